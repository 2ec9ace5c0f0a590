#include "shaders_c/warp/relief.h"
#include "shaders_c/warp/cells_shared.h"

SLAB_VERTEX_SHADERS(relief, ReliefUniforms);

/* Where the path meets the surface; below 0: nowhere. A step onto the other side that ends too far
 * behind the surface goes past an edge of it. */
GP_INLINE flt search(GpInvocation *gp, const ReliefUniforms *c, const SlabPath *in_box)
{
    const CellPath path = cell_path(&c->cells, in_box);
    const flt step = bcast(1.0f / c->steps);
    const flt thick = max(abs_(path.way.z) * (step * 2.0f), c->cells.thickness);
    flt deep, first = cell_behind(gp, &c->cells, &path, bcast(0), &deep);
    flt deeper = deep; /* at the last place, as deep is at the one before */
    CellBracket b = { bcast(0), bcast(0), first, first };
    flt k = sel(in_box->enters < in_box->leaves, bcast(1), bcast(c->steps + 1.0f));
    flt found = bcast(0);

    loop_while(255, (msk)(k <= c->steps) & (msk)(found < 0.5f))
    {
        flt t = k * step;
        flt here, off = cell_behind(gp, &c->cells, &path, t, &here);
        msk walks = (msk)(k <= c->steps) & (msk)(found < 0.5f);
        b.low = sel(walks, b.high, b.low);
        b.before = sel(walks, b.after, b.before);
        b.high = sel(walks, t, b.high);
        b.after = sel(walks, off, b.after);
        deep = sel(walks, deeper, deep);
        deeper = sel(walks, here, deeper);
        msk meets =
            (msk)(b.before * b.after <= 0.0f) & (msk)(sel(b.after > 0.0f, deeper, deep) <= thick);
        found = sel(meets, bcast(1), found);
        k = k + 1.0f;
    }
    flt t = cell_meet(gp, &c->cells, &path, b, c->halvings, found > 0.5f);
    return sel(found > 0.5f, t, bcast(-1));
}

SLAB_PIXEL_SHADERS(relief, ReliefUniforms, search);
SLAB_PROGRAMS(relief, GP_VS_3_0, GP_PS_3_0, 1 << 0 | 1 << 1)
