/* What of a walk's ground and of its casters may be left out: nothing that shows. */
#include "apps/depth_images/drawing/view_planes.h"
#include "apps/depth_images/drawing/walk_ground.h"
#include "tests/support/depth/depth_shapes.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

static const WarpLight sun = { .position = { 0.48, 0.8, 0.36 }, .directional = true };

static double real(Random *random, float low, float high)
{
    return (double)random_float(random, low, high);
}

static void some_direction(Random *random, double way[3])
{
    do
        for (int k = 0; k < 3; k++)
            way[k] = real(random, -1, 1);
    while (!(vector_dot(way, way) > 0.01 && vector_dot(way, way) < 1));
    vector_normalize(way);
}

/* All that a ball throws lies in the ellipse, which it touches on all sides. */
static void shadows_of_balls_are_ellipses(void **state)
{
    (void)state;
    Random random = { 20261123 };
    const WalkObject object = { .center = { 3, 1.7, -5 }, .radius = 1.3 };
    const WalkShadow shadow = walk_shadow(&object, &sun, 0);
    double most = 0;
    for (int i = 0; i < 100000; i++) {
        double way[3], point[3];
        some_direction(&random, way);
        vector_add_scaled(object.center, object.radius, way, point);
        vector_add_scaled(point, -point[1] / sun.position[1], sun.position, point);
        const double x = point[0] - shadow.center[0], z = point[2] - shadow.center[2];
        const double along = (x * shadow.way[0] + z * shadow.way[1]) / shadow.along;
        const double across = (z * shadow.way[0] - x * shadow.way[1]) / shadow.across;
        most = fmax(most, along * along + across * across);
    }
    assert_true(most < 1 + 1e-9 && most > 0.999);
}

/* Points of a ball on its way that are in the view: the way is never said to be outside. */
static void a_way_that_is_seen_is_not_left_out(void **state)
{
    (void)state;
    Random random = { 7 };
    uint32_t seen = 0, left_out = 0;
    for (int i = 0; i < 20000; i++) {
        Camera camera = { .up = { 0, 1, 0 }, .fovy = 50, .near = 0.3, .far = 30 };
        double from[3], to[3], at[3], way[3];
        float clip[4][4];
        for (int k = 0; k < 3; k++) {
            camera.eye[k] = real(&random, -5, 5);
            from[k] = real(&random, -15, 15);
            to[k] = real(&random, -15, 15);
        }
        const double radius = real(&random, 0, 3), share = real(&random, 0, 1);
        const WarpView view = { camera, 160, 90, NULL };
        const ViewPlanes planes = view_planes(&view);
        camera_matrix(&camera, 160.0 / 90, clip);
        some_direction(&random, way);
        vector_subtract(to, from, at);
        vector_add_scaled(from, share, at, at);
        vector_add_scaled(at, radius, way, at);
        double place[4];
        for (int k = 0; k < 4; k++)
            place[k] = (double)clip[k][3] + (double)clip[k][0] * at[0] +
                       (double)clip[k][1] * at[1] + (double)clip[k][2] * at[2];
        const double inside = 0.999 * place[3];
        const bool is_in = fabs(place[0]) < inside && fabs(place[1]) < inside && place[2] > 0.001 &&
                           place[2] < inside;
        const bool may = view_planes_may_see_way(&planes, from, to, radius);
        seen += is_in;
        left_out += !may;
        assert_false(is_in && !may);
    }
    print_message("# of 20000 ways %u are seen, %u are left out\n", seen, left_out);
    assert_true(seen > 500 && left_out > 1000);
}

static Walk open_walk(void)
{
    GpError error = { "" };
    DepthShape shape = depth_shape_open("builtin:knot", 9, 0);
    DepthModel model = depth_shape_capture(&shape, 64, 48, 32, true);
    Walk walk;
    if (walk_open(&model, 1, 9, &walk, &error))
        fail_msg("%s", error.text);
    depth_shape_close(&shape);
    depth_model_free(&model);
    /* grass of one colour: which of its levels a pixel has, at their borders rounding tells */
    for (uint32_t i = 0; i < walk.grass->levels; i++) {
        const GpLevel *level = &walk.grass->level[i];
        for (uint32_t y = 0; y < level->height; y++)
            memset(gp_surface_texel(level, 4, 0, y), 200, 4 * (size_t)level->width);
    }
    return walk;
}

enum { WIDTH = 240, HEIGHT = 135 };

/* The ground with shadows read where they may be, or, from wide ones, everywhere. */
static void draw_ground(const Walk *walk, double share, double texel, float rgba[][4])
{
    static const double map[4][4] = {
        { 0.04, 0, 0.01, 0.5 }, { -0.01, 0, 0.04, 0.5 }, { 0, 0, 0, 0.5 }, { 0, 0, 0, 1 }
    };
    Frame frame = { .color = NULL };
    WarpLight light = sun;
    const WarpView view = { walk_camera(walk, share), WIDTH, HEIGHT, &light };
    for (int k = 0; k < 3; k++)
        light.color[k] = 0.8f;
    GpSurface *lit = frame_surface(&frame, GP_D32F, 1, 1, 1);
    frame_pass(&frame, "map", NULL, lit, NULL);
    frame.color = frame_surface(&frame, GP_A8R8G8B8, WIDTH, HEIGHT, 1);
    frame.depth = frame_surface(&frame, GP_D32F, WIDTH, HEIGHT, 1);
    frame_pass(&frame, "ground", frame.color, frame.depth, (const float[4]){ 0 });
    const GpTexture texture = { lit, { .compare = true } };
    walk_ground_draw(walk, &view, &(WalkGround){ &light, map, texture, texel }, &frame);
    run_list(&frame.list);
    assert_int_equal(gp_surface_read_floats(frame.color, 0, NULL, &rgba[0][0], NULL), GP_OK);
    frame_free(&frame);
}

/* Where nothing throws a shadow, whether the map is read shows nowhere: neither by seams nor by
 * colours. */
static void parts_of_the_ground_do_not_show(void **state)
{
    (void)state;
    static float some[WIDTH * HEIGHT][4], all[WIDTH * HEIGHT][4];
    Walk walk = open_walk();
    for (int i = 0; i < 8; i++) {
        uint32_t other = 0;
        draw_ground(&walk, i / 8.0, 0.1, some);
        draw_ground(&walk, i / 8.0, 15, all);
        for (int k = 0; k < WIDTH * HEIGHT; k++)
            for (int c = 0; c < 3; c++)
                other += fabsf(some[k][c] - all[k][c]) > 2.5f / 255;
        assert_int_equal(other, 0);
    }
    walk_close(&walk);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shadows_of_balls_are_ellipses),
        cmocka_unit_test(a_way_that_is_seen_is_not_left_out),
        cmocka_unit_test(parts_of_the_ground_do_not_show),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
