/* Stored numbers and floats in lanes. */
#ifndef GP_FAST_CONVERT_H
#define GP_FAST_CONVERT_H

#include "pipeline/fast/lanes/memory/tile.h"

/* gp_float_from_half. */
GP_INLINE itg float_from_half(itg half)
{
    itg sign = (half & 0x8000) << 16, size = half & 0x7fff;
    itg normal = (size << 13) + (112 << 23);
    itg small = (itg)(flt_from_itg(size) * 0x1p-24f);
    itg finite = itg_select((itg)(size < 0x400), small, normal);
    itg special = itg_select((itg)(size > 0x7c00), itg_set(0x7fc00000), sign | 0x7f800000);
    return itg_select((itg)(size < 0x7c00), finite | sign, special);
}

/* gp_half_from_float of a float that some half is equal to. */
GP_INLINE itg half_from_float(itg bits)
{
    itg sign = bits >> 16 & 0x8000, size = bits & 0x7fffffff;
    itg normal = (size >> 13) - (112 << 10);
    itg small = (itg)((flt)size + 0.5f) - 0x3f000000;
    itg finite = itg_select((itg)(size < 0x38800000), small, normal);
    itg special = itg_select((itg)(size > 0x7f800000), itg_set(0x7e00), sign | 0x7c00);
    return itg_select((itg)(size < 0x7f800000), finite | sign, special);
}

/* A NaN of other bits than are stored (R31). A caller's may be in a target, and stays as it is
 * where nothing is written. */
GP_INLINE msk is_odd_nan(itg bits)
{
    return (msk)((bits & 0x7fffffff) > 0x7f800000) & (msk)(bits != 0x7fc00000);
}

/* What a pixel holds as long as nothing is written to it that had such a NaN, where there is no
 * room for its bits. It signals: any arithmetic makes another of it. */
enum { ODD_NAN = 0x7f800001 };

/* Any NaN becomes the one that is stored (R31). */
GP_INLINE itg canonical(itg bits)
{
    return itg_select((itg)((bits & 0x7fffffff) > 0x7f800000), itg_set(0x7fc00000), bits);
}

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

/* Codes of unorm depth as floats; words of other formats are their own. */
GP_INLINE flt depth_from_codes(GpFormat format, itg words)
{
    switch (format) { /* the divisions' operands are exact, as in gp_float_from_unorm */
    case GP_D16:
        return flt_from_itg(words) / 65535.0f;
    case GP_D24S8:
        return flt_from_itg(words) / 16777215.0f;
    default:
        return (flt)words;
    }
}

#endif
