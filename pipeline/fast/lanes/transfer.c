/* A tile's targets: cleared or loaded before the first draw, stored after the last. */
#include "pipeline/fast/lanes/tile.h"

#include <string.h>

static uint8_t *texel_at(const Tile *tile, const GpSurface *surface, int32_t x, int32_t y)
{
    return gp_surface_texel(&surface->level[0], gp_format_info(surface->format)->bytes,
                            (uint32_t)(tile->x0 + x), (uint32_t)(tile->y0 + y));
}

static void fill_words(uint32_t *plane, uint32_t word)
{
    for (int i = 0; i < FAST_TILE * FAST_PITCH; i++)
        plane[i] = word;
}

static void load_color(Tile *tile, int target)
{
    const GpColorTarget *color = &tile->pass->pass->color[target];
    const GpFormat format = color->surface->format;
    FastPlanes *planes = &tile->planes[target];
    const size_t row_bytes = (size_t)tile->width * 4;
    float rgba[4];
    if (color->clear) {
        uint8_t cleared[16] = { 0 };
        uint32_t word;
        gp_texel_store(format, cleared, color->clear_color, 0);
        gp_texel_load(format, cleared, rgba);
        memcpy(&word, cleared, sizeof word);
        if (format == GP_A8R8G8B8)
            fill_words(planes->packed, word);
        for (int c = 0; format != GP_A8R8G8B8 && c < gp_format_info(format)->channels; c++)
            fill_words((uint32_t *)(void *)planes->channel[c], gp_float_bits(rgba[c]));
        return;
    }
    for (int32_t y = 0; y < tile->height; y++) {
        if (format == GP_A8R8G8B8) {
            memcpy(planes->packed + fast_at(0, y), texel_at(tile, color->surface, 0, y), row_bytes);
            continue;
        }
        for (int32_t x = 0; x < tile->width; x++) {
            gp_texel_load(format, texel_at(tile, color->surface, x, y), rgba);
            for (int c = 0; c < 4; c++)
                planes->channel[c][fast_at(x, y)] = rgba[c];
        }
    }
}

static void load_depth(Tile *tile)
{
    const GpDepthTarget *depth = &tile->pass->pass->depth;
    const GpFormat format = depth->surface->format;
    bool kept =
        !depth->clear_depth || (gp_format_info(format)->has_stencil && !depth->clear_stencil);
    for (int32_t y = 0; kept && y < tile->height; y++)
        for (int32_t x = 0; x < tile->width; x++)
            gp_depth_load(format, texel_at(tile, depth->surface, x, y), &tile->depth[fast_at(x, y)],
                          &tile->stencil[fast_at(x, y)]);
    if (depth->clear_depth)
        fill_words(tile->depth, gp_depth_code(format, depth->depth_value));
    if (depth->clear_stencil)
        memset(tile->stencil, depth->stencil_value, sizeof tile->stencil);
}

void FAST(load_tile)(Tile *tile)
{
    for (int t = 0; t < tile->targets; t++)
        load_color(tile, t);
    if (tile->depth_format)
        load_depth(tile);
}

/* Rows of four-channel floats: planes to texels. */
static void store_floats(const Tile *tile, const GpSurface *surface, const FastPlanes *planes)
{
    for (int32_t y = 0; y < tile->height; y++) {
        float *to = (float *)(void *)texel_at(tile, surface, 0, y);
        uint32_t at = fast_at(0, y);
        for (int32_t x = 0; x < tile->width; x++)
            for (uint32_t c = 0; c < 4; c++)
                to[4 * x + (int32_t)c] = gp_canonical(planes->channel[c][at + (uint32_t)x]);
    }
}

static void store_color(const Tile *tile, const GpSurface *surface, const FastPlanes *planes)
{
    if (surface->format == GP_A32B32G32R32F) {
        store_floats(tile, surface, planes);
        return;
    }
    for (int32_t y = 0; y < tile->height; y++) {
        if (surface->format == GP_A8R8G8B8) {
            memcpy(texel_at(tile, surface, 0, y), planes->packed + fast_at(0, y),
                   (size_t)tile->width * 4);
            continue;
        }
        for (int32_t x = 0; x < tile->width; x++) {
            float rgba[4];
            for (int c = 0; c < 4; c++)
                rgba[c] = planes->channel[c][fast_at(x, y)];
            gp_texel_store(surface->format, texel_at(tile, surface, x, y), rgba, 0);
        }
    }
}

static void store_depth(const Tile *tile, const GpSurface *surface)
{
    for (int32_t y = 0; y < tile->height; y++) {
        const uint32_t *depth = tile->depth + fast_at(0, y);
        const uint8_t *stencil = tile->stencil + fast_at(0, y);
        uint8_t *to = texel_at(tile, surface, 0, y);
        if (tile->depth_format == GP_D32F)
            memcpy(to, depth, (size_t)tile->width * 4);
        else if (tile->depth_format == GP_D24S8)
            for (int32_t x = 0; x < tile->width; x++)
                ((uint32_t *)(void *)to)[x] = depth[x] << 8 | stencil[x];
        else
            for (int32_t x = 0; x < tile->width; x++)
                ((uint16_t *)(void *)to)[x] = (uint16_t)depth[x];
    }
}

void FAST(store_tile)(const Tile *tile)
{
    const GpPass *pass = tile->pass->pass;
    for (int t = 0; t < tile->targets; t++)
        store_color(tile, pass->color[t].surface, &tile->planes[t]);
    if (tile->depth_format)
        store_depth(tile, pass->depth.surface);
}

/* Repeats the texel at the start of a row along it. */
static void fill_row(uint8_t *row, const uint8_t *texel, size_t bytes, int32_t count)
{
    for (int32_t x = 0; x < count; x++)
        memcpy(row + (size_t)x * bytes, texel, bytes);
}

void FAST(clear_untouched)(const Tile *tile)
{
    const GpPass *pass = tile->pass->pass;
    uint8_t texel[16];
    for (int t = 0; t < tile->targets; t++) {
        const GpSurface *surface = pass->color[t].surface;
        const size_t bytes = gp_format_info(surface->format)->bytes;
        if (!pass->color[t].clear)
            continue;
        gp_texel_store(surface->format, texel, pass->color[t].clear_color, 0);
        fill_row(texel_at(tile, surface, 0, 0), texel, bytes, tile->width);
        for (int32_t y = 1; y < tile->height; y++)
            memcpy(texel_at(tile, surface, 0, y), texel_at(tile, surface, 0, 0),
                   bytes * (size_t)tile->width);
    }
    const GpDepthTarget *depth = &pass->depth;
    if (!depth->surface || !(depth->clear_depth || depth->clear_stencil))
        return;
    const size_t bytes = gp_format_info(tile->depth_format)->bytes;
    for (int32_t y = 0; y < tile->height; y++)
        for (int32_t x = 0; x < tile->width; x++) {
            uint8_t *at = texel_at(tile, depth->surface, x, y);
            uint32_t code;
            uint8_t stencil;
            if (y && depth->clear_depth &&
                (depth->clear_stencil || tile->depth_format != GP_D24S8)) {
                memcpy(at, texel_at(tile, depth->surface, 0, 0), bytes * (size_t)tile->width);
                break;
            }
            gp_depth_load(tile->depth_format, at, &code, &stencil);
            if (depth->clear_depth)
                code = gp_depth_code(tile->depth_format, depth->depth_value);
            if (depth->clear_stencil)
                stencil = depth->stencil_value;
            gp_depth_store(tile->depth_format, at, code, stencil);
        }
}
