/* The truth of shadows, where geometry says what it is; and the comparison with it. */
#include "apps/truth/shadow_error.h"
#include "apps/truth/voxel_truth.h"
#include "pipeline/io/file.h"
#include "pipeline/io/mesh/mesh_file.h"
#include "tests/support/ball.h"
#include "tests/support/unit.h"

enum { SIZE = 128, PIXELS = SIZE * SIZE };

static const double pi = 3.14159265358979323846;

/* --- scenes ----------------------------------------------------------------------------------- */

/* Triangles under construction. */
typedef struct Model {
    TruthTriangle triangles[2 * BALL];
    uint32_t count;
} Model;

static Model model;

/* A level rectangle, two triangles. */
static void add_level(double x0, double x1, double z0, double z1, double y)
{
    const double corner[4][3] = { { x0, y, z0 }, { x1, y, z0 }, { x1, y, z1 }, { x0, y, z1 } };
    for (int half = 0; half < 2; half++, model.count++)
        for (int k = 0; k < 3; k++)
            memcpy(model.triangles[model.count].corner[k], corner[(2 * half + k) % 4],
                   sizeof corner[0]);
}

/* The ground is triangles 0 and 1: y = 0, 8 by 8. */
static void start_with_ground(void)
{
    model.count = 0;
    add_level(-4, 4, -4, 4, 0);
}

static bool is_ground(uint32_t triangle)
{
    return triangle < 2;
}

static ShadowTruth cast(const TruthTriangle *triangles, uint32_t count, const ShadowView *view)
{
    TruthScene *scene;
    ShadowTruth truth;
    assert_int_equal(truth_scene_create(triangles, count, &scene), GP_OK);
    assert_int_equal(shadow_truth_cast(scene, view, &truth), GP_OK);
    truth_scene_destroy(&scene);
    assert_int_equal(truth.width, view->width);
    assert_int_equal(truth.height, view->height);
    return truth;
}

/* Looks straight down from y = height on 4 by 4 around the origin; x runs to the right, z down. */
static ShadowView from_above(double height, TruthLight light)
{
    return (ShadowView){
        .camera = { { 0, height, 0 }, { 0, 0, 0 }, { 0, 0, -1 }, 0, 4, 0.01, 10 },
        .width = SIZE,
        .height = SIZE,
        .light = light,
    };
}

static double centre_of(int pixel)
{
    return -2 + 4 * (pixel + 0.5) / SIZE;
}

/* --- outlines --------------------------------------------------------------------------------- */

/* A square of side 0.8 at y = 1, and a light at (3, 3, 0): the shadow is 1.5 times as large, around
 * (-0.3, 0). */
static const double block[4] = { 0.4, 1.2, -0.4, 0.4 };
static const TruthLight lamp = { .kind = TRUTH_POINT, .position = { 3, 3, 0 } };

static bool on_block(double x, double z)
{
    return x > block[0] && x < block[1] && z > block[2] && z < block[3];
}

static bool in_shadow_of_block(double x, double z)
{
    return fabs(x + 0.3) < 0.6 && fabs(z) < 0.6;
}

static void build_block(void)
{
    start_with_ground();
    add_level(block[0], block[1], block[2], block[3], 1);
}

static void a_square_casts_a_larger_square(void **state)
{
    (void)state;
    build_block();
    ShadowView view = from_above(4, lamp);
    ShadowTruth truth = cast(model.triangles, model.count, &view);
    int dark = 0;
    for (int i = 0; i < PIXELS; i++) {
        double x = centre_of(i % SIZE), z = centre_of(i / SIZE);
        assert_int_equal(is_ground(truth.triangle[i]), !on_block(x, z));
        assert_true(truth.visibility[i] == (on_block(x, z) || !in_shadow_of_block(x, z)));
        dark += truth.visibility[i] == 0;
    }
    double side = 1.2 * SIZE / 4; /* in pixels */
    assert_true(fabs(dark - side * side) < 4 * side / 2);
    shadow_truth_free(&truth);
    assert_null(truth.visibility);
}

