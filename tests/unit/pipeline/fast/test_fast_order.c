/* Draws in which the fast executor changes the order of its work, where only an order that shows
 * would be wrong: cut-outs of equal depths filled front to back, and layers blended a few pixels at
 * a time. */
#include <glasspipe/glasspipe.h>
#include "shaders_c/bench/lookup.h"
#include "shaders_c/common/texel_copy.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { SIZE = 90, QUADS = 60, SEEDS = 60, TEXELS = 64 }; /* two tiles a side, one of them cut */

static float position[QUADS * 4][3], texcoord[QUADS * 4][2];
static uint32_t indices[QUADS * 6];

static GpSurface *create(GpFormat format, uint32_t size)
{
    const GpSurfaceDesc desc = { .format = format, .width = size, .height = size };
    GpSurface *surface = NULL;
    assert_int_equal(gp_surface_create(&desc, &surface, NULL), GP_OK);
    return surface;
}

static void set_quad(int quad, const float middle[2], float size, float depth, float slant)
{
    static const float corner[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    static const uint32_t order[6] = { 0, 1, 2, 0, 2, 3 };
    for (int k = 0; k < 4; k++) {
        float *p = position[4 * quad + k];
        p[0] = middle[0] + size * corner[k][0];
        p[1] = middle[1] + size * corner[k][1];
        p[2] = depth + slant * corner[k][0];
        texcoord[4 * quad + k][0] = 2 * size * corner[k][0] + (float)quad / QUADS;
        texcoord[4 * quad + k][1] = 2 * size * corner[k][1];
    }
    for (int k = 0; k < 6; k++)
        indices[6 * quad + k] = (uint32_t)(4 * quad) + order[k];
}

static GpGeometry quads(uint32_t count)
{
    GpGeometry geometry = { .vertex_count = 4 * count,
                            .indices = indices,
                            .index_count = 6 * count };
    geometry.streams[GP_POSITION] = (GpStream){ position, sizeof position[0], 3, GP_FLOAT32 };
    geometry.streams[GP_TEXCOORD0] = (GpStream){ texcoord, sizeof texcoord[0], 2, GP_FLOAT32 };
    return geometry;
}

/* Hash of the last pass's targets. */
static uint64_t run(const GpPass *passes, uint32_t count, const GpDeviceDesc *desc)
{
    run_list_on(desc, &(GpList){ passes, count });
    return hash_targets(&(GpList){ &passes[count - 1], 1 });
}

static void assert_same(const GpPass *passes, uint32_t count, int seed)
{
    const uint64_t expected = run(passes, count, device_here(0));
    if (run(passes, count, &(GpDeviceDesc){ .threads = 1 }) != expected)
        fail_msg("seed %d: the executors differ", seed);
}

/* --- equal depths ----------------------------------------------------------------------------- */

static GpSurface *checker(Random *random)
{
    GpSurface *texture = create(GP_A8R8G8B8, TEXELS);
    for (uint32_t y = 0; y < TEXELS; y++)
        for (uint32_t x = 0; x < TEXELS; x++) {
            uint32_t opaque = (x / 8 ^ y / 8) & 1 ? 0xff000000u : 0;
            uint32_t texel = opaque | ((uint32_t)random_bits(random) & 0xffffff);
            memcpy(gp_surface_texel(&texture->level[0], 4, x, y), &texel, sizeof texel);
        }
    return texture;
}

/* Small and large quads of five depths, level or slanted; in every third frame nearer and
 * nearer. */
static void set_cut_outs(Random *random, int seed)
{
    for (int i = 0; i < QUADS; i++) {
        const float middle[2] = { random_float(random, -1, 1), random_float(random, -1, 1) };
        bool is_small = random_int(random, 0, 3) == 0, slanted = random_int(random, 0, 1);
        float size = is_small ? random_float(random, 0.1f, 0.3f) : random_float(random, 0.5f, 2);
        float depth = (float)random_int(random, 1, 5) / 8;
        float slant = seed % 3 == 1 && slanted ? random_float(random, -0.1f, 0.1f) : 0;
        set_quad(i, middle, size, seed % 3 == 2 ? 0.9f - 0.8f * (float)i / QUADS : depth, slant);
    }
}

static void equal_depths_keep_their_order(void **state)
{
    (void)state;
    static const GpFormat formats[] = { GP_D32F, GP_D24S8, GP_D16 };
    for (int seed = 0; seed < SEEDS; seed++) {
        Random random = { (uint64_t)seed };
        GpSurface *texture = checker(&random), *color = create(GP_A8R8G8B8, SIZE);
        GpSurface *depth = create(formats[seed / 3 % 3], SIZE);
        set_cut_outs(&random, seed);
        /* where filters differ, shaders look at quads of pixels */
        const GpSampler sampler = { .mag = seed / 2 % 2 ? GP_LINEAR : GP_POINT };
        GpDraw draw = { .program = &cut_out_program,
                        .geometry = quads(QUADS),
                        .textures[0] = { .surface = texture, .sampler = sampler } };
        draw.state.depth =
            (GpDepthState){ .test = seed % 2 ? GP_LESS : GP_LESS_EQUAL, .write = true };
        const GpPass pass = { .name = "cut-outs",
                              .color[0] = { .surface = color, .clear = true },
                              .depth = { .surface = depth, .clear_depth = true, .depth_value = 1 },
                              .draws = &draw,
                              .draw_count = 1 };
        assert_same(&pass, 1, seed);
        gp_surface_destroy(&texture);
        gp_surface_destroy(&color);
        gp_surface_destroy(&depth);
    }
}

/* --- layers of one place ---------------------------------------------------------------------- */

/* Quads of one size blended over each other, each showing what another surface has in its place: in
 * odd frames a picture, in even ones the colour that it was cleared to, and nothing else. */
static void layers_are_blended_in_order(void **state)
{
    (void)state;
    static const GpFormat formats[] = { GP_A8R8G8B8, GP_A16B16G16R16F, GP_A32B32G32R32F };
    static const GpBlend blends[] = {
        { .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA, .dst = GP_INV_SRC_ALPHA },
        { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE },
        { .op = GP_BLEND_ADD, .src = GP_INV_DEST_ALPHA, .dst = GP_ONE },
        { .op = GP_BLEND_REV_SUBTRACT, .src = GP_ONE, .dst = GP_SRC_COLOR, .keep = 4 },
        { .op = GP_BLEND_MAX },
    };
    for (int seed = 0; seed < SEEDS; seed++) {
        Random random = { (uint64_t)seed };
        GpSurface *shown = create(formats[seed / 2 % 3], SIZE);
        GpSurface *color = create(formats[seed / 6 % 3], SIZE), *texture = checker(&random);
        set_cut_outs(&random, 0);
        uint32_t layers = 1 + (uint32_t)seed % 20;
        const GpDraw picture = { .program = &cut_out_program,
                                 .geometry = quads(QUADS),
                                 .textures[0] = { .surface = texture } };
        GpDraw layer = { .program = &texel_copy_program,
                         .geometry = quads(1),
                         .state.blend[0] = blends[seed % 5],
                         .textures[0] = { .surface = shown } };
        uint32_t repeated[20 * 6];
        for (uint32_t i = 0; i < layers * 6; i++)
            repeated[i] = indices[i % 6];
        layer.geometry.indices = repeated;
        layer.geometry.index_count = layers * 6;
        const GpPass passes[2] = {
            { .name = "shown",
              .color[0] = { shown, true, { 0.3f, 0.1f, 0.7f, 0.4f } },
              .draws = &picture,
              .draw_count = (uint32_t)seed % 2 },
            { .name = "layers",
              .color[0] = { color, true, { 0.2f, 0.6f, 0.1f, 0.1f } },
              .draws = &layer,
              .draw_count = 1 },
        };
        assert_same(passes, 2, seed);
        gp_surface_destroy(&shown);
        gp_surface_destroy(&color);
        gp_surface_destroy(&texture);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_depths_keep_their_order),
        cmocka_unit_test(layers_are_blended_in_order),
    };
    return cmocka_run_group_tests_name("fast order", tests, NULL, NULL);
}
