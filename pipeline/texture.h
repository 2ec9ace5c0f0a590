/* Texture sampling: addressing, level of detail, filtering, depth comparison (R40-R44, R46, R48,
 * R49). */
#ifndef GP_TEXTURE_H
#define GP_TEXTURE_H

#include "pipeline/state.h"

/* One texel that a sample used, for the inspector. */
typedef struct GpTexelUse {
    int32_t x, y;      /* after addressing; -1, -1 where the border colour was used */
    uint8_t level;
    float weight;      /* share in the result */
    float value[4];    /* as loaded: r g b a */
} GpTexelUse;

typedef struct GpSampleReport {
    float lod;              /* after bias and clamp, as an 8.8 fixed-point value */
    bool magnified;
    int count;              /* texels used, at most 8 */
    GpTexelUse texel[8];
} GpSampleReport;

/* Level of detail before bias and clamp: log2 of the longer of the two footprint axes, from the
 * derivatives of u and v by x and by y, in texture space (R44).
 * in   ddx, ddy: (du, dv) across one pixel; width, height: texels of level 0
 * out  finite or -infinity for a zero footprint; NaN derivatives give 0 */
float gp_texture_lod(const float ddx[2], const float ddy[2], uint32_t width, uint32_t height);

/* Samples one point.
 * in   uvr: u, v in texture space, r the reference depth (compare samplers only);
 *      lod: before bias and clamp
 * out  rgba; for compare samplers all four hold the share of r <= stored;
 *      report: what was read, where not NULL
 * note an unbound texture (surface NULL) gives (0, 0, 0, 1) */
void gp_texture_sample(const GpTexture *texture, const float uvr[3], float lod, float rgba[4],
                       GpSampleReport *report);

#endif
