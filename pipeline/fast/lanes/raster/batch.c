/* Setting up GP_LANES triangles at a time. */
#include "pipeline/fast/lanes/raster/batch.h"

#include "pipeline/fast/lanes/raster/hierarchical_depth.h"

/* Largest extent, in sub-pixels, at which edges fit into 32 bits with room for helper pixels, and
 * their steps into 16. */
enum { FITS = 1 << 14 };

/* Tiny triangles that are worth a look at all of a batch. */
enum { WORTH_IT = GP_LANES / 4 };

/* Boxes of pixels, cut to what the draw may touch; returns the lanes that have one. */
static unsigned set_boxes(const Tile *tile, const GpRect *rect, bool quads, const Corners *corners,
                          TriangleBatch *b, unsigned *large)
{
    const int32_t aligned = quads ? ~1 : ~0;
    const itg *p0 = corners->at[0], *p1 = corners->at[1], *p2 = corners->at[2];
    itg low_x = itg_lesser(p0[0], itg_lesser(p1[0], p2[0]));
    itg low_y = itg_lesser(p0[1], itg_lesser(p1[1], p2[1]));
    itg high_x = itg_greater(p0[0], itg_greater(p1[0], p2[0]));
    itg high_y = itg_greater(p0[1], itg_greater(p1[1], p2[1]));
    *large = msk_bits((msk)(high_x - low_x >= FITS) | (msk)(high_y - low_y >= FITS));

    itg x0 =
        itg_greater((low_x + (GP_SUBPIXELS - 1)) >> GP_SUBPIXEL_BITS, itg_set(rect->x0 - tile->x0));
    itg y0 =
        itg_greater((low_y + (GP_SUBPIXELS - 1)) >> GP_SUBPIXEL_BITS, itg_set(rect->y0 - tile->y0));
    itg x1 = itg_lesser(high_x >> GP_SUBPIXEL_BITS, itg_set(rect->x1 - 1 - tile->x0));
    itg y1 = itg_lesser(high_y >> GP_SUBPIXEL_BITS, itg_set(rect->y1 - 1 - tile->y0));
    b->x = x0 & aligned;
    b->y = y0 & aligned;
    b->width = x1 - b->x;
    b->height = y1 - b->y;
    return msk_bits((msk)(x0 <= x1) & (msk)(y0 <= y1));
}

/* Twice the area, made positive: corners 1 and 2 change places where a triangle turns the other
 * way. */
static void set_facing(Corners *corners, TriangleBatch *b)
{
    itg *p0 = corners->at[0], *p1 = corners->at[1], *p2 = corners->at[2];
    itg area2 = cross_lanes(p1[0] - p0[0], p2[1] - p0[1], p2[0] - p0[0], p1[1] - p0[1]);
    msk front = (msk)(area2 > 0);
    for (int i = 0; i < 4; i++) {
        itg one = p1[i], two = p2[i];
        p1[i] = itg_select(front, one, two);
        p2[i] = itg_select(front, two, one);
    }
    corners->area2 = itg_select(front, area2, (itg) - (utg)area2);
    b->front = msk_bits(front);
}

static void set_edges(const Corners *corners, TriangleBatch *b)
{
    GP_UNROLL
    for (int i = 0; i < 3; i++) {
        const itg *from = corners->at[(i + 1) % 3], *to = corners->at[(i + 2) % 3];
        itg dx = to[0] - from[0], dy = to[1] - from[1];
        itg edge =
            cross_lanes(dx, b->y * GP_SUBPIXELS - from[1], dy, b->x * GP_SUBPIXELS - from[0]);
        msk accepts_zero = (msk)(dy < 0) | ((msk)(dy == 0) & (msk)(dx > 0));
        b->edge[i] = edge;
        b->inside[i] = (itg)((utg)edge + (utg)~accepts_zero) >> GP_SUBPIXEL_BITS; /* 0 or -1 */
        b->right[i] = -dy;
        b->down[i] = dx;
        b->steps[i] = (-dy & 0xffff) | (itg)((utg)dx << 16);
    }
}

