/* Texture addressing: from coordinates to texel numbers, and from a level of detail to mip levels
 * (R40-R44). Everything after this is integer: shares are 256ths. */
#ifndef GP_TEXTURE_ADDRESS_H
#define GP_TEXTURE_ADDRESS_H

#include "pipeline/resources/state.h"

/* The two texels of one axis that a coordinate lies between: first and first + 1. */
typedef struct GpTexelPair {
    int32_t first;  /* before addressing */
    uint32_t share; /* of first + 1, in 256ths, 0..255; always 0 for point filtering */
} GpTexelPair;

/* Texels for a coordinate along one axis.
 * in   coordinate: in texture space, any float. It is first reduced (R42): to the fraction for
 *      wrap, to one period of 2 for mirror, into [-10, 10] for the other modes. NaN counts as 0;
 *      an infinity clamps like any large number, and counts as 0 where it would have to wrap
 * note the position in texels is rounded to 8 fraction bits, to nearest even, before it is cut into
 *      texel and share (R40): texel centres hit their texel exactly for any size
 * source Direct3D 11.3 functional specification 7.18.6-7.18.8 */
GpTexelPair gp_texel_pair(GpAddress mode, GpFilter filter, float coordinate, uint32_t size);

/* Number of the texel that stands for texel `index`, 0..size-1; -1 for the border (R41).
 * source Direct3D 11.3 functional specification 7.18.9 */
int32_t gp_texel_address(GpAddress mode, int32_t index, uint32_t size);

/* The two mip levels that a level of detail lies between: first and first + 1. */
typedef struct GpLevelPair {
    uint32_t first; /* a level that exists, and so does first + 1 where share is not 0 */
    uint32_t share; /* of first + 1, in 256ths, 0..255 */
    bool magnified; /* the magnification filter applies */
    float lod;      /* after bias and clamp, rounded to 8 fraction bits; within [-128, 128) */
} GpLevelPair;

/* Levels for a level of detail (R43, R44): bias, then clamp to the sampler's range, the lower bound
 * last; magnified if the result is not positive; rounded to 8.8 fixed point; for GP_MIP_POINT plus
 * one half and truncated. GP_MIP_NONE reads the finest level that the sampler allows.
 * in   levels: of the surface, at least 1; lod: any float, NaN counts as 0
 * source Direct3D 11.3 functional specification 7.18.10-7.18.11 */
GpLevelPair gp_level_pair(const GpSampler *sampler, uint32_t levels, float lod);

#endif
