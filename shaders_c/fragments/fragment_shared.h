/* Fragments of a mesh whose triangles have a colour each. For shader files only. */
#ifndef SHADERS_FRAGMENTS_FRAGMENT_SHARED_H
#define SHADERS_FRAGMENTS_FRAGMENT_SHARED_H

#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/fragments/fragment.h"

/* --- plain ------------------------------------------------------------------------------------ */

typedef struct FragmentVertex {
    float3 position;
    float4 color;
} FragmentVertex;

/* A pixel shader of 2005 is not told the depth that the rasterizer computes, so it comes as a
 * varying. The same triangle has the same bits in every pass. */
typedef struct FragmentVarying {
    flt depth;
    float4 color;
} FragmentVarying;

#define fragment_vertex_shader(name)                                                               \
    vertex_shader(name, FragmentUniforms, FragmentVertex, FragmentVarying)                         \
    {                                                                                              \
        *position = m4x4(in->position, c->mvp);                                                    \
        out->depth = position->z * rcp(position->w);                                               \
        out->color = in->color;                                                                    \
    }                                                                                              \
    struct name##_follows

/* Colour multiplied by what the fragment hides, and what it lets through. */
GP_INLINE float4 fragment_source(const FragmentUniforms *c, const FragmentVarying *in)
{
    (void)c;
    return rgba(mul(xyz(in->color), in->color.w), 1.0f - in->color.w);
}

/* --- glass ------------------------------------------------------------------------------------ */

typedef struct GlassVertex {
    float3 position;
    float4 color;
    float3 normal;
} GlassVertex;

typedef struct GlassVarying {
    flt depth;
    float4 color;
    float3 normal;
    float3 ray; /* along the line of sight, from the eye, or from the plane in which it lies */
} GlassVarying;

#define glass_vertex_shader(name)                                                                  \
    vertex_shader(name, FragmentUniforms, GlassVertex, GlassVarying)                               \
    {                                                                                              \
        float3 from_eye = sub(in->position, u3(c->eye));                                           \
        float3 along = mul(u3(c->forward), dp3(from_eye, u3(c->forward)));                         \
        *position = m4x4(in->position, c->mvp);                                                    \
        out->depth = position->z * rcp(position->w);                                               \
        out->color = in->color;                                                                    \
        out->normal = in->normal;                                                                  \
        out->ray = lrp(bcast(c->parallel), along, from_eye);                                       \
    }                                                                                              \
    struct name##_follows

GP_INLINE float4 glass_source(const FragmentUniforms *c, const GlassVarying *in)
{
    flt squared = dp3(in->ray, in->ray), per_length = rsq(squared), length = squared * per_length;
    flt toward = dp3(in->normal, in->ray);
    flt beside = 1.0f - min(abs_(toward) * per_length, 1);
    flt fifth = beside * beside;
    fifth = fifth * fifth * beside;
    flt through = (1.0f - in->color.w) * ((1.0f - fifth) * c->through);
    flt way = length - length * c->begin * rcp(dp3(in->ray, u3(c->forward)));
    flt taken = exp_(way * neg(bcast(c->sigma)));
    msk faces = toward < 0.0f;
    float3 light = mul(xyz(in->color), 1.0f - through);
    return rgba(sel(faces, light, mul(light, taken)), through * sel(faces, rcp(taken), taken));
}

/* --- both ------------------------------------------------------------------------------------- */

/* clang-format off */
#define FRAGMENT_DECLARATIONS                                                                      \
    .inputs = { { GP_POSITION, 3 }, { GP_COLOR, 4 } },                                             \
    .varyings = { { "depth", 1, GP_LINEAR_SCREEN }, { "color", 4, GP_FLAT } }
#define GLASS_DECLARATIONS                                                                         \
    .inputs = { { GP_POSITION, 3 }, { GP_COLOR, 4 }, { GP_NORMAL, 3 } },                           \
    .varyings = { { "depth", 1, GP_LINEAR_SCREEN }, { "color", 4, GP_FLAT },                       \
                  { "normal", 3, GP_FLAT }, { "ray", 3, GP_PERSPECTIVE } }
/* clang-format on */

/* Two programs of one pixel shader, NAME_program and NAME_glass_program: what stands behind `name`
 * is its body, a function of gp, c, the fragment's depth and its source. The rest are declarations.
 * The vertex shaders are the file's, fragment_vs and glass_vs: of passes that share them vertices
 * are shaded once. */
#define fragment_programs(name, Out, ...)                                                          \
    GP_INLINE Out name##_pixel(GpInvocation *gp, const FragmentUniforms *c, flt depth,             \
                               float4 source);                                                     \
    pixel_shader_targets(name##_ps, FragmentUniforms, FragmentVarying, Out)                        \
    {                                                                                              \
        *out = name##_pixel(gp, c, in->depth, fragment_source(c, in));                             \
    }                                                                                              \
    program(name##_program, fragment_vs, name##_ps, FRAGMENT_DECLARATIONS, __VA_ARGS__)            \
    pixel_shader_targets(name##_glass_ps, FragmentUniforms, GlassVarying, Out)                     \
    {                                                                                              \
        *out = name##_pixel(gp, c, in->depth, glass_source(c, in));                                \
    }                                                                                              \
    program(name##_glass_program, glass_vs, name##_glass_ps, GLASS_DECLARATIONS, __VA_ARGS__)      \
    GP_INLINE Out name##_pixel(__attribute__((unused)) GpInvocation *gp,                           \
                               __attribute__((unused)) const FragmentUniforms *c,                  \
                               __attribute__((unused)) flt depth,                                  \
                               __attribute__((unused)) float4 source)

#endif
