/* Words that a draw brings from one surface into another: as the reference executor does it through
 * floats. */
#include "apps/techniques/voxel/volume/flat_texture.h"
#include "shaders_c/common/texel_copy.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { MOST = 200 };

typedef struct Copy {
    GpSurface *from, *to;
    GpDraw draw;
    bool both; /* the surface that is read is a target of the pass before */
} Copy;

static void fill(Random *random, GpSurface *surface)
{
    uint8_t *texels = surface->level[0].texels;
    for (size_t i = 0; i < (size_t)surface->width * surface->height * 4; i++)
        texels[i] = (uint8_t)random_bits(random);
}

static Copy make_copy(Random *random)
{
    static const GpBlendOp ops[] = { GP_BLEND_LOGIC_AND, GP_BLEND_LOGIC_OR, GP_BLEND_LOGIC_XOR,
                                     GP_BLEND_OFF, GP_BLEND_MAX };
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8,
                                 .width = (uint32_t)random_int(random, 1, MOST),
                                 .height = (uint32_t)random_int(random, 1, MOST) };
    Copy copy = { .both = random_int(random, 0, 3) > 0 };
    GpError error;
    assert_int_equal(gp_surface_create(&desc, &copy.from, &error), GP_OK);
    assert_int_equal(gp_surface_create(&desc, &copy.to, &error), GP_OK);
    fill(random, copy.from);
    fill(random, copy.to);
    copy.draw = (GpDraw){ .program = random_int(random, 0, 3) ? &texel_copy_program
                                                              : &texel_complement_program,
                          .uniforms = "",
                          .geometry = flat_texture_cover };
    copy.draw.textures[0].surface = copy.from;
    copy.draw.state.blend[0].op = ops[random_int(random, 0, (int32_t)GP_COUNT(ops) - 1)];
    if (random_int(random, 0, 2) == 0)
        copy.draw.state.blend[0].keep = (uint8_t)random_int(random, 1, 14);
    if (random_int(random, 0, 1)) {
        GpRasterState *raster = &copy.draw.state.raster;
        raster->scissor = true;
        raster->scissor_x0 = random_int(random, 0, (int32_t)desc.width - 1);
        raster->scissor_y0 = random_int(random, 0, (int32_t)desc.height - 1);
        raster->scissor_x1 = random_int(random, raster->scissor_x0 + 1, (int32_t)desc.width);
        raster->scissor_y1 = random_int(random, raster->scissor_y0 + 1, (int32_t)desc.height);
    }
    return copy;
}

/* The hash of what the copy makes of its target, which is left as it was. */
static uint64_t run(const Copy *copy, const GpDeviceDesc *desc)
{
    static uint8_t before[MOST * MOST * 4];
    const size_t bytes = (size_t)copy->to->width * copy->to->height * 4;
    const GpDraw draws[2] = { copy->draw, copy->draw }; /* the second in a layer over the first */
    const GpPass passes[2] = {
        { .name = "operand", .color = { { .surface = copy->from } } },
        { .name = "copy", .color = { { .surface = copy->to } }, .draws = draws, .draw_count = 2 },
    };
    const GpList list = { passes + !copy->both, 1 + copy->both };
    memcpy(before, copy->to->level[0].texels, bytes);
    run_list_on(desc, &list);
    uint64_t hash = gp_surface_hash(copy->to);
    memcpy(copy->to->level[0].texels, before, bytes);
    return hash;
}

static void copies_are_those_of_the_reference(void **state)
{
    (void)state;
    Random random = { 77 };
    for (int i = 0; i < 120; i++) {
        Copy copy = make_copy(&random);
        const uint64_t expected = run(&copy, device_here(0));
        for (size_t d = 1; device_here(d); d++)
            if (run(&copy, device_here(d)) != expected)
                fail_msg("copy %d, %s: other bits", i, device_name(device_here(d)));
        gp_surface_destroy(&copy.from);
        gp_surface_destroy(&copy.to);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(copies_are_those_of_the_reference) };
    return cmocka_run_group_tests_name("copies of words", tests, NULL, NULL);
}
