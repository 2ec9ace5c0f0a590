#include "apps/scene/capture.h"

#include "apps/depth_images/capture.h"
#include "apps/depth_images/drawing/surface_grid.h"

/* The depth along the view that a depth buffer's value means (camera_projection). */
static double depth_of(const Camera *camera, double value)
{
    const double near = camera->near, far = camera->far;
    return camera->fovy > 0 ? near * far / (far - value * (far - near))
                            : near + value * (far - near);
}

/* --- what is drawn ---------------------------------------------------------------------------- */

/* What a pixel's stencil says, from PASSED_NONE on: as fragments come, the nearest first, one is
 * passed; of those behind it the first that faces the eye is taken; then all are left. */
enum { PASSED_ONE = 0, PASSED_NONE = 1, LEAST_TAKEN = 2 };

/* Counts down, and below 0 there is 255. Backs are passed, but never taken. */
static GpState state_behind(GpState state)
{
    state.stencil = (GpStencilState){
        .enable = true,
        .two_sided = true,
        .front = { .test = GP_NEVER, .fail = GP_STENCIL_DECR_SAT },
        .back = { .test = GP_GREATER, .pass = GP_STENCIL_DECR },
        .reference = LEAST_TAKEN,
    };
    state.depth = (GpDepthState){ .test = GP_ALWAYS, .write = true };
    return state;
}

/* Draws what the scene's pass draws with a depth, into targets of its own. */
static GpResult draw_behind(GpDevice *device, const Scene *scene, GpSurface *color,
                            GpSurface *depth, GpError *error)
{
    const GpPass *front = &scene->list.passes[0];
    GpDraw *draws = gp_alloc(front->draw_count ? front->draw_count : 1, sizeof *draws);
    GpPass pass = *front;
    if (!draws)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for %u draws", front->draw_count);
    pass.draw_count = 0;
    for (uint32_t i = 0; i < front->draw_count; i++) {
        GpDraw *draw = &draws[pass.draw_count];
        *draw = front->draws[i];
        pass.draw_count += draw->state.depth.write;
        draw->state = state_behind(draw->state);
    }
    pass.draws = draws;
    pass.order = GP_ORDER_DEPTH_NEAR_FIRST;
    pass.color[0].surface = color;
    pass.depth = (GpDepthTarget){ .surface = depth,
                                  .clear_depth = true,
                                  .clear_stencil = true,
                                  .depth_value = 1,
                                  .stencil_value = PASSED_NONE };
    const GpResult result = gp_device_run(device, &(GpList){ &pass, 1 }, error);
    gp_free(draws);
    return result;
}

/* --- what is taken of it ---------------------------------------------------------------------- */

/* What has been read of a pass's targets. */
typedef struct Taken {
    float *color, *depth; /* [texels][4] */
    uint32_t *words;      /* depth with stencil, as it is stored; NULL: all are taken */
} Taken;

static void taken_free(Taken *taken)
{
    gp_free(taken->color);
    gp_free(taken->depth);
    gp_free(taken->words);
}

static void take_pixels(const Camera *camera, const Taken *taken, DepthPixels *pixels)
{
    for (size_t i = 0; i < (size_t)pixels->width * pixels->height; i++) {
        if (taken->depth[4 * i] == 1 || (taken->words && (taken->words[i] & 255) < LEAST_TAKEN))
            continue;
        pixels->depth[i] = (float)depth_of(camera, (double)taken->depth[4 * i]);
        for (size_t k = 0; k < 3; k++) {
            const float c = taken->color[4 * i + k];
            pixels->color[3 * i + k] = c > 0 ? c < 1 ? c : 1 : 0; /* NaN: 0 */
        }
    }
}

/* A layer of an image, with normals from its depths. in  behind: the stencil tells */
static GpResult take_layer(const Camera *camera, const GpSurface *color, const GpSurface *depth,
                           bool behind, const DepthImage *image, DepthPixels *layer, GpError *error)
{
    const size_t texels = (size_t)color->width * color->height;
    DepthImage made = { .plane = image->plane };
    Taken taken = { gp_alloc(texels, 4 * sizeof(float)), gp_alloc(texels, 4 * sizeof(float)),
                    behind ? gp_alloc(texels, sizeof(uint32_t)) : NULL };
    GpResult result = taken.color && taken.depth && (taken.words || !behind)
                          ? depth_pixels_make(color->width, color->height, false, &made.front)
                          : GP_ERROR_MEMORY;
    if (result)
        gp_fail(error, result, "no memory for %ux%u pixels", color->width, color->height);
    if (!result)
        result = gp_surface_read_floats(color, 0, NULL, taken.color, error);
    if (!result)
        result = gp_surface_read_floats(depth, 0, NULL, taken.depth, error);
    if (!result && behind)
        result = gp_surface_read_bytes(depth, 0, NULL, taken.words, 0, error);
    if (!result)
        take_pixels(camera, &taken, &made.front);
    taken_free(&taken);
    if (!result)
        result = surface_grid_normals(&made, 4, &made.front.normal, error);
    if (result)
        depth_pixels_free(&made.front);
    else
        *layer = made.front;
    return result;
}

static GpResult capture_behind(GpDevice *device, const Scene *scene, DepthImage *image,
                               GpError *error)
{
    const GpSurface *picture = scene->picture;
    GpSurface *color = NULL, *depth = NULL;
    const GpSurfaceDesc shown = { .format = picture->format,
                                  .width = picture->width,
                                  .height = picture->height },
                        deep = { .format = GP_D24S8,
                                 .width = picture->width,
                                 .height = picture->height };
    if (scene->list.pass_count != 1)
        return gp_fail(error, GP_ERROR_INVALID,
                       "splats and volumes have no second layer: expected meshes and depth images "
                       "alone, or one layer");
    GpResult result = gp_surface_create(&shown, &color, error);
    if (!result)
        result = gp_surface_create(&deep, &depth, error);
    if (!result)
        result = draw_behind(device, scene, color, depth, error);
    if (!result)
        result = take_layer(&scene->camera, color, depth, true, image, &image->behind, error);
    gp_surface_destroy(&color);
    gp_surface_destroy(&depth);
    return result;
}

GpResult scene_capture(GpDevice *device, const Scene *scene, bool behind, DepthImage *image,
                       GpError *error)
{
    if (scene->has_passes)
        return gp_fail(error, GP_ERROR_INVALID,
                       "a scene with passes of its own, which may look from elsewhere: expected "
                       "objects and lights under one camera, without \"passes\"");
    if (!scene->depth)
        return gp_fail(error, GP_ERROR_INVALID, "a scene without a depth buffer");
    const double aspect = (double)scene->picture->width / scene->picture->height;
    DepthImage made = { .plane = depth_plane_of_camera(&scene->camera, aspect) };
    GpResult result = gp_device_run(device, &scene->list, error);
    if (!result)
        result = take_layer(&scene->camera, scene->picture, scene->depth, false, &made, &made.front,
                            error);
    if (!result && behind)
        result = capture_behind(device, scene, &made, error);
    if (result)
        depth_pixels_free(&made.front);
    else
        *image = made;
    return result;
}
