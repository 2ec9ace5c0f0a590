/* Large triangles: their rows, a lane vector at a time. */
#include "pipeline/fast/lanes/raster/fill.h"

/* --- edges inside the tile -------------------------------------------------------------------- */

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

/* --- lanes ------------------------------------------------------------------------------------ */

/* Lanes of a row, or of quads: their places, and how far depth steps from the first to each. */
typedef struct LaneSteps {
    itg column, row;
    dbl edge[2];
} LaneSteps;

static LaneSteps lane_steps(const GpTriangle *t, bool quads)
{
    LaneSteps steps = { .column = lane_columns(quads), .row = lane_rows(quads) };
    for (int i = 0; i < 2; i++)
        steps.edge[i] = dbl_from_itg(steps.column) * (double)(t->a[i + 1] * GP_SUBPIXELS) +
                        dbl_from_itg(steps.row) * (double)(t->b[i + 1] * GP_SUBPIXELS);
    return steps;
}

/* What a row, or two of quads, has inside: of the lanes from a place on, numbers that are negative
 * where one is outside. The place moves to the right. */
typedef struct InsideRow {
    utg edge[3], across[3]; /* values, and what a step adds */
    itg right, left;        /* pixels to the box's ends */
    itg rows;               /* the same up and down, which no step changes */
} InsideRow;

GP_INLINE InsideRow inside_row(const Coverage *coverage, const LaneSteps *steps, bool whole,
                               int32_t x, int32_t y, int32_t wide)
{
    const itg column = steps->column + x, row = steps->row + y;
    InsideRow inside = { .right = coverage->x1 - column,
                         .left = column - coverage->x0,
                         .rows = (coverage->y1 - row) | (row - coverage->y0) };
    GP_UNROLL
    for (int i = 0; i < 3 && !whole; i++) {
        const TileEdge *e = &coverage->edge[i];
        inside.edge[i] =
            (utg)column * (uint32_t)e->right + (utg)row * (uint32_t)e->down + (uint32_t)e->value;
        inside.across[i] = (utg)itg_set((int32_t)((uint32_t)e->right * (uint32_t)wide));
    }
    return inside;
}

/* Lanes that are covered. */
GP_INLINE msk covered_lanes(const InsideRow *inside, bool whole)
{
    itg out = inside->right | inside->left | inside->rows;
    GP_UNROLL
    for (int i = 0; i < 3 && !whole; i++)
        out |= (itg)inside->edge[i];
    return (msk)(out >= 0);
}

/* The same; moves on. */
GP_INLINE msk step_right(InsideRow *inside, bool whole, int32_t wide)
{
    const msk covered = covered_lanes(inside, whole);
    GP_UNROLL
    for (int i = 0; i < 3 && !whole; i++)
        inside->edge[i] += inside->across[i];
    inside->right -= wide;
    inside->left += wide;
    return covered;
}

/* z_base + (E_1 k_1 + E_2 k_2), with the exact edge values in binary64 (CONVENTIONS.md). */
typedef struct DepthPlane {
    double base, step[2];
    double edge[2], right[2], down[2];
    bool flat; /* nothing is added to the base, whose zero then is not negative */
} DepthPlane;

static DepthPlane depth_plane(const Tile *tile, const GpTriangle *t)
{
    DepthPlane plane = { .base = t->z_base,
                         .step = { t->z_step[0], t->z_step[1] },
                         .flat = t->z_step[0] == 0 && t->z_step[1] == 0 };
    for (int i = 0; i < 2; i++) {
        plane.edge[i] = (double)edge_at_origin(tile, t, i + 1);
        plane.right[i] = (double)(t->a[i + 1] * GP_SUBPIXELS);
        plane.down[i] = (double)(t->b[i + 1] * GP_SUBPIXELS);
    }
    return plane;
}

GP_INLINE flt depth_at(const DepthPlane *p, const LaneSteps *steps, int32_t x, int32_t y)
{
    if (p->flat)
        return flt_set((float)(p->base + 0.0));
    double e1 = p->edge[0] + p->right[0] * x + p->down[0] * y; /* exact: integers below 2^53 */
    double e2 = p->edge[1] + p->right[1] * x + p->down[1] * y;
    dbl z = p->base + ((e1 + steps->edge[0]) * p->step[0] + (e2 + steps->edge[1]) * p->step[1]);
    return __builtin_convertvector(z, flt);
}

/* The usual test wants numbers: depth is one everywhere where all that makes it is finite. */
static EarlyTest early_test(const Filler *f, const GpTriangle *t)
{
    bool number = (t->z_base + t->z_step[0] + t->z_step[1]) * 0.0 == 0.0;
    return number || f->early == EARLY_NONE ? f->early : EARLY_ANY;
}

