/* Slots: the targets of a group inside a tile. Each is loaded or cleared when a pass first needs it,
 * read and drawn to by any number of passes, and stored once, after the last. */
#include "pipeline/fast/group.h"
#include "pipeline/fast/lanes/transfer.h"

#include "pipeline/texture_read.h"

#include <string.h>

static uint8_t *row_of(const Tile *tile, const GpSurface *surface, int32_t y)
{
    return gp_surface_texel(&surface->level[0], gp_format_info(surface->format)->bytes,
                            (uint32_t)tile->x0, (uint32_t)(tile->y0 + y));
}

static void fill_words(uint32_t *plane, int32_t height, uint32_t word)
{
    for (int32_t y = 0; y < height; y++, plane += FAST_PITCH)
        for (int32_t x = 0; x < FAST_TILE; x++)
            plane[x] = word;
}

/* --- colour ---------------------------------------------------------------------------------------- */

/* Only notes the colour: it may be all that anyone wants to know. */
static void clear_color(Tile *tile, int slot, const float color[4])
{
    const GpFormat format = tile->slots->color[slot]->format;
    uint8_t texel[16];
    gp_texel_store(format, texel, color, 0);
    gp_texel_load(format, texel, tile->color_state[slot].color);
    tile->color_state[slot].held = tile->color_state[slot].cleared = true;
}

static void spell_out(Tile *tile, int slot)
{
    const GpFormat format = tile->slots->color[slot]->format;
    const float *color = tile->color_state[slot].color;
    FastPlanes *planes = &tile->color_slot[slot];
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
static void hold_color(Tile *tile, int slot)
{
    const GpSurface *surface = tile->slots->color[slot];
    if (tile->color_state[slot].cleared)
        spell_out(tile, slot);
    for (int32_t y = 0; !tile->color_state[slot].held && y < tile->height; y++)
        FAST(load_colors)
    (surface->format, row_of(tile, surface, y), tile->width, &tile->color_slot[slot],
     fast_at(0, y));
    tile->color_state[slot].held = true;
    tile->color_state[slot].cleared = false;
}

static void begin_color(Tile *tile, const FastPass *pass, int target, bool touched)
{
    const GpColorTarget *color = &pass->pass->color[target];
    const int slot = fast_color_slot(tile->slots, color->surface);
    const bool clears = pass->clears && color->clear;
    tile->planes[target] = &tile->color_slot[slot];
    if (clears)
        clear_color(tile, slot, color->clear_color);
    if (touched)
        hold_color(tile, slot);
    tile->color_state[slot].written |= clears || touched;
}

/* --- depth and stencil ----------------------------------------------------------------------------- */

static void hold_depth(Tile *tile, int slot)
{
    const GpSurface *surface = tile->slots->depth[slot];
    for (int32_t y = 0; !tile->depth_state[slot].held && y < tile->height; y++)
        FAST(load_depths)
    (surface->format, row_of(tile, surface, y), tile->width, &tile->depth_slot[slot],
     fast_at(0, y));
    tile->depth_state[slot].held = true;
}

static void begin_depth(Tile *tile, const FastPass *pass, bool touched)
{
    const GpDepthTarget *depth = &pass->pass->depth;
    const int slot = fast_depth_slot(tile->slots, depth->surface);
    FastDepthPlanes *planes = &tile->depth_slot[slot];
    const bool clears_depth = pass->clears && depth->clear_depth;
    const bool clears_stencil = pass->clears && depth->clear_stencil;
    const bool has_stencil = gp_format_info(depth->surface->format)->has_stencil;
    const bool clears_all = clears_depth && (clears_stencil || !has_stencil);
    const bool written = touched || clears_depth || clears_stencil;
    tile->depth = planes->depth;
    tile->stencil = planes->stencil;
    if (clears_all)
        tile->depth_state[slot].held = true;
    else if (written)
        hold_depth(tile, slot);
    if (clears_depth)
        fill_words(planes->depth, tile->height,
                   gp_depth_code(depth->surface->format, depth->depth_value));
    if (clears_stencil)
        memset(planes->stencil, depth->stencil_value, sizeof planes->stencil);
    tile->depth_state[slot].written |= written;
}

/* --- the tile ------------------------------------------------------------------------------------- */

void FAST(begin_slots)(Tile *tile, const FastSlots *slots)
{
    tile->slots = slots;
    memset(tile->color_state, 0, sizeof tile->color_state);
    memset(tile->depth_state, 0, sizeof tile->depth_state);
}

void FAST(begin_pass)(Tile *tile, const FastPass *pass, bool touched)
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
    const GpSurface *surface = tile->slots->color[slot];
    hold_color(tile, slot);
    for (int32_t y = 0; y < tile->height; y++)
        FAST(store_colors)
    (surface->format, row_of(tile, surface, y), tile->width, &tile->color_slot[slot],
     fast_at(0, y));
}

