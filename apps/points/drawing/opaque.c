#include "apps/points/drawing/opaque.h"

#include "shaders_c/points/disc.h"

void splat_build_opaque(const SplatSource *source, const SplatEye *eye, const SplatView *view,
                        const SplatSetting *setting, Frame *frame)
{
    const bool round = setting->method == SPLAT_ROUND;
    const GpProgram *program = round ? &point_round_program : &point_pixel_program;
    const GpState nearest = { .depth = { .test = GP_LESS, .write = true } };
    frame->color = frame_surface(frame, GP_A8R8G8B8, view->width, view->height, 1);
    frame->depth = frame_surface(frame, GP_D32F, view->width, view->height, 1);
    frame_pass(frame, "points", frame->color, frame->depth, view->background);
    if (!view->lit) {
        const FilterUniforms uniforms = splat_filter_uniforms(eye, view, setting, frame);
        splat_draw_runs(source, &uniforms, program, &nearest, frame);
        return;
    }
    const SplatLight light = splat_light(view);
    LitPointUniforms lit = { splat_uniforms(eye, view, setting, setting->method),
                             .ambient = (float)light.ambient };
    for (int k = 0; k < 3; k++)
        lit.light[k] = (float)light.towards[k];
    FilterUniforms uniforms;
    uniforms.of[setting->method] = frame_copy(frame, &lit, sizeof lit);
    splat_draw_runs(source, &uniforms, round ? &lit_round_program : &lit_pixel_program, &nearest,
                    frame);
}
