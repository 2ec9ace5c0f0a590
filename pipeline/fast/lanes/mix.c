/* Shading of mixes: the interpolants of every lane from its own triangle, in the model's operations. */
#include "pipeline/fast/lanes/mix.h"

#include "pipeline/fast/lanes/interpolate.h"

/* --- runs of lanes that share a triangle -------------------------------------------------------- */

/* Without shuffles by variable indices it is faster to fetch each lane's triangle by itself. */
enum { LANES_SHARE = GP_LANES > 4 };

/* Where in the runs the lanes of a mix find their values. */
typedef struct Spread {
    uint32_t first;
    itg run; /* from there on */
} Spread;

/* The runs of a mix, behind those of the mixes before it. */
static Spread add_runs(const FastMix *mix, FastLaneRuns *runs)
{
    itg left = itg_shift_in(mix->record, 0);
    unsigned starts = LANES_SHARE ? msk_bits(mix->record != left) | 1 : (1u << GP_LANES) - 1;
    Spread spread = { runs->count, itg_running_sum((itg)mask_of(starts) & 1) - 1 };
    itg_compress(runs->offset + runs->count, starts, mix->record * (int32_t)sizeof(FastRecord));
    runs->count += (uint32_t)__builtin_popcount(starts);
    return spread;
}

GP_INLINE void keep_lanes(void *to, itg lanes)
{
    __builtin_memcpy(to, &lanes, sizeof lanes);
}

GP_INLINE void load_words(const FastRecord *const record[GP_LANES], int first, itg word[4])
{
    const void *from[GP_LANES];
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        from[lane] = (const int32_t *)(const void *)record[lane] + first;
    lanes_load4(from, word);
}

/* A step of one pixel is that of a sub-pixel, which fits into 16 bits, times 256. */
GP_INLINE itg step_halves(itg right, itg down)
{
    return (right >> GP_SUBPIXEL_BITS & 0xffff) | down >> GP_SUBPIXEL_BITS << 16;
}

GP_INLINE void fetch_edges(const FastRecord *const record[GP_LANES], uint32_t at,
                           FastLaneRuns *runs)
{
    itg a[4], b[4], c[4]; /* c1 a1 b1 c2, a2 b2 inverse_area ratio1, ratio2 face kind wide */
    load_words(record, 0, a);
    load_words(record, 4, b);
    load_words(record, 8, c);
    keep_lanes(runs->edge[0] + at, a[0]);
    keep_lanes(runs->step[0] + at, step_halves(a[1], a[2]));
    keep_lanes(runs->edge[1] + at, a[3]);
    keep_lanes(runs->step[1] + at, step_halves(b[0], b[1]));
    keep_lanes(runs->inverse_area + at, b[2]);
    keep_lanes(runs->ratio1 + at, b[3]);
    keep_lanes(runs->ratio2 + at, c[0]);
    runs->wide |= msk_bits(c[2] == FAST_WIDE) != 0;
}

GP_INLINE void fetch_corners(const FastRecord *const record[GP_LANES], uint32_t at, uint64_t wanted,
                             FastLaneRuns *runs)
{
    for (int first = 0; first < GP_MAX_VARYINGS && wanted >> first; first += 4) {
        if (!(wanted >> first & 15))
            continue;
        itg v[3][4];
        GP_UNROLL
        for (int k = 0; k < 3; k++) {
            const void *from[GP_LANES];
            GP_UNROLL
            for (int lane = 0; lane < GP_LANES; lane++)
                from[lane] = record[lane]->corner[k] + first;
            lanes_load4(from, v[k]);
        }
        GP_UNROLL
        for (int i = 0; i < 4; i++) {
            flt_store(runs->corner[first + i][0] + at, (flt)v[0][i]);
            flt_store(runs->corner[first + i][1] + at, (flt)v[1][i] - (flt)v[0][i]);
            flt_store(runs->corner[first + i][2] + at, (flt)v[2][i] - (flt)v[0][i]);
        }
    }
}

static void fetch_runs(const Tile *tile, uint64_t wanted, FastLaneRuns *runs)
{
    const uint8_t *records = (const uint8_t *)tile->records;
    runs->wide = false;
    keep_lanes(runs->offset + runs->count, itg_set((int32_t)runs->offset[0]));
    for (uint32_t at = 0; at < runs->count; at += GP_LANES) {
        const FastRecord *record[GP_LANES];
        GP_UNROLL
        for (uint32_t lane = 0; lane < GP_LANES; lane++)
            record[lane] = (const FastRecord *)(const void *)(records + runs->offset[at + lane]);
        fetch_edges(record, at, runs);
        fetch_corners(record, at, wanted, runs);
    }
}

GP_INLINE itg spread_itg(const void *values, const Spread *spread)
{
    itg all;
    __builtin_memcpy(&all, (const uint32_t *)values + spread->first, sizeof all);
    return LANES_SHARE ? itg_pick(all, spread->run) : all;
}

GP_INLINE flt spread_flt(const float *values, const Spread *spread)
{
    return (flt)spread_itg(values, spread);
}

/* --- triangles ---------------------------------------------------------------------------------- */

