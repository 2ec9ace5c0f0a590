/* Surfaces: memory that passes render to and shaders read from. */
#ifndef GP_SURFACE_H
#define GP_SURFACE_H

#include "pipeline/resources/format.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    GP_MAX_SIZE =
        8192, /* texels a side: binary32 has places up to here in steps of 2^-11 or less */
    GP_MAX_LEVELS = 14,   /* mip levels of an 8192 texture */
    GP_MAX_WHOLE = 32768, /* pixels a side of what a window is cut from */
    GP_WINDOW_STEP = 128, /* pixels: a window begins and ends at multiples of it */
};

/* Pixels [x0, x1) x [y0, y1), y down, as Direct3D's D3DRECT; none where an end is not beyond its
 * beginning. */
typedef struct GpRect {
    int32_t x0, y0, x1, y1;
} GpRect;

/* What two rectangles have in common; it may be empty. */
GpRect gp_rect_common(GpRect a, GpRect b);

/* Whether they begin and end alike. */
static inline bool gp_rect_equal(GpRect a, GpRect b)
{
    return a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1;
}

/* Whether it has no pixel. */
static inline bool gp_rect_is_empty(GpRect rect)
{
    return rect.x1 <= rect.x0 || rect.y1 <= rect.y0;
}

/* A surface to be made. */
typedef struct GpSurfaceDesc {
    GpFormat format;
    uint32_t width, height; /* texels of level 0, 1..GP_MAX_SIZE */
    /* mip levels; 0 means 1; GP_MAX_LEVELS or more means down to 1x1; any other number that goes
     * beyond 1x1 is an error */
    uint32_t levels;
    const char *name; /* for messages and dumps; copied, at most 31 characters kept */

    /* Texels in memory of the caller's, who keeps it until the surface is destroyed; what it holds
     * is the surface's content. NULL: the surface's own. One level; any alignment, though multiples
     * of 64 for both are quickest; in all at most 2^31 - 1 bytes. Bytes between the rows are left
     * alone. */
    void *memory;
    size_t pitch; /* bytes from one row to the next, at least a row's; 0: rows without padding */

    /* The part of it that has texels, of its own and of one level: for targets of pictures that are
     * drawn part by part. All is as if the whole were there, of up to GP_MAX_WHOLE texels a side,
     * but that nothing is drawn elsewhere, and that shaders read it only in place (gp_load_local).
     * Sides are those of the whole, or multiples of GP_WINDOW_STEP. All zero: the whole. */
    GpRect window;
} GpSurfaceDesc;

/* One level of a surface. */
typedef struct GpLevel {
    uint8_t *texels; /* row 0 at the top; of a window where texel (0, 0) would be */
    uint32_t width, height;
    size_t pitch; /* bytes from one row to the next; without padding where the surface owns them */
} GpLevel;

/* A surface owns its texels, or borrows them; the struct may be read by anyone, and texels may be
 * written by the caller while no list that uses the surface runs. */
typedef struct GpSurface {
    char name[32];
    GpFormat format;
    uint32_t width, height, levels;
    GpLevel level[GP_MAX_LEVELS];
    bool borrowed; /* texels are the caller's */
    GpRect window; /* texels that there are of level 0 */
} GpSurface;

/* Whether it has all its texels. */
static inline bool gp_surface_is_whole(const GpSurface *surface)
{
    const GpRect *window = &surface->window;
    return window->x0 == 0 && window->y0 == 0 && window->x1 == (int32_t)surface->width &&
           window->y1 == (int32_t)surface->height;
}

/* Creates a surface, zeroed, or over memory that is there. Errors: GP_ERROR_INVALID (format, size,
 * levels, pitch, window), GP_ERROR_MEMORY.
 * A level is half the size of the one before, rounded down, and at least 1.
 * Owns: the caller, until gp_surface_destroy. */
GpResult gp_surface_create(const GpSurfaceDesc *desc, GpSurface **surface, GpError *error);

/* Destroys *surface and sets it to NULL; NULL-safe. */
void gp_surface_destroy(GpSurface **surface);

/* Gives a surface that has a window all its texels, zeroed. Errors: GP_ERROR_INVALID (larger than
 * GP_MAX_SIZE), GP_ERROR_MEMORY; the surface is then as it was. */
GpResult gp_surface_make_whole(GpSurface *surface, GpError *error);

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

/* The same inside a rectangle, which is cut to the surface. */
void gp_surface_clear_color_rect(GpSurface *surface, GpRect rect, const float rgba[4]);
void gp_surface_clear_depth_rect(GpSurface *surface, GpRect rect, float depth, uint8_t stencil,
                                 bool clear_depth, bool clear_stencil);

/* Reads texels as floats.
 * in   rect: NULL, the whole level, or its window
 * out  rgba: [y][x][4], row 0 at the top: r g b a as gp_texel_load has them
 * errors GP_ERROR_INVALID: no such level, a rectangle that is not inside it */
GpResult gp_surface_read_floats(const GpSurface *surface, uint32_t level, const GpRect *rect,
                                float *rgba, GpError *error);

/* Reads texels as they are stored (CONVENTIONS.md, "Surfaces in memory").
 * out  bytes: rows of texels without gaps, `pitch` bytes from row to row (0: without padding)
 * errors as gp_surface_read_floats; a pitch less than a row */
GpResult gp_surface_read_bytes(const GpSurface *surface, uint32_t level, const GpRect *rect,
                               void *bytes, size_t pitch, GpError *error);

/* Whether texels of one are texels of the other: they are the same, or borrow the same memory.
 * Where pitches differ, memory between their rows counts as theirs. */
bool gp_surfaces_share(const GpSurface *a, const GpSurface *b);

/* Computes each level from the stored one before by a 2x2 box (sRGB formats: in linear light):
 * the mean ((a + b) + (c + d)) / 4 of two neighbours above and two below, in binary64, where it
 * cannot overflow. A side of one texel counts it twice; the last row or column of any other odd
 * side is dropped. Colour formats only. */
void gp_surface_build_mips(GpSurface *surface);

/* XXH3-64 of level 0's texels as stored, row 0 at the top, without what may lie between rows: what
 * `hash` lines print. Of a window its texels alone. */
uint64_t gp_surface_hash(const GpSurface *surface);

#ifdef __cplusplus
}
#endif

#endif
