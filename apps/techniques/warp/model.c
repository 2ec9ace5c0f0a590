#include "apps/techniques/warp/model.h"

#include "apps/base/machine.h"
#include "apps/base/model_color.h"
#include "apps/depth_images/capture.h"
#include "apps/depth_images/drawing/light.h"
#include "apps/depth_images/making/capture_box.h"
#include "apps/depth_images/making/capture_cylinder.h"
#include "apps/frame/picture.h"
#include "apps/scene/camera_file.h"
#include "apps/scene/model.h"
#include "apps/techniques/warp/cameras.h"

#include <string.h>

enum { DEFAULT_SIDE = 512 };

/* --- the mesh --------------------------------------------------------------------------------- */

/* One colour for all vertices: of the setting, or where there are none. Shapes are white, which is
 * none. */
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

/* --- opening ---------------------------------------------------------------------------------- */

static GpResult open_source(const TechniqueInput *input, WarpModel *model, GpError *error)
{
    const WarpOptions *options = input->setting;
    GpResult result = open_mesh(input->path, options->color, &model->mesh, &model->polygons, error);
    if (result)
        return result;
    const CaptureSource source = { &model->mesh, model->polygons.waves };
    const uint32_t *size = options->source_size;
    model->bounds = capture_bounds(&source);
    model->source = camera_beside(&model->bounds, options->orbit.up, (double)size[0] / size[1]);
    if (options->source)
        result = camera_read_file(options->source, &model->source, error);
    model->about = model->source;
    model->up = options->orbit.up;
    model->lit = !options->unlit && !(model->polygons.waves > 0);
    return result;
}

/* What is said of a capture does not go with an image that is there. */
static GpResult check_image(const char *path, const WarpOptions *options, GpError *error)
{
    /* else the method means it, and is told that it does not draw this */
    const bool is_asked = options->kind && warp_method_draws(options->method, WARP_PLANAR);
    const char *wrong = options->source  ? "source"
                        : options->color ? "color"
                        : is_asked       ? "kind"
                                         : NULL;
    return wrong ? gp_fail(error, GP_ERROR_INVALID,
                           "%.200s: --%s is of what is captured of a mesh, and this is a depth "
                           "image",
                           path, wrong)
                 : GP_OK;
}

/* Nor are options kept that the method auto does not have for images of its kind. */
static GpResult check_method(const char *path, const WarpOptions *options, WarpKind kind,
                             GpError *error)
{
    const bool is_surface =
        options->method == WARP_AUTO && warp_auto_method(kind, options->detail) != WARP_LAYERS;
    const char *wrong = options->cut != warp_option_defaults.cut               ? "cut"
                        : options->tolerance != warp_option_defaults.tolerance ? "tolerance"
                                                                               : NULL;
    return is_surface && wrong
               ? gp_fail(error, GP_ERROR_INVALID,
                         "%.200s: --%s is of planar images, and this is none", path, wrong)
               : GP_OK;
}

static GpResult open_images(const TechniqueInput *input, WarpModel *model, GpError *error)
{
    const WarpOptions *options = input->setting;
    WarpImages *images = gp_alloc(1, sizeof *images);
    if (!images)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    GpResult result = check_image(input->path, options, error);
    if (!result)
        result = model_depth_images(input->path, &images->model, error);
    if (result) {
        gp_free(images);
        return result;
    }
    const DepthImage *first = &images->model.images[0];
    const bool is_plane = images->model.count == 1 && !first->is_cylinder;
    images->kind = first->is_cylinder ? WARP_CYLINDER : is_plane ? WARP_PLANAR : WARP_BOX;
    result = check_method(input->path, options, images->kind, error);
    if (result) {
        depth_model_free(&images->model);
        gp_free(images);
        return result;
    }
    model->images = images;
    model->is_image = true;
    model->bounds = bounds_of_images(&images->model);
    model->about = is_plane ? camera_of_plane(&first->plane, &model->bounds)
                            : camera_beside(&model->bounds, options->orbit.up, 1);
    model->lit = !options->unlit && first->front.normal;
    model->width = is_plane ? first->front.width : DEFAULT_SIDE;
    model->height = is_plane ? first->front.height : DEFAULT_SIDE;
    return GP_OK;
}

/* The truth's picture is the view's, where none is described. */
static GpResult open_truth(const WarpOptions *options, WarpModel *model, GpError *error)
{
    model->color = options->color;
    model->truth_path = options->truth;
    if (!options->truth || !depth_file_is_readable(options->truth))
        return GP_OK;
    const GpResult result = model_depth_images(options->truth, &model->truth_images, error);
    if (result)
        return result;
    const DepthImage *image = &model->truth_images.images[0];
    model->lit = false; /* for its colours are as they are */
    if (image->is_cylinder || options->camera || !isnan(options->orbit.azimuth))
        return GP_OK;
    model->fixed = camera_of_plane(&image->plane, &model->bounds);
    model->is_fixed = true;
    model->width = image->front.width;
    model->height = image->front.height;
    return GP_OK;
}

