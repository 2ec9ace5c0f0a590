/* A walk among depth images: what is seen is drawn and nothing else, under shadows, the same bits
 * on every device. */
#include "apps/depth_images/drawing/walk.h"
#include "tests/support/depth/depth_shapes.h"
#include "tests/support/depth/formula.h"
#include "tests/support/depth/view_rays.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

#include <math.h>

enum { WIDTH = 160, HEIGHT = 90, OBJECTS = 12 };

/* A field of the first of two models, or of both. */
static Walk open_field(uint32_t count)
{
    static const char *const names[] = { "builtin:sphere", "builtin:cube" };
    GpError error = { "" };
    DepthModel models[2];
    Walk walk;
    for (int i = 0; i < 2; i++) {
        DepthShape shape = depth_shape_open(names[i], 9, 0);
        models[i] = depth_shape_capture(&shape, 64, 48, 32, true);
        depth_shape_close(&shape);
    }
    if (walk_open(models, count, OBJECTS, &walk, &error))
        fail_msg("%s", error.text);
    depth_model_free(&models[0]);
    depth_model_free(&models[1]);
    return walk;
}

static Walk open_walk(void)
{
    return open_field(2);
}

static Frame make(const Walk *walk, const WalkSetting *setting, const Camera *camera,
                  WalkCounts *counts)
{
    GpError error = { "" };
    Frame frame = { .color = NULL };
    if (walk_add(walk, setting, camera, WIDTH, HEIGHT, &frame, counts, &error))
        fail_msg("%s", error.text);
    return frame;
}

static void read_frame(Frame *frame, float rgba[WIDTH * HEIGHT][4])
{
    run_list(&frame->list);
    assert_int_equal(gp_surface_read_floats(frame->color, 0, NULL, &rgba[0][0], NULL), GP_OK);
    frame_free(frame);
}

static void what_is_outside_the_view_is_left_out(void **state)
{
    (void)state;
    Walk walk = open_walk();
    WalkCounts above, among, away;
    Camera camera = walk_camera(&walk, 0.5);
    Frame frame = make(&walk, &(WalkSetting){ .map = 64 }, &camera, &above);
    frame_free(&frame);
    camera = walk_camera(&walk, 0);
    frame = make(&walk, &(WalkSetting){ .map = 64 }, &camera, &among);
    frame_free(&frame);
    camera.eye[1] += 6;
    for (int k = 0; k < 3; k++)
        camera.at[k] = camera.eye[k] + (k == 1 ? 1 : 0.01);
    frame = make(&walk, &(WalkSetting){ .map = 64 }, &camera, &away);
    frame_free(&frame);
    print_message("# of %d: %u from above, %u from among them, %u into the sky\n", OBJECTS,
                  above.objects, among.objects, away.objects);
    assert_int_equal(above.objects, OBJECTS);
    assert_true(among.objects > 0 && among.objects < OBJECTS && among.triangles < above.triangles);
    assert_int_equal(away.objects, 0);
    walk_close(&walk);
}

/* Objects stand on the ground: each casts a shadow, and most of its outside is as bright as
 * without. */
static void shadows_fall_on_the_ground_and_on_images(void **state)
{
    (void)state;
    static float lit[WIDTH * HEIGHT][4], shadowed[WIDTH * HEIGHT][4];
    Walk walk = open_walk();
    const Camera camera = walk_camera(&walk, 0.5);
    uint32_t darker = 0, brighter = 0, ground = 0;
    Frame frame = make(&walk, &(WalkSetting){ .no_shadows = true }, &camera, NULL);
    read_frame(&frame, lit);
    frame = make(&walk, &(WalkSetting){ .map = 512 }, &camera, NULL);
    read_frame(&frame, shadowed);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        const bool is_grass = lit[i][1] > 1.2f * lit[i][0] && lit[i][1] > 1.5f * lit[i][2];
        const bool is_darker = shadowed[i][1] < 0.8f * lit[i][1];
        darker += is_darker;
        ground += is_darker && is_grass;
        brighter += shadowed[i][1] > lit[i][1] + 1.5f / 255;
    }
    print_message("# %u pixels darker, %u of them of the ground\n", darker, ground);
    assert_true(ground > 100 && darker > ground && darker < WIDTH * HEIGHT / 8);
    assert_int_equal(brighter, 0);
    walk_close(&walk);
}

static void every_step_of_the_way_is_drawn(void **state)
{
    (void)state;
    static float rgba[WIDTH * HEIGHT][4];
    Walk walk = open_walk();
    for (int i = 0; i <= 8; i++) {
        const Camera camera = walk_camera(&walk, i / 8.0);
        Frame frame =
            make(&walk, &(WalkSetting){ .map = 64, .step = i % 3 ? 0 : 4 }, &camera, NULL);
        read_frame(&frame, rgba);
        for (int k = 0; k < WIDTH * HEIGHT; k++)
            assert_true(rgba[k][3] == 1);
    }
    walk_close(&walk);
}

/* How many lengths of the ray from a place the nearest ball of the field is away, and its normal
 * there; HUGE_VAL: none. */
