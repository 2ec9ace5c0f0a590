/* Geometry: names of semantics, counts of primitives. */
#include "pipeline/resources/geometry.h"

const char *const gp_semantic_names[GP_SEMANTICS] = {
    "position",  "normal",    "color",   "texcoord0",  "texcoord1",
    "texcoord2", "texcoord3", "tangent", "point_size",
};

uint32_t gp_geometry_primitives(const GpGeometry *geometry)
{
    uint32_t count = geometry->indices ? geometry->index_count : geometry->vertex_count;
    return geometry->primitive == GP_TRIANGLES ? count / 3 : count;
}