static void store_depth(Tile *tile, int slot)
{
    const GpSurface *surface = tile->slots->depth[slot];
    for (int32_t y = 0; y < tile->height; y++)
        FAST(store_depths)
    (surface->format, row_of(tile, surface, y), tile->width, &tile->depth_slot[slot],
     fast_at(0, y));
}

void FAST(store_slots)(Tile *tile)
{
    for (int slot = 0; slot < FAST_COLOR_SLOTS; slot++)
        if (tile->color_state[slot].written)
            store_color(tile, slot);
    for (int slot = 0; slot < FAST_DEPTH_SLOTS; slot++)
        if (tile->depth_state[slot].written)
            store_depth(tile, slot);
}

/* --- reading in place ----------------------------------------------------------------------------- */

/* Where a packet's pixels are in the tile's planes. */
typedef struct Places {
    itg at;
    msk inside; /* the surface: helper pixels may lie past its edge */
    bool row;   /* side by side */
} Places;

static itg words_at(const void *plane, const Places *places)
{
    if (places->row)
        return (itg)flt_load((const float *)plane + places->at[0]);
    return itg_gather(plane, places->at * 4);
}

static void read_color_slot(const FastPlanes *planes, GpFormat format, const Places *places,
                            flt texel[4])
{
    static const uint8_t shift[4] = { 16, 8, 0, 24 }; /* of r g b a in A8R8G8B8's word */
    const int channels = gp_format_info(format)->channels;
    itg packed = format == GP_A8R8G8B8 ? words_at(planes->packed, places) : itg_set(0);
    for (int c = 0; c < 4; c++)
        texel[c] = c >= channels           ? flt_set(1)
                   : format == GP_A8R8G8B8 ? flt_from_itg(packed >> shift[c] & 255) / 255.0f
                                           : (flt)words_at(planes->channel[c], places);
}

/* Both operands of the division are exact, as in gp_float_from_unorm. */
static void read_depth_slot(const FastDepthPlanes *planes, GpFormat format, const Places *places,
                            flt texel[4])
{
    itg code = words_at(planes->depth, places);
    texel[0] = format == GP_D32F ? (flt)code
                                 : flt_from_itg(code) / (format == GP_D16 ? 65535.0f : 16777215.0f);
    texel[1] = texel[2] = texel[3] = flt_set(1);
}

void FAST(read_local)(const GpShaderCall *call, int slot, int packet, int lanes, float *texel)
{
    Tile *tile = call->local;
    const GpSurface *surface = call->textures[slot].surface;
    const int color = fast_color_slot(tile->slots, surface);
    const int depth = fast_depth_slot(tile->slots, surface);
    if (color < 0 && depth < 0) {
        gp_read_local_plain(call, slot, packet, lanes, texel);
        return;
    }
    const float *pixel = call->pixel + 2 * packet * GP_LANES;
    const itg x = itg_from_flt(flt_load(pixel)) - tile->x0;
    const itg y = itg_from_flt(flt_load(pixel + GP_LANES)) - tile->y0;
    Places places = { .at = y * FAST_PITCH + x,
                      .inside = (msk)(x < tile->width) & (msk)(y < tile->height) };
    places.row = msk_bits((msk)(places.at == places.at[0] + lane_numbers())) ==
                 (unsigned)((1ull << GP_LANES) - 1);
    flt value[4];
    if (color >= 0 && tile->color_state[color].cleared) {
        for (int c = 0; c < 4; c++)
            value[c] = flt_set(tile->color_state[color].color[c]);
    } else if (color >= 0) {
        hold_color(tile, color);
        read_color_slot(&tile->color_slot[color], surface->format, &places, value);
    } else {
        hold_depth(tile, depth);
        read_depth_slot(&tile->depth_slot[depth], surface->format, &places, value);
    }
    for (int c = 0; c < 4; c++)
        flt_store(texel + c * GP_LANES,
                  (flt)((itg)value[c] & places.inside)); /* outside: 0, as the model reads */
}
