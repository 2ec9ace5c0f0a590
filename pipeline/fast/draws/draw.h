/* Draws and passes, made ready for the stages. */
#ifndef GP_FAST_DRAW_H
#define GP_FAST_DRAW_H

#include "pipeline/list/list.h"
#include "pipeline/list/needs.h"
#include "pipeline/units/clip.h"
#include "pipeline/units/interpolate.h"
#include "pipeline/units/viewport.h"

/* A power of two, 16..64: edges across a tile fit into 32 bits. No bit depends on it, which builds
 * with other sizes show. */
#ifndef GP_TILE
#define GP_TILE 64
#endif

enum {
    FAST_TILE = GP_TILE,        /* pixels a side */
    FAST_WIDEST = 16,           /* lanes of the widest packet */
    FAST_VERTEX_BLOCK = 256,    /* vertices of one item of work */
    FAST_LEAST_IN_RANGE = 4096, /* primitives of one item of work */
    FAST_MOST_IN_RANGE = 16384,

    /* surfaces that a tile's memory holds at once: the targets of a pass, and colours that it reads
     * in place; and some more of its group. What else is read in place is read from where it is */
    FAST_COLOR_SLOTS = GP_MAX_TARGETS + GP_MAX_SAMPLERS + 4,
    FAST_DEPTH_SLOTS = 2,

    FAST_REPEATED = 64, /* draws of a group whose fragments a tile keeps from pass to pass */
};

_Static_assert(FAST_TILE >= 16 && FAST_TILE <= 64 && !(FAST_TILE & (FAST_TILE - 1)), "tiles");

/* Surfaces of so many bytes find no room in a core's own caches: what a tile writes to them, and no
 * one reads before the frame is done, is stored past the caches. */
enum { FAST_PAST_CACHES = 4 << 20 };

static inline bool fast_is_past_caches(const GpSurface *surface)
{
    return surface->level[0].pitch * surface->level[0].height >= FAST_PAST_CACHES;
}

/* How a draw's fragments reach the targets. */
typedef enum FastFragmentPath {
    FAST_DEPTH_ONLY, /* no pixel shader: depth and stencil alone */
    FAST_VISIBLE, /* each fragment replaces all that was there: shade what is visible at the end */
    FAST_ORDERED, /* blended, discarding, or with its own depth: one after the other */
    FAST_NOTHING, /* changes nothing */
} FastFragmentPath;

/* x of a vertex that has no place on the screen is far to the left of every one that has, plus a
 * bit for each clip plane that the vertex is outside of; all bits: it is no number, and draws
 * nothing. */
#define FAST_NOWHERE (-(1 << 30))
enum { FAST_OUTSIDE_ALL = 0xff };

/* A vertex on the screen. */
typedef struct FastPosition {
    int32_t x, y; /* 24.8 fixed point */
    float z;
    union {
        float rw;
        float size; /* of a point, which has no use for rw */
    };
} FastPosition;

/* The planes that a vertex is outside of; 0: it has a place. */
static inline unsigned fast_outside(const FastPosition *position)
{
    return position->x < FAST_NOWHERE / 2 ? (unsigned)(position->x - FAST_NOWHERE) : 0;
}

/* Pixels, ends included. */
typedef struct FastBox {
    int32_t x0, y0, x1, y1;
} FastBox;

static inline bool fast_box_is_empty(const FastBox *box)
{
    return box->x1 < box->x0 || box->y1 < box->y0;
}

/* Of a draw that others of its group repeat: those whose fragments are found by primitives
 * alone. */
typedef struct FastRepeats {
    uint32_t draws;
    bool depth; /* all of them look at the rasterizer's depth, or none */
    uint64_t varyings;
    uint32_t number; /* as FastDraw.repeated */
} FastRepeats;

