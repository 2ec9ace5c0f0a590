/* What points without filters share. For shader files only. */
#ifndef SHADERS_POINTS_DISC_SHARED_H
#define SHADERS_POINTS_DISC_SHARED_H

#include "shaders_c/points/disc.h"
#include "shaders_c/points/splat_shared.h"

typedef struct FlatVarying {
    float3 color;
} FlatVarying;

/* Squares and discs cover their surfels' discs, which leave no hole: their own diameter, and half a
 * pixel more, since a pixel's centre may be that far from the point's. */
GP_INLINE flt disc_side(const EyeSurfel *eye)
{
    return eye->radius * 2 + 1.0f;
}

GP_INLINE float3 lit_color(const LitPointUniforms *c, const SurfelVertex *in, const EyeSurfel *eye)
{
    flt lambert = dp3(in->normal, u3(c->light));
    lambert = max(sel(eye->facing < 0.0f, -lambert, lambert), 0);
    return mul(surfel_color(&c->splat, in), mad(lambert, 1 - c->ambient, c->ambient));
}

#endif
