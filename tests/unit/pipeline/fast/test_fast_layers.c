/* Layers that are blended into whole tiles, many at once, as if no colour needed a limit: one that
 * does is limited all the same, whichever it is. Of few varyings shaders interpolate by themselves,
 * where layers have one shape and varyings one kind: with others the pictures are right too. On
 * every device the bits are the reference's. And what covers tiles that the target ends in is
 * shaded once a pixel, and nowhere else. */
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

static const GpBlend over = { .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA, .dst = GP_INV_SRC_ALPHA };

static ExerciseUniforms plain_uniforms(void)
{
    ExerciseUniforms uniforms = { .color = { 1, 1, 1, 1 } };
    for (int i = 0; i < 4; i++)
        uniforms.matrix[i][i] = 1;
    return uniforms;
}

static GpGeometry geometry_of(uint32_t vertices)
{
    const uint32_t stride = sizeof corners[0];
    return (
        GpGeometry){ .vertex_count = vertices,
                     .streams = { [GP_POSITION] = { corners[0], stride, 4, GP_FLOAT32 },
                                  [GP_COLOR] = { corners[0] + 4, stride, 4, GP_FLOAT32 },
                                  [GP_TEXCOORD0] = { corners[0] + 8, stride, 2, GP_FLOAT32 } } };
}

static void draw_layers(const GpProgram *program, GpFormat format, const GpBlend *blend,
                        uint32_t side, const char *what)
{
    const ExerciseUniforms uniforms = plain_uniforms();
    GpDraw draw = { .program = program,
                    .uniforms = &uniforms,
                    .geometry = geometry_of(3 * LAYERS) };
    draw.state.blend[0] = *blend;
    GpPass pass = { .color[0] = { .clear = true, .clear_color = { 0.25f, 0.5f, 0.75f, 1 } },
                    .draws = &draw,
                    .draw_count = 1 };
    const GpSurfaceDesc desc = { .format = format, .width = side, .height = side };
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
        draw_layers(&exercise_color, formats[i % GP_COUNT(formats)], &over, SIDE, what);
    }
}

/* What makes layers differ from those that shaders can interpolate. */
typedef enum Difference { NONE, DEPTHS, SHAPES, EDGES, DIFFERENCES } Difference;

static void make_different(Difference what)
{
    make_layers();
    for (int i = 0; i < 3 * LAYERS; i++) {
        float *corner = corners[i];
        const int layer = i / 3, k = i % 3;
        const float w = what == DEPTHS ? 1 + 0.5f * (float)k : 1;
        corner[0] += what == SHAPES && layer % 2 && k == 1 ? 1.0f : 0;
        corner[1] -= what == EDGES && k == 2 && layer % 4 == 3 ? 2.5f : 0; /* cuts through tiles */
        for (int c = 0; c < 3; c++)
            corner[c] *= w;
        corner[3] = w;
    }
}

static void few_varyings(void **state)
{
    (void)state;
    static const GpInterpolation modes[][2] = { { GP_PERSPECTIVE, GP_PERSPECTIVE },
                                                { GP_LINEAR_SCREEN, GP_LINEAR_SCREEN },
                                                { GP_FLAT, GP_FLAT },
                                                { GP_PERSPECTIVE, GP_FLAT },
                                                { GP_LINEAR_SCREEN, GP_PERSPECTIVE } };
    static const GpFormat formats[] = { GP_A8R8G8B8, GP_A16B16G16R16F, GP_A32B32G32R32F };
    static const GpBlend opaque = { .op = GP_BLEND_OFF };
    for (uint32_t i = 0; i < DIFFERENCES * GP_COUNT(modes) * GP_COUNT(formats) * 6; i++) {
        const Difference difference = i % DIFFERENCES;
        const uint32_t mode = i / DIFFERENCES % GP_COUNT(modes);
        const uint32_t format = i / DIFFERENCES / GP_COUNT(modes) % GP_COUNT(formats);
        const bool blends = i / DIFFERENCES / GP_COUNT(modes) / GP_COUNT(formats) % 2 == 0;
        const GpProgram *const programs[] = { &exercise_flat, &exercise_at_once,
                                              &exercise_few_in_parts };
        GpProgram program = *programs[i / DIFFERENCES % GP_COUNT(programs)]; /* of four */
        char what[64];
        program.varyings[0] = (GpVaryingDecl){ "color", 3, modes[mode][0] };
        program.varyings[1] = (GpVaryingDecl){ "alpha", 1, modes[mode][1] };
        make_different(difference);
        snprintf(what, sizeof what, "difference %d, mode %u, format %u", (int)difference, mode,
                 format);
        draw_layers(&program, formats[format], blends ? &over : &opaque, 2 * SIDE + 13, what);
    }
}

static void count_covered(GpProgram *program, uint32_t triangles)
{
    const ExerciseUniforms uniforms = plain_uniforms();
    const GpDraw draw = { .program = program,
                          .uniforms = &uniforms,
                          .geometry = geometry_of(3 * triangles) };
    GpPass pass = { .color[0] = { .clear = true }, .draws = &draw, .draw_count = 1 };
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = 101, .height = 77 };
    assert_int_equal(gp_surface_create(&desc, &pass.color[0].surface, NULL), GP_OK);
    for (size_t i = 0; device_here(i); i++) {
        if (device_here(i)->executor == GP_EXECUTOR_REFERENCE) /* which shades what is hidden too */
            continue;
        GpDevice *device = device_open(device_here(i));
        assert_int_equal(gp_device_run(device, &(GpList){ &pass, 1 }, NULL), GP_OK);
        assert_int_equal(gp_device_counters(device)->fragments_shaded, desc.width * desc.height);
        gp_device_destroy(&device);
    }
    gp_surface_destroy(&pass.color[0].surface);
}

static void covered_pixels_are_shaded_once(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 4; i++) {
        GpProgram program = exercise_color;
        program.uses_derivatives = i % 2;
        make_layers();
        corners[4][0] = -0.5f; /* the second triangle is a small one, in front of the first */
        corners[5][1] = -0.5f;
        count_covered(&program, 1 + i / 2);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(colours_beyond_the_limits),
                                        cmocka_unit_test(few_varyings),
                                        cmocka_unit_test(covered_pixels_are_shaded_once) };
    return cmocka_run_group_tests_name("layers", tests, NULL, NULL);
}
