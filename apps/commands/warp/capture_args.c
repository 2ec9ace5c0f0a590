#include "apps/commands/warp/capture_args.h"

#include "apps/base/stable_math.h"
#include "apps/commands/progress.h"
#include "apps/depth_images/depth_file.h"
#include "apps/depth_images/making/capture_box.h"
#include "apps/depth_images/making/height_map.h"
#include "apps/depth_images/making/rgbd.h"
#include "apps/frame/picture.h"
#include "apps/scene/capture.h"
#include "apps/techniques/warp/model.h"
#include "pipeline/io/file.h"

CaptureInput capture_input(const CaptureArgs *args)
{
    return args->depth                                  ? CAPTURE_INPUT_RGBD
           : args->relief > 0                           ? CAPTURE_INPUT_HEIGHTS
           : gp_file_has_extension(args->input, "json") ? CAPTURE_INPUT_SCENE
                                                        : CAPTURE_INPUT_MESH;
}

/* --- meshes ----------------------------------------------------------------------------------- */

/* A model's second layers are taken away where one was asked for. */
static void leave_layers(uint32_t layers, DepthModel *model)
{
    for (uint32_t i = 0; i < model->count && layers == 1; i++)
        depth_pixels_free(&model->images[i].behind);
}

static GpResult capture_opened(const CaptureArgs *args, WarpModel *opened, GpDevice *device,
                               DepthModel *model, GpError *error)
{
    const CaptureSource source = { &opened->mesh, opened->polygons.waves };
    const uint32_t *size = args->warp.source_size;
    const Progress progress = progress_begin(&args->options);
    const CaptureTurn turn = { .up = args->warp.orbit.up,
                               .rays = args->rays,
                               .width = size[0],
                               .height = size[1],
                               .behind = args->layers != 1,
                               .tell = progress_tell,
                               .listener = &progress };
    if (args->warp.kind == WARP_CYLINDER)
        return capture_cylinder(device, &source, &turn, model, error);
    if (args->warp.kind == WARP_BOX)
        return capture_box(device, &source, size[0] > size[1] ? size[0] : size[1],
                           args->layers != 1, model, error);
    WarpImages *images;
    const GpResult result = warp_model_images(opened, &args->warp, device, &images, error);
    if (!result) {
        *model = images->model; /* which is then the caller's */
        images->model = (DepthModel){ 0 };
        leave_layers(args->layers, model);
    }
    return result;
}

static GpResult capture_mesh(const CaptureArgs *args, GpDevice *device, DepthModel *model,
                             GpError *error)
{
    const TechniqueInput input = { .path = args->input, .setting = &args->warp };
    void *opened;
    if (depth_file_is_readable(args->input) || picture_has_extension(args->input))
        return gp_fail(error, GP_ERROR_INVALID,
                       "%s: a picture: expected --depth-file or --relief with it", args->input);
    GpResult result = warp_model_open(&input, &opened, error);
    if (result)
        return result;
    result = capture_opened(args, opened, device, model, error);
    warp_model_close(opened);
    return result;
}

/* --- the others ------------------------------------------------------------------------------- */

static GpResult capture_scene_file(const CaptureArgs *args, GpDevice *device, DepthImage *image,
                                   GpError *error)
{
    const SceneOptions options = { .width = args->options.size[0],
                                   .height = args->options.size[1] };
    Scene scene;
    GpError reason = { "" };
    GpResult result = scene_load(args->input, &options, &scene, error);
    if (result)
        return result;
    result = scene_capture(device, &scene, args->layers == 2, image, &reason);
    scene_free(&scene);
    return result ? gp_fail(error, result, "%s: %s", args->input, reason.text) : GP_OK;
}

/* Pictures are looked for as data is. */
static GpResult find(const char *name, char path[4096], GpError *error)
{
    return gp_data_find(name, path, 4096, error);
}

static GpResult read_rgbd(const CaptureArgs *args, DepthImage *image, GpError *error)
{
    char color[4096], depth[4096], lens[4096];
    RgbdCamera camera;
    GpResult result = find(args->camera, lens, error);
    if (!result)
        result = rgbd_camera_read(lens, args->frame, &camera, error);
    if (!result)
        result = find(args->input, color, error);
    if (!result)
        result = find(args->depth, depth, error);
    if (result)
        return result;
    camera.unit = args->unit > 0 ? args->unit : camera.unit;
    return rgbd_read(color, depth, &camera, image, error);
}

static GpResult read_heights(const CaptureArgs *args, DepthImage *image, GpError *error)
{
    char paths[2][4096];
    const double width = args->width > 0 ? args->width : 1;
    GpResult result = find(args->input, paths[0], error);
    if (!result && args->height)
        result = find(args->height, paths[1], error);
    if (result)
        return result;
    return args->height ? height_map_read(paths[0], paths[1], width, args->relief, image, error)
                        : height_map_read(NULL, paths[0], width, args->relief, image, error);
}

static bool shows_anything(const DepthModel *model)
{
    for (uint32_t i = 0; i < model->count; i++) {
        const DepthPixels *front = &model->images[i].front;
        for (size_t p = 0; p < (size_t)front->width * front->height; p++)
            if (isfinite(front->depth[p]))
                return true;
    }
    return false;
}

GpResult capture_model(const CaptureArgs *args, GpDevice *device, DepthModel *model, GpError *error)
{
    const CaptureInput input = capture_input(args);
    DepthModel made = { .count = 1 };
    GpResult result = input == CAPTURE_INPUT_MESH ? capture_mesh(args, device, &made, error)
                      : input == CAPTURE_INPUT_SCENE
                          ? capture_scene_file(args, device, &made.images[0], error)
                      : input == CAPTURE_INPUT_RGBD ? read_rgbd(args, &made.images[0], error)
                                                    : read_heights(args, &made.images[0], error);
    if (!result && !shows_anything(&made))
        result = gp_fail(error, GP_ERROR_INVALID, "%s: nothing is seen of it", args->input);
    if (result)
        depth_model_free(&made);
    else
        *model = made;
    return result;
}

GpResult capture_camera(const DepthModel *model, Camera *camera, GpError *error)
{
    const DepthImage *image = &model->images[0];
    const DepthPlane *plane = &image->plane;
    const double half[2] = { plane->width / 2, plane->height / 2 };
    if (model->count > 1 || image->is_cylinder || fabs(plane->left + half[0]) > 1e-3 * half[0] ||
        fabs(plane->bottom + half[1]) > 1e-3 * half[1])
        return gp_fail(
            error, GP_ERROR_INVALID,
            "no camera of a scene takes this: expected one planar image about its own middle");
    double near = HUGE_VAL, far = 0;
    for (size_t i = 0; i < (size_t)image->front.width * image->front.height; i++) {
        const double depth = (double)image->front.depth[i];
        near = depth < near ? depth : near;
        far = isfinite(depth) && depth > far ? depth : far;
    }
    *camera = (Camera){ .near = fmax(near / 2, 1e-3 * far), .far = fmax(2 * far, 1e-30) };
    camera->near = fmax(camera->near, 1e-3 * camera->far);
    if (plane->is_parallel)
        camera->height = plane->height;
    else
        camera->fovy = 2 * stable_atan2(half[1], 1) * (180 / 3.14159265358979323846);
    for (int k = 0; k < 3; k++) {
        camera->eye[k] = plane->eye[k];
        camera->at[k] = plane->eye[k] + plane->forward[k];
        camera->up[k] = plane->up[k];
    }
    return GP_OK;
}
