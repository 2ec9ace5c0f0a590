/* Slots: the targets of a group inside a tile. Each is loaded or cleared when a pass first needs it,
 * read and drawn to by any number of passes, and stored once, after the last. */
#include "pipeline/fast/group.h"
#include "pipeline/fast/lanes/patch.h"
#include "pipeline/fast/lanes/through.h"
#include "pipeline/fast/lanes/transfer.h"

#include "pipeline/texture_read.h"

#include <string.h>

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
    if (tile->color_state[slot].cleared)
        spell_out(tile, slot);
    else if (!tile->color_state[slot].held)
        FAST(load_tile)(tile, tile->slots->color[slot], &tile->color_slot[slot]);
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
    if (!tile->depth_state[slot].held)
        FAST(load_tile)(tile, tile->slots->depth[slot], &tile->depth_slot[slot]);
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
    hold_color(tile, slot);
    FAST(store_tile)(tile, tile->slots->color[slot], &tile->color_slot[slot]);
}

void FAST(store_slots)(Tile *tile)
{
    for (int slot = 0; slot < FAST_COLOR_SLOTS; slot++)
        if (tile->color_state[slot].written)
            store_color(tile, slot);
    for (int slot = 0; slot < FAST_DEPTH_SLOTS; slot++)
        if (tile->depth_state[slot].written)
            FAST(store_tile)(tile, tile->slots->depth[slot], &tile->depth_slot[slot]);
}

/* --- reading in place ----------------------------------------------------------------------------- */

static void begin_local_color(Tile *tile, int slot, FastLocal *local)
{
    FastPlanes *planes = &tile->color_slot[slot];
    const int channels = gp_format_info(local->format)->channels;
    const bool cleared = tile->color_state[slot].cleared;
    if (!cleared)
        hold_color(tile, slot);
    for (int c = 0; c < 4; c++) {
        local->same[c] = cleared ? tile->color_state[slot].color[c] : 1;
        if (!cleared && c < channels)
            local->plane[c] = local->format == GP_A8R8G8B8
                                  ? planes->packed
                                  : (const uint32_t *)(const void *)planes->channel[c];
    }
}

void FAST(begin_local)(Tile *tile, const GpTexture *textures, int number)
{
    const GpSurface *surface = textures[number].surface;
    const int color = fast_color_slot(tile->slots, surface);
    const int depth = fast_depth_slot(tile->slots, surface);
    FastLocal *local = &tile->local[number];
    *local = (FastLocal){ .format = surface->format, .same = { 1, 1, 1, 1 } };
    if (color >= 0)
        begin_local_color(tile, color, local);
    else if (depth >= 0) {
        hold_depth(tile, depth);
        local->plane[0] = tile->depth_slot[depth].depth;
    } else
        local->format = GP_FORMAT_NONE;
}

/* Where a packet's pixels are in the tile. */
typedef struct Places {
    const FastPatch *patch; /* or NULL, and where each lane is: */
    itg at;
    msk inside; /* the surface: helper pixels may lie past its edge */
} Places;

static bool is_inside(const Tile *tile, const FastPatch *patch)
{
    const int32_t rows = patch->wide == GP_LANES ? 1 : patch->wide ? GP_LANES : 2;
    return patch->x + GP_LANES <= tile->width && patch->y + rows <= tile->height;
}

static Places find_places(const Tile *tile, const GpShaderCall *call, int packet)
{
    const FastPatch *patch = tile->shaded ? &tile->shaded[packet] : NULL;
    if (patch && !patch->mixed && is_inside(tile, patch))
        return (Places){ .patch = patch, .inside = itg_set(-1) };
    const float *pixel = call->pixel + 2 * packet * GP_LANES;
    const itg x = itg_from_flt(flt_load(pixel)) - tile->x0;
    const itg y = itg_from_flt(flt_load(pixel + GP_LANES)) - tile->y0;
    return (Places){ .at = y * FAST_PITCH + x,
                     .inside = (msk)(x < tile->width) & (msk)(y < tile->height) };
}

GP_INLINE flt read_channel(const FastLocal *local, int c, const Places *places)
{
    static const int byte[4] = { RED_BYTE, GREEN_BYTE, BLUE_BYTE, ALPHA_BYTE };
    if (!local->plane[c])
        return flt_set(local->same[c]);
    itg words = places->patch ? load_patch(local->plane[c], places->patch)
                              : itg_gather((const uint8_t *)local->plane[c], places->at * 4);
    switch (local->format) { /* the divisions' operands are exact, as in gp_float_from_unorm */
    case GP_A8R8G8B8:
        return flt_unpack_unorm8(words, byte[c]);
    case GP_D16:
        return flt_from_itg(words) / 65535.0f;
    case GP_D24S8:
        return flt_from_itg(words) / 16777215.0f;
    default:
        return (flt)words;
    }
}

void FAST(read_local)(const GpShaderCall *call, int slot, int packet, int lanes, float *texel)
{
    const Tile *tile = call->local;
    const FastLocal *local = &tile->local[slot];
    if (local->format == GP_FORMAT_NONE) {
        gp_read_local_plain(call, slot, packet, lanes, texel);
        return;
    }
    const Places places = find_places(tile, call, packet);
    GP_UNROLL
    for (int c = 0; c < 4; c++) /* outside: 0, as the model reads */
        flt_store(texel + c * GP_LANES,
                  (flt)((itg)read_channel(local, c, &places) & places.inside));
}
