#include "apps/depth_images/rivals/parallax.h"

#include "apps/depth_images/rivals/slab_quad.h"
#include "shaders_c/warp/parallax.h"

GpResult parallax_open(const DepthImage *image, Parallax *parallax, GpError *error)
{
    Parallax made = { .cells = { .z = NULL } };
    GpResult result = slab_check(image, "parallax mapping", error);
    if (!result && slab_find(&image->plane, &image->front, &made.slab)) {
        result = depth_cells_open(&made.slab, &image->front, &made.cells, error);
        if (!result)
            result = slab_textures_open(image, &made.textures, error);
    }
    if (result)
        parallax_close(&made);
    else
        *parallax = made;
    return result;
}

void parallax_close(Parallax *parallax)
{
    depth_cells_close(&parallax->cells);
    depth_textures_close(&parallax->textures);
    *parallax = (Parallax){ .cells = { .z = NULL } };
}

GpResult parallax_add(const Parallax *parallax, const ParallaxSetting *setting,
                      const WarpView *view, const WarpTarget *target, Frame *frame, GpError *error)
{
    static const GpProgram *const programs[][2] = {
        [PARALLAX_OFFSET] = { &parallax_program, &parallax_lit_program },
        [PARALLAX_LIMITED] = { &parallax_limited_program, &parallax_limited_lit_program },
        [PARALLAX_BUMP] = { &bump_program, &bump_lit_program },
    };
    static const double whole[2] = { 0, 0 }, sides[2] = { 1, 1 };
    const DepthSlab *slab = &parallax->slab;
    slab_pass(setting->name ? setting->name : "parallax", target, frame);
    if (!parallax->cells.z)
        return frame_result(frame, error);
    const double plane = setting->plane > 0 ? fmin(setting->plane, 1) : 0.5;
    ParallaxUniforms uniforms = { .slab = slab_uniforms(slab, view),
                                  .cells = depth_cells_uniforms(&parallax->cells, 0),
                                  .z = (float)plane };
    double eye[4], metric[3];
    camera_matrix(&view->camera, (double)view->width / view->height, uniforms.mvp);
    slab_eye(slab, &view->camera, eye);
    slab_metric(slab, metric);
    for (int k = 0; k < 4; k++)
        uniforms.eye[k] = (float)eye[k];
    for (int k = 0; k < 3; k++)
        uniforms.metric[k] = (float)metric[k];
    GpGeometry quad;
    if (!slab_quad(slab, plane, whole, sides, frame, &quad))
        return frame_result(frame, error);
    GpDraw *draw =
        frame_draw_copied(frame, programs[setting->kind][view->light != NULL], &uniforms, &quad);
    draw->state.depth = slab_depth_state(target);
    slab_textures(&parallax->textures, draw);
    depth_cells_texture(&parallax->cells, draw);
    return frame_result(frame, error);
}
