/* Binning in lanes: GP_LANES triangles or points at a time are culled and put in the bins of their
 * tiles. */
#include "pipeline/fast/lanes/geometry/cull.h"

#include "pipeline/fast/draws/find.h"
#include "pipeline/fast/lanes/geometry/sprites.h"

enum {
    FITS = 1 << 15,         /* largest extent, in sub-pixels, at which areas fit into 32 bits */
    TINY = 2 * GP_SUBPIXELS /* a smaller extent holds at most two centres */
};

/* GP_LANES triangles of one draw on the screen. */
typedef struct ScreenTriangles {
    itg x[3], y[3];
    itg low_x, low_y, high_x, high_y;
    itg x0, y0, x1, y1; /* pixels whose centres may be inside, ends included */
} ScreenTriangles;

GP_INLINE itg least(const itg a[3])
{
    return itg_lesser(a[0], itg_lesser(a[1], a[2]));
}

GP_INLINE itg most(const itg a[3])
{
    return itg_greater(a[0], itg_greater(a[1], a[2]));
}

/* Corners of a run of triangles; beyond its end the first one's stand in. */
GP_INLINE void load_corners(const FastDraw *d, FastPrimitiveMask run, ScreenTriangles *b)
{
    const uint32_t *indices = d->indices, *number;
    const uint32_t first = 3 * (run.first - d->first_primitive);
    uint32_t made[3 * GP_LANES];
    const bool whole = run.lanes >> (GP_LANES - 1) & 1;
    if (!indices || !whole) {
        for (uint32_t i = 0; i < 3 * GP_LANES; i++) {
            uint32_t at = first + (run.lanes >> i / 3 & 1 ? i : i % 3);
            made[i] = indices ? indices[at] : at;
        }
        number = made;
    } else {
        number = indices + first;
    }
    for (int k = 0; k < 3; k++) {
        const void *record[GP_LANES];
        GP_UNROLL
        for (int lane = 0; lane < GP_LANES; lane++)
            record[lane] = &d->positions[number[3 * lane + k] - d->first_vertex];
        itg word[4];
        lanes_load4(record, word);
        b->x[k] = word[0];
        b->y[k] = word[1];
    }
}

GP_INLINE void set_boxes(const FastDraw *d, ScreenTriangles *b)
{
    const int32_t half = GP_SUBPIXELS / 2;
    b->low_x = least(b->x);
    b->low_y = least(b->y);
    b->high_x = most(b->x);
    b->high_y = most(b->y);
    b->x0 = itg_greater((b->low_x + (half - 1)) >> GP_SUBPIXEL_BITS, itg_set(d->rect.x0));
    b->y0 = itg_greater((b->low_y + (half - 1)) >> GP_SUBPIXEL_BITS, itg_set(d->rect.y0));
    b->x1 = itg_lesser((b->high_x - half) >> GP_SUBPIXEL_BITS, itg_set(d->rect.x1 - 1));
    b->y1 = itg_lesser((b->high_y - half) >> GP_SUBPIXEL_BITS, itg_set(d->rect.y1 - 1));
}

/* Triangles that miss the four centres at and beyond (x0, y0), which are all that a tiny one may
 * cover. Centres on an edge are taken to be covered: the tiles know better. */
GP_INLINE msk misses_centers(const ScreenTriangles *b, itg area2)
{
    const itg turn = area2 < 0; /* edges of a triangle that turns the other way are reversed */
    const itg px = b->x0 * GP_SUBPIXELS + GP_SUBPIXELS / 2;
    const itg py = b->y0 * GP_SUBPIXELS + GP_SUBPIXELS / 2;
    itg out[4] = { itg_set(0), itg_set(0), itg_set(0), itg_set(0) };
    GP_UNROLL
    for (int i = 0; i < 3; i++) {
        int from = (i + 1) % 3, to = (i + 2) % 3;
        itg dx = ((b->x[to] - b->x[from]) ^ turn) - turn;
        itg dy = ((b->y[to] - b->y[from]) ^ turn) - turn;
        itg edge = cross_lanes(dx, py - b->y[from], dy, px - b->x[from]);
        itg right = (itg)((utg)edge - (utg)dy * GP_SUBPIXELS);
        itg down = (itg)((utg)dx * GP_SUBPIXELS);
        out[0] |= edge;
        out[1] |= right;
        out[2] |= (itg)((utg)edge + (utg)down);
        out[3] |= (itg)((utg)right + (utg)down);
    }
    return (msk)((out[0] & out[1] & out[2] & out[3]) < 0);
}

