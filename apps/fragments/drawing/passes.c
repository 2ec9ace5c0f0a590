#include "apps/fragments/drawing/passes.h"

#include "shaders_c/common/texel_copy.h"

#include <math.h>

const float fragment_nothing[4] = { 0, 0, 0, 1 };

const GpBlend fragment_under = { .op = GP_BLEND_ADD,
                                 .src = GP_DEST_ALPHA,
                                 .dst = GP_ONE,
                                 .alpha_op = GP_BLEND_ADD,
                                 .alpha_src = GP_ZERO,
                                 .alpha_dst = GP_SRC_ALPHA };
const GpBlend fragment_before = { .op = GP_BLEND_ADD,
                                  .src = GP_ONE,
                                  .dst = GP_SRC_ALPHA,
                                  .alpha_op = GP_BLEND_ADD,
                                  .alpha_src = GP_ZERO,
                                  .alpha_dst = GP_SRC_ALPHA };
const GpBlend fragment_over = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_INV_SRC_ALPHA };

#define LOG2_E 1.44269504088896340736

FragmentPasses fragment_passes(const FragmentMesh *mesh, const FragmentView *view, GpSurface *color,
                               GpSurface *depth, Frame *frame)
{
    const double aspect = (double)view->width / view->height;
    const CameraAxes axes = camera_axes(&view->camera, aspect);
    const FragmentGlass *glass = &view->glass;
    FragmentPasses passes = {
        .mesh = mesh, .view = view, .color = color, .depth = depth, .frame = frame
    };
    FragmentUniforms *uniforms = &passes.uniforms;
    camera_matrix(&view->camera, aspect, uniforms->mvp);
    for (int k = 0; k < 3; k++) {
        uniforms->eye[k] = (float)view->camera.eye[k];
        uniforms->forward[k] = (float)axes.forward[k];
    }
    uniforms->parallel = view->camera.fovy > 0 ? 0 : 1;
    uniforms->begin = (float)(glass->begin > 0 ? glass->begin : view->camera.near);
    uniforms->through = (float)(glass->is_as_printed ? 1 : 1 - FRAGMENT_REFLECTED);
    uniforms->sigma = (float)(glass->sigma * LOG2_E);
    return passes;
}

GpSurface *fragment_surface(const FragmentPasses *passes, GpFormat format)
{
    return frame_surface(passes->frame, format, passes->view->width, passes->view->height, 1);
}

GpSurface *fragment_layers(const FragmentPasses *passes)
{
    return fragment_surface(passes,
                            passes->view->glass.is_on ? GP_A32B32G32R32F : GP_A16B16G16R16F);
}

GpPass *fragment_pass(const FragmentPasses *passes, const char *name, GpSurface *target,
                      float clear)
{
    GpPass *pass = frame_pass(passes->frame, name, target, passes->depth,
                              (const float[4]){ clear, clear, clear, clear });
    pass->depth.clear_depth = false;
    return pass;
}

GpDraw *fragment_draw(const FragmentPasses *passes, const GpProgram *plain, const GpProgram *glass)
{
    GpDraw *draw = frame_draw_copied(passes->frame, passes->view->glass.is_on ? glass : plain,
                                     &passes->uniforms, passes->mesh->drawn);
    draw->state.depth.test = passes->depth ? GP_LESS : GP_ALWAYS;
    return draw;
}

static GpDraw *draw_whole(const FragmentPasses *passes, const GpProgram *program,
                          const void *uniforms)
{
    static const float corners[] = { -1, -1, 0, -1, 3, 0, 3, -1, 0 };
    const GpGeometry whole = {
        .vertex_count = 3, .streams = { [GP_POSITION] = { .data = corners, .components = 3 } }
    };
    return frame_draw_copied(passes->frame, program, uniforms, &whole);
}

GpDraw *fragment_whole(const FragmentPasses *passes, const char *name, const GpProgram *program,
                       const void *uniforms, FragmentSlots slots)
{
    GpPass *pass = frame_pass(passes->frame, name, NULL, NULL, fragment_nothing);
    for (int i = 0; i < slots.targets; i++)
        pass->color[i].surface = slots.target[i];
    GpDraw *draw = draw_whole(passes, program, uniforms);
    for (int i = 0; i < slots.reads; i++)
        draw->textures[i].surface = slots.read[i];
    return draw;
}

void fragment_put_under(const FragmentPasses *passes, GpSurface *from, GpSurface *to)
{
    const FragmentSlots slots = { &from, 1, &to, 1 };
    fragment_whole(passes, "under", &texel_copy_program, NULL, slots)->state.blend[0] =
        fragment_under;
}

void fragment_put_over(const FragmentPasses *passes, GpSurface *layers)
{
    GpSurface *color = passes->color;
    const FragmentSlots slots = { &layers, 1, &color, 1 };
    fragment_whole(passes, "over", &fragment_over_program, NULL, slots)->state.blend[0] =
        fragment_over;
}

void fragment_begin_depth(const FragmentPasses *passes)
{
    if (!passes->depth)
        return;
    GpDraw *draw = draw_whole(passes, &texel_depth_program, NULL);
    draw->textures[0].surface = passes->depth;
    draw->state.depth = (GpDepthState){ .test = GP_ALWAYS, .write = true };
}

GpResult fragment_same_alpha(const FragmentMesh *mesh, float *alpha, GpError *error)
{
    *alpha = mesh->colors[0][3];
    for (uint32_t i = 1; i < mesh->triangle_count; i++)
        if (mesh->colors[i][3] != *alpha)
            return gp_fail(error, GP_ERROR_INVALID,
                           "triangle %u has another alpha than the first: expected one for all", i);
    return GP_OK;
}
