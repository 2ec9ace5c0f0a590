#include "apps/depth_images/drawing/planar.h"

#include "apps/depth_images/drawing/grid.h"
#include "apps/depth_images/drawing/light.h"
#include "apps/depth_images/drawing/order.h"
#include "apps/depth_images/drawing/plane.h"
#include "apps/depth_images/drawing/surface_grid.h"
#include "shaders_c/warp/cylinder.h"
#include "shaders_c/warp/planar.h"

#include <string.h>

enum { USUAL_ENTRIES = 4096, LARGEST_PICTURE = 2048 /* pixels a side */ };

/* --- what stays ------------------------------------------------------------------------------- */

GpResult planar_open(const DepthImage *image, Planar *made, GpError *error)
{
    static const EdgeSetting edges[2] = { { .rule = EDGES_NONE }, { .rule = EDGES_SLOPES } };
    Planar planar = { .image = image, .pixel = surface_grid_pixel(image) };
    if (image->is_cylinder)
        return gp_fail(error, GP_ERROR_INVALID, "a cylinder is no planar depth image");
    depth_extent(&image->front, &planar.extent);
    plane_ball(image, planar.center, &planar.radius);
    GpResult result =
        depth_textures_open(&image->front, image->front.normal, &planar.textures, error);
    for (int i = 0; i < 2 && !result; i++)
        if (depth_lattice_make(&image->plane, &image->front, &edges[i], &planar.lattices[i]))
            result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    if (result)
        planar_close(&planar);
    else
        *made = planar;
    return result;
}

void planar_close(Planar *made)
{
    depth_textures_close(&made->textures);
    for (int i = 0; i < 2; i++)
        depth_lattice_free(&made->lattices[i]);
    *made = (Planar){ .image = NULL };
}

/* --- the eye ---------------------------------------------------------------------------------- */

/* The eye before the image, in the image's axes, and which depths it can be shown. */
typedef struct PlanarEye {
    double eye[4];   /* w 0: where parallel rays come from */
    double looks;    /* along the image's forward */
    double range[2]; /* of depths that are warped */
    double plane;    /* depth of the plane */
    double unit;     /* the eye's w, or so large that k / unit is within -1/2 .. 1/2 */
    bool is_along;   /* parallel rays along the plane: nothing can be warped */
    bool is_among;   /* on the plane, or beyond, and not yet behind it all */
} PlanarEye;

static const double nearest_share = 1e-3; /* of the range of depths: what is too near to the eye */

/* Depths in front of an eye among them; the plane goes to their middle. */
static void stand_among(PlanarEye *eye)
{
    const double margin = nearest_share * fmax(eye->range[1] - eye->range[0], 1e-30);
    const bool forward = eye->looks >= 0;
    if (forward)
        eye->range[0] = fmax(eye->range[0], eye->eye[2] + margin);
    else
        eye->range[1] = fmin(eye->range[1], eye->eye[2] - margin);
    eye->plane = (eye->range[0] + eye->range[1]) / 2;
}

static void find_plane(const double depths[2], bool stays, PlanarEye *eye)
{
    const double away = nearest_share * (depths[1] - depths[0]), z = eye->eye[2];
    const double rounding = 1e-6 * fmax(fabs(depths[0]), fabs(depths[1])); /* of flat depths */
    eye->range[0] = depths[0] - rounding;
    eye->range[1] = depths[1] + rounding;
    eye->plane = depths[0];
    eye->unit = 1;
    if (eye->eye[3] == 0) {
        eye->unit = fmax(2 * (depths[1] - depths[0]) / fabs(z), 1e-30);
        eye->is_along = fabs(z) < nearest_share;
        return;
    }
    eye->is_among = z >= depths[0] - away && z <= depths[1] + away;
    if (!stays && eye->is_among)
        stand_among(eye);
}

static PlanarEye find_eye(const DepthPlane *plane, const DepthExtent *extent, const WarpView *view,
                          bool stays)
{
    const CameraAxes axes = camera_axes(&view->camera, 1);
    PlanarEye eye = { .looks = vector_dot(axes.forward, plane->forward) };
    plane_eye(plane, view, eye.eye);
    find_plane((const double[2]){ extent->low[2], extent->high[2] }, stays, &eye);
    return eye;
}

