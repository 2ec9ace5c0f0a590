/* Slots: the targets of a group inside a tile. Each is loaded or cleared when a pass first needs
 * it, read and drawn to by any number of passes, and stored once, after the last. */
#include "pipeline/fast/lanes/memory/slots.h"

#include <string.h>

static void fill_words(uint32_t *plane, int32_t height, uint32_t word)
{
    for (int32_t y = 0; y < height; y++, plane += FAST_PITCH)
        for (int32_t x = 0; x < FAST_TILE; x++)
            plane[x] = word;
}

/* --- colour ----------------------------------------------------------------------------------- */

/* Only notes the colour: it may be all that anyone wants to know. */
static void clear_color(Tile *tile, int slot, const float color[4])
{
    const GpFormat format = tile->slots->surfaces->color[slot]->format;
    uint8_t texel[16];
    gp_texel_store(format, texel, color, 0);
    gp_texel_load(format, texel, tile->slots->color[slot].value);
    tile->slots->color[slot].held = tile->slots->color[slot].cleared = true;
}

static void spell_out(Tile *tile, int slot)
{
    const GpFormat format = tile->slots->surfaces->color[slot]->format;
    const float *color = tile->slots->color[slot].value;
    FastPlanes *planes = &tile->slots->color_planes[slot];
    uint32_t word;
    if (format == GP_A8R8G8B8) {
        gp_texel_store(format, &word, color, 0);
        fill_words(planes->packed, tile->height, word);
        return;
    }
    for (int c = 0; c < gp_format_info(format)->channels; c++)
        fill_words((uint32_t *)(void *)planes->channel[c], tile->height, gp_float_bits(color[c]));
}

/* Makes the planes hold the content. */
void fast_hold_color(Tile *tile, int slot)
{
    if (tile->slots->color[slot].cleared)
        spell_out(tile, slot);
    else if (!tile->slots->color[slot].held)
        fast_load_tile(tile, tile->slots->surfaces->color[slot], &tile->slots->color_planes[slot]);
    tile->slots->color[slot].held = true;
    tile->slots->color[slot].cleared = false;
}

static void begin_color(Tile *tile, const FastPass *pass, int target, bool touched)
{
    const GpColorTarget *color = &pass->pass->color[target];
    const int slot = fast_color_slot(tile->slots->surfaces, color->surface);
    const bool clears = pass->clears && color->clear;
    tile->planes[target] = &tile->slots->color_planes[slot];
    if (clears)
        clear_color(tile, slot, color->clear_color);
    if (touched)
        fast_hold_color(tile, slot);
    tile->slots->color[slot].written |= clears || touched;
}

/* --- depth and stencil ------------------------------------------------------------------------ */

void fast_hold_depth(Tile *tile, int slot)
{
    if (!tile->slots->depth[slot].held)
        fast_load_tile(tile, tile->slots->surfaces->depth[slot], &tile->slots->depth_planes[slot]);
    tile->slots->depth[slot].held = true;
}

static void begin_depth(Tile *tile, const FastPass *pass, bool touched)
{
    const GpDepthTarget *depth = &pass->pass->depth;
    const int slot = fast_depth_slot(tile->slots->surfaces, depth->surface);
    FastDepthPlanes *planes = &tile->slots->depth_planes[slot];
    const bool clears_depth = pass->clears && depth->clear_depth;
    const bool clears_stencil = pass->clears && depth->clear_stencil;
    const bool has_stencil = gp_format_info(depth->surface->format)->has_stencil;
    const bool clears_all = clears_depth && (clears_stencil || !has_stencil);
    const bool written = touched || clears_depth || clears_stencil;
    tile->depth = planes->depth;
    tile->stencil = planes->stencil;
    if (clears_all)
        tile->slots->depth[slot].held = true;
    else if (written)
        fast_hold_depth(tile, slot);
    if (clears_depth)
        fill_words(planes->depth, tile->height,
                   gp_depth_code(depth->surface->format, depth->depth_value));
    if (clears_stencil)
        memset(planes->stencil, depth->stencil_value, sizeof planes->stencil);
    tile->slots->depth[slot].written |= written;
}

/* --- the tile --------------------------------------------------------------------------------- */

void fast_begin_slots(Tile *tile, const FastSlots *surfaces)
{
    tile->slots->surfaces = surfaces;
    memset(tile->slots->color, 0, sizeof tile->slots->color);
    memset(tile->slots->depth, 0, sizeof tile->slots->depth);
}

void fast_begin_pass(Tile *tile, const FastPass *pass, bool touched)
{
    tile->pass = pass;
    tile->targets = 0;
    for (int t = 0; t < GP_MAX_TARGETS && pass->pass->color[t].surface; t++) {
        begin_color(tile, pass, t, touched);
        tile->targets++;
    }
    tile->depth_format = GP_FORMAT_NONE;
    if (!pass->pass->depth.surface)
        return;
    tile->depth_format = pass->pass->depth.surface->format;
    begin_depth(tile, pass, touched);
}

static void store_color(Tile *tile, int slot)
{
    fast_hold_color(tile, slot);
    fast_store_tile(tile, tile->slots->surfaces->color[slot], &tile->slots->color_planes[slot]);
}

void fast_store_slots(Tile *tile)
{
    for (int slot = 0; slot < FAST_COLOR_SLOTS; slot++)
        if (tile->slots->color[slot].written)
            store_color(tile, slot);
    for (int slot = 0; slot < FAST_DEPTH_SLOTS; slot++)
        if (tile->slots->depth[slot].written)
            fast_store_tile(tile, tile->slots->surfaces->depth[slot],
                            &tile->slots->depth_planes[slot]);
}
