/* Formats: what their texels hold, and every rounding on the way in and out. Rules R19 to R31. */
#include "pipeline/resources/format.h"

#include <string.h>
#include <strings.h>

/* How a channel's bits mean a number. */
typedef enum Coding { CODING_UNORM8, CODING_SRGB8, CODING_HALF, CODING_FLOAT } Coding;

/* clang-format off */
static const GpFormatInfo infos[GP_FORMATS] = {
    /*                      name        bytes channels unorm8 float  depth stencil target depth bytes of r g b a */
    [GP_A8R8G8B8]      = { "A8R8G8B8",         4, 4,      true,  false, false, false, true,  0,  { 2, 1, 0, 3 } },
    [GP_A8R8G8B8_SRGB] = { "A8R8G8B8_SRGB",    4, 4,      false, false, false, false, false, 0,  { 2, 1, 0, 3 } },
    [GP_X8R8G8B8]      = { "X8R8G8B8",         4, 3,      true,  false, false, false, true,  0,  { 2, 1, 0 } },
    [GP_R8]            = { "R8",               1, 1,      true,  false, false, false, true,  0,  { 0 } },
    [GP_L8]            = { "L8",               1, 1,      true,  false, false, false, false, 0,  { 0 } },
    [GP_G16R16F]       = { "G16R16F",          4, 2,      false, true,  false, false, true,  0,  { 0, 2 } },
    [GP_A16B16G16R16F] = { "A16B16G16R16F",    8, 4,      false, true,  false, false, true,  0,  { 0, 2, 4, 6 } },
    [GP_R32F]          = { "R32F",             4, 1,      false, true,  false, false, true,  0,  { 0 } },
    [GP_A32B32G32R32F] = { "A32B32G32R32F",   16, 4,      false, true,  false, false, true,  0,  { 0, 4, 8, 12 } },
    [GP_D16]           = { "D16",              2, 0,      false, false, true,  false, false, 16, { 0 } },
    [GP_D24S8]         = { "D24S8",            4, 0,      false, false, true,  true,  false, 24, { 0 } },
    [GP_D32F]          = { "D32F",             4, 0,      false, false, true,  false, false, 32, { 0 } },
};

static const Coding codings[GP_FORMATS] = {
    [GP_A8R8G8B8] = CODING_UNORM8,  [GP_A8R8G8B8_SRGB] = CODING_SRGB8,
    [GP_X8R8G8B8] = CODING_UNORM8,  [GP_L8] = CODING_UNORM8,
    [GP_R8] = CODING_UNORM8,        [GP_G16R16F] = CODING_HALF,
    [GP_A16B16G16R16F] = CODING_HALF, [GP_R32F] = CODING_FLOAT,
    [GP_A32B32G32R32F] = CODING_FLOAT,
};
/* clang-format on */

const GpFormatInfo *gp_format_info(GpFormat format)
{
    GP_ASSERT(format > GP_FORMAT_NONE && format < GP_FORMATS);
    return &infos[format];
}

GpFormat gp_format_from_name(const char *name)
{
    for (GpFormat format = GP_FORMAT_NONE + 1; format < GP_FORMATS; format++)
        if (strcasecmp(name, infos[format].name) == 0)
            return format;
    return GP_FORMAT_NONE;
}

/* --- scalars ---------------------------------------------------------------------------------- */

uint32_t gp_unorm_from_float(float value, int bits)
{
    GP_ASSERT(bits >= 1 && bits <= 24);
    if (!(value > 0.0f)) /* NaN too */
        return 0;
    if (value > 1.0f)
        value = 1.0f;
    /* 24 significant bits times 24 bits fit into binary64's 53, and so does the sum near any code
     * boundary: the truncation is exact. In binary32 a quarter of the D24 codes would be lost. */
    double scale = (double)((1u << bits) - 1);
    return (uint32_t)((double)value * scale + 0.5);
}

float gp_float_from_unorm(uint32_t code, int bits)
{
    GP_ASSERT(bits >= 1 && bits <= 24 && code >> bits == 0);
    /* Both operands are exact floats, so the one rounding is the division's. */
    return (float)code / (float)((1u << bits) - 1);
}

float gp_float_from_snorm(int32_t code, int bits)
{
    const int32_t most = (1 << (bits - 1)) - 1;
    GP_ASSERT(bits >= 2 && bits <= 16 && code >= -most - 1 && code <= most);
    return code < -most ? -1.0f : (float)code / (float)most;
}

uint16_t gp_half_from_float(float value)
{
    uint32_t bits = gp_float_bits(value);
    uint32_t sign = bits >> 16 & 0x8000u;
    uint32_t size = bits & 0x7fffffffu;

    if (size > 0x7f800000u)
        return 0x7e00u;
    if (size >= 0x477ff000u) /* 65520: half-way from the largest half, 65504, to the next step */
        return (uint16_t)(sign | 0x7c00u);
    if (size < 0x38800000u) {
        /* Below 2^-14 halves are the multiples of 2^-24, and so are the floats from 0.5 to 1: the
         * addition rounds, to nearest even, and leaves the count in the low bits. */
        float shifted = gp_bits_float(size) + 0.5f;
        return (uint16_t)(sign | (gp_float_bits(shifted) - gp_float_bits(0.5f)));
    }
    /* Exponent bias 127 to 15, then 13 bits fewer: half a step less one, plus the bit that makes a
     * tie odd or even. A carry runs into the exponent, which is right. */
    uint32_t rebiased = size - (112u << 23);
    return (uint16_t)(sign | (rebiased + 0xfffu + (rebiased >> 13 & 1u)) >> 13);
}