/* The ray through a point of clip space by way of apps/base/camera.h's matrices, down to y = 0. */
static bool get_ground(double inverse[4][4], double x, double y, double point[3])
{
    double end[2][3];
    for (int e = 0; e < 2; e++) {
        const double clip[4] = { x, y, e, 1 };
        double world[4];
        for (int k = 0; k < 4; k++)
            world[k] = inverse[k][0] * clip[0] + inverse[k][1] * clip[1] + inverse[k][2] * clip[2] +
                       inverse[k][3] * clip[3];
        for (int k = 0; k < 3; k++)
            end[e][k] = world[k] / world[3];
    }
    double way[3], t = end[0][1] / (end[0][1] - end[1][1]);
    vector_subtract(end[1], end[0], way);
    vector_add_scaled(end[0], t, way, point);
    return t > 0 && t < 1 && fabs(point[0]) < 4 && fabs(point[2]) < 4;
}

static void a_perspective_view_shows_the_same_square(void **state)
{
    (void)state;
    build_block();
    const Camera camera = { { -2, 2.5, 3 }, { 0.3, 0.2, 0 }, { 0.1, 1, 0 }, 50, 0, 0.5, 20 };
    enum { WIDTH = SIZE + 30, HEIGHT = SIZE };
    ShadowView view = { .camera = camera, .width = WIDTH, .height = HEIGHT, .light = lamp };
    ShadowTruth truth = cast(model.triangles, model.count, &view);
    double look[4][4], project[4][4], both[4][4], inverse[4][4];
    camera_view(&camera, look);
    camera_projection(&camera, (double)WIDTH / HEIGHT, project);
    matrix_multiply(project, look, both);
    assert_true(matrix_inverse(both, inverse) != 0);
    int dark = 0, nothing = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double x = (i % WIDTH + 0.5) * 2 / WIDTH - 1, y = 1 - (i / WIDTH + 0.5) * 2 / HEIGHT;
        double point[3];
        bool ground = get_ground(inverse, x, y, point);
        nothing += truth.triangle[i] == TRUTH_NO_TRIANGLE;
        if (is_ground(truth.triangle[i])) {
            bool expected = in_shadow_of_block(point[0], point[2]);
            assert_true(ground);
            assert_true(truth.visibility[i] == !expected);
            dark += expected;
        } else if (truth.triangle[i] == TRUTH_NO_TRIANGLE) {
            assert_false(ground);
            assert_true(truth.visibility[i] == SHADOW_NOTHING);
        }
    }
    assert_in_range(dark, PIXELS / 50, PIXELS / 4);
    assert_in_range(nothing, PIXELS / 50, PIXELS / 2);
    shadow_truth_free(&truth);
}

/* The disc that a ball at (0, 1, 0) casts from (0, 3, 0). */
static double disc_of_ball(double radius)
{
    return 3 * radius / sqrt(4 - radius * radius);
}

static void a_ball_casts_a_disc(void **state)
{
    (void)state;
    const double centre[3] = { 0, 1, 0 }, radius = 0.5;
    /* Between corners the ball is as much smaller as the chord of its quads' diagonals says. */
    double step = pi / BALL_ACROSS, inner_radius = radius * (1 - step * step / 4);
    start_with_ground();
    make_ball(centre, radius, model.triangles + 2);
    model.count += BALL;
    ShadowView view = from_above(4, (TruthLight){ .kind = TRUTH_POINT, .position = { 0, 3, 0 } });
    ShadowTruth truth = cast(model.triangles, model.count, &view);
    double inner = disc_of_ball(inner_radius), outer = disc_of_ball(radius), hidden = 0, dark = 0;
    for (int i = 0; i < PIXELS; i++) {
        double x = centre_of(i % SIZE), z = centre_of(i / SIZE), from_axis = sqrt(x * x + z * z);
        bool lit = truth.visibility[i] == 1;
        if (is_ground(truth.triangle[i])) {
            if (from_axis < inner || from_axis > outer)
                assert_int_equal(lit, from_axis > outer);
            dark += !lit;
        } else {
            hidden++;
            /* On a ball, what sees the light is nearer to it than where its rays graze. */
            double horizon = radius * sqrt(1 - radius * radius / 4);
            if (fabs(from_axis - horizon) > 0.04 * radius)
                assert_int_equal(lit, from_axis < horizon);
        }
    }
    double pixel = 16.0 / PIXELS, slack = 2 * pi * outer * (4.0 / SIZE) / 2;
    assert_true((dark + hidden) * pixel > pi * inner * inner - slack);
    assert_true((dark + hidden) * pixel < pi * outer * outer + slack);
    shadow_truth_free(&truth);
}

