/* Solids from six depth buffers, one for each face of the volume. What no face sees, a cavity or
 * the inside of a bend, is filled.
 * source Karabassi, Papaioannou and Theoharis, "A fast depth-buffer-based voxelization algorithm",
 *        Journal of Graphics Tools 4(4), 1999 */
#include "apps/techniques/voxel/methods/parts.h"
#include "apps/techniques/voxel/methods/along.h"
#include "shaders_c/common/depth_only.h"
#include "shaders_c/voxel/voxel_faces.h"

enum { FACES = 6 };

static void draw_faces(const VoxelModel *model, uint32_t size, Work *work, GpSurface *faces[FACES])
{
    static const char *const names[FACES] = { "face -x", "face +x", "face -y",
                                              "face +y", "face -z", "face +z" };
    const GpGeometry geometry = voxel_model_geometry(model);
    DepthOnlyUniforms *uniforms = work_alloc(work, FACES, sizeof *uniforms);
    for (int i = 0; i < FACES; i++) {
        faces[i] = work_surface(work, GP_D32F, size, size, 1);
        voxel_along_view(model, size, i / 2, i % 2, uniforms[i].mvp);
        work_pass(work, names[i], NULL, faces[i], NULL);
        GpDraw *draw = work_draw(work, &depth_only_program, &uniforms[i], &geometry);
        draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    }
}

void voxel_faces(const VoxelModel *model, const VoxelSetting *setting, Work *work,
                 const Worksheet *sheet)
{
    GpSurface *faces[FACES];
    draw_faces(model, setting->size, work, faces);

    WorksheetSlab *uniforms = work_alloc(work, sheet->slabs, sizeof *uniforms);
    worksheet_pass(work, "faces to voxels", sheet);
    for (uint32_t slab = 0; slab < sheet->slabs; slab++) {
        uniforms[slab] = worksheet_slab(sheet, slab);
        GpDraw *draw = worksheet_draw(work, &voxel_faces_program, &uniforms[slab], sheet, slab);
        for (int i = 0; i < FACES; i++)
            draw->textures[i].surface = faces[i];
    }
}
