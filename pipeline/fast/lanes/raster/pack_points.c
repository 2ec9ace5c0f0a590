/* Points whose fragments share packets, whatever points they are of. The values of GP_LANES points are
 * laid side by side, so that an input of a packet of their fragments is one shuffle.
 *
 * Fragments that combine bits with what was there have no order. Those that add, or leave their
 * depth, keep that of their points, and are taken one run of neighbours after the other, so that a
 * pixel may be in a packet several times; what the tests before the shader reject takes no room.
 *
 * Where a vertex shader makes much of little, its varyings are not kept between the stages:
 * vertices are shaded for their positions first, and once more, for the rest, when their points are
 * drawn.
 * source index-driven vertex shading, as of Arm's Bifrost (2016) */
#include "pipeline/fast/lanes/raster/pack_points.h"

#include "pipeline/fast/lanes/geometry/vertices.h"
#include "pipeline/fast/lanes/raster/fragment_path.h"
#include "pipeline/fast/lanes/shade/interpolate.h"
#include "pipeline/fast/lanes/shade/shader_block.h"

#include <string.h>

enum {
    PACKETS = 16, /* of one call of the shader: their inputs stay in the first cache */
    ROOM = 64 * GP_LANES,
    SMALL_BOX = 2 * GP_LANES, /* pixels */
    Y_SHIFT = 8,
    POINT_SHIFT = 16,
    BYTE = 255,
};

/* Fragments of a batch of points: where they are in the tile, and their point's lane. The first
 * follow those that the last packet of the queue has already. */
typedef struct Fragments {
    Filler filler;
    const SpriteBatch *batch;
    itg *varying; /* of the batch's points, side by side, component after component */
    bool loaded;  /* they are, once a fragment wants them so */
    uint32_t taken, count;
    uint32_t word[ROOM + GP_LANES]; /* x | y << Y_SHIFT | lane << POINT_SHIFT */
} Fragments;

/* --- packets ---------------------------------------------------------------------------------- */

static void begin_fragments(const Tile *tile, Fragments *f)
{
    const uint32_t last =
        tile->queue->count ? tile->queue->packets[tile->queue->count - 1].live : 0;
    f->taken = f->count = (uint32_t)__builtin_popcount(last) % GP_LANES;
    store_lanes(f->word, false, itg_set(0));
}

/* Component after component of GP_LANES points, side by side. */
static void load_varyings(const FastDraw *d, const uint32_t vertex[GP_LANES], itg *varying)
{
    for (int c = 0; c < d->modes.components; c += 4) {
        const void *record[GP_LANES];
        GP_UNROLL
        for (int lane = 0; lane < GP_LANES; lane++)
            record[lane] = d->varyings + (size_t)vertex[lane] * d->stride + c;
        lanes_load4(record, varying + c);
    }
}

/* A new packet at the end of the queue. One record serves a block of them: it only tells that
 * points face the eye. */
static void begin_packet(Tile *tile)
{
    if (tile->queue->count == PACKETS)
        fast_flush_packets(tile);
    uint32_t number = tile->queue->packets[0].record;
    if (tile->queue->count == 0) {
        fast_reserve_records(tile, 1);
        number = tile->records->count++;
        tile->records->record[number] = (FastTriangleRecord){ .face = 1.0f, .kind = FAST_SPRITE };
    }
    FastPacket *packet = &tile->queue->packets[tile->queue->count++];
    set_packet(packet, number, 0, FAST_TILE, 0, GP_LANES);
    packet->gathered = true;
}

/* Replaces the fresh lanes of what is kept, or all of them. */
GP_INLINE void keep_fresh(flt *kept, flt value, msk fresh, bool whole)
{
    *kept = whole ? value : flt_select(fresh, value, *kept);
}

/* What of the inputs differs from pixel to pixel. */
GP_INLINE void fill_places(const Fragments *f, const FastGathered *gathered, itg point, flt *in,
                           msk fresh, bool whole)
{
    const SpriteBatch *batch = f->batch;
    const flt per_step = (flt)itg_permute((itg)batch->per_step, point);
    const itg across = gathered->x * GP_SUBPIXELS - itg_permute(batch->at.left, point);
    const itg down = gathered->y * GP_SUBPIXELS - itg_permute(batch->at.top, point);
    keep_fresh(&in[0], flt_from_itg(across) * per_step, fresh, whole);
    keep_fresh(&in[1], flt_from_itg(down) * per_step, fresh, whole);
}

