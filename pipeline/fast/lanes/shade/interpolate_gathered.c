/* The interpolants of every lane from its own triangle, in the model's operations. */
#include "pipeline/fast/lanes/shade/interpolate_gathered.h"

#include "pipeline/fast/lanes/shade/interpolate.h"

/* --- runs of lanes that share a triangle ------------------------------------------------------ */

/* Without shuffles by variable indices it is faster to fetch each lane's triangle by itself. */
enum { LANES_SHARE = GP_LANES > 4 };

/* The first words of a record. */
enum { EDGE, STEP, AREA = 4, RATIO, KIND = 7 };

/* Where in the runs the lanes of a gathered packet find their values. */
typedef struct Spread {
    uint32_t first;
    itg run; /* from there on */
} Spread;

/* The runs of a gathered packet, behind those of the gathered packets before it. */
static Spread add_runs(const FastGathered *gathered, FastLaneRuns *runs)
{
    itg left = itg_shift_in(gathered->record, 0);
    unsigned starts = LANES_SHARE ? msk_bits(gathered->record != left) | 1 : (1u << GP_LANES) - 1;
    Spread spread = { runs->count, itg_prefix_sum((itg)mask_of(starts) & 1) - 1 };
    itg_compress(runs->record + runs->count, starts, gathered->record);
    runs->count += (uint32_t)__builtin_popcount(starts);
    return spread;
}

/* Of GP_LANES runs from `at` on: the words of their records. */
GP_INLINE msk fetch_words(const FastTriangleRecord *const records[GP_LANES], uint32_t at,
                          FastLaneRuns *runs)
{
    const void *from[GP_LANES];
    itg word[8];
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        from[lane] = records[lane];
    lanes_load8(from, word);
    GP_UNROLL
    for (int i = 0; i < 8; i++)
        store_lanes(runs->word[i] + at, false, word[i]);
    return (msk)(word[KIND] == FAST_EDGES_64);
}

/* Four or eight components from `first` on, of a corner of each; flat: of that which has the flat
 * values. */
GP_INLINE void load_components(const FastTriangleRecord *const records[GP_LANES], int corner,
                               bool flat, int first, int components, itg v[8])
{
    const void *from[GP_LANES];
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        from[lane] = records[lane]->corner[flat ? records[lane]->flat : corner] + first;
    if (components > 4)
        lanes_load8(from, v);
    else
        lanes_load4(from, v);
}

/* Components of the corners, from `first` on, of which some are wanted. */
GP_INLINE void fetch_components(const FastTriangleRecord *const records[GP_LANES], uint32_t at,
                                int first, int components, unsigned wanted, unsigned flat,
                                FastLaneRuns *runs)
{
    itg v[3][8];
    if (wanted & flat) {
        load_components(records, 0, true, first, components, v[0]);
        GP_UNROLL
        for (int i = 0; i < components; i++)
            if (wanted & flat & 1u << i)
                flt_store(runs->corner[first + i][0] + at, (flt)v[0][i]);
    }
    if (!(wanted & ~flat))
        return;
    GP_UNROLL
    for (int k = 0; k < 3; k++)
        load_components(records, k, false, first, components, v[k]);
    GP_UNROLL
    for (int i = 0; i < components; i++) {
        if (!(wanted & ~flat & 1u << i))
            continue;
        flt_store(runs->corner[first + i][0] + at, (flt)v[0][i]);
        flt_store(runs->corner[first + i][1] + at, (flt)v[1][i] - (flt)v[0][i]);
        flt_store(runs->corner[first + i][2] + at, (flt)v[2][i] - (flt)v[0][i]);
    }
}

