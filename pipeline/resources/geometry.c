/* Geometry: names of semantics and primitives, counts of primitives. */
#include "pipeline/resources/geometry.h"

const char *const gp_semantic_names[GP_SEMANTICS] = {
    "position",  "normal",    "color",   "texcoord0",  "texcoord1",
    "texcoord2", "texcoord3", "tangent", "point_size",
};

const char *const gp_primitive_names[GP_PRIMITIVES] = {
    "triangles",
    "points",
    "triangle strip",
    "triangle fan",
};

uint32_t gp_geometry_primitives(const GpGeometry *geometry)
{
    const uint32_t elements = gp_geometry_elements(geometry);
    if (geometry->primitive == GP_TRIANGLES)
        return elements / 3;
    return geometry->primitive == GP_POINTS ? elements : elements < 3 ? 0 : elements - 2;
}
