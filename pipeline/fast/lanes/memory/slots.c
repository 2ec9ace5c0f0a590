/* Slots: the targets of a group inside a tile. Each is loaded or cleared when a pass first needs it,
 * read and drawn to by any number of passes, and stored once, after the last. */
#include "pipeline/fast/draws/group.h"
#include "pipeline/fast/lanes/memory/packet.h"
#include "pipeline/fast/lanes/output/quantize.h"
#include "pipeline/fast/lanes/memory/transfer.h"

#include "pipeline/units/texture_read.h"

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
        fast_load_tile(tile, tile->slots->color[slot], &tile->color_slot[slot]);
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
        fast_load_tile(tile, tile->slots->depth[slot], &tile->depth_slot[slot]);
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

void fast_begin_slots(Tile *tile, const FastSlots *slots)
{
    tile->slots = slots;
    memset(tile->color_state, 0, sizeof tile->color_state);
    memset(tile->depth_state, 0, sizeof tile->depth_state);
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
    hold_color(tile, slot);
    fast_store_tile(tile, tile->slots->color[slot], &tile->color_slot[slot]);
}

void fast_store_slots(Tile *tile)
{
    for (int slot = 0; slot < FAST_COLOR_SLOTS; slot++)
        if (tile->color_state[slot].written)
            store_color(tile, slot);
    for (int slot = 0; slot < FAST_DEPTH_SLOTS; slot++)
        if (tile->depth_state[slot].written)
            fast_store_tile(tile, tile->slots->depth[slot], &tile->depth_slot[slot]);
}

/* --- reading in place ----------------------------------------------------------------------------- */

static void begin_fetch_color(Tile *tile, int slot, FastFetch *fetch)
{
    FastPlanes *planes = &tile->color_slot[slot];
    const int channels = gp_format_info(fetch->format)->channels;
    const bool cleared = tile->color_state[slot].cleared;
    if (!cleared)
        hold_color(tile, slot);
    for (int c = 0; c < 4; c++) {
        fetch->same[c] = cleared ? tile->color_state[slot].color[c] : 1;
        if (!cleared && c < channels)
            fetch->plane[c] = fetch->format == GP_A8R8G8B8
                                  ? planes->packed
                                  : (const uint32_t *)(const void *)planes->channel[c];
    }
}

void fast_begin_fetch(Tile *tile, const GpTexture *textures, int number)
{
    const GpSurface *surface = textures[number].surface;
    const int color = fast_color_slot(tile->slots, surface);
    const int depth = fast_depth_slot(tile->slots, surface);
    FastFetch *fetch = &tile->fetch[number];
    *fetch = (FastFetch){ .format = surface->format, .same = { 1, 1, 1, 1 } };
    if (color >= 0)
        begin_fetch_color(tile, color, fetch);
    else if (depth >= 0) {
        hold_depth(tile, depth);
        fetch->plane[0] = tile->depth_slot[depth].depth;
    } else
        fetch->format = GP_FORMAT_NONE;
}

GP_INLINE flt decode(GpFormat format, itg words)
{
    switch (format) { /* the divisions' operands are exact, as in gp_float_from_unorm */
    case GP_D16:
        return flt_from_itg(words) / 65535.0f;
    case GP_D24S8:
        return flt_from_itg(words) / 16777215.0f;
    default:
        return (flt)words;
    }
}

/* Where a packet's pixels are in the tile. */
typedef struct Places {
    const FastPacket *packet; /* a row or quads; or NULL, and where each lane is: */
    itg at;
} Places;

GP_INLINE itg load_places(const uint32_t *plane, const Places *places)
{
    const FastPacket *packet = places->packet;
    return packet ? load_lanes(plane + fast_at(packet->x, packet->y), !packet->wide)
                  : itg_gather((const uint8_t *)plane, places->at * 4);
}

GP_INLINE void read_planes(const FastFetch *fetch, const Places *places, flt rgba[4])
{
    static const int byte[4] = { RED_BYTE, GREEN_BYTE, BLUE_BYTE, ALPHA_BYTE };
    if (fetch->format == GP_A8R8G8B8 && fetch->plane[0]) {
        const itg words = load_places(fetch->plane[0], places);
        GP_UNROLL
        for (int c = 0; c < 4; c++)
            rgba[c] = flt_unpack_unorm8(words, byte[c]);
        return;
    }
    GP_UNROLL
    for (int c = 0; c < 4; c++)
        rgba[c] = fetch->plane[c] ? decode(fetch->format, load_places(fetch->plane[c], places))
                                  : flt_set(fetch->same[c]);
}

/* Rows and quads of which no pixel lies past the surface's edge. */
static bool is_plain(const Tile *tile, const FastPacket *packet)
{
    const int32_t rows = packet->wide ? 1 : 2;
    return !packet->gathered && (!packet->wide || packet->wide == GP_LANES) &&
           packet->x + GP_LANES <= tile->width && packet->y + rows <= tile->height;
}

/* Some pixels are anywhere, or past the surface's edge, where the model reads 0: helpers. */
static __attribute__((noinline)) void read_anywhere(Tile *tile, const GpShaderCall *call, int slot,
                                                    int number, float *texel)
{
    const FastPacket *packet = tile->shaded ? &tile->shaded[number] : NULL;
    const FastGathered *gathered = &tile->gathered[number];
    const itg x = packet && !packet->gathered ? packet_x(packet) : gathered->x;
    const itg y = packet && !packet->gathered ? packet_y(packet) : gathered->y;
    if (tile->fetch[slot].format == GP_FORMAT_NONE) {
        flt *pixel = (flt *)(void *)tile->pixel + 2 * number;
        pixel[0] = flt_from_itg(x + tile->x0);
        pixel[1] = flt_from_itg(y + tile->y0);
        gp_read_local_plain(call, slot, number, GP_LANES, texel);
        return;
    }
    const Places places = { .at = y * FAST_PITCH + x };
    const msk inside = (msk)(x < tile->width) & (msk)(y < tile->height);
    flt rgba[4];
    read_planes(&tile->fetch[slot], &places, rgba);
    GP_UNROLL
    for (int c = 0; c < 4; c++)
        flt_store(texel + c * GP_LANES, (flt)((itg)rgba[c] & inside));
}

void fast_fetch_framebuffer(const GpShaderCall *call, int slot, int number, int lanes, float *texel)
{
    GP_ASSERT(lanes == GP_LANES);
    Tile *tile = call->local;
    const Places places = { .packet = tile->shaded ? &tile->shaded[number] : NULL };
    if (!places.packet || !is_plain(tile, places.packet) ||
        tile->fetch[slot].format == GP_FORMAT_NONE) {
        read_anywhere(tile, call, slot, number, texel);
        return;
    }
    flt rgba[4];
    read_planes(&tile->fetch[slot], &places, rgba);
    GP_UNROLL
    for (int c = 0; c < 4; c++)
        flt_store(texel + c * GP_LANES, rgba[c]);
}
