/* Micro-structure: a small relief that is repeated over a depth image. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_DETAIL_H
#define APPS_DEPTH_IMAGES_DRAWING_DETAIL_H

#include "apps/depth_images/depth_image.h"
#include "pipeline/resources/state.h"
#include "shaders_c/warp/detail.h"

/* All zero: none. It needs a vertex wherever it is to be seen: grids are not merged under it.
 * source paper 001, section 3.4 */
typedef struct WarpDetail {
    const GpSurface *heights; /* 0..1 in red; NULL: none. Borrowed until frames have run */
    double amplitude;         /* world units by which 1 stands out of what 0 leaves as it is */
    double repeats[2];        /* across the picture and down; 0: 1 */
    /* heights are filtered, those of a level of the texture that is no finer than vertices; else
     * each vertex has that of the texel it is in */
    bool is_smooth;
} WarpDetail;

/* in  step: pixels of the image from vertex to vertex */
WarpDetailUniforms warp_detail_uniforms(const WarpDetail *detail, const DepthPixels *pixels,
                                        uint32_t step);

/* Heights as vertex shaders read them. */
GpTexture warp_detail_texture(const WarpDetail *detail);

/* Leans the normals of a layer, which it has, by as much as the relief leans those that its points
 * have.
 * in/out pixels: a layer of the image
 * errors GP_ERROR_MEMORY; source: ours, after Blinn, "Simulation of wrinkled surfaces", SIGGRAPH
 *      1978 */
GpResult warp_detail_lean(const DepthImage *image, DepthPixels *pixels, const WarpDetail *detail,
                          GpError *error);

#endif
