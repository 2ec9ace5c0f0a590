#include "apps/depth_images/capture.h"

#include "apps/frame/frame.h"
#include "shaders_c/warp/capture.h"

#include <string.h>

Bounds capture_bounds(const CaptureSource *source)
{
    const GpMesh *mesh = source->mesh;
    return bounds_of(mesh->positions, 3 * sizeof(float), mesh->indices, 3 * mesh->triangle_count);
}

DepthPlane depth_plane_of_camera(const Camera *camera, double aspect)
{
    const CameraAxes axes = camera_axes(camera, aspect);
    DepthPlane plane = { .is_parallel = !(camera->fovy > 0),
                         .left = -axes.half_width,
                         .bottom = -axes.half_height,
                         .width = 2 * axes.half_width,
                         .height = 2 * axes.half_height };
    memcpy(plane.eye, camera->eye, sizeof plane.eye);
    memcpy(plane.right, axes.right, sizeof plane.right);
    memcpy(plane.up, axes.up, sizeof plane.up);
    memcpy(plane.forward, axes.forward, sizeof plane.forward);
    return plane;
}

GpResult capture_colors(const CaptureSource *source, float **colors, GpError *error)
{
    *colors = NULL;
    if (source->mesh->colors || source->waves > 0)
        return GP_OK;
    const size_t count = 4 * (size_t)source->mesh->vertex_count;
    float *white = gp_alloc(count, sizeof *white);
    if (!white)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for %zu colours", count / 4);
    for (size_t i = 0; i < count; i++)
        white[i] = 1;
    *colors = white;
    return GP_OK;
}

/* --- drawing ---------------------------------------------------------------------------------- */

/* Of (right, up, forward, 1). Depths between near and far are 0 to 1 of the depth buffer. */
static void plane_to_clip(const DepthPlane *plane, double near, double far, float clip[4][4])
{
    double m[4][4] = { { 0 } };
    const int spread = plane->is_parallel ? 3 : 2; /* what w is: 1, or the depth */
    m[0][0] = 2 / plane->width;
    m[0][spread] = -(2 * plane->left / plane->width + 1);
    m[1][1] = 2 / plane->height;
    m[1][spread] = -(2 * plane->bottom / plane->height + 1);
    m[2][2] = (plane->is_parallel ? 1 : far) / (far - near);
    m[2][3] = -near * m[2][2];
    m[3][spread] = 1;
    matrix_round(m, clip);
}

static CaptureUniforms uniforms_of(const CaptureView *view, double waves)
{
    CaptureUniforms uniforms = { .waves = (float)waves };
    const double *const axes[3] = { view->plane.right, view->plane.up, view->plane.forward };
    for (int k = 0; k < 3; k++) {
        uniforms.eye[0][k] = (float)view->plane.eye[k];
        uniforms.eye[1][k] = (float)(view->plane.eye[k] - (double)uniforms.eye[0][k]);
        for (int j = 0; j < 3; j++)
            uniforms.axes[j][k] = (float)axes[j][k];
    }
    plane_to_clip(&view->plane, view->near, view->far, uniforms.eye_to_clip);
    return uniforms;
}

/* What faces the eye lies in the nearer half of the depth buffer, backs in the other one. */
static void add_behind(Frame *frame, const CaptureView *view, const CaptureUniforms *uniforms,
                       const GpSurface *front)
{
    for (int backs = 0; backs < 2; backs++) {
        GpDraw *draw = frame_draw_copied(
            frame, uniforms->waves > 0 ? &capture_waves_behind_program : &capture_behind_program,
            uniforms, &view->geometry);
        draw->viewport = view->viewport;
        draw->viewport.min_depth = backs ? 0.5f : 0;
        draw->viewport.max_depth = backs ? 1 : 0.5f;
        draw->state.raster.cull = backs ? GP_CULL_CCW : GP_CULL_CW;
        draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
        draw->textures[0].surface = front;
    }
}

/* A pass into two float targets. */
static GpPass *add_pass(Frame *frame, const char *name, uint32_t width, uint32_t height)
{
    static const float nothing[4] = { 0, 0, 0, DEPTH_NOTHING };
    GpSurface *color = frame_surface(frame, GP_A32B32G32R32F, width, height, 1);
    GpSurface *depth = frame_surface(frame, GP_D32F, width, height, 1);
    GpPass *pass = frame_pass(frame, name, color, depth, nothing);
    pass->color[1].surface = frame_surface(frame, GP_A32B32G32R32F, width, height, 1);
    pass->color[1].clear = true;
    return pass;
}

