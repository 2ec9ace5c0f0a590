/* The fast executor: the same bits as the reference, by tiles, lanes and threads.
 *
 * The story of a triangle. A pass is run in three phases, each a heap of items that threads take from
 * a pool (pipeline/pool.h); what an item writes, no other item of its phase reads, so the number of
 * threads cannot show.
 *
 *   1. Vertices (lanes/vertices.c). Blocks of vertices go through the vertex shader, GP_LANES side by
 *      side; each leaves a place on the screen, its varyings, and the planes it is outside of.
 *   2. Bins (lanes/cull.c, bin.c). Ranges of consecutive triangles are culled in lanes; the few that
 *      meet the near or far plane or the guard band are clipped by the reference's own unit. Each
 *      range keeps, for every tile of 64x64 pixels, the numbers of the triangles that may touch it,
 *      in submission order.
 *   3. Tiles (lanes/tile.c). One worker owns a tile at a time. It loads or clears the targets into
 *      its own memory (lanes/transfer.c), walks the ranges in order, and stores the result.
 *
 * Inside a tile small triangles are set up GP_LANES at a time (lanes/fill_batch.c), large ones and
 * point sprites row by row (lanes/fill_large.c). Where nothing looks at the colour that was there
 * before, a fragment that passes its tests only leaves the number of its triangle (a *record*); what
 * is still seen at the end is shaded once, in packets of pixels from any triangles (lanes/seen.c). Where
 * it does look, because it blends, discards or brings its own depth, fragments are queued in order and
 * shaded a block of patches at a time (lanes/patch.c).
 * lanes/depth.c and lanes/merge.c are the output end, lanes/sample.c the texture unit.
 *
 * Every value is a function of per-triangle constants and the pixel's position, in the operations
 * that CONVENTIONS.md fixes; that is why all this moving about changes no bit. */
#ifndef GP_FAST_H
#define GP_FAST_H

#include "pipeline/glasspipe.h"

typedef struct GpFast GpFast;

/* Creates the executor with its threads, 1..1024. Errors: GP_ERROR_MEMORY. */
GpResult gp_fast_create(int threads, GpFast **fast, GpError *error);
void gp_fast_destroy(GpFast **fast); /* NULL-safe, sets NULL */
int gp_fast_threads(const GpFast *fast);

/* Runs a checked list with shader code of a width that every program has.
 * errors GP_ERROR_MEMORY */
GpResult gp_fast_run(GpFast *fast, const GpList *list, int lanes, GpCounters *counters,
                     GpError *error);

#endif
