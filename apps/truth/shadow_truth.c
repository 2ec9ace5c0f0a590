#include "apps/truth/shadow_truth.h"

#include "apps/truth/triangle.h"
#include "pipeline/base/pool.h"

enum { DEFAULT_SAMPLES = 16 };

/* What a pixel shows. */
typedef struct Surface {
    double position[3], normal[3]; /* normal: of the plane, towards the eye, any length */
    uint32_t triangle;
} Surface;

typedef struct Job {
    const TruthScene *scene;
    const ShadowView *view;
    CameraAxes camera, frustum;
    ShadowTruth truth;
} Job;

/* --- the eye ---------------------------------------------------------------------------------- */

/* The ray of a pixel: starts on the near plane; t is the distance from there along the view. */
static void get_pixel_ray(const Job *job, uint32_t i, uint32_t j, double origin[3],
                          double direction[3])
{
    const ShadowView *view = job->view;
    const CameraAxes *axes = &job->camera;
    double x = axes->half_width * ((2 * i + 1) / (double)view->width - 1);
    double y = axes->half_height * (1 - (2 * j + 1) / (double)view->height);
    double *moved = view->camera.fovy > 0 ? direction : origin;
    for (int k = 0; k < 3; k++) {
        origin[k] = view->camera.eye[k];
        direction[k] = axes->forward[k];
    }
    vector_add_scaled(moved, x, axes->right, moved);
    vector_add_scaled(moved, y, axes->up, moved);
    vector_add_scaled(origin, view->camera.near, direction, origin);
}

static bool find_surface(const Job *job, uint32_t i, uint32_t j, Surface *surface)
{
    double origin[3], direction[3];
    TruthHit hit;
    get_pixel_ray(job, i, j, origin, direction);
    if (!truth_first_hit(job->scene, origin, direction, &hit) ||
        hit.t > job->view->camera.far - job->view->camera.near)
        return false;
    const TruthTriangle *triangle = truth_scene_triangle(job->scene, hit.triangle);
    *surface = (Surface){ .triangle = hit.triangle };
    for (int k = 0; k < 3; k++)
        vector_add_scaled(surface->position, hit.share[k], triangle->corner[k], surface->position);
    truth_normal(triangle, surface->normal);
    if (vector_dot(surface->normal, direction) > 0)
        vector_add_scaled(surface->normal, -2, surface->normal, surface->normal);
    return true;
}

/* --- the light -------------------------------------------------------------------------------- */

static bool sees_point(const Job *job, const Surface *surface, const double point[3])
{
    double way[3];
    vector_subtract(point, surface->position, way);
    return vector_dot(surface->normal, way) > 0 &&
           !truth_blocked(job->scene, surface->position, point, surface->triangle);
}

static bool sees_direction(const Job *job, const Surface *surface, const double towards[3])
{
    return vector_dot(surface->normal, towards) > 0 &&
           !truth_blocked_along(job->scene, surface->position, towards, surface->triangle);
}

static bool in_cone(const TruthLight *light, const double position[3])
{
    double way[3], sine, cosine;
    vector_subtract(position, light->position, way);
    angle_sincos(light->half_angle, &sine, &cosine);
    double along = vector_dot(way, light->axis);
    double lengths = sqrt(vector_dot(way, way) * vector_dot(light->axis, light->axis));
    return along >= lengths * cosine;
}

static bool sees_frustum(const Job *job, const Surface *surface)
{
    const CameraAxes *axes = &job->frustum;
    const double *eye = job->view->light.frustum.eye;
    const bool parallel = job->view->light.frustum.fovy == 0;
    double way[3], source[3];
    vector_subtract(surface->position, eye, way);
    double depth = vector_dot(way, axes->forward);
    double spread = parallel ? 1 : depth;
    if (depth <= 0 || fabs(vector_dot(way, axes->right)) > spread * axes->half_width ||
        fabs(vector_dot(way, axes->up)) > spread * axes->half_height)
        return false;
    vector_add_scaled(surface->position, -depth, axes->forward, source);
    return sees_point(job, surface, parallel ? source : eye);
}

/* The bits of k, less than 2^bits, behind the binary point in reverse; the centre of that cell. */
static double spread_bits(unsigned int k, int bits)
{
    double value = ldexp(0.5, -bits);
    for (int i = 0; i < bits; i++)
        value += ldexp(k >> i & 1, -1 - i);
    return value;
}

static double seen_of_area(const Job *job, const Surface *surface)
{
    const TruthLight *light = &job->view->light;
    unsigned int samples = light->samples ? light->samples : DEFAULT_SAMPLES, seen = 0;
    int bits = 0;
    while (1u << bits < samples && bits < 31)
        bits++;
    for (unsigned int k = 0; k < samples; k++) {
        double point[3];
        vector_add_scaled(light->position, (k + 0.5) / samples - 0.5, light->side[0], point);
        vector_add_scaled(point, spread_bits(k, bits) - 0.5, light->side[1], point);
        seen += sees_point(job, surface, point);
        const unsigned int left = samples - k - 1;
        if (job->view->only_lit && (2 * seen >= samples || 2 * (seen + left) < samples))
            return 2 * seen >= samples;
    }
    return (double)seen / samples;
}

static double get_visibility(const Job *job, const Surface *surface)
{
    const TruthLight *light = &job->view->light;
    switch (light->kind) {
    case TRUTH_CONE:
        return in_cone(light, surface->position) && sees_point(job, surface, light->position);
    case TRUTH_FRUSTUM:
        return sees_frustum(job, surface);
    case TRUTH_DIRECTIONAL:
        return sees_direction(job, surface, light->towards);
    case TRUTH_AREA:
        return light->half_angle > 0 && !in_cone(light, surface->position)
                   ? 0
                   : seen_of_area(job, surface);
    case TRUTH_POINT:
        break;
    }
    return sees_point(job, surface, light->position);
}

/* --- the picture ------------------------------------------------------------------------------ */

static void cast_row(void *context, uint32_t row, int worker)
{
    Job *job = context;
    (void)worker;
    for (uint32_t i = 0; i < job->view->width; i++) {
        Surface surface;
        size_t pixel = (size_t)row * job->view->width + i;
        bool covered = find_surface(job, i, row, &surface);
        job->truth.visibility[pixel] =
            covered ? (float)get_visibility(job, &surface) : SHADOW_NOTHING;
        job->truth.triangle[pixel] = covered ? surface.triangle : TRUTH_NO_TRIANGLE;
    }
}

GpResult shadow_truth_cast(const TruthScene *scene, const ShadowView *view, ShadowTruth *truth)
{
    size_t pixels = (size_t)view->width * view->height;
    Job job = {
        .scene = scene,
        .view = view,
        .camera = camera_axes(&view->camera, (double)view->width / view->height),
        .frustum = camera_axes(&view->light.frustum, 1),
        .truth = { view->width, view->height, gp_alloc(pixels, sizeof *truth->visibility),
                   gp_alloc(pixels, sizeof *truth->triangle) },
    };
    GpPool *pool = NULL;
    if (!job.truth.visibility || !job.truth.triangle ||
        gp_pool_create(view->threads ? view->threads : 1, &pool, NULL)) {
        shadow_truth_free(&job.truth);
        return GP_ERROR_MEMORY;
    }
    gp_pool_run(pool, view->height, cast_row, &job);
    gp_pool_destroy(&pool);
    *truth = job.truth;
    return GP_OK;
}

void shadow_truth_free(ShadowTruth *truth)
{
    gp_free(truth->visibility);
    gp_free(truth->triangle);
    *truth = (ShadowTruth){ 0 };
}