/* --- user clip planes ------------------------------------------------------------------------- */

/* Whether a plane leaves nothing of a triangle: all corners are farther outside than the rounding
 * of what is interpolated between them can bring back, which is some 2^-21 of their distances where
 * no share overflows. */
static bool is_cut_away(const FastDraw *d, const GpTriangle *t)
{
    if (!(t->rw_ratio[0] > 0x1p-100f && t->rw_ratio[1] > 0x1p-100f))
        return false;
    for (unsigned left = d->needs.clip_planes; left; left &= left - 1) {
        float least = 0, sum = 0;
        for (int k = 0; k < 3; k++) {
            const float outside = -t->corner[k].clip_distance[__builtin_ctz(left)];
            least = k == 0 || outside < least ? outside : least;
            sum += outside < 0 ? -outside : outside;
        }
        if (least > sum * 0x1p-18f) /* not where one is no number */
            return true;
    }
    return false;
}

/* Shares of a triangle's second and third corner, from its nearest on, at the centres of pixels
 * from (x, y) in the tile on: gp_interpolate_barycentrics in lanes. Edges are integers below
 * 2^53. */
static void find_shares(const Tile *tile, const GpTriangle *t, const LaneSteps *steps, int32_t x,
                        int32_t y, flt share[2])
{
    flt edge[3];
    for (int i = 0; i < 3; i++) {
        const int k = (t->nearest + i) % 3;
        const double right = (double)(t->a[k] * GP_SUBPIXELS),
                     down = (double)(t->b[k] * GP_SUBPIXELS);
        const double first = (double)edge_at_origin(tile, t, k) + right * x + down * y;
        edge[i] = __builtin_convertvector(
            first + (dbl_from_itg(steps->column) * right + dbl_from_itg(steps->row) * down), flt);
    }
    if (t->rw_ratio[0] == 1.0f && t->rw_ratio[1] == 1.0f) {
        share[0] = edge[1] * t->inverse_area;
        share[1] = edge[2] * t->inverse_area;
        return;
    }
    const flt part1 = edge[1] * t->rw_ratio[0], part2 = edge[2] * t->rw_ratio[1];
    const flt w = 1.0f / (edge[0] + (part1 + part2));
    share[0] = part1 * w;
    share[1] = part2 * w;
}

/* Of lanes from (x, y) in the tile on, those that no plane cuts (gp_interpolate_clip). */
static msk inside_clip_planes(const Tile *tile, const GpTriangle *t, const LaneSteps *steps,
                              int32_t x, int32_t y)
{
    const int first = t->nearest, second = (first + 1) % 3, third = (first + 2) % 3;
    flt share[2];
    msk inside = (msk)itg_set(-1);
    find_shares(tile, t, steps, x, y, share);
    for (unsigned left = tile->draw->needs.clip_planes; left; left &= left - 1) {
        const int plane = __builtin_ctz(left);
        const float at = t->corner[first].clip_distance[plane];
        const float along[2] = { t->corner[second].clip_distance[plane] - at,
                                 t->corner[third].clip_distance[plane] - at };
        inside &= (msk)(at + (share[0] * along[0] + share[1] * along[1]) >= 0.0f);
    }
    return inside;
}

/* --- filling ---------------------------------------------------------------------------------- */

/* Cuts a row's pixels first..last, which are in the box, to those that are inside an edge. */
GP_INLINE void cut_row(const TileEdge *e, int32_t y, int32_t *first, int32_t *last)
{
    const int32_t value = (int32_t)((uint32_t)e->value + (uint32_t)e->right * (uint32_t)*first +
                                    (uint32_t)e->down * (uint32_t)y);
    if (value >= 0 && e->right < 0) {
        const int32_t inside = *first + value / -e->right;
        *last = inside < *last ? inside : *last;
    } else if (value < 0 && e->right > 0)
        *first += (int32_t)(((uint32_t)-value + (uint32_t)e->right - 1) / (uint32_t)e->right);
    else if (value < 0)
        *last = *first - 1;
}

/* The run of pixels that a row of the box has inside; false where there is none. */
GP_INLINE bool find_run(const Coverage *coverage, int32_t y, int32_t *first, int32_t *last)
{
    *first = coverage->x0;
    *last = coverage->x1;
    for (int i = 0; i < 3 && *first <= *last; i++)
        cut_row(&coverage->edge[i], y, first, last);
    return *first <= *last;
}