/* Triangles that face the way that is drawn and may hold a centre. */
GP_INLINE unsigned drawn_lanes(const FastDraw *d, const ScreenTriangles *b)
{
    itg area2 =
        cross_lanes(b->x[1] - b->x[0], b->y[2] - b->y[0], b->x[2] - b->x[0], b->y[1] - b->y[0]);
    GpCull cull = d->draw->state.raster.cull;
    msk drawn = cull == GP_CULL_CW    ? (msk)(area2 < 0)
                : cull == GP_CULL_CCW ? (msk)(area2 > 0)
                                      : (msk)(area2 != 0);
    drawn &= (msk)(b->x0 <= b->x1) & (msk)(b->y0 <= b->y1);
    msk tiny = drawn & (msk)(b->high_x - b->low_x < TINY) & (msk)(b->high_y - b->low_y < TINY);
    if (msk_bits(tiny))
        drawn &= ~(tiny & misses_centers(b, area2));
    return msk_bits(drawn);
}

/* Triangles that are too large for lanes, or meet a plane: they are left to the code that takes one
 * at a time. `none`: those with all corners outside one plane. */
GP_INLINE unsigned lanes_alone(const ScreenTriangles *b, unsigned *none)
{
    itg large = (itg)(b->high_x - b->low_x >= FITS) | (itg)(b->high_y - b->low_y >= FITS);
    itg outside = b->low_x < FAST_NOWHERE / 2;
    *none = 0;
    if (msk_bits((msk)outside)) {
        itg planes = b->x[0] & b->x[1] & b->x[2] & FAST_OUTSIDE_ALL;
        *none = msk_bits((itg)(b->high_x < FAST_NOWHERE / 2) & (itg)(planes != 0));
    }
    return msk_bits(large | outside) & ~*none;
}

/* The tiles that primitives touch: columns x0..x1 and rows y0..y1. */
typedef struct TileBoxes {
    itg x0, y0, x1, y1;
    itg first; /* number of the tile at (x0, y0) */
} TileBoxes;

GP_INLINE TileBoxes tile_boxes(const FastPass *pass, itg x0, itg y0, itg x1, itg y1)
{
    const int bits = __builtin_ctz(FAST_TILE);
    TileBoxes t = { .x0 = x0 >> bits, .y0 = y0 >> bits, .x1 = x1 >> bits, .y1 = y1 >> bits };
    t.first = t.y0 * (int32_t)pass->tiles_x + t.x0 - (int32_t)pass->first_tile;
    return t;
}

/* Those that touch no tile but their first. */
GP_INLINE unsigned in_one_tile(const TileBoxes *tiles)
{
    return msk_bits((msk)(((tiles->x0 ^ tiles->x1) | (tiles->y0 ^ tiles->y1)) == 0));
}

/* Puts those of the lanes that are in one's tile there together; returns them. */
GP_INLINE unsigned bin_like(FastRange *range, uint32_t first, unsigned lanes, itg tiles,
                            uint32_t tile)
{
    const unsigned in = lanes & msk_bits((msk)(tiles == (int32_t)tile));
    fast_add_to_group(range, tile, (FastPrimitiveMask){ first, in });
    return in;
}

/* Lanes whose tile none of the `lanes` has that come shortly before: the first of each tile is
 * one. */
