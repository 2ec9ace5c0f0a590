/* Index lists of voxelization: which triangles a draw needs, found once for a model that stands
 * still. That is the processor's part, as in the thesis (section 2.2); nothing here makes a
 * voxel. */
#ifndef APPS_TECHNIQUES_VOXEL_METHODS_LISTS_H
#define APPS_TECHNIQUES_VOXEL_METHODS_LISTS_H

#include "apps/techniques/voxel/methods/model.h"

/* What a triangle may be drawn to, in voxels and with room for rounding. */
typedef struct VoxelExtent {
    float low, high;  /* z; of a model that moves: round 0, its longest edge apart */
    float side;       /* the longer side of its box in x and y */
    bool in_column;   /* that box is certainly within one voxel's square */
    bool meets_lines; /* the box may hold a line's two centres: others have no sample */
} VoxelExtent;

/* Of all triangles; NULL without memory. */
const VoxelExtent *voxel_extents(const VoxelModel *model, Frame *frame);

typedef bool VoxelChoice(const VoxelExtent *extent, float about);

/* Triangles by number, in order. */
typedef struct VoxelList {
    const uint32_t *triangles; /* NULL: all, from 0 on */
    uint32_t count;
} VoxelList;

/* Those of a list that a choice takes.
 * owns   the frame; none without memory */
VoxelList voxel_choose(Frame *frame, const VoxelExtent *extents, VoxelList from,
                       VoxelChoice *choice, float about);

/* The triangles that cross a group of slabs, of `depth` voxels from `floor` on, or where it is the
 * top one also what lies above; of a model that moves, all.
 * note   a surface above the last centre counts in the whole group; up to the next group's first
 *        centre, half a voxel beyond its end, it does so here
 * owns   the frame; none without memory */
GpGeometry voxel_group_triangles(const VoxelModel *model, Frame *frame, const VoxelExtent *extents,
                                 float floor, float depth, bool top);

#endif