/* For all triangles at once; of lanes that are not tiny the result means nothing. */
static void cover_tiny(TriangleBatch *b)
{
    utg row[3] = { (utg)b->inside[0], (utg)b->inside[1], (utg)b->inside[2] };
    itg covered = itg_set(0);
    GP_UNROLL
    for (int y = 0; y < 4; y++) {
        utg e0 = row[0], e1 = row[1], e2 = row[2];
        GP_UNROLL
        for (int x = 0; x < 4; x++) {
            itg out = (itg)(e0 | e1 | e2) | (b->width - x) | (b->height - y);
            covered |= (itg)((utg)~out >> 31) << (4 * y + x);
            e0 += (utg)b->right[0];
            e1 += (utg)b->right[1];
            e2 += (utg)b->right[2];
        }
        for (int i = 0; i < 3; i++)
            row[i] += (utg)b->down[i];
    }
    b->covered = covered;
}

static double size(double a)
{
    return a < 0 ? -a : a;
}

/* What the depth bias adds to depth at corner 0 (R22). */
static double depth_offset(const GpRasterState *raster, const TriangleBatch *b, int lane)
{
    double offset = (double)raster->depth_bias;
    if (raster->slope_depth_bias == 0)
        return offset;
    double k1 = b->step[0][lane], k2 = b->step[1][lane];
    double by_x = size((double)b->right[1][lane] * k1 + (double)b->right[2][lane] * k2);
    double by_y = size((double)b->down[1][lane] * k1 + (double)b->down[2][lane] * k2);
    by_x *= GP_SUBPIXELS;
    by_y *= GP_SUBPIXELS;
    return offset + (by_x > by_y ? by_x : by_y) * (double)raster->slope_depth_bias;
}

/* Returns the lanes where depth is a number: states are finite, and nothing that binary32 holds
 * overflows in set_depth. */
static unsigned set_nearest(const FastDraw *d, const Corners *corners, TriangleBatch *b)
{
    flt z0 = (flt)corners->at[0][2], z1 = (flt)corners->at[1][2], z2 = (flt)corners->at[2][2];
    /* pixels lie between the corners, but for the rounding of a few binary64 operations */
    flt sizes = flt_abs(z0) + flt_abs(z1) + flt_abs(z2);
    b->nearest = flt_lesser(z0, flt_lesser(z1, z2)) - sizes * 0x1p-20f;
    if (d->needs.depth_bias)
        b->nearest = flt_set(-__builtin_inff());
    return msk_bits((msk)((z0 + z1 + z2) * 0.0f == 0.0f));
}

/* As gp_setup_triangle: in binary64, from binary32 values. */
static void set_depth(const FastDraw *d, const Corners *corners, TriangleBatch *b)
{
    flt z0 = (flt)corners->at[0][2], z1 = (flt)corners->at[1][2], z2 = (flt)corners->at[2][2];
    dbl base = __builtin_convertvector(z0, dbl), area = dbl_from_itg(corners->area2);
    b->step[0] = (__builtin_convertvector(z1, dbl) - base) / area;
    b->step[1] = (__builtin_convertvector(z2, dbl) - base) / area;
    b->base = base + 0.0; /* what adding an offset of 0 does */
    for (int lane = 0; d->needs.depth_bias && lane < GP_LANES; lane++)
        b->base[lane] += depth_offset(&d->draw->state.raster, b, lane);
}

/* What interpolation needs, from the nearest corner on (R16): as gp_setup_triangle. */
static void set_shading(const Corners *corners, TriangleBatch *b)
{
    const itg *const at[3] = { corners->at[0], corners->at[1], corners->at[2] };
    const flt rw[3] = { (flt)at[0][3], (flt)at[1][3], (flt)at[2][3] };
    const msk second = (msk)(rw[1] > rw[0]);
    const flt nearer = flt_select(second, rw[1], rw[0]);
    const msk third = (msk)(rw[2] > nearer);
    const flt nearest = flt_select(third, rw[2], nearer);
    b->area2 = corners->area2;
    b->shade_first = itg_select(third, itg_set(2), (itg)second & 1);
    GP_UNROLL
    for (int i = 0; i < 2; i++) { /* the one after 0, 1 or 2; the one after that */
        const int k0 = 1 + i, k1 = i ? 0 : 2, k2 = i;
        b->shade_edge[i] =
            itg_select(third, b->edge[k2], itg_select(second, b->edge[k1], b->edge[k0]));
        b->shade_steps[i] =
            itg_select(third, b->steps[k2], itg_select(second, b->steps[k1], b->steps[k0]));
        b->ratio[i] = flt_select(third, rw[k2], flt_select(second, rw[k1], rw[k0])) / nearest;
    }
}