static GpResult take_pixels(const GpPass *pass, DepthPixels *pixels)
{
    const GpSurface *color = pass->color[0].surface, *normal = pass->color[1].surface;
    GpResult result = depth_pixels_make(color->width, color->height, true, pixels);
    for (uint32_t y = 0; result == GP_OK && y < color->height; y++) {
        const float *c = (const float *)(const void *)gp_surface_texel(&color->level[0], 16, 0, y);
        const float *n = (const float *)(const void *)gp_surface_texel(&normal->level[0], 16, 0, y);
        for (size_t x = 0, i = (size_t)y * color->width; x < color->width; x++, i++) {
            pixels->depth[i] = c[4 * x + 3] > 0 ? c[4 * x + 3] : 0;
            memcpy(pixels->color + 3 * i, c + 4 * x, 3 * sizeof *c);
            memcpy(pixels->normal + 3 * i, n + 4 * x, 3 * sizeof *n);
        }
    }
    return result;
}

GpResult capture_views(GpDevice *device, const CaptureView *views, uint32_t count, double waves,
                       uint32_t width, uint32_t height, DepthPixels *front, DepthPixels *behind,
                       GpError *error)
{
    if (width == 0 || height == 0 || width > GP_MAX_SIZE || height > GP_MAX_SIZE)
        return gp_fail(error, GP_ERROR_INVALID, "a depth image of %ux%u pixels; sides are 1 to %d",
                       width, height, GP_MAX_SIZE);
    Frame frame = { 0 };
    const GpSurface *first = add_pass(&frame, "front", width, height)->color[0].surface;
    frame_reserve(&frame, (behind ? 3 : 1) * count);
    for (uint32_t i = 0; i < count; i++) {
        const CaptureUniforms uniforms = uniforms_of(&views[i], waves);
        GpDraw *draw =
            frame_draw_copied(&frame, waves > 0 ? &capture_waves_program : &capture_program,
                              &uniforms, &views[i].geometry);
        draw->viewport = views[i].viewport;
        draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    }
    if (behind)
        add_pass(&frame, "behind", width, height);
    for (uint32_t i = 0; behind && i < count; i++) {
        const CaptureUniforms uniforms = uniforms_of(&views[i], waves);
        add_behind(&frame, &views[i], &uniforms, first);
    }
    DepthPixels taken[2] = { { 0 } };
    GpResult result = frame_result(&frame, error);
    if (result == GP_OK)
        result = gp_device_run(device, &frame.list, error);
    for (int layer = 0; result == GP_OK && layer < (behind ? 2 : 1); layer++)
        if (take_pixels(&frame.list.passes[layer], &taken[layer]) != GP_OK)
            result = gp_fail(error, GP_ERROR_MEMORY, "no memory for %ux%u pixels", width, height);
    frame_free(&frame);
    if (result != GP_OK) {
        depth_pixels_free(&taken[0]);
        depth_pixels_free(&taken[1]);
        return result;
    }
    *front = taken[0];
    if (behind)
        *behind = taken[1];
    return GP_OK;
}

/* --- planar images ---------------------------------------------------------------------------- */

/* Depths of what is captured: those of the box's corners, a little wider than they are, so that
 * what is rounded stays inside. */
static void depth_range(const CaptureShot *shot, const Bounds *bounds, double *near, double *far)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int corner = 0; corner < 8; corner++) {
        double off[3];
        for (int k = 0; k < 3; k++)
            off[k] = (corner >> k & 1 ? bounds->high : bounds->low)[k] - shot->plane.eye[k];
        const double depth = vector_dot(off, shot->plane.forward);
        low = depth < low ? depth : low;
        high = depth > high ? depth : high;
    }
    const double margin = 1e-4 * (high - low) + 1e-6 * fmax(fabs(low), fabs(high));
    high = high + margin;
    low = low - margin;
    if (shot->far > 0) {
        low = fmax(low, shot->near);
        high = fmin(high, shot->far);
    }
    *far = high;
    *near = fmax(low, shot->plane.is_parallel ? 0 : 0x1p-14 * high);
}

GpResult capture_planar(GpDevice *device, const CaptureSource *source, const CaptureShot *shot,
                        DepthImage *image, GpError *error)
{
    const GpMesh *mesh = source->mesh;
    const Bounds bounds = capture_bounds(source);
    float *colors = NULL;
    GpResult result = capture_colors(source, &colors, error);
    if (result != GP_OK)
        return result;
    CaptureView view = { .plane = shot->plane };
    view.geometry = (GpGeometry){
        .vertex_count = mesh->vertex_count,
        .indices = mesh->indices,
        .index_count = 3 * mesh->triangle_count,
        .streams = { [GP_POSITION] = { .data = mesh->positions, .components = 3 },
                     [GP_NORMAL] = { .data = mesh->normals, .components = 3 },
                     [GP_COLOR] = { .data = colors ? colors : mesh->colors, .components = 4 } },
    };
    if (source->waves > 0)
        view.geometry.streams[GP_COLOR] = (GpStream){ .data = NULL };
    depth_range(shot, &bounds, &view.near, &view.far);
    const uint32_t seen = view.near < view.far ? 1 : 0; /* else all is behind the eye */
    DepthImage made = { .plane = shot->plane };
    result = capture_views(device, &view, seen, source->waves, shot->width, shot->height,
                           &made.front, shot->behind ? &made.behind : NULL, error);
    gp_free(colors);
    if (result == GP_OK)
        *image = made;
    return result;
}
