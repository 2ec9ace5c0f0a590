#include "apps/techniques/warp/model.h"

#include "apps/base/machine.h"
#include "apps/base/model_color.h"
#include "apps/base/stable_math.h"
#include "apps/depth_images/capture.h"
#include "apps/depth_images/drawing/light.h"
#include "apps/scene/camera_file.h"
#include "apps/scene/model.h"

#include <string.h>

enum { DEFAULT_SIDE = 512 };

/* --- the mesh --------------------------------------------------------------------------------- */

/* One colour for all vertices: of the setting, or where there are none. Shapes are white, which is none. */
static GpResult paint(const char *name, const char *color, GpMesh *mesh)
{
    const uint8_t *one = color ? model_color(color) : NULL;
    if (!one && mesh->colors && !model_after(name, "builtin:"))
        return GP_OK;
    one = one ? one : model_color("clay");
    if (!mesh->colors)
        mesh->colors = gp_alloc(mesh->vertex_count, 4 * sizeof *mesh->colors);
    for (size_t i = 0; i < mesh->vertex_count && mesh->colors; i++) {
        float *vertex = mesh->colors + 4 * i;
        for (int k = 0; k < 3; k++)
            vertex[k] = (float)one[k] / 255;
        vertex[3] = 1;
    }
    return mesh->colors ? GP_OK : GP_ERROR_MEMORY;
}

static Polygons polygons_of(const GpMesh *mesh, double waves)
{
    return (Polygons){ .positions = mesh->positions,
                       .normals = mesh->normals,
                       .colors = mesh->colors,
                       .indices = mesh->indices,
                       .vertex_count = mesh->vertex_count,
                       .triangle_count = mesh->triangle_count,
                       .waves = waves };
}

/* errors GP_ERROR_INVALID: it has no faces; those of model_mesh and model_waves */
static GpResult open_mesh(const char *name, const char *color, GpMesh *mesh, Polygons *polygons,
                          GpError *error)
{
    double waves;
    GpResult result = model_waves(color, &waves, error);
    if (!result)
        result = model_mesh(name, mesh, error);
    if (result)
        return result;
    if (mesh->triangle_count == 0)
        result = gp_fail(error, GP_ERROR_FORMAT, "%.200s: no faces, which a mesh is seen by", name);
    else if (paint(name, color, mesh))
        result = gp_fail(error, GP_ERROR_MEMORY, "%.200s: no memory", name);
    *polygons = polygons_of(mesh, waves);
    if (result)
        gp_mesh_free(mesh);
    return result;
}

/* --- cameras ---------------------------------------------------------------------------------- */

/* Near and far around the box, as seen along the view; parallel eyes move back until near is before them. */
static void fit_range(const Bounds *bounds, Camera *camera)
{
    double middle[3], forward[3], radius = 0;
    vector_subtract(camera->at, camera->eye, forward);
    vector_normalize(forward);
    for (int k = 0; k < 3; k++) {
        const double half = (bounds->high[k] - bounds->low[k]) / 2;
        middle[k] = bounds->low[k] + half - camera->eye[k];
        radius += half * half;
    }
    radius = fmax(sqrt(radius), 1e-6);
    const double distance = vector_dot(middle, forward);
    if (!(camera->fovy > 0))
        vector_add_scaled(camera->eye, distance - 2 * radius, forward, camera->eye);
    const double ahead = camera->fovy > 0 ? distance : 2 * radius;
    camera->near = fmax(ahead - radius, radius * 1e-3);
    camera->far = fmax(ahead + radius, 2 * camera->near);
}

/* About the upwards line through what the camera looks at. */
static Camera turn(const Camera *camera, const Bounds *bounds, double degrees)
{
    double turned[4][4], from[3];
    Camera made = *camera;
    matrix_rotation(camera->up, degrees, turned);
    vector_subtract(camera->eye, camera->at, from);
    for (int k = 0; k < 3; k++)
        made.eye[k] = camera->at[k] + vector_dot(turned[k], from);
    fit_range(bounds, &made);
    return made;
}

/* The default source: all of the mesh, from 30 degrees to the right and 20 above. */
static Camera default_source(const Bounds *bounds, const WarpOptions *options)
{
    const Orbit orbit = { .azimuth = 30, .elevation = 20, .up = options->orbit.up, .zoom = 1 };
    return orbit_camera(&orbit, bounds, (double)options->source_size[0] / options->source_size[1],
                        bounds_longest(bounds) * 1e-3);
}

static GpResult find_view(const TechniqueInput *input, WarpModel *model, GpError *error)
{
    const WarpOptions *options = input->setting;
    const bool sized = input->width > 0 && input->height > 0,
               is_from = options->orbit.azimuth == options->orbit.azimuth;
    model->width = sized ? input->width : DEFAULT_SIDE;
    model->height = sized ? input->height : DEFAULT_SIDE;
    model->is_fixed = is_from || options->camera;
    model->fixed = is_from ? orbit_camera(&options->orbit, &model->bounds,
                                          (double)model->width / model->height,
                                          bounds_longest(&model->bounds) * 1e-3)
                           : turn(&model->about, &model->bounds, options->turn);
    return options->camera ? camera_read_file(options->camera, &model->fixed, error) : GP_OK;
}

