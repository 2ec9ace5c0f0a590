/* Groups: passes that run tile by tile, all of them in one tile before the next tile's turn, so
 * that their targets stay in tile memory from the first pass to the last (CONVENTIONS.md,
 * Groups). */
#ifndef GP_FAST_GROUP_H
#define GP_FAST_GROUP_H

#include "pipeline/fast/draws/draw.h"

/* The surfaces that a group draws to or reads in place, each with its slot in tile memory. */
typedef struct FastSlots {
    const GpSurface *color[FAST_COLOR_SLOTS]; /* NULL: free */
    const GpSurface *depth[FAST_DEPTH_SLOTS];
} FastSlots;

/* Passes that run tile by tile, all of them in one tile before the next tile's turn. */
typedef struct FastGroup {
    FastPass *passes;
    uint32_t pass_count;
    /* some pass's fragments are sorted: of these all vertices and bins are made at once */
    bool sorts;
    FastSlots slots;
    uint32_t block_count, range_count;
    uint32_t repeated; /* draws whose fragments are kept: repeat.h */
    bool is_whole;     /* all that the group has is drawn now */
    bool timed;        /* tiles look at the clock */
} FastGroup;

/* Gives slots to the targets of a pass that have none yet; false, with nothing changed, where there
 * are too few. An empty set is large enough for any one pass. */
bool fast_slots_add(FastSlots *slots, const GpPass *pass);

/* The same for what its draws read in place, as far as slots are left: rows of tiles are read
 * quicker than texels one by one. After the targets of all passes. */
void fast_slots_add_reads(FastSlots *slots, const GpPass *pass);

/* Slot of a target, or of what is read; -1: none. */
int fast_color_slot(const FastSlots *slots, const GpSurface *surface);
int fast_depth_slot(const FastSlots *slots, const GpSurface *surface);

#endif
