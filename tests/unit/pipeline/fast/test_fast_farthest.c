/* What a tile knows of its farthest depths, of which it takes note after so many small triangles:
 * nothing is hidden by them that shows. On every device the bits are the reference's. */
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

enum { SIDE = 64, SMALL = 40, CORNERS = 3 + 3 * SMALL, MANY = 320, CORNER_FLOATS = 10 };

/* Three draws at depths of their own: of one large triangle and many small ones, of a large one,
 * and of small ones, which the first draw is in front of. */
typedef struct Scene {
    float corners[3][CORNERS][CORNER_FLOATS];
    uint32_t many[3 * MANY];
    ExerciseUniforms uniforms;
    GpDraw draws[3];
    GpPass pass;
} Scene;

static void place(float *corner, int x, int y)
{
    corner[0] = (float)x * 2 / SIDE - 1;
    corner[1] = 1 - (float)y * 2 / SIDE;
}

static void begin(Scene *s)
{
    static const float depths[3] = { 0.25f, 0.875f, 0.5f };
    GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = SIDE, .height = SIDE };
    memset(s, 0, sizeof *s);
    for (int i = 0; i < 4; i++)
        s->uniforms.matrix[i][i] = 1;
    for (uint32_t i = 0; i < 3 * MANY; i++)
        s->many[i] = i < 3 ? i : 3 + i % (CORNERS - 3);
    for (int d = 0; d < 3; d++) {
        for (int i = 0; i < CORNERS; i++) {
            float *corner = s->corners[d][i];
            const int x = i / 3 % 8 * 8, y = i / 24 * 8, size = i < 3 ? 2 * SIDE : 4;
            place(corner, i < 3 ? 0 : x, i < 3 ? 0 : y);
            corner[0] += i % 3 == 1 ? (float)size * 2 / SIDE : 0;
            corner[1] -= i % 3 == 2 ? (float)size * 2 / SIDE : 0;
            corner[2] = depths[d];
            corner[3] = 1;
            corner[4 + d] = corner[7] = 1;
        }
        GpDraw *draw = &s->draws[d];
        const float *first = s->corners[d][d == 2 ? 3 : 0];
        const uint32_t stride = sizeof s->corners[d][0];
        *draw = (GpDraw){ .program = &exercise_color, .uniforms = &s->uniforms };
        draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
        draw->geometry.vertex_count = d == 1 ? 3 : d == 2 ? CORNERS - 3 : CORNERS;
        draw->geometry.streams[GP_POSITION] = (GpStream){ first, stride, 4, GP_FLOAT32 };
        draw->geometry.streams[GP_COLOR] = (GpStream){ first + 4, stride, 4, GP_FLOAT32 };
        draw->geometry.streams[GP_TEXCOORD0] = (GpStream){ first + 8, stride, 2, GP_FLOAT32 };
    }
    s->draws[0].geometry.indices = s->many;
    s->draws[0].geometry.index_count = 3 * MANY;
    s->pass = (GpPass){ .color[0].clear = true,
                        .depth = { .clear_depth = true, .clear_stencil = true, .depth_value = 1 },
                        .draws = s->draws,
                        .draw_count = 3 };
    assert_int_equal(gp_surface_create(&desc, &s->pass.color[0].surface, NULL), GP_OK);
    desc.format = GP_D24S8;
    assert_int_equal(gp_surface_create(&desc, &s->pass.depth.surface, NULL), GP_OK);
}

static void finish(Scene *s, const char *what)
{
    run_list_everywhere(&(GpList){ &s->pass, 1 }, what);
    gp_surface_destroy(&s->pass.color[0].surface);
    gp_surface_destroy(&s->pass.depth.surface);
}

/* They are forgotten where a draw may put something behind them. */
static void depths_that_rise_again_hide_nothing(void **state)
{
    (void)state;
    for (int i = 0; i < 2 * GP_COMPARES; i++) {
        const GpCompare test = (GpCompare)(i / 2);
        Scene s;
        begin(&s);
        s.draws[0].state.depth.test = s.draws[2].state.depth.test = i % 2 ? GP_LESS : GP_LESS_EQUAL;
        s.draws[1].state.depth.test = test;
        finish(&s, gp_compare_names[test]);
    }
}

/* A triangle that begins behind what is near, and goes on beyond it. */
static void triangles_longer_than_what_hides_them_show(void **state)
{
    (void)state;
    for (int wide = 6; wide <= 60; wide += 54) {
        Scene s;
        begin(&s);
        place(s.corners[0][1], 34, 0);
        place(s.corners[0][2], 0, 34);
        for (int i = 6; i < CORNERS; i++)
            place(s.corners[0][i], i % 3 == 1 ? 4 : 0, i % 3 == 2 ? 4 : 0);
        place(s.corners[2][4], wide, 0);
        place(s.corners[2][5], 0, 66 - wide);
        finish(&s, "long ones");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depths_that_rise_again_hide_nothing),
        cmocka_unit_test(triangles_longer_than_what_hides_them_show),
    };
    return cmocka_run_group_tests_name("farthest depths", tests, NULL, NULL);
}
