/* Surfaces of tests, and their texels. */
#ifndef TESTS_TEXELS_H
#define TESTS_TEXELS_H

#include "pipeline/resources/surface.h"
#include "tests/support/unit.h"

static inline GpSurface *make(GpFormat format, uint32_t width, uint32_t height, uint32_t levels)
{
    GpSurface *surface = NULL;
    GpSurfaceDesc desc = {
        .format = format, .width = width, .height = height, .levels = levels, .name = "test"
    };
    GpError error;
    assert_int_equal(gp_surface_create(&desc, &surface, &error), GP_OK);
    assert_non_null(surface);
    return surface;
}

static inline uint8_t *texel_at(const GpSurface *surface, uint32_t level, uint32_t x, uint32_t y)
{
    return gp_surface_texel(&surface->level[level], gp_format_info(surface->format)->bytes, x, y);
}

static inline void load(const GpSurface *surface, uint32_t level, uint32_t x, uint32_t y,
                        float rgba[4])
{
    gp_texel_load(surface->format, texel_at(surface, level, x, y), rgba);
}

#endif
