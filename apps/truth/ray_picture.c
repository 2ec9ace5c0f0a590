#include "apps/truth/ray_picture.h"

#include <string.h>

typedef struct Run {
    const RayPictureScene *scene;
    CameraAxes axes;
    const RayPicture *picture;
} Run;

/* The ray through a pixel's centre, from the near plane on: a step of 1 is one farther along the
 * view. */
static void find_ray(const Run *run, uint32_t x, uint32_t y, double origin[3], double direction[3])
{
    const RayPictureScene *scene = run->scene;
    const Camera *camera = &scene->camera;
    const double right = run->axes.half_width * (2 * (x + 0.5) / scene->width - 1);
    const double up = run->axes.half_height * (1 - 2 * (y + 0.5) / scene->height);
    const bool is_parallel = !(camera->fovy > 0);
    for (int k = 0; k < 3; k++) {
        const double aside = right * run->axes.right[k] + up * run->axes.up[k];
        direction[k] = run->axes.forward[k] + (is_parallel ? 0 : aside);
        origin[k] = camera->eye[k] + camera->near * direction[k] + (is_parallel ? aside : 0);
    }
}

static void find_row(void *context, uint32_t y, int worker)
{
    const Run *run = context;
    const RayPictureScene *scene = run->scene;
    (void)worker;
    for (uint32_t x = 0; x < scene->width; x++) {
        const size_t at = (size_t)y * scene->width + x;
        double origin[3], direction[3];
        TruthHit hit;
        find_ray(run, x, y, origin, direction);
        if (!truth_first_hit(scene->triangles, origin, direction, &hit) ||
            scene->camera.near + hit.t > scene->camera.far)
            continue;
        run->picture->depth[at] = scene->camera.near + hit.t;
        scene->color(scene->context, hit.triangle, hit.share, run->picture->color + 3 * at);
    }
}

GpResult ray_picture_create(uint32_t width, uint32_t height, RayPicture *picture)
{
    const size_t pixels = (size_t)width * height;
    RayPicture made = { .width = width,
                        .height = height,
                        .color = gp_alloc(pixels, 3 * sizeof(double)),
                        .depth = gp_alloc(pixels, sizeof(double)) };
    if (!made.color || !made.depth) {
        ray_picture_free(&made);
        return GP_ERROR_MEMORY;
    }
    for (size_t i = 0; i < pixels; i++)
        made.depth[i] = (double)INFINITY;
    *picture = made;
    return GP_OK;
}

GpResult ray_picture_make(const RayPictureScene *scene, GpPool *pool, RayPicture *picture)
{
    const GpResult result = ray_picture_create(scene->width, scene->height, picture);
    const Run run = { scene, camera_axes(&scene->camera, (double)scene->width / scene->height),
                      picture };
    if (!result)
        gp_pool_run(pool, scene->height, find_row, (void *)&run);
    return result;
}

void ray_picture_free(RayPicture *picture)
{
    gp_free(picture->color);
    gp_free(picture->depth);
    memset(picture, 0, sizeof *picture);
}
