/* Surfaces as depth images have them. The eye is taken away before anything is rounded, so that
 * models far from the origin lose nothing; depth is carried along as a distance along the view,
 * which the interpolation keeps within 19 roundings of itself (CONVENTIONS.md, "Varyings").
 * source of the second layer: Everitt, "Interactive order-independent transparency", NVIDIA 2001 */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/warp/capture.h"

typedef struct Vertex {
    float3 position, normal;
    float4 color;
} Vertex;

typedef struct Varying {
    float3 normal, color;
    flt depth;
} Varying;

typedef struct WavesVarying {
    float3 normal, world;
    flt depth;
} WavesVarying;

typedef struct Targets {
    float4 color, normal;
} Targets;

/* Clip position, and the depth that is behind it. */
GP_INLINE float4 place(const CaptureUniforms *c, float3 world, flt *depth)
{
    float3 off = sub(sub(world, u3(c->eye[0])), u3(c->eye[1]));
    float3 seen = m3x3(off, c->axes);
    *depth = seen.z;
    return m4x4(seen, c->eye_to_clip);
}

vertex_shader(capture_vs, CaptureUniforms, Vertex, Varying)
{
    *position = place(c, in->position, &out->depth);
    out->normal = in->normal;
    out->color = xyz(in->color);
}

vertex_shader(capture_waves_vs, CaptureUniforms, MeshVertex, WavesVarying)
{
    *position = place(c, in->position, &out->depth);
    out->normal = in->normal;
    out->world = in->position;
}

GP_INLINE float3 waves(const CaptureUniforms *c, float3 world)
{
    return vec3(mad(sin_(world.x * c->waves), 0.5f, 0.5f),
                mad(sin_(world.y * c->waves), 0.5f, 0.5f),
                mad(sin_(world.z * c->waves), 0.5f, 0.5f));
}

/* Both passes interpolate one triangle to the same bits, so the front itself is never behind. What
 * is not farther than this is a copy of it, or another side of something without thickness. */
#define BEYOND (1 + 0x1p-18f)

pixel_shader_targets(capture_ps, CaptureUniforms, Varying, Targets)
{
    out->color = rgba(in->color, in->depth);
    out->normal = rgba(nrm(in->normal), 0);
}

pixel_shader_targets(capture_behind_ps, CaptureUniforms, Varying, Targets)
{
    discard(in->depth <= gp_load_local(0).w * BEYOND);
    out->color = rgba(in->color, in->depth);
    out->normal = rgba(nrm(in->normal), 0);
}

pixel_shader_targets(capture_waves_ps, CaptureUniforms, WavesVarying, Targets)
{
    out->color = rgba(waves(c, in->world), in->depth);
    out->normal = rgba(nrm(in->normal), 0);
}

pixel_shader_targets(capture_waves_behind_ps, CaptureUniforms, WavesVarying, Targets)
{
    discard(in->depth <= gp_load_local(0).w * BEYOND);
    out->color = rgba(waves(c, in->world), in->depth);
    out->normal = rgba(nrm(in->normal), 0);
}

/* clang-format off */
#define COLORED                                                                                    \
    MODEL_2_0, .inputs = { MESH_INPUTS, { GP_COLOR, 4 } },                                         \
    .varyings = { { "normal", 3, GP_PERSPECTIVE }, { "color", 3, GP_PERSPECTIVE },                 \
                  { "depth", 1, GP_PERSPECTIVE } }
#define WAVES                                                                                      \
    MODEL_2_0, .inputs = { MESH_INPUTS },                                                          \
    .varyings = { SURFACE_VARYINGS, { "depth", 1, GP_PERSPECTIVE } }
#define BEHIND .local_reads = 1 << 0, .may_discard = true
/* clang-format on */

program(capture_program, capture_vs, capture_ps, COLORED)
program(capture_behind_program, capture_vs, capture_behind_ps, COLORED, BEHIND)
program(capture_waves_program, capture_waves_vs, capture_waves_ps, WAVES)
program(capture_waves_behind_program, capture_waves_vs, capture_waves_behind_ps, WAVES, BEHIND)
