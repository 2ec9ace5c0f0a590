/* The surface that sums of weighted attributes say is at a pixel. For shader files only. */
#ifndef SHADERS_POINTS_SURFACE_SHARED_H
#define SHADERS_POINTS_SURFACE_SHARED_H

#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/points/normalize.h"

/* Less weight than this is none: sums of no splat. */
#define NOTHING 1e-6f

/* Slots that all programs with a surface read in place. */
#define READ_HERE (1 << HIDES_SLOT | 1 << SUMS_HERE_SLOT)

GP_INLINE flt covered_part(const NormalizeUniforms *c, flt weight)
{
    flt alpha = sat(mad(weight, c->coverage[0], c->coverage[1]));
    return sel(weight > NOTHING, alpha, 0);
}

/* What was added up at a pixel: colour and weight, and of programs that shade normal and
 * distance. */
typedef struct Sums {
    float4 color, surface;
} Sums;

/* So many pixels to the right and down. */
GP_INLINE float4 texel_at(GpInvocation *gp, int slot, const NormalizeUniforms *c, float right,
                          float down)
{
    float2 place = vpos();
    return texldl(slot, vec4((place.x + (right + 0.5f)) * c->texel[0],
                             (place.y + (down + 0.5f)) * c->texel[1], 0, 0));
}

/* Two pixels on opposite sides of this one; alpha is the lesser coverage of the two. */
GP_INLINE void look_across(GpInvocation *gp, const NormalizeUniforms *c, float right, float down,
                           int surface, Sums *best, flt *most)
{
    float4 one = texel_at(gp, 0, c, right, down), other = texel_at(gp, 0, c, -right, -down);
    flt alpha = min(covered_part(c, one.w), covered_part(c, other.w));
    msk better = alpha > *most;
    *most = max(*most, alpha);
    best->color = sel(better, add(one, other), best->color);
    if (surface) {
        float4 of_one = texel_at(gp, surface, c, right, down);
        float4 of_other = texel_at(gp, surface, c, -right, -down);
        best->surface = sel(better, add(of_one, of_other), best->surface);
    }
}

/* Where a surface ends before another one, its own weight fades out, and what is behind it has been
 * hidden: sums of one surface alone, though two cover the pixel. Such pixels have covered ones on
 * both sides, within two pixels, and those where the whole model ends have not. What hides, and has
 * no sums at all, takes those of both sides.
 * in   surface: slot of the sums of normals and distances, 0: they are not asked for
 * returns alpha */
GP_INLINE flt close_gaps(GpInvocation *gp, const NormalizeUniforms *c, int surface, Sums *sums)
{
    const float across[8][2] = { { 1, 0 }, { 0, 1 }, { 1, 1 }, { 1, -1 },
                                 { 2, 0 }, { 0, 2 }, { 2, 2 }, { 2, -2 } };
    flt alpha = covered_part(c, sums->color.w);
    msk drawn = (msk)(sums->color.w > NOTHING) | (msk)(gp_load_local(HIDES_SLOT).x < 1.0f);
    if (any((msk)(alpha < 1.0f) & drawn)) {
        Sums best = *sums;
        flt most = bcast(0);
        for (int i = 0; i < 8; i++)
            look_across(gp, c, across[i][0], across[i][1], surface, &best, &most);
        msk empty = drawn & (msk)(sums->color.w <= NOTHING) & (msk)(most > 0.0f);
        sums->color = sel(empty, best.color, sums->color);
        sums->surface = sel(empty, best.surface, sums->surface);
        alpha = sel(drawn, max(alpha, most), alpha);
    }
    watch("sums", sums->color);
    watch("coverage", alpha);
    return alpha;
}

typedef struct SplattedSurface {
    float3 color;
    float3 normal; /* world, unit length */
    float3 ray;    /* world, from the eye, of length 1 forwards */
    flt distance;  /* forwards */
    flt alpha;     /* how much of the pixel it covers */
} SplattedSurface;

/* in   slot: of the sums of normals and distances */
GP_INLINE SplattedSurface surface_at(GpInvocation *gp, const NormalizeUniforms *c, int slot)
{
    Sums sums = { gp_load_local(SUMS_HERE_SLOT), gp_load_local(SURFACE_HERE_SLOT) };
    flt alpha = close_gaps(gp, c, slot, &sums);
    flt per_weight = rcp(max(sums.color.w, NOTHING));
    flt x = (vpos().x + (0.5f - c->centre[0])) * c->per_focal;
    flt y = (vpos().y + (0.5f - c->centre[1])) * c->per_focal;
    return (SplattedSurface){
        .color = mul(xyz(sums.color), per_weight),
        .normal = nrm(xyz(sums.surface)),
        .ray = mad(u3(c->axes[0]), x, mad(u3(c->axes[1]), y, u3(c->axes[2]))),
        .distance = sums.surface.w * per_weight,
        .alpha = alpha,
    };
}

GP_INLINE flt surface_depth(const NormalizeUniforms *c, flt distance)
{
    return c->depth[0] + c->depth[1] * rcp(max(distance, NOTHING));
}

#endif
