#include "pipeline/fast/lanes/shade/repeated.h"

#include "pipeline/fast/lanes/output/depth.h"
#include "pipeline/fast/lanes/shade/interpolate_packets.h"
#include "pipeline/fast/lanes/shade/packets.h"
#include "pipeline/fast/lanes/shade/shader_block.h"

#include <string.h>

/* --- blocks of packets ------------------------------------------------------------------------ */

/* Before all blocks: of each row's part the number of the first packet of the draw that is being
 * found. Numbers of packets count from 1 on; 0: there is none yet. */
enum { ROW_PARTS = FAST_PIXELS / GP_LANES };
typedef struct FirstPackets {
    _Alignas(64) uint32_t number[ROW_PARTS];
} FirstPackets;

/* As many as a call of the shader takes. */
typedef struct KeptBlock {
    FastPacket packets[FAST_BLOCK];
    uint32_t next[FAST_BLOCK]; /* the number of that of the same pixels' next fragments */
    _Alignas(64) float depths[FAST_BLOCK * GP_LANES];
    _Alignas(64) float in[]; /* [packet][component][lane] */
} KeptBlock;

static size_t block_bytes(int components)
{
    return sizeof(KeptBlock) + (size_t)components * FAST_BLOCK * GP_LANES * sizeof(float);
}

size_t fast_least_repeated_bytes(void)
{
    return sizeof(FirstPackets) + block_bytes(GP_MAX_VARYINGS);
}

/* That a packet of the present draw is in, by its number from 0 on. */
GP_INLINE KeptBlock *block_of(const FastRepeated *r, uint32_t packet)
{
    return (KeptBlock *)(void *)(r->blocks + packet / FAST_BLOCK * r->block_bytes);
}

static void set_blocks(FastRepeated *r, const FastDraw *d)
{
    r->blocks = (char *)r->memory + r->kept[d->repeated].begin;
    r->block_bytes = block_bytes(d->modes.components);
}

/* --- drawing ---------------------------------------------------------------------------------- */

/* Whether fragments that fail the depth test now, before the shader, would fail it after: what is
 * stored only comes nearer. */
static bool fails_early(const FastDraw *d)
{
    const GpCompare test = d->draw->state.depth.test;
    return d->needs.depth_test && !d->needs.shader_depth &&
           (test == GP_LESS || test == GP_LESS_EQUAL);
}

/* Takes packets of which nothing passes out of a block: of eight models in each other a quarter of
 * all.
 * out  nearer: the others, whose inputs are then in the shader block */
static void find_nearer(Tile *tile, const FastPacketBlock *block, FastPacket *packets,
                        float *depths, FastPacketBlock *nearer)
{
    const FastDraw *d = tile->draw;
    const int words = d->modes.components * GP_LANES;
    float *in = tile->block->in;
    *nearer = (FastPacketBlock){ .packets = packets, .depths = depths };
    for (int p = 0; p < block->count; p++) {
        const FastPacket *packet = &block->packets[p];
        const flt z = flt_load(block->depths + p * GP_LANES);
        const itg stored = load_lanes(tile->depth + fast_at(packet->x, packet->y), false);
        const msk passed =
            compare_codes(d->draw->state.depth.test, coming_codes(tile, d, z), stored);
        const unsigned live = packet->live & msk_bits(passed);
        if (!live)
            continue;
        const int to = nearer->count++;
        packets[to] = *packet;
        packets[to].live = live;
        flt_store(depths + to * GP_LANES, z);
        for (int i = 0; i < words; i += GP_LANES, in += GP_LANES)
            flt_store(in, flt_load(block->in + p * words + i));
    }
}

static void draw_nearer(Tile *tile, const FastPacketBlock *block)
{
    FastPacket packets[FAST_BLOCK];
    _Alignas(64) float depths[FAST_BLOCK * GP_LANES];
    FastPacketBlock nearer;
    find_nearer(tile, block, packets, depths, &nearer);
    if (nearer.count)
        fast_shade_inputs(tile, tile->draw, &nearer);
}

/* in   has_block: the shader block's inputs are not wanted any more */
static void draw_kept(Tile *tile, bool has_block)
{
    const FastDraw *d = tile->draw;
    const FastRepeated *r = tile->repeated;
    const uint32_t count = r->kept[d->repeated].count;
    const bool early = has_block && fails_early(d);
    const FastPhase before = fast_turn_to(tile, FAST_SHADING);
    for (uint32_t packet = 0; packet < count; packet += FAST_BLOCK) {
        const KeptBlock *kept = block_of(r, packet);
        const uint32_t left = count - packet;
        const FastPacketBlock block = { .packets = kept->packets,
                                        .depths = kept->depths,
                                        .in = kept->in,
                                        .count = left < FAST_BLOCK ? (int)left : FAST_BLOCK };
        if (early)
            draw_nearer(tile, &block);
        else
            fast_shade_inputs(tile, d, &block);
    }
    fast_turn_to(tile, before);
}

