/* Framebuffer fetch: what the pixels of a packet hold, from slots or surfaces. */
#include "pipeline/fast/lanes/shade/framebuffer_fetch.h"

#include "pipeline/fast/lanes/memory/convert.h"
#include "pipeline/fast/lanes/memory/slots.h"
#include "pipeline/fast/lanes/output/quantize.h"
#include "pipeline/fast/lanes/shade/shader_block.h"
#include "pipeline/units/texture_read.h"

static void begin_fetch_color(Tile *tile, int slot, FastFetch *fetch)
{
    FastPlanes *planes = &tile->slots->color_planes[slot];
    const int channels = gp_format_info(fetch->format)->channels;
    const bool cleared = tile->slots->color[slot].cleared;
    fetch->sums = channels == 4 ? (const float(*)[4])tile->slots->color[slot].sums : NULL;
    if (!cleared && !fetch->sums)
        fast_hold_color(tile, slot);
    for (int c = 0; c < 4; c++) {
        fetch->same[c] = cleared ? tile->slots->color[slot].value[c] : 1;
        if (!cleared && !fetch->sums && c < channels)
            fetch->plane[c] = fast_is_packed(fetch->format)
                                  ? planes->packed
                                  : (const uint32_t *)(const void *)planes->channel[c];
    }
}

void fast_begin_fetch(Tile *tile, const GpTexture *textures, int number)
{
    const GpSurface *surface = textures[number].surface;
    const int color = fast_color_slot(tile->slots->surfaces, surface);
    const int depth = fast_depth_slot(tile->slots->surfaces, surface);
    FastFetch *fetch = &tile->block->fetch[number];
    *fetch = (FastFetch){ .format = surface->format, .same = { 1, 1, 1, 1 } };
    if (color >= 0)
        begin_fetch_color(tile, color, fetch);
    else if (depth >= 0) {
        fast_hold_depth(tile, depth);
        fetch->plane[0] = tile->slots->depth_planes[depth].depth;
    } else
        fetch->format = GP_FORMAT_NONE;
    fetch->is_float = !(fast_is_packed(fetch->format) && fetch->plane[0]) &&
                      fetch->format != GP_D16 && fetch->format != GP_D24S8;
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

/* Of fours that stand side by side. */
GP_INLINE void read_sums(const float (*sums)[4], const Places *places, itg rgba[4])
{
    const FastPacket *packet = places->packet;
    if (packet && packet->wide) {
        lanes_load4_row(sums[fast_at(packet->x, packet->y)], rgba);
        return;
    }
    const itg at = packet ? packet_y(packet) * FAST_PITCH + packet_x(packet) : places->at;
    const void *record[GP_LANES];
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        record[lane] = sums[at[lane]];
    lanes_load4(record, rgba);
}

GP_INLINE void read_planes(const FastFetch *fetch, const Places *places, flt rgba[4])
{
    if (fetch->sums) {
        itg words[4];
        read_sums(fetch->sums, places, words);
        GP_UNROLL
        for (int c = 0; c < 4; c++)
            rgba[c] = (flt)words[c];
        return;
    }
    if (fetch->is_float) {
        GP_UNROLL
        for (int c = 0; c < 4; c++)
            rgba[c] = fetch->plane[c] ? (flt)load_places(fetch->plane[c], places)
                                      : flt_set(fetch->same[c]);
        return;
    }
    static const int byte[4] = { RED_BYTE, GREEN_BYTE, BLUE_BYTE, ALPHA_BYTE };
    if (fast_is_packed(fetch->format)) {
        const itg words = load_places(fetch->plane[0], places);
        GP_UNROLL
        for (int c = 0; c < 4; c++)
            rgba[c] = flt_unpack_unorm8(words, byte[c]);
        if (!fetch->plane[3])
            rgba[3] = flt_set(1);
        return;
    }
    rgba[0] = depth_from_codes(fetch->format, load_places(fetch->plane[0], places));
    GP_UNROLL
    for (int c = 1; c < 4; c++)
        rgba[c] = flt_set(fetch->same[c]);
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
    const itg x = block_x(&tile->block->at, number), y = block_y(&tile->block->at, number);
    if (tile->block->fetch[slot].format == GP_FORMAT_NONE) {
        flt *pixel = (flt *)(void *)tile->block->pixel + 2 * number;
        pixel[0] = flt_from_itg(x + tile->x0);
        pixel[1] = flt_from_itg(y + tile->y0);
        gp_read_local_plain(call, slot, number, GP_LANES, texel);
        return;
    }
    const Places places = { .at = y * FAST_PITCH + x };
    const msk inside = (msk)(x < tile->width) & (msk)(y < tile->height);
    flt rgba[4];
    read_planes(&tile->block->fetch[slot], &places, rgba);
    GP_UNROLL
    for (int c = 0; c < 4; c++)
        flt_store(texel + c * GP_LANES, (flt)((itg)rgba[c] & inside));
}

void fast_fetch_framebuffer(const GpShaderCall *call, int slot, int number, int lanes, float *texel)
{
    GP_ASSERT(lanes == GP_LANES);
    Tile *tile = call->local;
    const FastPacket *packets = tile->block->at.packets;
    const Places places = { .packet = packets ? &packets[number] : NULL };
    if (!places.packet || !is_plain(tile, places.packet) ||
        tile->block->fetch[slot].format == GP_FORMAT_NONE) {
        read_anywhere(tile, call, slot, number, texel);
        return;
    }
    flt rgba[4];
    read_planes(&tile->block->fetch[slot], &places, rgba);
    GP_UNROLL
    for (int c = 0; c < 4; c++)
        flt_store(texel + c * GP_LANES, rgba[c]);
}
