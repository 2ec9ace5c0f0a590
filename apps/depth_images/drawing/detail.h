/* Micro-structure: a small relief that is repeated over a depth image. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_DETAIL_H
#define APPS_DEPTH_IMAGES_DRAWING_DETAIL_H

#include "pipeline/resources/surface.h"
#include "shaders_c/warp/detail.h"

#include <stddef.h>

/* All zero: none. It needs a vertex wherever it is to be seen: grids are not merged under it.
 * source paper 001, section 3.4 */
typedef struct WarpDetail {
    const GpSurface *heights; /* 0..1 in red; NULL: none. Borrowed until frames have run */
    double amplitude;         /* world units by which 1 stands out of what 0 leaves as it is */
    double repeats[2];        /* across the picture and down; 0: 1 */
} WarpDetail;

static inline WarpDetailUniforms warp_detail_uniforms(const WarpDetail *detail)
{
    WarpDetailUniforms uniforms = { .height = (float)detail->amplitude };
    for (int i = 0; i < 2; i++)
        uniforms.repeats[i] = (float)(detail->repeats[i] > 0 ? detail->repeats[i] : 1);
    return uniforms;
}

#endif
