/* Point sprites: set up GP_LANES at a time, then filled one by one.
 *
 * Where fragments are shaded in order, small sprites fill packets with as many of their rows as
 * have room, and the shader's inputs are left at once, for nothing but the place in the sprite
 * differs from pixel to pixel. */
#include "pipeline/fast/lanes/raster/sprite.h"

#include "pipeline/base/prefetch.h"
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

/* Inputs of some vertices in a row, where these are shaded again. (By gp_prefetch, whose lines are
 * counted, voxelization takes 5 % more: whether one vertex is on two lines is hard to foresee.) */
GP_PREFETCHES void prefetch_inputs(const FastDraw *d, uint32_t vertex, uint32_t count)
{
    const GpStream *stream = &d->draw->geometry.streams[d->draw->program->inputs[0].semantic];
    const size_t step = gp_stream_stride(stream);
    const uint8_t *inputs = (const uint8_t *)stream->data + (d->first_vertex + vertex) * step;
    for (size_t i = 0; i < count * step; i += 64)
        __builtin_prefetch(inputs + i);
    __builtin_prefetch(inputs + count * step - 1);
}

/* Some vertices in a row; often one. */
GP_PREFETCHES void prefetch_vertices(const FastDraw *d, uint32_t vertex, uint32_t count)
{
    for (uint32_t i = 0; i < count; i += 4)
        __builtin_prefetch(&d->positions[vertex + i]);
    if (d->path != FAST_ORDERED) /* varyings wait until it is known what is visible */
        return;
    if (d->shades_again)
        prefetch_inputs(d, vertex, count);
    else
        for (uint32_t i = 0; i < count * d->stride; i += 16)
            __builtin_prefetch(d->varyings + (size_t)vertex * d->stride + i);
}

void fast_prefetch_points(const FastDraw *d, const FastPrimitiveMask *mask)
{
    for (uint32_t lanes = mask->lanes; lanes;) {
        const uint32_t first = (uint32_t)__builtin_ctz(lanes);
        const uint32_t run = d->indices ? 1 : (uint32_t)__builtin_ctz(~(lanes >> first));
        prefetch_vertices(d, vertex_of(d, mask->first + first), run);
        lanes &= ~(((1u << run) - 1) << first);
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
    if (q->d->late_depth || q->d->sorted)
        flt_store(tile->queue->depths + tile->queue->count * GP_LANES, flt_set(q->z));
    if (q->d->wants_depth && !q->d->late_depth)
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

static void queue_batch(Tile *tile, const SpriteBatch *batch, Packing *packing)
{
    fast_reserve_records(tile, 1);
    const uint32_t record = tile->records->count++; /* for all: it tells that they face the eye */
    tile->records->record[record] = (FastTriangleRecord){ .face = 1.0f, .kind = FAST_SPRITE };
    for (unsigned drawn = batch->at.drawn; drawn; drawn &= drawn - 1)
        queue_sprite(tile, batch, (uint32_t)__builtin_ctz(drawn), record, packing);
}

/* --- visible, or only tested ------------------------------------------------------------------ */

static void write_record(Tile *tile, const SpriteBatch *batch, uint32_t lane,
                         FastTriangleRecord *record)
{
    const FastDraw *d = tile->draw;
    const float *varying = d->varyings + (size_t)batch->vertex[lane] * d->stride;
    *record = (FastTriangleRecord){ .face = 1.0f,
                                    .kind = FAST_SPRITE,
                                    .corner = { varying, varying, varying } };
    if (d->modes.sprite < 0)
        return;
    record->edges64 = (uint16_t)tile->records->edges64_count;
    tile->records->edges64[tile->records->edges64_count++].sprite.left = batch->at.left[lane];
    tile->records->edges64[record->edges64].sprite.top = batch->at.top[lane];
    tile->records->edges64[record->edges64].sprite.per_step = batch->per_step[lane];
}

/* A sprite of one pixel, of which scans are full: without lanes. */
GP_INLINE bool fill_pixel(const Filler *f, EarlyTest early, FastFragmentPath path, uint32_t at,
                          int32_t code)
{
    Tile *tile = f->tile;
    if (is_usual(early)) {
        if (code - f->allowance >= (int32_t)tile->depth[at])
            return false;
        tile->depth[at] = (uint32_t)code;
    }
    if (path == FAST_VISIBLE)
        tile->visibility->record[at] = f->number;
    return true;
}

/* Any sprite; returns whether some pixel passed. */
GP_INLINE bool fill_box(const Filler *f, EarlyTest early, FastFragmentPath path, const Sprites *s,
                        uint32_t lane, int32_t code)
{
    const int32_t x0 = s->x0[lane], x1 = s->x1[lane], y0 = s->y0[lane], y1 = s->y1[lane];
    if (early != EARLY_ANY && x0 == x1 && y0 == y1)
        return fill_pixel(f, early, path, fast_at(x0, y0), code);
    msk passed = itg_set(0);
    for (int32_t y = y0; y <= y1; y++)
        for (int32_t x = x0; x <= x1; x += GP_LANES)
            passed |= send_lanes(f, early, path, false, x, y, (msk)(lane_numbers() <= x1 - x),
                                 flt_set(s->z[lane]));
    return msk_any(passed);
}

/* Records of sprites that are not visible stay unwritten. */
GP_INLINE void fill(Filler *f, EarlyTest early, FastFragmentPath path, const SpriteBatch *batch)
{
    FastRecords *records = f->tile->records;
    const itg codes = is_usual(early) ? nearer_codes(f, early, batch->at.z) : itg_set(0);
    int32_t code[GP_LANES];
    __builtin_memcpy(code, &codes, sizeof code);
    if (path == FAST_VISIBLE)
        fast_reserve_records(f->tile, GP_LANES);
    for (unsigned drawn = batch->at.drawn; drawn; drawn &= drawn - 1) {
        const uint32_t lane = (uint32_t)__builtin_ctz(drawn);
        f->number = records->count;
        if (fill_box(f, early, path, &batch->at, lane, code[lane]) && path == FAST_VISIBLE)
            write_record(f->tile, batch, lane, &records->record[records->count++]);
    }
}

static void fill_batch(Filler *f, const SpriteBatch *batch)
{
    const bool visible = f->d->path == FAST_VISIBLE;
    if (f->early == EARLY_NEARER_FLOAT && visible)
        fill(f, EARLY_NEARER_FLOAT, FAST_VISIBLE, batch);
    else if (f->early == EARLY_NEARER_UNORM && visible)
        fill(f, EARLY_NEARER_UNORM, FAST_VISIBLE, batch);
    else
        fill(f, f->early, f->d->path, batch);
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
    Filler filler = fast_filler(tile);
    filler.front = true;
    for (uint32_t first = 0; first < count; first += most) {
        const uint32_t made = set_up_batches(tile, primitives + first, count - first, batches);
        if (tile->draw->packs_points)
            fast_pack_points(&filler, batches, made);
        for (uint32_t i = 0; !tile->draw->packs_points && i < made; i++)
            if (tile->draw->path == FAST_ORDERED)
                queue_batch(tile, &batches[i], &packing);
            else
                fill_batch(&filler, &batches[i]);
    }
}