/* --- finding ---------------------------------------------------------------------------------- */

void fast_begin_repeated(Tile *tile)
{
    tile->repeated->used = sizeof(FirstPackets);
    tile->repeated->finds = false;
    memset(tile->repeated->kept, 0, sizeof tile->repeated->kept);
}

static void begin_finding(Tile *tile)
{
    FastRepeated *r = tile->repeated;
    r->kept[tile->draw->repeated] = (FastKept){ .begin = r->used, .is_whole = true };
    memset(r->memory, 0, sizeof(FirstPackets));
    for (uint32_t part = 0; part < ROW_PARTS; part++)
        store_lanes(&r->link[part * GP_LANES], false, itg_set((int32_t)(part * sizeof(uint32_t))));
    set_blocks(r, tile->draw);
}

bool fast_find_repeated_fragments(Tile *tile)
{
    FastRepeated *r = tile->repeated;
    r->finds = !r->kept[tile->draw->repeated].is_whole;
    if (r->finds) {
        begin_finding(tile);
    } else {
        set_blocks(r, tile->draw);
        draw_kept(tile, true);
    }
    return r->finds;
}

void fast_end_repeated(Tile *tile)
{
    if (!tile->repeated->finds)
        return;
    draw_kept(tile, true);
    tile->repeated->finds = false;
}

/* Where there is no room, draws what is there and forgets it, with all that others have kept. */
static void make_room(Tile *tile)
{
    FastRepeated *r = tile->repeated;
    draw_kept(tile, false);
    fast_begin_repeated(tile);
    begin_finding(tile);
    r->finds = true;
    r->kept[tile->draw->repeated].is_whole = false;
}

/* A packet for a pixel's next fragment, and those beside it; returns its number. */
static __attribute__((noinline)) uint32_t add_packet(Tile *tile, uint32_t at)
{
    FastRepeated *r = tile->repeated;
    const int32_t first = (int32_t)(at & -(uint32_t)GP_LANES);
    FastKept *kept = &r->kept[tile->draw->repeated];
    if (kept->count % FAST_BLOCK == 0) {
        if (r->bytes - r->used < r->block_bytes)
            make_room(tile);
        r->used += r->block_bytes;
    }
    KeptBlock *block = block_of(r, kept->count);
    const uint32_t place = kept->count++ % FAST_BLOCK;
    set_packet(&block->packets[place], 0, first % FAST_PITCH, first / FAST_PITCH, 0, GP_LANES);
    block->next[place] = 0;
    return kept->count;
}

GP_INLINE uint32_t *link_of(FastRepeated *r, uint32_t at)
{
    return (uint32_t *)(void *)((char *)r->memory + r->link[at]);
}

/* The number of the packet for a pixel's next fragment. */
GP_INLINE uint32_t next_packet(Tile *tile, uint32_t at)
{
    FastRepeated *r = tile->repeated;
    const uint32_t present = *link_of(r, at);
    if (present)
        return present;
    const uint32_t number = add_packet(tile, at);
    return *link_of(r, at) = number; /* may be another link now: there may have been no room */
}

/* A packet's lanes, one by one: they lie in several rows, and go on in several packets. (By lanes
 * of a row at a time it is no quicker: triangles are small.) Lanes that none of them takes have
 * another's inputs. */
static void keep_packet(Tile *tile, const FastPacketBlock *block, int p, const float *in)
{
    FastRepeated *r = tile->repeated;
    const int components = tile->draw->modes.components;
    const float *depths = block->depths + p * GP_LANES;
    uint32_t places[GP_LANES];
    store_lanes(places, false, block_y(block, p) * FAST_PITCH + block_x(block, p));
    for (unsigned live = block->packets[p].live; live; live &= live - 1) {
        const int from = __builtin_ctz(live);
        const uint32_t at = places[from], number = next_packet(tile, at), to = at % GP_LANES;
        const uint32_t place = (number - 1) % FAST_BLOCK;
        KeptBlock *kept = block_of(r, number - 1);
        float *kept_in = kept->in + place * (uint32_t)components * GP_LANES;
        r->link[at] = (uint32_t)((char *)&kept->next[place] - (char *)r->memory);
        kept->depths[place * GP_LANES + to] = depths[from];
        if (!kept->packets[place].live)
            for (int c = 0; c < components; c++)
                flt_store(kept_in + c * GP_LANES, flt_set(in[c * GP_LANES + from]));
        else
            for (int c = 0; c < components; c++)
                kept_in[c * GP_LANES + (int)to] = in[c * GP_LANES + from];
        kept->packets[place].live |= 1u << to;
    }
}

void fast_keep_repeated(Tile *tile, const FastPacketBlock *block)
{
    const FastDraw *d = tile->draw;
    fast_interpolate_packets(tile, d, block, fast_inputs(tile));
    for (int p = 0; p < block->count; p++)
        keep_packet(tile, block, p, tile->block->in + p * d->modes.components * GP_LANES);
}
