/* Slots: the targets of a group inside a tile. */
#ifndef GP_FAST_SLOTS_H
#define GP_FAST_SLOTS_H

#include "pipeline/fast/draws/group.h"
#include "pipeline/fast/lanes/memory/transfer.h"

/* The group's surfaces, as far as the tile has come to need them. */
typedef struct FastTileSlots {
    const FastSlots *surfaces;
    struct {
        bool held;    /* the slot has the content, not the surface alone */
        bool cleared; /* but not spelled out: each pixel is `value`, as it reads back */
        bool written; /* the surface has another content */
        float value[4];
        float (*sums)[4]; /* where the pixels are, and not in the planes (sums.h); or NULL */
    } color[FAST_COLOR_SLOTS];
    struct {
        bool held, written;
    } depth[FAST_DEPTH_SLOTS];
    _Alignas(64) FastDepthPlanes depth_planes[FAST_DEPTH_SLOTS];
    _Alignas(64) FastPlanes color_planes[FAST_COLOR_SLOTS];
} FastTileSlots;

/* Starts a tile with nothing in its slots; stores those that were written. */
void fast_begin_slots(Tile *tile, const FastSlots *surfaces);
void fast_store_slots(Tile *tile);

/* Clears what the pass clears, and points to its targets; where the pass will draw loads depth, and
 * leaves colours to fast_hold_targets. */
void fast_begin_pass(Tile *tile, const FastPass *pass, bool touched);

/* Makes the planes of a slot hold its surface's content. */
void fast_hold_color(Tile *tile, int slot);
void fast_hold_depth(Tile *tile, int slot);

/* Makes the pass's first targets, so many, hold theirs: as sums or in their planes. */
void fast_hold_targets(Tile *tile, int count, bool as_sums);

/* Makes the first pixels of a slot that is cleared hold its colour. */
void fast_spell_out_first(Tile *tile, int slot);

#endif