static double k_of(const PlanarEye *eye, double depth)
{
    const double under = eye->eye[2] - eye->eye[3] * depth;
    const double k = (eye->plane - depth) / under;
    return isfinite(k) ? fmin(fmax(k, -1e6), 1e6) : 0;
}

const char *planar_warning(const DepthImage *image, const WarpView *view)
{
    DepthExtent extent;
    if (image->is_cylinder || !depth_extent(&image->front, &extent))
        return NULL;
    const PlanarEye eye = find_eye(&image->plane, &extent, view, false);
    if (eye.is_along)
        return "rays along the plane of a planar depth image warp nothing";
    if (eye.is_among)
        return "the eye is on the plane of a planar depth image, or beyond: only what is in front "
               "of the eye is warped";
    const char *warning = plane_warning(&image->plane, &extent, view);
    return warning ? warning : depth_level_warning(&image->plane, &image->front);
}

/* --- the picture in the plane ----------------------------------------------------------------- */

typedef struct Window {
    double low[2], high[2]; /* in the plane, along right and up */
    uint32_t size[2];       /* pixels */
} Window;

static void window_add(Window *window, double x, double y)
{
    const double at[2] = { x, y };
    for (int i = 0; i < 2; i++) {
        window->low[i] = fmin(window->low[i], at[i]);
        window->high[i] = fmax(window->high[i], at[i]);
    }
}

static const Window empty_window = { { HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL }, { 0, 0 } };

/* All to which the corners of what the picture shows are warped at the least and the greatest
 * depth: what is between them goes between these, since k is monotonous. */
static Window find_reach(const Planar *made, const PlanarEye *eye)
{
    const DepthPlane *plane = &made->image->plane;
    const DepthPixels *pixels = &made->image->front;
    const DepthExtent *extent = &made->extent;
    Window window = empty_window;
    for (int i = 0; i < 8; i++) {
        const double depth = eye->range[i >> 2], k = k_of(eye, depth);
        const double s = (plane->is_parallel ? 1 : depth) * (1 - eye->eye[3] * k);
        const double x = (i & 1 ? extent->high[0] : extent->low[0]) / pixels->width,
                     y = (i & 2 ? extent->high[1] : extent->low[1]) / pixels->height;
        window_add(&window, s * (plane->left + x * plane->width) + k * eye->eye[0],
                   s * (plane->bottom + (1 - y) * plane->height) + k * eye->eye[1]);
    }
    return window;
}

/* What of the plane the view's corners see; false: there is no end of it. */
static bool find_seen(const DepthPlane *plane, const PlanarEye *eye, const WarpView *view,
                      Window *window)
{
    const CameraAxes axes = camera_axes(&view->camera, (double)view->width / view->height);
    const double *image_axes[3] = { plane->right, plane->up, plane->forward };
    *window = empty_window;
    for (int i = 0; i < 4; i++) {
        double from[3], way[3], aside[3], at[3], along[3];
        for (int k = 0; k < 3; k++)
            aside[k] = (i & 1 ? 1 : -1) * axes.half_width * axes.right[k] +
                       (i & 2 ? 1 : -1) * axes.half_height * axes.up[k];
        memcpy(from, view->camera.eye, sizeof from);
        memcpy(way, axes.forward, sizeof way);
        vector_add_scaled(eye->eye[3] > 0 ? way : from, 1, aside, eye->eye[3] > 0 ? way : from);
        vector_subtract(from, plane->eye, from);
        for (int k = 0; k < 3; k++) {
            at[k] = vector_dot(from, image_axes[k]);
            along[k] = vector_dot(way, image_axes[k]);
        }
        const double t = (eye->plane - at[2]) / along[2];
        if (!isfinite(t) || (eye->eye[3] > 0 && t <= 0))
            return false;
        window_add(window, at[0] + t * along[0], at[1] + t * along[1]);
    }
    return true;
}

static void corner_of(const DepthPlane *plane, const PlanarEye *eye, const Window *window,
                      int corner, double point[3])
{
    memcpy(point, plane->eye, 3 * sizeof *point);
    vector_add_scaled(point, eye->plane, plane->forward, point);
    vector_add_scaled(point, corner & 1 ? window->high[0] : window->low[0], plane->right, point);
    vector_add_scaled(point, corner & 2 ? window->high[1] : window->low[1], plane->up, point);
}

