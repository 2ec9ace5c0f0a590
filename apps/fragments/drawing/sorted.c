#include "apps/fragments/drawing/sorted.h"

#include "apps/fragments/drawing/passes.h"
#include "shaders_c/fragments/sorted.h"

/* The farthest fragment first; of those of one depth the last triangle, which is to lie behind, is
 * drawn first. */
static void draw_sorted(const FragmentPasses *passes, GpPass *pass, GpBlend blend)
{
    pass->order = GP_ORDER_DEPTH;
    GpDraw *draw = fragment_draw(passes, &sorted_program, &sorted_glass_program);
    draw->geometry = *passes->mesh->backwards;
    draw->state.blend[0] = blend;
}

GpResult sorted_add(const FragmentMesh *mesh, const FragmentView *view, GpSurface *color,
                    GpSurface *depth, Frame *frame, GpError *error)
{
    const FragmentPasses passes = fragment_passes(mesh, view, color, depth, frame);
    if (view->glass.is_on) {
        GpSurface *layers = fragment_layers(&passes);
        GpPass *pass = fragment_pass(&passes, "sorted", layers, 0);
        pass->color[0].clear_color[3] = 1;
        draw_sorted(&passes, pass, fragment_before);
        fragment_put_over(&passes, layers);
    } else {
        GpPass *pass = fragment_pass(&passes, "sorted", color, 0);
        pass->color[0].clear = false;
        draw_sorted(&passes, pass, fragment_over);
    }
    return frame_result(frame, error);
}
