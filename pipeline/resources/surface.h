/* Surfaces: memory that passes render to and shaders read from. */
#ifndef GP_SURFACE_H
#define GP_SURFACE_H

#include "pipeline/resources/format.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    GP_MAX_SIZE = 8192, /* texels a side; the guard band allows no more with sub-pixel exactness */
    GP_MAX_LEVELS = 14, /* mip levels of an 8192 texture */
};

typedef struct GpSurfaceDesc {
    GpFormat format;
    uint32_t width, height; /* texels of level 0, 1..GP_MAX_SIZE */
    uint32_t levels;        /* mip levels; 0 means 1; GP_MAX_LEVELS or more means down to 1x1;
                               any other number that goes beyond 1x1 is an error */
    const char *name;       /* for messages and dumps; copied, at most 31 characters kept */
} GpSurfaceDesc;

typedef struct GpLevel {
    uint8_t *texels; /* row 0 at the top, rows without padding */
    uint32_t width, height;
    size_t pitch; /* bytes from one row to the next */
} GpLevel;

/* A surface owns its texels; the struct may be read by anyone, and texels may be written by the
 * caller while no list that uses the surface runs. */
typedef struct GpSurface {
    char name[32];
    GpFormat format;
    uint32_t width, height, levels;
    GpLevel level[GP_MAX_LEVELS];
} GpSurface;

/* Creates a zeroed surface. Errors: GP_ERROR_INVALID (format, size, levels), GP_ERROR_MEMORY.
 * A level is half the size of the one before, rounded down, and at least 1.
 * Owns: the caller, until gp_surface_destroy. */
GpResult gp_surface_create(const GpSurfaceDesc *desc, GpSurface **surface, GpError *error);

/* Destroys *surface and sets it to NULL; NULL-safe. */
void gp_surface_destroy(GpSurface **surface);

/* Address of a texel; x, y inside the level. */
static inline uint8_t *gp_surface_texel(const GpLevel *level, size_t texel_bytes, uint32_t x,
                                        uint32_t y)
{
    return level->texels + (size_t)y * level->pitch + (size_t)x * texel_bytes;
}

/* Fills level 0 with a colour (colour formats) or a depth, clamped to [0,1], and stencil (depth
 * formats); what is not cleared keeps its bits. */
void gp_surface_clear_color(GpSurface *surface, const float rgba[4]);
void gp_surface_clear_depth(GpSurface *surface, float depth, uint8_t stencil, bool clear_depth,
                            bool clear_stencil);

/* Computes each level from the stored one before by a 2x2 box (sRGB formats: in linear light):
 * the mean ((a + b) + (c + d)) / 4 of two neighbours above and two below, in binary64, where it
 * cannot overflow. A side of one texel counts it twice; the last row or column of any other odd
 * side is dropped. Colour formats only. */
void gp_surface_build_mips(GpSurface *surface);

/* XXH3-64 of level 0's raw bytes, row 0 at the top: what `hash` lines print. */
uint64_t gp_surface_hash(const GpSurface *surface);

#ifdef __cplusplus
}
#endif

#endif
