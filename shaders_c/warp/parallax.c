#include "shaders_c/warp/parallax.h"
#include "shaders_c/warp/cells_shared.h"
#include "shaders_c/warp/slab_quad_shared.h"

SLAB_QUAD_VERTEX_SHADER(parallax, ParallaxUniforms);

/* How far behind the rectangle the surface is there; where nothing is, the pixel goes. */
GP_INLINE flt sunken(GpInvocation *gp, const ParallaxUniforms *c, float2 at)
{
    const CellPath path = { vec3(mad(at.x, c->cells.side[0], c->cells.first[0]),
                                 mad(at.y, c->cells.side[1], c->cells.first[1]), 0),
                            sp3(bcast(0)) };
    flt deep, z = neg(cell_behind(gp, &c->cells, &path, bcast(0), &deep));
    discard(z > 1.0f);
    return min(z, 1.0f) - c->z;
}

/* Towards the eye, in the box. */
GP_INLINE float3 to_eye(const ParallaxUniforms *c, float2 at)
{
    return vec3(c->eye[0] - at.x * c->eye[3], c->eye[1] - at.y * c->eye[3],
                bcast(c->eye[2] - c->z * c->eye[3]));
}

GP_INLINE float3 stays(GpInvocation *gp, const ParallaxUniforms *c, float2 at)
{
    sunken(gp, c, at);
    return vec3(at.x, at.y, c->z);
}

GP_INLINE float3 moved(GpInvocation *gp, const ParallaxUniforms *c, float2 at)
{
    float3 way = to_eye(c, at);
    flt by = sunken(gp, c, at) * rcp(way.z);
    return vec3(mad(way.x, by, at.x), mad(way.y, by, at.y), c->z);
}

/* Never by more than the surface is sunken. */
GP_INLINE float3 moved_less(GpInvocation *gp, const ParallaxUniforms *c, float2 at)
{
    float3 way = to_eye(c, at), length = mul(way, u3(c->metric));
    flt by = sunken(gp, c, at) * rsq(max(dp3(length, length), 1e-30f)) * c->metric[2];
    by = sel(way.z < 0.0f, neg(by), by);
    return vec3(mad(way.x, by, at.x), mad(way.y, by, at.y), c->z);
}

/* clang-format off */
#define PARALLAX_PROGRAMS(name, place)                                                             \
    pixel_shader(name##_ps, ParallaxUniforms, SlabQuadVarying)                                     \
    {                                                                                              \
        return slab_color(gp, slab_place(&c->slab, place(gp, c, in->at)));                         \
    }                                                                                              \
    pixel_shader(name##_lit_ps, ParallaxUniforms, SlabQuadVarying)                                 \
    {                                                                                              \
        return slab_lit(gp, &c->slab, slab_place(&c->slab, place(gp, c, in->at)), in->world);      \
    }                                                                                              \
    SLAB_QUAD_PROGRAM(name##_program, parallax_vs, name##_ps, 1 << 0 | 1 << 1, false)              \
    SLAB_QUAD_PROGRAM(name##_lit_program, parallax_vs, name##_lit_ps,                              \
                      1 << 0 | 1 << 1 | 1 << 2, false)
/* clang-format on */

PARALLAX_PROGRAMS(bump, stays)
PARALLAX_PROGRAMS(parallax, moved)
PARALLAX_PROGRAMS(parallax_limited, moved_less)
