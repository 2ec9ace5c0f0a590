/* What is seen: after the last opaque draw, every pixel that shows a record is shaded, once. */
#include "pipeline/fast/lanes/interpolate.h"
#include "pipeline/fast/lanes/patch.h"

#include <string.h>

/* --- mixes -------------------------------------------------------------------------------------- */

static Shares mixed_shares(const Tile *tile, const FastMix *mix)
{
    itg x = lane_bytes(mix->x), y = lane_bytes(mix->y);
    itg word[12];
    const void *at[GP_LANES];
    for (int part = 0; part < 3; part++) {
        GP_UNROLL
        for (int lane = 0; lane < GP_LANES; lane++)
            at[lane] = (const int32_t *)(const void *)&tile->records[mix->record[lane]] + 4 * part;
        lanes_load4(at, word + 4 * part);
    }
    /* c1 a1 b1 c2, a2 b2 inverse_area ratio1, ratio2 face kind wide */
    flt edge1 = flt_from_itg((itg)((utg)word[0] + (utg)word[1] * (utg)x + (utg)word[2] * (utg)y));
    flt edge2 = flt_from_itg((itg)((utg)word[3] + (utg)word[4] * (utg)x + (utg)word[5] * (utg)y));
    if (msk_bits((itg)(word[10] != FAST_SMALL)))
        GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++) {
        if (word[10][lane] == FAST_SMALL)
            continue;
        const FastWide *wide = &tile->wide[word[11][lane]];
        const int64_t px = mix->x[lane], py = mix->y[lane];
        edge1[lane] = (float)(wide->edge.c[0] + wide->edge.a[0] * px + wide->edge.b[0] * py);
        edge2[lane] = (float)(wide->edge.c[1] + wide->edge.a[1] * px + wide->edge.b[1] * py);
    }
    return shares_of(edge1, edge2, (flt)word[6], (flt)word[7], (flt)word[8]);
}

static void interpolate_mixed(const Tile *tile, const FastDraw *d, const FastMix *mix,
                              flt *in)
{
    Shares shares = mixed_shares(tile, mix);
    for (int first = 0; first < d->modes.components; first += 4) {
        if (!(d->needs.varyings >> first & 15))
            continue;
        itg v[3][4];
        for (int k = 0; k < 3; k++) {
            const void *at[GP_LANES];
            GP_UNROLL
            for (int lane = 0; lane < GP_LANES; lane++)
                at[lane] = tile->records[mix->record[lane]].corner[k] + first;
            lanes_load4(at, v[k]);
        }
        for (int c = first; c < first + 4 && c < d->modes.components; c++)
            in[c] = blend_corners(d->modes.mode[c], &shares, (flt)v[0][c - first],
                                  (flt)v[1][c - first], (flt)v[2][c - first]);
    }
}

/* Sprites are rare among opaque draws: a lane at a time. */
static void interpolate_sprites(const Tile *tile, const FastDraw *d, const FastMix *mix, flt *in)
{
    itg x = lane_bytes(mix->x) * GP_SUBPIXELS, y = lane_bytes(mix->y) * GP_SUBPIXELS;
    for (int lane = 0; lane < GP_LANES; lane++) {
        const FastRecord *r = &tile->records[mix->record[lane]];
        const FastWide *wide = &tile->wide[r->wide];
        for (int c = 0; c < d->modes.components; c++)
            in[c][lane] = r->corner[0][c];
        if (d->modes.sprite < 0)
            continue;
        flt *at = in + d->modes.sprite;
        at[0][lane] = (float)(x[lane] - wide->sprite.left) * wide->sprite.per_step;
        at[1][lane] = (float)(y[lane] - wide->sprite.top) * wide->sprite.per_step;
    }
}

static void shade_mixes(Tile *tile, const FastDraw *d, const FastMix *mixes, int count)
{
    const GpProgram *program = d->draw->program;
    flt *in = (flt *)(void *)tile->in;
    flt *pixel = (flt *)(void *)tile->pixel;
    for (int p = 0; p < count; p++) {
        const FastMix *mix = &mixes[p];
        if (tile->records[mix->record[0]].kind == FAST_SPRITE)
            interpolate_sprites(tile, d, mix, in + p * d->modes.components);
        else
            interpolate_mixed(tile, d, mix, in + p * d->modes.components);
        if (program->uses_pixel || program->local_reads) {
            pixel[2 * p] = flt_from_itg(lane_bytes(mix->x) + tile->x0);
            pixel[2 * p + 1] = flt_from_itg(lane_bytes(mix->y) + tile->y0);
        }
        for (int lane = 0; program->uses_face && lane < GP_LANES; lane++)
            tile->face[p * GP_LANES + lane] = tile->records[mix->record[lane]].face;
    }
    FAST(run_pixel_shader)(tile, d, count);
    int targets = gp_program_targets(program);
    const flt *color = (const flt *)(const void *)tile->color;
    for (int p = 0; p < count; p++)
        FAST(write_mix)(tile, d, &mixes[p], color + p * targets * 4);
}

/* --- collecting --------------------------------------------------------------------------------- */

