/* Index lists of triangles: by the axis along which they are drawn, and along it by groups of slabs
 * that are drawn at once, so that the geometry is read once but for what reaches over groups. */
#ifndef APPS_TECHNIQUES_VOXEL_METHODS_SORT_H
#define APPS_TECHNIQUES_VOXEL_METHODS_SORT_H

#include "apps/techniques/voxel/methods/model.h"

typedef enum VoxelSortBy {
    VOXEL_BY_NORMAL, /* each along the axis that its normal is nearest to, the first of equals */
    VOXEL_ALONG_Z,   /* all along z */
    VOXEL_ALONG_ALL, /* all along each axis */
} VoxelSortBy;

enum { VOXEL_SORT_MAX_GROUPS = 64 };

/* The lists that a triangle is in: groups first <= g < end along each axis. */
typedef struct VoxelSpans {
    uint8_t first[3], end[3];
} VoxelSpans;

typedef struct VoxelSort {
    VoxelSortBy by;
    uint32_t groups;    /* along each axis, at most VOXEL_SORT_MAX_GROUPS */
    double group_depth; /* voxels */
    VoxelSpans *spans;  /* [triangle_count]; the caller's, as the indices are */
    uint32_t *indices;  /* of all lists, one after the other */
    uint32_t start[3 * VOXEL_SORT_MAX_GROUPS + 1]; /* list axis * groups + group begins there */
} VoxelSort;

/* Sorts in two steps: counts, then fills. A model that does not move is sorted once, one that does
 * before every frame. What lies outside of the volume along its axis is in no list.
 * in     sort: by, groups, group_depth, spans; to fill, indices
 * out    count: sort->spans, sort->start; fill: sort->indices
 * returns how many indices there are going to be
 * order  triangles of a list stay in their order
 * source Dong et al., "Real-time voxelization for complex polygonal models", Pacific Graphics 2004:
 *        an index buffer for each direction, and smaller groups of each; the counting sort is
 *        ours */
uint32_t voxel_sort_count(const VoxelModel *model, VoxelSort *sort);
void voxel_sort_fill(const VoxelModel *model, VoxelSort *sort);

#endif
