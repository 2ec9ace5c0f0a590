/* Depth peeling: Everitt, "Interactive order-independent transparency", NVIDIA 2001. Layers are put
 * together front to back with colours multiplied by alpha: Porter and Duff, "Compositing digital
 * images", SIGGRAPH 1984. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/bench/peeling.h"

/* --- peeling ---------------------------------------------------------------------------------- */

typedef struct Varying {
    float3 normal;
    flt depth;
} Varying;

vertex_shader(peel_vs, PeelUniforms, MeshVertex, Varying)
{
    float4 clip = m4x4(in->position, c->mvp);
    *position = clip;
    out->normal = m3x3(in->normal, c->model);
    out->depth = clip.z * rcp(clip.w);
}

GP_INLINE float4 lambert(const PeelUniforms *c, float3 normal)
{
    flt cosine = abs_(dp3(nrm(normal), u3(c->light)));
    return rgba(mul(u3(c->color), cosine * 0.75f + 0.25f), c->color[3]);
}

pixel_shader(peel_first_ps, PeelUniforms, Varying)
{
    return lambert(c, in->normal);
}

/* A pixel shader of 2005 is not told the depth that the rasterizer computes, so it comes as a
 * varying, and the last bits differ: by less than 1.5e-7, as both are sums of at most three terms
 * rounded at 1. One layer is closer than that to another only where they meet. */
#define SAME_DEPTH 0x1p-22f

pixel_shader(peel_next_ps, PeelUniforms, Varying)
{
    discard(in->depth <= gp_load_local(0).x + SAME_DEPTH);
    return lambert(c, in->normal);
}

/* clang-format off */
#define PEEL_DECLARATIONS                                                                          \
    MODEL_2_0, .inputs = { MESH_INPUTS },                                                          \
    .varyings = { { "normal", 3, GP_PERSPECTIVE }, { "depth", 1, GP_LINEAR_SCREEN } }

program(peel_first_program, peel_vs, peel_first_ps, PEEL_DECLARATIONS)
program(peel_next_program, peel_vs, peel_next_ps, PEEL_DECLARATIONS, .local_reads = 1 << 0,
        .may_discard = true)
/* clang-format on */

/* --- putting together ------------------------------------------------------------------------- */

clip_vertex_shader(layer_vs, LayerUniforms);

pixel_shader(layer_premultiply_ps, LayerUniforms, NoVarying)
{
    float4 layer = gp_load_local(0);
    return rgba(mul(xyz(layer), layer.w), layer.w);
}

pixel_shader(layer_background_ps, LayerUniforms, NoVarying)
{
    float4 layers = gp_load_local(0);
    return rgba(add(xyz(layers), mul(u3(c->background), 1.0f - layers.w)), 1);
}

/* clang-format off */
#define LAYER_DECLARATIONS MODEL_2_0, .inputs = { { GP_POSITION, 3 } }, .local_reads = 1 << 0
/* clang-format on */

program(layer_premultiply_program, layer_vs, layer_premultiply_ps, LAYER_DECLARATIONS)
program(layer_background_program, layer_vs, layer_background_ps, LAYER_DECLARATIONS)