static double meet_balls(const Walk *walk, const double from[3], const double ray[3],
                         double normal[3])
{
    double nearest = HUGE_VAL;
    for (int i = 0; i < OBJECTS; i++) {
        const WalkObject *object = &walk->objects[i];
        const double radius = object->scale * walk->models[0].size / 2;
        double own[3], way[3];
        for (int k = 0; k < 3; k++) {
            own[k] = (from[k] - object->foot[k]) / radius - (k == 1);
            way[k] = ray[k] / radius;
        }
        const double along = formula_meet(FORMULA_BALL, own, way);
        if (along < nearest) {
            nearest = along;
            vector_add_scaled(own, along, way, normal);
        }
    }
    return nearest;
}

/* Pixels of balls, of the ground, of both in shadow; and those which are drawn otherwise. */
typedef struct Places {
    int ball, ground, shadow, misplaced, mislit;
} Places;

/* Pixels of one picture; of balls, whether they are in another's shadow where they face the sun. */
static void compare_places(const Walk *walk, double share, Places *places)
{
    static const double to_sun[3] = { 0.48, 0.8, 0.36 }, up[3] = { 0, 1, 0 };
    static float depth[WIDTH * HEIGHT][4], lit[WIDTH * HEIGHT][4], shadowed[WIDTH * HEIGHT][4];
    Camera camera = walk_camera(walk, share);
    camera.far = 60;
    Frame frame = make(walk, &(WalkSetting){ .no_shadows = true }, &camera, NULL);
    read_frame(&frame, lit);
    frame = make(walk, &(WalkSetting){ .map = 1024 }, &camera, NULL);
    run_list(&frame.list);
    assert_int_equal(gp_surface_read_floats(frame.depth, 0, NULL, &depth[0][0], NULL), GP_OK);
    read_frame(&frame, shadowed);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double eye[3], ray[3], place[3], normal[3], above[3], other[3];
        view_ray(&camera, i % WIDTH + 0.5, i / WIDTH + 0.5, WIDTH, HEIGHT, eye, ray);
        const double ball = meet_balls(walk, eye, ray, normal);
        const double ground = ray[1] < 0 ? -eye[1] / ray[1] : HUGE_VAL;
        const double along = fmin(ball, ground);
        vector_add_scaled(eye, along, ray, place);
        if (!(fabs(place[0]) < walk->half && fabs(place[2]) < walk->half))
            continue; /* the sky, or grass on which no object is */
        const double drawn = view_distance(&camera, (double)depth[i][0]);
        const bool faces_sun = vector_dot(ball < ground ? normal : up, to_sun) > 0.3;
        vector_add_scaled(place, 0.01, to_sun, above); /* not on the surface that it leaves */
        const bool in_shadow = faces_sun && isfinite(meet_balls(walk, above, to_sun, other));
        places->ball += ball < ground;
        places->ground += ball > ground;
        places->shadow += in_shadow;
        if (fabs(drawn - along) > 0.01 * along)
            places->misplaced++;
        else if (faces_sun)
            places->mislit += in_shadow != (shadowed[i][1] < 0.8f * lit[i][1]);
    }
}

/* From several places of the way, at which objects are cut by the picture's border. What is mislit
 * lies along the borders of shadows, whose map is filtered. */
static void balls_and_their_shadows_are_where_rays_meet_them(void **state)
{
    (void)state;
    Places places = { 0 };
    Walk walk = open_field(1);
    for (int i = 8; i <= 32; i += 3)
        compare_places(&walk, i / 64.0, &places);
    print_message(
        "# pixels: %d of balls, %d of the ground, %d in shadow; %d misplaced, %d mislit\n",
        places.ball, places.ground, places.shadow, places.misplaced, places.mislit);
    assert_true(places.ball > 10000 && places.ground > 10000 && places.shadow > 4000);
    assert_true(places.misplaced < (places.ball + places.ground) / 100);
    assert_true(places.mislit < places.shadow / 20);
    walk_close(&walk);
}

static void every_device_draws_the_same_bits(void **state)
{
    (void)state;
    Walk walk = open_walk();
    const Camera camera = walk_camera(&walk, 0.3);
    Frame frame = make(&walk, &(WalkSetting){ .map = 128 }, &camera, NULL);
    run_everywhere(&frame);
    frame_free(&frame);
    walk_close(&walk);
}

static void a_model_of_nothing_is_refused(void **state)
{
    (void)state;
    GpError error = { "" };
    Walk walk;
    DepthShape shape = depth_shape_open("builtin:cube", 9, 0);
    DepthModel model = depth_shape_capture(&shape, 16, 16, 0, true);
    for (int i = 0; i < 16 * 16; i++)
        model.images[0].front.depth[i] = DEPTH_NOTHING;
    assert_int_equal(walk_open(&model, 1, 4, &walk, &error), GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "shows nothing"));
    depth_model_free(&model);
    depth_shape_close(&shape);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_outside_the_view_is_left_out),
        cmocka_unit_test(shadows_fall_on_the_ground_and_on_images),
        cmocka_unit_test(every_step_of_the_way_is_drawn),
        cmocka_unit_test(balls_and_their_shadows_are_where_rays_meet_them),
        cmocka_unit_test(every_device_draws_the_same_bits),
        cmocka_unit_test(a_model_of_nothing_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
