/* The fast executor: the same bits as the reference, by tiles, lanes and threads.
 *
 * The story of a triangle. Passes that read each other's targets only in place form a group
 * (draws/group.h). A group is prepared (prepare.c), and run in three phases (rounds.c), each a heap
 * of items that threads take from a pool (pipeline/base/pool.h); what an item writes, no other item
 * of its phase reads, so the number of threads cannot show.
 *
 *   1. Vertices (geometry/vertices.c). Blocks of vertices go through the vertex shader, GP_LANES
 *      side by side; each leaves a place on the screen, its varyings, and the planes it is outside
 *      of.
 *   2. Bins (geometry/cull.c, draws/bin.c). Ranges of consecutive triangles are culled in lanes;
 *      the few that meet the near or far plane or the guard band are clipped by the reference's own
 *      unit. Each range has, for every tile of 64x64 pixels, the triangles that may touch it, as
 *      masks of neighbours, in submission order.
 *   3. Tiles (tile/draw_tile.c). One worker owns a tile at a time. It loads or clears the targets
 *      into slots of its own memory (memory/slots.c, memory/transfer.c), walks the ranges of each
 *      pass in order, and stores what was written.
 *
 * Memory is bounded: where shaded vertices or bins reach their limit, what is there is drawn into
 * the targets, and the group goes on from there. Only a pass that sorts its fragments needs all of
 * its vertices and bins at once; of the fragments themselves a tile draws a slice after the other.
 *
 * Inside a tile triangles are set up GP_LANES at a time (raster/batch.c): tiny ones are filled
 * pixel by pixel (raster/fill_tiny.c), small ones some rows at a time (raster/fill_small.c), large
 * ones row by row (raster/fill_large.c); those behind the hierarchical depth around them are left
 * out before, and, where nothing looks at depth, all that a later cover of the tile hides
 * (raster/corners.h). Point sprites have a short way of their own (raster/sprite.c); where they
 * only combine bits, add to floats or leave their depth, their pixels share packets
 * (raster/pack_points.c), and sums of a pixel stand side by side (output/blend_add.c).
 *
 * Fragments take the path of their draw (raster/fragment_path.h). Where nothing looks at the colour
 * that was there before, a fragment that passes its tests only leaves the number of its triangle's
 * record in the visibility buffer; what is visible at the end is shaded once (shade/visibility.c).
 * Where it does look, because it blends, discards or brings its own depth, fragments are queued in
 * order and shaded a block of packets at a time (shade/queue.c, shade/packets.c): the pixels of
 * tiny triangles side by side (raster/fill_compacted.c), boxes that lie one on the other as layers
 * (shade/layers.c). Where it only discards, and nearer fragments hide others, large triangles are
 * sorted (raster/sorted_triangles.c).
 *
 * Where the pass sorts, shaded fragments wait in the tile's lists (shade/fragments.c) until all
 * have come, and are sorted and blended then, the pixels of a packet side by side
 * (shade/blend_sorted.c). Those of triangles that have one colour each are there before it is found
 * (raster/fill_one_color.c, shade/one_color.c).
 *
 * Passes that draw again what an earlier one of their group drew, as peeling does, have its
 * vertices and bins (draws/repeat.h); and where primitives alone decide on fragments, a tile finds
 * and interpolates them once and keeps them, as packets that are full (shade/repeated.h).
 *
 * output/depth.c and output/blend.c are the output end, texture/sample.c is the texture unit.
 *
 * Every value is a function of per-triangle constants and the pixel's position, in the operations
 * that CONVENTIONS.md fixes; that is why all this moving about changes no bit.
 *
 * Floors, from the ground; a file includes and calls its own folder and those below. What is in
 * lanes/ is compiled once for each width; lanes/names.h tells the copies apart:
 *   draws/                            what is prepared: draws, passes, groups, bins, samplers
 *   lanes/memory/                     a tile's place, targets, packets
 *   lanes/texture/, lanes/output/     the texture unit; the output end
 *   lanes/geometry/, lanes/shade/     vertices and culling; fragments and their shaders
 *   lanes/raster/                     which pixels a primitive covers
 *   lanes/tile/                       one tile, from clear to store
 *   fast/                             lists: preparing, phases, rounds
 *
 * Glossary.
 *   packet                GP_LANES fragments: a row, 2x2 quads, or the short rows of a sprite
 *   gathered packet       its fragments are of several triangles, placed as a packet's or from
 *                         anywhere
 *   compacted fragments   those of tiny triangles, put side by side in gathered packets
 *   triangle record       what shading needs of a triangle or point: edges, ratios, corners
 *   visibility buffer     of each pixel the record in front, not yet shaded
 *   full-tile occluder    a record in front of all older ones, everywhere in the tile
 *   hierarchical depth    the farthest depth of each window of the tile
 *   sorted triangles      large ones that wait to be filled front to back
 *   fragment path         depth only, visible, ordered, or nothing
 *   early test            depth, before the shader; a late one comes after it
 *   layer                 one of several boxes on the same pixels, shaded together
 *   block                 packets of one call of a shader
 *   batch                 GP_LANES primitives that are set up side by side
 *   primitive mask        neighbours of one draw that touch a tile
 *   clip polygon          what the clipper leaves of a triangle, as a fan
 *   edge step             how an edge function changes a pixel to the right or down
 *   64-bit edge           of triangles too large for 32 bits
 *   weight                barycentric, of corners 1 and 2; or of a texel, in 256ths
 *   slot                  room of a group's target in tile memory
 *   framebuffer fetch     a shader reads what its pixel holds in a target
 *   to quantize           to make of a value what reading it back from its target gives
 *   non-temporal          stores past the caches, of what no one reads soon
 *   range                 consecutive primitives that are binned by one worker */
#ifndef GP_FAST_H
#define GP_FAST_H

#include "pipeline/list/counters.h"
#include "pipeline/list/list.h"

typedef struct GpFast GpFast;

/* Creates the executor with its threads, 1..1024. Errors: GP_ERROR_MEMORY. */
GpResult gp_fast_create(int threads, GpFast **fast, GpError *error);
void gp_fast_destroy(GpFast **fast); /* NULL-safe, sets NULL */
int gp_fast_threads(const GpFast *fast);

/* Bytes that running a list may take, beside the surfaces and the geometry that it names: at the
 * most, but for bins of passes that sort, whose size depends on how many tiles a triangle meets.
 * What a run that lacks memory says. in list: checked */
uint64_t gp_fast_memory(const GpFast *fast, const GpList *list, int lanes);

/* Bytes of shaded vertices, and of bins, after which what is there is drawn before more is made,
 * but for passes that sort; and of a tile's sorted fragments. Any number gives the same bits; for
 * tests. */
void gp_fast_set_limit(GpFast *fast, size_t bytes);

/* As gp_list_check, by all threads, which read indices in lanes of a width that the build has and
 * the processor runs; the list may run in another. */
GpResult gp_fast_check(GpFast *fast, const GpList *list, int lanes, GpError *error);

/* Runs a checked list with shader code of a width that every program has.
 * in   timed: looks at the clock inside tiles too
 * errors GP_ERROR_MEMORY */
GpResult gp_fast_run(GpFast *fast, const GpList *list, int lanes, bool timed, GpCounters *counters,
                     GpPhases *phases, GpError *error);

#endif