void fast_set_up_batch(const Filler *f, const BatchCorners *found, TriangleBatch *b)
{
    const Tile *tile = f->tile;
    const FastDraw *d = f->d;
    const GpRect rect = fast_tile_rect(tile, d);
    const bool quads = d->path == FAST_ORDERED && d->needs.quads;
    const unsigned wanted = (1u << found->count) - 1;
    Corners corners;
    unsigned large;
    load_corners(tile, found, &corners);
    unsigned drawn = wanted & set_boxes(tile, &rect, quads, &corners, b, &large) & ~large;
    const unsigned numbers = d->wants_depth ? set_nearest(d, &corners, b) : wanted;
    if (is_usual(f->early))
        drawn &= ~occluded_boxes(f, drawn & numbers, b->x, b->y, b->width, b->height, b->nearest);
    if (large)
        large &= ~fast_between_corners(tile, &corners, &rect).none;
    b->primitives = found->primitives;
    b->alone = wanted & (large | (drawn & ~numbers));
    b->small = drawn & numbers;
    b->tiny = 0;
    if (!b->small)
        return;
    set_facing(&corners, b);
    set_edges(&corners, b);

    b->tiny = b->small & msk_bits((msk)((b->width | b->height) < 4));
    /* with larger ones it would be filled in pieces, one way and the other in turn: where that is
     * no help to the shader, shadow maps take 3 to 7 % more */
    const bool mixed = d->path != FAST_ORDERED && b->tiny != b->small;
    if (mixed || __builtin_popcount(b->tiny) < WORTH_IT)
        b->tiny = 0;
    if (b->tiny) {
        cover_tiny(b);
        unsigned empty = b->tiny & msk_bits((msk)(b->covered == 0));
        b->small &= ~empty;
        b->tiny &= ~empty;
    }
    if (d->wants_depth && b->small)
        set_depth(d, &corners, b);
    /* no room here for clip distances, nor for quads that start left of or above what is allowed */
    if (d->needs.clip_planes || (quads && ((rect.x0 | rect.y0) & 1))) {
        b->alone |= b->small;
        b->small = 0;
    }
    const bool apart =
        d->path == FAST_ORDERED ? d->wants_depth || quads : d->needs.stencil || d->needs.ternary;
    b->tiny = apart ? 0 : b->tiny & b->small;
    b->small &= ~b->tiny;
    if (d->path != FAST_DEPTH_ONLY && (b->tiny | b->small))
        set_shading(&corners, b);
}

void fast_write_record(const FastDraw *d, const TriangleBatch *b, uint32_t lane,
                       FastTriangleRecord *record)
{
    /* corners from the nearest on, of triangles that turn the other way and of front ones */
    static const uint8_t turned[2][3][3] = { { { 0, 2, 1 }, { 2, 1, 0 }, { 1, 0, 2 } },
                                             { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 } } };
    static const uint8_t first_of[3] = { 0, 2, 1 };
    const bool front = b->front >> lane & 1;
    const uint8_t *order = turned[front][b->shade_first[lane]];
    const uint32_t x = (uint32_t)b->x[lane], y = (uint32_t)b->y[lane];
    int32_t c[2];
    for (int i = 0; i < 2; i++) {
        const int32_t step = b->shade_steps[i][lane];
        c[i] = (int32_t)((uint32_t)b->shade_edge[i][lane] - ((uint32_t)fast_step_right(step) * x +
                                                             (uint32_t)fast_step_down(step) * y));
    }
    record->c1 = c[0];
    record->step1 = b->shade_steps[0][lane];
    record->c2 = c[1];
    record->step2 = b->shade_steps[1][lane];
    record->area = b->area2[lane];
    record->ratio1 = b->ratio[0][lane];
    record->ratio2 = b->ratio[1][lane];
    record->kind = FAST_EDGES_32;
    record->face = front ? 1.0f : -1.0f;
    record->edges64 = 0;
    record->flat = first_of[b->shade_first[lane]];
    const uint32_t *indices = d->indices;
    const uint32_t at = 3 * (b->primitives[lane] - d->first_primitive);
    for (int k = 0; k < 3; k++) {
        uint32_t number = (indices ? indices[at + order[k]] : at + order[k]) - d->first_vertex;
        record->corner[k] = d->varyings + (size_t)number * d->stride;
        __builtin_prefetch(record->corner[k]); /* wanted when what is visible is shaded */
    }
}
