#include "apps/points/drawing/filtered.h"

#include "apps/points/drawing/quads.h"

#include "apps/base/stable_math.h"
#include "apps/points/drawing/compressed.h"
#include "shaders_c/points/clipped.h"
#include "shaders_c/points/perspective.h"
#include "shaders_c/points/quad.h"
#include "shaders_c/points/ternary.h"

#include <math.h>
#include <string.h>

/* --- sums ------------------------------------------------------------------------------------- */

static const float black[4] = { 0 };

/* The share of a Gaussian inside its cut. */
static double inside_cut(double cut)
{
    return 1 - stable_exp(-cut * cut / 2);
}

NormalizeUniforms splat_normalize_uniforms(const SplatEye *eye, const SplatView *view,
                                           const SplatSetting *setting)
{
    /* along a straight border the sums fall from 1 to 0 with the filter's integral; twice as steep,
     * the surface is whole where they are 3/4, and a border is blurred by less than a pixel */
    const double per_weight = 1 / inside_cut(setting->cut), steep = 2;
    const SplatLight light = splat_light(view);
    NormalizeUniforms uniforms = {
        .coverage = { (float)(steep * per_weight), (float)((1 - steep) / 2) },
        .texel = { 1 / (float)view->width, 1 / (float)view->height },
        .per_focal = (float)(1 / eye->focal),
        .centre = { (float)view->width / 2, (float)view->height / 2 },
        .light = { (float)light.towards[0], (float)light.towards[1], (float)light.towards[2] },
        .ambient = (float)light.ambient,
        .specular = (float)light.specular,
        .shininess = (float)light.shininess,
        .depth = { (float)eye->depth[0], (float)eye->depth[1] },
    };
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            uniforms.axes[i][k] = (float)eye->axis[i][k];
    return uniforms;
}

GpGeometry splat_whole_picture(void)
{
    static const float corners[] = { -1, -1, 0, -1, 3, 0, 3, -1, 0 };
    return (GpGeometry){ .vertex_count = 3,
                         .streams = { [GP_POSITION] = { .data = corners, .components = 3 } } };
}

void splat_bind_sums(GpDraw *draw, GpSurface *const sums[2], int surface_slot, GpSurface *hides)
{
    static const GpSampler at_pixels = { .address_u = GP_BORDER, .address_v = GP_BORDER };
    draw->textures[0] = (GpTexture){ sums[0], at_pixels };
    draw->textures[surface_slot] = (GpTexture){ sums[1], at_pixels };
    draw->textures[HIDES_SLOT].surface = hides;
    draw->textures[SUMS_HERE_SLOT].surface = sums[0];
    draw->textures[SURFACE_HERE_SLOT].surface = sums[1];
}

static void add_normalization(const SplatEye *eye, const SplatView *view,
                              const SplatSetting *setting, GpSurface *const sums[2],
                              GpSurface *visible, Frame *frame)
{
    NormalizeUniforms uniforms = splat_normalize_uniforms(eye, view, setting);
    const GpGeometry whole = splat_whole_picture();
    memcpy(uniforms.background, view->background, sizeof uniforms.background);
    frame->color = frame_surface(frame, GP_A8R8G8B8, view->width, view->height, 1);
    frame->depth = view->lit ? frame_surface(frame, GP_D32F, view->width, view->height, 1) : NULL;
    frame_pass(frame, "normalize", frame->color, frame->depth, view->background);
    GpDraw *draw = frame_draw_copied(
        frame, view->lit ? &splat_shade_program : &splat_normalize_program, &uniforms, &whole);
    splat_bind_sums(draw, sums, 1, visible);
    if (view->lit)
        draw->state.depth = (GpDepthState){ .test = GP_ALWAYS, .write = true };
}

/* --- two passes ------------------------------------------------------------------------------- */

static const GpBlend add = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };

static void draw_runs(const SplatSource *source, const FilterUniforms *uniforms, SplatPass pass,
                      const SplatSetting *setting, const GpState *state, Frame *frame)
{
    static const GpProgram *const programs[3][SPLAT_PASSES] = {
        { &splat_visibility_program, &splat_color_program, &splat_surface_program },
        { &perspective_visibility_program, &perspective_color_program,
          &perspective_surface_program },
        { &clipped_visibility_program, &clipped_color_program, &clipped_surface_program },
    };
    const bool exact = setting->method == SPLAT_PERSPECTIVE;
    if (source->compressed)
        compressed_draw_runs(source, uniforms, pass, state, frame);
    else
        splat_draw_runs(source, uniforms, programs[exact][pass], state, frame);
    if (source->clipped)
        splat_draw_runs(source->clipped, uniforms, programs[2][pass], state, frame);
}

void splat_draw_hiders(const SplatSource *source, const FilterUniforms *uniforms,
                       const SplatSetting *setting, Frame *frame)
{
    SplatSource hiders = *source;
    if (source->hiders) {
        hiders.runs = source->hiders;
        hiders.run_count = source->hider_count;
    }
    draw_runs(&hiders, uniforms, SPLAT_VISIBILITY, setting,
              &(GpState){ .depth = { .test = GP_LESS, .write = true } }, frame);
}

GpPass *splat_begin_sums(GpSurface *const sums[2], GpSurface *visible, Frame *frame)
{
    GpPass *pass = frame_pass(frame, "splats", sums[0], visible, black);
    pass->depth.clear_depth = false;
    if (sums[1])
        pass->color[1] = (GpColorTarget){ .surface = sums[1], .clear = true };
    return pass;
}

