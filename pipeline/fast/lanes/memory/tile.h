/* One tile on its way: shared by the stages that are compiled for each lane width. */
#ifndef GP_FAST_TILE_H
#define GP_FAST_TILE_H

#include "pipeline/base/clock.h"
#include "pipeline/fast/draws/draw.h"
#include "pipeline/fast/lanes/stages.h"
#include "pipeline/base/lanes.h"
#include "pipeline/fast/lanes/names.h"

typedef double dbl __attribute__((vector_size(8 * GP_LANES)));

/* Exact. */
GP_INLINE dbl dbl_from_itg(itg a)
{
#if GP_LANES == 16 && !defined(__OPTIMIZE__) /* gcc 12 gives up on this conversion at -O0 */
    dbl b;
    for (int lane = 0; lane < GP_LANES; lane++)
        b[lane] = a[lane];
    return b;
#else
    return __builtin_convertvector(a, dbl);
#endif
}

enum {
    FAST_PITCH = FAST_TILE + 16, /* a row of the tile, with room for a packet that runs over */
    FAST_PIXELS = FAST_PITCH * (FAST_TILE + 3),
    FAST_BLOCK = 32,        /* packets of one call of a shader */
    FAST_LAYERS = 8,        /* boxes of one place that wait for each other */
    FAST_SORTED = 64,       /* large triangles that wait to be sorted */
    FAST_AHEAD = 4,         /* packets whose inputs may be written at once, past the last too */
    FAST_RECORDS = 1 << 14, /* triangles that a tile remembers before it shades what it sees */
    FAST_EDGES64 = 1 << 12,
    FAST_RUNS = 1 << 10,
    FAST_NO_RECORD = 0,
    FAST_DEPTH_WINDOWS = FAST_TILE * FAST_TILE / 64 < 16 ? 16 : FAST_TILE * FAST_TILE / 64,
};

/* What shading needs of a triangle or point in this tile: a cache line, whose first eight words go
 * into lanes together. */
typedef struct FastTriangleRecord {
    _Alignas(64) int32_t c1; /* edge 1 at the tile's first centre, modulo 2^32, and what it gains */
    int32_t step1;           /* in a sub-pixel to the right (low half) and down (high half) */
    int32_t c2, step2;       /* edge 2. Both are those of small triangles only */
    float inverse_area, ratio1, ratio2;
    uint32_t kind; /* FastKind */
    float face;
    uint32_t edges64;       /* number of the 64-bit edges */
    const float *corner[3]; /* varyings; of a point the first */
} FastTriangleRecord;

typedef enum FastRecordKind { FAST_EDGES_32, FAST_EDGES_64, FAST_SPRITE } FastRecordKind;

/* What a small triangle's edge gains in a pixel to the right and in one down. */
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
        int64_t c[2], a[2], b[2];
    } edge;
    struct {
        int32_t left, top;
        float per_step;
    } sprite;
} FastEdges64;

/* GP_LANES pixels of one triangle or point: a row, or two rows as 2x2 quads side by side, whose lanes
 * 4q..4q+3 are top left, top right, bottom left, bottom right; or packed, the short rows of a sprite's
 * box one after the other. Pixels past the tile are never live. */
typedef struct FastPacket {
    uint32_t record;
    uint32_t live; /* bit i: lane i; the others stand by as helpers */
    uint8_t x, y;  /* of the first lane, in the tile */
    uint8_t wide;  /* pixels a row, up to GP_LANES; 0: quads */
    bool
        gathered; /* pixels of several small triangles, those of the gathered packet of the same number */
} FastPacket;

/* Of sprites narrower than a packet: as many rows as have room go into one. Most have one width, so what
 * follows from it is kept from sprite to sprite. */
typedef struct FastPacking {
    int32_t wide, rows;  /* pixels a row, 0: not set; rows a packet */
    uint32_t reciprocal; /* times this and divided by 2^16 is divided by `rows`, up to 2^12 */
    itg across, down;    /* of each lane, in sub-pixels */
} FastPacking;

/* GP_LANES pixels of one draw, each of a triangle or point of its own: placed as those of a packet, or
 * packed from anywhere in the tile. Lanes that are not live have some record of the draw too. */
