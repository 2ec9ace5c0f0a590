/* Layers that are blended into whole tiles, many at once, as if no colour needed a limit: one that does is limited
 * all the same, whichever it is. On every device the bits are the reference's. */
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

#include <math.h>
#include <stdio.h>

enum { SIDE = 64, LAYERS = 19, CORNER_FLOATS = 10 };

static float corners[3 * LAYERS][CORNER_FLOATS];

/* Triangles that cover the picture, of colours in [0, 1] that differ from corner to corner. */
static void make_layers(void)
{
    for (int i = 0; i < 3 * LAYERS; i++) {
        float *corner = corners[i];
        const int layer = i / 3, k = i % 3;
        corner[0] = k == 1 ? 3 : -1;
        corner[1] = k == 2 ? 3 : -1;
        corner[2] = 0;
        corner[3] = 1;
        for (int c = 0; c < 4; c++)
            corner[4 + c] = (float)((layer * 7 + k * 5 + c * 3) % 16) / 16;
    }
}

static void draw_layers(GpFormat format, const char *what)
{
    static const GpBlend blend = { .op = GP_BLEND_ADD,
                                   .src = GP_SRC_ALPHA,
                                   .dst = GP_INV_SRC_ALPHA };
    ExerciseUniforms uniforms = { .color = { 1, 1, 1, 1 } };
    for (int i = 0; i < 4; i++)
        uniforms.matrix[i][i] = 1;
    GpDraw draw = { .program = &exercise_color, .uniforms = &uniforms };
    const uint32_t stride = sizeof corners[0];
    draw.state.blend[0] = blend;
    draw.geometry.vertex_count = 3 * LAYERS;
    draw.geometry.streams[GP_POSITION] = (GpStream){ corners[0], stride, 4, GP_FLOAT32 };
    draw.geometry.streams[GP_COLOR] = (GpStream){ corners[0] + 4, stride, 4, GP_FLOAT32 };
    draw.geometry.streams[GP_TEXCOORD0] = (GpStream){ corners[0] + 8, stride, 2, GP_FLOAT32 };
    GpPass pass = { .color[0] = { .clear = true, .clear_color = { 0.25f, 0.5f, 0.75f, 1 } },
                    .draws = &draw,
                    .draw_count = 1 };
    const GpSurfaceDesc desc = { .format = format, .width = SIDE, .height = SIDE };
    assert_int_equal(gp_surface_create(&desc, &pass.color[0].surface, NULL), GP_OK);
    run_list_everywhere(&(GpList){ &pass, 1 }, what);
    gp_surface_destroy(&pass.color[0].surface);
}

static void colours_beyond_the_limits(void **state)
{
    (void)state;
    static const float beyond[] = { 2, -1, 0x1.000002p0f, -0.0f, -1e-40f, INFINITY, NAN };
    static const GpFormat formats[] = { GP_A8R8G8B8, GP_X8R8G8B8, GP_R8 };
    static const int at[] = { 0, 3, 7, 8, 15, 16, LAYERS - 1 };
    for (size_t i = 0; i < GP_COUNT(beyond) * GP_COUNT(at); i++) {
        const int layer = at[i % GP_COUNT(at)];
        const float value = beyond[i / GP_COUNT(at)];
        char what[64];
        make_layers();
        corners[3 * layer + (i % 2 ? 1 : 0)][4 + i % 4] =
            value; /* from there to the next corners */
        snprintf(what, sizeof what, "layer %d of %g", layer, (double)value);
        draw_layers(formats[i % GP_COUNT(formats)], what);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(colours_beyond_the_limits) };
    return cmocka_run_group_tests_name("layers", tests, NULL, NULL);
}