float gp_float_from_half(uint16_t half)
{
    uint32_t sign = (uint32_t)(half & 0x8000u) << 16;
    uint32_t exponent = half >> 10 & 31u;
    uint32_t fraction = half & 0x3ffu;

    if (exponent == 31)
        return gp_bits_float(fraction ? 0x7fc00000u : sign | 0x7f800000u);
    if (exponent == 0)
        return gp_bits_float(sign | gp_float_bits((float)fraction * 0x1p-24f));
    return gp_bits_float(sign | (exponent + 112) << 23 | fraction << 13);
}

/* --- channels --------------------------------------------------------------------------------- */

/* Little-endian words at any alignment; compilers make one move of these. */
static uint32_t load16(const uint8_t *bytes)
{
    return bytes[0] | (uint32_t)bytes[1] << 8;
}

static uint32_t load32(const uint8_t *bytes)
{
    return load16(bytes) | load16(bytes + 2) << 16;
}

static void store16(uint8_t *bytes, uint32_t word)
{
    bytes[0] = (uint8_t)word;
    bytes[1] = (uint8_t)(word >> 8);
}

static void store32(uint8_t *bytes, uint32_t word)
{
    store16(bytes, word);
    store16(bytes + 2, word >> 16);
}

/* Alpha is linear also where colour is not (R26). */
static Coding channel_coding(GpFormat format, int channel)
{
    return codings[format] == CODING_SRGB8 && channel == 3 ? CODING_UNORM8 : codings[format];
}

static float load_channel(Coding coding, const uint8_t *bytes)
{
    switch (coding) {
    case CODING_UNORM8:
        return gp_float_from_unorm(bytes[0], 8);
    case CODING_SRGB8:
        return gp_linear_from_srgb8(bytes[0]);
    case CODING_HALF:
        return gp_float_from_half((uint16_t)load16(bytes));
    case CODING_FLOAT:
        break;
    }
    return gp_bits_float(load32(bytes));
}

static void store_channel(Coding coding, uint8_t *bytes, float value)
{
    switch (coding) {
    case CODING_UNORM8:
        bytes[0] = (uint8_t)gp_unorm_from_float(value, 8);
        return;
    case CODING_SRGB8:
        bytes[0] = gp_srgb8_from_linear(value);
        return;
    case CODING_HALF:
        store16(bytes, gp_half_from_float(value));
        return;
    case CODING_FLOAT:
        store32(bytes, gp_float_bits(gp_canonical(value)));
        return;
    }
}

/* --- texels ----------------------------------------------------------------------------------- */

void gp_texel_load(GpFormat format, const void *texel, float rgba[4])
{
    const GpFormatInfo *info = gp_format_info(format);
    const uint8_t *bytes = texel;

    for (int c = 0; c < 4; c++)
        rgba[c] = 1.0f;
    for (int c = 0; c < info->channels; c++)
        rgba[c] = load_channel(channel_coding(format, c), bytes + info->first_byte[c]);
    if (format == GP_L8)
        rgba[1] = rgba[2] = rgba[0];
    if (info->is_depth) {
        uint32_t code;
        uint8_t stencil;
        gp_depth_load(format, texel, &code, &stencil);
        rgba[0] = gp_depth_from_code(format, code);
    }
}

void gp_texel_store(GpFormat format, void *texel, const float rgba[4], unsigned keep)
{
    const GpFormatInfo *info = gp_format_info(format);
    uint8_t *bytes = texel;

    GP_ASSERT(!info->is_depth);
    for (int c = 0; c < info->channels; c++)
        if (!(keep >> c & 1u))
            store_channel(channel_coding(format, c), bytes + info->first_byte[c], rgba[c]);
    if (format == GP_X8R8G8B8)
        bytes[3] = 255;
}

void gp_texel_codes(GpFormat format, const void *texel, uint8_t code[4])
{
    const GpFormatInfo *info = gp_format_info(format);
    const uint8_t *bytes = texel;

    GP_ASSERT(info->is_unorm8);
    for (int c = 0; c < 4; c++)
        code[c] = c < info->channels ? bytes[info->first_byte[c]] : 255;
    if (format == GP_L8)
        code[1] = code[2] = code[0];
}

/* --- depth ------------------------------------------------------------------------------------ */

static int depth_bits(GpFormat format)
{
    const GpFormatInfo *info = gp_format_info(format);
    GP_ASSERT(info->is_depth);
    return info->depth_bits;
}

uint32_t gp_depth_code(GpFormat format, float depth)
{
    int bits = depth_bits(format);
    if (bits < 32)
        return gp_unorm_from_float(depth, bits);
    /* As an integer -0 would lie behind everything. */
    return depth == 0.0f ? 0 : gp_float_bits(gp_canonical(depth));
}

float gp_depth_from_code(GpFormat format, uint32_t code)
{
    int bits = depth_bits(format);
    return bits < 32 ? gp_float_from_unorm(code, bits) : gp_bits_float(code);
}

void gp_depth_load(GpFormat format, const void *texel, uint32_t *depth_code, uint8_t *stencil)
{
    int bits = depth_bits(format);
    uint32_t word = bits == 16 ? load16(texel) : load32(texel);
    *depth_code = bits == 24 ? word >> 8 : word;
    *stencil = bits == 24 ? (uint8_t)word : 0;
}

void gp_depth_store(GpFormat format, void *texel, uint32_t depth_code, uint8_t stencil)
{
    int bits = depth_bits(format);
    if (bits == 16)
        store16(texel, depth_code);
    else
        store32(texel, bits == 24 ? depth_code << 8 | stencil : depth_code);
}
