#include "apps/techniques/voxel/methods/voxelize.h"

#include "apps/techniques/voxel/methods/methods.h"

const VoxelSetting voxel_defaults = { .size = 128, .bits = 1, .blend = VOXEL_ADD, .axes = 3 };

VoxelMotion voxel_still(const VoxelBox *box)
{
    VoxelMotion motion = { .twist = 0, .middle = (float)box->size / 2 };
    voxel_box_matrix(box, motion.to_voxels);
    return motion;
}

void voxel_move(const VoxelMotions *motions, const VoxelMotion *motion)
{
    for (uint32_t i = 0; i < motions->count; i++)
        *motions->motion[i] = *motion;
}

void voxel_set_motion(const VoxelModel *model, VoxelMotion *motion)
{
    *motion = model->motion;
    if (model->motions) {
        GP_ASSERT(model->motions->count < VOXEL_MAX_MOTIONS);
        model->motions->motion[model->motions->count++] = motion;
    }
}

void voxel_corner(const VoxelModel *model, size_t corner, double place[3])
{
    const float *p = model->positions + 3 * (size_t)model->indices[corner];
    for (int k = 0; k < 3; k++) {
        const float *row = model->motion.to_voxels[k];
        place[k] = (double)row[0] * (double)p[0] + (double)row[1] * (double)p[1] +
                   (double)row[2] * (double)p[2] + (double)row[3];
    }
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

void tech_voxel_room(const VoxelSetting *setting, uint32_t *passes, uint32_t *draws)
{
    *passes = 64 + 4 * setting->size;
    *draws = 256 + 8 * setting->size;
}

static VoxelSetting complete(const VoxelSetting *setting)
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
    if (!solid && (setting->method == VOXEL_XOR || setting->method == VOXEL_FACES))
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

GpResult tech_voxel_draw(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                         const FlatTexture *sheet, GpError *error)
{
    typedef void Method(const VoxelModel *, const VoxelSetting *, Frame *, const FlatTexture *);
    static Method *const methods[] = {
        [VOXEL_CONSERVATIVE] = voxel_columns,
        [VOXEL_THIN] = voxel_columns,
        [VOXEL_XOR] = voxel_xor,
        [VOXEL_SHEETS] = voxel_sheets,
        [VOXEL_SLICES] = voxel_slices,
        [VOXEL_LDI] = voxel_ldi,
        [VOXEL_FACES] = voxel_faces,
    };
    const VoxelSetting full = complete(setting);
    GpResult result = check(model, &full, error);
    if (!result)
        methods[full.method](model, &full, frame, sheet);
    return result;
}

GpResult tech_voxel_build(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                          FlatTexture *sheet, GpError *error)
{
    GpResult result = flat_texture_check(setting->size, setting->bits, error);
    if (result)
        return result;
    *sheet = flat_texture_make(frame, setting->size, setting->bits);
    return tech_voxel_draw(model, setting, frame, sheet, error);
}
