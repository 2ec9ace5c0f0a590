#include "apps/depth_images/making/rgbd.h"

#include "apps/base/json_reader.h"
#include "apps/base/vector.h"
#include "apps/depth_images/drawing/surface_grid.h"
#include "apps/frame/picture.h"
#include "pipeline/io/image/image_file.h"

#include <string.h>

/* --- cameras ---------------------------------------------------------------------------------- */

#define FAR 1e9

/* Turns by whole numbers to 1e-3 are made exact: right first, then up. */
static void read_turn(const Node *node, double rows[3][4], RgbdCamera *camera)
{
    double *const axes[3] = { camera->right, camera->up, camera->forward };
    double back[3];
    for (int axis = 0; axis < 3; axis++)
        for (int k = 0; k < 3; k++)
            axes[axis][k] = axis == 1 ? -rows[k][axis] : rows[k][axis];
    vector_cross(camera->right, camera->up, back);
    bool is_turn = true;
    for (int k = 0; k < 3; k++) {
        camera->eye[k] = rows[k][3];
        is_turn = is_turn && fabs(back[k] + camera->forward[k]) < 1e-3;
    }
    for (int axis = 0; axis < 3; axis++)
        is_turn = is_turn && fabs(vector_dot(axes[axis], axes[axis]) - 1) < 1e-3;
    if (!is_turn)
        node_fail(node, GP_ERROR_FORMAT,
                  "expected a turn: columns of length 1, square to each other");
    vector_normalize(camera->right);
    vector_add_scaled(camera->up, -vector_dot(camera->up, camera->right), camera->right,
                      camera->up);
    vector_normalize(camera->up);
    vector_cross(camera->right, camera->up, back);
    for (int k = 0; k < 3; k++)
        camera->forward[k] = -back[k];
}

static void read_frame(Node *frames, const char *name, RgbdCamera *camera)
{
    node_require(frames);
    const char *first =
        frames->value ? json_object_iter_key(json_object_iter(frames->value)) : NULL;
    if (!name && json_object_size(frames->value) != 1) {
        node_fail(frames, GP_ERROR_FORMAT, "expected one frame, or the name of one of these");
        return;
    }
    Node frame = node_member(frames, name ? name : first);
    node_require(&frame);
    Node to_world = node_member(&frame, "camera_to_world");
    node_require(&to_world);
    double rows[4][4] = { { 0 } };
    if (!node_has_length(to_world, 4, "four rows"))
        return;
    for (size_t i = 0; i < 4; i++) {
        const Node row = node_element(&to_world, i);
        node_doubles(row, rows[i], 4, -FAR, FAR);
    }
    if (frame.reader->result == GP_OK)
        read_turn(&to_world, rows, camera);
}

static double read_length(Node *object, const char *key, double low)
{
    const Node node = node_member(object, key);
    node_require(&node);
    return node_double(node, 1, low, FAR);
}

GpResult rgbd_camera_read(const char *path, const char *frame, RgbdCamera *camera, GpError *error)
{
    Reader reader;
    GpResult result = reader_open(&reader, path, error);
    if (result)
        return result;
    RgbdCamera read = { .unit = 0 };
    Node root = node_root(&reader);
    Node lens = node_member(&root, "intrinsics"), frames = node_member(&root, "frames");
    node_require(&lens);
    read.fx = read_length(&lens, "fx", 1e-6);
    read.fy = read_length(&lens, "fy", 1e-6);
    read.cx = read_length(&lens, "cx", -FAR);
    read.cy = read_length(&lens, "cy", -FAR);
    read.unit = node_double(node_member(&root, "depth_unit_m"), 0.001, 1e-9, FAR);
    const Node axes = node_member(&root, "camera_axes");
    static const char known[] = "x right, y down, z forward";
    if (strcmp(node_string(axes, known), known) != 0)
        node_fail(&axes, GP_ERROR_FORMAT, "expected \"%s\"", known);
    read_frame(&frames, frame, &read);
    node_close(&lens);
    node_close(&root);
    result = reader.result;
    reader_close(&reader);
    if (!result)
        *camera = read;
    return result;
}

DepthPlane rgbd_plane(const RgbdCamera *camera, uint32_t width, uint32_t height)
{
    DepthPlane plane = { .left = -(camera->cx + 0.5) / camera->fx,
                         .bottom = (camera->cy + 0.5 - height) / camera->fy,
                         .width = width / camera->fx,
                         .height = height / camera->fy };
    memcpy(plane.eye, camera->eye, sizeof plane.eye);
    memcpy(plane.right, camera->right, sizeof plane.right);
    memcpy(plane.up, camera->up, sizeof plane.up);
    memcpy(plane.forward, camera->forward, sizeof plane.forward);
    return plane;
}

/* --- pictures --------------------------------------------------------------------------------- */

/* A depth as it is stored; 0: nothing. */
static double code_of(const GpImage *image, size_t i)
{
    switch (image->type) {
    case GP_IMAGE_U8:
        return ((const uint8_t *)image->data)[i];
    case GP_IMAGE_U16:
        return ((const uint16_t *)image->data)[i];
    case GP_IMAGE_F16:
        return (double)gp_float_from_half(((const uint16_t *)image->data)[i]);
    default:
        return (double)((const float *)image->data)[i];
    }
}

static GpResult take_depths(const char *path, const GpImage *codes, double unit,
                            DepthPixels *pixels, GpError *error)
{
    for (size_t i = 0; i < (size_t)codes->width * codes->height; i++) {
        const double code = code_of(codes, i);
        if (code < 0)
            return gp_fail(error, GP_ERROR_FORMAT,
                           "%s: pixel (%zu, %zu): expected a depth from 0 on", path,
                           i % codes->width, i / codes->width);
        pixels->depth[i] = code > 0 && isfinite(code) ? (float)(code * unit) : DEPTH_NOTHING;
    }
    return GP_OK;
}

static GpResult make_image(const char *color_path, const Picture *color, const char *depth_path,
                           const GpImage *codes, const RgbdCamera *camera, DepthImage *image,
                           GpError *error)
{
    DepthPixels *pixels = &image->front;
    if (codes->channels != 1)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: %u channels; expected depths alone", depth_path,
                       codes->channels);
    if (codes->width != color->width || codes->height != color->height)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: %ux%u pixels; %s has %ux%u", depth_path,
                       codes->width, codes->height, color_path, color->width, color->height);
    if (depth_pixels_make(codes->width, codes->height, false, pixels))
        return gp_fail(error, GP_ERROR_MEMORY, "%s: out of memory", depth_path);
    image->plane = rgbd_plane(camera, codes->width, codes->height);
    memcpy(pixels->color, color->values, 3 * sizeof(float) * (size_t)codes->width * codes->height);
    const GpResult result = take_depths(depth_path, codes, camera->unit, pixels, error);
    return result ? result : surface_grid_normals(image, 4, &pixels->normal, error);
}

GpResult rgbd_read(const char *color_path, const char *depth_path, const RgbdCamera *camera,
                   DepthImage *image, GpError *error)
{
    Picture color = { .values = NULL };
    GpImage codes = { .data = NULL };
    DepthImage made = { .is_cylinder = false };
    GpResult result = picture_read(color_path, &color, error);
    if (!result)
        result = picture_set_channels(&color, 3, error);
    if (!result)
        result = gp_image_read(depth_path, &codes, error);
    if (!result)
        result = make_image(color_path, &color, depth_path, &codes, camera, &made, error);
    picture_free(&color);
    gp_image_free(&codes);
    if (result)
        depth_pixels_free(&made.front);
    else
        *image = made;
    return result;
}
