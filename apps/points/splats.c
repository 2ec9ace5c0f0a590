#include "apps/points/splats.h"

#include "apps/base/stable_math.h"
#include "shaders_c/points/disc.h"
#include "shaders_c/points/normalize.h"
#include "shaders_c/points/splat.h"

#include <math.h>
#include <string.h>

const SplatSetting splat_defaults = { .low_pass = 0.4, .spread = 0.8, .cut = 2, .epsilon = 4 };

/* --- the camera ------------------------------------------------------------------------------- */

/* Axes of an eye that looks along z, with y down the picture. */
typedef struct Eye {
    double axis[3][3]; /* right, down, forward */
    double focal;      /* pixels */
    double depth[2];
} Eye;

static Eye find_eye(const SplatView *view)
{
    const Camera *camera = &view->camera;
    const CameraAxes axes = camera_axes(camera, (double)view->width / view->height);
    const double range = camera->far - camera->near;
    Eye eye = { .focal = view->height / (2 * axes.half_height),
                .depth = { camera->far / range, -camera->far * camera->near / range } };
    for (int k = 0; k < 3; k++) {
        eye.axis[0][k] = axes.right[k];
        eye.axis[1][k] = -axes.up[k];
        eye.axis[2][k] = axes.forward[k];
    }
    return eye;
}

static SplatUniforms splat_uniforms(const Eye *eye, const SplatView *view,
                                    const SplatSetting *setting, SplatMethod filter)
{
    const double low_pass = filter == SPLAT_RECONSTRUCTION ? 0 : setting->low_pass;
    SplatUniforms uniforms = {
        .focal = (float)eye->focal,
        .centre = { (float)view->width / 2, (float)view->height / 2 },
        .ndc = { 2 / (float)view->width, 2 / (float)view->height },
        .depth = { (float)eye->depth[0], (float)eye->depth[1] },
        .nearest = (float)view->camera.near,
        .facing = setting->two_sided ? -INFINITY : 0,
        .low_pass = (float)(low_pass * low_pass),
        .spread = filter == SPLAT_LOW_PASS ? 0 : (float)setting->spread,
        .cut = (float)setting->cut,
        .epsilon = (float)setting->epsilon,
        .waves = (float)view->waves,
    };
    for (int i = 0; i < 3; i++) {
        uniforms.eye[i][3] = (float)-vector_dot(eye->axis[i], view->camera.eye);
        for (int k = 0; k < 3; k++)
            uniforms.eye[i][k] = (float)eye->axis[i][k];
    }
    return uniforms;
}

SplatLight splat_light(const SplatView *view)
{
    const Eye eye = find_eye(view);
    SplatLight light = { .ambient = 0.15, .specular = 0.25, .shininess = 32 };
    for (int k = 0; k < 3; k++)
        light.towards[k] = -0.4 * eye.axis[0][k] - 0.5 * eye.axis[1][k] - eye.axis[2][k];
    vector_normalize(light.towards);
    return light;
}

/* --- geometry --------------------------------------------------------------------------------- */

static GpGeometry run_geometry(const SplatSource *source, const SplatRun *run)
{
    const Surfel *first = source->surfels + run->first;
    return (GpGeometry){
        .primitive = GP_POINTS,
        .vertex_count = run->count,
        .streams = {
            [GP_POSITION] = { first->position, sizeof *first, 3, GP_FLOAT32 },
            [GP_NORMAL] = { first->normal, sizeof *first, 3, GP_FLOAT32 },
            [GP_POINT_SIZE] = { &first->radius, sizeof *first, 1, GP_FLOAT32 },
            [GP_COLOR] = { first->color, sizeof *first, 4, GP_UNORM8 },
        },
    };
}

/* Uniforms for each filter that a run may have. */
typedef struct FilterUniforms {
    const void *of[SPLAT_METHODS];
} FilterUniforms;

static FilterUniforms filter_uniforms(const Eye *eye, const SplatView *view,
                                      const SplatSetting *setting, Frame *frame)
{
    FilterUniforms uniforms;
    for (int i = 0; i < SPLAT_METHODS; i++) {
        const SplatUniforms filtered = splat_uniforms(eye, view, setting, (SplatMethod)i);
        uniforms.of[i] = frame_copy(frame, &filtered, sizeof filtered);
    }
    return uniforms;
}

static void draw_runs(const SplatSource *source, const FilterUniforms *uniforms,
                      const GpProgram *program, const GpState *state, Frame *frame)
{
    for (uint32_t i = 0; i < source->run_count; i++) {
        const SplatRun *run = &source->runs[i];
        const GpGeometry geometry = run_geometry(source, run);
        if (run->count > 0)
            frame_draw(frame, program, uniforms->of[run->filter], &geometry)->state = *state;
    }
}

/* --- splats ----------------------------------------------------------------------------------- */

static const float black[4] = { 0 };

/* The share of a Gaussian inside its cut. */
static double inside_cut(double cut)
{
    return 1 - stable_exp(-cut * cut / 2);
}

