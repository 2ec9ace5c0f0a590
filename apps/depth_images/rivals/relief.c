#include "apps/depth_images/rivals/relief.h"

#include "shaders_c/warp/relief.h"

enum { STEPS = 64, HALVINGS = 8, MOST = 255 };

GpResult relief_open(const DepthImage *image, Relief *relief, GpError *error)
{
    Relief made = { .cells = { .z = NULL } };
    GpResult result = slab_check(image, "relief mapping", error);
    if (!result && slab_find(&image->plane, &image->front, &made.slab)) {
        result = depth_cells_open(&made.slab, &image->front, &made.cells, error);
        if (!result)
            result = slab_textures_open(image, &made.textures, error);
    }
    if (result)
        relief_close(&made);
    else
        *relief = made;
    return result;
}

void relief_close(Relief *relief)
{
    depth_cells_close(&relief->cells);
    depth_textures_close(&relief->textures);
    *relief = (Relief){ .cells = { .z = NULL } };
}

static float number_of(uint32_t asked, uint32_t meant)
{
    return (float)(asked == 0 ? meant : asked < MOST ? asked : MOST);
}

GpResult relief_add(const Relief *relief, const ReliefSetting *setting, const WarpView *view,
                    const WarpTarget *target, Frame *frame, GpError *error)
{
    SlabRays rays;
    slab_pass(setting->name ? setting->name : "relief", target, frame);
    if (!relief->cells.z || !slab_rays(&relief->slab, view, frame, &rays))
        return frame_result(frame, error);
    const ReliefUniforms uniforms = {
        .slab = rays.uniforms,
        .cells = depth_cells_uniforms(&relief->cells, setting->thickness),
        .steps = number_of(setting->steps, STEPS),
        .halvings = number_of(setting->halvings, HALVINGS),
    };
    GpDraw *draw = frame_draw_copied(frame, view->light ? &relief_lit_program : &relief_program,
                                     &uniforms, &rays.geometry);
    draw->state = slab_state(&rays, target);
    slab_textures(&relief->textures, draw);
    depth_cells_texture(&relief->cells, draw);
    return frame_result(frame, error);
}