static void fetch_runs(const FastDraw *d, const FastTriangleRecord *records, FastLaneRuns *runs)
{
    const uint64_t wanted = d->needs.varyings, flat = d->modes.flat;
    msk wide = itg_set(0);
    store_lanes(runs->record + runs->count, false, itg_set((int32_t)runs->record[0]));
    for (uint32_t at = 0; at < runs->count; at += GP_LANES) {
        const FastTriangleRecord *record[GP_LANES];
        GP_UNROLL
        for (uint32_t lane = 0; lane < GP_LANES; lane++)
            record[lane] = &records[runs->record[at + lane]];
        wide |= fetch_words(record, at, runs);
        for (int first = 0; first < GP_MAX_VARYINGS && wanted >> first; first += 8) {
            const unsigned eight = wanted >> first & 0xff, flat8 = flat >> first & 0xff;
            if (eight >> 4)
                fetch_components(record, at, first, 8, eight, flat8, runs);
            else if (eight)
                fetch_components(record, at, first, 4, eight, flat8, runs);
        }
    }
    runs->wide = msk_bits(wide);
}

GP_INLINE itg spread_itg(const void *values, const Spread *spread)
{
    const itg all = load_lanes((const uint32_t *)values + spread->first, false);
    return LANES_SHARE ? itg_permute(all, spread->run) : all;
}

GP_INLINE flt spread_flt(const void *values, const Spread *spread)
{
    return (flt)spread_itg(values, spread);
}

/* --- triangles -------------------------------------------------------------------------------- */

/* Edge values and areas of triangles too large for 32 bits: exact, rounded once. */
static void set_edges_64(const Tile *tile, const FastGathered *gathered, flt edge[3], flt *area)
{
    for (int lane = 0; lane < GP_LANES; lane++) {
        const FastTriangleRecord *record = &tile->records->record[gathered->record[lane]];
        const FastEdges64 *edges = &tile->records->edges64[record->edges64];
        const int64_t x = gathered_x(gathered)[lane], y = gathered_y(gathered)[lane];
        if (record->kind != FAST_EDGES_64)
            continue;
        int64_t sum = 0;
        for (int i = 0; i < 3; i++) {
            const int64_t value = edges->edge.c[i] + edges->edge.a[i] * x + edges->edge.b[i] * y;
            edge[i][lane] = (float)value;
            sum += value;
        }
        (*area)[lane] = (float)sum;
    }
}

static void set_weights(const Tile *tile, const FastDraw *d, const FastGathered *gathered,
                        const Spread *spread, int p, FastWeights *weights)
{
    const FastLaneRuns *runs = tile->lane_runs;
    const itg area2 = spread_itg(runs->word[AREA], spread);
    itg left = area2;
    flt edge[3], area = flt_from_itg(area2);
    GP_UNROLL
    for (int i = 0; i < 2; i++) {
        itg first = spread_itg(runs->word[EDGE + 2 * i], spread);
        itg stepped = itg_dot2(spread_itg(runs->word[STEP + 2 * i], spread), gathered->place);
        itg value = (itg)((utg)first + ((utg)stepped << GP_SUBPIXEL_BITS));
        left = (itg)((utg)left - (utg)value);
        edge[1 + i] = flt_from_itg(value);
    }
    edge[0] = flt_from_itg(left);
    if (runs->wide)
        set_edges_64(tile, gathered, edge, &area);
    const flt ratio1 = spread_flt(runs->word[RATIO], spread);
    const flt ratio2 = spread_flt(runs->word[RATIO + 1], spread);
    const msk even = (msk)(ratio1 == 1.0f) & (msk)(ratio2 == 1.0f);
    const unsigned even_lanes = msk_bits(even);
    if (even_lanes != ALL_LANES)
        set_perspective(weights, p, edge[0], edge[1] * ratio1, edge[2] * ratio2);
    if (!even_lanes && !d->varyings_by[GP_LINEAR_SCREEN])
        return;
    const flt scale = 1.0f / area;
    GP_UNROLL
    for (int i = 0; i < 2; i++) {
        const flt screen = edge[1 + i] * scale;
        weights->screen[i][p] = screen;
        weights->perspective[i][p] =
            even_lanes == ALL_LANES ? screen : flt_select(even, screen, weights->perspective[i][p]);
    }
}

/* Neighbouring components of one mode: v0 + (s1 (v1 - v0) + s2 (v2 - v0)), with the differences at
 * hand. */
