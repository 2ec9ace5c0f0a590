/* Surface formats and every rounding between floats and stored bits.
 *
 * The formats are those of the 2005 generation that the techniques use, named as Direct3D 9 names
 * them: from the most significant bits down, little-endian in memory (A8R8G8B8 is bytes B G R A).
 * Rules R19-R31 of CONVENTIONS.md; a rounding that is not here does not exist.
 */
#ifndef GP_FORMAT_H
#define GP_FORMAT_H

#include "pipeline/base/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How a texel is stored; the letters go from the highest bit down, as in Direct3D. */
typedef enum GpFormat {
    GP_FORMAT_NONE = 0,
    GP_A8R8G8B8,
    GP_A8R8G8B8_SRGB, /* same bits; colour is decoded to linear when read (R26); not a target */
    GP_X8R8G8B8,      /* no alpha: reads 1; a store leaves 255 in the unused byte */
    GP_R8,            /* one unorm byte; reads as (r, 1, 1, 1) like the float formats below */
    GP_L8,            /* one unorm byte; reads as (l, l, l, 1), stores red; not a target */
    GP_G16R16F,
    GP_A16B16G16R16F,
    GP_R32F,
    GP_A32B32G32R32F,
    GP_D16,
    GP_D24S8, /* depth in bits 31..8, stencil in bits 7..0 */
    GP_D32F,
    GP_FORMATS
} GpFormat;

/* What a format can be used for. */
typedef struct GpFormatInfo {
    const char *name;      /* as in scene files and hashes: "A8R8G8B8" */
    uint8_t bytes;         /* per texel */
    uint8_t channels;      /* colour channels stored, 0 for depth formats */
    bool is_unorm8;        /* linear 8-bit channels: filtered as exact integers */
    bool is_float;         /* 16- or 32-bit float channels */
    bool is_depth;         /* usable as depth target and for depth-compare sampling */
    bool has_stencil;      /* 8 stencil bits */
    bool is_target;        /* usable as colour target */
    uint8_t depth_bits;    /* 16, 24 or 32 (float); 0 for colour */
    uint8_t first_byte[4]; /* of the stored channels r, g, b, a inside the texel */
} GpFormatInfo;

/* Description of a format; GP_ASSERT on a value that is no format. */
const GpFormatInfo *gp_format_info(GpFormat format);

/* Format of a name, any case ("a8r8g8b8", "d24s8"); GP_FORMAT_NONE where there is none. */
GpFormat gp_format_from_name(const char *name);

/* --- scalars ---------------------------------------------------------------------------------- */

/* Float to n-bit unorm code, 1 <= n <= 24: NaN to 0, clamp to [0,1], times 2^n - 1, add 0.5,
 * truncate, all in binary64 (R19, R20, R24). */
uint32_t gp_unorm_from_float(float value, int bits);

/* n-bit unorm code to float: code / (2^n - 1), correctly rounded (R23). */
float gp_float_from_unorm(uint32_t code, int bits);

/* n-bit snorm code, 2 <= n <= 16, to float: code / (2^(n-1) - 1), correctly rounded; the least code
 * is -1 as the one above it is (R25). */
float gp_float_from_snorm(int32_t code, int bits);

/* Float to half: to nearest even, overflow to infinity, denormals kept, any NaN to 0x7e00 (R27,
 * R28, R31). */
uint16_t gp_half_from_float(float value);

/* Half to float, exact; any NaN to 0x7fc00000. */
float gp_float_from_half(uint16_t half);

/* sRGB-encoded byte to linear float, correctly rounded, 0 and 1 exact (R26); in format_srgb.c. */
float gp_linear_from_srgb8(uint8_t code);

/* Linear float to sRGB-encoded byte: NaN to 0, clamp, the exact curve, rounded as R24 rounds. */
uint8_t gp_srgb8_from_linear(float value);

enum { GP_QUIET_NAN = 0x7fc00000 };

/* The value with any NaN replaced by the one quiet NaN: done on every float store, since
 * hardware disagrees about the bits of a computed NaN. */
static inline float gp_canonical(float value)
{
    return value == value ? value : gp_bits_float(GP_QUIET_NAN);
}

/* --- texels ----------------------------------------------------------------------------------- */

/* Reads one texel as (r, g, b, a). Channels that the format lacks read as 1, but for green and blue
 * of L8, which read as red; depth formats give (depth, 1, 1, 1).
 * in   texel: bytes of the format, any alignment
 * out  rgba */
void gp_texel_load(GpFormat format, const void *texel, float rgba[4]);

/* Writes one colour texel; channels that the format lacks are dropped, floats are canonicalised.
 * Colour of sRGB formats is encoded: mip levels and clears need it, though no pass draws there.
 * keep: bit c set leaves channel c (0 red .. 3 alpha) with the bits it has (R37). */
void gp_texel_store(GpFormat format, void *texel, const float rgba[4], unsigned keep);

/* The bytes of a texel of an is_unorm8 format as r, g, b, a, as gp_texel_load has them. */
void gp_texel_codes(GpFormat format, const void *texel, uint8_t code[4]);

/* --- depth ------------------------------------------------------------------------------------ */

/* Depth float, already clamped to [0,1], to the integer that is stored and compared (R19-R21): the
 * unorm code for D16 and D24S8; the float's bits for D32F, whose order is that of the floats
 * since they are not negative. NaN becomes 0 for unorm formats and canonical NaN for D32F. */
uint32_t gp_depth_code(GpFormat format, float depth);

/* Stored code back to a float. */
float gp_depth_from_code(GpFormat format, uint32_t code);

/* Reads and writes the two parts of a depth texel; stencil is 0 and ignored without stencil. */
void gp_depth_load(GpFormat format, const void *texel, uint32_t *depth_code, uint8_t *stencil);
void gp_depth_store(GpFormat format, void *texel, uint32_t depth_code, uint8_t stencil);

#ifdef __cplusplus
}
#endif

#endif
