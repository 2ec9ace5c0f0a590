/* Surfaces: their memory, clears, mip levels and hashes. */
#include "pipeline/resources/surface.h"

#include <stdio.h>
#include <string.h>
#include <xxhash.h>

/* --- life ------------------------------------------------------------------------------------- */

/* Levels from the given size down to 1x1. */
static uint32_t full_chain(uint32_t width, uint32_t height)
{
    uint32_t longer = width > height ? width : height;
    uint32_t levels = 1;
    for (; longer > 1; longer /= 2)
        levels++;
    return levels;
}

static GpResult check(const GpSurfaceDesc *desc, GpError *error)
{
    if (desc->format <= GP_FORMAT_NONE || desc->format >= GP_FORMATS)
        return gp_fail(error, GP_ERROR_INVALID, "surface: %d is no format", (int)desc->format);
    if (desc->width < 1 || desc->width > GP_MAX_SIZE || desc->height < 1 ||
        desc->height > GP_MAX_SIZE)
        return gp_fail(error, GP_ERROR_INVALID, "surface: size %ux%u is not within 1..%d",
                       desc->width, desc->height, GP_MAX_SIZE);
    uint32_t most = full_chain(desc->width, desc->height);
    if (desc->levels > most && desc->levels < GP_MAX_LEVELS)
        return gp_fail(error, GP_ERROR_INVALID, "surface: %ux%u has %u levels, not %u", desc->width,
                       desc->height, most, desc->levels);
    return GP_OK;
}

GpResult gp_surface_create(const GpSurfaceDesc *desc, GpSurface **surface, GpError *error)
{
    GpResult result = check(desc, error);
    if (result)
        return result;

    GpSurface *s = gp_alloc(1, sizeof *s);
    if (!s)
        return gp_fail(error, GP_ERROR_MEMORY, "surface: no memory");
    snprintf(s->name, sizeof s->name, "%s", desc->name ? desc->name : "");
    s->format = desc->format;
    s->width = desc->width;
    s->height = desc->height;
    uint32_t most = full_chain(desc->width, desc->height);
    s->levels = desc->levels == 0 ? 1 : desc->levels < most ? desc->levels : most;

    /* One allocation a level: an address beyond a level's end is then an error that sanitizers see,
     * not a texel of the next. */
    for (uint32_t i = 0; i < s->levels; i++) {
        GpLevel *level = &s->level[i];
        level->width = s->width >> i > 0 ? s->width >> i : 1;
        level->height = s->height >> i > 0 ? s->height >> i : 1;
        level->pitch = (size_t)level->width * gp_format_info(s->format)->bytes;
        level->texels = gp_alloc(level->height, level->pitch);
        if (!level->texels) {
            gp_surface_destroy(&s);
            return gp_fail(error, GP_ERROR_MEMORY, "surface: no memory for %ux%u %s", desc->width,
                           desc->height, gp_format_info(desc->format)->name);
        }
    }
    *surface = s;
    return GP_OK;
}

void gp_surface_destroy(GpSurface **surface)
{
    if (!surface || !*surface)
        return;
    for (uint32_t i = 0; i < (*surface)->levels; i++)
        gp_free((*surface)->level[i].texels);
    gp_free(*surface);
    *surface = NULL;
}

/* --- content ---------------------------------------------------------------------------------- */

void gp_surface_clear_color(GpSurface *surface, const float rgba[4])
{
    const size_t bytes = gp_format_info(surface->format)->bytes;
    const GpLevel *level = &surface->level[0];
    uint8_t texel[16];

    gp_texel_store(surface->format, texel, rgba, 0);
    for (uint32_t y = 0; y < level->height; y++)
        for (uint32_t x = 0; x < level->width; x++)
            memcpy(gp_surface_texel(level, bytes, x, y), texel, bytes);
}

void gp_surface_clear_depth(GpSurface *surface, float depth, uint8_t stencil, bool clear_depth,
                            bool clear_stencil)
{
    const GpFormat format = surface->format;
    const size_t bytes = gp_format_info(format)->bytes;
    const GpLevel *level = &surface->level[0];
    const uint32_t code = gp_depth_code(format, depth < 0.0f ? 0.0f : depth > 1.0f ? 1.0f : depth);

    for (uint32_t y = 0; y < level->height; y++) {
        for (uint32_t x = 0; x < level->width; x++) {
            uint8_t *texel = gp_surface_texel(level, bytes, x, y);
            uint32_t old_code;
            uint8_t old_stencil;
            gp_depth_load(format, texel, &old_code, &old_stencil);
            gp_depth_store(format, texel, clear_depth ? code : old_code,
                           clear_stencil ? stencil : old_stencil);
        }
    }
}

/* Writes a level as the 2x2 means of the one before. */
static void build_level(GpFormat format, const GpLevel *fine, const GpLevel *coarse)
{
    const size_t bytes = gp_format_info(format)->bytes;
    for (uint32_t y = 0; y < coarse->height; y++) {
        for (uint32_t x = 0; x < coarse->width; x++) {
            uint32_t x0 = 2 * x, x1 = fine->width > 1 ? x0 + 1 : x0;
            uint32_t y0 = 2 * y, y1 = fine->height > 1 ? y0 + 1 : y0;
            float a[4], b[4], c[4], d[4], mean[4];
            gp_texel_load(format, gp_surface_texel(fine, bytes, x0, y0), a);
            gp_texel_load(format, gp_surface_texel(fine, bytes, x1, y0), b);
            gp_texel_load(format, gp_surface_texel(fine, bytes, x0, y1), c);
            gp_texel_load(format, gp_surface_texel(fine, bytes, x1, y1), d);
            for (int i = 0; i < 4; i++)
                mean[i] =
                    (float)(0.25 * (((double)a[i] + (double)b[i]) + ((double)c[i] + (double)d[i])));
            gp_texel_store(format, gp_surface_texel(coarse, bytes, x, y), mean, 0);
        }
    }
}

void gp_surface_build_mips(GpSurface *surface)
{
    for (uint32_t i = 1; i < surface->levels; i++)
        build_level(surface->format, &surface->level[i - 1], &surface->level[i]);
}

uint64_t gp_surface_hash(const GpSurface *surface)
{
    const GpLevel *level = &surface->level[0];
    return XXH3_64bits(level->texels, level->height * level->pitch);
}
