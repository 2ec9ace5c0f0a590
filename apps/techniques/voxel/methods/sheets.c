/* The printed method: directional flat textures and their synthesis; of solids, their scans.
 * source Dong, Chen, Bao, Zhang and Peng, "Real-time voxelization for complex polygonal models",
 *        Pacific Graphics 2004 */
#include "apps/techniques/voxel/methods/methods.h"
#include "apps/techniques/voxel/methods/solid_rows.h"
#include "apps/techniques/voxel/methods/synthesis.h"

void voxel_sheets(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                  const FlatTexture *volume)
{
    const bool solid = setting->kind == VOXEL_SOLID;
    VoxelDirections directions = voxel_directions_make(setting, frame, solid ? NULL : volume);
    voxel_directions_draw(model, setting,
                          setting->axes == 1 ? VOXEL_ALONG_Z
                          : solid            ? VOXEL_ALONG_ALL
                                             : VOXEL_BY_NORMAL,
                          frame, &directions);
    if (solid)
        voxel_row_scan(setting, frame, &directions, volume);
    else if (setting->axes != 1)
        voxel_synthesize(setting, frame, &directions);
}
