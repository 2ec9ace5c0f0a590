#include "apps/points/drawing/over.h"

#include "apps/points/drawing/filtered.h"
#include "shaders_c/points/over.h"

#include <math.h>
#include <string.h>

/* --- what is there ---------------------------------------------------------------------------- */

float splat_largest_radius(const SplatGroup *group)
{
    float largest = 0;
    for (uint32_t i = 0; i < group->source_count; i++)
        for (uint32_t k = 0; k < group->sources[i].run_count; k++)
            largest = fmaxf(largest, group->sources[i].runs[k].radius);
    return largest;
}

/* As far as surfels are pushed that are seen from their edge (splat.c), by the runs of the
 * largest. */
static void draw_behind(const SplatGroup *group, const SplatEye *eye, const GpSurface *depth,
                        Frame *frame)
{
    const double steepest = 10, epsilon = group->setting.epsilon;
    const BehindUniforms uniforms = {
        .depth = { (float)eye->depth[0], (float)eye->depth[1] },
        .behind = { (float)(epsilon * (double)splat_largest_radius(group)),
                    (float)(epsilon * steepest * group->setting.low_pass / eye->focal) },
    };
    const GpGeometry whole = splat_whole_picture();
    GpDraw *draw = frame_draw_copied(frame, &splat_behind_program, &uniforms, &whole);
    draw->state.depth = (GpDepthState){ .test = GP_ALWAYS, .write = true };
    draw->textures[0].surface = depth;
}

/* --- over it ---------------------------------------------------------------------------------- */

static void draw_shaded(const SplatShading *shading, const void *uniforms, GpSurface *const sums[2],
                        GpSurface *hides, const GpState *state, Frame *frame)
{
    const GpGeometry whole = splat_whole_picture();
    GpDraw *draw = frame_draw_copied(frame, shading->program, uniforms, &whole);
    draw->state = *state;
    draw->textures[1] = shading->map;
    splat_bind_sums(draw, sums, shading->surface_slot, hides);
}

enum { RED = 1, GREEN = 2, BLUE = 4, ALPHA = 8 }; /* channels of a target */

/* Once for the colours of all that it covers, and once for the depth of what it covers by half. */
static void draw_over(const SplatShading *shading, GpSurface *const sums[2], GpSurface *hides,
                      Frame *frame)
{
    const bool own = shading->solid != NULL;
    const GpState seen = {
        .depth = { .test = GP_LESS_EQUAL },
        .blend = { { .op = GP_BLEND_ADD,
                     .src = GP_ONE,
                     .dst = GP_INV_SRC_ALPHA,
                     .keep = own ? ALPHA : 0 } },
    };
    const GpState solid = {
        .depth = { .test = GP_LESS_EQUAL, .write = true },
        .alpha_test = { .test = own ? GP_ALWAYS : GP_GREATER_EQUAL, .reference = 128 },
        .blend = { { .keep = own ? RED | GREEN | BLUE : RED | GREEN | BLUE | ALPHA } },
    };
    draw_shaded(shading, shading->uniforms, sums, hides, &seen, frame);
    draw_shaded(shading, own ? shading->solid : shading->uniforms, sums, hides, &solid, frame);
}

static void fill_normalization(const SplatGroup *group, const SplatEye *eye,
                               NormalizeUniforms *given)
{
    NormalizeUniforms made = splat_normalize_uniforms(eye, &group->view, &group->setting);
    memcpy(made.light, given->light, sizeof made.light);
    made.specular = given->specular;
    made.shininess = given->shininess;
    *given = made;
}

void splat_build_over(const SplatGroup *group, const SplatNames *names, const SplatShading *shading,
                      GpSurface *color, GpSurface *depth, Frame *frame)
{
    static const float nothing[4] = { 1, 1, 1, 1 };
    const SplatView *view = &group->view;
    const SplatEye eye = splat_eye(view);
    const FilterUniforms uniforms = splat_filter_uniforms(&eye, view, &group->setting, frame);
    GpSurface *visible = frame_target(frame, GP_D32F, view->width, view->height);
    GpSurface *hides = frame_target(frame, GP_R8, view->width, view->height);
    GpSurface *sums[2];
    splat_make_sums(view, &group->setting, sums, frame);
    frame_pass(frame, names->visibility, hides, visible, nothing);
    draw_behind(group, &eye, depth, frame);
    for (uint32_t i = 0; i < group->source_count; i++)
        splat_draw_hiders(&group->sources[i], &uniforms, &group->setting, frame);
    splat_begin_sums(sums, visible, frame)->name = names->sums;
    for (uint32_t i = 0; i < group->source_count; i++)
        splat_draw_sums(&group->sources[i], &uniforms, view, &group->setting, frame);

    fill_normalization(group, &eye, shading->uniforms);
    if (shading->solid)
        fill_normalization(group, &eye, shading->solid);
    GpPass *pass = frame_pass(frame, names->surface, color, depth, nothing);
    pass->color[0].clear = pass->depth.clear_depth = false;
    draw_over(shading, sums, hides, frame);
}
