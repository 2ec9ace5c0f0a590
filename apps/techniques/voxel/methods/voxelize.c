/* Which method a setting means, whether it can be, and the table of methods. */
#include "apps/techniques/voxel/methods/voxelize.h"

#include "apps/techniques/voxel/methods/methods.h"

VoxelSetting voxel_complete(const VoxelSetting *setting)
{
    VoxelSetting full = *setting;
    if (full.method == VOXEL_AUTO)
        full.method = full.kind == VOXEL_SOLID ? VOXEL_XOR : VOXEL_CONSERVATIVE;
    return full;
}

static GpResult check(const VoxelModel *model, const VoxelSetting *setting, GpError *error)
{
    const bool solid = setting->kind == VOXEL_SOLID, thin = setting->method == VOXEL_THIN;
    if (solid && (thin || setting->method == VOXEL_CONSERVATIVE))
        return gp_fail(error, GP_ERROR_INVALID, "this method makes surfaces, not solids");
    if (!solid && (setting->method == VOXEL_XOR || setting->method == VOXEL_WINDING ||
                   setting->method == VOXEL_FACES))
        return gp_fail(error, GP_ERROR_INVALID, "this method makes solids: --kind solid");
    if (setting->bits != 1 && setting->method != VOXEL_SHEETS)
        return gp_fail(error, GP_ERROR_INVALID, "%u bits a voxel: only --method sheets has them",
                       setting->bits);
    if (setting->bits != 1 && solid)
        return gp_fail(error, GP_ERROR_INVALID, "%u bits a voxel: solids have 1", setting->bits);
    if (setting->bits != 1 && setting->value == VOXEL_NORMAL && !model->normals)
        return gp_fail(error, GP_ERROR_INVALID, "the model has no normals");
    if (setting->bits != 1 && setting->value == VOXEL_COLOR && !model->colors)
        return gp_fail(error, GP_ERROR_INVALID, "the model has no colours");
    if (setting->axes == 2)
        return gp_fail(error, GP_ERROR_INVALID, "--axes 2: expected 1 or 3");
    return flat_texture_check(setting->size, setting->bits, error);
}

GpResult voxel_draw(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                    const FlatTexture *volume, GpError *error)
{
    static VoxelMethodPasses *const methods[] = {
        [VOXEL_CONSERVATIVE] = voxel_columns,
        [VOXEL_THIN] = voxel_columns,
        [VOXEL_XOR] = voxel_xor,
        [VOXEL_WINDING] = voxel_winding,
        [VOXEL_SHEETS] = voxel_sheets,
        [VOXEL_SLICES] = voxel_slices,
        [VOXEL_LDI] = voxel_layered_depth,
        [VOXEL_FACES] = voxel_faces,
    };
    const VoxelSetting full = voxel_complete(setting);
    GpResult result = check(model, &full, error);
    if (!result)
        methods[full.method](model, &full, frame, volume);
    return result ? result : frame_result(frame, error);
}

GpResult voxel_build(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                     FlatTexture *volume, GpError *error)
{
    GpResult result = flat_texture_check(setting->size, setting->bits, error);
    if (result)
        return result;
    *volume = flat_texture_make(frame, setting->size, setting->bits);
    return voxel_draw(model, setting, frame, volume, error);
}
