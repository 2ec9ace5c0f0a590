/* Texels and planes. Planes hold what reading the stored texel gives, so storing never rounds. */
#include "pipeline/fast/lanes/transfer.h"

#include <string.h>

typedef uint8_t byte_lanes __attribute__((vector_size(GP_LANES)));
typedef uint16_t half_lanes __attribute__((vector_size(2 * GP_LANES)));

enum { LARGEST_TEXEL = 16 };

/* --- memory ----------------------------------------------------------------------------------------- */

GP_INLINE itg load_words(const void *from)
{
    itg words;
    memcpy(&words, from, sizeof words);
    return words;
}

GP_INLINE void store_words(void *to, itg words)
{
    memcpy(to, &words, sizeof words);
}

GP_INLINE itg load_halves(const void *from)
{
    half_lanes halves;
    memcpy(&halves, from, sizeof halves);
    return __builtin_convertvector(halves, itg);
}

GP_INLINE void store_halves(void *to, itg words)
{
    half_lanes halves = __builtin_convertvector(words, half_lanes);
    memcpy(to, &halves, sizeof halves);
}

GP_INLINE itg load_bytes(const void *from)
{
    byte_lanes bytes;
    memcpy(&bytes, from, sizeof bytes);
    return __builtin_convertvector(bytes, itg);
}

GP_INLINE void store_bytes(void *to, itg words)
{
    byte_lanes bytes = __builtin_convertvector(words, byte_lanes);
    memcpy(to, &bytes, sizeof bytes);
}

/* --- numbers --------------------------------------------------------------------------------------- */

/* gp_float_from_half. */
GP_INLINE itg from_half(itg half)
{
    itg sign = (half & 0x8000) << 16, size = half & 0x7fff;
    itg normal = (size << 13) + (112 << 23);
    itg small = (itg)(flt_from_itg(size) * 0x1p-24f);
    itg finite = itg_select((itg)(size < 0x400), small, normal);
    itg special = itg_select((itg)(size > 0x7c00), itg_set(0x7fc00000), sign | 0x7f800000);
    return itg_select((itg)(size < 0x7c00), finite | sign, special);
}

/* gp_half_from_float of a float that some half is equal to. */
GP_INLINE itg to_half(itg bits)
{
    itg sign = bits >> 16 & 0x8000, size = bits & 0x7fffffff;
    itg normal = (size >> 13) - (112 << 10);
    itg small = (itg)((flt)size + 0.5f) - 0x3f000000;
    itg finite = itg_select((itg)(size < 0x38800000), small, normal);
    itg special = itg_select((itg)(size > 0x7f800000), itg_set(0x7e00), sign | 0x7c00);
    return itg_select((itg)(size < 0x7f800000), finite | sign, special);
}

GP_INLINE itg canonical(itg bits)
{
    return itg_select((itg)((bits & 0x7fffffff) > 0x7f800000), itg_set(0x7fc00000), bits);
}

/* --- colour ---------------------------------------------------------------------------------------- */

static void load_whole(GpFormat format, const uint8_t *from, int32_t count, FastPlanes *planes,
                       uint32_t at)
{
    for (int32_t x = 0; x < count; x += GP_LANES, at += GP_LANES) {
        float *const channel[4] = { planes->channel[0] + at, planes->channel[1] + at,
                                    planes->channel[2] + at, planes->channel[3] + at };
        const uint8_t *texel = from + (size_t)x * gp_format_info(format)->bytes;
        itg v[4];
        switch (format) {
        case GP_A8R8G8B8:
            store_words(planes->packed + at, load_words(texel));
            break;
        case GP_R8:
            flt_store(channel[0], flt_from_itg(load_bytes(texel)) / 255.0f);
            break;
        case GP_G16R16F:
            v[0] = load_words(texel);
            store_words(channel[0], from_half(v[0] & 0xffff));
            store_words(channel[1], from_half((itg)((utg)v[0] >> 16)));
            break;
        case GP_A16B16G16R16F:
            v[0] = load_words(texel);
            v[1] = load_words(texel + sizeof(itg));
            v[2] = itg_evens(v[0], v[1]);
            v[3] = itg_odds(v[0], v[1]);
            store_words(channel[0], from_half(v[2] & 0xffff));
            store_words(channel[1], from_half((itg)((utg)v[2] >> 16)));
            store_words(channel[2], from_half(v[3] & 0xffff));
            store_words(channel[3], from_half((itg)((utg)v[3] >> 16)));
            break;
        case GP_R32F:
            store_words(channel[0], load_words(texel));
            break;
        default: /* GP_A32B32G32R32F: r b r b ..., g a g a ... of each half, then r r ... */
            for (int i = 0; i < 4; i++)
                v[i] = load_words(texel + (size_t)i * sizeof(itg));
            for (int odd = 0; odd < 2; odd++) {
                itg low = odd ? itg_odds(v[0], v[1]) : itg_evens(v[0], v[1]);
                itg high = odd ? itg_odds(v[2], v[3]) : itg_evens(v[2], v[3]);
                store_words(channel[odd], itg_evens(low, high));
                store_words(channel[odd + 2], itg_odds(low, high));
            }
        }
    }
}