/* --- lights ----------------------------------------------------------------------------------- */

static void a_light_behind_the_surface_leaves_it_dark(void **state)
{
    (void)state;
    start_with_ground();
    const TruthLight behind[] = {
        { .kind = TRUTH_POINT, .position = { 1, -2, 0.5 } },
        { .kind = TRUTH_DIRECTIONAL, .towards = { 1, -2, 0.5 } },
        { .kind = TRUTH_CONE, .position = { 0, -2, 0 }, .axis = { 0, 1, 0 }, .half_angle = 80 },
        { .kind = TRUTH_AREA, .position = { 0, -2, 0 }, .side = { { 1, 0, 0 }, { 0, 0, 1 } } },
        { .kind = TRUTH_DIRECTIONAL, .towards = { 1, 0, 0 } }, /* just along it */
    };
    for (size_t k = 0; k < GP_COUNT(behind); k++)
        for (int side = 0; side < 2; side++) {
            ShadowView view = from_above(side ? -4 : 4, behind[k]);
            ShadowTruth truth = cast(model.triangles, model.count, &view);
            bool lit = side && k + 1 < GP_COUNT(behind);
            for (int i = 0; i < PIXELS; i++)
                assert_true(truth.visibility[i] == lit);
            shadow_truth_free(&truth);
        }
}

static void a_far_point_is_a_direction(void **state)
{
    (void)state;
    build_block();
    ShadowView view =
        from_above(4, (TruthLight){ .kind = TRUTH_POINT, .position = { 0.9e9, 0.8e9, -0.3e9 } });
    ShadowTruth point = cast(model.triangles, model.count, &view);
    view.light = (TruthLight){ .kind = TRUTH_DIRECTIONAL, .towards = { 9, 8, -3 } };
    ShadowTruth direction = cast(model.triangles, model.count, &view);
    assert_memory_equal(point.visibility, direction.visibility, PIXELS * sizeof(float));
    assert_memory_equal(point.triangle, direction.triangle, PIXELS * sizeof(uint32_t));
    int dark = 0;
    for (int i = 0; i < PIXELS; i++) {
        /* The square moves by 9/8 and 3/8 and keeps its size. */
        double x = centre_of(i % SIZE) + 9.0 / 8, z = centre_of(i / SIZE) - 3.0 / 8;
        if (is_ground(point.triangle[i]))
            assert_true(point.visibility[i] == !on_block(x, z));
        dark += point.visibility[i] == 0;
    }
    assert_true(fabs(dark - 0.64 / 16 * PIXELS) < 4 * 0.8 * SIZE / 4 / 2);
    shadow_truth_free(&point);
    shadow_truth_free(&direction);
}

static bool in_disc(double x, double z)
{
    double radius = 2 * tan(30 * pi / 180);
    return x * x + z * z < radius * radius;
}

static bool in_square(double x, double z)
{
    return fmax(fabs(x), fabs(z)) < 2 * tan(20 * pi / 180);
}

static bool in_strip(double x, double z)
{
    return fmax(fabs(x), fabs(z)) < 0.75;
}

