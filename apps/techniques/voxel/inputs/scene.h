/* What is to be voxelized, and where its volume lies: a mesh, a function, a parametric surface, or
 * points. */
#ifndef APPS_TECHNIQUES_VOXEL_INPUTS_SCENE_H
#define APPS_TECHNIQUES_VOXEL_INPUTS_SCENE_H

#include "apps/techniques/voxel/methods/voxelize.h"
#include "apps/techniques/voxel/inputs/implicit.h"
#include "apps/techniques/voxel/inputs/parametric.h"
#include "apps/base/voxel_range.h"
#include "pipeline/io/mesh/mesh.h"

typedef enum VoxelInput {
    VOXEL_MESH,
    VOXEL_FUNCTION,   /* below 0 is inside */
    VOXEL_PARAMETRIC, /* a surface of parametric.h */
    VOXEL_POINTS,     /* the vertices of a mesh */
} VoxelInput;

#define VOXEL_MOST_TWIST 1440.0

typedef struct VoxelScene {
    VoxelInput input;
    GpMesh mesh;  /* also of points */
    double twist; /* of a mesh: degrees from its floor to its top, about the centre of its volume */
    bool is_placed; /* by a scale and an offset of the user's, not by the model's box */
    double scale, offset[3];

    /* private */
    VoxelFunction function;
    Bounds cube; /* of functions and surfaces: what is looked at */
    char surface[16];
} VoxelScene;

/* Reads a mesh file, looked for as data is (gp_data_find), whose vertices are points where it has
 * no faces; or makes builtin:NAME (apps/scene/shapes.h), implicit:FUNCTION (voxel_function_parse)
 * or parametric:NAME.
 * errors those of gp_data_find, gp_mesh_read and voxel_function_parse; GP_ERROR_INVALID: no such
 *        name
 * owns   the caller, until voxel_scene_close */
GpResult voxel_scene_open(const char *path, VoxelScene *scene, GpError *error);
void voxel_scene_close(VoxelScene *scene); /* a zeroed one is fine */

/* The box of all that may be set. Of a function it is the cube that is looked at; of a twisted mesh
 * it has room for every angle. */
Bounds voxel_scene_bounds(const VoxelScene *scene);

/* Where a volume of `size` voxels a side lies in the model's space. */
VoxelBox voxel_scene_box(const VoxelScene *scene, uint32_t size);

/* The same where the model's bounds are known. */
VoxelBox voxel_scene_box_around(const VoxelScene *scene, const Bounds *bounds, uint32_t size);

/* The voxels that a model of these bounds may set. */
VoxelRange voxel_scene_range(const Bounds *bounds, const VoxelBox *box);

/* The mesh of a scene as voxel_draw takes it, borrowed and not twisted. */
VoxelModel voxel_scene_model(const VoxelScene *scene, const VoxelBox *box);

/* Appends the passes of a model in its box.
 * in     flat: of the setting's size and bits, which flat_texture_check lets pass
 * errors those of voxel_draw and of implicit.h and parametric.h; GP_ERROR_INVALID: the setting does
 *        not go with what the model is */
GpResult voxel_scene_draw(const VoxelScene *scene, const VoxelSetting *setting, const VoxelBox *box,
                          Frame *frame, const FlatTexture *flat, GpError *error);

#endif
