/* Vertices at the same place. */
#ifndef APPS_BASE_MESH_PLACES_H
#define APPS_BASE_MESH_PLACES_H

#include "pipeline/base/base.h"

/* Numbers the places of vertices from 0 on, by x, then y, then z; vertices at the same place have
 * one number.
 * in     positions: finite
 * out    place_of: [vertex_count]
 * errors GP_ERROR_MEMORY */
GpResult mesh_places(const float *positions, uint32_t vertex_count, uint32_t *place_of);

#endif
