#include "tests/support/splat_sum.h"

#include <math.h>

enum { STEPS = 20 };           /* of the integral, along an axis of the picture */
static const double reach = 5; /* deviations of the pixel's filter out to which it is summed */

/* A splat before the eye: x right, y down, z forward. */
typedef struct Seen {
    const TruthSplat *splat;
    double place[3], normal[3];
    double plane;      /* normal . place */
    double hidden;     /* depth from which on its disc hides what is behind it */
    double x, y;       /* of its middle, pixels */
    double xx, xy, yy; /* affine: inverse of the variance */
    double height;     /* affine: the weight in its middle */
} Seen;

typedef struct Run {
    const SplatSumScene *scene;
    SplatSum *sum;
    double axis[3][3], focal;
    Seen *seen;
    uint32_t count;
    double filter[STEPS]; /* of the integral: what places along an axis count, sum 1 */
} Run;

/* --- splats ----------------------------------------------------------------------------------- */

/* Two directions square to a normal and to each other. */
static void find_tangents(const double normal[3], double s[3], double t[3])
{
    double other[3];
    const bool is_along_x = fabs(normal[0]) > 0.6;
    vector_set(other, !is_along_x, is_along_x, 0);
    vector_cross(normal, other, t);
    vector_normalize(t);
    vector_cross(t, normal, s);
}

/* V = J J^T + h I with the columns of J the tangents' images, as long as the deviation. */
static void find_affine(const Run *run, Seen *seen)
{
    const double *o = seen->place, h = run->scene->low_pass * run->scene->low_pass;
    const double scale = seen->splat->deviation * run->focal / o[2];
    double tangent[2][3], image[2][2];
    find_tangents(seen->normal, tangent[0], tangent[1]);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            image[i][k] = scale * (tangent[i][k] - tangent[i][2] * o[k] / o[2]);
    const double xx = image[0][0] * image[0][0] + image[1][0] * image[1][0] + h;
    const double yy = image[0][1] * image[0][1] + image[1][1] * image[1][1] + h;
    const double xy = image[0][0] * image[0][1] + image[1][0] * image[1][1];
    const double det = xx * yy - xy * xy;
    const double across = fabs(image[0][0] * image[1][1] - image[0][1] * image[1][0]);
    const double per_deviation = seen->splat->deviation * seen->splat->deviation;
    seen->xx = yy / det;
    seen->xy = -xy / det;
    seen->yy = xx / det;
    /* the projected area spread over a Gaussian of that variance */
    seen->height = seen->splat->area * across / per_deviation / (6.283185307179586 * sqrt(det));
}

/* False: it is not seen. */
static bool look_at(const Run *run, const TruthSplat *splat, Seen *seen)
{
    double away[3];
    *seen = (Seen){ .splat = splat };
    vector_subtract(splat->position, run->scene->camera.eye, away);
    for (int k = 0; k < 3; k++) {
        seen->place[k] = vector_dot(run->axis[k], away);
        seen->normal[k] = vector_dot(run->axis[k], splat->normal);
    }
    const double z = seen->place[2];
    seen->plane = vector_dot(seen->normal, seen->place);
    if (!(z >= run->scene->camera.near) || !(seen->plane < 0))
        return false;
    const double facing = fmax(-seen->plane / z, 0.1);
    const double filter = run->scene->low_pass * z / run->focal / facing;
    seen->hidden = z + run->scene->epsilon * (splat->radius + filter);
    seen->x = run->scene->width / 2.0 + run->focal * seen->place[0] / z;
    seen->y = run->scene->height / 2.0 + run->focal * seen->place[1] / z;
    find_affine(run, seen);
    return true;
}

/* --- pixels ----------------------------------------------------------------------------------- */

/* Where the ray through a place of the picture meets the plane, from the splat's middle; false: not
 * before the eye. */
static bool meet(const Run *run, const Seen *seen, double x, double y, double from_middle[3])
{
    const double way[3] = { (x - run->scene->width / 2.0) / run->focal,
                            (y - run->scene->height / 2.0) / run->focal, 1 };
    const double t = seen->plane / vector_dot(seen->normal, way);
    if (!(t > 0) || !isfinite(t))
        return false;
    for (int k = 0; k < 3; k++)
        from_middle[k] = t * way[k] - seen->place[k];
    return true;
}

static bool disc_covers(const Run *run, const Seen *seen, double x, double y)
{
    double at[3];
    return meet(run, seen, x, y, at) &&
           vector_dot(at, at) <= seen->splat->radius * seen->splat->radius;
}

static double affine_weight(const Seen *seen, double x, double y)
{
    const double dx = x - seen->x, dy = y - seen->y;
    return seen->height *
           exp(-0.5 * (seen->xx * dx * dx + 2 * seen->xy * dx * dy + seen->yy * dy * dy));
}

