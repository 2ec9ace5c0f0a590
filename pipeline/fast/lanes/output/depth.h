/* Depth codes in lanes. */
#ifndef GP_FAST_DEPTH_H
#define GP_FAST_DEPTH_H

#include "pipeline/resources/compare.h"
#include "pipeline/fast/lanes/memory/packet.h"

/* Depth to the code that is stored, as gp_depth_code: unorm by binary64, floats by their bits. */
GP_INLINE itg depth_codes(GpFormat format, flt z)
{
    if (format == GP_D32F) {
        itg bits = (itg)(z + 0.0f); /* -0 becomes 0 */
        return itg_select((itg)(z == z), bits, itg_set(0x7fc00000));
    }
    double scale = format == GP_D16 ? 65535.0 : 16777215.0;
    flt safe = flt_select(z > 0.0f, z, flt_set(0)); /* NaN to 0 */
    return __builtin_convertvector(__builtin_convertvector(safe, dbl) * scale + 0.5, itg);
}

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

/* Any depth and stencil state, on the lanes of a row or of quads from one place of the tile on.
 * in   z: not yet clamped to the viewport's range
 * returns the lanes that pass both tests */
msk fast_test_depth_stencil(Tile *tile, const FastDraw *draw, uint32_t at, bool quads, msk live,
                            flt z, bool front);

/* The same on the lanes of a packet.
 * returns those of `live` that pass */
unsigned fast_test_packet(Tile *tile, const FastDraw *draw, const FastPacket *packet, bool front,
                          unsigned live, flt z);

#endif
