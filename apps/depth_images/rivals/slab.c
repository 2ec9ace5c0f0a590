#include "apps/depth_images/rivals/slab.h"

#include "apps/base/reach.h"
#include "apps/depth_images/drawing/light.h"
#include "apps/depth_images/drawing/surface_grid.h"

#include <string.h>

static const double usual_cut = 4; /* of normals that are found: as surfaces have it */

/* --- the box ---------------------------------------------------------------------------------- */

static bool shows(bool is_parallel, float depth)
{
    return isfinite(depth) && (is_parallel || depth > 0);
}

/* What is linear on planes. */
static double flat_of(bool is_parallel, double depth)
{
    return is_parallel ? depth : 1 / depth;
}

/* Sides of the pixels that show something: left, top, right, bottom; and their depths. */
static bool find_extent(const DepthPlane *plane, const DepthPixels *pixels, uint32_t rect[4],
                        double depths[2])
{
    rect[0] = rect[1] = UINT32_MAX;
    rect[2] = rect[3] = 0;
    depths[0] = HUGE_VAL;
    depths[1] = 0;
    for (uint32_t y = 0; y < pixels->height; y++)
        for (uint32_t x = 0; x < pixels->width; x++) {
            const float depth = pixels->depth[(size_t)y * pixels->width + x];
            if (!shows(plane->is_parallel, depth))
                continue;
            rect[0] = x < rect[0] ? x : rect[0];
            rect[1] = y < rect[1] ? y : rect[1];
            rect[2] = x >= rect[2] ? x + 1 : rect[2];
            rect[3] = y + 1;
            depths[0] = fmin(depths[0], (double)depth);
            depths[1] = fmax(depths[1], (double)depth);
        }
    return rect[2] > 0;
}

/* From the world to the box, whose z goes from low to high. */
static void find_matrix(const DepthPlane *plane, DepthSlab *slab)
{
    const double flat = flat_of(plane->is_parallel, slab->low);
    const double per_z = 1 / (flat_of(plane->is_parallel, slab->high) - flat);
    double eye[4][4] = { { 0 } }; /* right, up, forward, 1 */
    for (int k = 0; k < 3; k++) {
        const double *axis = k == 0 ? plane->right : k == 1 ? plane->up : plane->forward;
        for (int i = 0; i < 3; i++)
            eye[k][i] = axis[i];
        eye[k][3] = -vector_dot(axis, plane->eye);
    }
    eye[3][3] = 1;
    const int spread = plane->is_parallel ? 3 : 2, depth = plane->is_parallel ? 2 : 3;
    double box[4][4] = { { 0 } };
    box[0][0] = 1 / (plane->width * slab->side[0]);
    box[0][spread] = (-plane->left / plane->width - slab->first[0]) / slab->side[0];
    box[1][1] = -1 / (plane->height * slab->side[1]);
    box[1][spread] = (1 + plane->bottom / plane->height - slab->first[1]) / slab->side[1];
    box[2][depth] = per_z;
    box[2][spread] = -flat * per_z;
    box[3][spread] = 1;
    matrix_multiply(box, eye, slab->matrix);
}

bool slab_find(const DepthPlane *plane, const DepthPixels *pixels, DepthSlab *slab)
{
    uint32_t rect[4];
    double depths[2];
    if (!find_extent(plane, pixels, rect, depths))
        return false;
    DepthSlab made = { .is_parallel = plane->is_parallel };
    /* Some room before and behind, so that flat images have a box too. */
    const double flat[2] = { flat_of(plane->is_parallel, depths[0]),
                             flat_of(plane->is_parallel, depths[1]) };
    const double texel = plane->width / pixels->width;
    const double room = fabs(flat[1] - flat[0]) / 256 +
                        (plane->is_parallel ? texel : fmin(flat[0], flat[1]) * texel) / 4;
    made.low = plane->is_parallel ? flat[0] - room : 1 / (flat[0] + room);
    made.high = plane->is_parallel ? flat[1] + room : 1 / fmax(flat[1] - room, flat[1] / 2);
    const uint32_t size[2] = { pixels->width, pixels->height };
    for (int k = 0; k < 2; k++) {
        const double low = rect[k] > 0 ? rect[k] - 1.0 : 0;
        const double high = rect[k + 2] < size[k] ? rect[k + 2] + 1.0 : size[k];
        made.first[k] = low / size[k];
        made.side[k] = (high - low) / size[k];
    }
    find_matrix(plane, &made);
    for (int corner = 0; corner < 8; corner++) {
        double place[2];
        for (int k = 0; k < 2; k++)
            place[k] = (made.first[k] + (corner >> k & 1 ? made.side[k] : 0)) * size[k];
        depth_plane_point(plane, pixels, place[0], place[1], corner >> 2 ? made.high : made.low,
                          made.corners[corner]);
    }
    *slab = made;
    return true;
}

float slab_z(const DepthSlab *slab, float depth)
{
    if (!shows(slab->is_parallel, depth))
        return SLAB_NOTHING;
    const double low = flat_of(slab->is_parallel, slab->low);
    return (float)((flat_of(slab->is_parallel, (double)depth) - low) /
                   (flat_of(slab->is_parallel, slab->high) - low));
}

GpResult slab_check(const DepthImage *image, const char *method, GpError *error)
{
    if (image->is_cylinder)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%s of a cylinder: expected a planar depth image", method);
    if (image->front.width >= GP_MAX_SIZE || image->front.height >= GP_MAX_SIZE)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%s of a depth image of %u x %u: expected at most %u pixels a side", method,
                       image->front.width, image->front.height, GP_MAX_SIZE - 1);
    return GP_OK;
}

