#include "apps/points/drawing/opaque.h"

#include "shaders_c/points/disc.h"
#include "shaders_c/points/sequence.h"

static const GpState nearest = { .depth = { .test = GP_LESS, .write = true } };

/* Uniforms that light points one by one; with all light from everywhere where they are not lit. */
static LitPointUniforms lit_uniforms(const SplatEye *eye, const SplatView *view,
                                     const SplatSetting *setting)
{
    const SplatLight light = splat_light(view);
    LitPointUniforms lit = { splat_uniforms(eye, view, setting, setting->method),
                             .ambient = view->lit ? (float)light.ambient : 1 };
    for (int k = 0; k < 3; k++)
        lit.light[k] = (float)light.towards[k];
    return lit;
}

static const GpProgram *program_of(SplatMethod method, bool lit)
{
    if (method == SPLAT_ROUND)
        return lit ? &lit_round_program : &point_round_program;
    if (method == SPLAT_QSPLAT)
        return lit ? &lit_square_program : &point_square_program;
    return lit ? &lit_pixel_program : &point_pixel_program;
}

static void draw_runs(const SplatSource *source, const SplatEye *eye, const SplatView *view,
                      const SplatSetting *setting, Frame *frame)
{
    FilterUniforms uniforms;
    const LitPointUniforms lit = lit_uniforms(eye, view, setting);
    uniforms.of[false][setting->method] = uniforms.of[true][setting->method] =
        frame_copy(frame, &lit, view->lit ? sizeof lit : sizeof lit.splat); /* its beginning */
    splat_draw_runs(source, &uniforms, program_of(setting->method, view->lit), &nearest, frame);
}

static void draw_sequence(const SplatSource *source, const SplatEye *eye, const SplatView *view,
                          const SplatSetting *setting, Frame *frame)
{
    const SequenceUniforms uniforms = { lit_uniforms(eye, view, setting),
                                        (float)source->per_radius };
    const SequenceNode *first = source->nodes;
    const uint32_t step = sizeof *first;
    const GpGeometry geometry = {
        .primitive = GP_POINTS,
        .vertex_count = source->node_count,
        .streams = {
            [GP_POSITION] = { first->surfel.position, step, 4, GP_FLOAT32 },
            [GP_NORMAL] = { first->surfel.normal, step, 3, GP_FLOAT32 },
            [GP_COLOR] = { first->surfel.color, step, 4, GP_UNORM8 },
            [GP_TEXCOORD0] = { first->size, step, 2, GP_FLOAT32 },
        },
    };
    if (source->node_count > 0)
        frame_draw_copied(frame, &sequence_square_program, &uniforms, &geometry)->state = nearest;
}

void splat_build_opaque(const SplatSource *source, const SplatEye *eye, const SplatView *view,
                        const SplatSetting *setting, Frame *frame)
{
    frame->color = frame_surface(frame, GP_A8R8G8B8, view->width, view->height, 1);
    frame->depth = frame_surface(frame, GP_D32F, view->width, view->height, 1);
    frame_pass(frame, "points", frame->color, frame->depth, view->background);
    if (setting->method == SPLAT_SEQUENCE)
        draw_sequence(source, eye, view, setting, frame);
    else
        draw_runs(source, eye, view, setting, frame);
}