GP_INLINE void interpolate_neighbours(const FastLaneRuns *runs, const Spread *spread,
                                      const flt weight[2][FAST_BLOCK], int first, int components,
                                      int count, int stride, flt *in)
{
    for (int p = 0; p < count; p++, in += stride) {
        const Spread at = spread[p];
        const flt s1 = weight[0][p], s2 = weight[1][p];
        GP_UNROLL
        for (int i = 0; i < components; i++) {
            const float(*corner)[FAST_LANE_RUNS] = runs->corner[first + i];
            in[first + i] = spread_flt(corner[0], &at) +
                            (s1 * spread_flt(corner[1], &at) + s2 * spread_flt(corner[2], &at));
        }
    }
}

static void interpolate_components(const FastLaneRuns *runs, const Spread *spread,
                                   const flt weight[2][FAST_BLOCK], uint64_t components, int count,
                                   int stride, flt *in)
{
    while (components) {
        int first;
        const int found = take_neighbours(&components, 3, &first);
        if (found == 3)
            interpolate_neighbours(runs, spread, weight, first, 3, count, stride, in);
        else if (found == 2)
            interpolate_neighbours(runs, spread, weight, first, 2, count, stride, in);
        else
            interpolate_neighbours(runs, spread, weight, first, 1, count, stride, in);
    }
}

static void repeat_components(const FastLaneRuns *runs, const Spread *spread, uint64_t components,
                              int count, int stride, flt *in)
{
    for (uint64_t left = components; left; left &= left - 1) {
        const int c = __builtin_ctzll(left);
        for (int p = 0; p < count; p++)
            in[c + p * stride] = spread_flt(runs->corner[c][0], &spread[p]);
    }
}

static void interpolate_triangles(Tile *tile, const FastDraw *d, const FastGathered *gathered,
                                  int count, flt *in)
{
    const int stride = d->modes.components;
    FastLaneRuns *runs = tile->lane_runs;
    Spread spread[FAST_BLOCK];
    FastWeights weights;
    runs->count = 0;
    for (int p = 0; p < count; p++)
        spread[p] = add_runs(&gathered[p], runs);
    fetch_runs(d, tile->records->record, runs);
    for (int p = 0; p < count; p++)
        set_weights(tile, d, &gathered[p], &spread[p], p, &weights);
    interpolate_components(runs, spread, weights.perspective, d->varyings_by[GP_PERSPECTIVE], count,
                           stride, in);
    interpolate_components(runs, spread, weights.screen, d->varyings_by[GP_LINEAR_SCREEN], count,
                           stride, in);
    repeat_components(runs, spread, d->varyings_by[GP_FLAT], count, stride, in);
}

/* --- sprites ---------------------------------------------------------------------------------- */

/* Rare among opaque draws: a lane at a time. */
static void interpolate_sprites(const Tile *tile, const FastDraw *d, const FastGathered *gathered,
                                flt *in)
{
    for (int lane = 0; lane < GP_LANES; lane++) {
        const FastTriangleRecord *record = &tile->records->record[gathered->record[lane]];
        const FastEdges64 *edges = &tile->records->edges64[record->edges64];
        for (int c = 0; c < d->modes.components; c++)
            in[c][lane] = record->corner[0][c];
        if (d->modes.sprite < 0)
            continue;
        flt *at = in + d->modes.sprite;
        const int32_t x = gathered_x(gathered)[lane] * GP_SUBPIXELS;
        const int32_t y = gathered_y(gathered)[lane] * GP_SUBPIXELS;
        at[0][lane] = (float)(x - edges->sprite.left) * edges->sprite.per_step;
        at[1][lane] = (float)(y - edges->sprite.top) * edges->sprite.per_step;
    }
}

void fast_interpolate_gathered(Tile *tile, const FastDraw *d, const FastGathered *gathered,
                               int count, flt *in)
{
    const int components = d->modes.components;
    if (d->draw->geometry.primitive == GP_POINTS) {
        for (int p = 0; p < count; p++)
            interpolate_sprites(tile, d, &gathered[p], in + p * components);
        return;
    }
    interpolate_triangles(tile, d, gathered, count, in);
}
