/* Slots: the targets of a group inside a tile. Each is loaded or cleared when a pass first needs
 * it, read and drawn to by any number of passes, and stored once, after the last. */
#include "pipeline/fast/lanes/memory/slots.h"

#include "pipeline/fast/draws/clear.h"
#include "pipeline/fast/lanes/memory/sums.h"

#include <string.h>

/* --- clears ----------------------------------------------------------------------------------- */

/* What a pass's rectangles leave of a tile that it clears. */
typedef enum ClearedPart { CLEARED_NOWHERE, CLEARED_PARTS, CLEARED_WHOLE } ClearedPart;

/* Rectangle i in pixels of the tile; false where they have none in common. */
static bool clear_part(const Tile *tile, const GpPass *pass, uint32_t i, FastBox *part)
{
    const FastBox box = { tile->x0, tile->y0, tile->x0 + tile->width - 1,
                          tile->y0 + tile->height - 1 };
    *part = fast_clear_part(pass, i, &box);
    part->x0 -= tile->x0;
    part->x1 -= tile->x0;
    part->y0 -= tile->y0;
    part->y1 -= tile->y0;
    return !fast_box_is_empty(part);
}

static ClearedPart cleared_part(const Tile *tile, const GpPass *pass)
{
    ClearedPart cleared = pass->clear_rect_count ? CLEARED_NOWHERE : CLEARED_WHOLE;
    for (uint32_t i = 0; i < pass->clear_rect_count && cleared != CLEARED_WHOLE; i++) {
        FastBox part;
        if (!clear_part(tile, pass, i, &part))
            continue;
        const bool whole =
            part.x1 - part.x0 + 1 == tile->width && part.y1 - part.y0 + 1 == tile->height;
        cleared = whole ? CLEARED_WHOLE : CLEARED_PARTS;
    }
    return cleared;
}

static void fill_words(uint32_t *plane, int32_t height, uint32_t word)
{
    for (int32_t y = 0; y < height; y++, plane += FAST_PITCH)
        for (int32_t x = 0; x < FAST_TILE; x++)
            plane[x] = word;
}

static void fill_part(uint32_t *plane, const FastBox *part, uint32_t word)
{
    for (int32_t y = part->y0; y <= part->y1; y++)
        for (int32_t x = part->x0; x <= part->x1; x++)
            plane[fast_at(x, y)] = word;
}

/* Fills a part of the tile, or all of it where there is none. */
static void fill(const Tile *tile, void *plane, const FastBox *part, uint32_t word)
{
    if (part)
        fill_part(plane, part, word);
    else
        fill_words(plane, tile->height, word);
}

/* --- colour ----------------------------------------------------------------------------------- */

/* What each pixel reads back after a clear. */
static void cleared_value(GpFormat format, const float color[4], float value[4])
{
    uint8_t texel[16];
    gp_texel_store(format, texel, color, 0);
    gp_texel_load(format, texel, value);
}

/* Only notes the colour: it may be all that anyone wants to know. */
static void clear_color(Tile *tile, int slot, const float color[4])
{
    const GpFormat format = tile->slots->surfaces->color[slot]->format;
    cleared_value(format, color, tile->slots->color[slot].value);
    tile->slots->color[slot].held = tile->slots->color[slot].cleared = true;
    tile->slots->color[slot].sums = NULL;
}

/* in   value: as it reads back */
static void spell_out(Tile *tile, int slot, const FastBox *part, const float value[4])
{
    const GpFormat format = tile->slots->surfaces->color[slot]->format;
    FastPlanes *planes = &tile->slots->color_planes[slot];
    uint32_t word;
    if (fast_is_packed(format)) {
        gp_texel_store(format, &word, value, 0);
        fill(tile, planes->packed, part, word);
        return;
    }
    for (int c = 0; c < gp_format_info(format)->channels; c++)
        fill(tile, planes->channel[c], part, gp_float_bits(value[c]));
}

static int channels_of(const Tile *tile, int slot)
{
    return gp_format_info(tile->slots->surfaces->color[slot]->format)->channels;
}

/* Makes the planes hold the content. */
void fast_hold_color(Tile *tile, int slot)
{
    if (tile->slots->color[slot].cleared)
        spell_out(tile, slot, NULL, tile->slots->color[slot].value);
    else if (tile->slots->color[slot].sums)
        fast_sums_to_planes(tile, (const float(*)[4])tile->slots->color[slot].sums,
                            channels_of(tile, slot), &tile->slots->color_planes[slot]);
    else if (!tile->slots->color[slot].held)
        fast_load_tile(tile, tile->slots->surfaces->color[slot], &tile->slots->color_planes[slot]);
    tile->slots->color[slot].held = true;
    tile->slots->color[slot].cleared = false;
    tile->slots->color[slot].sums = NULL;
}

