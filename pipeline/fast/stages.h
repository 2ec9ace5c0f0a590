/* The stages that are compiled once for each lane width. */
#ifndef GP_FAST_STAGES_H
#define GP_FAST_STAGES_H

#include "pipeline/fast/frame.h"

/* What one worker needs for the tile it is in; its content is the stages' own. */
typedef struct FastTileMemory FastTileMemory;

typedef struct FastStages {
    int lanes;
    /* Shades vertices [first, first + count) of a draw (counted from its first vertex). */
    void (*shade_vertices)(const FastDraw *draw, uint32_t first, uint32_t count);
    /* Bins primitives [first, end) of a pass: culls, clips where it must, and keeps their order. */
    void (*bin_range)(const FastPass *pass, FastRange *range, uint32_t first, uint32_t end);
    /* Draws one tile of a pass, from clear or load to store. */
    void (*draw_tile)(const FastPass *pass, uint32_t tile, FastTileMemory *memory);
    size_t (*tile_bytes)(void);
} FastStages;

/* The stages of a width: 4, 8 or 16. */
const FastStages *fast_stages(int lanes);

extern const FastStages fast_stages4, fast_stages8, fast_stages16;

#endif