static void spots_light_their_shape(void **state)
{
    (void)state;
    start_with_ground();
    add_level(-2, 2, -2, 2, 3); /* behind the light, so in nothing's way */
    static const struct {
        TruthLight light;
        bool (*inside)(double x, double z);
    } spots[] = {
        { { .kind = TRUTH_CONE, .position = { 0, 2, 0 }, .axis = { 0, -5, 0 }, .half_angle = 30 },
          in_disc },
        { { .kind = TRUTH_FRUSTUM,
            .frustum = { { 0, 2, 0 }, { 0, 0, 0 }, { 0, 0, 1 }, 40, 0, 0.1, 1 } },
          in_square },
        { { .kind = TRUTH_FRUSTUM,
            .frustum = { { 0, 2, 0 }, { 0, 0, 0 }, { 0, 0, 1 }, 0, 1.5, 0.1, 1 } },
          in_strip },
    };
    for (size_t k = 0; k < GP_COUNT(spots); k++) {
        ShadowView view = from_above(2.5, spots[k].light);
        ShadowTruth truth = cast(model.triangles, model.count, &view);
        for (int i = 0; i < PIXELS; i++)
            assert_true(truth.visibility[i] ==
                        spots[k].inside(centre_of(i % SIZE), centre_of(i / SIZE)));
        shadow_truth_free(&truth);
    }
}

static void a_wall_of_rays_casts_what_is_before_it(void **state)
{
    (void)state;
    build_block();
    const Camera wall = { { 0, 2, 0 }, { 0, 0, 0 }, { 0, 0, 1 }, 0, 3, 0.1, 1 };
    ShadowView view = from_above(0.9, (TruthLight){ .kind = TRUTH_FRUSTUM, .frustum = wall });
    ShadowTruth truth = cast(model.triangles, model.count, &view);
    for (int i = 0; i < PIXELS; i++) {
        double x = centre_of(i % SIZE), z = centre_of(i / SIZE);
        assert_true(truth.visibility[i] == (fmax(fabs(x), fabs(z)) < 1.5 && !on_block(x, z)));
    }
    shadow_truth_free(&truth);
}

/* A half-plane at y = 1 under a square light of side 1 at y = 2: from the ground at x, the edge
 * hides all of the light beyond -x. */
static void an_area_light_casts_a_linear_penumbra(void **state)
{
    (void)state;
    start_with_ground();
    add_level(0, 9, -9, 9, 1);
    for (unsigned int samples = 0; samples <= 64; samples += 64)
        for (int swapped = 0; swapped < 2; swapped++) {
            TruthLight light = { .kind = TRUTH_AREA,
                                 .position = { 0, 2, 0 },
                                 .side = { { !swapped, 0, swapped }, { swapped, 0, !swapped } },
                                 .samples = samples };
            ShadowView view = from_above(0.9, light);
            ShadowTruth truth = cast(model.triangles, model.count, &view);
            double tolerance = 0.5 / (samples ? samples : 16) + 1e-6;
            for (int i = 0; i < PIXELS; i++) {
                double share = fmin(fmax(0.5 - centre_of(i % SIZE), 0), 1);
                assert_true(fabs((double)truth.visibility[i] - share) <= tolerance);
                if (share == 0 || share == 1)
                    assert_true((double)truth.visibility[i] == share);
            }
            shadow_truth_free(&truth);
        }
}

/* What is asked only whether half of a light is seen is told no sooner than it is certain. */
static void half_of_an_area_light_or_more_counts_as_lit(void **state)
{
    (void)state;
    start_with_ground();
    add_level(0, 9, -9, 9, 1);
    for (unsigned int samples = 1; samples <= 34; samples += 3)
        for (int turned = 0; turned < 4; turned++) {
            TruthLight light = { .kind = TRUTH_AREA, .position = { 0, 2, 0 }, .samples = samples };
            light.side[0][turned & 1 ? 0 : 2] = light.side[1][turned & 1 ? 2 : 0] =
                turned & 2 ? -1 : 1;
            ShadowView view = from_above(0.9, light);
            ShadowTruth all = cast(model.triangles, model.count, &view);
            view.only_lit = true;
            ShadowTruth half = cast(model.triangles, model.count, &view);
            int lit = 0;
            for (int i = 0; i < PIXELS; i++) {
                assert_true(half.visibility[i] == (all.visibility[i] >= 0.5F));
                lit += half.visibility[i] == 1;
            }
            assert_true(lit > PIXELS / 4 && lit < PIXELS);
            shadow_truth_free(&all);
            shadow_truth_free(&half);
        }
}