typedef struct FastGathered {
    itg record;
    itg x, y; /* in the tile */
    uint32_t live;
    bool packed, quads;
    itg at; /* of (x, y); only of ordered draws */
} FastGathered;

/* What the lanes of a block of gathered packets take their values from. Neighbouring pixels mostly show the same
 * triangle, so its constants are fetched once for a run of lanes. */
enum { FAST_LANE_RUNS = FAST_BLOCK * GP_LANES + GP_LANES }; /* with room to load past the last */
typedef struct FastLaneRuns {
    _Alignas(64) uint32_t record[FAST_LANE_RUNS];
    uint32_t word[8][FAST_LANE_RUNS];                 /* the first of the records */
    float corner[GP_MAX_VARYINGS][3][FAST_LANE_RUNS]; /* v0, v1 - v0, v2 - v0 */
    uint32_t count;
    bool wide; /* some edges do not fit into 32 bits */
} FastLaneRuns;

/* A colour target inside the tile: A8R8G8B8 as its words, all others by channel, as the floats that
 * reading the texels back would give. */
typedef union FastPlanes {
    uint32_t packed[FAST_PIXELS];
    float channel[4][FAST_PIXELS];
} FastPlanes;

typedef struct FastDepthPlanes {
    _Alignas(64) uint32_t depth[FAST_PIXELS]; /* codes */
    _Alignas(64) uint8_t stencil[FAST_PIXELS];
} FastDepthPlanes;

/* A large triangle that waits for others, and the codes of all its depths in the tile. */
typedef struct FastSortedTriangle {
    GpTriangle triangle;
    int32_t nearest, farthest;
} FastSortedTriangle;

/* What a shader's slot reads in place. */
typedef struct FastFetch {
    GpFormat format;          /* GP_FORMAT_NONE: a surface that no slot of the tile holds */
    const uint32_t *plane[4]; /* of each channel, NULL where all pixels have the same: */
    float same[4];
} FastFetch;

typedef enum FastPhase { FAST_RASTER, FAST_SHADING, FAST_TRANSFER, FAST_PHASES } FastPhase;

struct FastTileMemory {
    /* the clock, where it is asked for */
    bool timed;
    FastPhase phase; /* at work since `mark` */
    double mark, times[FAST_PHASES];
    uint64_t fragments_shaded;

    /* the tile */
    const FastPass *pass;
    int32_t x0, y0, width, height; /* pixels; width and height of what the target has of it */
    int targets;
    GpFormat depth_format;
    FastPlanes *planes[GP_MAX_TARGETS]; /* of the pass's targets, in their slots */
    uint32_t *depth;
    uint8_t *stencil;

    /* the draw at work, and its number */
    const FastDraw *draw;
    uint32_t draw_number;

    uint32_t record_count; /* record 0 stands for none */
    uint32_t occluder;     /* record that is seen wherever the one in `seen` is older */
    uint32_t packet_count;
    uint32_t filled;      /* triangles, since the hierarchical depth were found */
    uint32_t layer_count; /* while any layers wait, no packets do */
    bool layers_alike;    /* all their pixels have one colour: that of the block's first packet */
    FastBox layer_box;    /* in the tile */
    uint32_t layer_record[FAST_LAYERS];

    FastPacking packing;
    uint32_t sorted_count;

    /* the block in the shader */
    const FastPacket *shaded; /* NULL: gathered packets */
    FastFetch fetch[GP_MAX_SAMPLERS];

    /* the group's surfaces, as far as this tile has come to need them */
    const FastSlots *slots;
    struct {
        bool held;    /* the slot has the content, not the surface alone */
        bool cleared; /* but not spelled out: each pixel is `color`, as it reads back */
        bool written; /* the surface has another content */
        float color[4];
    } color_state[FAST_COLOR_SLOTS];
    struct {
        bool held, written;
    } depth_state[FAST_DEPTH_SLOTS];
    _Alignas(64) FastPlanes color_slot[FAST_COLOR_SLOTS];
    _Alignas(64) FastDepthPlanes depth_slot[FAST_DEPTH_SLOTS];

