/* The fast executor: the same bits as the reference, by tiles, lanes and threads.
 *
 * The story of a triangle. Passes that read each other's targets only in place form a group (group.h).
 * A group is prepared (prepare.c), and run in three phases (rounds.c), each a heap of items that
 * threads take from a pool (pipeline/base/pool.h); what an item writes, no other item of its phase reads,
 * so the number of threads cannot show.
 *
 *   1. Vertices (lanes/vertices.c). Blocks of vertices go through the vertex shader, GP_LANES side by
 *      side; each leaves a place on the screen, its varyings, and the planes it is outside of.
 *   2. Bins (lanes/cull.c, bin.c). Ranges of consecutive triangles are culled in lanes; the few that
 *      meet the near or far plane or the guard band are clipped by the reference's own unit. Each
 *      range keeps, for every tile of 64x64 pixels, the triangles that may touch it, as groups of
 *      neighbours, in submission order.
 *   3. Tiles (lanes/tile.c). One worker owns a tile at a time. It loads or clears the targets into
 *      slots of its own memory (lanes/slots.c, lanes/transfer.c), walks the ranges of each pass in
 *      order, and stores what was written.
 *
 * Memory is bounded: where shaded vertices or bins reach their limit, what is there is drawn into the
 * targets, and the group goes on from there.
 *
 * Inside a tile triangles are set up GP_LANES at a time (lanes/batch.c): tiny ones are filled pixel by
 * pixel (lanes/fill_tiny.c), small ones some rows at a time (lanes/fill_small.c), large ones row by
 * row (lanes/fill_large.c); those behind the farthest depths around them are left out before
 * (lanes/farthest.c). Point sprites have a short way of their own (lanes/sprite.c); where they only combine bits, their
 * pixels share packets (lanes/pack_points.c).
 *
 * Where nothing looks at the colour that was there before, a fragment that passes its tests only
 * leaves the number of its triangle (a *record*). What is still seen at the end is shaded once: rows
 * of one triangle as patches, all else as mixes of pixels of any triangles (lanes/seen.c, lanes/mix.c,
 * lanes/write.c). Where it does look, because it blends, discards or brings its own depth, fragments
 * are queued in order and shaded a block of patches at a time (lanes/patch.c): the loose pixels of tiny
 * triangles side by side (lanes/fill_loose.c), boxes that lie one on the other as layers, all of them on
 * a few pixels before the next pixels (lanes/layers.c). Where it only discards, and nearer fragments
 * hide others, large triangles are filled front to back (lanes/front_to_back.c).
 *
 * lanes/depth.c, lanes/merge.c and lanes/merge_bits.c are the output end, lanes/sample.c the texture unit.
 *
 * Every value is a function of per-triangle constants and the pixel's position, in the operations
 * that CONVENTIONS.md fixes; that is why all this moving about changes no bit. */
#ifndef GP_FAST_H
#define GP_FAST_H

#include "pipeline/list/counters.h"
#include "pipeline/list/list.h"

typedef struct GpFast GpFast;

/* Creates the executor with its threads, 1..1024. Errors: GP_ERROR_MEMORY. */
GpResult gp_fast_create(int threads, GpFast **fast, GpError *error);
void gp_fast_destroy(GpFast **fast); /* NULL-safe, sets NULL */
int gp_fast_threads(const GpFast *fast);

/* Bytes of shaded vertices, and of bins, after which what is there is drawn before more is made. Any
 * number gives the same bits; for tests. */
void gp_fast_set_limit(GpFast *fast, size_t bytes);

/* As gp_list_check, by all threads. */
GpResult gp_fast_check(GpFast *fast, const GpList *list, GpError *error);

/* Runs a checked list with shader code of a width that every program has.
 * in   timed: looks at the clock inside tiles too
 * errors GP_ERROR_MEMORY */
GpResult gp_fast_run(GpFast *fast, const GpList *list, int lanes, bool timed, GpCounters *counters,
                     GpPhases *phases, GpError *error);

#endif
