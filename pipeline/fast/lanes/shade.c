/* Shading: interpolants of packets, one call of the pixel shader for a block, late tests, merging. */
#include "pipeline/fast/lanes/tile.h"

#include "pipeline/compare.h"
#include "pipeline/fast/sampler.h"
#include "pipeline/texture_read.h"

#include <string.h>

/* --- interpolation ------------------------------------------------------------------------------ */

/* Barycentrics of a packet: shares on the screen, and perspective-correct ones. */
typedef struct Shares {
    flt screen[2], perspective[2];
} Shares;

static itg lane_bytes(const uint8_t bytes[GP_LANES])
{
    typedef uint8_t byte_lanes __attribute__((vector_size(GP_LANES)));
    byte_lanes packed;
    memcpy(&packed, bytes, sizeof packed);
    return __builtin_convertvector(packed, itg);
}

GP_INLINE Shares shares_of(flt edge1, flt edge2, flt inverse_area, flt ratio1, flt ratio2)
{
    Shares s;
    s.screen[0] = edge1 * inverse_area;
    s.screen[1] = edge2 * inverse_area;
    flt rw = 1.0f + (s.screen[0] * (ratio1 - 1.0f) + s.screen[1] * (ratio2 - 1.0f));
    flt w = 1.0f / rw;
    s.perspective[0] = s.screen[0] * ratio1 * w;
    s.perspective[1] = s.screen[1] * ratio2 * w;
    return s;
}

/* Edge values of a large triangle: exact in binary64, rounded once. */
static flt wide_edge(const FastWide *wide, int i, itg x, itg y)
{
    dbl value = (double)wide->edge.c[i] + (dbl_from_itg(x) * (double)wide->edge.a[i] +
                                           dbl_from_itg(y) * (double)wide->edge.b[i]);
    return __builtin_convertvector(value, flt);
}

static Shares uniform_shares(const Tile *tile, const FastPacket *packet)
{
    const FastRecord *r = packet->record[0];
    itg x = lane_bytes(packet->x), y = lane_bytes(packet->y);
    flt edge1, edge2;
    if (r->kind == FAST_SMALL) {
        edge1 = flt_from_itg((itg)((utg)(x * r->a1 + y * r->b1) + (uint32_t)r->c1));
        edge2 = flt_from_itg((itg)((utg)(x * r->a2 + y * r->b2) + (uint32_t)r->c2));
    } else {
        edge1 = wide_edge(&tile->wide[r->wide], 0, x, y);
        edge2 = wide_edge(&tile->wide[r->wide], 1, x, y);
    }
    return shares_of(edge1, edge2, flt_set(r->inverse_area), flt_set(r->ratio1),
                     flt_set(r->ratio2));
}

static Shares mixed_shares(const Tile *tile, const FastPacket *packet)
{
    itg x = lane_bytes(packet->x), y = lane_bytes(packet->y);
    itg word[12];
    const void *at[GP_LANES];
    for (int part = 0; part < 3; part++) {
        GP_UNROLL
        for (int lane = 0; lane < GP_LANES; lane++)
            at[lane] = (const int32_t *)(const void *)packet->record[lane] + 4 * part;
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
        const int64_t px = packet->x[lane], py = packet->y[lane];
        edge1[lane] = (float)(wide->edge.c[0] + wide->edge.a[0] * px + wide->edge.b[0] * py);
        edge2[lane] = (float)(wide->edge.c[1] + wide->edge.a[1] * px + wide->edge.b[1] * py);
    }
    return shares_of(edge1, edge2, (flt)word[6], (flt)word[7], (flt)word[8]);
}

GP_INLINE flt blend_corners(GpInterpolation mode, const Shares *shares, flt v0, flt v1, flt v2)
{
    if (mode == GP_FLAT)
        return v0;
    const flt *s = mode == GP_LINEAR_SCREEN ? shares->screen : shares->perspective;
    return v0 + (s[0] * (v1 - v0) + s[1] * (v2 - v0));
}

static void interpolate_uniform(const Tile *tile, const FastDraw *d, const FastPacket *packet,
                                flt *in)
{
    Shares shares = uniform_shares(tile, packet);
    const float *const *corner = packet->record[0]->corner;
    for (int c = 0; c < d->modes.components; c++)
        if (d->needs.varyings >> c & 1)
            in[c] = blend_corners(d->modes.mode[c], &shares, flt_set(corner[0][c]),
                                  flt_set(corner[1][c]), flt_set(corner[2][c]));
}