    _Alignas(64) uint32_t
        visibility[FAST_PIXELS]; /* record of the fragment in front, not yet shaded */
    _Alignas(64) int32_t
        hierarchical_depth[FAST_DEPTH_WINDOWS];             /* codes: see hierarchical_depth.h */
    _Alignas(64) FastPacket packets[FAST_BLOCK];            /* waiting for the shader, in order */
    _Alignas(64) float packet_depth[FAST_BLOCK * GP_LANES]; /* of packets whose tests come late */
    _Alignas(64) FastGathered gathered[FAST_BLOCK];
    FastSortedTriangle sorted[FAST_SORTED];
    uint8_t sorted_order[FAST_SORTED]; /* front to back, as far as it is free */
    uint32_t edges64_count;
    _Alignas(64) FastTriangleRecord records[FAST_RECORDS];
    FastEdges64 edges64[FAST_EDGES64];
    struct {
        uint32_t first_record, draw;
        uint16_t cells; /* what is seen of it: a list */
    } runs[FAST_RUNS];  /* which records belong to which draw */
    uint32_t run_count;
    uint16_t run_of[FAST_RECORDS]; /* while what is seen is shaded */
    struct {
        uint8_t x, y;
        uint16_t next; /* 0: the last */
    } cells[1 +
            FAST_TILE * FAST_TILE]; /* parts of the tile, once for each run that is seen there */

    _Alignas(64) FastLaneRuns lane_runs;

    /* a block's values: [packet][component][lane] */
    _Alignas(64) float in[(FAST_BLOCK + FAST_AHEAD) * GP_MAX_VARYINGS * GP_LANES];
    _Alignas(64) float color[FAST_BLOCK * GP_MAX_TARGETS * 4 * GP_LANES];
    _Alignas(64) float pixel[FAST_BLOCK * 2 * GP_LANES];
    _Alignas(64) float face[FAST_BLOCK * GP_LANES];
    _Alignas(64) float shader_depth[FAST_BLOCK * GP_LANES];
    _Alignas(64) int32_t killed[FAST_BLOCK * GP_LANES];
};

typedef struct FastTileMemory Tile;

/* --- small things ------------------------------------------------------------------------------------ */

GP_INLINE itg lane_numbers(void)
{
    itg numbers;
    for (int lane = 0; lane < GP_LANES; lane++)
        numbers[lane] = lane;
    return numbers;
}

/* a * b - c * d modulo 2^32: right wherever it fits, which is all that is asked; lanes whose triangle
 * is too large for it are found by its size and taken alone. */
GP_INLINE itg cross_lanes(itg a, itg b, itg c, itg d)
{
    return (itg)((utg)a * (utg)b - (utg)c * (utg)d);
}

GP_INLINE uint32_t fast_at(int32_t x, int32_t y)
{
    return (uint32_t)(y * FAST_PITCH + x);
}

/* Turns to another phase; returns the one before, to turn back to. */
GP_INLINE FastPhase fast_turn_to(Tile *tile, FastPhase phase)
{
    FastPhase before = tile->phase;
    if (tile->timed)
        tile->times[before] += fast_clock_lap(&tile->mark);
    tile->phase = phase;
    return before;
}

/* Rasterizes triangles of the present draw that are inside all planes: any number, of any size.
 * Primitives are those of the pass. */
void fast_fill_triangles(Tile *tile, const uint32_t *primitives, uint32_t count);

/* The same for any number of points; whose vertices are better asked for some time before. */
void fast_fill_sprites(Tile *tile, const uint32_t *primitives, uint32_t count);
void fast_prefetch_points(const FastDraw *draw, const FastPrimitiveMask *mask);

/* Varyings of a draw that shades again. Vertices count from the draw's first, and rise within a packet.
 * out  varying: [packet][component][lane]; packets: FAST_SPRITE_BATCHES at most */
void fast_shade_varyings(const FastDraw *draw, const uint32_t (*vertex)[GP_LANES], uint32_t packets,
                         float *varying);

/* Rasterizes one set-up triangle into the tile, by the fragment path of its draw; now, or with those that are
 * kept. Nearest: no depth's code is below. */
