/* The visibility buffer: of each pixel the triangle record of the fragment in front, not yet
 * shaded. */
#ifndef GP_FAST_VISIBILITY_H
#define GP_FAST_VISIBILITY_H

#include "pipeline/fast/lanes/shade/records.h"

enum { FAST_RUNS = 1 << 10 };

typedef struct FastVisibility {
    _Alignas(64) uint32_t record[FAST_PIXELS];
    uint32_t occluder; /* a record of the whole tile, in front of all that are older */
    uint32_t run_count;
    struct {
        uint32_t first_record, draw;
        uint16_t cells; /* where it is visible: a list */
    } runs[FAST_RUNS];  /* which records belong to which draw */

    /* while what is visible is shaded */
    uint16_t run_of[FAST_RECORDS];
    struct {
        uint8_t x, y;
        uint16_t next; /* 0: the last */
    } cells[1 +
            FAST_TILE * FAST_TILE]; /* parts of the tile, once for each run that is visible there */
} FastVisibility;

/* Starts a pass without records. */
void fast_begin_visibility(Tile *tile);

/* Makes sure that `count` records of the present draw can be added; shades what is visible if
 * not. */
void fast_reserve_records(Tile *tile, uint32_t count);

/* Shades every pixel that shows a record, and forgets the records. */
void fast_flush_visibility(Tile *tile);

#endif
