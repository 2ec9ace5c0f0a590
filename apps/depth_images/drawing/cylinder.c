#include "apps/depth_images/drawing/cylinder.h"

#include "apps/depth_images/drawing/footprint.h"
#include "apps/depth_images/drawing/light.h"
#include "apps/depth_images/drawing/plane.h"
#include "apps/depth_images/drawing/surface_grid.h"
#include "shaders_c/warp/cylinder.h"

#include <math.h>
#include <string.h>

enum { LARGEST_PICTURE = 2048 }; /* of the plane, pixels a side */

static const double least_beyond = 1e-3; /* the eye from the plane, in radii */

/* --- opening ---------------------------------------------------------------------------------- */

GpResult cylinder_open(const DepthImage *image, CylinderWarp *made, GpError *error)
{
    const uint32_t least = 4; /* columns, and rows, of a coarse image */
    const DepthPixels *pixels = &image->front;
    CylinderWarp opened = { .image = image, .pixel = surface_grid_pixel(image) };
    float *found = NULL;
    if (!image->is_cylinder) {
        const GpResult result = surface_open(image, NULL, &opened.cap, error);
        if (!result)
            *made = opened;
        return result;
    }
    GpResult result = pixels->normal ? GP_OK : surface_grid_normals(image, -1, &found, error);
    if (!result)
        result = depth_textures_open(pixels, pixels->normal ? pixels->normal : found,
                                     &opened.textures, error);
    for (uint32_t i = 0; i < CYLINDER_STEPS && !result; i++) {
        if (i > 0 && (pixels->width >> i < least || pixels->height >> i < least))
            break;
        result = cylinder_strips_open(image, 1u << i, &opened.strips[opened.count++], error);
    }
    gp_free(found);
    if (result)
        cylinder_close(&opened);
    else
        *made = opened;
    return result;
}

void cylinder_close(CylinderWarp *made)
{
    depth_textures_close(&made->textures);
    for (uint32_t i = 0; i < made->count; i++)
        cylinder_strips_close(&made->strips[i]);
    surface_close(&made->cap);
    *made = (CylinderWarp){ .image = NULL };
}

/* --- the eye and the plane -------------------------------------------------------------------- */

/* The plane that touches the cylinder at the eye's azimuth. */
typedef struct TouchingPlane {
    double place[2];     /* of the eye, in the image */
    double turn[2];      /* cosine and sine of its azimuth */
    double away, height; /* of the eye from the axis, and above the centre */
    double low[2],
        high[2];      /* the picture: to the right of the line that touches, and above the centre */
    uint32_t size[2]; /* in pixels */
} TouchingPlane;

/* Along the axis' foot towards the eye, to its right as the eye sees it, and up. */
static void axes_of(const DepthCylinder *cylinder, const TouchingPlane *plane, double towards[3],
                    double right[3])
{
    double aside[3];
    vector_cross(cylinder->axis, cylinder->zero, aside);
    for (int k = 0; k < 3; k++) {
        towards[k] = plane->turn[0] * cylinder->zero[k] + plane->turn[1] * aside[k];
        right[k] = plane->turn[0] * aside[k] - plane->turn[1] * cylinder->zero[k];
    }
}

static void corner_of(const DepthCylinder *cylinder, const TouchingPlane *plane, int corner,
                      double point[3])
{
    double towards[3], right[3];
    axes_of(cylinder, plane, towards, right);
    vector_add_scaled(cylinder->center, cylinder->radius, towards, point);
    vector_add_scaled(point, corner & 1 ? plane->high[0] : plane->low[0], right, point);
    vector_add_scaled(point, corner & 2 ? plane->high[1] : plane->low[1], cylinder->axis, point);
}

static bool find_plane(const DepthImage *image, const WarpView *view, TouchingPlane *plane)
{
    const DepthCylinder *cylinder = &image->cylinder;
    double off[3], aside[3], depth;
    if (!(view->camera.fovy > 0) ||
        !depth_cylinder_place(cylinder, &image->front, view->camera.eye, plane->place, &depth))
        return false;
    vector_subtract(view->camera.eye, cylinder->center, off);
    vector_cross(cylinder->axis, cylinder->zero, aside);
    plane->away = cylinder->radius - depth;
    plane->height = vector_dot(off, cylinder->axis);
    plane->turn[0] = vector_dot(off, cylinder->zero) / plane->away;
    plane->turn[1] = vector_dot(off, aside) / plane->away;
    return plane->away > cylinder->radius * (1 + least_beyond);
}

