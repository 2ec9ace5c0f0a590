/* The printed method step by step: directional flat textures, their synthesis, and the row scan.
 *
 * A flat texture along an axis has the layout of a volume's whose x, y, z are u, v and the depth w:
 * along x those are y, z, x, along y they are z, x, y, and along z they are x, y, z themselves. */
#ifndef APPS_TECHNIQUES_VOXEL_METHODS_SHEETS_H
#define APPS_TECHNIQUES_VOXEL_METHODS_SHEETS_H

#include "apps/techniques/voxel/methods/sort.h"

typedef struct VoxelDirections {
    FlatTexture along[3]; /* x, y, z; where setting->axes is 1 there is only the last */
} VoxelDirections;

/* Makes the sheets that a setting needs.
 * in     z: what the last one is to be; NULL: a sheet of its own */
VoxelDirections voxel_directions_make(const VoxelSetting *setting, Frame *frame,
                                      const FlatTexture *z);

/* Appends the passes that draw triangles into their slabs, each along one axis, or all along every
 * axis (VoxelSortBy): for each axis one pass, four slabs at once, and one that gathers the slabs.
 * source Dong et al., Pacific Graphics 2004: rasterization and texelization. DEVIATES: a draw is
 *        cut to the patch by its viewport, and every fourth slab lies in the same target, so that
 *        one set of four targets serves all; the print leaves open how patches are reached. */
void voxel_directions_draw(const VoxelModel *model, const VoxelSetting *setting, int sort_by,
                           Frame *frame, const VoxelDirections *directions);

/* Appends the passes that put the sheets along x and y into the volume's places and merges them
 * with the one along z, which becomes the volume.
 * source Dong et al., Pacific Graphics 2004: synthesis, by lookup tables. The print leaves open how
 *        bits are merged: here by OR, whatever the setting's blend, which is what a shader does
 *        that reads all three bits. Values merge as fragments do. */
void voxel_synthesize(const VoxelSetting *setting, Frame *frame, const VoxelDirections *directions);

/* How fragments of a setting come together: bits are added as printed, or set (VOXEL_OR); densities
 * are counted, each fragment adds 1 and 255 is the most (VOXEL_ADD), or are all there is
 * (VOXEL_OR); normals and colours keep the greatest of each byte. What 16 bits hold is in two
 * bytes, low first: where fragments of a voxel differ, each byte may be another's. */
GpBlend voxel_sheets_blend(const VoxelSetting *setting);

/* The inside of a model along each axis, and the majority of the three: a voxel is in the solid
 * where two scans say so.
 * in/out crossings: where lines along each axis cross the surface (VOXEL_ALONG_ALL); are
 *        overwritten
 * out    solid: merged; the scan along z where setting->axes is 1
 * returns the solids of the three scans, all in the volume's places
 * source Dong et al., Pacific Graphics 2004, solid voxelization. The print leaves open how the
 *        three are merged, and what rows are scanned against. On the synthesized surface they would
 *        meet voxels beside which it passes, in runs of any length; what lines along a row's own
 *        axis cross it meets once each. */
VoxelDirections voxel_row_scan(const VoxelSetting *setting, Frame *frame,
                               const VoxelDirections *crossings, const FlatTexture *solid);

/* All of a solid: crossings, scans, majority. Returns what voxel_row_scan does. */
VoxelDirections voxel_sheets_solid(const VoxelModel *model, const VoxelSetting *setting,
                                   Frame *frame, const FlatTexture *solid);

/* --- steps of theirs -------------------------------------------------------------------------- */

/* What is looked up where sheets are turned. */
typedef struct VoxelTables {
    const GpSurface *places, *bits; /* slots 1 and 2 of shaders_c/voxel/methods/turn.h */
    GpSurface *found;               /* slot 3 */
} VoxelTables;

/* For sheets of this layout; the work owns them. */
VoxelTables voxel_tables_make(Frame *frame, const FlatTexture *sheet);

/* Appends passes that put a flat texture along x (axis 0) or y (1) into the volume's places, to `to`;
 * `blend` says what becomes of what is there. */
void voxel_turn(int axis, const FlatTexture *from, const VoxelTables *tables, const FlatTexture *to,
                const GpBlend *blend, Frame *frame);

/* A texture of bytes, red the value and green the second where `channels` is 2.
 * in   codes: [height][width][channels] */
const GpSurface *voxel_table(Frame *frame, uint32_t width, uint32_t height, uint32_t channels,
                             const uint8_t *codes);

/* Reads texels as they are: point filtering, and nothing beyond the edges. */
GpTexture voxel_texels(const GpSurface *surface);

#endif
