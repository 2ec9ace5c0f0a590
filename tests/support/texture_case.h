/* Small textures for tests: made, filled texel by texel, sampled. */
#ifndef TESTS_TEXTURE_CASE_H
#define TESTS_TEXTURE_CASE_H

#include "pipeline/units/texture.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#define assert_float_bits(a, b) assert_int_equal(gp_float_bits(a), gp_float_bits(b))

static inline GpSurface *make(GpFormat format, uint32_t width, uint32_t height, uint32_t levels)
{
    GpSurface *surface = NULL;
    GpSurfaceDesc desc = { .format = format, .width = width, .height = height, .levels = levels };
    assert_int_equal(gp_surface_create(&desc, &surface, NULL), GP_OK);
    return surface;
}

static inline uint8_t *texel_at(const GpSurface *s, uint32_t level, uint32_t x, uint32_t y)
{
    return gp_surface_texel(&s->level[level], gp_format_info(s->format)->bytes, x, y);
}

static inline void put(const GpSurface *s, uint32_t level, uint32_t x, uint32_t y,
                       const float rgba[4])
{
    if (gp_format_info(s->format)->is_depth)
        gp_depth_store(s->format, texel_at(s, level, x, y), gp_depth_code(s->format, rgba[0]), 99);
    else
        gp_texel_store(s->format, texel_at(s, level, x, y), rgba, 0);
}

static inline GpTexture linear(const GpSurface *surface, GpAddress address)
{
    return (GpTexture){ .surface = surface,
                        .sampler = { .min = GP_LINEAR,
                                     .mag = GP_LINEAR,
                                     .address_u = address,
                                     .address_v = address } };
}

static inline void sample(const GpTexture *texture, float u, float v, float lod, float rgba[4])
{
    const float uvr[3] = { u, v, 0 };
    gp_texture_sample(texture, uvr, lod, rgba, NULL);
}

/* Texel values of every size a format can hold, from tiny to huge, and of both signs. */
static inline float wild_value(GpFormat format, Random *seed)
{
    uint32_t bits = random_word(seed);
    if (!gp_format_info(format)->is_float)
        return (float)(bits >> 8) * 0x1p-24f;
    if (gp_format_info(format)->bytes / gp_format_info(format)->channels == 2)
        return gp_float_from_half((uint16_t)(bits % 0x7c00u | (bits & 0x80000000u) >> 16));
    return gp_bits_float(bits % 0x7f800000u | (random_word(seed) & 0x80000000u));
}

static inline GpSurface *make_random(GpFormat format, uint32_t size, Random seed)
{
    GpSurface *s = make(format, size, size, 1);
    for (uint32_t t = 0; t < size * size; t++) {
        float color[4];
        for (int c = 0; c < 4; c++)
            color[c] = wild_value(format, &seed);
        put(s, 0, t % size, t / size, color);
    }
    return s;
}

#endif
