/* Solids from six depth buffers, one for each face of the volume. What no face sees, a cavity or
 * the inside of a bend, is filled.
 * source Karabassi, Papaioannou and Theoharis, "A fast depth-buffer-based voxelization algorithm",
 *        Journal of Graphics Tools 4(4), 1999 */
#include "apps/techniques/voxel/methods/methods.h"
#include "shaders_c/common/depth_only.h"
#include "shaders_c/voxel/methods/faces.h"

enum { FACES = 6 };

static void draw_faces(const VoxelModel *model, uint32_t size, Frame *frame,
                       GpSurface *faces[FACES])
{
    static const char *const names[FACES] = { "face -x", "face +x", "face -y",
                                              "face +y", "face -z", "face +z" };
    const GpGeometry geometry = voxel_model_geometry(model);
    for (int i = 0; i < FACES; i++) {
        faces[i] = frame_surface(frame, GP_D32F, size, size, 1);
        const VoxelModel along = voxel_model_along(model, i / 2);
        DepthOnlyUniforms uniforms;
        voxel_model_view(&along, size, i % 2, uniforms.mvp);
        frame_pass(frame, names[i], NULL, faces[i], NULL);
        GpDraw *draw = frame_draw_copied(frame, &depth_only_program, &uniforms, &geometry);
        draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    }
}

void voxel_faces(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                 const FlatTexture *flat)
{
    GpSurface *faces[FACES];
    draw_faces(model, setting->size, frame, faces);

    flat_texture_pass(frame, "faces to voxels", flat);
    for (uint32_t slab = 0; slab < flat->slabs; slab++) {
        GpDraw *draw = flat_texture_draw_slab(frame, &voxel_faces_program, flat, slab);
        for (int i = 0; i < FACES; i++)
            draw->textures[i].surface = faces[i];
    }
}
