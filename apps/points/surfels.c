#include "apps/points/surfels.h"

float surfels_mean_radius(const Surfels *surfels)
{
    double sum = 0;
    for (uint32_t i = 0; i < surfels->count; i++)
        sum += (double)surfels->surfels[i].radius;
    return (float)(sum / surfels->count);
}

GpResult surfels_alloc(Surfels *surfels, uint32_t count)
{
    *surfels = (Surfels){ .surfels = gp_alloc(count, sizeof(Surfel)), .count = count };
    return surfels->surfels ? GP_OK : GP_ERROR_MEMORY;
}

void surfels_free(Surfels *surfels)
{
    gp_free(surfels->surfels);
    gp_free(surfels->clips);
    *surfels = (Surfels){ .surfels = NULL };
}
