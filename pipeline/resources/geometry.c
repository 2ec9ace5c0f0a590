#include "pipeline/resources/geometry.h"

uint32_t gp_geometry_primitives(const GpGeometry *geometry)
{
    uint32_t count = geometry->indices ? geometry->index_count : geometry->vertex_count;
    return geometry->primitive == GP_TRIANGLES ? count / 3 : count;
}
