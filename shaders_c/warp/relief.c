#include "shaders_c/warp/relief.h"
#include "shaders_c/warp/slab_shared.h"

SLAB_VERTEX_SHADERS(relief, ReliefUniforms);

/* The path in texels of slot 0, and z. */
typedef struct Walk {
    float3 first, way;
} Walk;

GP_INLINE Walk walk_along(const ReliefUniforms *c, const SlabPath *path)
{
    return (Walk){ vec3(mad(path->first.x, c->cells[0], c->first[0]),
                        mad(path->first.y, c->cells[1], c->first[1]), path->first.z),
                   vec3(path->way.x * c->cells[0], path->way.y * c->cells[1], path->way.z) };
}

/* How far the path is behind the surface at t: linear between four pixels.
 * out  deep: and behind the nearest of the four */
GP_INLINE flt behind(GpInvocation *gp, const ReliefUniforms *c, const Walk *walk, flt t, flt *deep)
{
    float3 at = mad(walk->way, t, walk->first);
    flt right = frc(at.x), down = frc(at.y);
    float4 z = texldl(
        0, vec4((at.x - right + 0.5f) * c->texel[0], (at.y - down + 0.5f) * c->texel[1], 0, 0));
    flt upper = mad(z.y - z.x, right, z.x), lower = mad(z.w - z.z, right, z.z);
    *deep = at.z - min(min(z.x, z.y), min(z.z, z.w));
    return at.z - mad(lower - upper, down, upper);
}

/* Where the path meets the surface; below 0: nowhere. A step onto the other side that ends too far
 * behind the surface goes past an edge of it. */
GP_INLINE flt search(GpInvocation *gp, const ReliefUniforms *c, const SlabPath *path)
{
    const Walk walk = walk_along(c, path);
    const flt step = bcast(1.0f / c->steps);
    const flt thick = max(abs_(walk.way.z) * (step * 2.0f), c->thickness);
    flt deep, low = bcast(0), before = behind(gp, c, &walk, low, &deep); /* the last place */
    flt high = bcast(0), after = before, deeper = deep;                  /* the one behind it */
    flt k = sel(path->enters < path->leaves, bcast(1), bcast(c->steps + 1.0f));
    flt found = bcast(0);

    loop_while(255, (msk)(k <= c->steps) & (msk)(found < 0.5f))
    {
        flt t = k * step;
        flt here, off = behind(gp, c, &walk, t, &here);
        msk walks = (msk)(k <= c->steps) & (msk)(found < 0.5f);
        low = sel(walks, high, low);
        before = sel(walks, after, before);
        high = sel(walks, t, high);
        after = sel(walks, off, after);
        deep = sel(walks, deeper, deep);
        deeper = sel(walks, here, deeper);
        msk meets = (msk)(before * after <= 0.0f) & (msk)(sel(after > 0.0f, deeper, deep) <= thick);
        found = sel(meets, bcast(1), found);
        k = k + 1.0f;
    }
    flt turn = bcast(0);
    loop_while(255, (msk)(turn < c->halvings) & (msk)(found > 0.5f))
    {
        flt t = (low + high) * 0.5f;
        flt off = behind(gp, c, &walk, t, &deep);
        msk beyond = before * off <= 0.0f;
        high = sel(beyond, t, high);
        after = sel(beyond, off, after);
        low = sel(beyond, low, t);
        before = sel(beyond, before, off);
        turn = turn + 1.0f;
    }
    flt t = mad(high - low, before * rcp(before - after), low);
    return sel(found > 0.5f, t, bcast(-1));
}

/* out world: share of the ray's way */
GP_INLINE float4 meet(GpInvocation *gp, const ReliefUniforms *c, const SlabVarying *in, flt *share)
{
    const SlabPath path = slab_path(in->start, in->way);
    flt t = search(gp, c, &path);
    discard(t < 0.0f);
    flt inside = sat(t);
    *share = slab_share(&path, inside);
    odepth(slab_depth(&c->slab, *share));
    return slab_place(&c->slab, mad(path.way, inside, path.first));
}

pixel_shader(relief_ps, ReliefUniforms, SlabVarying)
{
    flt share;
    return slab_color(gp, meet(gp, c, in, &share));
}

pixel_shader(relief_lit_ps, ReliefUniforms, SlabLitVarying)
{
    flt share;
    float4 place = meet(gp, c, &in->ray, &share);
    return slab_lit(gp, &c->slab, place, mad(in->along, share, in->from));
}

SLAB_PROGRAMS(relief, GP_VS_3_0, GP_PS_3_0)