GP_INLINE unsigned run_firsts(unsigned lanes, itg tiles)
{
    enum { BEFORE = 2 }; /* strips go to and fro between two tiles */
    unsigned firsts = lanes;
    itg before = tiles;
    GP_UNROLL
    for (int i = 1; i <= BEFORE; i++) {
        before = itg_shift_in(before, 0);
        firsts &= ~(msk_bits((msk)(tiles == before)) & lanes << i);
    }
    return firsts;
}

/* Puts triangles of the same tile there together, of all `lanes`. Mostly the first one's is all; of
 * others each run comes in turn, which for a later one changes nothing. (To strike out those that
 * are done would make each turn wait for the one before: with AVX-512 bunny_depth takes 6 %
 * more.) */
GP_INLINE void bin_lanes(FastRange *range, uint32_t first, unsigned lanes, itg tiles)
{
    uint32_t tile[GP_LANES];
    __builtin_memcpy(tile, &tiles, sizeof tile);
    if (!lanes)
        return;
    const unsigned in = bin_like(range, first, lanes, tiles, tile[__builtin_ctz(lanes)]);
    if (in == lanes)
        return;
    for (unsigned runs = run_firsts(lanes & ~in, tiles); runs; runs &= runs - 1)
        bin_like(range, first, lanes, tiles, tile[__builtin_ctz(runs)]);
}

/* Neighbours mostly touch the same few tiles: bins them as one group a tile. Small ones touch up to
 * two by two, which are taken one after the other. */
GP_INLINE void bin_together(const FastPass *pass, FastRange *range, uint32_t first, unsigned lanes,
                            const TileBoxes *tiles)
{
    const itg columns = tiles->x1 - tiles->x0, rows = tiles->y1 - tiles->y0;
    const unsigned wide = lanes & msk_bits((msk)((columns | rows) > 1));
    const unsigned right = lanes & ~wide & msk_bits((msk)(columns > 0));
    const unsigned down = lanes & ~wide & msk_bits((msk)(rows > 0));
    bin_lanes(range, first, lanes & ~wide, tiles->first);
    if (right | down | wide) {
        bin_lanes(range, first, right, tiles->first + 1);
        bin_lanes(range, first, down, tiles->first + (int32_t)pass->tiles_x);
        bin_lanes(range, first, right & down, tiles->first + (int32_t)pass->tiles_x + 1);
    }
    for (unsigned left = wide; left; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        for (int32_t y = tiles->y0[lane]; y <= tiles->y1[lane]; y++)
            for (int32_t x = tiles->x0[lane]; x <= tiles->x1[lane]; x++)
                fast_add_to_group(range,
                                  (uint32_t)y * pass->tiles_x + (uint32_t)x - pass->first_tile,
                                  (FastPrimitiveMask){ first, left & -left });
    }
}

/* A run of triangles of one draw, whose corners are loaded. */
static void bin_triangles(const FastPass *pass, const FastDraw *d, FastRange *range,
                          FastPrimitiveMask run, const ScreenTriangles *loaded)
{
    ScreenTriangles b = *loaded;
    unsigned none;
    set_boxes(d, &b);
    unsigned alone = lanes_alone(&b, &none);
    unsigned left = ((drawn_lanes(d, &b) & ~none) | alone) & run.lanes;
    if (left & alone) {
        fast_bin_triangles(pass, d, range, (FastPrimitiveMask){ run.first, left });
        return;
    }
    const TileBoxes tiles = tile_boxes(pass, b.x0, b.y0, b.x1, b.y1);
    bin_together(pass, range, run.first, left, &tiles);
}

/* Whether half of `lanes` begin in the tile of the first of them: neighbours of a mesh mostly do,
 * of other points hardly ever. */
static bool are_together(const TileBoxes *tiles, unsigned lanes)
{
    if (!lanes)
        return false;
    const itg first = itg_set(tiles->first[__builtin_ctz(lanes)]);
    const unsigned same = lanes & msk_bits((msk)(tiles->first == first));
    return 2 * __builtin_popcount(same) >= __builtin_popcount(lanes);
}

