/* Where rays meet the surface of a depth image, once they are near. For shader files only. */
#ifndef SHADERS_WARP_CELLS_SHARED_H
#define SHADERS_WARP_CELLS_SHARED_H

#include "shaders_c/warp/cells.h"
#include "shaders_c/warp/slab_shared.h"

/* A path in texels of slot 0, and z. */
typedef struct CellPath {
    float3 first, way;
} CellPath;

GP_INLINE CellPath cell_path(const CellUniforms *c, const SlabPath *path)
{
    return (CellPath){ vec3(mad(path->first.x, c->side[0], c->first[0]),
                            mad(path->first.y, c->side[1], c->first[1]), path->first.z),
                       vec3(path->way.x * c->side[0], path->way.y * c->side[1], path->way.z) };
}

/* How far a path is behind the surface at t: linear between four pixels.
 * out  deep: and behind the nearest of the four */
GP_INLINE flt cell_behind(GpInvocation *gp, const CellUniforms *c, const CellPath *path, flt t,
                          flt *deep)
{
    float3 at = mad(path->way, t, path->first);
    flt right = frc(at.x), down = frc(at.y);
    float4 z = texldl(
        0, vec4((at.x - right + 0.5f) * c->texel[0], (at.y - down + 0.5f) * c->texel[1], 0, 0));
    flt upper = mad(z.y - z.x, right, z.x), lower = mad(z.w - z.z, right, z.z);
    flt behind = at.z - mad(lower - upper, down, upper);
    *deep = at.z - min(min(z.x, z.y), min(z.z, z.w));
    watch("at", at);
    watch("behind", behind);
    watch("deep", *deep);
    return behind;
}

/* Two places of a path, and how far behind the surface each is. */
typedef struct CellBracket {
    flt low, high, before, after;
} CellBracket;

/* Halves it so many times where a mask is true, keeping the surface between, then takes the place
 * on a line. */
GP_INLINE flt cell_meet(GpInvocation *gp, const CellUniforms *c, const CellPath *path,
                        CellBracket b, float halvings, msk wanted)
{
    flt turn = bcast(0);
    loop_while(255, (msk)(turn < halvings) & wanted)
    {
        flt deep, t = (b.low + b.high) * 0.5f;
        flt off = cell_behind(gp, c, path, t, &deep);
        msk beyond = b.before * off <= 0.0f;
        b.high = sel(beyond, t, b.high);
        b.after = sel(beyond, off, b.after);
        b.low = sel(beyond, b.low, t);
        b.before = sel(beyond, b.before, off);
        turn = turn + 1.0f;
    }
    return mad(b.high - b.low, b.before * rcp(b.before - b.after), b.low);
}

#endif