WarpView warp_model_view(const WarpModel *model, const WarpOptions *options, WarpLight *light)
{
    WarpView view = { .width = model->width, .height = model->height };
    view.camera =
        model->is_fixed ? model->fixed : turn(&model->about, &model->bounds, options->turn);
    *light = warp_light_beside(&view.camera);
    view.light = model->lit ? light : NULL;
    return view;
}

/* --- opening ---------------------------------------------------------------------------------- */

static GpResult open_source(const TechniqueInput *input, WarpModel *model, GpError *error)
{
    const WarpOptions *options = input->setting;
    GpResult result = open_mesh(input->path, options->color, &model->mesh, &model->polygons, error);
    if (result)
        return result;
    const CaptureSource source = { &model->mesh, model->polygons.waves };
    model->bounds = capture_bounds(&source);
    model->source = default_source(&model->bounds, options);
    if (options->source)
        result = camera_read_file(options->source, &model->source, error);
    model->about = model->source;
    model->lit = !options->unlit && !(model->polygons.waves > 0);
    return result;
}

GpResult warp_model_open(const TechniqueInput *input, void **made, GpError *error)
{
    const WarpOptions *options = input->setting;
    WarpModel *model = gp_alloc(1, sizeof *model);
    if (!model)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    model->name = input->path;
    model->truth_path = options->truth;
    GpResult result = open_source(input, model, error);
    if (!result)
        result = find_view(input, model, error);
    if (result) {
        warp_model_close(model);
        return result;
    }
    *made = model;
    return GP_OK;
}

void warp_model_close(void *made)
{
    WarpModel *model = made;
    while (model->images) {
        WarpImages *images = model->images;
        model->images = images->next;
        depth_model_free(&images->model);
        gp_free(images);
    }
    while (model->truths) {
        WarpTruth *truth = model->truths;
        model->truths = truth->next;
        ray_picture_free(&truth->picture);
        gp_free(truth);
    }
    gp_mesh_free(&model->mesh);
    gp_free(model);
}

/* --- images ----------------------------------------------------------------------------------- */

static GpResult capture(const WarpModel *model, WarpImages *images, GpDevice *device,
                        GpError *error)
{
    const CaptureSource source = { &model->mesh, model->polygons.waves };
    const Camera *camera = &model->source;
    const CaptureShot shot = { .plane = depth_plane_of_camera(camera, (double)images->size[0] /
                                                                          images->size[1]),
                               .width = images->size[0],
                               .height = images->size[1],
                               .near = camera->near,
                               .far = camera->far,
                               .behind = true };
    const GpResult result = capture_planar(device, &source, &shot, &images->model.images[0], error);
    images->model.count = result ? 0 : 1;
    return result;
}

GpResult warp_model_images(WarpModel *model, const WarpOptions *options, WarpKind kind,
                           GpDevice *device, WarpImages **found, GpError *error)
{
    for (WarpImages *images = model->images; images; images = images->next)
        if (images->kind == kind &&
            memcmp(images->size, options->source_size, sizeof images->size) == 0) {
            *found = images;
            return GP_OK;
        }
    WarpImages *images = gp_alloc(1, sizeof *images);
    if (!images)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    images->kind = kind;
    memcpy(images->size, options->source_size, sizeof images->size);
    const GpResult result = capture(model, images, device, error);
    if (result) {
        gp_free(images);
        return result;
    }
    images->next = model->images;
    *found = model->images = images;
    return GP_OK;
}

/* --- truths ----------------------------------------------------------------------------------- */

static GpResult find_truth(WarpModel *model, const WarpOptions *options, int threads,
                           RayPicture *truth, GpError *error)
{
    WarpLight light;
    const WarpView view = warp_model_view(model, options, &light);
    GpMesh mesh = { .positions = NULL };
    Polygons polygons = model->polygons;
    if (model->truth_path) {
        const GpResult result =
            open_mesh(model->truth_path, options->color, &mesh, &polygons, error);
        if (result)
            return result;
    }
    const GpResult result = warp_truth_of_mesh(&polygons, &view, threads, truth, error);
    gp_mesh_free(&mesh);
    return result;
}

GpResult warp_model_truth(WarpModel *model, const WarpOptions *options, int threads,
                          const RayPicture **found, GpError *error)
{
    for (WarpTruth *truth = model->truths; truth; truth = truth->next)
        if (truth->turn == options->turn) {
            *found = &truth->picture;
            return GP_OK;
        }
    WarpTruth *truth = gp_alloc(1, sizeof *truth);
    if (!truth)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    const GpResult result = find_truth(model, options, threads, &truth->picture, error);
    if (result) {
        gp_free(truth);
        return result;
    }
    truth->turn = options->turn;
    truth->next = model->truths;
    model->truths = truth;
    *found = &truth->picture;
    return GP_OK;
}

GpResult warp_model_error(WarpModel *model, const Frame *frame, int threads, WarpError *off,
                          GpError *error)
{
    const WarpOptions *options = frame->made;
    const RayPicture *truth;
    WarpLight light;
    const WarpView view = warp_model_view(model, options, &light);
    GpResult result = warp_model_truth(model, options, threads, &truth, error);
    if (!result && warp_error(truth, &view.camera, frame->color, frame->depth, off))
        result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    return result;
}
