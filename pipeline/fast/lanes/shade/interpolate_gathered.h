/* Interpolants of gathered packets. */
#ifndef GP_FAST_INTERPOLATE_GATHERED_H
#define GP_FAST_INTERPOLATE_GATHERED_H

#include "pipeline/fast/lanes/shade/interpolate.h"
#include "pipeline/fast/lanes/shade/records.h"

/* What the lanes of a block of gathered packets take their values from. Neighbouring pixels mostly
 * show the same triangle, so its constants are fetched once for a run of lanes. */
enum { FAST_LANE_RUNS = FAST_BLOCK * GP_LANES + GP_LANES }; /* with room to load past the last */
typedef struct FastLaneRuns {
    _Alignas(64) uint32_t record[FAST_LANE_RUNS];
    uint32_t word[8][FAST_LANE_RUNS];                 /* the first of the records */
    float corner[GP_MAX_VARYINGS][3][FAST_LANE_RUNS]; /* v0, v1 - v0, v2 - v0 */
    uint32_t count;
    bool wide; /* some edges do not fit into 32 bits */
} FastLaneRuns;

/* Inputs of a draw's gathered packets: [packet][component]. */
void fast_interpolate_gathered(Tile *tile, const FastDraw *draw, const FastGathered *gathered,
                               int count, flt *in);

#endif
