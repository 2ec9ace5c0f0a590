/* Corners at odd places: w of 0, denormal or infinite, z on the planes or infinite, and none of
 * them a number. On every device the bits are the reference's, and what has no place on the screen
 * draws nothing. */
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <float.h>

enum { SIDE = 96, TRIANGLES = 40, CORNERS = 3 * TRIANGLES, CORNER_FLOATS = 10, SEEDS = 120 };

typedef struct Odd {
    float corners[CORNERS][CORNER_FLOATS];
    ExerciseUniforms uniforms;
    GpDraw draw;
    GpPass pass;
} Odd;

static void begin(Odd *odd, const GpProgram *program)
{
    const uint32_t stride = sizeof odd->corners[0];
    memset(odd, 0, sizeof *odd);
    for (int i = 0; i < 4; i++)
        odd->uniforms.matrix[i][i] = 1;
    odd->draw = (GpDraw){
        .program = program,
        .uniforms = &odd->uniforms,
        .geometry = { .vertex_count = CORNERS,
                      .streams = { [GP_POSITION] = { odd->corners[0], stride, 4, GP_FLOAT32 },
                                   [GP_COLOR] = { odd->corners[0] + 4, stride, 4, GP_FLOAT32 },
                                   [GP_TEXCOORD0] = { odd->corners[0] + 8, stride, 2,
                                                      GP_FLOAT32 } } }
    };
    GpSurfaceDesc desc = { .format = GP_A16B16G16R16F, .width = SIDE, .height = SIDE };
    odd->pass = (GpPass){ .color[0].clear = true,
                          .depth = { .clear_depth = true, .depth_value = 0.75f },
                          .draws = &odd->draw,
                          .draw_count = 1 };
    assert_int_equal(gp_surface_create(&desc, &odd->pass.color[0].surface, NULL), GP_OK);
    desc.format = GP_D32F;
    assert_int_equal(gp_surface_create(&desc, &odd->pass.depth.surface, NULL), GP_OK);
}

static void end(Odd *odd)
{
    gp_surface_destroy(&odd->pass.color[0].surface);
    gp_surface_destroy(&odd->pass.depth.surface);
}

/* What the matrix makes infinite, in some corners, is finite before: 0 * infinity would be no
 * number. */
static void place_oddly(Random *random, Odd *odd)
{
    static const float ws[] = { 0, 1e-45f, 1e-40f, FLT_MIN, 1e-3f, 1, 1, 1, 2, 100, FLT_MAX, -1 };
    static const float zs[] = { 0, -0.0f, 1e-45f, 0.25f, 0.5f, 1, 1, 2, FLT_MAX, -1 };
    const bool infinite_w = random_int(random, 0, 2) == 0, infinite_z = random_int(random, 0, 2);
    odd->uniforms.matrix[3][3] = infinite_w ? FLT_MAX : 1;
    odd->uniforms.matrix[2][2] = infinite_w && infinite_z ? FLT_MAX : 1;
    for (int i = 0; i < CORNERS; i++) {
        float *corner = odd->corners[i];
        for (int k = 0; k < CORNER_FLOATS; k++)
            corner[k] = random_float(random, k < 2 ? -1.2f : 0, 1.2f);
        const bool ordinary = random_int(random, 0, 1);
        corner[3] = ordinary ? 1 : ws[random_int(random, 0, (int)GP_COUNT(ws) - 1)];
        corner[2] = ordinary ? 0.5f : zs[random_int(random, 0, (int)GP_COUNT(zs) - 1)];
        if (corner[3] < 1e-3f && random_int(random, 0, 1)) /* which 1/w still gives a place */
            corner[0] = corner[1] = 0;
    }
}

static void corners_at_odd_places_draw_what_the_reference_does(void **state)
{
    (void)state;
    static const GpProgram *const programs[] = { &exercise_color, &exercise_flat,
                                                 &exercise_depth_only };
    Random random = { 11 };
    for (int seed = 0; seed < SEEDS; seed++) {
        Odd odd;
        begin(&odd, programs[seed % 3]);
        place_oddly(&random, &odd);
        odd.pass.order = (GpOrder)(seed / 3 % 3);
        odd.draw.state.depth =
            (GpDepthState){ .test = (GpCompare)(seed % 8), .write = !odd.pass.order };
        if (seed / 9 % 2)
            odd.draw.state.blend[0] =
                (GpBlend){ .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA, .dst = GP_INV_SRC_ALPHA };
        if (seed / 18 % 2)
            odd.draw.state.raster.slope_depth_bias = 0.5f;
        if (seed % 7 == 6)
            odd.draw.geometry.primitive = GP_POINTS;
        run_seed_everywhere(&odd.pass, seed);
        end(&odd);
    }
}

/* 1/w of what is nearer than any number is none, and neither is where it would be. */
static void a_triangle_with_a_corner_nowhere_is_not_drawn(void **state)
{
    (void)state;
    static const float ws[] = { 1e-40f, 1e-45f };
    for (size_t i = 0; i < GP_COUNT(ws); i++) {
        Odd odd;
        begin(&odd, &exercise_color);
        odd.draw.geometry.vertex_count = 3;
        for (int k = 0; k < 3; k++)
            memcpy(
                odd.corners[k],
                (float[CORNER_FLOATS]){ k == 1 ? 3 : -1, k == 2 ? -3 : 1, 0, 1, 1, 1, 1, 1, 1, 1 },
                sizeof odd.corners[k]);
        run_seed_everywhere(&odd.pass, (int)i);
        const uint64_t drawn = gp_surface_hash(odd.pass.color[0].surface);
        odd.corners[2][0] = odd.corners[2][1] = 0;
        odd.corners[2][3] = ws[i];
        run_seed_everywhere(&odd.pass, (int)i);
        const uint64_t nowhere = gp_surface_hash(odd.pass.color[0].surface);
        odd.draw.geometry.vertex_count = 0;
        run_seed_everywhere(&odd.pass, (int)i);
        assert_int_equal(nowhere, gp_surface_hash(odd.pass.color[0].surface));
        assert_int_not_equal(nowhere, drawn);
        end(&odd);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corners_at_odd_places_draw_what_the_reference_does),
        cmocka_unit_test(a_triangle_with_a_corner_nowhere_is_not_drawn),
    };
    return cmocka_run_group_tests_name("odd positions", tests, NULL, NULL);
}
