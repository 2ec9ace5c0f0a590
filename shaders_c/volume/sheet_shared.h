/* What is seen of matter without an order. For shader files only. */
#ifndef SHADERS_VOLUME_SHEET_SHARED_H
#define SHADERS_VOLUME_SHEET_SHARED_H

#include <glasspipe/shader.h>

/* (1 - exp(-e)) / e. Of little matter the difference has lost its digits, and its series has
 * them. */
GP_INLINE flt share_seen(flt e)
{
    const float log2_e = 1.44269504088896340736f;
    flt little = mad(e, mad(e, 1.0f / 6, -0.5f), 1);
    return sel(e < 0.0625f, little, (1.0f - exp_(e * -log2_e)) * rcp(max(e, 0.0625f)));
}

/* Light sent out and extinction along a ray to colour times opacity and opacity. */
GP_INLINE float4 sheet_of_light(float4 sheet)
{
    return mul(sheet, share_seen(sheet.w));
}

#endif
