/* What the stages of the fast executor hand to each other: see fast.h for the story. */
#ifndef GP_FAST_FRAME_H
#define GP_FAST_FRAME_H

#include "pipeline/clip.h"
#include "pipeline/glasspipe.h"
#include "pipeline/interpolate.h"
#include "pipeline/setup.h"
#include "pipeline/vertex_stage.h"
#include "pipeline/viewport.h"

enum {
    FAST_TILE = 64,          /* pixels a side */
    FAST_VERTEX_BLOCK = 256, /* vertices of one item of work */
    FAST_RANGE = 16384,      /* primitives of one item of work */
};

/* How a draw's fragments reach the targets. */
typedef enum FastRoute {
    FAST_DEPTH_ONLY, /* no pixel shader: depth and stencil alone */
    FAST_VISIBLE,    /* each fragment replaces all that was there: shade what is seen at the end */
    FAST_ORDERED,    /* blended, discarding, or with its own depth: one after the other */
    FAST_NOTHING,    /* changes nothing */
} FastRoute;

/* A vertex on the screen; one that is outside some plane has no place there (see `outside`). */
typedef struct FastPosition {
    int32_t x, y; /* 24.8 fixed point */
    float z, rw;
} FastPosition;

/* Pixels, ends included. */
typedef struct FastBox {
    int32_t x0, y0, x1, y1;
} FastBox;

typedef struct FastDraw {
    const GpPass *pass;
    const GpDraw *draw;
    const GpProgramCode *code;
    GpNeeds needs;
    FastRoute route;
    bool late_depth;  /* the pixel shader comes before depth and stencil */
    bool wants_depth; /* depth or stencil is touched at all */
    GpVaryingModes modes;
    GpViewport viewport; /* resolved */
    GpRect rect;         /* pixels that viewport, targets and scissor allow */
    GpGuardBand band;
    struct FastSampler *samplers; /* [GP_MAX_SAMPLERS], where the program reads textures */

    uint32_t first_vertex, vertex_count;
    uint32_t first_block;     /* of all vertex blocks of the pass */
    uint32_t first_primitive; /* of all primitives of the pass */
    uint32_t primitive_count;

    /* shaded vertices, vertex first_vertex first */
    FastPosition *positions;
    uint8_t *outside;   /* bit i: outside clip plane i; 0xff: no number, draws nothing */
    float *varyings;    /* stride floats a vertex: varyings, then clip distances in use */
    float *point_sizes; /* points only */
    uint32_t stride;    /* a multiple of 4 */
} FastDraw;

/* A triangle that the clipper cut: its fan, as triangles of three corners of their own. */
typedef struct FastCut {
    uint32_t primitive; /* of the pass */
    uint32_t first, corners;
} FastCut;

enum { FAST_CHUNK = 14 };         /* primitives of one chunk: 64 bytes with its header */
#define FAST_CUT_FLAG 0x80000000u /* on a primitive's number: look it up in the cuts */

/* Some primitives of one tile; chunks of a tile are linked in order. */
typedef struct FastChunk {
    uint32_t count;
    uint32_t next; /* chunk number, 0: the last */
    uint32_t primitive[FAST_CHUNK];
} FastChunk;

/* Primitives of one range, by tiles, in submission order. Kept from frame to frame. */
typedef struct FastRange {
    uint32_t *head, *tail; /* [tiles], chunk numbers, 0: none */
    uint32_t tile_room;
    FastChunk *chunks; /* number 0 stays unused */
    uint32_t chunk_count, chunk_room;

    FastCut *cuts; /* by rising primitive */
    uint32_t cut_count, cut_room;
    GpScreenVertex *corners; /* of the cuts */
    float *corner_varyings;  /* GP_MAX_VARYINGS floats a corner */
    uint32_t corner_count, corner_room, varying_room;
    uint64_t clipped;
    bool failed; /* no memory */
} FastRange;

typedef struct FastPass {
    const GpPass *pass;
    uint32_t width, height;
    uint32_t tiles_x, tiles_y;
    FastDraw *draws;
    uint32_t draw_count;
    uint32_t block_count, primitive_count, range_count;
    FastRange *ranges;
} FastPass;

/* Draw that an item of a rising series belongs to: the last whose first item is not above it. */
uint32_t fast_find_draw(const FastPass *pass, uint32_t primitive);
uint32_t fast_find_block(const FastPass *pass, uint32_t block);

/* Starts a range for a pass with so many tiles; false when memory is short. */
bool fast_range_begin(FastRange *range, uint32_t tiles);
void fast_range_free(FastRange *range);

/* Adds a primitive to the bin of every tile that the pixels x0..x1, y0..y1 touch; notes a failure in
 * the range. */
void fast_bin_box(const FastPass *pass, FastRange *range, uint32_t primitive, const FastBox *box);

/* Bins one primitive, whatever it is: a point, a triangle of any size, one to be clipped. */
void fast_bin_primitive(const FastPass *pass, const FastDraw *draw, FastRange *range,
                        uint32_t primitive);

/* The cut of a primitive that was binned with FAST_CUT_FLAG. */
const FastCut *fast_find_cut(const FastRange *range, uint32_t primitive);

#endif
