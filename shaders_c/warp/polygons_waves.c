/* Triangles with colours of their places: waves along the axes of the world. */
#define GP_SHADER_AT_ONCE 2 /* three sines: two fit into the registers */
#include "shaders_c/warp/polygons_waves.h"

#include "shaders_c/common/vertices_shared.h"

typedef struct PlaceVarying {
    float3 world;
} PlaceVarying;

vertex_shader(polygons_waves_vs, PolygonsUniforms, PointVertex, PlaceVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->world = in->position;
}

pixel_shader(polygons_waves_ps, PolygonsUniforms, PlaceVarying)
{
    float3 at = mul(in->world, c->waves);
    float3 waves = vec3(sin_(at.x), sin_(at.y), sin_(at.z));
    return rgba(mad(waves, 0.5f, bcast(0.5f)), 1);
}

program(polygons_waves_program, polygons_waves_vs, polygons_waves_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 } }, .varyings = { { "world", 3, GP_PERSPECTIVE } })