/* Points of a run; beyond its end the first one stands in. */
GP_INLINE Sprites place_points(const FastDraw *d, FastPrimitiveMask run)
{
    const uint32_t *indices = d->indices;
    uint32_t vertex[GP_LANES];
    GP_UNROLL
    for (uint32_t lane = 0; lane < GP_LANES; lane++) {
        uint32_t at = run.first - d->first_primitive + (run.lanes >> lane & 1 ? lane : 0);
        vertex[lane] = (indices ? indices[at] : at) - d->first_vertex;
    }
    return place_sprites(d, vertex, &d->rect);
}

/* A run of points of one draw, at their places. */
static void bin_points(const FastPass *pass, FastRange *range, FastPrimitiveMask run,
                       const Sprites *s)
{
    const TileBoxes tiles = tile_boxes(pass, s->x0, s->y0, s->x1, s->y1);
    const unsigned one = in_one_tile(&tiles);
    unsigned left = s->drawn & run.lanes;
    if (are_together(&tiles, left)) {
        bin_together(pass, range, run.first, left, &tiles);
        return;
    }
    for (; left; left &= left - 1) { /* in each tile order counts */
        const uint32_t lane = (uint32_t)__builtin_ctz(left);
        if (one >> lane & 1)
            fast_add_to_tile(range, (uint32_t)tiles.first[lane],
                             (FastPrimitiveMask){ run.first + lane, 1 });
        else
            fast_bin_box(pass, range, (FastPrimitiveMask){ run.first + lane, 1 },
                         &(FastBox){ s->x0[lane], s->y0[lane], s->x1[lane], s->y1[lane] });
    }
}

/* --- runs ------------------------------------------------------------------------------------- */

/* Some primitives of one draw, and where they are: triangles or points. (In a union gcc would not
 * keep them in registers.) */
typedef struct Run {
    FastPrimitiveMask primitives;
    ScreenTriangles triangles;
    Sprites sprites;
} Run;

/* Up to GP_LANES of those from `first` on. */
GP_INLINE void load_run(const FastDraw *d, bool points, uint32_t first, uint32_t stop, Run *run)
{
    const uint32_t count = stop - first < GP_LANES ? stop - first : GP_LANES;
    run->primitives = (FastPrimitiveMask){ first, (1u << count) - 1 };
    if (points)
        run->sprites = place_points(d, run->primitives);
    else
        load_corners(d, run->primitives, &run->triangles);
}

/* Primitives of one draw, while there is memory; returns the first that is left. Runs are loaded
 * one ahead: before the branches of the present one, which wait for its places, and go the wrong
 * way at times. (Two threads, one of which may have shaded what the other bins, take a quarter less
 * for it; one alone a tenth.) */
GP_INLINE uint32_t bin_draw(const FastPass *pass, const FastDraw *d, bool points, FastRange *range,
                            uint32_t first, uint32_t stop)
{
    Run next;
    load_run(d, points, first, stop, &next);
    while (first < stop) {
        const Run run = next;
        first += (uint32_t)__builtin_popcount(run.primitives.lanes);
        if (first < stop)
            load_run(d, points, first, stop, &next);
        if (points)
            bin_points(pass, range, run.primitives, &run.sprites);
        else
            bin_triangles(pass, d, range, run.primitives, &run.triangles);
        if (!fast_budget_left(range->budget))
            break;
    }
    return first;
}

/* Always some primitives at least, so that a pass comes to its end whatever the limit. */
void fast_bin_range(const FastPass *pass, FastRange *range)
{
    uint32_t first = range->first, stop = first;
    const FastDraw *d = &pass->draws[fast_find_draw(pass, first)];
    for (; first == stop && first < range->end; d++) {
        if (!d->primitive_count)
            continue;
        const uint32_t draw_end = d->first_primitive + d->primitive_count;
        stop = draw_end < range->end ? draw_end : range->end;
        first = d->draw->geometry.primitive == GP_POINTS
                    ? bin_draw(pass, d, true, range, first, stop)
                    : bin_draw(pass, d, false, range, first, stop);
    }
    range->reached = first;
}
