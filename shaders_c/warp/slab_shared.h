/* Rays through the box of a depth image. For shader files only.
 *
 * A ray of the view is two points of it, in the box's homogeneous coordinates and in the world;
 * between them it is told by a share of the way, 0 to 1. Both are linear on the screen, whatever
 * the camera. Slot 0 is the method's own; slot 1 has the image's colours, slot 2, of lit programs,
 * its normals, a component n as (n + 1) / 2.
 */
#ifndef SHADERS_WARP_SLAB_SHARED_H
#define SHADERS_WARP_SLAB_SHARED_H

#include "shaders_c/warp/light_shared.h"
#include "shaders_c/warp/slab.h"

typedef struct SlabVertex {
    float2 corner;
    float4 start, way;
} SlabVertex;

typedef struct SlabVarying {
    float4 start, way;
} SlabVarying;

typedef struct SlabLitVertex {
    SlabVertex ray;
    float3 from, along;
} SlabLitVertex;

typedef struct SlabLitVarying {
    SlabVarying ray;
    float3 from, along; /* in the world */
} SlabLitVarying;

/* The part of a ray that is in the box: straight there, `first + t way` for t from 0 to 1. */
typedef struct SlabPath {
    float3 first, way;
    flt enters, leaves; /* as shares of the ray's way; in the box where enters < leaves */
    flt w[2];           /* homogeneous, at both ends */
} SlabPath;

/* Moves both ends to where a + r b is not below 0. */
GP_INLINE void slab_cut(flt a, flt b, SlabPath *path)
{
    flt risen = b + 0.0f; /* no -0 */
    flt at = neg(a) * rcp(risen);
    path->enters = max(path->enters, sel(risen < 0.0f, bcast(0), at));
    path->leaves = min(path->leaves, sel(risen < 0.0f, at, bcast(1)));
}

GP_INLINE SlabPath slab_path(float4 start, float4 way)
{
    SlabPath path = { .enters = bcast(0), .leaves = bcast(1) };
    slab_cut(start.x, way.x, &path);
    slab_cut(start.y, way.y, &path);
    slab_cut(start.z, way.z, &path);
    slab_cut(start.w - start.x, way.w - way.x, &path);
    slab_cut(start.w - start.y, way.w - way.y, &path);
    slab_cut(start.w - start.z, way.w - way.z, &path);
    float4 first = mad(way, path.enters, start), last = mad(way, path.leaves, start);
    flt share = rcp(first.w), other = rcp(last.w);
    path.first = mul(xyz(first), share);
    path.way = sub(mul(xyz(last), other), path.first);
    path.w[0] = first.w;
    path.w[1] = last.w;
    return path;
}

/* The share of the ray's way at t, between 0 and 1, of its way in the box. */
GP_INLINE flt slab_share(const SlabPath *path, flt t)
{
    flt near = t * path->w[0];
    flt part = near * rcp(near + (1.0f - t) * path->w[1]);
    return mad(path->leaves - path->enters, part, path->enters);
}

GP_INLINE flt slab_depth(const SlabUniforms *c, flt share)
{
    return mad(share, c->depth[1], c->depth[0]) / mad(share, c->depth[3], c->depth[2]);
}

/* A place of the box in the picture. */
GP_INLINE float4 slab_place(const SlabUniforms *c, float3 at)
{
    return vec4(mad(at.x, c->side[0], c->first[0]), mad(at.y, c->side[1], c->first[1]), 0, 0);
}

GP_INLINE float4 slab_color(GpInvocation *gp, float4 place)
{
    return rgba(xyz(texldl(1, place)), 1);
}

GP_INLINE float4 slab_lit(GpInvocation *gp, const SlabUniforms *c, float4 place, float3 world)
{
    float3 normal = mad(xyz(texldl(2, place)), 2, sp3(bcast(-1)));
    return rgba(warp_lit(&c->light, xyz(texldl(1, place)), normal, world), 1);
}