/* Blocks that fill up with what is seen of one draw. */
typedef struct Collector {
    Tile *tile;
    const FastDraw *d;
    int patches;      /* rows of one triangle */
    int mixes, lanes; /* whole mixes; lanes of the next one */
} Collector;

static void shade_collected_mixes(Collector *c)
{
    if (c->lanes) { /* the last mix: repeat its first lane */
        FastMix *mix = &c->tile->mixes[c->mixes++];
        for (int lane = c->lanes; lane < GP_LANES; lane++) {
            mix->record[lane] = mix->record[0];
            mix->x[lane] = mix->x[0];
            mix->y[lane] = mix->y[0];
        }
        mix->live &= (1u << c->lanes) - 1;
    }
    if (c->mixes)
        shade_mixes(c->tile, c->d, c->tile->mixes, c->mixes);
    c->mixes = c->lanes = 0;
}

static void collect(Collector *c, uint32_t record, int32_t x, int32_t y, bool live)
{
    FastMix *mix = &c->tile->mixes[c->mixes];
    if (c->lanes == 0)
        mix->live = 0;
    mix->record[c->lanes] = record;
    mix->x[c->lanes] = (uint8_t)x;
    mix->y[c->lanes] = (uint8_t)y;
    mix->live |= (unsigned)live << c->lanes;
    if (++c->lanes < GP_LANES)
        return;
    c->lanes = 0;
    if (++c->mixes == FAST_BLOCK)
        shade_collected_mixes(c);
}

static void shade_collected_patches(Collector *c)
{
    if (c->patches)
        FAST(shade_patches)(c->tile, c->d, c->tile->patches, c->patches, NULL);
    c->patches = 0;
}

/* A whole row of one triangle's pixels. The queue of ordered draws is empty here: its room serves. */
static void collect_row(Collector *c, uint32_t record, int32_t x, int32_t y)
{
    c->tile->patches[c->patches++] = (FastPatch){ .record = record,
                                                  .live = (unsigned)((1ull << GP_LANES) - 1),
                                                  .x = (uint8_t)x,
                                                  .y = (uint8_t)y };
    if (c->patches == FAST_BLOCK)
        shade_collected_patches(c);
}

static void collect_pixels(Collector *c, uint32_t first, uint32_t end)
{
    const Tile *tile = c->tile;
    for (int32_t y = 0; y < tile->height; y++)
        for (int32_t x = 0; x < tile->width; x += GP_LANES) {
            itg seen;
            memcpy(&seen, tile->seen + fast_at(x, y), sizeof seen);
            unsigned mine = msk_bits((itg)(seen >= (int32_t)first) & (itg)(seen < (int32_t)end));
            if (!mine)
                continue;
            bool one = msk_bits((itg)(seen == seen[0])) == (unsigned)((1ull << GP_LANES) - 1);
            if (one && x + GP_LANES <= tile->width) {
                collect_row(c, (uint32_t)seen[0], x, y);
                continue;
            }
            for (; mine; mine &= mine - 1) {
                int lane = __builtin_ctz(mine);
                collect(c, (uint32_t)seen[lane], x + lane, y, true);
            }
        }
}

/* Quads, for shaders that look at their neighbours: one for each triangle seen in the 2x2 block. */
static void collect_quads(Collector *c, uint32_t first, uint32_t end)
{
    const Tile *tile = c->tile;
    for (int32_t y = 0; y < tile->height; y += 2)
        for (int32_t x = 0; x < tile->width; x += 2) {
            uint32_t seen[4];
            for (int i = 0; i < 4; i++) {
                bool inside = x + i % 2 < tile->width && y + i / 2 < tile->height;
                seen[i] = inside ? tile->seen[fast_at(x + i % 2, y + i / 2)] : FAST_NO_RECORD;
            }
            for (int i = 0; i < 4; i++) {
                bool earlier = false;
                for (int k = 0; k < i; k++)
                    earlier = earlier || seen[k] == seen[i];
                if (earlier || seen[i] < first || seen[i] >= end)
                    continue;
                for (int k = 0; k < 4; k++)
                    collect(c, seen[i], x + k % 2, y + k / 2, seen[k] == seen[i]);
            }
        }
}

void FAST(flush_seen)(Tile *tile)
{
    for (uint32_t i = 0; i < tile->run_count; i++) {
        uint32_t first = tile->runs[i].first_record;
        uint32_t end =
            i + 1 < tile->run_count ? tile->runs[i + 1].first_record : tile->record_count;
        Collector collector = { .tile = tile, .d = &tile->pass->draws[tile->runs[i].draw] };
        if (first == end || collector.d->route != FAST_VISIBLE)
            continue;
        if (collector.d->needs.quads)
            collect_quads(&collector, first, end);
        else
            collect_pixels(&collector, first, end);
        shade_collected_patches(&collector);
        shade_collected_mixes(&collector);
    }
    if (tile->record_count > FAST_NO_RECORD + 1)
        memset(tile->seen, 0, sizeof tile->seen);
    tile->record_count = FAST_NO_RECORD + 1;
    tile->run_count = tile->wide_count = 0;
}