/* --- the view --------------------------------------------------------------------------------- */

static void near_and_far_cut_what_is_seen_not_what_shades(void **state)
{
    (void)state;
    build_block();
    ShadowView view = from_above(4, lamp);
    view.camera.near = 3.5; /* between the block and the ground */
    ShadowTruth truth = cast(model.triangles, model.count, &view);
    for (int i = 0; i < PIXELS; i++) {
        assert_true(is_ground(truth.triangle[i]));
        assert_true(truth.visibility[i] ==
                    !in_shadow_of_block(centre_of(i % SIZE), centre_of(i / SIZE)));
    }
    shadow_truth_free(&truth);
    view.camera.near = 2;
    view.camera.far = 3.5;
    truth = cast(model.triangles, model.count, &view);
    for (int i = 0; i < PIXELS; i++)
        if (truth.triangle[i] == TRUTH_NO_TRIANGLE)
            assert_true(truth.visibility[i] == SHADOW_NOTHING);
        else
            assert_false(is_ground(truth.triangle[i]));
    shadow_truth_free(&truth);
}

static void threads_do_not_matter(void **state)
{
    (void)state;
    const double centre[3] = { 0.4, 0.7, 0 };
    start_with_ground();
    make_ball(centre, 0.6, model.triangles + 2);
    model.count += BALL;
    ShadowView view = from_above(4, (TruthLight){ .kind = TRUTH_AREA,
                                                  .position = { 1, 3, 1 },
                                                  .side = { { 1, 0, 0 }, { 0, 0.3, 1 } },
                                                  .samples = 5 });
    view.width = 61;
    view.height = 47;
    ShadowTruth one = cast(model.triangles, model.count, &view);
    for (view.threads = 2; view.threads <= 8; view.threads += 3) {
        ShadowTruth many = cast(model.triangles, model.count, &view);
        assert_memory_equal(one.visibility, many.visibility, 61 * 47 * sizeof(float));
        assert_memory_equal(one.triangle, many.triangle, 61 * 47 * sizeof(uint32_t));
        shadow_truth_free(&many);
    }
    shadow_truth_free(&one);
}

/* The bunny in its own coordinates on a square at its feet. A rasterizer that snaps corners to
 * 1/256 pixel covers one pixel less: the centre of (358, 177) is not 0.001 pixels inside. */
static void the_bunny_shades_the_ground(void **state)
{
    (void)state;
    char path[400];
    GpMesh mesh;
    GpError error = { "" };
    if (gp_data_find("meshes/bunny.ply", path, sizeof path, &error))
        skip();
    if (gp_mesh_read(path, GP_MESH_TRIANGLES, &mesh, &error))
        fail_msg("%s", error.text);
    double low[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL }, high[3], size[3];
    for (int k = 0; k < 3; k++)
        high[k] = -HUGE_VAL;
    for (size_t i = 0; i < 3 * (size_t)mesh.vertex_count; i++) {
        low[i % 3] = fmin(low[i % 3], (double)mesh.positions[i]);
        high[i % 3] = fmax(high[i % 3], (double)mesh.positions[i]);
    }
    vector_subtract(high, low, size);
    double x = (low[0] + high[0]) / 2, z = (low[2] + high[2]) / 2,
           half = 1.5 * sqrt(vector_dot(size, size));
    model.count = 0;
    add_level(x - half, x + half, z - half, z + half, low[1]);

    TruthTriangle *triangles = gp_alloc(mesh.triangle_count + 2, sizeof *triangles);
    assert_non_null(triangles);
    memcpy(triangles, model.triangles, 2 * sizeof *triangles);
    voxel_triangles(mesh.positions, mesh.indices, mesh.triangle_count, &(VoxelBox){ .scale = 1 },
                    triangles + 2);
    const ShadowView view = {
        .camera = { { 0.25, 0.35, 0.40 }, { -0.0168, 0.09, -0.0014 }, { 0, 1, 0 }, 32, 0, 0.1, 3 },
        .width = 1024,
        .height = 1024,
        .light = { .kind = TRUTH_POINT, .position = { -0.35, 0.55, 0.25 } },
        .threads = 2,
    };
    ShadowTruth truth = cast(triangles, mesh.triangle_count + 2, &view);
    int covered = 0, dark = 0;
    for (int i = 0; i < 1024 * 1024; i++) {
        covered += truth.triangle[i] != TRUTH_NO_TRIANGLE;
        dark += truth.visibility[i] == 0;
    }
    assert_int_equal(covered, 803727);
    assert_int_equal(dark, 129529);
    shadow_truth_free(&truth);
    gp_free(triangles);
    gp_mesh_free(&mesh);
}

