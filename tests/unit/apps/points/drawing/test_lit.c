/* Lit surfels of a white ball against the light by hand, from several sides. */
#include "apps/points/drawing/splats.h"

#include "tests/support/depth/formula.h"
#include "tests/support/surfel_shapes.h"

#include <string.h>

enum { SIDE = 64 };

/* An eye on an axis, and what is to its right and above it. */
typedef struct Side {
    double eye[3], right[3], up[3];
} Side;

static const Side sides[] = {
    { { 0, 0, 5 }, { 1, 0, 0 }, { 0, 1, 0 } },
    { { 5, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 } },
    { { 0, 5, 0 }, { 1, 0, 0 }, { 0, 0, -1 } },
};

static SplatView seen_from(const Side *side)
{
    SplatView view = {
        .camera = { .fovy = 30, .near = 1, .far = 10 }, .width = SIDE, .height = SIDE, .lit = true
    };
    memcpy(view.camera.eye, side->eye, sizeof side->eye);
    memcpy(view.camera.up, side->up, sizeof side->up);
    return view;
}

/* What the ray of a pixel's centre meets of the ball of radius 1, whose points are their normals;
 * false: nothing, or what is near its border. */
static bool meet_ball(const Side *side, int x, int y, double ray[3], double normal[3])
{
    const double slope = 0.2679491924311227; /* the tangent of half the view, 15 degrees */
    const double across = ((x + 0.5) / SIDE * 2 - 1) * slope,
                 up = (1 - (y + 0.5) / SIDE * 2) * slope;
    for (int k = 0; k < 3; k++)
        ray[k] = across * side->right[k] + up * side->up[k] - side->eye[k] / 5;
    vector_normalize(ray);
    vector_add_scaled(side->eye, formula_meet(FORMULA_BALL, side->eye, ray), ray, normal);
    return vector_dot(normal, ray) < -0.5;
}

/* 0.15 from everywhere, 0.85 of the light, which is 0.4 to the left of the eye's direction and 0.5
 * above it; and what shines. */
static double lit(const Side *side, const double ray[3], const double normal[3], double specular)
{
    double light[3], half[3];
    for (int k = 0; k < 3; k++)
        light[k] = side->eye[k] / 5 - 0.4 * side->right[k] + 0.5 * side->up[k];
    vector_normalize(light);
    vector_subtract(light, ray, half);
    vector_normalize(half);
    double shine = fmax(vector_dot(normal, half), 0);
    for (int k = 0; k < 5; k++)
        shine *= shine;
    return fmin(0.15 + 0.85 * fmax(vector_dot(normal, light), 0) + specular * shine, 1);
}

/* The mean difference of a picture of the ball from what is right. Only what is lit once a pixel
 * shines. */
static double difference(const Surfels *ball, const Side *side, SplatMethod method)
{
    const bool filtered = method < SPLAT_ROUND;
    GpError error = { "" };
    Frame frame = { .color = NULL };
    const SplatRun run = { .filter = filtered ? SPLAT_EWA : method,
                           .count = ball->count,
                           .radius = ball->surfels[0].radius };
    const SplatSource source = { .surfels = ball->surfels, .runs = &run, .run_count = 1 };
    const SplatView view = seen_from(side);
    SplatSetting setting = SPLAT_DEFAULTS;
    setting.method = method;
    if (splats_build(&source, &view, &setting, &frame, &error))
        fail_msg("%s", error.text);
    run_list(&frame.list);
    const uint8_t *texels = frame.color->level[0].texels;
    double sum = 0;
    int pixels = 0;
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            double ray[3], normal[3];
            if (!meet_ball(side, x, y, ray, normal))
                continue;
            sum += fabs(texels[4 * (y * SIDE + x)] / 255.0 -
                        lit(side, ray, normal, filtered ? 0.25 : 0));
            pixels++;
        }
    frame_free(&frame);
    assert_true(pixels > 1000);
    return sum / pixels;
}

static void light_is_to_the_left_of_the_eye_and_above_it(void **state)
{
    static const SplatMethod methods[] = { SPLAT_EWA,   SPLAT_TERNARY, SPLAT_PERSPECTIVE,
                                           SPLAT_QUADS, SPLAT_ROUND,   SPLAT_PIXELS };
    (void)state;
    Surfels ball = { 0 };
    shape_sphere(&ball, 20000);
    for (uint32_t i = 0; i < ball.count; i++)
        memset(ball.surfels[i].color, 255, 3);
    for (size_t m = 0; m < sizeof methods / sizeof *methods; m++)
        for (size_t s = 0; s < sizeof sides / sizeof *sides; s++) {
            const double off = difference(&ball, &sides[s], methods[m]);
            if (off > (methods[m] < SPLAT_ROUND ? 0.002 : 0.02))
                fail_msg("method %d, eye %zu: off by %.4f", (int)methods[m], s, off);
        }
    surfels_free(&ball);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_is_to_the_left_of_the_eye_and_above_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
