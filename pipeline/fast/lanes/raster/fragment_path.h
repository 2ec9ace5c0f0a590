/* Where covered pixels go: through the early tests, then along the path of their draw. */
#ifndef GP_FAST_RASTER_FRAGMENT_PATH_H
#define GP_FAST_RASTER_FRAGMENT_PATH_H

#include "pipeline/fast/lanes/output/depth.h"
#include "pipeline/fast/lanes/shade/one_color.h"
#include "pipeline/fast/lanes/shade/queue.h"
#include "pipeline/fast/lanes/shade/visibility.h"

/* What is tested before the shader. The usual test, where nearer pixels pass and are written and
 * nothing looks at the stencil, is short enough to stand inside the loops over pixels; it may only
 * be asked where depth is a number.
 *
 * Where tests come late, the usual one is also asked early, without writing: what is stored only
 * comes nearer while fragments of the draw wait, so one that fails now would fail then too. Of an
 * ordered draw that writes no depth the answer is the same at any time: it is asked early alone. */
typedef enum EarlyTest {
    EARLY_NONE,         /* nothing looks at depth or stencil, early or late */
    EARLY_NEARER_FLOAT, /* the usual, for D32F */
    EARLY_NEARER_UNORM, /* for D16 and D24 */
    EARLY_ANY,          /* all else; where tests come late, none */
} EarlyTest;

GP_INLINE bool is_usual(EarlyTest early)
{
    return early == EARLY_NEARER_FLOAT || early == EARLY_NEARER_UNORM;
}

/* What all triangles of a batch share, and the one at work. */
typedef struct Filler {
    Tile *tile;
    const FastDraw *d;
    EarlyTest early;
    float low, high;   /* the viewport's depths; 0 is never -0 */
    double scale;      /* of unorm codes */
    int32_t allowance; /* 1 where equal depths pass */
    bool writes;       /* the usual test also stores */
    uint32_t number;   /* of the record, where one is needed */
    uint32_t color;    /* the number of a triangle's one colour, where it has one */
    bool front;
} Filler;

Filler fast_filler(Tile *tile);

/* Whether a triangle that covers the tile hides all that was there. */
GP_INLINE bool covers_hide(const Filler *f)
{
    return f->d->path == FAST_VISIBLE && f->early == EARLY_NONE && !f->d->needs.clip_planes;
}

/* Codes of finite depths, for the usual test. The greater one comes out as `low` where both are 0,
 * so that no -0 is left. */
GP_INLINE itg nearer_codes(const Filler *f, EarlyTest early, flt z)
{
    z = flt_lesser(flt_greater(z, flt_set(f->low)), flt_set(f->high));
    if (early == EARLY_NEARER_FLOAT)
        return (itg)z;
    return __builtin_convertvector(__builtin_convertvector(z, dbl) * f->scale + 0.5, itg);
}

/* The usual test of lanes of a row, or of quads, from a place of the tile on.
 * returns those of `live` that pass */
GP_INLINE msk test_usual(const Filler *f, bool writes, bool quads, uint32_t at, msk live, itg code)
{
    uint32_t *depth = f->tile->depth + at;
    const itg stored = load_lanes(depth, quads);
    const itg reach = f->d->needs.ternary ? put_back(f->tile, f->d, stored) : stored;
    live &= (code - f->allowance - reach) >> 31; /* codes are not negative */
    if (writes)
        store_lanes(depth, quads, itg_select(live, code, stored));
    return live;
}

/* Adds fragments of a triangle of one colour to their lists: of some rows from a place on.
 * in   z: a number, or not
 * returns those that were of the slice */
GP_INLINE msk list_rows(const Filler *f, uint32_t at, int32_t wide, msk live, flt z)
{
    FastFragments *fragments = f->tile->fragments;
    z = flt_select((msk)(z < f->low), flt_set(f->low), z);
    z = flt_select((msk)(z > f->high), flt_set(f->high), z);
    const itg keys = fast_order_keys(f->d, depth_codes(GP_D32F, z));
    live &= fast_of_slice(fragments, keys);
    fast_add_fragments(fragments, at, wide, live, keys, f->color);
    return live;
}

/* Lanes of a row, or of quads, from (x, y) of the tile on: the tests that come early, and on along
 * the draw's fragment path.
 * in   early: the filler's, or EARLY_ANY in its place; z: not clamped; matters unless EARLY_NONE
 * returns the lanes that passed */
GP_INLINE msk send_lanes(const Filler *f, EarlyTest early, FastFragmentPath path, bool quads,
                         int32_t x, int32_t y, msk live, flt z)
{
    Tile *tile = f->tile;
    const uint32_t at = fast_at(x, y);
    msk replaced = itg_set(0);
    if (is_usual(early))
        live = test_usual(f, path != FAST_ORDERED || f->writes, quads, at, live,
                          nearer_codes(f, early, z));
    else if (early == EARLY_ANY && !f->d->late_depth)
        live = fast_test_depth_stencil(tile, f->d, at, quads, live, z, f->front, &replaced);

    if (path == FAST_VISIBLE) {
        itg shown = load_lanes(tile->visibility->record + at, quads);
        store_lanes(tile->visibility->record + at, quads,
                    itg_select(live, itg_set((int32_t)f->number), shown));
    } else if (path == FAST_ORDERED && f->d->one_color) {
        live = list_rows(f, at, GP_LANES, live, z);
    } else if (path == FAST_ORDERED) {
        unsigned lanes = msk_bits(live);
        if (lanes) {
            FastPacket *packet = quads ? fast_queue_quads(tile, f->number, x, y, lanes, z)
                                       : fast_queue_row(tile, f->number, x, y, lanes, z);
            packet->replaced = msk_bits(replaced);
        }
    }
    return live;
}

#endif