/* --- errors ----------------------------------------------------------------------------------- */

static void errors_are_counted_by_kind(void **state)
{
    (void)state;
    float visibility[8] = { 1, 1, 1, 0, 0, 0.5f, 0.25f, SHADOW_NOTHING };
    const float measured[8] = { 1, 0.49f, SHADOW_NOTHING, 0.5f, 0, 0.75f, 0.25f, 1 };
    const uint8_t mask[8] = { 1, 0, 1, 255, 1, 1, 1, 1 };
    const ShadowTruth truth = { 4, 2, visibility, NULL };

    ShadowError error = shadow_error(&truth, measured, NULL);
    assert_int_equal(error.covered, 6);
    assert_int_equal(error.lit, 3);
    assert_int_equal(error.acne, 1);
    assert_int_equal(error.leak, 1);
    assert_true(error.wrong == 2.0 / 6);
    assert_true(fabs(error.rmse - sqrt((0.51 * 0.51 + 0.25 + 0.0625) / 6)) < 1e-7);

    error = shadow_error(&truth, measured, mask);
    assert_int_equal(error.covered, 5);
    assert_int_equal(error.lit, 2);
    assert_int_equal(error.acne, 0);
    assert_int_equal(error.leak, 1);
    assert_true(error.wrong == 1.0 / 5);
    assert_true(fabs(error.rmse - sqrt((0.25 + 0.0625) / 5)) < 1e-15);
}

static void no_error_of_nothing_and_of_itself(void **state)
{
    (void)state;
    build_block();
    ShadowView view = from_above(4, lamp);
    ShadowTruth truth = cast(model.triangles, model.count, &view);
    ShadowError error = shadow_error(&truth, truth.visibility, NULL);
    assert_int_equal(error.covered, PIXELS);
    assert_int_equal(error.acne + error.leak, 0);
    assert_true(error.wrong == 0 && error.rmse == 0);
    static const uint8_t none[PIXELS];
    error = shadow_error(&truth, truth.visibility, none);
    assert_int_equal(error.covered, 0);
    assert_true(error.wrong == 0 && error.rmse == 0);
    float not_a_number[PIXELS];
    for (int i = 0; i < PIXELS; i++)
        not_a_number[i] = NAN;
    error = shadow_error(&truth, not_a_number, NULL);
    assert_int_equal(error.acne, error.lit);
    assert_true(isnan(error.rmse));
    shadow_truth_free(&truth);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_square_casts_a_larger_square),
        cmocka_unit_test(a_perspective_view_shows_the_same_square),
        cmocka_unit_test(a_ball_casts_a_disc),
        cmocka_unit_test(a_light_behind_the_surface_leaves_it_dark),
        cmocka_unit_test(a_far_point_is_a_direction),
        cmocka_unit_test(spots_light_their_shape),
        cmocka_unit_test(a_wall_of_rays_casts_what_is_before_it),
        cmocka_unit_test(an_area_light_casts_a_linear_penumbra),
        cmocka_unit_test(half_of_an_area_light_or_more_counts_as_lit),
        cmocka_unit_test(near_and_far_cut_what_is_seen_not_what_shades),
        cmocka_unit_test(threads_do_not_matter),
        cmocka_unit_test(the_bunny_shades_the_ground),
        cmocka_unit_test(errors_are_counted_by_kind),
        cmocka_unit_test(no_error_of_nothing_and_of_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