void splat_draw_sums(const SplatSource *source, const FilterUniforms *uniforms,
                     const SplatView *view, const SplatSetting *setting, Frame *frame)
{
    draw_runs(source, uniforms, view->lit ? SPLAT_SURFACES : SPLAT_COLORS, setting,
              &(GpState){ .depth = { .test = GP_LESS_EQUAL }, .blend = { add, add } }, frame);
}

static void add_hidden_splats(const SplatSource *source, const SplatEye *eye, const SplatView *view,
                              const SplatSetting *setting, GpSurface *const sums[2],
                              GpSurface *visible, Frame *frame)
{
    const FilterUniforms uniforms = splat_filter_uniforms(eye, view, setting, frame);
    frame_pass(frame, "visibility", NULL, visible, NULL);
    splat_draw_hiders(source, &uniforms, setting, frame);
    splat_begin_sums(sums, visible, frame);
    splat_draw_sums(source, &uniforms, view, setting, frame);
}

static void add_quads(const SplatSource *source, const SplatEye *eye, const SplatView *view,
                      const SplatSetting *setting, GpSurface *const sums[2], GpSurface *visible,
                      Frame *frame)
{
    const SplatUniforms uniforms = splat_uniforms(eye, view, setting, SPLAT_QUADS);
    const GpGeometry quads = splat_quads(source, frame);
    const bool some = quads.index_count > 0;
    frame_pass(frame, "visibility", NULL, visible, NULL);
    if (some)
        frame_draw_copied(frame, &quad_visibility_program, &uniforms, &quads)->state =
            (GpState){ .depth = { .test = GP_LESS, .write = true } };
    splat_begin_sums(sums, visible, frame);
    if (some)
        frame_draw_copied(frame, view->lit ? &quad_surface_program : &quad_color_program, &uniforms,
                          &quads)
            ->state = (GpState){ .depth = { .test = GP_LESS_EQUAL }, .blend = { add, add } };
}

/* --- one pass --------------------------------------------------------------------------------- */

static double mean_radius(const SplatSource *source)
{
    double sum = 0, count = 0;
    for (uint32_t i = 0; i < source->run_count; i++) {
        sum += (double)source->runs[i].radius * source->runs[i].count;
        count += source->runs[i].count;
    }
    return count > 0 ? sum / count : 0;
}

/* A surface that is seen at an angle goes back by more than its footprints within one splat. The
 * test does not know the angle: it is taken for 76 degrees. Steeper ones lose weight. */
#define STEEP 4

/* Depths of one scale for all runs (shaders_c/points/ternary.h), by their mean radius; runs of
 * larger surfels have an epsilon larger by as much. */
static void add_ternary_splats(const SplatSource *source, const SplatEye *eye,
                               const SplatView *view, const SplatSetting *setting,
                               GpSurface *const sums[2], GpSurface *visible, Frame *frame)
{
    const double radius = mean_radius(source), per_z = setting->low_pass / eye->focal;
    const double near = stable_log(radius + per_z * view->camera.near);
    const double span = stable_log(radius + per_z * view->camera.far) - near;
    const double log_2 = stable_log(2);
    TernaryUniforms uniforms = {
        .splat = splat_uniforms(eye, view, setting, SPLAT_TERNARY),
        .footprint = { (float)radius, (float)per_z },
        .depth = { (float)(-near / span), (float)(log_2 / span) },
    };
    const TernaryUniforms *kept = frame_copy(frame, &uniforms, sizeof uniforms);
    splat_begin_sums(sums, visible, frame)->depth.clear_depth = true;
    for (uint32_t i = 0; i < source->run_count; i++) {
        const SplatRun *run = &source->runs[i];
        const GpGeometry geometry = splat_run_geometry(source, run);
        const double footprints = STEEP * setting->epsilon * fmax((double)run->radius / radius, 1);
        if (run->count > 0)
            frame_draw(frame, view->lit ? &ternary_surface_program : &ternary_color_program, kept,
                       &geometry)
                ->state = (GpState){
                .depth = { .test = GP_LESS_EQUAL,
                           .write = true,
                           .ternary = true,
                           .epsilon = (float)(stable_log(1 + footprints * per_z) / span) },
                .blend = { add, add },
            };
    }
}

void splat_make_sums(const SplatView *view, const SplatSetting *setting, GpSurface *sums[2],
                     Frame *frame)
{
    static const GpFormat formats[] = { [SPLAT_HALVES] = GP_A16B16G16R16F,
                                        [SPLAT_FLOATS] = GP_A32B32G32R32F,
                                        [SPLAT_BYTES] = GP_A8R8G8B8 };
    sums[1] = NULL;
    for (int i = 0; i < 1 + view->lit; i++)
        sums[i] = frame_target(frame, formats[setting->sums], view->width, view->height);
}

void splat_build_filtered(const SplatSource *source, const SplatEye *eye, const SplatView *view,
                          const SplatSetting *setting, Frame *frame)
{
    GpSurface *visible = frame_surface(frame, GP_D32F, view->width, view->height, 1);
    GpSurface *sums[2];
    splat_make_sums(view, setting, sums, frame);
    if (setting->method == SPLAT_TERNARY)
        add_ternary_splats(source, eye, view, setting, sums, visible, frame);
    else if (setting->method == SPLAT_QUADS)
        add_quads(source, eye, view, setting, sums, visible, frame);
    else
        add_hidden_splats(source, eye, view, setting, sums, visible, frame);
    add_normalization(eye, view, setting, sums, visible, frame);
}
