#include "tests/support/depth/formula.h"

#include "apps/depth_images/capture.h"
#include "tests/support/depth/view_rays.h"

/* --- surfaces --------------------------------------------------------------------------------- */

static double meet_plane(const double normal[3], double offset, const double from[3],
                         const double direction[3])
{
    const double t = (offset - vector_dot(normal, from)) / vector_dot(normal, direction);
    return t > 0 ? t : HUGE_VAL;
}

static double meet_ball(const double from[3], const double direction[3])
{
    const double a = vector_dot(direction, direction), b = vector_dot(from, direction);
    const double c = vector_dot(from, from) - 1, root = b * b - a * c;
    if (root < 0)
        return HUGE_VAL;
    const double near = (-b - sqrt(root)) / a, far = (-b + sqrt(root)) / a;
    return near > 0 ? near : far > 0 ? far : HUGE_VAL;
}

static double meet_step(const double from[3], const double direction[3])
{
    static const double forward[3] = { 0, 0, 1 };
    double nearest = HUGE_VAL;
    for (int side = 0; side < 2; side++) {
        const double t = meet_plane(forward, side ? -0.5 : 0.5, from, direction);
        if ((from[0] + t * direction[0] >= 0) == side)
            nearest = fmin(nearest, t);
    }
    return nearest;
}

static const double leaning[3] = { 0.3, 0.2, 1 };

double formula_meet(Formula formula, const double from[3], const double direction[3])
{
    static const double forward[3] = { 0, 0, 1 };
    switch (formula) {
    case FORMULA_FLAT:
        return meet_plane(forward, 0, from, direction);
    case FORMULA_PLANE:
        return meet_plane(leaning, 0.1, from, direction);
    case FORMULA_STEP:
        return meet_step(from, direction);
    default:
        return meet_ball(from, direction);
    }
}

static double color_at(const double point[3], int channel)
{
    return 0.5 + 0.5 * sin(2 * point[channel]);
}

/* --- images ----------------------------------------------------------------------------------- */

static void set_pixel(Formula formula, const double point[3], double depth, uint32_t i,
                      DepthPixels *pixels)
{
    double normal[3] = { 0, 0, 1 };
    if (formula == FORMULA_PLANE)
        memcpy(normal, leaning, sizeof normal);
    if (formula == FORMULA_BALL)
        memcpy(normal, point, sizeof normal);
    vector_normalize(normal);
    pixels->depth[i] = (float)depth;
    for (uint32_t k = 0; k < 3; k++) {
        pixels->color[3 * i + k] = (float)color_at(point, (int)k);
        pixels->normal[3 * i + k] = (float)normal[k];
    }
}

DepthImage formula_image(Formula formula, bool is_parallel)
{
    const Camera camera = { .eye = { 0, 0, 5 },
                            .up = { 0, 1, 0 },
                            .fovy = is_parallel ? 0 : 40,
                            .height = 3.6,
                            .near = 1,
                            .far = 10 };
    DepthImage image = { .plane = depth_plane_of_camera(&camera, 1) };
    assert_int_equal(depth_pixels_make(FORMULA_IMAGE, FORMULA_IMAGE, true, &image.front), GP_OK);
    for (uint32_t i = 0; i < FORMULA_IMAGE * FORMULA_IMAGE; i++) {
        double ends[2][3], direction[3];
        for (int k = 0; k < 2; k++)
            depth_plane_point(&image.plane, &image.front, i % FORMULA_IMAGE + 0.5,
                              i / FORMULA_IMAGE + 0.5, 1 + k, ends[k]);
        vector_subtract(ends[1], ends[0], direction);
        const double t = formula_meet(formula, ends[0], direction);
        if (!isfinite(t))
            continue;
        vector_add_scaled(ends[0], t, direction, ends[1]);
        set_pixel(formula, ends[1], 1 + t, i, &image.front);
    }
    return image;
}

void formula_free(DepthImage *image)
{
    depth_pixels_free(&image->front);
}

Camera formula_camera(double x, double y, double z, bool is_parallel)
{
    const double away = sqrt(x * x + y * y + z * z);
    return (Camera){ .eye = { x, y, z },
                     .up = { 0, fabs(y) < 0.9 * away, fabs(y) >= 0.9 * away },
                     .fovy = is_parallel ? 0 : 40,
                     .height = away / 2,
                     .near = 0.1,
                     .far = 20 };
}

