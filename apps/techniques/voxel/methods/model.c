/* A model's triangles as draws take them: where they lie, how they move, and views along axes. */
#include "apps/techniques/voxel/methods/model.h"

#include <string.h>

/* --- motion ----------------------------------------------------------------------------------- */

typedef struct VoxelMotionPlace {
    VoxelMotion *motion; /* in the uniforms of a draw */
    struct VoxelMotionPlace *next;
} VoxelMotionPlace;

VoxelMotion voxel_still(const VoxelBox *box)
{
    VoxelMotion motion = { .twist = 0, .centre = (float)box->size / 2 };
    voxel_box_matrix(box, motion.to_voxels);
    return motion;
}

void voxel_move(const VoxelMotions *motions, const VoxelMotion *motion)
{
    for (const VoxelMotionPlace *place = motions->first; place; place = place->next)
        *place->motion = *motion;
}

void voxel_set_motion(const VoxelModel *model, Frame *frame, VoxelMotion *motion)
{
    *motion = model->motion;
    VoxelMotionPlace *place = model->motions ? frame_alloc(frame, 1, sizeof *place) : NULL;
    if (!place)
        return;
    *place = (VoxelMotionPlace){ motion, model->motions->first };
    model->motions->first = place;
}

/* --- views ------------------------------------------------------------------------------------ */

VoxelModel voxel_model_along(const VoxelModel *model, int axis)
{
    VoxelModel turned = *model;
    for (int k = 0; k < 3; k++)
        memcpy(turned.motion.to_voxels[k], model->motion.to_voxels[(axis + 1 + k) % 3],
               sizeof turned.motion.to_voxels[k]);
    return turned;
}

void voxel_model_view(const VoxelModel *model, uint32_t size, bool from_far, float matrix[4][4])
{
    const float per_voxel = 1.0f / (float)size;
    const float scale[3] = { 2 * per_voxel, -2 * per_voxel, from_far ? -per_voxel : per_voxel };
    const float offset[3] = { -1, 1, from_far ? 1 : 0 };
    memset(matrix, 0, sizeof(float[4][4]));
    for (int row = 0; row < 3; row++) {
        for (int k = 0; k < 4; k++)
            matrix[row][k] = model->motion.to_voxels[row][k] * scale[row];
        matrix[row][3] += offset[row];
    }
    matrix[3][3] = 1;
}

GpGeometry voxel_model_geometry(const VoxelModel *model)
{
    return (GpGeometry){
        .vertex_count = model->vertex_count,
        .indices = model->indices,
        .index_count = 3 * model->triangle_count,
        .streams = { [GP_POSITION] = { .data = model->positions, .components = 3 } },
    };
}
