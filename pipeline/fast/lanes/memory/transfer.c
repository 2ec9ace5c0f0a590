/* Texels and planes. Planes hold what reading the stored texel gives, so storing never rounds; of a
 * caller's odd NaNs their bits, or of halves a mark that the texel stays. */
#include "pipeline/fast/lanes/memory/transfer.h"

#include "pipeline/fast/lanes/memory/convert.h"

#include <string.h>

typedef uint8_t byte_lanes __attribute__((vector_size(GP_LANES)));
typedef uint16_t half_lanes __attribute__((vector_size(2 * GP_LANES)));

enum { LARGEST_TEXEL = 16 };

/* --- memory ----------------------------------------------------------------------------------- */

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

GP_INLINE void put_words(void *to, itg words, bool non_temporal)
{
    if (non_temporal)
        itg_stream(to, words);
    else
        store_words(to, words);
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

GP_INLINE void store_bytes(void *to, itg words)
{
    byte_lanes bytes = __builtin_convertvector(words, byte_lanes);
    memcpy(to, &bytes, sizeof bytes);
}

/* --- halves ----------------------------------------------------------------------------------- */

GP_INLINE itg held_half(itg half)
{
    const msk odd = (msk)((half & 0x7fff) > 0x7c00) & (msk)(half != 0x7e00);
    return itg_select(odd, itg_set(ODD_NAN), float_from_half(half));
}

/* Two channels in a word, and which bits of the texel's stay instead. */
typedef struct Halves {
    itg word, kept;
} Halves;

GP_INLINE Halves halves_of(const float *low, const float *high)
{
    const itg a = load_words(low), b = load_words(high);
    return (Halves){ half_from_float(a) | half_from_float(b) << 16,
                     ((itg)(a == ODD_NAN) & 0xffff) | (itg)(b == ODD_NAN) << 16 };
}

GP_INLINE itg over_texel(Halves halves, itg stored)
{
    return (halves.word & ~halves.kept) | (stored & halves.kept);
}

/* --- GP_LANES texels -------------------------------------------------------------------------- */

GP_INLINE void load_color(GpFormat format, const uint8_t *texel, FastPlanes *planes, uint32_t at)
{
    float *const channel[4] = { planes->channel[0] + at, planes->channel[1] + at,
                                planes->channel[2] + at, planes->channel[3] + at };
    itg v[4];
    switch (format) {
    case GP_A8R8G8B8:
    case GP_X8R8G8B8:
        store_words(planes->packed + at, load_words(texel));
        break;
    case GP_R8:
        flt_store(channel[0], flt_from_unorm8(itg_load_bytes(texel)));
        break;
    case GP_G16R16F:
        v[0] = load_words(texel);
        store_words(channel[0], held_half(v[0] & 0xffff));
        store_words(channel[1], held_half((itg)((utg)v[0] >> 16)));
        break;
    case GP_A16B16G16R16F:
        v[0] = load_words(texel);
        v[1] = load_words(texel + sizeof(itg));
        v[2] = itg_evens(v[0], v[1]);
        v[3] = itg_odds(v[0], v[1]);
        store_words(channel[0], held_half(v[2] & 0xffff));
        store_words(channel[1], held_half((itg)((utg)v[2] >> 16)));
        store_words(channel[2], held_half(v[3] & 0xffff));
        store_words(channel[3], held_half((itg)((utg)v[3] >> 16)));
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

GP_INLINE void load_depth(GpFormat format, const uint8_t *texel, FastDepthPlanes *planes,
                          uint32_t at)
{
    itg code = format == GP_D16 ? load_halves(texel) : load_words(texel);
    if (format == GP_D24S8)
        store_bytes(planes->stencil + at, code & 255);
    store_words(planes->depth + at, format == GP_D24S8 ? (itg)((utg)code >> 8) : code);
}

GP_INLINE void store_color(GpFormat format, uint8_t *texel, const FastPlanes *planes, uint32_t at,
                           bool non_temporal)
{
    const float *const channel[4] = { planes->channel[0] + at, planes->channel[1] + at,
                                      planes->channel[2] + at, planes->channel[3] + at };
    Halves rg, ba;
    itg v[4];
    switch (format) {
    case GP_A8R8G8B8:
    case GP_X8R8G8B8:
        put_words(texel, load_words(planes->packed + at), non_temporal);
        break;
    case GP_R8: /* nearest: the float is within 2^-24 of code / 255 */
        store_bytes(texel, itg_from_flt(flt_load(channel[0]) * 255.0f + 0.5f));
        break;
    case GP_G16R16F:
        rg = halves_of(channel[0], channel[1]);
        put_words(texel, over_texel(rg, load_words(texel)), non_temporal);
        break;
    case GP_A16B16G16R16F:
        rg = halves_of(channel[0], channel[1]);
        ba = halves_of(channel[2], channel[3]);
        if (msk_any((msk)((rg.kept | ba.kept) != 0))) {
            v[0] = load_words(texel);
            v[1] = load_words(texel + sizeof(itg));
            rg.word = over_texel(rg, itg_evens(v[0], v[1]));
            ba.word = over_texel(ba, itg_odds(v[0], v[1]));
        }
        put_words(texel, itg_zip_low(rg.word, ba.word), non_temporal);
        put_words(texel + sizeof(itg), itg_zip_high(rg.word, ba.word), non_temporal);
        break;
    case GP_R32F:
        put_words(texel, load_words(channel[0]), non_temporal);
        break;
    default: /* GP_A32B32G32R32F */
        GP_UNROLL
        for (int c = 0; c < 4; c++)
            v[c] = load_words(channel[c]);
        GP_UNROLL
        for (int half = 0; half < 2; half++) {
            itg low = half ? itg_zip_high(v[0], v[2]) : itg_zip_low(v[0], v[2]);
            itg high = half ? itg_zip_high(v[1], v[3]) : itg_zip_low(v[1], v[3]);
            uint8_t *to = texel + (size_t)(2 * half) * sizeof(itg);
            put_words(to, itg_zip_low(low, high), non_temporal);
            put_words(to + sizeof(itg), itg_zip_high(low, high), non_temporal);
        }
    }
}

GP_INLINE void store_depth(GpFormat format, uint8_t *texel, const FastDepthPlanes *planes,
                           uint32_t at, bool non_temporal)
{
    itg code = load_words(planes->depth + at);
    if (format == GP_D24S8)
        code = code << 8 | itg_load_bytes(planes->stencil + at);
    if (format == GP_D16)
        store_halves(texel, code);
    else
        put_words(texel, code, non_temporal);
}

/* --- the rows of a tile ----------------------------------------------------------------------- */

/* The tile's part of a surface. */
typedef struct Rows {
    uint8_t *texels;
    size_t pitch, bytes; /* from row to row, of a texel */
    int32_t width, height;
    bool non_temporal; /* stores go past the caches */
} Rows;

static Rows rows_of(const Tile *tile, const GpSurface *surface)
{
    const GpLevel *level = &surface->level[0];
    Rows rows = { .pitch = level->pitch, .width = tile->width, .height = tile->height };
    rows.bytes = gp_format_info(surface->format)->bytes;
    rows.texels = gp_surface_texel(level, rows.bytes, (uint32_t)tile->x0, (uint32_t)tile->y0);
    rows.non_temporal = fast_is_past_caches(surface) &&
                        ((uintptr_t)level->texels | level->pitch) % sizeof(itg) == 0;
    return rows;
}

GP_INLINE void load_texels(GpFormat format, const uint8_t *texel, void *planes, uint32_t at)
{
    if (format == GP_D16 || format == GP_D24S8 || format == GP_D32F)
        load_depth(format, texel, planes, at);
    else
        load_color(format, texel, planes, at);
}

GP_INLINE void store_texels(GpFormat format, uint8_t *texel, const void *planes, uint32_t at,
                            bool non_temporal)
{
    if (format == GP_D16 || format == GP_D24S8 || format == GP_D32F)
        store_depth(format, texel, planes, at, non_temporal);
    else
        store_color(format, texel, planes, at, non_temporal);
}

/* What is left of a row goes by way of a buffer that is wide enough for all lanes. */

void fast_load_tile(const Tile *tile, const GpSurface *surface, void *planes)
{
    const Rows rows = rows_of(tile, surface);
    const int32_t whole = rows.width / GP_LANES * GP_LANES;
    const size_t rest = (size_t)(rows.width - whole) * rows.bytes;
    uint8_t buffer[GP_LANES * LARGEST_TEXEL] = { 0 };
    for (int32_t y = 0; y < rows.height; y++) {
        const uint8_t *from = rows.texels + (size_t)y * rows.pitch;
        for (int32_t x = 0; x < whole; x += GP_LANES, from += GP_LANES * rows.bytes)
            load_texels(surface->format, from, planes, fast_at(x, y));
        if (!rest)
            continue;
        memcpy(buffer, from, rest);
        load_texels(surface->format, buffer, planes, fast_at(whole, y));
    }
}

void fast_store_tile(const Tile *tile, const GpSurface *surface, const void *planes)
{
    const Rows rows = rows_of(tile, surface);
    const int32_t whole = rows.width / GP_LANES * GP_LANES;
    const size_t rest = (size_t)(rows.width - whole) * rows.bytes;
    uint8_t buffer[GP_LANES * LARGEST_TEXEL] = { 0 };
    for (int32_t y = 0; y < rows.height; y++) {
        uint8_t *to = rows.texels + (size_t)y * rows.pitch;
        for (int32_t x = 0; x < whole; x += GP_LANES, to += GP_LANES * rows.bytes)
            store_texels(surface->format, to, planes, fast_at(x, y), rows.non_temporal);
        if (!rest)
            continue;
        memcpy(buffer, to, rest);
        store_texels(surface->format, buffer, planes, fast_at(whole, y), false);
        memcpy(to, buffer, rest);
    }
    if (rows.non_temporal)
        lanes_stream_end();
}
