#include "shaders_c/warp/displacement.h"
#include "shaders_c/volume/atlas_shared.h"
#include "shaders_c/warp/cells_shared.h"

SLAB_VERTEX_SHADERS(displacement, DisplacementUniforms);

/* How far the surface is from the path at t. */
GP_INLINE flt distance_at(GpInvocation *gp, const DisplacementUniforms *c, const SlabPath *path,
                          flt t)
{
    float3 at = mul(mad(path->way, t, path->first), u3(c->last));
    return volume_value(gp, 3, &c->field, min(max(at, 0), u3(c->last))) * c->reach;
}

/* Where the path meets the surface; below 0: nowhere. */
GP_INLINE flt search(GpInvocation *gp, const DisplacementUniforms *c, const SlabPath *in_box)
{
    const CellPath path = cell_path(&c->cells, in_box);
    float3 way = mul(in_box->way, u3(c->metric));
    const flt per_length = rsq(max(dp3(way, way), 1e-30f));
    const flt near = per_length * c->near;
    const flt thick = max(abs_(path.way.z) * (near * 2.0f), c->cells.thickness);
    CellBracket b = { bcast(0), bcast(0), bcast(0), bcast(0) };
    flt t = sel(in_box->enters < in_box->leaves, bcast(0), bcast(2));
    flt found = bcast(0), k = bcast(0);

    loop_while(255, (msk)(t <= 1.0f) & (msk)(found < 0.5f) & (msk)(k < c->steps))
    {
        flt ahead = distance_at(gp, c, in_box, t);
        msk walks = (msk)(t <= 1.0f) & (msk)(found < 0.5f);
        msk looks = (msk)(ahead <= c->near) & walks;
        loop_while(1, looks)
        {
            flt low = max(t - near, 0), high = min(t + near, 1.0f), deep, deeper;
            flt before = cell_behind(gp, &c->cells, &path, low, &deep);
            flt after = cell_behind(gp, &c->cells, &path, high, &deeper);
            msk meets = (msk)(before * after <= 0.0f) & looks &
                        (msk)(sel(after > 0.0f, deeper, deep) <= thick);
            b.low = sel(meets, low, b.low);
            b.high = sel(meets, high, b.high);
            b.before = sel(meets, before, b.before);
            b.after = sel(meets, after, b.after);
            found = sel(meets, bcast(1), found);
        }
        t = sel(walks, t + max(ahead * per_length, near * 2.0f), t);
        k = k + 1.0f;
    }
    flt at = cell_meet(gp, &c->cells, &path, b, 6.0f, found > 0.5f);
    return sel(found > 0.5f, at, bcast(-1));
}

SLAB_PIXEL_SHADERS(displacement, DisplacementUniforms, search);
SLAB_PROGRAMS(displacement, GP_VS_3_0, GP_PS_3_0, 1 << 0 | 1 << 1 | 1 << 3)
