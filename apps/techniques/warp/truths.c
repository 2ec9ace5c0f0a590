#include "apps/techniques/warp/truths.h"

#include "apps/depth_images/drawing/light.h"

#include <stdlib.h>

/* --- of a mesh -------------------------------------------------------------------------------- */

static GpResult cast(const Polygons *mesh, const WarpView *view, const TruthScene *triangles,
                     int threads, RayPicture *truth, GpError *error)
{
    TruthLight light = { .shininess = WARP_SHININESS };
    if (view->light) {
        const WarpLightUniforms uniforms = warp_light_uniforms(view);
        for (int k = 0; k < 4; k++) {
            light.eye[k] = (double)uniforms.eye[k];
            light.source[k] = (double)uniforms.source[k];
        }
        for (int k = 0; k < 3; k++) {
            light.ambient[k] = (double)view->light->ambient[k];
            light.diffuse[k] = (double)view->light->color[k];
            light.specular[k] = light.diffuse[k] * WARP_SPECULAR;
        }
    }
    const MeshPaint paint = { .positions = mesh->positions,
                              .normals = mesh->normals,
                              .colors = mesh->colors,
                              .indices = mesh->indices,
                              .waves = mesh->waves,
                              .light = view->light && !(mesh->waves > 0) ? &light : NULL };
    const RayPictureScene scene = { .triangles = triangles,
                                    .camera = view->camera,
                                    .width = view->width,
                                    .height = view->height,
                                    .color = mesh_paint_color,
                                    .context = &paint };
    GpPool *pool;
    GpResult result = gp_pool_create(threads, &pool, error);
    if (result)
        return result;
    result = ray_picture_make(&scene, pool, truth);
    gp_pool_destroy(&pool);
    return result ? gp_fail(error, result, "no memory for the truth") : GP_OK;
}

GpResult warp_truth_of_mesh(const Polygons *mesh, const WarpView *view, int threads,
                            RayPicture *truth, GpError *error)
{
    TruthTriangle *triangles = gp_alloc(mesh->triangle_count, sizeof *triangles);
    TruthScene *scene;
    for (size_t i = 0; triangles && i < mesh->triangle_count; i++)
        for (size_t c = 0; c < 3; c++)
            for (size_t k = 0; k < 3; k++)
                triangles[i].corner[c][k] =
                    (double)mesh->positions[3 * (size_t)mesh->indices[3 * i + c] + k];
    GpResult result =
        triangles ? truth_scene_create(triangles, mesh->triangle_count, &scene) : GP_ERROR_MEMORY;
    gp_free(triangles);
    if (result)
        return truth_scene_fail(error, result);
    result = cast(mesh, view, scene, threads, truth, error);
    truth_scene_destroy(&scene);
    return result;
}

/* --- of a depth image ------------------------------------------------------------------------- */

/* Eyes within a millionth of the picture's distances are one. */
static bool is_of_eye(const DepthPlane *plane, const Camera *camera)
{
    double apart[3];
    vector_subtract(plane->eye, camera->eye, apart);
    return !plane->is_parallel && camera->fovy > 0 && vector_extent(apart) < 1e-6 * camera->far;
}

static void look_up(const DepthImage *image, const WarpView *view, RayPicture *truth)
{
    const CameraAxes axes = camera_axes(&view->camera, (double)view->width / view->height);
    const DepthPixels *front = &image->front;
    for (size_t at = 0; at < (size_t)view->width * view->height; at++) {
        const double right =
            axes.half_width * (2 * ((double)(at % view->width) + 0.5) / view->width - 1);
        const double up =
            axes.half_height * (1 - 2 * ((double)(at / view->width) + 0.5) / view->height);
        double ray[3], point[3], place[2], depth;
        for (int k = 0; k < 3; k++) {
            ray[k] = axes.forward[k] + right * axes.right[k] + up * axes.up[k];
            point[k] = image->plane.eye[k] + ray[k];
        }
        if (!depth_plane_place(&image->plane, front, point, place, &depth) || place[0] < 0 ||
            place[1] < 0 || place[0] >= front->width || place[1] >= front->height)
            continue;
        const size_t from = (size_t)place[1] * front->width + (size_t)place[0];
        if (!isfinite(front->depth[from]))
            continue;
        truth->depth[at] = (double)front->depth[from] / vector_dot(ray, image->plane.forward);
        for (size_t k = 0; k < 3; k++)
            truth->color[3 * at + k] = (double)front->color[3 * from + k];
    }
}

GpResult warp_truth_of_image(const DepthImage *image, const WarpView *view, RayPicture *truth,
                             GpError *error)
{
    if (image->is_cylinder || !is_of_eye(&image->plane, &view->camera))
        return gp_fail(error, GP_ERROR_INVALID,
                       "expected a planar depth image from the eye of the view");
    if (ray_picture_create(view->width, view->height, truth))
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for the truth");
    look_up(image, view, truth);
    return GP_OK;
}

/* --- errors ----------------------------------------------------------------------------------- */

/* How far a pixel of A8R8G8B8 is above the truth, on black: red, green, blue. */
static void pixel_off(const RayPicture *truth, size_t at, const uint8_t *texel, double off[3])
{
    for (int k = 0; k < 3; k++)
        off[k] = (texel[3] ? texel[2 - k] / 255.0 : 0) - truth->color[3 * at + (size_t)k];
}

/* The distance along the view that a depth buffer holds. */
static double view_depth(const Camera *camera, double depth)
{
    const double near = camera->near, far = camera->far;
    return camera->fovy > 0 ? near * far / (far - depth * (far - near))
                            : near + depth * (far - near);
}

static int compare_numbers(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

GpResult warp_error(const RayPicture *truth, const Camera *camera, const GpSurface *color,
                    const GpSurface *depth, WarpError *off)
{
    const size_t pixels = (size_t)truth->width * truth->height;
    double *depths = gp_alloc(pixels, sizeof *depths);
    WarpError error = { .missing = 0 };
    double square = 0, inside = 0, each[3];
    size_t both = 0;
    if (!depths)
        return GP_ERROR_MEMORY;
    for (size_t at = 0; at < pixels; at++) {
        const uint8_t *texel = color->level[0].texels + 4 * at;
        const bool is_covered = isfinite(truth->depth[at]);
        pixel_off(truth, at, texel, each);
        square += vector_dot(each, each);
        error.covered += is_covered;
        error.missing += is_covered && texel[3] == 0;
        error.extra += !is_covered && texel[3] > 0;
        if (!is_covered || texel[3] == 0)
            continue;
        inside += vector_dot(each, each);
        const double found =
            view_depth(camera, (double)((const float *)depth->level[0].texels)[at]);
        depths[both] = fabs(found - truth->depth[at]);
        error.depth_mean += depths[both++];
    }
    qsort(depths, both, sizeof *depths, compare_numbers);
    error.both = (double)both;
    error.depth_mean /= fmax(error.both, 1);
    error.depth_error = both ? depths[both / 2] : 0;
    error.interior_psnr = both ? -10 * log10(fmax(inside / (3 * error.both), 1e-18)) : (double)NAN;
    error.rmse = sqrt(square / (3 * (double)pixels));
    gp_free(depths);
    *off = error;
    return GP_OK;
}

void warp_difference(const RayPicture *truth, const GpSurface *color, float *off)
{
    for (size_t at = 0; at < (size_t)truth->width * truth->height; at++) {
        double each[3];
        pixel_off(truth, at, color->level[0].texels + 4 * at, each);
        off[at] = (float)((each[0] + each[1] + each[2]) / 3);
    }
}
