/* Points whose fragments share packets, whatever points they are of. The values of GP_LANES points
 * are laid side by side, so that an input of a packet of their fragments is one shuffle.
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
#include "pipeline/fast/lanes/output/blend_add.h"
#include "pipeline/fast/lanes/raster/fragment_path.h"
#include "pipeline/fast/lanes/shade/interpolate.h"
#include "pipeline/fast/lanes/shade/shader_block.h"

#include <string.h>

enum {
    PACKETS = FAST_BLOCK / 2, /* of one call of the shader: their inputs stay in the first cache */
    ROOM = 64 * GP_LANES,
    SMALL_BOX = 2 * GP_LANES, /* pixels */
    POINT_SHIFT = 8,
    BYTE = 255,
    PLACE = BYTE | BYTE << PLACE_Y,
    DEAD = INT32_MIN,
};

/* Fragments of a batch of points: where they are in the tile, and their point's lane. The first
 * follow those that the last packet of the queue has already. */
typedef struct Fragments {
    Filler filler;
    const SpriteBatch *batch;
    itg *varying; /* of the batch's points, side by side, component after component */
    bool loaded;  /* they are, once a fragment wants them so */
    bool pairs;   /* as fast_adds_pairs: two by two, the second may be dead */
    itg order;    /* of each lane, the number of its fragment in the packet */
    uint32_t taken, count;
    uint32_t word[ROOM + GP_LANES]; /* x | lane << POINT_SHIFT | y << PLACE_Y, and perhaps DEAD */
} Fragments;

/* --- packets ---------------------------------------------------------------------------------- */

static void begin_fragments(const Tile *tile, Fragments *f)
{
    f->taken = f->count = tile->queue->count ? tile->queue->taken : 0;
    store_lanes(f->word, false, itg_set(0));
}

