#include "shaders_c/warp/relief_texture.h"
#include "shaders_c/warp/slab_quad_shared.h"

SLAB_QUAD_VERTEX_SHADER(relief_texture, ReliefTextureUniforms);

/* A place in the box: between texels where these are of one surface, else the nearest one's. */
GP_INLINE float4 place_at(GpInvocation *gp, const ReliefTextureUniforms *c, float2 at)
{
    float4 texture =
        vec4(mad(at.x, c->per_side[0], c->first[0]), mad(at.y, c->per_side[1], c->first[1]), 0, 0);
    float4 nearest = texldl(0, texture), mixed = texldl(3, texture);
    msk same = (msk)(mixed.w >= 1.0f) & (msk)(abs_(mixed.x - nearest.x) < c->apart[0]) &
               (msk)(abs_(mixed.y - nearest.y) < c->apart[1]);
    return sel(same, mixed, nearest);
}

GP_INLINE flt row_at(float4 at, const float row[4])
{
    return at.x * row[0] + at.y * row[1] + at.z * row[2] + row[3];
}

/* out at: in the box */
GP_INLINE float4 meet(GpInvocation *gp, const ReliefTextureUniforms *c, float2 quad, float4 *at)
{
    *at = place_at(gp, c, quad);
    discard(at->w < 0.5f);
    odepth(row_at(*at, c->clip[0]) * rcp(row_at(*at, c->clip[1])));
    return slab_place(&c->slab, xyz(*at));
}

pixel_shader(relief_texture_ps, ReliefTextureUniforms, SlabQuadVarying)
{
    float4 at;
    return slab_color(gp, meet(gp, c, in->at, &at));
}

pixel_shader(relief_texture_lit_ps, ReliefTextureUniforms, SlabQuadVarying)
{
    float4 at, place = meet(gp, c, in->at, &at);
    float3 world = vec3(row_at(at, c->world[0]), row_at(at, c->world[1]), row_at(at, c->world[2]));
    return slab_lit(gp, &c->slab, place, mul(world, rcp(row_at(at, c->world[3]))));
}

SLAB_QUAD_PROGRAM(relief_texture_program, relief_texture_vs, relief_texture_ps,
                  1 << 0 | 1 << 1 | 1 << 3, true)
SLAB_QUAD_PROGRAM(relief_texture_lit_program, relief_texture_vs, relief_texture_lit_ps,
                  1 << 0 | 1 << 1 | 1 << 2 | 1 << 3, true)
