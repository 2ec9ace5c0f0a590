#include "apps/base/mesh_places.h"

#include <stdlib.h>
#include <string.h>

typedef struct Place {
    float position[3];
    uint32_t vertex;
} Place;

static int compare_places(const void *a, const void *b)
{
    const Place *p = a, *q = b;
    for (int k = 0; k < 3; k++)
        if (p->position[k] != q->position[k])
            return p->position[k] < q->position[k] ? -1 : 1;
    return 0;
}

GpResult mesh_places(const float *positions, uint32_t vertex_count, uint32_t *place_of)
{
    Place *places = gp_alloc(vertex_count, sizeof *places);
    if (!places)
        return GP_ERROR_MEMORY;
    for (uint32_t i = 0; i < vertex_count; i++) {
        memcpy(places[i].position, positions + 3 * (size_t)i, sizeof places[i].position);
        places[i].vertex = i;
    }
    qsort(places, vertex_count, sizeof *places, compare_places);
    uint32_t number = 0;
    for (uint32_t i = 0; i < vertex_count; i++) {
        number += i > 0 && compare_places(&places[i - 1], &places[i]) != 0;
        place_of[places[i].vertex] = number;
    }
    gp_free(places);
    return GP_OK;
}
