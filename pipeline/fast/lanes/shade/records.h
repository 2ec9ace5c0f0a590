/* Triangle records: what shading needs of the triangles and points of a tile, until they are
 * shaded. */
#ifndef GP_FAST_RECORDS_H
#define GP_FAST_RECORDS_H

#include "pipeline/fast/lanes/memory/tile.h"

enum {
    FAST_RECORDS = 1 << 14, /* that a tile remembers before it shades what is visible */
    FAST_EDGES64 = 1 << 12,
    FAST_NO_RECORD = 0,
};

/* What shading needs of a triangle or point in this tile: a cache line, whose first eight words go
 * into lanes together. Corners, and the edges opposite them, count from the nearest one on. */
typedef struct FastTriangleRecord {
    _Alignas(64) int32_t c1; /* edge 1 at the tile's first centre, modulo 2^32, and its step */
    int32_t step1;           /* in a sub-pixel to the right (low half) and down (high half) */
    int32_t c2, step2;       /* edge 2 */
    int32_t area;            /* doubled; these five are those of small triangles only */
    float ratio1, ratio2;    /* 1/w of corners 1 and 2 over that of corner 0 */
    uint32_t kind;           /* FastRecordKind */
    float face;
    uint16_t edges64;       /* number of the 64-bit edges */
    uint16_t flat;          /* which corner has the flat values */
    const float *corner[3]; /* varyings; of a point the first */
} FastTriangleRecord;

typedef enum FastRecordKind { FAST_EDGES_32, FAST_EDGES_64, FAST_SPRITE } FastRecordKind;

/* Steps of a small triangle's edge, a pixel to the right and one down. */
GP_INLINE int32_t fast_step_right(int32_t step)
{
    return (int16_t)step * GP_SUBPIXELS;
}

GP_INLINE int32_t fast_step_down(int32_t step)
{
    return (step >> 16) * GP_SUBPIXELS;
}

/* Edges of a triangle too large for 32 bits; or a sprite's corner, from the tile's first centre, in
 * sub-pixels, and 1 over its side. */
typedef union FastEdges64 {
    struct {
        int64_t c[3], a[3], b[3];
    } edge;
    struct {
        int32_t left, top;
        float per_step;
    } sprite;
} FastEdges64;

typedef struct FastRecords {
    uint32_t count; /* record 0 stands for none */
    uint32_t edges64_count;
    _Alignas(64) FastTriangleRecord record[FAST_RECORDS];
    FastEdges64 edges64[FAST_EDGES64];
} FastRecords;

GP_INLINE void fast_forget_records(FastRecords *records)
{
    records->count = FAST_NO_RECORD + 1;
    records->edges64_count = 0;
}

#endif
