/* Large triangles and point sprites: their rows, a lane vector at a time. */
#include "pipeline/fast/lanes/route.h"

/* --- edges inside the tile -------------------------------------------------------------------------------- */

/* An edge function in 1/256ths of its exact value: pixel steps are multiples of 256 sub-pixels, so
 * its low eight bits never change, and the sign of the rest decides. In 32 bits, because an edge
 * that has one sign all over the tile is replaced by a constant. */
typedef struct TileEdge {
    int32_t value, right, down; /* at the tile's first centre; a pixel to the right; one down */
} TileEdge;

typedef struct Coverage {
    TileEdge edge[3];
    int32_t x0, y0, x1, y1; /* in the tile, ends included */
    bool whole;             /* every pixel of the box is inside */
} Coverage;

static int64_t edge_at_origin(const Tile *tile, const GpTriangle *t, int i)
{
    int64_t x = (int64_t)tile->x0 * GP_SUBPIXELS + GP_SUBPIXELS / 2;
    int64_t y = (int64_t)tile->y0 * GP_SUBPIXELS + GP_SUBPIXELS / 2;
    return t->a[i] * x + t->b[i] * y + t->c[i];
}

/* Returns false where the edge leaves no pixel of the box inside. */
static bool set_edge(const Tile *tile, const GpTriangle *t, int i, Coverage *coverage)
{
    int64_t value = (edge_at_origin(tile, t, i) - !t->accepts_zero[i]) >> GP_SUBPIXEL_BITS;
    int64_t right = t->a[i], down = t->b[i];
    int64_t first = value + right * coverage->x0 + down * coverage->y0;
    int64_t across = right * (coverage->x1 - coverage->x0);
    int64_t along = down * (coverage->y1 - coverage->y0);
    int64_t low = first + (across < 0 ? across : 0) + (along < 0 ? along : 0);
    int64_t high = first + (across > 0 ? across : 0) + (along > 0 ? along : 0);
    if (high < 0)
        return false;
    coverage->edge[i] = (TileEdge){ 0, 0, 0 };
    if (low >= 0)
        return true;
    coverage->edge[i] = (TileEdge){ (int32_t)value, (int32_t)right, (int32_t)down };
    coverage->whole = false;
    return true;
}

static bool find_coverage(const Tile *tile, const GpTriangle *t, Coverage *coverage)
{
    *coverage = (Coverage){ .x0 = t->x0 - tile->x0,
                            .y0 = t->y0 - tile->y0,
                            .x1 = t->x1 - tile->x0,
                            .y1 = t->y1 - tile->y0,
                            .whole = true };
    for (int i = 0; i < 3; i++)
        if (!set_edge(tile, t, i, coverage))
            return false;
    return true;
}

/* Lanes x .. x + GP_LANES - 1 of row y that are covered. */
GP_INLINE unsigned covered(const Coverage *coverage, int32_t x, int32_t y, itg lanes)
{
    itg inside = coverage->x1 - x - lanes; /* negative right of the box */
    for (int i = 0; i < 3; i++) {
        const TileEdge *e = &coverage->edge[i];
        int32_t start = (int32_t)((uint32_t)e->value + (uint32_t)e->right * (uint32_t)x +
                                  (uint32_t)e->down * (uint32_t)y);
        inside |= (itg)((utg)(lanes * e->right) + (uint32_t)start);
    }
    return msk_bits(inside >= 0);
}

/* --- depth ----------------------------------------------------------------------------------------------------- */

/* z_base + (E_1 k_1 + E_2 k_2), with the exact edge values in binary64 (CONVENTIONS.md). */
typedef struct DepthPlane {
    double base, step[2];
    double edge[2], right[2], down[2];
    float low, high;
    dbl lanes[2]; /* lane number * right */
} DepthPlane;

static DepthPlane depth_plane(const Tile *tile, const GpTriangle *t)
{
    DepthPlane plane = { .base = t->z_base,
                         .step = { t->z_step[0], t->z_step[1] },
                         .low = tile->draw->viewport.min_depth,
                         .high = tile->draw->viewport.max_depth };
    for (int i = 0; i < 2; i++) {
        plane.edge[i] = (double)edge_at_origin(tile, t, i + 1);
        plane.right[i] = (double)(t->a[i + 1] * GP_SUBPIXELS);
        plane.down[i] = (double)(t->b[i + 1] * GP_SUBPIXELS);
        plane.lanes[i] = dbl_from_itg(lane_numbers()) * plane.right[i];
    }
    return plane;
}

GP_INLINE flt depth_at(const DepthPlane *p, int32_t x, int32_t y)
{
    double e1 = p->edge[0] + p->right[0] * x + p->down[0] * y; /* exact: integers below 2^53 */
    double e2 = p->edge[1] + p->right[1] * x + p->down[1] * y;
    dbl z = p->base + ((e1 + p->lanes[0]) * p->step[0] + (e2 + p->lanes[1]) * p->step[1]);
    flt depth = __builtin_convertvector(z, flt);
    depth = flt_select(depth < p->low, flt_set(p->low), depth);
    return flt_select(depth > p->high, flt_set(p->high), depth);
}

/* --- user clip planes ------------------------------------------------------------------------------------------- */

