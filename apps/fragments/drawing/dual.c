#include "apps/fragments/drawing/dual.h"

#include "apps/fragments/drawing/passes.h"
#include "shaders_c/fragments/peel.h"

typedef struct Dual {
    GpSurface *near[2], *far[2]; /* of the fragments that come next, and before */
    GpSurface *layer[2];         /* the nearest and the farthest of a pass, */
    GpSurface *sum[2];           /* and all that have been: from the front, and from the back */
} Dual;

static void set_target(GpPass *pass, int number, GpSurface *surface)
{
    pass->color[number] =
        (GpColorTarget){ surface, true, { DUAL_NONE, DUAL_NONE, DUAL_NONE, DUAL_NONE } };
}

/* The pass after those of `number` pairs. */
static void add_pass(const FragmentPasses *passes, const Dual *dual, uint32_t number)
{
    const uint32_t now = number % 2;
    GpPass *pass = fragment_pass(passes, "dual", dual->near[now], DUAL_NONE);
    set_target(pass, 1, dual->far[now]);
    for (int i = 0; i < 2 && number > 0; i++)
        set_target(pass, 2 + i, dual->layer[i]);
    GpDraw *draw = number ? fragment_draw(passes, &dual_next_program, &dual_next_glass_program)
                          : fragment_draw(passes, &dual_first_program, &dual_first_glass_program);
    draw->textures[0].surface = number ? dual->near[!now] : NULL;
    draw->textures[1].surface = number ? dual->far[!now] : NULL;
    for (int i = 0; i < GP_MAX_TARGETS; i++)
        draw->state.blend[i].op = GP_BLEND_MAX;
}

static void add_layers(const FragmentPasses *passes, const Dual *dual)
{
    GpDraw *draw = fragment_whole(passes, "layers", &dual_layers_program, NULL,
                                  (FragmentSlots){ dual->layer, 2, dual->sum, 2 });
    draw->state.blend[0] = fragment_under;
    draw->state.blend[1] = fragment_before;
}

GpResult dual_add(const FragmentMesh *mesh, const DualSetting *setting, const FragmentView *view,
                  GpSurface *color, GpSurface *depth, Frame *frame, GpError *error)
{
    const FragmentPasses passes = fragment_passes(mesh, view, color, depth, frame);
    Dual dual;
    for (int i = 0; i < 2; i++) {
        dual.near[i] = fragment_surface(&passes, GP_R32F);
        dual.far[i] = fragment_surface(&passes, GP_R32F);
        dual.layer[i] = fragment_layers(&passes);
        dual.sum[i] = fragment_layers(&passes);
        frame_pass(frame, "layers", dual.sum[i], NULL, fragment_nothing);
    }
    for (uint32_t i = 0; i <= (setting->layers + 1) / 2; i++) {
        add_pass(&passes, &dual, i);
        if (i > 0)
            add_layers(&passes, &dual);
    }
    fragment_put_under(&passes, dual.sum[1], dual.sum[0]);
    fragment_put_over(&passes, dual.sum[0]);
    return frame_result(frame, error);
}
