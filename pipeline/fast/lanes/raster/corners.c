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

/* The least and the greatest of an edge function over a rectangle, and it at the first pixel: exact, integers
 * below 2^53, then rounded, which keeps their signs. */
typedef struct EdgeReach {
    dbl first;
    flt least, greatest;
} EdgeReach;

GP_INLINE EdgeReach edge_reach(const itg *from, const itg *to, const GpRect *rect)
{
    const itg zero = itg_set(0), dx = to[0] - from[0], dy = to[1] - from[1];
    const double across = (double)(rect->x1 - 1 - rect->x0) * GP_SUBPIXELS;
    const double along = (double)(rect->y1 - 1 - rect->y0) * GP_SUBPIXELS;
    const dbl first = dbl_from_itg(dx) * dbl_from_itg(rect->y0 * GP_SUBPIXELS - from[1]) -
                      dbl_from_itg(dy) * dbl_from_itg(rect->x0 * GP_SUBPIXELS - from[0]);
    const dbl least = first - (dbl_from_itg(itg_greater(dy, zero)) * across -
                               dbl_from_itg(itg_lesser(dx, zero)) * along);
    const dbl greatest = first + (dbl_from_itg(itg_greater(dx, zero)) * along -
                                  dbl_from_itg(itg_lesser(dy, zero)) * across);
    return (EdgeReach){ first, __builtin_convertvector(least, flt),
                        __builtin_convertvector(greatest, flt) };
}

FastBetween fast_between_corners(const Tile *tile, const Corners *corners, const GpRect *rect)
{
    const GpRect inside = { rect->x0 - tile->x0, rect->y0 - tile->y0, rect->x1 - tile->x0,
                            rect->y1 - tile->y0 };
    dbl doubled_area = dbl_from_itg(itg_set(0));
    flt least_of_all = flt_set(__builtin_inff()), greatest_of_all = -least_of_all;
    flt least_greatest = least_of_all, greatest_least = greatest_of_all;
    GP_UNROLL
    for (int i = 0; i < 3; i++) {
        const EdgeReach reach =
            edge_reach(corners->at[(i + 1) % 3], corners->at[(i + 2) % 3], &inside);
        doubled_area += reach.first;
        least_of_all = flt_lesser(least_of_all, reach.least);
        greatest_of_all = flt_greater(greatest_of_all, reach.greatest);
        least_greatest = flt_lesser(least_greatest, reach.greatest);
        greatest_least = flt_greater(greatest_least, reach.least);
    }
    const flt area = __builtin_convertvector(doubled_area, flt);
    return (FastBetween){
        .all = msk_bits((msk)(least_of_all > 0.0f) | (msk)(greatest_of_all < 0.0f)),
        .none = msk_bits((msk)(area == 0.0f) | ((msk)(area > 0.0f) & (msk)(least_greatest < 0.0f)) |
                         ((msk)(area < 0.0f) & (msk)(greatest_least > 0.0f))),
    };
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
    for (uint32_t end = count, first; end; end = first) {
        first = (end - 1) & -(uint32_t)GP_LANES;
        BatchCorners found;
        Corners corners;
        fast_find_corners(tile->draw, primitives + first, end - first, &found);
        load_corners(tile, &found, &corners);
        if (!are_large(tile, &corners))
            return 0; /* neighbours mostly are as small */
        const unsigned present = (1u << found.count) - 1;
        const unsigned covers = present & fast_between_corners(tile, &corners, &rect).all;
        if (covers)
            return first + 31 - (uint32_t)__builtin_clz(covers);
    }
    return 0;
}
