/* Depth codes in lanes. */
#ifndef GP_FAST_DEPTH_H
#define GP_FAST_DEPTH_H

#include "pipeline/resources/compare.h"
#include "pipeline/fast/lanes/memory/convert.h"
#include "pipeline/fast/lanes/memory/packet.h"

/* Lanes in which a test accepts how two numbers compare. */
GP_INLINE msk accepted_lanes(GpCompare test, msk less, msk equal, msk greater)
{
    msk accepted = itg_set(0);
    if (gp_compare_accepts(test, GP_IS_LESS))
        accepted |= less;
    if (gp_compare_accepts(test, GP_IS_EQUAL))
        accepted |= equal;
    if (gp_compare_accepts(test, GP_IS_GREATER))
        accepted |= greater;
    return accepted;
}

/* Codes are below 2^31, so signed comparison is right. */
GP_INLINE msk compare_codes(GpCompare test, itg a, itg b)
{
    msk less = (msk)(a < b), equal = (msk)(a == b);
    return accepted_lanes(test, less, equal, ~(less | equal));
}

/* Codes of depths that come, clamped to the viewport's range. */
GP_INLINE itg coming_codes(const Tile *tile, const FastDraw *d, flt z)
{
    const flt low = flt_set(d->viewport.min_depth), high = flt_set(d->viewport.max_depth);
    z = flt_select((msk)(z < low), low, z);
    z = flt_select((msk)(z > high), high, z);
    return depth_codes(tile->depth_format, z);
}

/* As gp_depth_put_back. */
GP_INLINE itg put_back(const Tile *tile, const FastDraw *d, itg codes)
{
    if (tile->depth_format == GP_D32F)
        return (itg)((flt)codes + gp_bits_float(d->epsilon));
    return codes + (int32_t)d->epsilon;
}

/* Any depth and stencil state, on the lanes of a row or of quads from one place of the tile on.
 * in   z: not yet clamped to the viewport's range
 * out  replaced: of the lanes that pass, those that replace, by the ternary test
 * returns the lanes that pass both tests */
msk fast_test_depth_stencil(Tile *tile, const FastDraw *draw, uint32_t at, bool quads, msk live,
                            flt z, bool front, msk *replaced);

/* The same on the lanes of a packet.
 * returns those of `live` that pass */
unsigned fast_test_packet(Tile *tile, const FastDraw *draw, const FastPacket *packet, bool front,
                          unsigned live, flt z, unsigned *replaced);

#endif
