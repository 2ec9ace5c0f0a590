/* Interpolants of packets. What does not change in a run, of packets of one triangle and one shape,
 * is found once. */
#ifndef GP_FAST_INTERPOLATE_PACKETS_H
#define GP_FAST_INTERPOLATE_PACKETS_H

#include "pipeline/fast/lanes/shade/interpolate.h"
#include "pipeline/fast/lanes/shade/records.h"

/* An edge function in this tile, in 32 bits, in units of `unit`, a power of two. */
typedef struct FastEdge {
    int32_t c, a, b;
    float unit;
} FastEdge;

/* Those of a triangle, and 1 over its doubled area. */
typedef struct FastNarrowEdges {
    FastEdge edge[3]; /* 0 only for weights in perspective */
    float inverse_area;
} FastNarrowEdges;

/* False where an edge needs more bits. */
bool fast_narrow_edges(const FastRecords *records, const FastTriangleRecord *triangle,
                       bool perspective, FastNarrowEdges *edges);

/* Whether weights in perspective are wanted, and differ from those on the screen. */
bool fast_needs_perspective(const FastDraw *draw, const FastTriangleRecord *triangle);

/* Weights of a run. */
void fast_find_weights(const FastDraw *draw, const FastTriangleRecord *triangle,
                       const FastNarrowEdges *edges, bool perspective, const FastPacket *packets,
                       int count, FastWeights *weights);

/* A component of a triangle: at its first corner, and how it differs at the others. */
typedef struct FastComponent {
    flt v0, to1, to2;
} FastComponent;

/* Those that are not flat, for many runs. */
void fast_prepare_components(const FastDraw *draw, const FastTriangleRecord *triangle,
                             FastComponent prepared[GP_MAX_VARYINGS]);

/* A run's inputs, from its weights: [packet][component]. */
void fast_interpolate_prepared(const FastDraw *draw, const FastTriangleRecord *triangle,
                               const FastComponent prepared[GP_MAX_VARYINGS],
                               const FastWeights *weights, int count, flt *in);

/* Inputs of any packets: [packet][component]. */
void fast_interpolate_packets(Tile *tile, const FastDraw *draw, const FastPacketBlock *packets,
                              flt *in);

#endif
