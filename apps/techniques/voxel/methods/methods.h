/* The methods of voxelization, each in a file of its own. All append passes to a work; the setting
 * is complete (no VOXEL_AUTO) and has been checked. */
#ifndef APPS_TECHNIQUES_VOXEL_METHODS_METHODS_H
#define APPS_TECHNIQUES_VOXEL_METHODS_METHODS_H

#include "apps/techniques/voxel/methods/voxelize.h"

/* Copies a model's motion into a draw's uniforms, and notes where, if it moves. */
void voxel_set_motion(const VoxelModel *model, VoxelMotion *motion);

/* Where a corner of a triangle lies in the volume, if the model stands still.
 * in   corner: its place in model->indices */
void voxel_corner(const VoxelModel *model, size_t corner, double place[3]);

/* The model's triangles, with positions. */
GpGeometry voxel_model_geometry(const VoxelModel *model);

/* tech_voxel_columns.c: conservative and thin; what xor draws is in tech_voxel_xor.c. */
void voxel_columns(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                   const FlatTexture *sheet);
void voxel_xor(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
               const FlatTexture *sheet);

/* tech_voxel_sheets.c: the printed method, surfaces and solids; its steps are in
 * tech_voxel_sheets.h. */
void voxel_sheets(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                  const FlatTexture *sheet);

/* tech_voxel_slices.c */
void voxel_slices(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                  const FlatTexture *sheet);

/* tech_voxel_ldi.c; surfaces that lie behind so many others are lost. Even, so that what is left of
 * a solid ends at a surface. */
enum { VOXEL_LDI_LAYERS = 16 };
void voxel_ldi(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
               const FlatTexture *sheet);

/* tech_voxel_faces.c: solids only */
void voxel_faces(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                 const FlatTexture *sheet);

#endif