static void hold_sums(Tile *tile, int slot, int target)
{
    float(*const pixel)[4] = tile->sums->pixel[target];
    if (tile->slots->color[slot].sums == pixel)
        return;
    for (int other = 0; other < FAST_COLOR_SLOTS; other++)
        if (tile->slots->color[other].sums == pixel)
            fast_hold_color(tile, other);
    if (tile->slots->color[slot].cleared) {
        fast_fill_sums(tile, tile->slots->color[slot].value, pixel);
        tile->sums->odd[target] = false;
        tile->slots->color[slot].cleared = false;
    } else {
        fast_hold_color(tile, slot);
        tile->sums->odd[target] = fast_planes_to_sums(tile, &tile->slots->color_planes[slot],
                                                      channels_of(tile, slot), pixel);
    }
    tile->slots->color[slot].sums = pixel;
}

void fast_hold_targets(Tile *tile, int count, bool as_sums)
{
    for (int t = 0; t < count; t++) {
        const GpSurface *surface = tile->pass->pass->color[t].surface;
        const int slot = fast_color_slot(tile->slots->surfaces, surface);
        if (as_sums)
            hold_sums(tile, slot, t);
        else
            fast_hold_color(tile, slot);
    }
}

void fast_spell_out_first(Tile *tile, int slot)
{
    const FastBox first = { 0, 0, GP_LANES - 1, 0 };
    spell_out(tile, slot, &first, tile->slots->color[slot].value);
}

static void clear_color_parts(Tile *tile, int slot, const GpPass *pass, const float color[4])
{
    float value[4];
    FastBox part;
    cleared_value(tile->slots->surfaces->color[slot]->format, color, value);
    for (uint32_t i = 0; i < pass->clear_rect_count; i++)
        if (clear_part(tile, pass, i, &part))
            spell_out(tile, slot, &part, value);
}

static void begin_color(Tile *tile, const FastPass *pass, int target, bool touched,
                        ClearedPart cleared)
{
    const GpColorTarget *color = &pass->pass->color[target];
    const int slot = fast_color_slot(tile->slots->surfaces, color->surface);
    if (!color->clear)
        cleared = CLEARED_NOWHERE;
    tile->planes[target] = &tile->slots->color_planes[slot];
    if (cleared == CLEARED_WHOLE)
        clear_color(tile, slot, color->clear_color);
    if (cleared == CLEARED_PARTS) {
        fast_hold_color(tile, slot);
        clear_color_parts(tile, slot, pass->pass, color->clear_color);
    }
    tile->slots->color[slot].written |= cleared != CLEARED_NOWHERE || touched;
}

/* --- depth and stencil ------------------------------------------------------------------------ */

void fast_hold_depth(Tile *tile, int slot)
{
    if (!tile->slots->depth[slot].held)
        fast_load_tile(tile, tile->slots->surfaces->depth[slot], &tile->slots->depth_planes[slot]);
    tile->slots->depth[slot].held = true;
}

/* Fills depth, stencil or both, of a part of the tile or, where there is none, of all of it. */
static void clear_depth(Tile *tile, const GpDepthTarget *depth, const FastBox *part)
{
    if (depth->clear_depth)
        fill(tile, tile->depth, part, gp_depth_code(depth->surface->format, depth->depth_value));
    if (!depth->clear_stencil)
        return;
    for (int32_t y = part ? part->y0 : 0; y <= (part ? part->y1 : tile->height - 1); y++)
        memset(tile->stencil + fast_at(part ? part->x0 : 0, y), depth->stencil_value,
               part ? (size_t)(part->x1 - part->x0 + 1) : FAST_TILE);
}

static void begin_depth(Tile *tile, const FastPass *pass, bool touched, ClearedPart cleared)
{
    const GpDepthTarget *depth = &pass->pass->depth;
    const int slot = fast_depth_slot(tile->slots->surfaces, depth->surface);
    FastDepthPlanes *planes = &tile->slots->depth_planes[slot];
    const bool has_stencil = gp_format_info(depth->surface->format)->has_stencil;
    const bool replaces = depth->clear_depth && (depth->clear_stencil || !has_stencil);
    if (!depth->clear_depth && !depth->clear_stencil)
        cleared = CLEARED_NOWHERE;
    tile->depth = planes->depth;
    tile->stencil = planes->stencil;
    if (cleared == CLEARED_WHOLE && replaces)
        tile->slots->depth[slot].held = true;
    else if (touched || cleared != CLEARED_NOWHERE)
        fast_hold_depth(tile, slot);
    if (cleared == CLEARED_WHOLE)
        clear_depth(tile, depth, NULL);
    FastBox part;
    for (uint32_t i = 0; cleared == CLEARED_PARTS && i < pass->pass->clear_rect_count; i++)
        if (clear_part(tile, pass->pass, i, &part))
            clear_depth(tile, depth, &part);
    tile->slots->depth[slot].written |= touched || cleared != CLEARED_NOWHERE;
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
    const ClearedPart cleared = pass->clears ? cleared_part(tile, pass->pass) : CLEARED_NOWHERE;
    tile->pass = pass;
    tile->targets = 0;
    for (int t = 0; t < GP_MAX_TARGETS && pass->pass->color[t].surface; t++) {
        begin_color(tile, pass, t, touched, cleared);
        tile->targets++;
    }
    tile->depth_format = GP_FORMAT_NONE;
    if (!pass->pass->depth.surface)
        return;
    tile->depth_format = pass->pass->depth.surface->format;
    begin_depth(tile, pass, touched, cleared);
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