/* What of the plane the cylinder may be warped to, with a relief on it, which may come to where the
 * eye is nearly. To the sides its silhouette; heights move towards the eye's, the more the farther
 * away, at most on the far side, and away from it where they are nearer than the plane. */
static void find_window(const DepthCylinder *cylinder, const WarpDetail *detail,
                        const WarpView *view, TouchingPlane *plane)
{
    const CameraAxes axes = camera_axes(&view->camera, (double)view->width / view->height);
    const double ahead = plane->away - cylinder->radius, half = cylinder->height / 2;
    const double relief = detail->heights ? fmax(detail->amplitude, 0) : 0;
    const double radius = cylinder->radius + fmin(relief, 0.75 * ahead);
    const double least = ahead / (plane->away + radius), most = ahead / (plane->away - radius);
    const double low = -half - plane->height, high = half - plane->height;
    const bool stands_out = most > 1;
    double nearest = HUGE_VAL;
    plane->high[0] = radius * sqrt(least * most);
    plane->low[0] = -plane->high[0];
    plane->low[1] =
        fmin(stands_out ? plane->height + low * most : -half, plane->height + low * least);
    plane->high[1] =
        fmax(stands_out ? plane->height + high * most : half, plane->height + high * least);
    for (int i = 0; i < 4; i++) {
        double corner[3];
        corner_of(cylinder, plane, i, corner);
        vector_subtract(corner, view->camera.eye, corner);
        nearest = fmin(nearest, vector_dot(corner, axes.forward));
    }
    const double density = view->height / (2 * axes.half_height * fmax(nearest, view->camera.near));
    for (int i = 0; i < 2; i++) {
        const double pixels = ceil((plane->high[i] - plane->low[i]) * density);
        plane->size[i] = (uint32_t)fmin(fmax(pixels, 1), LARGEST_PICTURE);
    }
}

/* From the cylinder's own space, before the turn, to the world. */
static void place_matrix(const DepthCylinder *cylinder, double matrix[4][4])
{
    double aside[3];
    vector_cross(cylinder->axis, cylinder->zero, aside);
    matrix_identity(matrix);
    for (int k = 0; k < 3; k++) {
        matrix[k][0] = cylinder->zero[k];
        matrix[k][1] = cylinder->axis[k];
        matrix[k][2] = aside[k];
        matrix[k][3] = cylinder->center[k];
    }
}

/* --- drawing ---------------------------------------------------------------------------------- */

static const CylinderStrips *strips_for(const CylinderWarp *made, const CylinderSetting *setting,
                                        const WarpView *view)
{
    const DepthCylinder *cylinder = &made->image->cylinder;
    const double half = cylinder->height / 2;
    const double radius = sqrt(cylinder->radius * cylinder->radius + half * half);
    const uint32_t step =
        setting->step ? setting->step : footprint_step(cylinder->center, radius, made->pixel, view);
    const CylinderStrips *strips = made->strips, *last = strips + made->count - 1;
    while (strips < last && strips[1].step <= step)
        strips++;
    return strips;
}

static CylinderUniforms uniforms_of(const CylinderWarp *made, const CylinderSetting *setting,
                                    const WarpView *view)
{
    const DepthCylinder *cylinder = &made->image->cylinder;
    CylinderUniforms uniforms = {
        .radius = (float)cylinder->radius,
        .detail = warp_detail_uniforms(&setting->detail, &made->image->front,
                                       strips_for(made, setting, view)->step),
    };
    double place[4][4], clip[4][4], product[4][4];
    place_matrix(cylinder, place);
    view_to_clip(view, clip);
    matrix_multiply(clip, place, product);
    matrix_round(place, uniforms.to_world);
    matrix_round(product, uniforms.to_clip);
    if (view->light)
        uniforms.light = warp_light_uniforms(view);
    return uniforms;
}

