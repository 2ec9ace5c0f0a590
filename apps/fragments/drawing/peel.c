#include "apps/fragments/drawing/peel.h"

#include "apps/fragments/drawing/passes.h"
#include "shaders_c/fragments/peel.h"

/* Layers alternate between two pairs of surfaces, so that each can read the depths of the one
 * before. */
typedef struct Layers {
    GpSurface *color[2], *depth[2], *all;
} Layers;

static void add_layer(const FragmentPasses *passes, const Layers *layers, uint32_t number)
{
    const uint32_t now = number % 2;
    frame_pass(passes->frame, "peel", layers->color[now], layers->depth[now], fragment_nothing);
    fragment_begin_depth(passes);
    GpDraw *draw =
        number ? fragment_draw(passes, &fragment_next_program, &fragment_next_glass_program)
               : fragment_draw(passes, &fragment_first_program, &fragment_first_glass_program);
    draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    draw->textures[0].surface = number ? layers->depth[!now] : NULL;
    fragment_put_under(passes, layers->color[now], layers->all);
}

GpResult peel_add(const FragmentMesh *mesh, const PeelSetting *setting, const FragmentView *view,
                  GpSurface *color, GpSurface *depth, Frame *frame, GpError *error)
{
    const FragmentPasses passes = fragment_passes(mesh, view, color, depth, frame);
    Layers layers = { .all = fragment_layers(&passes) };
    for (int i = 0; i < 2; i++) {
        layers.color[i] = fragment_layers(&passes);
        layers.depth[i] = fragment_surface(&passes, GP_D32F);
    }
    frame_pass(frame, "layers", layers.all, NULL, fragment_nothing);
    for (uint32_t i = 0; i < setting->layers; i++)
        add_layer(&passes, &layers, i);
    fragment_put_over(&passes, layers.all);
    return frame_result(frame, error);
}
