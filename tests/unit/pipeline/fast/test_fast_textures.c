/* Every format read by every filter with every address mode, compared too where it holds depths:
 * cells of one picture, each with samplers of its own. On every device the bits are the
 * reference's. */
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { SIDE = 6, CELLS = 18, DRAWS = CELLS * CELLS, CORNER_FLOATS = 10, SIZES = 3 };

/* With texels of all kinds: colours somewhat outside [0, 1], depths inside. */
static GpSurface *filled(Random *random, GpFormat format, uint32_t width, uint32_t height)
{
    const bool depth = gp_format_info(format)->is_depth;
    const GpSurfaceDesc desc = {
        .format = format, .width = width, .height = height, .levels = depth ? 1 : GP_MAX_LEVELS
    };
    GpSurface *s = NULL;
    assert_int_equal(gp_surface_create(&desc, &s, NULL), GP_OK);
    for (int32_t y = 0; y < (int32_t)height; y++)
        for (int32_t x = 0; x < (int32_t)width; x++) {
            const GpRect texel = { x, y, x + 1, y + 1 };
            float rgba[4];
            for (int c = 0; c < 4; c++)
                rgba[c] = random_float(random, -0.125f, 1.125f);
            if (depth)
                gp_surface_clear_depth_rect(s, texel, rgba[0], (uint8_t)x, true, true);
            else
                gp_surface_clear_color_rect(s, texel, rgba);
        }
    if (!depth)
        gp_surface_build_mips(s);
    return s;
}

/* All filters by number, and all address modes. */
static GpSampler sampler_of(int number, bool compare)
{
    return (GpSampler){
        .min = (GpFilter)(number % 2),
        .mag = (GpFilter)(number / 2 % 2),
        .mip = (GpMipFilter)(number / 4 % 3),
        .address_u = (GpAddress)(number / 12 % 5),
        .address_v = (GpAddress)(number / 60 % 5),
        .border = { 0.375f, 0.75f, -0.5f, 0.25f },
        .lod_bias = number % 7 == 0 ? 1.5f : 0,
        .min_lod = number % 11 == 0 ? 1 : 0,
        .max_lod = number % 13 == 0 ? 2 : 0,
        .compare = compare,
    };
}

static void read_everywhere(GpFormat format, bool compare)
{
    static const GpProgram *const programs[] = { &exercise_texture, &exercise_dependent,
                                                 &exercise_vertex_texture };
    static const float corners[3][CORNER_FLOATS] = {
        { -1, 1, 0, 1, 0.1f, 0.4f, 0.9f, 0.2f, -1, -0.7f },
        { 3, 1, 0, 1, 0.9f, 0.8f, 0.1f, 0.6f, 5, -0.7f },
        { -1, -3, 0, 1, 0.5f, 0.2f, 0.3f, 0.9f, -1, 6 }
    };
    static const uint32_t sizes[SIZES][2] = { { 1, 1 }, { 7, 5 }, { 16, 33 } };
    static GpDraw draws[DRAWS];
    Random random = { (uint64_t)format };
    ExerciseUniforms uniforms[2] = { { .scale = { 1, 1, 0.5f, 0 } },
                                     { .scale = { 0.125f, 4, -1, 0 } } };
    for (int i = 0; i < 8; i++)
        uniforms[i / 4].matrix[i % 4][i % 4] = 1;
    GpSurface *textures[SIZES];
    for (int i = 0; i < SIZES; i++)
        textures[i] = filled(&random, format, sizes[i][0], sizes[i][1]);
    GpPass pass = { .color[0].clear = true, .draws = draws, .draw_count = DRAWS };
    const GpSurfaceDesc desc = { .format = GP_A32B32G32R32F,
                                 .width = SIDE * CELLS,
                                 .height = SIDE * CELLS };
    assert_int_equal(gp_surface_create(&desc, &pass.color[0].surface, NULL), GP_OK);
    for (int i = 0; i < DRAWS; i++) {
        draws[i] = (GpDraw){
            .program = programs[i % 3],
            .uniforms = &uniforms[i / 3 % 2],
            .geometry = { .vertex_count = 3,
                          .streams = { [GP_POSITION] = { corners[0], sizeof corners[0], 4,
                                                         GP_FLOAT32 },
                                       [GP_COLOR] = { corners[0] + 4, sizeof corners[0], 4,
                                                      GP_FLOAT32 },
                                       [GP_TEXCOORD0] = { corners[0] + 8, sizeof corners[0], 2,
                                                          GP_FLOAT32 } } },
            .viewport = { .x = (float)(i % CELLS * SIDE),
                          .y = (float)(i / CELLS * SIDE),
                          .width = SIDE,
                          .height = SIDE },
        };
        for (int slot = 0; slot < 3; slot++)
            draws[i].textures[slot] =
                (GpTexture){ textures[(i / 6 + slot) % SIZES], sampler_of(i + 77 * slot, compare) };
    }
    run_seed_everywhere(&pass, (int)format);
    gp_surface_destroy(&pass.color[0].surface);
    for (int i = 0; i < SIZES; i++)
        gp_surface_destroy(&textures[i]);
}

static void every_format_by_every_sampler(void **state)
{
    (void)state;
    for (GpFormat format = GP_FORMAT_NONE + 1; format < GP_FORMATS; format++)
        read_everywhere(format, false);
}

static void every_depth_format_compared(void **state)
{
    (void)state;
    for (GpFormat format = GP_FORMAT_NONE + 1; format < GP_FORMATS; format++)
        if (gp_format_info(format)->is_depth)
            read_everywhere(format, true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_format_by_every_sampler),
        cmocka_unit_test(every_depth_format_compared),
    };
    return cmocka_run_group_tests_name("fast textures", tests, NULL, NULL);
}