/* Rows of a draw that looks at no depth, in its order. */
static void queue_rows(const Filler *f, const Coverage *coverage)
{
    int32_t first, last;
    for (int32_t y = coverage->y0; y <= coverage->y1; y++) {
        if (!find_run(coverage, y, &first, &last))
            continue;
        for (int32_t x = first & -GP_LANES; x <= last; x += GP_LANES) {
            const unsigned from = x < first ? (unsigned)ALL_LANES << (first - x) : ALL_LANES;
            const unsigned to = last - x < GP_LANES ? (2u << (last - x)) - 1 : ALL_LANES;
            fast_queue_row(f->tile, f->number, x, y, from & to, flt_set(0));
        }
    }
}

/* The same of a draw of which only the front is shaded: runs of the triangle's number. A hundred
 * rectangles on each other take a quarter less than with every pixel asked. */
static void show_rows(const Filler *f, const Coverage *coverage)
{
    const itg number = itg_set((int32_t)f->number);
    int32_t first, last;
    for (int32_t y = coverage->y0; y <= coverage->y1; y++) {
        if (!find_run(coverage, y, &first, &last))
            continue;
        uint32_t *at = f->tile->visibility->record + fast_at(first, y);
        int32_t pixels = last - first + 1;
        for (; pixels >= GP_LANES; pixels -= GP_LANES, at += GP_LANES)
            store_lanes(at, false, number);
        const msk inside = (msk)(lane_numbers() < pixels);
        store_lanes(at, false, itg_select(inside, number, load_lanes(at, false)));
    }
}

/* whole: as coverage->whole */
GP_INLINE void fill_rows(const Filler *f, const GpTriangle *t, const Coverage *coverage, bool whole,
                         bool quads, EarlyTest early)
{
    const FastDraw *d = f->d;
    const int32_t wide = quads ? QUADS_WIDE : GP_LANES, high = quads ? 2 : 1;
    const int32_t first_x = coverage->x0 & (quads ? -2 : -1);
    const int32_t first_y = quads ? coverage->y0 & ~1 : coverage->y0;
    const DepthPlane plane = depth_plane(f->tile, t);
    const LaneSteps steps = lane_steps(t, quads);
    for (int32_t y = first_y; y <= coverage->y1; y += high) {
        InsideRow inside = inside_row(coverage, &steps, whole, first_x, y, wide);
        for (int32_t x = first_x; x <= coverage->x1; x += wide) {
            msk live = step_right(&inside, whole, wide);
            if (!msk_bits(live))
                continue;
            if (d->needs.clip_planes)
                live &= inside_clip_planes(f->tile, t, &steps, x, y);
            flt z = early == EARLY_NONE ? flt_set(0) : depth_at(&plane, &steps, x, y);
            send_lanes(f, early, d->path, quads, x, y, live, z);
        }
    }
}

static void fill_covered(const Filler *f, const GpTriangle *t, const Coverage *coverage)
{
    const FastDraw *d = f->d;
    const bool quads = d->path == FAST_ORDERED && d->needs.quads;
    const EarlyTest early = early_test(f, t);
    const bool runs = early == EARLY_NONE && !quads && !d->needs.clip_planes;
    if (runs && d->path == FAST_VISIBLE)
        show_rows(f, coverage);
    else if (runs && d->path == FAST_ORDERED && coverage->whole && !d->repeated)
        fast_queue_box(f->tile, f->number,
                       &(FastBox){ coverage->x0, coverage->y0, coverage->x1, coverage->y1 });
    else if (runs && d->path == FAST_ORDERED)
        queue_rows(f, coverage);
    else if (coverage->whole)
        fill_rows(f, t, coverage, true, quads, early);
    else
        fill_rows(f, t, coverage, false, quads, early);
}

/* --- what is not hidden ----------------------------------------------------------------------- */

/* A triangle on its way through a tile's strips. */
typedef struct StripFilling {
    const Filler *f;
    const GpTriangle *t;
    const Coverage *coverage;
    int32_t reach; /* stored codes above it may be passed */
    DepthPlane plane;
    LaneSteps steps;
} StripFilling;

/* Queues a packet of a strip, a row's or one of quads. One of which nothing is left is written over
 * by the next: whether something is, is hard to foresee (discard_tex takes 9 % less).
 * returns whether the strip is not all hidden here */
GP_INLINE bool queue_part(const StripFilling *w, bool whole, bool quads, int32_t x, int32_t y)
{
    const Filler *f = w->f;
    FastQueue *q = f->tile->queue;
    const InsideRow inside = inside_row(w->coverage, &w->steps, whole, x, y, 0);
    const flt z = depth_at(&w->plane, &w->steps, x, y);
    const msk covered = covered_lanes(&inside, whole);
    const itg stored = load_lanes(f->tile->depth + fast_at(x, y), quads);
    msk live = test_usual(f, false, quads, fast_at(x, y), covered, nearer_codes(f, f->early, z));
    if (f->d->needs.clip_planes)
        live &= inside_clip_planes(f->tile, w->t, &w->steps, x, y);
    set_packet(&q->packets[q->count], f->number, x, y, msk_bits(live), quads ? 0 : GP_LANES);
    flt_store(q->depths + q->count * GP_LANES, z);
    q->count += msk_bits(live) != 0;
    return msk_bits((msk)(w->reach < stored)) != 0;
}

