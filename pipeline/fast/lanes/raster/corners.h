/* Corners of GP_LANES triangles of one draw, and what of a tile can lie between them. */
#ifndef GP_FAST_CORNERS_H
#define GP_FAST_CORNERS_H

#include "pipeline/fast/lanes/memory/tile.h"

/* Where the corners of a batch's triangles are; beyond `count` the first triangle's stand in. */
typedef struct BatchCorners {
    const uint32_t *primitives;
    uint32_t count;
    const FastPosition *corner[3][GP_LANES];
} BatchCorners;

/* They themselves: x and y from the tile's first centre, in sub-pixels; z, rw. */
typedef struct Corners {
    itg at[3][4];
    itg area2;
} Corners;

/* Looks up the corners of the first of `count` triangles, up to GP_LANES, and asks memory for them:
 * some time before they are set up, for they are rarely near. */
void fast_find_corners(const FastDraw *draw, const uint32_t *primitives, uint32_t count,
                       BatchCorners *corners);

/* All but area2. */
GP_INLINE void load_corners(const Tile *tile, const BatchCorners *from, Corners *corners)
{
    for (int k = 0; k < 3; k++) {
        itg *at = corners->at[k];
        lanes_load4((const void *const *)from->corner[k], at);
        at[0] -= tile->x0 * GP_SUBPIXELS + GP_SUBPIXELS / 2;
        at[1] -= tile->y0 * GP_SUBPIXELS + GP_SUBPIXELS / 2;
    }
}

/* Lanes whose triangle covers every pixel of a rectangle; covers it together with that of the lane
 * before, as the halves of a larger rectangle do; and covers no pixel. Not all of them: what is not
 * told may be so, too. */
typedef struct FastBetween {
    unsigned all, with_previous, none;
} FastBetween;

/* What of a rectangle of the target, which is in the tile and not empty, lies between corners. */
FastBetween fast_between_corners(const Tile *tile, const Corners *corners, const GpRect *rect);

/* Where nothing looks at depth, and what comes last replaces what was there: the number of
 * primitives at the front that one or two behind them hide, all over the tile. (Screens full of
 * rectangles take a third.) */
uint32_t fast_hidden_by_cover(const Tile *tile, const uint32_t *primitives, uint32_t count);

#endif