/* What of the inputs is one value a point. Four lanes fetch it sooner than they find it among the
 * values that lie side by side. */
GP_INLINE void fill_values(const Fragments *f, itg point, flt *in, msk fresh, bool whole)
{
    const FastDraw *d = f->filler.d;
    const int components = d->modes.components, sprite = d->modes.sprite;
    if (GP_LANES > 4 || d->shades_again) {
        for (int c = 0; c < components; c++)
            if (c == sprite)
                c++; /* both of them differ from pixel to pixel */
            else
                keep_fresh(&in[c], (flt)itg_permute(f->varying[c], point), fresh, whole);
        return;
    }
    const void *record[GP_LANES];
    itg four[4];
    for (int c = 0; c < components; c += 4) {
        GP_UNROLL
        for (int lane = 0; lane < GP_LANES; lane++)
            record[lane] = d->varyings + (size_t)f->batch->vertex[point[lane]] * d->stride + c;
        lanes_load4(record, four);
        for (int i = 0; i < 4 && c + i < components; i++)
            if (sprite < 0 || (c + i != sprite && c + i != sprite + 1))
                keep_fresh(&in[c + i], (flt)four[i], fresh, whole);
    }
}

/* Puts fragments into the lanes of the queue's last packet that `fresh` tells. */
GP_INLINE void fill_packet(const Fragments *f, itg word, msk fresh, bool whole)
{
    Tile *tile = f->filler.tile;
    const FastDraw *d = f->filler.d;
    const uint32_t at = tile->queue->count - 1;
    FastGathered *gathered = &tile->queue->gathered[at];
    const itg x = word & BYTE, y = word >> Y_SHIFT & BYTE, point = word >> POINT_SHIFT;
    gathered->x = whole ? x : itg_select(fresh, x, gathered->x);
    gathered->y = whole ? y : itg_select(fresh, y, gathered->y);
    gathered->at = gathered->y * FAST_PITCH + gathered->x;
    flt *in = fast_inputs(tile) + at * (uint32_t)d->modes.components;
    fill_values(f, point, in, fresh, whole);
    if (d->modes.sprite >= 0)
        fill_places(f, gathered, point, in + d->modes.sprite, fresh, whole);
    if (d->late_depth)
        keep_fresh((flt *)(void *)tile->queue->depths + at,
                   (flt)itg_permute((itg)f->batch->at.z, point), fresh, whole);
}

/* Moves the fragments into the queue. Lanes that are left over repeat the last of them. */
static void queue_fragments(Fragments *f)
{
    Tile *tile = f->filler.tile;
    if (f->count == f->taken)
        return;
    if (GP_LANES > 4 && !f->loaded)
        load_varyings(f->filler.d, f->batch->vertex, f->varying);
    f->loaded = true;
    store_lanes(f->word + f->count, false, itg_set((int32_t)f->word[f->count - 1]));
    for (uint32_t first = 0; first < f->count; first += GP_LANES) {
        const itg word = load_lanes(f->word + first, false);
        if (first || !f->taken) {
            begin_packet(tile);
            fill_packet(f, word, word, true);
        } else
            fill_packet(f, word, (msk)(lane_numbers() >= (int32_t)f->taken), false);
        const uint32_t left = f->count - first;
        tile->queue->packets[tile->queue->count - 1].live =
            left < GP_LANES ? (1u << left) - 1 : ALL_LANES;
    }
    begin_fragments(tile, f);
}

/* --- boxes ------------------------------------------------------------------------------------ */

/* Boxes of few pixels, all at once, a fragment of each at a time: combined bits have no order. */
GP_INLINE void add_small(Fragments *f, unsigned small)
{
    const Sprites *s = &f->batch->at;
    const itg lane = lane_numbers() << POINT_SHIFT, first = s->x0 | lane, last = s->x1 | lane;
    itg x = first, y = s->y0;
    for (; small; small &= msk_bits((msk)(y <= s->y1))) {
        if (f->count > ROOM - GP_LANES)
            queue_fragments(f);
        itg_compress(f->word + f->count, small, x | y << Y_SHIFT);
        f->count += (uint32_t)__builtin_popcount(small);
        const msk ends = (msk)(x == last);
        x = itg_select(ends, first, x + 1);
        y -= (itg)ends;
    }
}

