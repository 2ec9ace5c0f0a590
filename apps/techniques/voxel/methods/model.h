/* What methods draw: triangles of a model in a volume, which may move from frame to frame. */
#ifndef APPS_TECHNIQUES_VOXEL_METHODS_MODEL_H
#define APPS_TECHNIQUES_VOXEL_METHODS_MODEL_H

#include "apps/frame/frame.h"
#include "apps/base/voxel_box.h"
#include "pipeline/base/lanes/types.h"
#include "shaders_c/voxel/methods/motion.h"

/* Where draws keep the motion of a model that moves; the frame owns the list. A zeroed one is
 * empty. */
typedef struct VoxelMotions {
    struct VoxelMotionPlace *first;
} VoxelMotions;

/* Triangles of a model, borrowed. */
typedef struct VoxelModel {
    const float *positions;        /* [3 * vertex_count] */
    const float *normals, *colors; /* [3 * ..], [4 * ..]; NULL: none */
    const uint32_t *indices;       /* [3 * triangle_count] */
    uint32_t vertex_count, triangle_count;
    VoxelMotion motion;    /* into the volume: voxel_still, or a motion before it */
    VoxelMotions *motions; /* NULL: it stands still; else of conservative, thin, xor and winding */
    float most_twist;      /* of a motion that may be set later */
} VoxelModel;

/* The motion of a model that stands in its box. */
VoxelMotion voxel_still(const VoxelBox *box);

/* Sets a motion, rigid or a twist, in all draws that were appended with these motions, for the next
 * frame. */
void voxel_move(const VoxelMotions *motions, const VoxelMotion *motion);

/* Copies a model's motion into a draw's uniforms, and notes where, if it moves. */
void voxel_set_motion(const VoxelModel *model, Frame *frame, VoxelMotion *motion);

/* The model turned so that `axis` (0 x, 1 y, 2 z) becomes z, and the two after it x and y. */
VoxelModel voxel_model_along(const VoxelModel *model, int axis);

/* From the model to clip space, looking along z: x and y run to the right and down over `size`
 * voxels, and depth over the volume from 0 to 1, or from 1 to 0 where it is counted from the far
 * end.
 * out  matrix: rows */
void voxel_model_view(const VoxelModel *model, uint32_t size, bool from_far, float matrix[4][4]);

/* Where the corners of a triangle lie in the volume, if the model stands still. */
static inline void voxel_model_corners(const VoxelModel *model, uint32_t triangle,
                                       double corners[3][3])
{
    GP_UNROLL
    for (size_t j = 0; j < 3; j++) {
        const float *p = model->positions + 3 * (size_t)model->indices[3 * (size_t)triangle + j];
        GP_UNROLL
        for (int k = 0; k < 3; k++) {
            const float *row = model->motion.to_voxels[k];
            corners[j][k] = (double)row[0] * (double)p[0] + (double)row[1] * (double)p[1] +
                            (double)row[2] * (double)p[2] + (double)row[3];
        }
    }
}

/* The model's triangles, with positions. */
GpGeometry voxel_model_geometry(const VoxelModel *model);

#endif
