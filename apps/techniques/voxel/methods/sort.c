/* A counting sort of triangles: counts first, then places. */
#include "apps/techniques/voxel/methods/sort.h"

#include <math.h>
#include <string.h>

/* Triangles are taken to be longer by so many voxels: where they are drawn, positions are rounded
 * once more. */
#define MARGIN (1.0 / 64)

static int dominant_axis(double corner[3][3])
{
    double normal[3];
    for (int k = 0; k < 3; k++) {
        int u = (k + 1) % 3, v = (k + 2) % 3;
        normal[k] = fabs((corner[1][u] - corner[0][u]) * (corner[2][v] - corner[0][v]) -
                         (corner[1][v] - corner[0][v]) * (corner[2][u] - corner[0][u]));
    }
    int axis = normal[1] > normal[0] ? 1 : 0;
    return normal[2] > normal[axis] ? 2 : axis;
}

/* A place along an axis as a group, from 0 to `groups`; NaN is 0. */
static uint8_t group_at(const VoxelSort *sort, double place)
{
    double group = floor(place / sort->group_depth);
    if (!(group > 0))
        return 0;
    return (uint8_t)(group < sort->groups ? group : sort->groups);
}

static void span_along(const VoxelSort *sort, double corner[3][3], int axis, VoxelSpans *spans)
{
    double low = fmin(corner[0][axis], fmin(corner[1][axis], corner[2][axis])) - MARGIN;
    double high = fmax(corner[0][axis], fmax(corner[1][axis], corner[2][axis])) + MARGIN;
    if (!(high >= 0))
        return;
    spans->first[axis] = group_at(sort, low);
    uint32_t last = group_at(sort, high);
    spans->end[axis] = (uint8_t)(last < sort->groups ? last + 1 : sort->groups);
}

uint32_t voxel_sort_count(const VoxelModel *model, VoxelSort *sort)
{
    GP_ASSERT(sort->groups > 0 && sort->groups <= VOXEL_SORT_MAX_GROUPS);
    const uint32_t lists = 3 * sort->groups;
    memset(sort->start, 0, sizeof sort->start);
    for (uint32_t i = 0; i < model->triangle_count; i++) {
        double corners[3][3];
        VoxelSpans spans = { .first = { 0 } };
        voxel_model_corners(model, i, corners);
        int only = sort->by == VOXEL_BY_NORMAL ? dominant_axis(corners) : 2;
        for (int axis = 0; axis < 3; axis++) {
            if (axis == only || sort->by == VOXEL_ALONG_ALL)
                span_along(sort, corners, axis, &spans);
            for (uint32_t g = spans.first[axis]; g < spans.end[axis]; g++)
                sort->start[(uint32_t)axis * sort->groups + g + 1] += 3;
        }
        sort->spans[i] = spans;
    }
    for (uint32_t list = 0; list < lists; list++)
        sort->start[list + 1] += sort->start[list];
    return sort->start[lists];
}

void voxel_sort_fill(const VoxelModel *model, VoxelSort *sort)
{
    uint32_t at[3 * VOXEL_SORT_MAX_GROUPS];
    memcpy(at, sort->start, sizeof at);
    for (uint32_t i = 0; i < model->triangle_count; i++)
        for (uint32_t axis = 0; axis < 3; axis++)
            for (uint32_t g = sort->spans[i].first[axis]; g < sort->spans[i].end[axis]; g++) {
                uint32_t *end = &at[axis * sort->groups + g];
                memcpy(sort->indices + *end, model->indices + 3 * (size_t)i, 3 * sizeof(uint32_t));
                *end += 3;
            }
}
