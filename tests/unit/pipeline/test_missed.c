/* What a trace tells of triangles that are not there: culled ones, and what the near or the far
 * plane alone cut away, pixel by pixel. */
#include <glasspipe/glasspipe.h>
#include "tests/shaders/exercise.h"
#include "tests/support/unit.h"

enum { SIDE = 16 };

typedef struct Vertex {
    float position[4], color[4], uv[2];
} Vertex;

/* What was heard of each pixel. */
typedef struct Heard {
    int drawn[SIDE][SIDE], missed[SIDE][SIDE], set_up;
    const char *reason;
    bool front, has_depth;
    float depth;
} Heard;

static void hear(void *user, const GpTraceEvent *event)
{
    Heard *heard = user;
    if (event->kind == GP_TRACE_RASTER)
        heard->drawn[event->y][event->x]++;
    heard->set_up += event->kind == GP_TRACE_SETUP;
    if (event->kind != GP_TRACE_MISSED)
        return;
    heard->missed[event->y][event->x]++;
    heard->reason = event->missed.reason;
    heard->front = event->missed.front;
    heard->has_depth = event->missed.has_depth;
    heard->depth = event->missed.depth;
}

/* Two triangles over all of the screen, clockwise; z at the left and at the right. */
static Heard draw(float left, float right, GpCull cull, GpTrace trace)
{
    Heard heard = { .reason = NULL };
    Vertex corner[4];
    ExerciseUniforms uniforms;
    memset(&uniforms, 0, sizeof uniforms);
    for (int i = 0; i < 4; i++) {
        corner[i] =
            (Vertex){ .position = { i % 2 ? 1 : -1, i / 2 ? -1 : 1, i % 2 ? right : left, 1 },
                      .color = { 1, 1, 1, 1 } };
        uniforms.matrix[i][i] = 1;
    }
    GpDraw quad = { .program = &exercise_discard,
                    .uniforms = &uniforms,
                    .geometry = { .primitive = GP_TRIANGLE_STRIP, .vertex_count = 4 },
                    .state.raster.cull = cull };
    GpStream *streams = quad.geometry.streams;
    streams[GP_POSITION] = (GpStream){ corner->position, sizeof *corner, 4, GP_FLOAT32 };
    streams[GP_COLOR] = (GpStream){ corner->color, sizeof *corner, 4, GP_FLOAT32 };
    streams[GP_TEXCOORD0] = (GpStream){ corner->uv, sizeof *corner, 2, GP_FLOAT32 };
    GpSurface *surface = NULL;
    assert_int_equal(
        gp_surface_create(&(GpSurfaceDesc){ .format = GP_A8R8G8B8, .width = SIDE, .height = SIDE },
                          &surface, NULL),
        GP_OK);
    const GpPass pass = { .color = { { surface, true } }, .draws = &quad, .draw_count = 1 };
    trace.event = hear;
    trace.user = &heard;
    GpDevice *device = NULL;
    GpError error = { "" };
    const GpDeviceDesc desc = { .executor = GP_EXECUTOR_REFERENCE, .trace = trace };
    assert_int_equal(gp_device_create(&desc, &device, &error), GP_OK);
    if (gp_device_run(device, &(GpList){ &pass, 1 }, &error))
        fail_msg("%s", error.text);
    gp_device_destroy(&device);
    gp_surface_destroy(&surface);
    return heard;
}

static const GpTrace all = { .missed = true };

static int sum(const int count[SIDE][SIDE])
{
    int sum = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        sum += count[i / SIDE][i % SIDE];
    return sum;
}

static void a_culled_triangle_is_told_at_each_pixel_that_it_would_cover(void **state)
{
    (void)state;
    const Heard heard = draw(0.25f, 0.25f, GP_CULL_CW, all);
    assert_int_equal(sum(heard.drawn), 0);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            assert_int_equal(heard.missed[y][x], 1);
    assert_string_equal(heard.reason, "facing");
    assert_true(heard.front && heard.has_depth);
    assert_true(heard.depth == 0.25f);
}

static void what_is_drawn_is_not_missed(void **state)
{
    (void)state;
    const Heard heard = draw(0.25f, 0.25f, GP_CULL_CCW, all);
    assert_int_equal(sum(heard.drawn), SIDE * SIDE);
    assert_int_equal(sum(heard.missed), 0);
}

static void pixels_are_told_of_where_the_near_plane_alone_cut(void **state)
{
    (void)state;
    /* z = 0 in the middle of the screen */
    const Heard heard = draw(-0.5f, 0.5f, GP_CULL_NONE, all);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            assert_int_equal(heard.drawn[y][x], x >= SIDE / 2);
            assert_int_equal(heard.missed[y][x], x < SIDE / 2);
        }
    assert_string_equal(heard.reason, "near plane");
    assert_false(heard.has_depth);
    const Heard far = draw(0.5f, 1.5f, GP_CULL_NONE, all);
    assert_string_equal(far.reason, "far plane");
    assert_int_equal(sum(far.drawn), SIDE * SIDE / 2);
    assert_int_equal(sum(far.missed), SIDE * SIDE / 2);
}

static void a_triangle_all_before_the_near_plane_is_told(void **state)
{
    (void)state;
    const Heard heard = draw(-0.5f, -0.25f, GP_CULL_NONE, all);
    assert_int_equal(sum(heard.drawn), 0);
    assert_int_equal(sum(heard.missed), SIDE * SIDE);
    assert_string_equal(heard.reason, "near plane");
}

static void what_both_planes_cut_is_missed_by_neither_alone(void **state)
{
    (void)state;
    assert_int_equal(sum(draw(-0.5f, 1.5f, GP_CULL_NONE, all).missed), 0);
}

static void one_pixel_is_watched_alone_and_nothing_comes_unasked(void **state)
{
    (void)state;
    const GpTrace one = { .missed = true, .one_pixel = true, .x = 3, .y = 5 };
    const Heard heard = draw(-0.5f, 0.5f, GP_CULL_NONE, one);
    assert_int_equal(sum(heard.missed), 1);
    assert_int_equal(heard.missed[5][3], 1);
    assert_int_equal(heard.set_up, 0); /* the part that would cover it was cut away */
    assert_int_equal(draw(0.25f, 0.25f, GP_CULL_CW, one).set_up, 1);
    assert_int_equal(sum(draw(-0.5f, 0.5f, GP_CULL_NONE, (GpTrace){ .missed = false }).missed), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_culled_triangle_is_told_at_each_pixel_that_it_would_cover),
        cmocka_unit_test(what_is_drawn_is_not_missed),
        cmocka_unit_test(pixels_are_told_of_where_the_near_plane_alone_cut),
        cmocka_unit_test(a_triangle_all_before_the_near_plane_is_told),
        cmocka_unit_test(what_both_planes_cut_is_missed_by_neither_alone),
        cmocka_unit_test(one_pixel_is_watched_alone_and_nothing_comes_unasked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
