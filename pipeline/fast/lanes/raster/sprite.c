/* Point sprites: set up GP_LANES at a time, then filled one by one.
 *
 * Where fragments are shaded in order, small sprites fill packets with as many of their rows as
 * have room, and the shader's inputs are left at once, for nothing but the place in the sprite
 * differs from pixel to pixel. */
#include "pipeline/fast/lanes/raster/sprite.h"

#include "pipeline/fast/lanes/geometry/sprites.h"
#include "pipeline/fast/lanes/raster/fragment_path.h"
#include "pipeline/fast/lanes/raster/pack_points.h"
#include "pipeline/fast/lanes/shade/interpolate.h"
#include "pipeline/fast/lanes/shade/shader_block.h"
#include "pipeline/units/input_assembly.h"

/* --- set-up ----------------------------------------------------------------------------------- */

/* Points are cut whole, by their vertex. */
static bool inside_clip_planes(const FastDraw *d, uint32_t vertex)
{
    const float *distance = d->varyings + (size_t)vertex * d->stride + d->modes.components;
    for (unsigned planes = d->needs.clip_planes; planes; planes &= planes - 1)
        if (!(*distance++ >= 0))
            return false;
    return true;
}

/* A point's vertex, counted from the draw's first. */
GP_INLINE uint32_t vertex_of(const FastDraw *d, uint32_t primitive)
{
    const uint32_t at = primitive - d->first_primitive;
    return (d->indices ? d->indices[at] : at) - d->first_vertex;
}

void fast_prefetch_points(const FastDraw *d, const FastPrimitiveMask *mask)
{
    const GpStream *stream = &d->draw->geometry.streams[d->draw->program->inputs[0].semantic];
    const size_t step = gp_stream_stride(stream);
    const uint8_t *inputs = stream->data;
    for (uint32_t lanes = mask->lanes; lanes; lanes &= lanes - 1) {
        const uint32_t vertex = vertex_of(d, mask->first + (uint32_t)__builtin_ctz(lanes));
        __builtin_prefetch(&d->positions[vertex]);
        if (d->shades_again)
            __builtin_prefetch(inputs + (d->first_vertex + vertex) * step);
        for (uint32_t c = 0; !d->shades_again && c < d->stride; c += 16)
            __builtin_prefetch(d->varyings + (size_t)vertex * d->stride + c);
    }
}

static void set_up(const Tile *tile, const uint32_t *primitives, uint32_t count, SpriteBatch *batch)
{
    const FastDraw *d = tile->draw;
    const GpRect rect = fast_tile_rect(tile, d);
    for (uint32_t lane = 0; lane < GP_LANES; lane++)
        batch->vertex[lane] = vertex_of(d, primitives[lane < count ? lane : count - 1]);
    Sprites s = place_sprites(d, batch->vertex, &rect);
    s.drawn &= (1u << count) - 1;
    for (unsigned left = d->needs.clip_planes ? s.drawn : 0; left; left &= left - 1)
        if (!inside_clip_planes(d, batch->vertex[__builtin_ctz(left)]))
            s.drawn &= ~(left & -left);

    const flt low = flt_set(d->viewport.min_depth), high = flt_set(d->viewport.max_depth);
    s.z = flt_select((msk)(s.z < low), low, s.z);
    s.z = flt_select((msk)(s.z > high), high, s.z);
    s.x0 -= tile->x0;
    s.y0 -= tile->y0;
    s.x1 -= tile->x0;
    s.y1 -= tile->y0;
    s.left -= tile->x0 * GP_SUBPIXELS + GP_SUBPIXELS / 2;
    s.top -= tile->y0 * GP_SUBPIXELS + GP_SUBPIXELS / 2;
    batch->at = s;
    batch->per_step = 1.0f / flt_from_itg(s.whole);
}

/* --- shaded in order -------------------------------------------------------------------------- */

/* Of sprites narrower than a packet: as many rows as have room go into one. Most have one width, so
 * what follows from it is kept from sprite to sprite. */
typedef struct Packing {
    int32_t wide, rows;  /* pixels a row, 0: not set; rows a packet */
    uint32_t reciprocal; /* times this and divided by 2^16 is divided by `rows`, up to 2^12 */
    itg across, down;    /* of each lane, in sub-pixels */
} Packing;

static void set_packing(Packing *packing, int32_t wide)
{
    packing->wide = wide;
    packing->rows = GP_LANES / wide;
    packing->reciprocal = (1 << 16) / (uint32_t)packing->rows + 1;
    packing->across = packet_columns(wide) * GP_SUBPIXELS;
    packing->down = packet_rows(wide) * GP_SUBPIXELS;
}