static NormalizeUniforms normalize_uniforms(const Eye *eye, const SplatView *view,
                                            const SplatSetting *setting)
{
    /* along a straight border the sums fall from 1 to 0 with the filter's integral; twice as steep, the
     * surface is whole where they are 3/4, and a border is blurred by less than a pixel */
    const double per_weight = 1 / inside_cut(setting->cut), steep = 2;
    const SplatLight light = splat_light(view);
    NormalizeUniforms uniforms = {
        .coverage = { (float)(steep * per_weight), (float)((1 - steep) / 2) },
        .per_focal = (float)(1 / eye->focal),
        .centre = { (float)view->width / 2, (float)view->height / 2 },
        .light = { (float)light.towards[0], (float)light.towards[1], (float)light.towards[2] },
        .ambient = (float)light.ambient,
        .specular = (float)light.specular,
        .shininess = (float)light.shininess,
        .depth = { (float)eye->depth[0], (float)eye->depth[1] },
    };
    memcpy(uniforms.background, view->background, sizeof uniforms.background);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            uniforms.axes[i][k] = (float)eye->axis[i][k];
    return uniforms;
}

static GpGeometry whole_picture(void)
{
    static const float corners[] = { -1, -1, 0, -1, 3, 0, 3, -1, 0 };
    return (GpGeometry){ .vertex_count = 3,
                         .streams = { [GP_POSITION] = { .data = corners, .components = 3 } } };
}

static void add_normalization(const Eye *eye, const SplatView *view, const SplatSetting *setting,
                              GpSurface *sums[2], Frame *frame)
{
    const NormalizeUniforms uniforms = normalize_uniforms(eye, view, setting);
    const GpGeometry whole = whole_picture();
    frame->color = frame_surface(frame, GP_A8R8G8B8, view->width, view->height, 1);
    frame->depth = view->lit ? frame_surface(frame, GP_D32F, view->width, view->height, 1) : NULL;
    frame_pass(frame, "normalize", frame->color, frame->depth, view->background);
    GpDraw *draw = frame_draw_copied(
        frame, view->lit ? &splat_shade_program : &splat_normalize_program, &uniforms, &whole);
    draw->textures[0].surface = sums[0];
    draw->textures[1].surface = sums[1];
    if (view->lit)
        draw->state.depth = (GpDepthState){ .test = GP_ALWAYS, .write = true };
}

static void build_splats(const SplatSource *source, const Eye *eye, const SplatView *view,
                         const SplatSetting *setting, Frame *frame)
{
    static const GpFormat formats[] = { [SPLAT_HALVES] = GP_A16B16G16R16F,
                                        [SPLAT_FLOATS] = GP_A32B32G32R32F,
                                        [SPLAT_BYTES] = GP_A8R8G8B8 };
    static const GpBlend add = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };
    GpSurface *visible = frame_surface(frame, GP_D32F, view->width, view->height, 1);
    GpSurface *sums[2] = { NULL, NULL };
    for (int i = 0; i < 1 + view->lit; i++)
        sums[i] = frame_surface(frame, formats[setting->sums], view->width, view->height, 1);

    const FilterUniforms uniforms = filter_uniforms(eye, view, setting, frame);
    frame_pass(frame, "visibility", NULL, visible, NULL);
    draw_runs(source, &uniforms, &splat_visibility_program,
              &(GpState){ .depth = { .test = GP_LESS, .write = true } }, frame);

    GpPass *pass = frame_pass(frame, "splats", sums[0], visible, black);
    pass->depth.clear_depth = false;
    if (view->lit)
        pass->color[1] = (GpColorTarget){ .surface = sums[1], .clear = true };
    draw_runs(source, &uniforms, view->lit ? &splat_surface_program : &splat_color_program,
              &(GpState){ .depth = { .test = GP_LESS_EQUAL }, .blend = { add, add } }, frame);
    add_normalization(eye, view, setting, sums, frame);
}

/* --- rivals ----------------------------------------------------------------------------------- */

static void build_discs(const SplatSource *source, const Eye *eye, const SplatView *view,
                        const SplatSetting *setting, Frame *frame)
{
    const bool round = setting->method == SPLAT_ROUND;
    const GpProgram *program = round ? &point_round_program : &point_pixel_program;
    const GpState nearest = { .depth = { .test = GP_LESS, .write = true } };
    frame->color = frame_surface(frame, GP_A8R8G8B8, view->width, view->height, 1);
    frame->depth = frame_surface(frame, GP_D32F, view->width, view->height, 1);
    frame_pass(frame, "points", frame->color, frame->depth, view->background);
    if (!view->lit) {
        const FilterUniforms uniforms = filter_uniforms(eye, view, setting, frame);
        draw_runs(source, &uniforms, program, &nearest, frame);
        return;
    }
    const SplatLight light = splat_light(view);
    LitPointUniforms lit = { splat_uniforms(eye, view, setting, setting->method),
                             .ambient = (float)light.ambient };
    for (int k = 0; k < 3; k++)
        lit.light[k] = (float)light.towards[k];
    FilterUniforms uniforms;
    uniforms.of[setting->method] = frame_copy(frame, &lit, sizeof lit);
    draw_runs(source, &uniforms, round ? &lit_round_program : &lit_pixel_program, &nearest, frame);
}

GpResult splats_build(const SplatSource *source, const SplatView *view, const SplatSetting *setting,
                      Frame *frame, GpError *error)
{
    if (view->camera.fovy <= 0)
        return gp_fail(error, GP_ERROR_INVALID,
                       "splats are seen by a perspective camera: expected a \"fovy\" above 0");
    const Eye eye = find_eye(view);
    if (setting->method == SPLAT_ROUND || setting->method == SPLAT_PIXELS)
        build_discs(source, &eye, view, setting, frame);
    else
        build_splats(source, &eye, view, setting, frame);
    return GP_OK;
}
