/* Corners of triangles, and covers of a tile. */
#include "pipeline/fast/lanes/raster/corners.h"

void fast_find_corners(const FastDraw *d, const uint32_t *primitives, uint32_t count,
                       BatchCorners *corners)
{
    const uint32_t *indices = d->indices;
    corners->primitives = primitives;
    corners->count = count < GP_LANES ? count : GP_LANES;
    for (uint32_t lane = 0; lane < GP_LANES; lane++) {
        const uint32_t at = 3 * (primitives[lane < count ? lane : 0] - d->first_primitive);
        const uint32_t made[3] = { at, at + 1, at + 2 }, *number = indices ? indices + at : made;
        GP_UNROLL
        for (uint32_t k = 0; k < 3; k++) {
            corners->corner[k][lane] = &d->positions[number[k] - d->first_vertex];
            __builtin_prefetch(corners->corner[k][lane]);
        }
    }
}

/* An edge of triangles that turn to the front, or turned so: the least and the greatest of its
 * function over a rectangle. They are exact, integers below 2^53, then rounded, which keeps their
 * signs. */
typedef struct EdgeReach {
    flt least, greatest;
} EdgeReach;

GP_INLINE EdgeReach edge_reach(const itg *from, const itg *to, const GpRect *rect, msk turned)
{
    const itg zero = itg_set(0), dx = to[0] - from[0], dy = to[1] - from[1];
    const double across = (double)(rect->x1 - 1 - rect->x0) * GP_SUBPIXELS;
    const double along = (double)(rect->y1 - 1 - rect->y0) * GP_SUBPIXELS;
    const dbl first = dbl_from_itg(dx) * dbl_from_itg(rect->y0 * GP_SUBPIXELS - from[1]) -
                      dbl_from_itg(dy) * dbl_from_itg(rect->x0 * GP_SUBPIXELS - from[0]);
    const dbl less =
        dbl_from_itg(itg_greater(dy, zero)) * across - dbl_from_itg(itg_lesser(dx, zero)) * along;
    const dbl more =
        dbl_from_itg(itg_greater(dx, zero)) * along - dbl_from_itg(itg_lesser(dy, zero)) * across;
    const flt least = __builtin_convertvector(first - less, flt);
    const flt greatest = __builtin_convertvector(first + more, flt);
    return (EdgeReach){ flt_select(turned, -greatest, least),
                        flt_select(turned, -least, greatest) };
}

/* Twice the area, rounded. */
GP_INLINE flt signed_area(const Corners *corners)
{
    const itg *p0 = corners->at[0], *p1 = corners->at[1], *p2 = corners->at[2];
    return __builtin_convertvector(dbl_from_itg(p1[0] - p0[0]) * dbl_from_itg(p2[1] - p0[1]) -
                                       dbl_from_itg(p2[0] - p0[0]) * dbl_from_itg(p1[1] - p0[1]),
                                   flt);
}

/* The one edge that a lane's rectangle is not all inside of. */
typedef struct OpenEdge {
    msk one; /* there is one, and no other */
    itg from[2], to[2];
} OpenEdge;

/* Lanes whose open edge is that of the lane before, the other way round: of two that face one way
 * the fill rule gives each pixel on it to one (R5). */
static unsigned share_edge(const OpenEdge *open, msk turned)
{
    msk shared = open->one & itg_shift_in(open->one, 0) & ~(turned ^ itg_shift_in(turned, 0));
    for (int i = 0; i < 2; i++)
        shared &= (msk)(open->from[i] == itg_shift_in(open->to[i], 0)) &
                  (msk)(open->to[i] == itg_shift_in(open->from[i], 0));
    return msk_bits(shared) & ~1u;
}

FastBetween fast_between_corners(const Tile *tile, const Corners *corners, const GpRect *rect)
{
    const GpRect inside = { rect->x0 - tile->x0, rect->y0 - tile->y0, rect->x1 - tile->x0,
                            rect->y1 - tile->y0 };
    const flt area = signed_area(corners);
    const msk turned = (msk)(area < 0.0f);
    OpenEdge open = { .one = itg_set(0) };
    msk several = itg_set(0), none = (msk)(area == 0.0f);
    GP_UNROLL
    for (int i = 0; i < 3; i++) {
        const itg *from = corners->at[(i + 1) % 3], *to = corners->at[(i + 2) % 3];
        const EdgeReach reach = edge_reach(from, to, &inside, turned);
        const msk is_open = (msk)(reach.least <= 0.0f);
        none |= (msk)(reach.greatest < 0.0f);
        several |= open.one & is_open;
        open.one |= is_open;
        for (int k = 0; k < 2; k++) {
            open.from[k] = itg_select(is_open, from[k], open.from[k]);
            open.to[k] = itg_select(is_open, to[k], open.to[k]);
        }
    }
    const msk covers = ~(none | open.one);
    open.one &= ~(none | several);
    return (FastBetween){ msk_bits(covers), share_edge(&open, turned), msk_bits(none) };
}

/* Whether some triangle of a batch is as large as the tile, without which none covers it. */
static bool are_large(const Tile *tile, const Corners *corners)
{
    const itg *x = &corners->at[0][0];
    itg low = *x, high = *x;
    for (int k = 1; k < 3; k++) {
        low = itg_lesser(low, corners->at[k][0]);
        high = itg_greater(high, corners->at[k][0]);
    }
    return msk_any((msk)(high - low >= (tile->width - 1) * GP_SUBPIXELS));
}

uint32_t fast_hidden_by_cover(const Tile *tile, const uint32_t *primitives, uint32_t count)
{
    const GpRect rect = fast_tile_rect(tile, tile->draw);
    if (rect.x1 - rect.x0 < tile->width || rect.y1 - rect.y0 < tile->height)
        return 0;
    for (uint32_t end = count, first; end > 1; end = first) { /* one alone hides no other */
        first = (end - 1) & -(uint32_t)GP_LANES;
        BatchCorners found;
        Corners corners;
        fast_find_corners(tile->draw, primitives + first, end - first, &found);
        load_corners(tile, &found, &corners);
        if (!are_large(tile, &corners))
            return 0; /* neighbours mostly are as small */
        const unsigned present = (1u << found.count) - 1;
        const FastBetween between = fast_between_corners(tile, &corners, &rect);
        const unsigned covers = (between.all & present) | (between.with_previous & present) >> 1;
        if (covers)
            return first + 31 - (uint32_t)__builtin_clz(covers);
    }
    return 0;
}