static void set_plane(const TouchingPlane *plane, CylinderUniforms *uniforms)
{
    for (int i = 0; i < 2; i++) {
        const double size = plane->high[i] - plane->low[i];
        uniforms->turn[i] = (float)plane->turn[i];
        uniforms->window[2 * i] = (float)(2 / size);
        uniforms->window[2 * i + 1] = (float)(-(plane->low[i] + plane->high[i]) / size);
    }
    uniforms->eye[0] = (float)plane->away;
    uniforms->eye[1] = (float)plane->height;
}

/* A draw of strips, whose indices are yet to come. */
static GpDraw draw_of(const CylinderWarp *made, const CylinderSetting *setting,
                      const CylinderStrips *strips, const GpProgram *program,
                      const CylinderUniforms *uniforms, Frame *frame)
{
    const GpSampler sampler = { .min = GP_LINEAR,
                                .mag = GP_LINEAR,
                                .mip = strips->step > 1 ? GP_MIP_LINEAR : GP_MIP_NONE,
                                .address_v = GP_CLAMP };
    const uint32_t stride = sizeof *strips->vertices;
    GpDraw draw = { .program = program,
                    .uniforms = frame_copy(frame, uniforms, sizeof *uniforms),
                    .textures = { { made->textures.color, sampler },
                                  { made->textures.normal, sampler } } };
    draw.state.raster.cull = GP_CULL_CW;
    draw.textures[WARP_DETAIL_SLOT] = warp_detail_texture(&setting->detail);
    draw.geometry.vertex_count = (strips->strips + 1) * strips->rows;
    draw.geometry.streams[GP_POSITION] =
        (GpStream){ strips->vertices->turn, stride, 3, GP_FLOAT32 };
    draw.geometry.streams[GP_TEXCOORD0] =
        (GpStream){ strips->vertices->texel, stride, 3, GP_FLOAT32 };
    return draw;
}

/* The picture on its rectangle. */
static void add_rectangle(const CylinderWarp *made, const WarpView *view,
                          const TouchingPlane *plane, GpSurface *const surfaces[2], bool has_depth,
                          Frame *frame)
{
    static const uint16_t indices[6] = { 0, 1, 2, 2, 1, 3 };
    const GpSampler linear = { .min = GP_LINEAR,
                               .mag = GP_LINEAR,
                               .address_u = GP_CLAMP,
                               .address_v = GP_CLAMP },
                    nearest = { .address_u = GP_CLAMP, .address_v = GP_CLAMP };
    CylinderPlaneUniforms uniforms;
    double clip[4][4], eye_depth = 0;
    float(*corners)[5] = frame_alloc(frame, 4, sizeof *corners);
    if (!corners)
        return;
    for (int i = 0; i < 4; i++) {
        double corner[3];
        corner_of(&made->image->cylinder, plane, i, corner);
        for (int k = 0; k < 3; k++)
            corners[i][k] = (float)corner[k];
        corners[i][3] = (float)(i & 1);
        corners[i][4] = (float)(i & 2 ? 0 : 1);
    }
    view_to_clip(view, clip);
    matrix_round(clip, uniforms.mvp);
    eye_depth = vector_dot(clip[2], view->camera.eye) + clip[2][3];
    uniforms.eye_depth = (float)eye_depth;
    const GpGeometry geometry = {
        .vertex_count = 4,
        .indices16 = indices,
        .index_count = 6,
        .streams = { [GP_POSITION] = { corners[0], sizeof *corners, 3, GP_FLOAT32 },
                     [GP_TEXCOORD0] = { corners[0] + 3, sizeof *corners, 2, GP_FLOAT32 } },
    };
    GpDraw *draw = frame_draw_copied(frame, &cylinder_plane_program, &uniforms, &geometry);
    draw->textures[0] = (GpTexture){ surfaces[0], linear };
    draw->textures[1] = (GpTexture){ surfaces[1], nearest };
    if (has_depth)
        draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
}