/* --- rays ------------------------------------------------------------------------------------- */

/* As the programs take it: place in clip space, the ray in the box, the ray in the world. */
typedef struct RayCorner {
    float corner[2], start[4], way[4], from[3], along[3];
} RayCorner;

static void find_corners(const DepthSlab *slab, const Camera *camera, const CameraAxes *axes,
                         const double reach[2], RayCorner corners[3])
{
    static const double places[3][2] = { { -1, -1 }, { -1, 3 }, { 3, -1 } };
    for (int k = 0; k < 3; k++) {
        const double x = places[k][0] * axes->half_width, y = places[k][1] * axes->half_height;
        double from[4], along[4];
        for (int i = 0; i < 3; i++) {
            const double aside = axes->right[i] * x + axes->up[i] * y;
            const double spread = camera->fovy > 0 ? aside : 0;
            from[i] = camera->eye[i] + axes->forward[i] * reach[0] +
                      aside * (camera->fovy > 0 ? reach[0] : 1);
            along[i] = (axes->forward[i] + spread) * (reach[1] - reach[0]);
            corners[k].from[i] = (float)from[i];
            corners[k].along[i] = (float)along[i];
        }
        from[3] = 1;
        along[3] = 0;
        for (int i = 0; i < 4; i++) {
            double start = 0, way = 0;
            for (int j = 0; j < 4; j++) {
                start += slab->matrix[i][j] * from[j];
                way += slab->matrix[i][j] * along[j];
            }
            corners[k].start[i] = (float)start;
            corners[k].way[i] = (float)way;
        }
        corners[k].corner[0] = (float)places[k][0];
        corners[k].corner[1] = (float)places[k][1];
    }
}

bool slab_rays(const DepthSlab *slab, const WarpView *view, Frame *frame, SlabRays *rays)
{
    const CameraAxes axes = camera_axes(&view->camera, (double)view->width / view->height);
    double box[8][3], reach[2];
    memcpy(box, slab->corners, sizeof box);
    const GpRect rect = reach_rect(box, &view->camera, &axes, view->width, view->height);
    if (gp_rect_is_empty(rect) || !reach_find(box, &view->camera, &axes, reach))
        return false;
    RayCorner *corners = frame_alloc(frame, 3, sizeof *corners);
    if (!corners)
        return false;
    find_corners(slab, &view->camera, &axes, reach, corners);
    const uint32_t stride = sizeof *corners;
    *rays = (SlabRays){
        .uniforms = slab_uniforms(slab, view),
        .geometry = { .vertex_count = 3,
                      .streams = { [GP_POSITION] = { corners->corner, stride, 2, GP_FLOAT32 },
                                   [GP_TEXCOORD0] = { corners->start, stride, 4, GP_FLOAT32 },
                                   [GP_TEXCOORD1] = { corners->way, stride, 4, GP_FLOAT32 },
                                   [GP_TEXCOORD2] = { corners->from, stride, 3, GP_FLOAT32 },
                                   [GP_TEXCOORD3] = { corners->along, stride, 3, GP_FLOAT32 } } },
        .raster = { .scissor = true,
                    .scissor_x0 = rect.x0,
                    .scissor_y0 = rect.y0,
                    .scissor_x1 = rect.x1,
                    .scissor_y1 = rect.y1 },
    };
    reach_depth(&view->camera, reach, rays->uniforms.depth);
    return true;
}

/* --- what methods share ----------------------------------------------------------------------- */

SlabUniforms slab_uniforms(const DepthSlab *slab, const WarpView *view)
{
    SlabUniforms uniforms = { .first = { (float)slab->first[0], (float)slab->first[1] },
                              .side = { (float)slab->side[0], (float)slab->side[1] } };
    if (view->light)
        uniforms.light = warp_light_uniforms(view);
    return uniforms;
}

void slab_pass(const char *name, const WarpTarget *target, Frame *frame)
{
    static const float nothing[4] = { 0 };
    GpPass *pass = frame_pass(frame, name, target->color, target->depth, nothing);
    pass->color[0].clear = false;
    pass->depth.clear_depth = false;
}

GpDepthState slab_depth_state(const WarpTarget *target)
{
    return target->depth ? (GpDepthState){ .test = GP_LESS, .write = true } : (GpDepthState){ 0 };
}

GpState slab_state(const SlabRays *rays, const WarpTarget *target)
{
    return (GpState){ .raster = rays->raster, .depth = slab_depth_state(target) };
}

GpResult slab_textures_open(const DepthImage *image, DepthTextures *textures, GpError *error)
{
    const DepthPixels *front = &image->front;
    float *found = NULL;
    GpResult result = front->normal ? GP_OK : surface_grid_normals(image, usual_cut, &found, error);
    if (!result)
        result = depth_textures_open(front, found ? found : front->normal, textures, error);
    gp_free(found);
    return result;
}

void slab_textures(const DepthTextures *textures, GpDraw *draw)
{
    static const GpSampler linear = {
        .min = GP_LINEAR, .mag = GP_LINEAR, .address_u = GP_CLAMP, .address_v = GP_CLAMP
    };
    draw->textures[1] = (GpTexture){ textures->color, linear };
    draw->textures[2] = (GpTexture){ textures->normal, linear };
}