/* Lanes of a row of a sprite that pass the tests before the shader; code: of its depth, or that itself
 * where the test is not the usual. */
GP_INLINE msk test_row(const Filler *f, EarlyTest early, uint32_t at, msk inside, itg code)
{
    if (is_usual(early))
        return test_usual(f, f->writes, false, at, inside, code);
    msk replaced; /* never: of points that are packed, the ternary test is late */
    if (early == EARLY_ANY && !f->d->late_depth)
        return fast_test_depth_stencil(f->tile, f->d, at, false, inside, (flt)code, true,
                                       &replaced);
    return inside;
}

/* Rows of one box, of at most GP_LANES pixels. */
GP_INLINE void add_rows(Fragments *f, EarlyTest early, int32_t x, int32_t pixels, int32_t point,
                        itg code)
{
    const Sprites *s = &f->batch->at;
    const msk inside = (msk)(lane_numbers() < pixels);
    const int32_t y0 = s->y0[point];
    itg word = lane_numbers() + (x | y0 << Y_SHIFT | point << POINT_SHIFT);
    uint32_t at = fast_at(x, y0), count = f->count;
    for (int32_t left = s->y1[point] - y0; left >= 0; left--, at += FAST_PITCH) {
        if (count > ROOM - GP_LANES) {
            f->count = count;
            queue_fragments(f);
            count = f->count;
        }
        if (early == EARLY_NONE) {
            store_lanes(f->word + count, false, word);
            count += (uint32_t)pixels;
        } else {
            const unsigned passed = msk_bits(test_row(&f->filler, early, at, inside, code));
            itg_compress(f->word + count, passed, word);
            count += (uint32_t)__builtin_popcount(passed);
        }
        word += 1 << Y_SHIFT;
    }
    f->count = count;
}

GP_INLINE void add_box(Fragments *f, EarlyTest early, int32_t point, itg code)
{
    const int32_t x1 = f->batch->at.x1[point];
    for (int32_t x = f->batch->at.x0[point]; x <= x1; x += GP_LANES)
        add_rows(f, early, x, x1 - x + 1 < GP_LANES ? x1 - x + 1 : GP_LANES, point, code);
}

GP_INLINE void add_boxes(Fragments *f, EarlyTest early, unsigned points)
{
    const flt z = f->batch->at.z;
    const itg codes = is_usual(early) ? nearer_codes(&f->filler, early, z) : (itg)z;
    for (; points; points &= points - 1) {
        const int32_t point = __builtin_ctz(points);
        add_box(f, early, point, itg_set(codes[point]));
    }
}

static void add_points(Fragments *f)
{
    const Sprites *s = &f->batch->at;
    const EarlyTest early = f->filler.early;
    unsigned points = s->drawn;
    begin_fragments(f->filler.tile, f);
    if (early == EARLY_NONE && !f->filler.d->only_adds) {
        const utg pixels = (utg)(s->x1 - s->x0 + 1) * (utg)(s->y1 - s->y0 + 1); /* if drawn */
        const unsigned small = msk_bits((msk)(pixels <= SMALL_BOX)) & points;
        add_small(f, small);
        points &= ~small;
    }
    if (early == EARLY_NONE)
        add_boxes(f, EARLY_NONE, points);
    else if (early == EARLY_NEARER_FLOAT)
        add_boxes(f, EARLY_NEARER_FLOAT, points);
    else
        add_boxes(f, early, points);
    queue_fragments(f);
}

void fast_pack_points(const Filler *filler, const SpriteBatch *batches, uint32_t count)
{
    const FastDraw *d = filler->d;
    const uint32_t components = (uint32_t)d->modes.components;
    itg varying[FAST_SPRITE_BATCHES * GP_MAX_VARYINGS];
    uint32_t vertex[FAST_SPRITE_BATCHES][GP_LANES];
    for (uint32_t i = 0; d->shades_again && i < count; i++)
        memcpy(vertex[i], batches[i].vertex, sizeof vertex[i]);
    if (d->shades_again)
        fast_shade_varyings(d, vertex, count, (float *)(void *)varying);
    Fragments fragments;
    fragments.filler = *filler;
    for (uint32_t i = 0; i < count; i++) {
        fragments.batch = &batches[i];
        fragments.varying = varying + i * components;
        fragments.loaded = d->shades_again;
        add_points(&fragments);
    }
}