/* As many pixels as the view has where the window is nearest. returns false: nothing of it is
 * seen */
static bool find_window(const Planar *made, const PlanarEye *eye, const WarpView *view,
                        Window *window)
{
    const DepthPlane *plane = &made->image->plane;
    const CameraAxes axes = camera_axes(&view->camera, (double)view->width / view->height);
    double nearest = HUGE_VAL;
    Window seen;
    *window = find_reach(made, eye);
    if (find_seen(plane, eye, view, &seen))
        for (int i = 0; i < 2; i++) {
            window->low[i] = fmax(window->low[i], seen.low[i]);
            window->high[i] = fmin(window->high[i], seen.high[i]);
        }
    if (!(window->low[0] < window->high[0] && window->low[1] < window->high[1]))
        return false;
    for (int i = 0; i < 4; i++) {
        double off[3];
        corner_of(plane, eye, window, i, off);
        vector_subtract(off, view->camera.eye, off);
        nearest = fmin(nearest, vector_dot(off, axes.forward));
    }
    nearest = eye->eye[3] > 0 ? fmax(nearest, view->camera.near) : 1;
    for (int i = 0; i < 2; i++) {
        const double pixels =
            (window->high[i] - window->low[i]) * view->height / (2 * axes.half_height * nearest);
        window->size[i] = (uint32_t)fmin(fmax(ceil(pixels), 1), LARGEST_PICTURE);
    }
    return true;
}

/* --- a frame ---------------------------------------------------------------------------------- */

/* k of depths from the first of the range to the last. */
static GpSurface *make_table(const PlanarEye *eye, const double range[2], uint32_t entries,
                             Frame *frame)
{
    GpSurface *table = frame_surface(frame, GP_R32F, entries, 1, 1);
    float *texels = (float *)(void *)table->level[0].texels;
    for (uint32_t i = 0; i < entries && texels; i++)
        texels[i] = (float)k_of(eye, range[0] + (range[1] - range[0]) * i / (entries - 1));
    return table;
}

static PlanarUniforms find_uniforms(const Planar *made, const PlanarSetting *setting,
                                    const PlanarEye *eye, const Window *window,
                                    const double range[2], uint32_t entries, uint32_t step,
                                    const WarpView *view)
{
    const DepthPlane *plane = &made->image->plane;
    const bool is_parallel = plane->is_parallel;
    const double per = range[1] > range[0] ? (entries - 1) / (range[1] - range[0]) : 0;
    PlanarUniforms uniforms = {
        .spread = { is_parallel ? 0 : 1, is_parallel ? 1 : 0 },
        .table = { (float)(per / entries), (float)((0.5 - range[0] * per) / entries) },
        .eye_w = (float)eye->eye[3],
        .per_k = (float)(1 / eye->unit),
        .detail = warp_detail_uniforms(&setting->detail, &made->image->front, step),
    };
    const double first[2] = { plane->left, plane->bottom + plane->height };
    const double pixel[2] = { plane->width / made->image->front.width,
                              -plane->height / made->image->front.height };
    for (int i = 0; i < 2; i++) {
        const double half = (window->high[i] - window->low[i]) / 2;
        uniforms.window[i][i] = (float)(pixel[i] / half);
        uniforms.window[i][2] = (float)(first[i] / half);
        uniforms.window[i][3] = (float)(eye->eye[i] / half);
        uniforms.shift[i] = (float)(-(window->low[i] + window->high[i]) / 2 / half);
    }
    double to_world[4][4];
    float world[4][4];
    plane_to_world(plane, &made->image->front, to_world);
    matrix_round(to_world, world);
    memcpy(uniforms.to_world, world, sizeof uniforms.to_world);
    if (view->light)
        uniforms.light = warp_light_uniforms(view);
    return uniforms;
}

static GridVertex vertex_of(const DepthLattice *lattice, uint32_t i)
{
    const double x = depth_lattice_place(lattice, 0, i % lattice->width),
                 y = depth_lattice_place(lattice, 1, i / lattice->width);
    const double depth = depth_flat(lattice->is_parallel, (double)lattice->flat[i]);
    return (GridVertex){ (float)x, (float)y, (float)depth, (float)(x / lattice->image[0]),
                         (float)(y / lattice->image[1]) };
}