static void add_warped(const CylinderWarp *made, const CylinderSetting *setting,
                       const WarpView *view, const WarpTarget *target, TouchingPlane *plane,
                       Frame *frame)
{
    static const GpProgram *const programs[2][2] = {
        { &cylinder_program, &cylinder_lit_program },
        { &cylinder_detail_program, &cylinder_detail_lit_program },
    };
    static const float none[4] = { 0 };
    const CylinderStrips *strips = strips_for(made, setting, view);
    CylinderUniforms uniforms = uniforms_of(made, setting, view);
    find_window(&made->image->cylinder, &setting->detail, view, plane);
    set_plane(plane, &uniforms);
    GpSurface *const surfaces[2] = {
        frame_surface(frame, GP_A8R8G8B8, plane->size[0], plane->size[1], 1),
        frame_surface(frame, GP_R32F, plane->size[0], plane->size[1], 1),
    };
    GpPass *pass = frame_pass(frame, "cylinder-warp", surfaces[0], NULL, none);
    pass->color[1] = (GpColorTarget){ .surface = surfaces[1], .clear = true };
    const GpDraw draw =
        draw_of(made, setting, strips,
                programs[setting->detail.heights != NULL][view->light != NULL], &uniforms, frame);
    const double *eye = setting->detail.heights ? NULL : view->camera.eye; /* relief leans */
    cylinder_strips_draw(strips, &draw, eye, plane->place, frame);
    pass = frame_pass(frame, setting->name ? setting->name : "cylinder", target->color,
                      target->depth, none);
    pass->color[0].clear = pass->depth.clear_depth = false;
    add_rectangle(made, view, plane, surfaces, target->depth != NULL, frame);
}

static void add_straight(const CylinderWarp *made, const CylinderSetting *setting,
                         const WarpView *view, const WarpTarget *target, Frame *frame)
{
    static const GpProgram *const programs[2][2] = {
        { &cylinder_straight_program, &cylinder_straight_lit_program },
        { &cylinder_straight_detail_program, &cylinder_straight_detail_lit_program },
    };
    static const float none[4] = { 0 };
    const CylinderStrips *strips = strips_for(made, setting, view);
    const CylinderUniforms uniforms = uniforms_of(made, setting, view);
    GpSurface *depth =
        target->depth ? target->depth : frame_surface(frame, GP_D32F, view->width, view->height, 1);
    GpPass *pass =
        frame_pass(frame, setting->name ? setting->name : "cylinder", target->color, depth, none);
    pass->color[0].clear = false;
    pass->depth.clear_depth = !target->depth;
    GpDraw draw =
        draw_of(made, setting, strips,
                programs[setting->detail.heights != NULL][view->light != NULL], &uniforms, frame);
    draw.state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    draw.geometry.indices = strips->falling;
    draw.geometry.index_count = strips->first[strips->strips * strips->rows - 1];
    if (draw.geometry.index_count)
        *frame_draw(frame, draw.program, draw.uniforms, &draw.geometry) = draw;
}

/* Whether the eye is where a cap was taken from. */
static bool is_before(const DepthPlane *plane, const WarpView *view)
{
    double way[3];
    vector_subtract(view->camera.eye, view->camera.fovy > 0 ? plane->eye : view->camera.at, way);
    return vector_dot(way, plane->forward) < 0;
}

GpResult cylinder_add(const CylinderWarp *made, const CylinderSetting *setting,
                      const WarpView *view, const WarpTarget *target, Frame *frame, GpError *error)
{
    TouchingPlane plane;
    if (!made->image->is_cylinder) {
        const SurfaceSetting cap = { .step = setting->step, .name = setting->name };
        return is_before(&made->image->plane, view)
                   ? surface_add(&made->cap, &cap, view, target, frame, error)
                   : GP_OK;
    }
    if (find_plane(made->image, view, &plane))
        add_warped(made, setting, view, target, &plane, frame);
    else
        add_straight(made, setting, view, target, frame);
    return frame_result(frame, error);
}

const char *cylinder_warning(const DepthImage *image, const WarpView *view)
{
    TouchingPlane plane;
    if (!image->is_cylinder || find_plane(image, view, &plane))
        return NULL;
    return view->camera.fovy > 0
               ? "the eye is inside the cylinder, or above or below it, where no plane touches it "
                 "before the eye: the image is drawn straight"
               : "parallel rays have no eye to warp to: the image is drawn straight";
}
