/* A pixel shader in parts draws, on every device, what the same draws in one: whatever number of
 * packets a triangle has, whichever part discards a fragment, and whenever its lanes have turned
 * enough. */
#include <glasspipe/glasspipe.h>
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { WIDTH = 301, HEIGHT = 177, TRIANGLES = 60, TEXELS = 16 };

typedef struct Corner {
    float position[4], color[4], uv[2];
} Corner;

static void make_corners(Random *r, Corner corners[3 * TRIANGLES])
{
    for (int i = 0; i < 3 * TRIANGLES; i++) {
        Corner *corner = &corners[i];
        const float size = i / 3 % 2 ? 0.2f : 1.5f; /* some have few packets, some many */
        if (i % 3 == 0)
            *corner =
                (Corner){ .position = { random_float(r, -1, 1), random_float(r, -1, 1), 0, 1 } };
        else
            *corner = corners[i - i % 3];
        for (int k = 0; k < 2; k++) {
            corner->position[k] += i % 3 ? random_float(r, -size, size) : 0;
            corner->uv[k] = random_float(r, -2, 2);
        }
        for (int k = 0; k < 4; k++)
            corner->color[k] = random_float(r, 0, 1);
    }
}

static uint64_t drawn(const GpDeviceDesc *desc, const GpProgram *program, const Corner *corners,
                      GpSurface *texture)
{
    ExerciseUniforms uniforms = { .color = { 0.125f, 0.25f, 0.5f, 1 } };
    for (int i = 0; i < 4; i++)
        uniforms.matrix[i][i] = 1;
    GpDraw draw = { .program = program,
                    .uniforms = &uniforms,
                    .geometry.vertex_count = 3 * TRIANGLES };
    draw.textures[0].surface = texture;
    GpStream *streams = draw.geometry.streams;
    streams[GP_POSITION] = (GpStream){ corners->position, sizeof *corners, 4, GP_FLOAT32 };
    streams[GP_COLOR] = (GpStream){ corners->color, sizeof *corners, 4, GP_FLOAT32 };
    streams[GP_TEXCOORD0] = (GpStream){ corners->uv, sizeof *corners, 2, GP_FLOAT32 };
    GpPass pass = { .color[0].clear = true, .draws = &draw, .draw_count = 1 };
    const GpSurfaceDesc target = { .format = GP_A32B32G32R32F, .width = WIDTH, .height = HEIGHT };
    assert_int_equal(gp_surface_create(&target, &pass.color[0].surface, NULL), GP_OK);
    run_list_on(desc, &(GpList){ &pass, 1 });
    const uint64_t hash = gp_surface_hash(pass.color[0].surface);
    gp_surface_destroy(&pass.color[0].surface);
    return hash;
}

static void assert_draws_the_same(const GpProgram *whole, const GpProgram *parts)
{
    Random r = { 30 };
    static Corner corners[3 * TRIANGLES];
    GpSurface *texture = NULL;
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = TEXELS, .height = TEXELS };
    assert_int_equal(gp_surface_create(&desc, &texture, NULL), GP_OK);
    for (int i = 0; i < 4 * TEXELS * TEXELS; i++)
        texture->level[0].texels[i] = (uint8_t)random_int(&r, 0, 255);
    make_corners(&r, corners);
    const uint64_t expected = drawn(device_here(0), whole, corners, texture);
    for (size_t i = 0; device_here(i); i++) {
        assert_true(drawn(device_here(i), whole, corners, texture) == expected);
        assert_true(drawn(device_here(i), parts, corners, texture) == expected);
    }
    gp_surface_destroy(&texture);
}

static void parts_draw_what_the_whole_draws(void **state)
{
    (void)state;
    assert_draws_the_same(&exercise_whole, &exercise_in_parts);
}

static void turns_draw_what_a_loop_draws(void **state)
{
    (void)state;
    assert_draws_the_same(&exercise_looped, &exercise_in_turns);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_draw_what_the_whole_draws),
        cmocka_unit_test(turns_draw_what_a_loop_draws),
    };
    return cmocka_run_group_tests_name("parts", tests, NULL, NULL);
}
