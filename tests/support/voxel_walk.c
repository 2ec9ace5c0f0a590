#include "tests/support/voxel_walk.h"

#include <math.h>
#include <stdlib.h>

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Where the ray meets planes between voxels, and its start. */
static uint32_t find_meetings(uint32_t size, const double origin[3], const double direction[3],
                              double *at)
{
    uint32_t count = 0;
    at[count++] = 0;
    for (int k = 0; k < 3; k++)
        for (uint32_t plane = 0; plane <= size && direction[k] != 0; plane++) {
            const double t = (plane - origin[k]) / direction[k];
            if (t > 0)
                at[count++] = t;
        }
    qsort(at, count, sizeof *at, compare);
    return count;
}

uint32_t voxel_walk(uint32_t size, const double origin[3], const double direction[3],
                    VoxelStep *steps)
{
    double *at = gp_alloc(3 * (size_t)size + 4, sizeof *at);
    const uint32_t meetings = find_meetings(size, origin, direction, at);
    uint32_t count = 0;
    for (uint32_t i = 0; i + 1 < meetings; i++) {
        const double centre = (at[i] + at[i + 1]) / 2;
        VoxelStep step = { .enter = at[i], .leave = at[i + 1] };
        bool inside = at[i + 1] > at[i];
        for (int k = 0; k < 3 && inside; k++) {
            const double place = floor(origin[k] + centre * direction[k]);
            inside = place >= 0 && place < size;
            step.voxel[k] = inside ? (uint32_t)place : 0;
        }
        if (inside)
            steps[count++] = step;
    }
    gp_free(at);
    return count;
}