static void interpolate_mixed(const Tile *tile, const FastDraw *d, const FastPacket *packet,
                              flt *in)
{
    Shares shares = mixed_shares(tile, packet);
    for (int first = 0; first < d->modes.components; first += 4) {
        if (!(d->needs.varyings >> first & 15))
            continue;
        itg v[3][4];
        for (int k = 0; k < 3; k++) {
            const void *at[GP_LANES];
            GP_UNROLL
            for (int lane = 0; lane < GP_LANES; lane++)
                at[lane] = packet->record[lane]->corner[k] + first;
            lanes_load4(at, v[k]);
        }
        for (int c = first; c < first + 4 && c < d->modes.components; c++)
            in[c] = blend_corners(d->modes.mode[c], &shares, (flt)v[0][c - first],
                                  (flt)v[1][c - first], (flt)v[2][c - first]);
    }
}

static void interpolate_sprites(const Tile *tile, const FastDraw *d, const FastPacket *packet,
                                flt *in)
{
    itg x = lane_bytes(packet->x) * GP_SUBPIXELS, y = lane_bytes(packet->y) * GP_SUBPIXELS;
    if (packet->uniform) {
        const FastRecord *r = packet->record[0];
        const FastWide *wide = &tile->wide[r->wide];
        for (int c = 0; c < d->modes.components; c++)
            in[c] = flt_set(r->corner[0][c]);
        if (d->modes.sprite < 0)
            return;
        in[d->modes.sprite] = flt_from_itg(x - wide->sprite.left) * wide->sprite.per_step;
        in[d->modes.sprite + 1] = flt_from_itg(y - wide->sprite.top) * wide->sprite.per_step;
        return;
    }
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++) {
        const FastRecord *r = packet->record[lane];
        const FastWide *wide = &tile->wide[r->wide];
        for (int c = 0; c < d->modes.components; c++)
            in[c][lane] = r->corner[0][c];
        if (d->modes.sprite < 0)
            continue;
        in[d->modes.sprite][lane] = (float)(x[lane] - wide->sprite.left) * wide->sprite.per_step;
        in[d->modes.sprite + 1][lane] = (float)(y[lane] - wide->sprite.top) * wide->sprite.per_step;
    }
}

/* --- one block ------------------------------------------------------------------------------------------------ */

static void fill_call(Tile *tile, const FastDraw *d, const FastPacket *packets, int count)
{
    const GpProgram *program = d->draw->program;
    flt *in = (flt *)(void *)tile->in;
    for (int p = 0; p < count; p++) {
        const FastPacket *packet = &packets[p];
        flt *to = in + p * d->modes.components;
        if (packet->record[0]->kind == FAST_SPRITE)
            interpolate_sprites(tile, d, packet, to);
        else if (packet->uniform)
            interpolate_uniform(tile, d, packet, to);
        else
            interpolate_mixed(tile, d, packet, to);
        if (program->uses_pixel || program->local_reads) {
            flt x = flt_from_itg(lane_bytes(packet->x) + tile->x0);
            flt y = flt_from_itg(lane_bytes(packet->y) + tile->y0);
            memcpy(tile->pixel + 2 * p * GP_LANES, &x, sizeof x);
            memcpy(tile->pixel + (2 * p + 1) * GP_LANES, &y, sizeof y);
        }
        for (int lane = 0; program->uses_face && lane < GP_LANES; lane++)
            tile->face[p * GP_LANES + lane] = packet->record[packet->uniform ? 0 : lane]->face;
    }
}

/* Lanes of a shaded packet that pass the tests which had to wait. */
static unsigned late_tests(Tile *tile, const FastDraw *d, const FastPacket *packet, int number)
{
    const GpState *state = &d->draw->state;
    unsigned live = packet->live;
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++) {
        if (!(live >> lane & 1))
            continue;
        bool lives = !d->draw->program->may_discard || !tile->killed[number * GP_LANES + lane];
        if (lives && d->needs.alpha_test) {
            int targets = gp_program_targets(d->draw->program);
            float alpha = tile->color[(number * targets * 4 + 3) * GP_LANES + lane];
            lives = gp_compare_floats(state->alpha_test.test, alpha,
                                      gp_float_from_unorm(state->alpha_test.reference, 8));
        }
        if (lives && d->late_depth) {
            float z = d->draw->program->writes_depth ? tile->shader_depth[number * GP_LANES + lane]
                                                     : packet->depth[lane];
            z = z < d->viewport.min_depth   ? d->viewport.min_depth
                : z > d->viewport.max_depth ? d->viewport.max_depth
                                            : z;
            uint32_t at = fast_at(packet->x[lane], packet->y[lane]);
            const FastRecord *record = packet->record[packet->uniform ? 0 : lane];
            lives = FAST(depth_stencil)(tile, d, at, 1, flt_set(z), record->face > 0);
        }
        if (!lives)
            live &= ~(1u << lane);
    }
    return live;
}

