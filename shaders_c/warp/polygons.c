/* Triangles with colours of their vertices, with alpha 1: what depth images are taken of. */
#define GP_SHADER_AT_ONCE 4 /* square roots, one after the other, and a power */
#include "shaders_c/warp/polygons.h"

#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/warp/light_shared.h"

vertex_shader(polygons_vs, PolygonsUniforms, ColoredVertex, ColorVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->color = rgba(xyz(in->color), 1);
}

pixel_shader(polygons_ps, PolygonsUniforms, ColorVarying)
{
    return in->color;
}

program(polygons_program, polygons_vs, polygons_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_COLOR, 4 } },
        .varyings = { { "color", 4, GP_PERSPECTIVE } })

typedef struct LitVertex {
    float3 position, normal;
    float4 color;
} LitVertex;

typedef struct LitVarying {
    float3 normal, world, color;
} LitVarying;

vertex_shader(polygons_lit_vs, PolygonsUniforms, LitVertex, LitVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->normal = in->normal;
    out->world = in->position;
    out->color = xyz(in->color);
}

pixel_shader(polygons_lit_ps, PolygonsUniforms, LitVarying)
{
    return rgba(warp_lit(&c->light, in->color, in->normal, in->world), 1);
}

program(polygons_lit_program, polygons_lit_vs, polygons_lit_ps, MODEL_2_0,
        .inputs = { MESH_INPUTS, { GP_COLOR, 4 } },
        .varyings = { { "normal", 3, GP_PERSPECTIVE },
                      { "world", 3, GP_PERSPECTIVE },
                      { "color", 3, GP_PERSPECTIVE } })