/* Whether all that the filter sees of the plane is so far from the splat that exp is below 2^-53:
 * the corners of its square are the farthest from its middle. */
static bool is_far(const Run *run, const Seen *seen, double x, double y)
{
    double middle[3], farthest = 0;
    const double half = reach * run->scene->low_pass;
    if (!meet(run, seen, x, y, middle))
        return false;
    for (int i = 0; i < 4; i++) {
        double corner[3];
        if (!meet(run, seen, x + (i % 2 ? half : -half), y + (i / 2 ? half : -half), corner))
            return false;
        vector_subtract(corner, middle, corner);
        farthest = fmax(farthest, vector_dot(corner, corner));
    }
    return sqrt(vector_dot(middle, middle)) - sqrt(farthest) > 8.6 * seen->splat->deviation;
}

/* Place of a step of the integral, in deviations of the pixel's filter. */
static double step_place(int step)
{
    return (step + 0.5) * (2 * reach / STEPS) - reach;
}

static double exact_weight(const Run *run, const Seen *seen, double x, double y)
{
    const double low_pass = run->scene->low_pass;
    const double variance = seen->splat->deviation * seen->splat->deviation;
    double sum = 0;
    if (is_far(run, seen, x, y))
        return 0;
    for (int j = 0; j < STEPS; j++)
        for (int i = 0; i < STEPS; i++) {
            double at[3];
            if (meet(run, seen, x + step_place(i) * low_pass, y + step_place(j) * low_pass, at))
                sum += run->filter[i] * run->filter[j] * exp(-0.5 * vector_dot(at, at) / variance);
        }
    return seen->splat->area / (6.283185307179586 * variance) * sum;
}

static void add_pixel(const Run *run, uint32_t column, uint32_t row)
{
    const double x = column + 0.5, y = row + 0.5;
    const size_t pixel = (size_t)row * run->scene->width + column;
    double hidden = (double)INFINITY, color[3] = { 0, 0, 0 }, weights = 0;
    for (uint32_t i = 0; i < run->count; i++)
        if (run->seen[i].hidden < hidden && disc_covers(run, &run->seen[i], x, y))
            hidden = run->seen[i].hidden;
    for (uint32_t i = 0; i < run->count; i++) {
        const Seen *seen = &run->seen[i];
        if (seen->place[2] > hidden)
            continue;
        const double weight = run->scene->kind == SPLAT_SUM_EXACT ? exact_weight(run, seen, x, y)
                                                                  : affine_weight(seen, x, y);
        weights += weight;
        for (int k = 0; k < 3; k++)
            color[k] += weight * seen->splat->color[k];
    }
    run->sum->weight[pixel] = weights;
    for (size_t k = 0; k < 3; k++)
        run->sum->color[3 * pixel + k] = weights > 0 ? color[k] / weights : 0;
}

static void add_row(void *context, uint32_t row, int worker)
{
    const Run *run = context;
    (void)worker;
    for (uint32_t column = 0; column < run->scene->width; column++)
        add_pixel(run, column, row);
}

/* --- the whole -------------------------------------------------------------------------------- */

GpResult splat_sum_make(const SplatSumScene *scene, GpPool *pool, SplatSum *sum)
{
    const CameraAxes axes = camera_axes(&scene->camera, (double)scene->width / scene->height);
    const size_t pixels = (size_t)scene->width * scene->height;
    SplatSum made = { .width = scene->width,
                      .height = scene->height,
                      .color = gp_alloc(pixels, 3 * sizeof(double)),
                      .weight = gp_alloc(pixels, sizeof(double)) };
    Run run = { .scene = scene,
                .sum = &made,
                .focal = scene->height / (2 * axes.half_height),
                .seen = gp_alloc((size_t)scene->count + 1, sizeof(Seen)) };
    if (!made.color || !made.weight || !run.seen) {
        gp_free(run.seen);
        splat_sum_free(&made);
        return GP_ERROR_MEMORY;
    }
    for (int k = 0; k < 3; k++) {
        run.axis[0][k] = axes.right[k];
        run.axis[1][k] = -axes.up[k];
        run.axis[2][k] = axes.forward[k];
    }
    double all = 0;
    for (int i = 0; i < STEPS; i++)
        all += run.filter[i] = exp(-0.5 * step_place(i) * step_place(i));
    for (int i = 0; i < STEPS; i++)
        run.filter[i] /= all;
    for (uint32_t i = 0; i < scene->count; i++)
        run.count += look_at(&run, &scene->splats[i], &run.seen[run.count]);
    gp_pool_run(pool, scene->height, add_row, &run);
    gp_free(run.seen);
    *sum = made;
    return GP_OK;
}

void splat_sum_free(SplatSum *sum)
{
    gp_free(sum->color);
    gp_free(sum->weight);
    *sum = (SplatSum){ .color = NULL };
}