/* A sprite on its way into the queue. */
typedef struct Queuer {
    Tile *tile;
    const FastDraw *d;
    uint32_t record;
    FastBox box;
    int32_t left, top;
    float per_step, z;
    const float *varying;
} Queuer;

/* Room in the queue for so many packets, of a block at most. */
GP_INLINE void make_room(Tile *tile, int32_t packets)
{
    if ((int32_t)tile->queue->count + packets > FAST_BLOCK)
        fast_flush_packets(tile);
}

/* A packet, where there is room for one, if any of its pixels pass the early tests. */
GP_INLINE void queue_packet(const Queuer *q, int32_t x, int32_t y, int32_t wide, unsigned live)
{
    Tile *tile = q->tile;
    FastPacket *packet = &tile->queue->packets[tile->queue->count];
    set_packet(packet, q->record, x, y, live, wide);
    if (q->d->late_depth)
        flt_store(tile->queue->depths + tile->queue->count * GP_LANES, flt_set(q->z));
    else if (q->d->wants_depth)
        packet->live =
            fast_test_packet(tile, q->d, packet, true, live, flt_set(q->z), &packet->replaced);
    tile->queue->count += packet->live != 0;
}

GP_INLINE void repeat_ahead(flt *to, int stride, int count, flt value)
{
    for (int p = 0; p < count; p += FAST_AHEAD) {
        GP_UNROLL
        for (int k = 0; k < FAST_AHEAD; k++, to += stride)
            *to = value;
    }
}

/* Inputs of the sprite's packets from number `first` of the queue on: of one shape, one below
 * the other, so that they share u. Places of the lanes are in sub-pixels. */
GP_INLINE void set_inputs(const Queuer *q, uint32_t first, itg across, itg down)
{
    Tile *tile = q->tile;
    const int stride = q->d->modes.components, sprite = q->d->modes.sprite;
    const int count = (int)(tile->queue->count - first);
    const FastPacket *packets = tile->queue->packets + first;
    flt *const in = fast_inputs(tile) + first * (uint32_t)stride;
    for (int c = 0; c < stride; c++) {
        if (c == sprite)
            c += 2;
        if (c < stride)
            repeat_ahead(in + c, stride, count, flt_set(q->varying[c]));
    }
    if (sprite < 0)
        return;
    flt *place = in + sprite;
    repeat_ahead(place, stride, count, place_in_sprite(across, q->left, q->per_step));
    for (int p = 0; p < count; p++, place += stride)
        place[1] = place_in_sprite(down + packets[p].y * GP_SUBPIXELS, q->top, q->per_step);
}

static void queue_packed(const Queuer *q, const Packing *packing)
{
    Tile *tile = q->tile;
    const FastBox *box = &q->box;
    const int32_t wide = packing->wide, rows = packing->rows;
    const int32_t most = rows * FAST_BLOCK; /* rows of a full queue */
    for (int32_t top = box->y0; top <= box->y1; top += most) {
        const int32_t end = box->y1 < top + most ? box->y1 + 1 : top + most;
        make_room(tile, (int32_t)((uint32_t)(end - top + rows - 1) * packing->reciprocal >> 16));
        const uint32_t first = tile->queue->count;
        for (int32_t y = top; y < end; y += rows) {
            const int32_t pixels = (end - y < rows ? end - y : rows) * wide;
            queue_packet(q, box->x0, y, wide, (1u << pixels) - 1);
        }
        set_inputs(q, first, packing->across + box->x0 * GP_SUBPIXELS, packing->down);
    }
}

/* Any box, by rows or by quads. */
static void queue_box(const Queuer *q)
{
    const FastBox *box = &q->box;
    const bool quads = q->d->needs.quads;
    const int32_t across = quads ? QUADS_WIDE : GP_LANES, down = quads ? 2 : 1;
    const int32_t wide = quads ? 0 : GP_LANES;
    const itg column = packet_columns(wide), row = packet_rows(wide);
    for (int32_t y = quads ? box->y0 & ~1 : box->y0; y <= box->y1; y += down)
        for (int32_t x = quads ? box->x0 & ~1 : box->x0; x <= box->x1; x += across) {
            const itg px = column + x, py = row + y;
            unsigned live = msk_bits((msk)(px >= box->x0) & (msk)(px <= box->x1) &
                                     (msk)(py >= box->y0) & (msk)(py <= box->y1));
            make_room(q->tile, 1);
            const uint32_t first = q->tile->queue->count;
            if (live)
                queue_packet(q, x, y, wide, live);
            set_inputs(q, first, px * GP_SUBPIXELS, row * GP_SUBPIXELS);
        }
}