/* In which order lanes take fragments: one after the other, or pairs in lanes k and k + 4. */
static itg order_of_lanes(bool pairs)
{
    const itg lane = lane_numbers();
    return pairs ? (lane & ~7) | (lane & 3) << 1 | (lane >> 2 & 1) : lane;
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

/* Packets of a block, which differ in what lives alone. One record serves them all: it only tells
 * that points face the eye. */
static void begin_packets(Tile *tile)
{
    fast_reserve_records(tile, 1);
    const uint32_t number = tile->records->count++;
    tile->records->record[number] = (FastTriangleRecord){ .face = 1.0f, .kind = FAST_SPRITE };
    for (int p = 0; p < PACKETS; p++) {
        set_packet(&tile->queue->packets[p], number, 0, FAST_TILE, 0, GP_LANES);
        tile->queue->packets[p].gathered = true;
    }
}

/* A new packet at the end of the queue. */
GP_INLINE void begin_packet(Tile *tile)
{
    if (tile->queue->count == PACKETS)
        fast_flush_packets(tile); /* which leaves them as they began */
    else if (tile->queue->count == 0)
        begin_packets(tile);
    tile->queue->count++;
}

/* What all packets of a batch's fragments share: apart, so that no store can change it. */
typedef struct Source {
    Tile *tile;
    const SpriteBatch *batch;
    const itg *varying;
    int components,
        before; /* before: of them come before those of the place in the sprite, if any */
    bool has_place, keeps_depth;
    itg order;
    msk fresh; /* lanes of the first packet that are not taken */
    bool pairs;
} Source;

static Source source_of(const Fragments *f)
{
    const FastDraw *d = f->filler.d;
    const bool has_place = d->modes.sprite >= 0;
    return (Source){ .tile = f->filler.tile,
                     .batch = f->batch,
                     .varying = f->varying,
                     .components = d->modes.components,
                     .before = has_place ? d->modes.sprite : d->modes.components,
                     .has_place = has_place,
                     .keeps_depth = d->late_depth,
                     .order = f->order,
                     .fresh = (msk)(f->order >= (int32_t)f->taken),
                     .pairs = f->pairs };
}

/* Replaces the fresh lanes of what is kept, or all of them. */
GP_INLINE void keep_fresh(flt *kept, flt value, msk fresh, bool whole)
{
    *kept = whole ? value : flt_select(fresh, value, *kept);
}

/* What of the inputs differs from pixel to pixel. */
GP_INLINE void fill_places(const Source *s, itg x, itg y, itg point, flt *in, bool whole)
{
    const SpriteBatch *batch = s->batch;
    const flt per_step = (flt)itg_permute((itg)batch->per_step, point);
    const itg across = x * GP_SUBPIXELS - itg_permute(batch->at.left, point);
    const itg down = y * GP_SUBPIXELS - itg_permute(batch->at.top, point);
    keep_fresh(&in[0], flt_from_itg(across) * per_step, s->fresh, whole);
    keep_fresh(&in[1], flt_from_itg(down) * per_step, s->fresh, whole);
}

/* Components first..end-1 of the inputs, one value a point. */
GP_INLINE void fill_values(const Source *s, itg point, int first, int end, flt *in, bool whole)
{
    int c = first;
    for (; c + 2 <= end; c += 2) {
        keep_fresh(&in[c], (flt)itg_permute(s->varying[c], point), s->fresh, whole);
        keep_fresh(&in[c + 1], (flt)itg_permute(s->varying[c + 1], point), s->fresh, whole);
    }
    if (c < end)
        keep_fresh(&in[c], (flt)itg_permute(s->varying[c], point), s->fresh, whole);
}

/* The same of all components. Four lanes fetch them sooner than they find them among the values
 * that lie side by side. */
static void fetch_values(const Fragments *f, itg point, flt *in, msk fresh, bool whole)
{
    const FastDraw *d = f->filler.d;
    const int components = d->modes.components, sprite = d->modes.sprite;
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

/* Puts fragments into the queue's last packet, in all its lanes or the fresh ones. */
GP_INLINE void fill_packet(const Fragments *f, const Source *s, itg word, bool whole)
{
    FastQueue *queue = s->tile->queue;
    const uint32_t at = queue->count - 1;
    FastGathered *gathered = &queue->gathered[at];
    FastPacket *packet = &queue->packets[at];
    const itg place = word & PLACE, point = word >> POINT_SHIFT & BYTE;
    const unsigned alive = ~msk_bits((msk)word) & ALL_LANES;
    gathered->place = whole ? place : itg_select(s->fresh, place, gathered->place);
    packet->live = whole ? alive : packet->live | (alive & msk_bits(s->fresh));
    flt *in = fast_inputs(s->tile) + at * (uint32_t)s->components;
    if (GP_LANES > 4 || f->filler.d->shades_again) {
        fill_values(s, point, 0, s->before, in, whole);
        fill_values(s, point, s->before + 2, s->components, in, whole);
    } else
        fetch_values(f, point, in, s->fresh, whole);
    if (s->has_place)
        fill_places(s, place & BYTE, place >> PLACE_Y, point, in + s->before, whole);
    if (s->keeps_depth)
        keep_fresh((flt *)(void *)queue->depths + at, (flt)itg_permute((itg)s->batch->at.z, point),
                   s->fresh, whole);
}

/* Moves the fragments into the queue. Lanes that are left over repeat the last of them, dead. */
static void queue_fragments(Fragments *f)
{
    const uint32_t count = f->count, taken = f->taken;
    if (count == taken)
        return;
    if (GP_LANES > 4 && !f->loaded)
        load_varyings(f->filler.d, f->batch->vertex, f->varying);
    f->loaded = true;
    store_lanes(f->word + count, false, itg_set((int32_t)f->word[count - 1] | DEAD));
    const Source source = source_of(f);
    for (uint32_t first = 0; first < count; first += GP_LANES) {
        itg word = load_lanes(f->word + first, false);
        if (source.pairs)
            word = itg_permute(word, source.order);
        if (first || !taken) {
            begin_packet(source.tile);
            fill_packet(f, &source, word, true);
        } else
            fill_packet(f, &source, word, false);
    }
    source.tile->queue->taken = count % GP_LANES;
    begin_fragments(source.tile, f);
}

/* --- boxes ------------------------------------------------------------------------------------ */

_Static_assert(GP_LANES + GP_LANES * SMALL_BOX <= ROOM, "small boxes of a batch have room");

/* Boxes of few pixels, all at once, a fragment of each at a time: combined bits have no order. */
GP_INLINE void add_small(Fragments *f, unsigned small)
{
    const Sprites *s = &f->batch->at;
    const itg lane = lane_numbers() << POINT_SHIFT, first = s->x0 | lane, last = s->x1 | lane;
    itg x = first, y = s->y0;
    for (; small; small &= msk_bits((msk)(y <= s->y1))) {
        itg_compress(f->word + f->count, small, x | y << PLACE_Y);
        f->count += (uint32_t)__builtin_popcount(small);
        const msk ends = (msk)(x == last);
        x = itg_select(ends, first, x + 1);
        y -= (itg)ends;
    }
}

/* Lanes of a row of a sprite that pass the tests before the shader; code: of its depth, or that
 * itself where the test is not the usual. */
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

/* Rows of one box, of at most GP_LANES pixels; where there are pairs, of an even number of
 * fragments. */
GP_INLINE void add_rows(Fragments *f, EarlyTest early, int32_t x, int32_t pixels, int32_t point,
                        itg code)
{
    const Sprites *s = &f->batch->at;
    const msk inside = (msk)(lane_numbers() < pixels);
    const int32_t y0 = s->y0[point];
    const uint32_t odd = f->pairs && pixels % 2, fragments = (uint32_t)pixels + odd;
    itg word = (lane_numbers() + (x | y0 << PLACE_Y | point << POINT_SHIFT)) | (~inside & DEAD);
    uint32_t at = fast_at(x, y0), count = f->count;
    for (int32_t left = s->y1[point] - y0; left >= 0; left--, at += FAST_PITCH) {
        if (count > ROOM - GP_LANES) {
            f->count = count;
            queue_fragments(f);
            count = f->count;
        }
        if (early == EARLY_NONE) {
            store_lanes(f->word + count, false, word);
            count += fragments;
        } else {
            const unsigned passed = msk_bits(test_row(&f->filler, early, at, inside, code));
            itg_compress(f->word + count, passed, word);
            count += (uint32_t)__builtin_popcount(passed);
        }
        word += 1 << PLACE_Y;
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
    fragments.pairs = fast_adds_pairs(d);
    fragments.order = order_of_lanes(fragments.pairs);
    for (uint32_t i = 0; i < count; i++) {
        fragments.batch = &batches[i];
        fragments.varying = varying + i * components;
        fragments.loaded = d->shades_again;
        add_points(&fragments);
    }
}