/* whole: as coverage->whole */
GP_INLINE void fill_strips(const StripFilling *w, bool whole, bool quads, FastNotHidden *strips)
{
    const Coverage *box = w->coverage;
    const int32_t wide = quads ? QUADS_WIDE : GP_LANES, high = quads ? 2 : 1;
    const uint32_t across = (2u << box->x1 / GP_LANES) - (1u << box->x0 / GP_LANES);
    Tile *tile = w->f->tile;
    for (int32_t y = box->y0 & -high; y <= box->y1; y += high) {
        const uint32_t row = strips->of_row[y] | (quads ? strips->of_row[y + 1] : 0u);
        uint32_t kept = row & ~across;
        if (tile->queue->count > (uint32_t)(FAST_BLOCK - FAST_TILE / wide))
            fast_flush_packets(tile);
        for (uint32_t left = row & across; left; left &= left - 1) {
            const int32_t strip = __builtin_ctz(left);
            for (int32_t x = strip * GP_LANES; x < (strip + 1) * GP_LANES; x += wide)
                kept |= (uint32_t)queue_part(w, whole, quads, x, y) << strip;
        }
        strips->of_row[y] = kept;
        if (quads)
            strips->of_row[y + 1] = kept;
    }
}

static void fill_not_hidden(const Filler *f, const GpTriangle *t, const Coverage *coverage,
                            FastNotHidden *strips)
{
    const bool quads = f->d->needs.quads;
    const StripFilling work = { f,
                                t,
                                coverage,
                                strips->nearest - f->allowance,
                                depth_plane(f->tile, t),
                                lane_steps(t, quads) };
    if (quads)
        fill_strips(&work, false, true, strips);
    else if (coverage->whole)
        fill_strips(&work, true, false, strips);
    else
        fill_strips(&work, false, false, strips);
}

static bool covers_tile(const Tile *tile, const Coverage *coverage)
{
    return coverage->whole && coverage->x0 == 0 && coverage->y0 == 0 &&
           coverage->x1 == tile->width - 1 && coverage->y1 == tile->height - 1;
}

FastCover fast_cover(const Tile *tile, const GpTriangle *t)
{
    Coverage coverage;
    if (!find_coverage(tile, t, &coverage))
        return FAST_COVERS_NONE;
    return covers_tile(tile, &coverage) ? FAST_COVERS_ALL : FAST_COVERS_SOME;
}

/* Nothing that was visible in the tile is so any more: all shows one record. */
static bool hides_tile(const Filler *f, const Coverage *coverage)
{
    return covers_hide(f) && covers_tile(f->tile, coverage);
}

static void write_record(Tile *tile, const GpTriangle *t, FastTriangleRecord *record)
{
    FastEdges64 *edges = &tile->records->edges64[tile->records->edges64_count];
    *record = (FastTriangleRecord){ .ratio1 = t->rw_ratio[0],
                                    .ratio2 = t->rw_ratio[1],
                                    .face = t->front ? 1.0f : -1.0f,
                                    .kind = FAST_EDGES_64,
                                    .edges64 = (uint16_t)tile->records->edges64_count++,
                                    .flat = (uint16_t)((3 - t->nearest) % 3) };
    for (int i = 0; i < 3; i++) {
        const int k = (t->nearest + i) % 3;
        record->corner[i] = t->corner[k].varying;
        edges->edge.c[i] = edge_at_origin(tile, t, k);
        edges->edge.a[i] = t->a[k] * GP_SUBPIXELS;
        edges->edge.b[i] = t->b[k] * GP_SUBPIXELS;
    }
}

void fast_fill_large(Tile *tile, const GpTriangle *t, FastNotHidden *strips)
{
    const FastDraw *d = tile->draw;
    Coverage coverage;
    if (!find_coverage(tile, t, &coverage) || is_cut_away(d, t))
        return;
    Filler filler = fast_filler(tile);
    filler.front = t->front;
    if (d->path != FAST_DEPTH_ONLY) {
        fast_reserve_records(tile, 1);
        filler.number = tile->records->count++;
        write_record(tile, t, &tile->records->record[filler.number]);
    }
    if (d->one_color)
        filler.color = fast_begin_color(tile, filler.number, t->front);
    if (hides_tile(&filler, &coverage))
        tile->visibility->occluder = filler.number;
    else if (strips)
        fill_not_hidden(&filler, t, &coverage, strips);
    else
        fill_covered(&filler, t, &coverage);
}