void fast_fill_triangle(Tile *tile, const GpTriangle *triangle);
void fast_fill_large(Tile *tile, const GpTriangle *triangle, int32_t nearest);

/* The tile's part of what the draw may touch. */
GpRect fast_tile_rect(const Tile *tile, const FastDraw *draw);

/* A vertex of the draw, for the units that take one triangle at a time. */
void fast_corner_of(const FastDraw *draw, uint32_t number, GpScreenVertex *corner);

/* Makes sure that `count` records of the present draw can be added; shades what is seen if not. */
void fast_reserve_records(Tile *tile, uint32_t count);

/* Queues pixels of an ordered draw for its shader; `live` is not 0, depth matters where tests come
 * late. Records stay in place until their packets are shaded. */
void fast_queue_row(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live, flt depth);
void fast_queue_quads(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live, flt depth);

/* Queues every pixel of a box in the tile, by rows, of an ordered draw without depth. */
void fast_queue_box(Tile *tile, uint32_t record, const FastBox *box);

/* Shades the boxes that wait. */
void fast_shade_layers(Tile *tile);

/* Shades the queued packets, all of the tile's present draw, and blends them in their order. */
void fast_flush_packets(Tile *tile);

/* The same for packets that wait somewhere else, of any draw. Depths: [packet][lane], or NULL. */
void fast_shade_packets(Tile *tile, const FastDraw *draw, const FastPacket *packets, int count,
                        const float *depths);

/* Where the nearest fragment of the draw wins: keeps a large triangle until others can be sorted with
 * it; and fills those that are kept, front to back. Before any other fragment of the draw is made. */
void fast_sort_triangle(Tile *tile, const GpTriangle *triangle);
void fast_fill_sorted(Tile *tile);

/* Brings `seen` up to date with the full-tile occluder. */
void fast_settle_occluder(Tile *tile);

/* Shades every pixel that shows a record, and forgets the records. */
void fast_flush_visibility(Tile *tile);

/* Runs the pixel shader over `count` packets whose inputs are in tile->in, and whose tile->pixel
 * and tile->face are set where the program uses them. Packets: the packets', or NULL where they are
 * gathered packets. */
void fast_run_pixel_shader(Tile *tile, const FastDraw *draw, const FastPacket *packets, int count);

/* Blends and writes shaded packets, of packet i the lanes live[i]; color is [packet][target][channel]. */
void fast_blend_packets(Tile *tile, const FastDraw *draw, const FastPacket *packets,
                        const unsigned *live, int count, const flt *color);

/* Whether a draw's sprites only add to targets of floats; and how a block of their packets, rows or
 * packed, is blended then: color is [packet][target][channel]. */
bool fast_only_adds(const Tile *tile, const FastDraw *draw);
void fast_add_packets(Tile *tile, const FastDraw *draw, const FastPacket *packets,
                      const unsigned *live, int count, const flt *color);

/* The same for one target whose blend is bitwise. A packet of a gathered packet may hold a pixel several times. */
void fast_blend_bits(const Tile *tile, const GpBlend *blend, FastPlanes *planes,
                     const FastPacket *packets, const unsigned *live, int count, const flt *color,
                     int stride);

/* All layers that wait, of a draw that copies words (FastDraw.copied_slot). False, and nothing done,
 * where the tile does not hold the words that are copied. */
bool fast_copy_layers(Tile *tile, const FastDraw *draw);

/* Starts a tile with nothing in its slots; stores those that were written. */
void fast_begin_slots(Tile *tile, const FastSlots *slots);
void fast_store_slots(Tile *tile);

/* Clears what the pass clears, and points to its targets; loads them where the pass will draw. */
void fast_begin_pass(Tile *tile, const FastPass *pass, bool touched);

/* gp_load_local, from slots or surfaces: the call's `local` is the tile. Each slot that the program
 * reads is made ready before a block's call. */
void fast_begin_fetch(Tile *tile, const GpTexture *textures, int slot);
void fast_fetch_framebuffer(const GpShaderCall *call, int slot, int packet, int lanes,
                            float *texel);

#endif