/* The slow way, pixel by pixel: the reference's own units on a quad. */
static unsigned inside_clip_planes(const Tile *tile, const GpTriangle *t, int32_t x, int32_t y,
                                   unsigned mask)
{
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++) {
        if (!(mask >> lane & 1))
            continue;
        int64_t center_x = (int64_t)(tile->x0 + x + lane) * GP_SUBPIXELS + GP_SUBPIXELS / 2;
        int64_t center_y = (int64_t)(tile->y0 + y) * GP_SUBPIXELS + GP_SUBPIXELS / 2;
        GpQuad quad = { .mask = 1 };
        for (int i = 0; i < 3; i++)
            quad.edge[i][0] = t->a[i] * center_x + t->b[i] * center_y + t->c[i];
        gp_interpolate_barycentrics(t, &quad);
        gp_interpolate_clip(t, tile->draw->needs.clip_planes, &quad);
        if (!quad.mask)
            mask &= ~(1u << lane);
    }
    return mask;
}

/* --- filling ------------------------------------------------------------------------------------- */

/* Two rows of lanes that have passed, from even x and y on, as two patches of quads. */
static void queue_two_rows(const Filler *f, int32_t x, int32_t y, const unsigned live[2],
                           const flt depth[2])
{
    enum { WIDE = GP_LANES / 2 };
    for (int part = 0; part < 2; part++) {
        unsigned quads = 0;
        flt z;
        GP_UNROLL
        for (int lane = 0; lane < GP_LANES; lane++) {
            int row = lane % 4 / 2, column = part * WIDE + lane / 4 * 2 + lane % 2;
            quads |= (live[row] >> column & 1) << lane;
            z[lane] = depth[row][column];
        }
        if (quads)
            FAST(queue_quads)(f->tile, f->number, x + part * WIDE, y, quads, z);
    }
}

static void fill_covered(const Filler *f, const GpTriangle *t, const Coverage *coverage)
{
    const FastDraw *d = f->d;
    const bool quads = d->route == FAST_ORDERED && d->needs.quads;
    const itg lanes = lane_numbers();
    DepthPlane plane = depth_plane(f->tile, t);
    int32_t first_x = quads ? coverage->x0 & ~1 : coverage->x0;
    int32_t first_y = quads ? coverage->y0 & ~1 : coverage->y0;
    unsigned live[2] = { 0, 0 };
    flt z[2] = { flt_set(0), flt_set(0) };
    for (int32_t y = first_y; y <= coverage->y1; y += 1 + quads)
        for (int32_t x = first_x; x <= coverage->x1; x += GP_LANES) {
            for (int row = 0; row < 1 + quads; row++) {
                bool in_box = y + row >= coverage->y0 && y + row <= coverage->y1;
                live[row] = in_box ? covered(coverage, x, y + row, lanes) : 0;
                if (x < coverage->x0)
                    live[row] &= ~1u;
                if (d->needs.clip_planes && live[row])
                    live[row] = inside_clip_planes(f->tile, t, x, y + row, live[row]);
                if (live[row] && d->wants_depth)
                    z[row] = depth_at(&plane, x, y + row);
                if (live[row])
                    live[row] = FAST(route_lanes)(f, x, y + row, live[row], z[row]);
            }
            if (quads && (live[0] | live[1]))
                queue_two_rows(f, x, y, live, z);
        }
}

void FAST(fill_triangle)(Tile *tile, const GpTriangle *t)
{
    const FastDraw *d = tile->draw;
    Coverage coverage;
    if (!find_coverage(tile, t, &coverage))
        return;
    Filler filler = { .tile = tile, .d = d, .front = t->front };
    if (d->route != FAST_DEPTH_ONLY) {
        FAST(reserve_records)(tile, 1);
        filler.number = tile->record_count++;
        FastRecord *record = &tile->records[filler.number];
        FastWide *wide = &tile->wide[tile->wide_count];
        *record = (FastRecord){ .inverse_area = t->inverse_area,
                                .ratio1 = t->rw_ratio[0],
                                .ratio2 = t->rw_ratio[1],
                                .face = t->front ? 1.0f : -1.0f,
                                .kind = FAST_WIDE,
                                .wide = tile->wide_count++ };
        for (int i = 0; i < 3; i++)
            record->corner[i] = t->corner[i].varying;
        for (int i = 0; i < 2; i++) {
            wide->edge.c[i] = edge_at_origin(tile, t, i + 1);
            wide->edge.a[i] = t->a[i + 1] * GP_SUBPIXELS;
            wide->edge.b[i] = t->b[i + 1] * GP_SUBPIXELS;
        }
    }
    fill_covered(&filler, t, &coverage);
}

void FAST(fill_sprite)(Tile *tile, const GpPointSprite *s, const float *varying)
{
    const FastDraw *d = tile->draw;
    Filler filler = { .tile = tile, .d = d, .front = true };
    if (d->route != FAST_DEPTH_ONLY) {
        FAST(reserve_records)(tile, 1);
        filler.number = tile->record_count++;
        FastWide *wide = &tile->wide[tile->wide_count];
        tile->records[filler.number] = (FastRecord){ .face = 1.0f,
                                                     .kind = FAST_SPRITE,
                                                     .wide = tile->wide_count++,
                                                     .corner = { varying, varying, varying } };
        wide->sprite.left = s->left - tile->x0 * GP_SUBPIXELS - GP_SUBPIXELS / 2;
        wide->sprite.top = s->top - tile->y0 * GP_SUBPIXELS - GP_SUBPIXELS / 2;
        wide->sprite.per_step = 1.0f / (float)(s->right - s->left);
    }
    /* a square has no edges but its box, and one depth */
    Coverage coverage = { .x0 = s->x0 - tile->x0,
                          .y0 = s->y0 - tile->y0,
                          .x1 = s->x1 - tile->x0,
                          .y1 = s->y1 - tile->y0,
                          .whole = true };
    GpTriangle flat = { .z_base = (double)s->center.z };
    fill_covered(&filler, &flat, &coverage);
}