/* --- pictures --------------------------------------------------------------------------------- */

WarpTarget formula_target(bool float_color, Frame *frame)
{
    static const float nothing[4] = { 0 };
    const WarpTarget target = {
        .color = frame_surface(frame, float_color ? GP_A32B32G32R32F : GP_A8R8G8B8, FORMULA_SIDE,
                               FORMULA_SIDE, 1),
        .depth = frame_surface(frame, GP_D32F, FORMULA_SIDE, FORMULA_SIDE, 1),
    };
    frame_pass(frame, "below", target.color, target.depth, nothing);
    frame->color = target.color;
    frame->depth = target.depth;
    return target;
}

/* What a camera sees through a place of the picture. returns its distance along the view */
static double see(Formula formula, const Camera *camera, double x, double y, double point[3])
{
    double from[3], direction[3];
    view_ray(camera, x, y, FORMULA_SIDE, FORMULA_SIDE, from, direction);
    const double t = formula_meet(formula, from, direction);
    for (int k = 0; k < 3; k++)
        point[k] = from[k] + t * direction[k];
    return t > camera->near && t < camera->far ? t : HUGE_VAL;
}

/* Whether places of the picture round a pixel are all seen, or all not. */
static bool is_sure(Formula formula, const Camera *camera, uint32_t x, uint32_t y)
{
    int seen = 0;
    for (int i = 0; i < 9; i++) {
        double point[3];
        seen +=
            isfinite(see(formula, camera, x + i % 3 * 1.25 - 0.75, y + i / 3 * 1.25 - 0.75, point));
    }
    return seen == 0 || seen == 9;
}

FormulaOff formula_compare(Formula formula, const Camera *camera, const Frame *frame)
{
    static float rgba[FORMULA_SIDE * FORMULA_SIDE][4], z[FORMULA_SIDE * FORMULA_SIDE][4];
    FormulaOff off = { 0 };
    uint32_t both = 0;
    assert_int_equal(gp_surface_read_floats(frame->color, 0, NULL, &rgba[0][0], NULL), GP_OK);
    assert_int_equal(gp_surface_read_floats(frame->depth, 0, NULL, &z[0][0], NULL), GP_OK);
    for (uint32_t i = 0; i < FORMULA_SIDE * FORMULA_SIDE; i++) {
        const uint32_t x = i % FORMULA_SIDE, y = i / FORMULA_SIDE;
        double point[3];
        const double distance = see(formula, camera, x + 0.5, y + 0.5, point);
        const bool is_there = isfinite(distance), is_drawn = rgba[i][3] > 0;
        const double reach = 1.4;
        if (is_there && (fabs(point[0]) > reach || fabs(point[1]) > reach))
            continue;
        off.covered += is_there;
        if (is_there != is_drawn) {
            const bool counts = is_sure(formula, camera, x, y);
            off.missing += counts && is_there;
            off.extra += counts && is_drawn;
            continue;
        }
        if (!is_there)
            continue;
        const double deep = fabs(view_distance(camera, (double)z[i][0]) / distance - 1);
        double color = 0;
        for (int k = 0; k < 3; k++)
            color = fmax(color, fabs((double)rgba[i][k] - color_at(point, k)));
        off.color = fmax(off.color, color);
        off.depth = fmax(off.depth, deep);
        off.mean_color += color;
        off.mean_depth += deep;
        both++;
    }
    off.mean_color /= both ? both : 1;
    off.mean_depth /= both ? both : 1;
    return off;
}

uint32_t formula_check_numbers(const Frame *frame)
{
    static float rgba[FORMULA_SIDE * FORMULA_SIDE][4], z[FORMULA_SIDE * FORMULA_SIDE][4];
    uint32_t covered = 0;
    assert_int_equal(gp_surface_read_floats(frame->color, 0, NULL, &rgba[0][0], NULL), GP_OK);
    assert_int_equal(gp_surface_read_floats(frame->depth, 0, NULL, &z[0][0], NULL), GP_OK);
    for (uint32_t i = 0; i < FORMULA_SIDE * FORMULA_SIDE; i++) {
        for (int c = 0; c < 4; c++)
            assert_true(isfinite(rgba[i][c]));
        assert_true(z[i][0] >= 0 && z[i][0] <= 1);
        covered += rgba[i][3] > 0;
    }
    return covered;
}