static void shade_block(Tile *tile, const FastDraw *d, const FastPacket *packets, int count)
{
    const GpProgram *program = d->draw->program;
    fill_call(tile, d, packets, count);
    GpShaderCall call = {
        .uniforms = d->draw->uniforms,
        .packets = count,
        .in = tile->in,
        .textures = d->draw->textures,
        .read_texture = FAST(read_texture),
        .executor = d->samplers,
        .read_local = gp_read_local_plain,
        .pixel = tile->pixel,
        .face = tile->face,
        .color = tile->color,
        .depth = program->writes_depth ? tile->shader_depth : NULL,
        .killed = program->may_discard ? tile->killed : NULL,
    };
    d->code->pixel(&call);
    int targets = gp_program_targets(program);
    const flt *color = (const flt *)(const void *)tile->color;
    bool late = program->may_discard || d->needs.alpha_test || d->late_depth;
    for (int p = 0; p < count; p++) {
        unsigned live = late ? late_tests(tile, d, &packets[p], p) : packets[p].live;
        if (live && d->needs.color)
            FAST(merge)(tile, d, &packets[p], live, color + p * targets * 4);
    }
}

void FAST(flush_packets)(Tile *tile)
{
    if (!tile->packet_count)
        return;
    for (uint32_t p = 0; p < tile->packet_count; p++)
        GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        tile->pending[tile->packets[p].y[lane]] = 0;
    shade_block(tile, tile->draw, tile->packets, (int)tile->packet_count);
    tile->packet_count = 0;
}

/* --- what is seen ------------------------------------------------------------------------------------------------- */

/* A block of packets that fills up with pixels of any triangles of one draw. */
typedef struct Collector {
    Tile *tile;
    const FastDraw *d;
    int packets, lanes; /* whole packets; lanes of the next one */
} Collector;

static void shade_collected(Collector *c)
{
    if (c->lanes) { /* the last packet: repeat its first lane */
        FastPacket *packet = &c->tile->packets[c->packets++];
        for (int lane = c->lanes; lane < GP_LANES; lane++) {
            packet->record[lane] = packet->record[0];
            packet->x[lane] = packet->x[0];
            packet->y[lane] = packet->y[0];
        }
        packet->live &= (1u << c->lanes) - 1;
    }
    if (c->packets)
        shade_block(c->tile, c->d, c->tile->packets, c->packets);
    c->packets = c->lanes = 0;
}

static void collect(Collector *c, uint32_t record, int32_t x, int32_t y, bool live)
{
    FastPacket *packet = &c->tile->packets[c->packets];
    if (c->lanes == 0) {
        packet->live = 0;
        packet->uniform = packet->row = false;
    }
    packet->record[c->lanes] = &c->tile->records[record];
    packet->x[c->lanes] = (uint8_t)x;
    packet->y[c->lanes] = (uint8_t)y;
    packet->live |= (unsigned)live << c->lanes;
    if (++c->lanes < GP_LANES)
        return;
    c->lanes = 0;
    if (++c->packets == FAST_BLOCK)
        shade_collected(c);
}

/* A whole packet of one triangle's pixels, side by side. */
static void collect_row(Collector *c, uint32_t record, int32_t x, int32_t y)
{
    Tile *tile = c->tile;
    if (c->lanes) { /* the packet that is being filled moves on by one */
        tile->packets[c->packets + 1] = tile->packets[c->packets];
    }
    FastPacket *packet = &tile->packets[c->packets];
    packet->record[0] = &tile->records[record];
    packet->uniform = packet->row = true;
    packet->live = (unsigned)((1ull << GP_LANES) - 1);
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++) {
        packet->x[lane] = (uint8_t)(x + lane);
        packet->y[lane] = (uint8_t)y;
    }
    if (++c->packets < FAST_BLOCK)
        return;
    /* keep the packet that is being filled: shade the whole ones only */
    FastPacket filling = tile->packets[FAST_BLOCK];
    int lanes = c->lanes;
    c->lanes = 0;
    shade_collected(c);
    tile->packets[0] = filling;
    c->lanes = lanes;
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
        shade_collected(&collector);
    }
    if (tile->record_count > FAST_NO_RECORD + 1)
        memset(tile->seen, 0, sizeof tile->seen);
    tile->record_count = FAST_NO_RECORD + 1;
    tile->run_count = tile->wide_count = 0;
}
