/* The synthesis: directional flat textures into the one of the volume. */
#ifndef APPS_TECHNIQUES_VOXEL_METHODS_SYNTHESIS_H
#define APPS_TECHNIQUES_VOXEL_METHODS_SYNTHESIS_H

#include "apps/techniques/voxel/methods/directions.h"

/* Appends the passes that put the flat textures along x and y into the volume's places and merge
 * them with the one along z, which becomes the volume.
 * source Dong et al., Pacific Graphics 2004: synthesis, by lookup tables. The print leaves open how
 *        bits are merged: here by OR, whatever the setting's blend, which is what a shader does
 *        that reads all three bits. Values merge as fragments do. */
void voxel_synthesize(const VoxelSetting *setting, Frame *frame, const VoxelDirections *directions);

/* What is looked up where flat textures are turned. */
typedef struct VoxelTables {
    const GpSurface *places, *bits; /* slots 1 and 2 of shaders_c/voxel/methods/turn.h */
    GpSurface *found;               /* slot 3 */
} VoxelTables;

/* For flat textures of this layout; the frame owns them. */
VoxelTables voxel_tables_make(Frame *frame, const FlatTexture *flat);

/* Appends passes that put a flat texture along x (axis 0) or y (1) into the volume's places, to
 * `to`; `blend` says what becomes of what is there. */
void voxel_turn(int axis, const FlatTexture *from, const VoxelTables *tables, const FlatTexture *to,
                const GpBlend *blend, Frame *frame);

#endif