/* clang-format off */
/* `struct` follows, so that a semicolon stands behind the macro. */
#define SLAB_VERTEX_SHADERS(name, Uniforms)                                                        \
    vertex_shader(name##_vs, Uniforms, SlabVertex, SlabVarying)                                    \
    {                                                                                              \
        *position = vec4(in->corner.x, in->corner.y, 0.5f, 1);                                     \
        out->start = in->start;                                                                    \
        out->way = in->way;                                                                        \
    }                                                                                              \
    vertex_shader(name##_lit_vs, Uniforms, SlabLitVertex, SlabLitVarying)                          \
    {                                                                                              \
        *position = vec4(in->ray.corner.x, in->ray.corner.y, 0.5f, 1);                             \
        out->ray.start = in->ray.start;                                                            \
        out->ray.way = in->ray.way;                                                                \
        out->from = in->from;                                                                      \
        out->along = in->along;                                                                    \
    }                                                                                              \
    struct name##_follows

#define SLAB_INPUTS   { GP_POSITION, 2 }, { GP_TEXCOORD0, 4 }, { GP_TEXCOORD1, 4 }
#define SLAB_VARYINGS { "start", 4, GP_LINEAR_SCREEN }, { "way", 4, GP_LINEAR_SCREEN }

/* A method's two pixel shaders: search(gp, uniforms, path) finds where a path in the box meets the
 * surface, as its t; below 0: nowhere. */
#define SLAB_PIXEL_SHADERS(name, Uniforms, search)                                                 \
    GP_INLINE float4 name##_meet(GpInvocation *gp, const Uniforms *c, const SlabVarying *in,       \
                                 flt *share)                                                       \
    {                                                                                              \
        const SlabPath path = slab_path(in->start, in->way);                                       \
        flt t = search(gp, c, &path);                                                              \
        discard(t < 0.0f);                                                                         \
        flt inside = sat(t);                                                                       \
        *share = slab_share(&path, inside);                                                        \
        watch("t", t);                                                                             \
        watch("place", mad(path.way, inside, path.first));                                         \
        odepth(slab_depth(&c->slab, *share));                                                      \
        return slab_place(&c->slab, mad(path.way, inside, path.first));                            \
    }                                                                                              \
    pixel_shader(name##_ps, Uniforms, SlabVarying)                                                 \
    {                                                                                              \
        flt share;                                                                                 \
        return slab_color(gp, name##_meet(gp, c, in, &share));                                     \
    }                                                                                              \
    pixel_shader(name##_lit_ps, Uniforms, SlabLitVarying)                                          \
    {                                                                                              \
        flt share;                                                                                 \
        float4 place = name##_meet(gp, c, &in->ray, &share);                                       \
        return slab_lit(gp, &c->slab, place, mad(in->along, share, in->from));                     \
    }                                                                                              \
    struct name##_shaded

/* A method's two programs: colours as they are, and lit. */
#define SLAB_PROGRAMS(name, vertex, pixel, slots)                                                  \
    program(name##_program, name##_vs, name##_ps, .vertex_profile = vertex,                        \
            .pixel_profile = pixel, .inputs = { SLAB_INPUTS }, .varyings = { SLAB_VARYINGS },      \
            .samplers = slots, .may_discard = true, .writes_depth = true)                          \
    program(name##_lit_program, name##_lit_vs, name##_lit_ps, .vertex_profile = vertex,            \
            .pixel_profile = pixel,                                                                \
            .inputs = { SLAB_INPUTS, { GP_TEXCOORD2, 3 }, { GP_TEXCOORD3, 3 } },                   \
            .varyings = { SLAB_VARYINGS, { "from", 3, GP_LINEAR_SCREEN },                          \
                          { "along", 3, GP_LINEAR_SCREEN } },                                      \
            .samplers = slots | 1 << 2, .may_discard = true, .writes_depth = true)
/* clang-format on */

#endif
