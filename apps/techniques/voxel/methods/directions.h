/* The printed method's first step: triangles into directional flat textures.
 *
 * A flat texture along an axis has the layout of a volume's whose x, y, z are u, v and the depth w:
 * along x those are y, z, x, along y they are z, x, y, and along z they are x, y, z themselves. */
#ifndef APPS_TECHNIQUES_VOXEL_METHODS_DIRECTIONS_H
#define APPS_TECHNIQUES_VOXEL_METHODS_DIRECTIONS_H

#include "apps/techniques/voxel/methods/setting.h"
#include "apps/techniques/voxel/methods/sort.h"
#include "apps/techniques/voxel/volume/flat_texture.h"

typedef struct VoxelDirections {
    FlatTexture along[3]; /* x, y, z; where setting->axes is 1 there is only the last */
} VoxelDirections;

/* Makes the flat textures that a setting needs.
 * in     z: what the last one is to be; NULL: one of its own */
VoxelDirections voxel_directions_make(const VoxelSetting *setting, Frame *frame,
                                      const FlatTexture *z);

/* Appends the passes that draw triangles into their slabs, each along one axis, or all along every
 * axis (VoxelSortBy): for each axis one pass, four slabs at once, and one that gathers the slabs.
 * source Dong et al., Pacific Graphics 2004: rasterization and texelization. DEVIATES: a draw is
 *        cut to the patch by its viewport, and every fourth slab lies in the same target, so that
 *        one set of four targets serves all; the print leaves open how patches are reached. */
void voxel_directions_draw(const VoxelModel *model, const VoxelSetting *setting,
                           VoxelSortBy sort_by, Frame *frame, const VoxelDirections *directions);

/* How fragments of a setting come together: bits are added as printed, or set (VOXEL_OR); densities
 * are counted, each fragment adds 1 and 255 is the most (VOXEL_ADD), or are all there is
 * (VOXEL_OR); normals and colours keep the greatest of each byte. What 16 bits hold is in two
 * bytes, low first: where fragments of a voxel differ, each byte may be another's. */
GpBlend voxel_directions_blend(const VoxelSetting *setting);

/* --- lookup tables of all steps --------------------------------------------------------------- */

/* A texture of bytes, red the value and green the second where `channels` is 2.
 * in   codes: [height][width][channels] */
const GpSurface *voxel_table(Frame *frame, uint32_t width, uint32_t height, uint32_t channels,
                             const uint8_t *codes);

/* Reads texels as they are: point filtering, and nothing beyond the edges. */
GpTexture voxel_texels(const GpSurface *surface);

#endif