static void store_whole(GpFormat format, uint8_t *to, int32_t count, const FastPlanes *planes,
                        uint32_t at)
{
    for (int32_t x = 0; x < count; x += GP_LANES, at += GP_LANES) {
        uint8_t *texel = to + (size_t)x * gp_format_info(format)->bytes;
        const float *const channel[4] = { planes->channel[0] + at, planes->channel[1] + at,
                                          planes->channel[2] + at, planes->channel[3] + at };
        itg rg, ba, low, high;
        switch (format) {
        case GP_A8R8G8B8:
            store_words(texel, load_words(planes->packed + at));
            break;
        case GP_R8: /* nearest: the float is within 2^-24 of code / 255 */
            store_bytes(texel, itg_from_flt(flt_load(channel[0]) * 255.0f + 0.5f));
            break;
        case GP_G16R16F:
            rg = to_half(load_words(channel[0])) | to_half(load_words(channel[1])) << 16;
            store_words(texel, rg);
            break;
        case GP_A16B16G16R16F:
            rg = to_half(load_words(channel[0])) | to_half(load_words(channel[1])) << 16;
            ba = to_half(load_words(channel[2])) | to_half(load_words(channel[3])) << 16;
            store_words(texel, itg_zip_low(rg, ba));
            store_words(texel + sizeof(itg), itg_zip_high(rg, ba));
            break;
        case GP_R32F:
            store_words(texel, canonical(load_words(channel[0])));
            break;
        default: /* GP_A32B32G32R32F */
            for (int half = 0; half < 2; half++) {
                itg v[4];
                for (int c = 0; c < 4; c++)
                    v[c] = canonical(load_words(channel[c]));
                low = half ? itg_zip_high(v[0], v[2]) : itg_zip_low(v[0], v[2]);
                high = half ? itg_zip_high(v[1], v[3]) : itg_zip_low(v[1], v[3]);
                store_words(texel + (size_t)(2 * half) * sizeof(itg), itg_zip_low(low, high));
                store_words(texel + (size_t)(2 * half + 1) * sizeof(itg), itg_zip_high(low, high));
            }
        }
    }
}

/* What is left of a row goes by way of a buffer that is wide enough for all lanes. */

void FAST(load_colors)(GpFormat format, const uint8_t *texels, int32_t count, FastPlanes *planes,
                       uint32_t at)
{
    const size_t bytes = gp_format_info(format)->bytes;
    const int32_t whole = count / GP_LANES * GP_LANES;
    load_whole(format, texels, whole, planes, at);
    if (whole == count)
        return;
    uint8_t rest[GP_LANES * LARGEST_TEXEL] = { 0 };
    memcpy(rest, texels + (size_t)whole * bytes, (size_t)(count - whole) * bytes);
    load_whole(format, rest, GP_LANES, planes, at + (uint32_t)whole);
}

void FAST(store_colors)(GpFormat format, uint8_t *texels, int32_t count, const FastPlanes *planes,
                        uint32_t at)
{
    const size_t bytes = gp_format_info(format)->bytes;
    const int32_t whole = count / GP_LANES * GP_LANES;
    store_whole(format, texels, whole, planes, at);
    if (whole == count)
        return;
    uint8_t rest[GP_LANES * LARGEST_TEXEL];
    store_whole(format, rest, GP_LANES, planes, at + (uint32_t)whole);
    memcpy(texels + (size_t)whole * bytes, rest, (size_t)(count - whole) * bytes);
}

/* --- depth ----------------------------------------------------------------------------------------- */

static void load_whole_depths(GpFormat format, const uint8_t *from, int32_t count,
                              FastDepthPlanes *planes, uint32_t at)
{
    for (int32_t x = 0; x < count; x += GP_LANES, at += GP_LANES) {
        itg code = format == GP_D16 ? load_halves(from + 2 * x) : load_words(from + 4 * x);
        if (format == GP_D24S8)
            store_bytes(planes->stencil + at, code & 255);
        store_words(planes->depth + at, format == GP_D24S8 ? (itg)((utg)code >> 8) : code);
    }
}

static void store_whole_depths(GpFormat format, uint8_t *to, int32_t count,
                               const FastDepthPlanes *planes, uint32_t at)
{
    for (int32_t x = 0; x < count; x += GP_LANES, at += GP_LANES) {
        itg code = load_words(planes->depth + at);
        if (format == GP_D24S8)
            code = code << 8 | load_bytes(planes->stencil + at);
        if (format == GP_D16)
            store_halves(to + 2 * x, code);
        else
            store_words(to + 4 * x, code);
    }
}

void FAST(load_depths)(GpFormat format, const uint8_t *texels, int32_t count,
                       FastDepthPlanes *planes, uint32_t at)
{
    const size_t bytes = gp_format_info(format)->bytes;
    const int32_t whole = count / GP_LANES * GP_LANES;
    load_whole_depths(format, texels, whole, planes, at);
    if (whole == count)
        return;
    uint8_t rest[GP_LANES * LARGEST_TEXEL] = { 0 };
    memcpy(rest, texels + (size_t)whole * bytes, (size_t)(count - whole) * bytes);
    load_whole_depths(format, rest, GP_LANES, planes, at + (uint32_t)whole);
}

void FAST(store_depths)(GpFormat format, uint8_t *texels, int32_t count,
                        const FastDepthPlanes *planes, uint32_t at)
{
    const size_t bytes = gp_format_info(format)->bytes;
    const int32_t whole = count / GP_LANES * GP_LANES;
    store_whole_depths(format, texels, whole, planes, at);
    if (whole == count)
        return;
    uint8_t rest[GP_LANES * LARGEST_TEXEL];
    store_whole_depths(format, rest, GP_LANES, planes, at + (uint32_t)whole);
    memcpy(texels + (size_t)whole * bytes, rest, (size_t)(count - whole) * bytes);
}
