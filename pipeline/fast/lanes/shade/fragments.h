/* Fragments of a pass that sorts: shaded, they wait in lists of their pixels until all have come.
 *
 * Where a tile has more of them than there is room for, it is drawn in slices: those whose turn
 * comes first are kept, by their keys, and blended; then all draws of the pass come again, for the
 * rest. A slice ends between two keys, so equal depths are never parted; if even those of one key
 * are too many they are blended as they come, which is their order. No bit depends on where slices
 * end. */
#ifndef GP_FAST_FRAGMENTS_H
#define GP_FAST_FRAGMENTS_H

#include "pipeline/fast/lanes/output/shaded.h"

typedef struct FastFragments {
    void *memory; /* of the lists, and of what was shaded */
    size_t bytes;
    uint64_t sorted, slices; /* counted */

    uint32_t first, last;  /* keys of the present slice, ends included */
    uint32_t layers, room; /* of a pixel, and of what was shaded */
    uint32_t deepest;      /* no list is longer */
    uint32_t targets;
    uint32_t shaded_count;
    _Alignas(64) uint32_t waiting[FAST_PIXELS]; /* of each pixel */

    /* [layer][pixel], as they came: gp_order_key, and the number of what was shaded */
    uint32_t *key, *shaded;

    /* what was shaded, by numbers that rise as it came */
    float *color;     /* [number][target][channel] */
    uint32_t *source; /* twice the draw's number, plus 1 where it shows its front: fast_source */
    uint32_t *moved;  /* its next number, while some are dropped */
} FastFragments;

/* Memory without which nothing can be sorted. */
size_t fast_least_fragment_bytes(void);

/* Begins the first slice of the present pass. */
void fast_begin_fragments(Tile *tile);

/* Whether every list has room for one more fragment, and what was shaded for a packet; where not,
 * makes it, which may end the slice earlier. What waits to be shaded must have been. */
GP_INLINE bool fast_has_layer(const FastFragments *f)
{
    return f->deepest < f->layers && f->shaded_count + GP_LANES <= f->room;
}

void fast_make_layer(Tile *tile);

/* Whose a fragment is. */
GP_INLINE uint32_t fast_source(const Tile *tile, const FastDraw *d, bool front)
{
    return 2 * (uint32_t)(d - tile->pass->draws) + front;
}

/* As gp_order_key, of depth's codes. */
GP_INLINE itg fast_order_keys(const FastDraw *d, itg codes)
{
    return d->pass->order == GP_ORDER_DEPTH_NEAR_FIRST ? codes : INT32_MAX - codes;
}

/* Lanes whose fragments are of the slice. */
GP_INLINE msk fast_of_slice(const FastFragments *f, itg keys)
{
    return (msk)(keys >= (int32_t)f->first) & (msk)(keys <= (int32_t)f->last);
}

/* Adds a fragment to its list, which has room. */
GP_INLINE void fast_add_fragment(FastFragments *f, uint32_t at, uint32_t key, uint32_t shaded)
{
    const size_t place = (size_t)f->waiting[at]++ * FAST_PIXELS + at;
    f->key[place] = key;
    f->shaded[place] = shaded;
}

/* The same of `live` pixels of some rows from a place on, of what was shaded once: those whose
 * lists are equally long, at once. What sorts fragments takes 20 to 25 % less than one by one.
 * (Chosen by the other lanes, which keep what may never have been set, and not by these: so
 * valgrind can tell that these are.) */
GP_INLINE void fast_add_fragments(FastFragments *f, uint32_t at, int32_t wide, msk live, itg keys,
                                  uint32_t shaded)
{
    const itg waiting = load_rows(f->waiting + at, wide);
    for (unsigned left = msk_bits(live); left;) {
        const int32_t lane = __builtin_ctz(left);
        const uint32_t layer = f->waiting[at + fast_at(lane % wide, lane / wide)];
        const msk others = ~live | (msk)(waiting != (int32_t)layer);
        const size_t place = (size_t)layer * FAST_PIXELS + at;
        uint32_t *key = f->key + place, *number = f->shaded + place;
        store_rows(key, wide, itg_select(others, load_rows(key, wide), keys));
        store_rows(number, wide,
                   itg_select(others, load_rows(number, wide), itg_set((int32_t)shaded)));
        left &= msk_bits(others);
    }
    store_rows(f->waiting + at, wide, waiting - (itg)live);
}

/* Adds the live fragments of shaded packets of an ordered draw, as far as they are of the slice. */
void fast_keep_packets(Tile *tile, const FastDraw *draw, const FastShaded *shaded);

/* Sorts what waits, and blends it; true where another slice begins. */
bool fast_end_slice(Tile *tile);

#endif
