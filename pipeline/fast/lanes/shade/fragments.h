/* Fragments of a pass that sorts: shaded, they wait in lists of their pixels until all have come.
 *
 * Where a tile has more of them than there is room for, it is drawn in slices: those whose turn comes
 * first are kept, by their keys, and blended; then all draws of the pass come again, for the rest.
 * A slice ends between two keys, so equal depths are never parted; if even those of one key are too
 * many they are blended as they come, which is their order. No bit depends on where slices end. */
#ifndef GP_FAST_FRAGMENTS_H
#define GP_FAST_FRAGMENTS_H

#include "pipeline/fast/lanes/output/shaded.h"

typedef struct FastFragments {
    void *memory; /* of the lists, and of what was shaded */
    size_t bytes;
    uint64_t sorted, slices; /* counted */

    uint32_t first, last;  /* keys of the present slice, ends included */
    uint32_t layers, room; /* of a pixel, and of what was shaded */
    uint32_t targets;
    uint32_t shaded_count;
    uint8_t waiting[FAST_PIXELS]; /* of each pixel */

    /* [layer][pixel], as they came: gp_order_key, and the number of what was shaded */
    uint32_t *key, *shaded;

    /* what was shaded, by numbers that rise as it came */
    float *color;     /* [number][target][channel] */
    uint32_t *source; /* twice the draw's number, plus 1 where it shows its front */
    uint32_t *moved;  /* its next number, while some are dropped */
} FastFragments;

/* Memory without which nothing can be sorted. */
size_t fast_least_fragment_bytes(void);

/* Begins the first slice of the present pass. */
void fast_begin_fragments(Tile *tile);

/* Adds the live fragments of shaded packets of an ordered draw, as far as they are of the slice. */
void fast_keep_packets(Tile *tile, const FastDraw *draw, const FastShaded *shaded);

/* Sorts what waits, and blends it; true where another slice begins. */
bool fast_end_slice(Tile *tile);

#endif