static void queue_sprite(Tile *tile, const SpriteBatch *batch, uint32_t lane, uint32_t record,
                         Packing *packing)
{
    const FastDraw *d = tile->draw;
    const Sprites *s = &batch->at;
    const Queuer queuer = { .tile = tile,
                            .d = d,
                            .record = record,
                            .box = { s->x0[lane], s->y0[lane], s->x1[lane], s->y1[lane] },
                            .left = s->left[lane],
                            .top = s->top[lane],
                            .per_step = batch->per_step[lane],
                            .z = s->z[lane],
                            .varying = d->varyings + (size_t)batch->vertex[lane] * d->stride };
    const int32_t wide = queuer.box.x1 - queuer.box.x0 + 1;
    if (wide >= GP_LANES || d->needs.quads) {
        queue_box(&queuer);
        return;
    }
    if (packing->wide != wide)
        set_packing(packing, wide);
    queue_packed(&queuer, packing);
}

/* --- visible, or only tested ------------------------------------------------------------------ */

static void fill_rows(Tile *tile, const SpriteBatch *batch, uint32_t lane)
{
    const FastDraw *d = tile->draw;
    const Sprites *s = &batch->at;
    Filler filler = fast_filler(tile);
    filler.front = true;
    if (d->path != FAST_DEPTH_ONLY) {
        const float *varying = d->varyings + (size_t)batch->vertex[lane] * d->stride;
        fast_reserve_records(tile, 1);
        filler.number = tile->records->count++;
        FastEdges64 *edges = &tile->records->edges64[tile->records->edges64_count];
        tile->records->record[filler.number] =
            (FastTriangleRecord){ .face = 1.0f,
                                  .kind = FAST_SPRITE,
                                  .edges64 = (uint16_t)tile->records->edges64_count++,
                                  .corner = { varying, varying, varying } };
        edges->sprite.left = s->left[lane];
        edges->sprite.top = s->top[lane];
        edges->sprite.per_step = batch->per_step[lane];
    }
    for (int32_t y = s->y0[lane]; y <= s->y1[lane]; y++)
        for (int32_t x = s->x0[lane]; x <= s->x1[lane]; x += GP_LANES) {
            int32_t pixels = s->x1[lane] - x + 1;
            unsigned live = (1u << (pixels < GP_LANES ? pixels : GP_LANES)) - 1;
            send_lanes(&filler, filler.early, d->path, false, x, y, mask_of(live),
                       flt_set(s->z[lane]));
        }
}

static void fill_batch(Tile *tile, const SpriteBatch *batch, Packing *packing)
{
    const FastDraw *d = tile->draw;
    uint32_t record = 0;
    if (d->path == FAST_ORDERED) { /* one for all: it only tells that they face the eye */
        fast_reserve_records(tile, 1);
        record = tile->records->count++;
        tile->records->record[record] = (FastTriangleRecord){ .face = 1.0f, .kind = FAST_SPRITE };
    }
    for (unsigned drawn = batch->at.drawn; drawn; drawn &= drawn - 1) {
        const uint32_t lane = (uint32_t)__builtin_ctz(drawn);
        if (d->path == FAST_ORDERED)
            queue_sprite(tile, batch, lane, record, packing);
        else
            fill_rows(tile, batch, lane);
    }
}

static uint32_t set_up_batches(const Tile *tile, const uint32_t *primitives, uint32_t count,
                               SpriteBatch *batches)
{
    uint32_t batch = 0;
    for (; count && batch < FAST_SPRITE_BATCHES; batch++) {
        const uint32_t now = count < GP_LANES ? count : GP_LANES;
        set_up(tile, primitives, now, &batches[batch]);
        primitives += now;
        count -= now;
    }
    return batch;
}

void fast_fill_sprites(Tile *tile, const uint32_t *primitives, uint32_t count)
{
    const uint32_t most = FAST_SPRITE_BATCHES * GP_LANES;
    SpriteBatch batches[FAST_SPRITE_BATCHES];
    Packing packing = { .wide = 0 };
    for (uint32_t first = 0; first < count; first += most) {
        const uint32_t made = set_up_batches(tile, primitives + first, count - first, batches);
        if (tile->draw->packs_points)
            fast_pack_points(tile, batches, made);
        for (uint32_t i = 0; !tile->draw->packs_points && i < made; i++)
            fill_batch(tile, &batches[i], &packing);
    }
}