typedef struct FastDraw {
    const GpPass *pass;
    const GpDraw *draw;
    const GpProgramCode *code;
    GpNeeds needs;
    FastFragmentPath path;
    bool late_depth;  /* the pixel shader comes before depth and stencil */
    bool wants_depth; /* depth or stencil is touched at all */
    bool sorted;      /* fragments wait for all of their pixel: shade/fragments.h */
    /* and meet depth and stencil when they have their turn, if at all; otherwise nothing in the
     * pass writes these, and tests are as early as ever */
    bool tests_last;
    /* sorted, and all fragments of a triangle have one colour, which is found once:
     * shade/one_color.c */
    bool one_color;
    bool nearest_wins; /* ordered, but only equal depths need their order: see sorted_triangles.c */
    uint32_t epsilon;  /* of the ternary test, as a depth code */
    /* of a few triangles; its colour differs only where what it reads in place does, and nothing
     * but targets changes: see even_tile.c */
    bool is_even;
    bool packs_points; /* fragments of several points share packets: see pack_points.c */
    bool only_adds;    /* blending does nothing but add, to targets of floats */
    bool shades_again; /* varyings are not stored, but found where points are packed */
    /* 1 + the slot whose texels, read in place, are all that its shader gives; or 0 */
    int shown_slot;
    bool copies_words; /* of that slot, as they are, into its target's */
    GpVaryingModes modes;
    uint64_t varyings_by[3];       /* components that are read, by GpInterpolation */
    GpBlend blend[GP_MAX_TARGETS]; /* as the targets' formats make them */
    GpViewport viewport;           /* resolved */
    GpRect rect;                   /* pixels that viewport, targets and scissor allow */
    GpGuardBand band;
    const struct FastSampler *samplers; /* [GP_MAX_SAMPLERS]; none where the program reads none */

    /* vertex numbers, three a triangle or one a point, whatever the geometry's own way to say them;
     * NULL: vertices in order */
    const uint32_t *indices;
    uint32_t first_vertex, vertex_count;
    uint32_t first_block; /* of all vertex blocks of the pass */
    uint32_t block_count;
    uint32_t first_primitive; /* of all primitives of the pass */
    uint32_t primitive_count;

    /* shaded vertices, vertex first_vertex first */
    FastPosition *positions;
    /* stride floats a vertex: varyings, then clip distances in use; none of points that are not on
     * the screen, or of a draw that shades again */
    float *varyings;
    uint32_t stride; /* a multiple of 4 */

    /* draws that come again (repeat.h) */
    struct FastDraw *first; /* whose vertices these are, and primitives; NULL: its own */
    FastRepeats repeats;
    uint32_t repeated; /* the number of its fragments, which a tile finds once; 0: none */
} FastDraw;

/* What is interpolated for the pixel shader. */
static inline void fast_need_varyings(FastDraw *draw, uint64_t varyings)
{
    draw->needs.varyings |= varyings;
    for (uint64_t left = varyings; left; left &= left - 1)
        draw->varyings_by[draw->modes.mode[__builtin_ctzll(left)]] |= left & -left;
}

/* Formats whose texels a tile keeps as their words: bytes blue, green, red, and alpha or none. */
static inline bool fast_is_packed(GpFormat format)
{
    return format == GP_A8R8G8B8 || format == GP_X8R8G8B8;
}

/* Formats of bytes, which hold 0 to 1: colours are clamped before they are blended. */
static inline bool fast_is_unorm8(GpFormat format)
{
    return fast_is_packed(format) || format == GP_R8;
}

/* Formats of halves. */
static inline bool fast_is_half(GpFormat format)
{
    return format == GP_G16R16F || format == GP_A16B16G16R16F;
}

/* Bits of a packed word that every store sets: the byte that X8R8G8B8 has no use for. */
static inline uint32_t fast_filled_bits(GpFormat format)
{
    return format == GP_X8R8G8B8 ? 0xff000000 : 0;
}

/* Whether a blend combines the stored words of its target, whatever they stand for. (Logic serves
 * colour and alpha alike.) */
static inline bool fast_is_bitwise(const GpBlend *blend, GpFormat format)
{
    return format == GP_A8R8G8B8 && gp_blend_is_logic(blend->op);
}

/* A pass, or the part of one that memory has room for. */
typedef struct FastPass {
    const GpPass *pass;
    uint32_t width, height;
    GpRect window;             /* of its targets: at tiles' corners, but for their own */
    uint32_t tiles_x, tiles_y; /* of the window */
    /* row * tiles_x + column of its first, of the whole's; others have their numbers from there */
    uint32_t first_tile;
    FastDraw *draws;
    uint32_t draw_count;
    uint32_t block_count, primitive_count, range_count;
    uint32_t range_size;               /* primitives, but for the last */
    uint32_t first_block, first_range; /* of all that the group has */
    /* of a pass that sorts: all draws blend alike, and test nothing in their turn */
    bool one_blend;
    bool writes_depth; /* of a pass that sorts: some draw changes depth or stencil */
    bool starts;       /* with the pass's first draw: targets are cleared before */
    /* an earlier one of the group, whose bins are its too; or NULL */
    const struct FastPass *repeats;

    /* what the tiles are to draw now */
    bool clears;
    uint32_t ready_count;
    struct FastRange *ranges;
} FastPass;

#endif