/* Keeps only vertices that are used, in the lattice's order.
 * in/out indices: from numbers of the lattice to numbers of those
 * returns NULL: no memory */
static GridVertex *find_vertices(const DepthLattice *lattice, uint32_t *indices, uint32_t count,
                                 uint32_t *used, Frame *frame)
{
    const uint32_t all = lattice->width * lattice->height;
    uint32_t *number = frame_alloc(frame, all, sizeof *number);
    uint32_t vertices = 0;
    for (uint32_t i = 0; i < count && number; i++)
        number[indices[i]] = 1;
    for (uint32_t i = 0; i < all && number; i++)
        vertices += number[i];
    GridVertex *vertex = frame_alloc(frame, vertices, sizeof *vertex);
    *used = 0;
    for (uint32_t i = 0; i < all && vertex; i++) {
        if (!number[i])
            continue;
        vertex[*used] = vertex_of(lattice, i);
        number[i] = (*used)++;
    }
    for (uint32_t i = 0; i < count && vertex; i++)
        indices[i] = number[indices[i]];
    return vertex;
}

/* The lattice's cells in the order for the eye; none where memory is short. */
static GpGeometry find_geometry(const Planar *made, const PlanarEye *eye,
                                const DepthLattice *lattice, Frame *frame)
{
    const WarpOrder order = warp_order(&made->image->plane, &made->image->front, eye->eye);
    uint32_t *indices =
        frame_alloc(frame, (size_t)lattice->width * lattice->height, 6 * sizeof *indices);
    const uint32_t count = indices ? warp_order_cells(&order, lattice, eye->range, indices) : 0,
                   stride = sizeof(GridVertex);
    uint32_t used;
    const GridVertex *vertices = find_vertices(lattice, indices, count, &used, frame);
    if (!vertices)
        return (GpGeometry){ .vertex_count = 0 };
    return (GpGeometry){ .vertex_count = used,
                         .indices = indices,
                         .index_count = count,
                         .streams = { [GP_POSITION] = { &vertices->x, stride, 3, GP_FLOAT32 },
                                      [GP_TEXCOORD0] = { &vertices->u, stride, 2, GP_FLOAT32 } } };
}

static const float nothing[4] = { 0 };

/* Pass 1: into a picture of colours and one of nearness. */
static void add_warp(const Planar *made, const PlanarSetting *setting, const WarpView *view,
                     const PlanarUniforms *uniforms, const GpGeometry *geometry, bool is_far,
                     GpSurface *table, GpSurface *picture[2], Frame *frame)
{
    static const GpProgram *const programs[2][2] = { { &planar_program, &planar_lit_program },
                                                     { &planar_detail_program,
                                                       &planar_detail_lit_program } };
    const GpSampler linear = { .min = GP_LINEAR,
                               .mag = GP_LINEAR,
                               .mip = is_far ? GP_MIP_LINEAR : GP_MIP_NONE,
                               .address_u = GP_CLAMP,
                               .address_v = GP_CLAMP };
    const bool has_detail = setting->detail.heights, is_lit = view->light && made->textures.normal;
    GpPass *pass = frame_pass(frame, "planar-warp", picture[0], NULL, nothing);
    pass->color[1] = (GpColorTarget){ .surface = picture[1], .clear = true };
    GpDraw *draw = frame_draw_copied(frame, programs[has_detail][is_lit], uniforms, geometry);
    draw->textures[0] = (GpTexture){ made->textures.color, linear };
    if (is_lit)
        draw->textures[1] = (GpTexture){ made->textures.normal, linear };
    if (has_detail)
        draw->textures[WARP_DETAIL_SLOT] = warp_detail_texture(&setting->detail);
    draw->textures[PLANAR_TABLE_SLOT] =
        (GpTexture){ table, { .address_u = GP_CLAMP, .address_v = GP_CLAMP } };
}