static GpResult find_view(const TechniqueInput *input, WarpModel *model, GpError *error)
{
    const WarpOptions *options = input->setting;
    const bool is_from = !isnan(options->orbit.azimuth);
    if (input->width > 0 && input->height > 0) {
        model->width = input->width;
        model->height = input->height;
    }
    const double aspect = (double)model->width / model->height;
    if (is_from)
        model->fixed = orbit_camera(&options->orbit, &model->bounds, aspect,
                                    bounds_longest(&model->bounds) * 1e-3);
    else if (options->camera)
        model->fixed = camera_turned(&model->about, &model->bounds, options->turn);
    model->is_fixed |= is_from || options->camera;
    return options->camera ? camera_read_file(options->camera, &model->fixed, error) : GP_OK;
}

WarpView warp_model_view(const WarpModel *model, const WarpOptions *options, WarpLight *light)
{
    WarpView view = { .width = model->width, .height = model->height };
    view.camera = model->is_fixed ? model->fixed
                                  : camera_turned(&model->about, &model->bounds, options->turn);
    *light = warp_light_beside(&view.camera);
    view.light = model->lit ? light : NULL;
    return view;
}

/* Names that end as what depth images are captured of, but meshes. */
static GpResult check_name(const char *path, GpError *error)
{
    const char *what = picture_has_extension(path)           ? "picture"
                       : gp_file_has_extension(path, "json") ? "scene"
                                                             : NULL;
    return what && !depth_file_is_readable(path)
               ? gp_fail(error, GP_ERROR_INVALID,
                         "%.200s: a %s: expected a mesh, or a depth image, .exr; glasspipe warp "
                         "capture makes one of a %s",
                         path, what, what)
               : GP_OK;
}

GpResult warp_model_open(const TechniqueInput *input, void **made, GpError *error)
{
    WarpModel *model = gp_alloc(1, sizeof *model);
    if (!model)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    model->width = model->height = DEFAULT_SIDE;
    GpResult result = check_name(input->path, error);
    if (!result)
        result = depth_file_is_readable(input->path) ? open_images(input, model, error)
                                                     : open_source(input, model, error);
    if (!result)
        result = warp_heights_open(input->setting, &model->bounds, &model->heights, error);
    if (!result && model->is_image)
        result = warp_heights_lean(&model->heights, &model->images->model, error);
    if (!result)
        result = open_truth(input->setting, model, error);
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
    depth_model_free(&model->truth_images);
    warp_heights_close(&model->heights);
    gp_mesh_free(&model->mesh);
    gp_free(model);
}

/* --- images ----------------------------------------------------------------------------------- */

static GpResult capture_plane(const WarpModel *model, const uint32_t size[2],
                              const CaptureSource *source, GpDevice *device, DepthModel *captured,
                              GpError *error)
{
    const Camera *camera = &model->source;
    const CaptureShot shot = { .plane = depth_plane_of_camera(camera, (double)size[0] / size[1]),
                               .width = size[0],
                               .height = size[1],
                               .near = camera->near,
                               .far = camera->far,
                               .behind = true };
    const GpResult result = capture_planar(device, source, &shot, &captured->images[0], error);
    captured->count = result ? 0 : 1;
    return result;
}

static GpResult capture(const WarpModel *model, WarpImages *images, GpDevice *device,
                        GpError *error)
{
    const CaptureSource source = { &model->mesh, model->polygons.waves };
    const uint32_t *size = images->size;
    if (images->kind == WARP_PLANAR)
        return capture_plane(model, size, &source, device, &images->model, error);
    const CaptureTurn turn = { .up = model->up, .width = size[0], .height = size[1] };
    return images->kind == WARP_CYLINDER
               ? capture_cylinder(device, &source, &turn, &images->model, error)
               : capture_box(device, &source, size[0] > size[1] ? size[0] : size[1], false,
                             &images->model, error);
}

GpResult warp_model_images(WarpModel *model, const WarpOptions *options, GpDevice *device,
                           WarpImages **found, GpError *error)
{
    for (WarpImages *images = model->images; images; images = images->next)
        if (model->is_image ||
            (images->kind == options->kind &&
             memcmp(images->size, options->source_size, sizeof images->size) == 0)) {
            *found = images;
            return GP_OK;
        }
    WarpImages *images = gp_alloc(1, sizeof *images);
    if (!images)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    images->kind = options->kind;
    memcpy(images->size, options->source_size, sizeof images->size);
    GpResult result = capture(model, images, device, error);
    if (!result)
        result = warp_heights_lean(&model->heights, &images->model, error);
    if (result) {
        depth_model_free(&images->model);
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
    if (model->truth_images.count > 0)
        return warp_truth_of_image(&model->truth_images.images[0], &view, truth, error);
    if (model->is_image && !model->truth_path)
        return gp_fail(error, GP_ERROR_INVALID,
                       "the truth is the mesh that was captured, and a depth image has none: name "
                       "it by --truth");
    if (model->heights.surface && !model->truth_path)
        return gp_fail(
            error, GP_ERROR_INVALID,
            "the mesh lacks what --detail adds to it: --measure needs a --truth that has "
            "it, and --error has none");
    GpResult result = GP_OK;
    if (model->truth_path)
        result = open_mesh(model->truth_path, model->color, &mesh, &polygons, error);
    if (!result)
        result = warp_truth_of_mesh(&polygons, &view, threads, truth, error);
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