/* Edge values of triangles too large for 32 bits: exact, rounded once. */
static void set_wide_edges(const Tile *tile, const FastMix *mix, flt edge[2])
{
    for (int lane = 0; lane < GP_LANES; lane++) {
        const FastRecord *record = &tile->records[mix->record[lane]];
        const FastWide *wide = &tile->wide[record->wide];
        const int64_t x = mix->x[lane], y = mix->y[lane];
        for (int i = 0; i < 2 && record->kind == FAST_WIDE; i++)
            edge[i][lane] = (float)(wide->edge.c[i] + wide->edge.a[i] * x + wide->edge.b[i] * y);
    }
}

static Shares mixed_shares(const Tile *tile, const FastMix *mix, const Spread *spread)
{
    const FastLaneRuns *runs = &tile->lane_runs;
    const itg place = mix->x | mix->y << 16;
    flt edge[2];
    GP_UNROLL
    for (int i = 0; i < 2; i++) {
        utg moved = (utg)itg_dot2(spread_itg(runs->step[i], spread), place) << GP_SUBPIXEL_BITS;
        edge[i] = flt_from_itg((itg)((utg)spread_itg(runs->edge[i], spread) + moved));
    }
    if (runs->wide)
        set_wide_edges(tile, mix, edge);
    return shares_of(edge[0], edge[1], spread_flt(runs->inverse_area, spread),
                     spread_flt(runs->ratio1, spread), spread_flt(runs->ratio2, spread));
}

/* v0 + (s1 (v1 - v0) + s2 (v2 - v0)), with the differences at hand. */
static void interpolate_triangles(const Tile *tile, const FastDraw *d, const FastMix *mix,
                                  const Spread *spread, flt *in)
{
    const Shares shares = mixed_shares(tile, mix, spread);
    for (uint64_t left = d->needs.varyings; left; left &= left - 1) {
        const int c = __builtin_ctzll(left);
        const float(*corner)[FAST_LANE_RUNS] = tile->lane_runs.corner[c];
        const bool screen = d->modes.mode[c] == GP_LINEAR_SCREEN;
        const flt *s = screen ? shares.screen : shares.perspective;
        flt value = spread_flt(corner[0], spread);
        if (d->modes.mode[c] != GP_FLAT)
            value += s[0] * spread_flt(corner[1], spread) + s[1] * spread_flt(corner[2], spread);
        in[c] = value;
    }
}

/* --- sprites ------------------------------------------------------------------------------------ */

/* Rare among opaque draws: a lane at a time. */
static void interpolate_sprites(const Tile *tile, const FastDraw *d, const FastMix *mix, flt *in)
{
    for (int lane = 0; lane < GP_LANES; lane++) {
        const FastRecord *record = &tile->records[mix->record[lane]];
        const FastWide *wide = &tile->wide[record->wide];
        for (int c = 0; c < d->modes.components; c++)
            in[c][lane] = record->corner[0][c];
        if (d->modes.sprite < 0)
            continue;
        flt *at = in + d->modes.sprite;
        int32_t x = mix->x[lane] * GP_SUBPIXELS, y = mix->y[lane] * GP_SUBPIXELS;
        at[0][lane] = (float)(x - wide->sprite.left) * wide->sprite.per_step;
        at[1][lane] = (float)(y - wide->sprite.top) * wide->sprite.per_step;
    }
}

/* --- shading ------------------------------------------------------------------------------------ */

static void set_faces(const Tile *tile, const FastMix *mix, float *face)
{
    for (int lane = 0; lane < GP_LANES; lane++)
        face[lane] = tile->records[mix->record[lane]].face;
}

void FAST(interpolate_mixes)(Tile *tile, const FastDraw *d, const FastMix *mixes, int count,
                             flt *in)
{
    const int components = d->modes.components;
    if (d->draw->geometry.primitive == GP_POINTS) {
        for (int p = 0; p < count; p++)
            interpolate_sprites(tile, d, &mixes[p], in + p * components);
        return;
    }
    Spread spread[FAST_BLOCK];
    tile->lane_runs.count = 0;
    for (int p = 0; p < count; p++)
        spread[p] = add_runs(&mixes[p], &tile->lane_runs);
    fetch_runs(tile, d->needs.varyings, &tile->lane_runs);
    for (int p = 0; p < count; p++)
        interpolate_triangles(tile, d, &mixes[p], &spread[p], in + p * components);
}

void FAST(shade_mixes)(Tile *tile, const FastDraw *d, const FastMix *mixes, int count)
{
    const GpProgram *program = d->draw->program;
    flt *pixel = (flt *)(void *)tile->pixel;
    FAST(interpolate_mixes)(tile, d, mixes, count, (flt *)(void *)tile->in);
    for (int p = 0; p < count; p++) {
        if (program->uses_pixel || program->local_reads) {
            pixel[2 * p] = flt_from_itg(mixes[p].x + tile->x0);
            pixel[2 * p + 1] = flt_from_itg(mixes[p].y + tile->y0);
        }
        if (program->uses_face)
            set_faces(tile, &mixes[p], tile->face + p * GP_LANES);
    }
    FAST(run_pixel_shader)(tile, d, NULL, count);
    for (int p = 0; p < count; p++)
        tile->fragments_shaded += (uint64_t)__builtin_popcount(mixes[p].live);
    FAST(write_mixes)(tile, d, mixes, count, (const flt *)(const void *)tile->color);
}
