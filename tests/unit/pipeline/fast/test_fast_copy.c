/* Words that a draw brings from one surface into another: as the reference executor does it through
 * floats. */
#include "apps/techniques/voxel/volume/flat_texture.h"
#include "shaders_c/common/texel_copy.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { MOST = 200 };

typedef struct RunStatistics {
    GpSurface *from, *to;
    GpDraw draw;
    bool both; /* the surface that is read is a target of the pass before */
} RunStatistics;

static void fill(Random *random, GpSurface *surface)
{
    uint8_t *texels = surface->level[0].texels;
    for (size_t i = 0; i < (size_t)surface->width * surface->height * 4; i++)
        texels[i] = (uint8_t)random_bits(random);
}

static RunStatistics make_frame(Random *random)
{
    static const GpBlendOp ops[] = { GP_BLEND_LOGIC_AND, GP_BLEND_LOGIC_OR, GP_BLEND_LOGIC_XOR,
                                     GP_BLEND_OFF, GP_BLEND_MAX };
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8,
                                 .width = (uint32_t)random_int(random, 1, MOST),
                                 .height = (uint32_t)random_int(random, 1, MOST) };
    RunStatistics statistics = { .both = random_int(random, 0, 3) > 0 };
    GpError error;
    assert_int_equal(gp_surface_create(&desc, &statistics.from, &error), GP_OK);
    assert_int_equal(gp_surface_create(&desc, &statistics.to, &error), GP_OK);
    fill(random, statistics.from);
    fill(random, statistics.to);
    statistics.draw = (GpDraw){ .program = random_int(random, 0, 3) ? &texel_copy_program
                                                                    : &texel_complement_program,
                                .uniforms = "",
                                .geometry = flat_texture_cover };
    statistics.draw.textures[0].surface = statistics.from;
    statistics.draw.state.blend[0].op = ops[random_int(random, 0, (int32_t)GP_COUNT(ops) - 1)];
    if (random_int(random, 0, 2) == 0)
        statistics.draw.state.blend[0].keep = (uint8_t)random_int(random, 1, 14);
    if (random_int(random, 0, 1)) {
        GpRasterState *raster = &statistics.draw.state.raster;
        raster->scissor = true;
        raster->scissor_x0 = random_int(random, 0, (int32_t)desc.width - 1);
        raster->scissor_y0 = random_int(random, 0, (int32_t)desc.height - 1);
        raster->scissor_x1 = random_int(random, raster->scissor_x0 + 1, (int32_t)desc.width);
        raster->scissor_y1 = random_int(random, raster->scissor_y0 + 1, (int32_t)desc.height);
    }
    return statistics;
}

/* The hash of what the frame makes of its target, which is left as it was. */
static uint64_t run(const RunStatistics *statistics, const GpDeviceDesc *desc)
{
    static uint8_t before[MOST * MOST * 4];
    const size_t bytes = (size_t)statistics->to->width * statistics->to->height * 4;
    const GpDraw draws[2] = { statistics->draw,
                              statistics->draw }; /* the second in a layer over the first */
    const GpPass passes[2] = {
        { .name = "operand", .color = { { .surface = statistics->from } } },
        { .name = "copy",
          .color = { { .surface = statistics->to } },
          .draws = draws,
          .draw_count = 2 },
    };
    const GpList list = { passes + !statistics->both, 1 + statistics->both };
    GpDevice *device = NULL;
    GpError error = { "" };
    if (gp_device_create(desc, &device, &error) == GP_ERROR_UNSUPPORTED)
        return 0;
    memcpy(before, statistics->to->level[0].texels, bytes);
    if (gp_device_run(device, &list, &error))
        fail_msg("%s", error.text);
    gp_device_destroy(&device);
    uint64_t hash = gp_surface_hash(statistics->to);
    memcpy(statistics->to->level[0].texels, before, bytes);
    return hash;
}

static void copies_are_those_of_the_reference(void **state)
{
    (void)state;
    static const GpDeviceDesc devices[] = { { .threads = 2 },
                                            { .threads = 1, .isa = "lanes4" },
                                            { .threads = 1, .isa = "lanes8" },
                                            { .threads = 3, .isa = "lanes16" } };
    Random random = { 77 };
    for (int i = 0; i < 120; i++) {
        RunStatistics statistics = make_frame(&random);
        const uint64_t expected =
            run(&statistics, &(GpDeviceDesc){ .executor = GP_EXECUTOR_REFERENCE });
        for (size_t d = 0; d < GP_COUNT(devices); d++) {
            const uint64_t hash = run(&statistics, &devices[d]);
            if (hash && hash != expected)
                fail_msg("frame %d, device %zu: other bits", i, d);
        }
        gp_surface_destroy(&statistics.from);
        gp_surface_destroy(&statistics.to);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(copies_are_those_of_the_reference) };
    return cmocka_run_group_tests_name("copies of words", tests, NULL, NULL);
}