/* Pass 2: the picture on its rectangle. */
static void add_shown(const Planar *made, const PlanarSetting *setting, const WarpView *view,
                      const PlanarEye *eye, const Window *window, GpSurface *picture[2],
                      const WarpTarget *target, Frame *frame)
{
    static const uint32_t corners[6] = { 0, 1, 2, 1, 3, 2 };
    static const GpSampler linear = { .min = GP_LINEAR,
                                      .mag = GP_LINEAR,
                                      .address_u = GP_CLAMP,
                                      .address_v = GP_CLAMP },
                           points = { .address_u = GP_CLAMP, .address_v = GP_CLAMP };
    const Camera *camera = &view->camera;
    const double span = camera->far - camera->near;
    CylinderPlaneUniforms uniforms = {
        .eye_depth =
            (float)(eye->unit * (camera->fovy > 0 ? -camera->near * camera->far / span : -1 / span))
    };
    float(*vertices)[5] = frame_alloc(frame, 4, sizeof *vertices);
    camera_matrix(camera, (double)view->width / view->height, uniforms.mvp);
    for (int i = 0; i < 4 && vertices; i++) {
        double point[3];
        corner_of(&made->image->plane, eye, window, i, point);
        for (int k = 0; k < 3; k++)
            vertices[i][k] = (float)point[k];
        vertices[i][3] = (float)(i & 1);
        vertices[i][4] = (float)(i < 2);
    }
    const uint32_t stride = sizeof *vertices;
    const GpGeometry geometry = { .vertex_count = 4,
                                  .indices = corners,
                                  .index_count = vertices ? GP_COUNT(corners) : 0,
                                  .streams = { [GP_POSITION] = { vertices, stride, 3, GP_FLOAT32 },
                                               [GP_TEXCOORD0] = { vertices ? &vertices[0][3] : NULL,
                                                                  stride, 2, GP_FLOAT32 } } };
    GpPass *pass = frame_pass(frame, setting->name ? setting->name : "planar", target->color,
                              target->depth, nothing);
    pass->color[0].clear = false;
    pass->depth.clear_depth = false;
    GpDraw *draw = frame_draw_copied(frame, &cylinder_plane_program, &uniforms, &geometry);
    draw->textures[0] = (GpTexture){ picture[0], linear };
    draw->textures[1] = (GpTexture){ picture[1], points };
    if (target->depth)
        draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
}

/* What is shown may be nearer by a relief, or farther. */
static DepthExtent with_detail(DepthExtent extent, const WarpDetail *detail)
{
    if (detail->heights) {
        extent.low[2] -= fmax(detail->amplitude, 0);
        extent.high[2] -= fmin(detail->amplitude, 0);
    }
    return extent;
}

GpResult planar_add(const Planar *made, const PlanarSetting *setting, const WarpView *view,
                    const WarpTarget *target, Frame *frame, GpError *error)
{
    const DepthImage *image = made->image;
    const uint32_t entries = setting->entries ? setting->entries : USUAL_ENTRIES;
    const uint32_t footprint = plane_step(made->center, made->radius, made->pixel, view);
    const uint32_t step = setting->step ? setting->step : footprint;
    const DepthExtent extent = with_detail(made->extent, &setting->detail);
    const PlanarEye eye = find_eye(&image->plane, &extent, view, setting->stays);
    const double depths[2] = { extent.low[2], extent.high[2] };
    const DepthLattice *pixels = &made->lattices[setting->is_cut];
    DepthLattice thin = { .flat = NULL };
    Window window;
    if (!(eye.range[0] <= eye.range[1]) || eye.is_along || !find_window(made, &eye, view, &window))
        return frame_result(frame, error);
    if (step > 1 && depth_lattice_thin(pixels, step, &thin))
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    const GpGeometry geometry = find_geometry(made, &eye, step > 1 ? &thin : pixels, frame);
    depth_lattice_free(&thin);
    if (!geometry.index_count)
        return frame_result(frame, error);
    GpSurface *picture[2] = { frame_surface(frame, GP_A8R8G8B8, window.size[0], window.size[1], 1),
                              frame_surface(frame, GP_R32F, window.size[0], window.size[1], 1) };
    const PlanarUniforms uniforms =
        find_uniforms(made, setting, &eye, &window, depths, entries, step, view);
    add_warp(made, setting, view, &uniforms, &geometry, footprint > 1,
             make_table(&eye, depths, entries, frame), picture, frame);
    add_shown(made, setting, view, &eye, &window, picture, target, frame);
    return frame_result(frame, error);
}
