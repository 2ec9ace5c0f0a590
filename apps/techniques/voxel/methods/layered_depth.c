/* Voxels from a layered depth image: surfaces along z are peeled off one after the other, which
 * also sorts them, and a column is inside from each odd one to the next.
 * DEVIATES: a list cannot look whether a layer came out empty, so all VOXEL_LAYERS are drawn;
 * empty ones cost their geometry, and nothing else.
 * source Heidelberger, Teschner and Gross, "Real-time volumetric intersections of deforming
 *        objects", Vision, Modeling and Visualization 2003 */
#include "apps/techniques/voxel/methods/methods.h"
#include "shaders_c/voxel/methods/layers.h"

static void peel(const VoxelModel *model, uint32_t size, Frame *frame,
                 GpSurface *layers[VOXEL_LAYERS])
{
    static const float no_layer[4] = { VOXEL_NO_LAYER };
    const GpGeometry geometry = voxel_model_geometry(model);
    GpSurface *depth = frame_surface(frame, GP_D32F, size, size, 1);
    VoxelPeelUniforms view;
    voxel_model_view(model, size, false, view.to_clip);
    const void *uniforms = frame_copy(frame, &view, sizeof view);
    for (int i = 0; i < VOXEL_LAYERS; i++) {
        layers[i] = frame_surface(frame, GP_R32F, size, size, 1);
        frame_pass(frame, "layer", layers[i], depth, no_layer);
        GpDraw *draw = frame_draw(frame, i ? &voxel_peel_next_program : &voxel_peel_first_program,
                                  uniforms, &geometry);
        draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
        if (i)
            draw->textures[0].surface = layers[i - 1];
    }
}

/* Draws a patch from one layer, or from two. */
static void fill_patch(Frame *frame, const FlatTexture *flat, uint32_t slab, const GpSurface *entry,
                       const GpSurface *exit)
{
    const GpProgram *program = exit ? &voxel_between_program : &voxel_layer_program;
    GpDraw *draw = flat_texture_draw_slab(frame, program, flat, slab);
    draw->state.blend[0].op = GP_BLEND_LOGIC_OR;
    draw->textures[0].surface = entry;
    draw->textures[1].surface = exit;
}

void voxel_layered_depth(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                         const FlatTexture *flat)
{
    const bool solid = setting->kind == VOXEL_SOLID;
    GpSurface *layers[VOXEL_LAYERS];
    peel(model, setting->size, frame, layers);

    flat_texture_pass(frame, "layers to voxels", flat);
    for (uint32_t slab = 0; slab < flat->slabs; slab++)
        for (int i = 0; i < VOXEL_LAYERS; i += solid ? 2 : 1)
            fill_patch(frame, flat, slab, layers[i], solid ? layers[i + 1] : NULL);
}
