#include "apps/fragments/drawing/weighted.h"

#include "apps/fragments/drawing/passes.h"
#include "shaders_c/fragments/weighted.h"

GpResult weighted_add(const FragmentMesh *mesh, const FragmentView *view, GpSurface *color,
                      GpSurface *depth, Frame *frame, GpError *error)
{
    const FragmentPasses passes = fragment_passes(mesh, view, color, depth, frame);
    /* The weighted sum, and what all let through. */
    GpSurface *const sums[] = { fragment_surface(&passes, GP_A32B32G32R32F),
                                fragment_surface(&passes, GP_A16B16G16R16F) };
    GpPass *pass = fragment_pass(&passes, "weighted", sums[0], 0);
    pass->color[1] = (GpColorTarget){ sums[1], true, { 1, 1, 1, 1 } };
    GpDraw *draw = fragment_draw(&passes, &weighted_program, &weighted_program);
    draw->state.blend[0] = (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };
    draw->state.blend[1] = (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ZERO, .dst = GP_SRC_COLOR };
    fragment_whole(&passes, "over", &weighted_layers_program, NULL,
                   (FragmentSlots){ sums, 2, &color, 1 })
        ->state.blend[0] = fragment_over;
    return frame_result(frame, error);
}
