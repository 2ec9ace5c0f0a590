/* Texture sampling: addressing, level of detail, filtering, depth comparison (R40-R44, R46, R48,
 * R49). */
#ifndef GP_TEXTURE_H
#define GP_TEXTURE_H

#include "pipeline/resources/sample_report.h"
#include "pipeline/resources/state.h"

/* Level of detail before bias and clamp: log2 of the longer of the two footprint axes, from the
 * derivatives of u and v by x and by y, in texture space (R44).
 * in   ddx, ddy: (du, dv) across one pixel; width, height: texels of level 0
 * out  at most 64, -infinity for a footprint whose square is 0 in binary32; NaN gives 0 */
float gp_texture_lod(const float ddx[2], const float ddy[2], uint32_t width, uint32_t height);

/* The border as one texel of the surface's format. */
void gp_texture_border(const GpTexture *texture, uint8_t border[16]);

/* Samples one point.
 * in   uvr: u, v in texture space, r the reference depth (compare samplers, depth formats only);
 *      lod: before bias and clamp. NaN and infinities anywhere are safe: see texture_address.h
 * out  rgba; for compare samplers all four hold the share of r <= stored;
 *      report: the texels that have a part in the result, where not NULL
 * note 8-bit unorm formats give the exact bilinear value, correctly rounded; all others blend
 *      floats with the mix of texture.c; so do mip levels. A texel of weight 0 is not looked at,
 *      others pass their NaN on. The border is first stored in the surface's format. An unbound
 *      texture (surface NULL) gives (0, 0, 0, 1)
 * source Direct3D 11.3 functional specification 7.18; the arithmetic is ours */
void gp_texture_sample(const GpTexture *texture, const float uvr[3], float lod, float rgba[4],
                       GpSampleReport *report);

#endif
