/* The oldest baseline: all geometry once for each slice of z, cut by clip planes.
 * source Fang and Chen, "Hardware accelerated voxelization", Computers & Graphics 24(3), 2000 */
#include "apps/techniques/voxel/methods/methods.h"
#include "shaders_c/materials/unlit.h"

#include <string.h>

/* A bit of a texel's word as a colour. (Bytes of channels, and channels of bytes, are the same
 * table.) */
static void color_of_bit(uint32_t bit, float color[4])
{
    memset(color, 0, sizeof(float[4]));
    color[gp_format_info(GP_A8R8G8B8)->first_byte[bit / 8]] = (float)(1u << bit % 8) / 255.0f;
}

/* Surface: the piece of the model inside the slice sets its voxels. Solid: a centre that an odd
 * number of surfaces lie in front of is inside, so all that lies in front of the slice's centres
 * turns over its bit. Depth is z / size here, so a plane's distance is in voxels. */
static void cut(GpRasterState *raster, VoxelKind kind, float size, float slice)
{
    if (kind == VOXEL_SOLID) {
        const float in_front[4] = { 0, 0, -size, slice + 0.5f };
        raster->clip_planes = 1;
        memcpy(raster->clip_plane[0], in_front, sizeof in_front);
    } else {
        const float planes[2][4] = { { 0, 0, size, -slice }, { 0, 0, -size, slice + 1 } };
        raster->clip_planes = 3;
        memcpy(raster->clip_plane, planes, sizeof planes);
    }
}

void voxel_slices(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                  const FlatTexture *flat)
{
    const GpGeometry geometry = voxel_model_geometry(model);
    flat_texture_pass(frame, "slices", flat);
    for (uint32_t slice = 0; slice < setting->size; slice++) {
        UnlitUniforms uniforms;
        voxel_model_view(model, setting->size, false, uniforms.mvp);
        color_of_bit(slice % flat->per_texel, uniforms.color);
        GpDraw *draw = frame_draw_copied(frame, &unlit_program, &uniforms, &geometry);
        draw->viewport = flat_texture_patch(flat, slice / flat->per_texel);
        draw->state.blend[0].op =
            setting->kind == VOXEL_SOLID ? GP_BLEND_LOGIC_XOR : GP_BLEND_LOGIC_OR;
        cut(&draw->state.raster, setting->kind, (float)setting->size, (float)slice);
    }
}
