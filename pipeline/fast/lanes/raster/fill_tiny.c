/* Triangles of a few pixels, the bulk of a fine mesh: pixel by pixel, in one list over all of a
 * batch. */
#include "pipeline/fast/lanes/raster/fill.h"

/* Depth at a pixel of the lane's 4x4 box. */
GP_INLINE float depth_at(const TriangleBatch *b, uint32_t lane, int32_t x, int32_t y)
{
    double e1 = b->edge[1][lane] + GP_SUBPIXELS * (b->right[1][lane] * x + b->down[1][lane] * y);
    double e2 = b->edge[2][lane] + GP_SUBPIXELS * (b->right[2][lane] * x + b->down[2][lane] * y);
    return (float)(b->base[lane] + (e1 * b->step[0][lane] + e2 * b->step[1][lane]));
}

GP_INLINE uint32_t depth_code(const Filler *f, float z)
{
    z = z > f->low ? z : f->low; /* as nearer_codes */
    z = z < f->high ? z : f->high;
    if (f->tile->depth_format == GP_D32F)
        return gp_float_bits(z);
    return (uint32_t)((double)z * f->scale + 0.5);
}

/* Tests, and writes, depth. */
GP_INLINE bool test_depth(const Filler *f, EarlyTest early, uint32_t *depth, float z)
{
    const GpDepthState *state = &f->d->draw->state.depth;
    const uint32_t code = depth_code(f, z);
    const bool passes = early == EARLY_ANY ? gp_compare_codes(state->test, code, *depth)
                                           : (int32_t)code - f->allowance < (int32_t)*depth;
    if (passes && (early != EARLY_ANY || state->write))
        *depth = code;
    return passes;
}

GP_INLINE void fill(const Filler *f, EarlyTest early, bool visible, const TriangleBatch *b,
                    unsigned lanes)
{
    enum { LANES_OF_WORD = 4, PIXELS_OF_LANE = 16 };
    typedef uint16_t boxes __attribute__((vector_size(2 * GP_LANES)));
    Tile *tile = f->tile;
    boxes covered = __builtin_convertvector(b->covered & mask_of(lanes), boxes);
    uint64_t word[GP_LANES / LANES_OF_WORD];
    __builtin_memcpy(word, &covered, sizeof word);
    const uint32_t first = (uint32_t)__builtin_ctz(lanes), number = tile->records->count - first;
    unsigned shown = 0;
    for (uint32_t i = 0; i < GP_LANES / LANES_OF_WORD; i++)
        for (uint64_t left = word[i]; left; left &= left - 1) {
            uint32_t bit = (uint32_t)__builtin_ctzll(left);
            uint32_t lane = i * LANES_OF_WORD + bit / PIXELS_OF_LANE;
            int32_t x = bit & 3, y = bit >> 2 & 3;
            uint32_t at = fast_at(b->x[lane] + x, b->y[lane] + y);
            bool passes = early == EARLY_NONE ||
                          test_depth(f, early, &tile->depth[at], depth_at(b, lane, x, y));
            if (visible && passes) {
                tile->visibility->record[at] = number + lane;
                shown |= 1u << lane;
            }
        }
    /* records of triangles that are not visible stay unwritten */
    for (unsigned left = shown; left; left &= left - 1) {
        uint32_t lane = (uint32_t)__builtin_ctz(left);
        tile->records->count = number + lane;
        fast_write_record(f->d, b, lane, &tile->records->record[tile->records->count++]);
    }
}

void fast_fill_tiny(const Filler *f, const TriangleBatch *b, unsigned lanes)
{
    const bool visible = f->d->path == FAST_VISIBLE;
    if (f->early == EARLY_NONE)
        fill(f, EARLY_NONE, visible, b, lanes);
    else if (f->early == EARLY_ANY)
        fill(f, EARLY_ANY, visible, b, lanes);
    else if (visible)
        fill(f, EARLY_NEARER_FLOAT, true, b, lanes);
    else
        fill(f, EARLY_NEARER_FLOAT, false, b, lanes);
}
