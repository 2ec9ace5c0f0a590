#include "apps/truth/voxel_nearest.h"

#include "apps/truth/voxel_truth.h"

/* --- bits ------------------------------------------------------------------------------------- */

static size_t index_of(const uint32_t at[3], uint32_t size)
{
    return at[0] + size * (at[1] + size * (size_t)at[2]);
}

size_t voxel_next(const uint8_t *bits, uint32_t size, size_t i)
{
    const size_t count = (size_t)size * size * size, bytes = voxel_bytes(size);
    if (i >= count)
        return count;
    size_t byte = i / 8;
    unsigned rest = bits[byte] & (0xffu << i % 8);
    while (rest == 0 && ++byte < bytes)
        rest = bits[byte];
    return rest ? byte * 8 + (unsigned)__builtin_ctz(rest) : count;
}

void voxel_place(size_t i, uint32_t size, uint32_t at[3])
{
    at[0] = (uint32_t)(i % size);
    at[1] = (uint32_t)(i / size % size);
    at[2] = (uint32_t)(i / size / size);
}

/* --- the pyramid ------------------------------------------------------------------------------ */

/* A volume of half the size, rounded up. NULL without memory. */
static uint8_t *halve(const uint8_t *bits, uint32_t size)
{
    const size_t count = (size_t)size * size * size;
    const uint32_t half = (size + 1) / 2;
    uint8_t *made = gp_alloc(voxel_bytes(half), 1);
    for (size_t i = 0; made && (i = voxel_next(bits, size, i)) < count; i++) {
        uint32_t at[3];
        voxel_place(i, size, at);
        size_t k = index_of((const uint32_t[]){ at[0] / 2, at[1] / 2, at[2] / 2 }, half);
        made[k / 8] = (uint8_t)(made[k / 8] | 1u << k % 8);
    }
    return made;
}

GpResult voxel_pyramid_make(const uint8_t *bits, uint32_t size, VoxelPyramid *pyramid)
{
    *pyramid = (VoxelPyramid){ .levels = 1, .size = { size }, .bits = { bits } };
    while (size > 1) {
        const int level = pyramid->levels++;
        GP_ASSERT(level < VOXEL_LEVELS);
        pyramid->bits[level] = halve(pyramid->bits[level - 1], size);
        pyramid->size[level] = size = (size + 1) / 2;
        if (!pyramid->bits[level]) {
            voxel_pyramid_free(pyramid);
            return GP_ERROR_MEMORY;
        }
    }
    return GP_OK;
}

void voxel_pyramid_free(VoxelPyramid *pyramid)
{
    for (int level = 1; level < pyramid->levels; level++)
        gp_free((void *)pyramid->bits[level]);
    *pyramid = (VoxelPyramid){ .levels = 0 };
}

/* --- search ----------------------------------------------------------------------------------- */

typedef struct Search {
    const VoxelPyramid *pyramid;
    const double *point;
    double square; /* of the distance of the nearest so far */
} Search;

/* To the box of the centres of the voxels that are in one of a level. */
static double square_to_centres(const Search *search, int level, const uint32_t at[3])
{
    double square = 0;
    for (int k = 0; k < 3; k++) {
        double low = ((double)at[k] * (1 << level)) + 0.5, high = low + (1 << level) - 1;
        double off = fmax(fmax(low - search->point[k], search->point[k] - high), 0);
        square += off * off;
    }
    return square;
}

/* Looks into a voxel of a level that is set: into the eight parts, the nearest first. */
static void look_into(Search *search, int level, const uint32_t at[3])
{
    if (level == 0) {
        search->square = fmin(search->square, square_to_centres(search, 0, at));
        return;
    }
    const uint32_t size = search->pyramid->size[level - 1];
    const uint8_t *bits = search->pyramid->bits[level - 1];
    unsigned side = 0;
    for (int k = 0; k < 3; k++)
        side |= (unsigned)(search->point[k] >= (at[k] + 0.5) * (1 << level)) << k;
    for (unsigned i = 0; i < 8; i++) {
        uint32_t part[3];
        for (int k = 0; k < 3; k++)
            part[k] = 2 * at[k] + ((i ^ side) >> k & 1);
        if (part[0] >= size || part[1] >= size || part[2] >= size)
            continue;
        const size_t place = index_of(part, size);
        if ((bits[place / 8] >> place % 8 & 1) &&
            square_to_centres(search, level - 1, part) < search->square)
            look_into(search, level - 1, part);
    }
}

double voxel_pyramid_nearest(const VoxelPyramid *pyramid, const double point[3], double most)
{
    const int top = pyramid->levels - 1;
    const uint32_t whole[3] = { 0, 0, 0 };
    Search search = { pyramid, point, most * most };
    if (pyramid->bits[top][0] & 1)
        look_into(&search, top, whole);
    return sqrt(search.square);
}
