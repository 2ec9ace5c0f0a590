/* Targets that sprites are added to stand as sums until planes are wanted: passes that add, blend,
 * read in place and clear, one after the other in one group, on every device and of every format of
 * floats. What no pass writes keeps its bits, be they NaNs that no store makes (R31). */
#include "shaders_c/common/texel_copy.h"
#include "tests/shaders/flat_points.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <stdio.h>

enum { WIDTH = 150, HEIGHT = 100, POINTS = 150, SURFACES = 3, PASSES = 14, SEEDS = 60 };

static const FlatPointsUniforms uniforms = { { WIDTH, HEIGHT } };
static const float cover[3][3] = { { -1, 1, 0 }, { 3, 1, 0 }, { -1, -3, 0 } };
static const float part[3][3] = { { -1, 0.3f, 0 }, { 0.9f, 0.7f, 0.5f }, { -0.2f, -0.9f, 0.2f } };
static const GpFormat formats[] = { GP_R32F, GP_G16R16F, GP_A16B16G16R16F, GP_A32B32G32R32F,
                                    GP_A32B32G32R32F };

typedef struct Point {
    float position[3], color[4], size;
} Point;

typedef struct Drawing {
    Point points[PASSES][POINTS];
    GpSurface *surfaces[SURFACES];
    GpRect rects[PASSES];
    GpDraw draws[PASSES][2];
    GpPass passes[PASSES];
} Drawing;

static void set_points(Random *r, Point *points)
{
    const float at[2] = { random_float(r, 0, WIDTH), random_float(r, 0, HEIGHT) };
    for (int i = 0; i < POINTS; i++) {
        points[i] = (Point){ .position = { at[0] + random_float(r, -30, 30),
                                           at[1] + random_float(r, -30, 30), 0.5f },
                             .size = random_float(r, 1, 9) };
        for (int c = 0; c < 4; c++)
            points[i].color[c] = random_float(r, -0.5f, 1.5f);
    }
}

static GpBlend random_blend(Random *r)
{
    static const GpBlend blends[] = {
        { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE },
        { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE },
        { .op = GP_BLEND_OFF },
        { .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA, .dst = GP_INV_SRC_ALPHA },
        { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE, .keep = 4 },
        { .op = GP_BLEND_MAX },
    };
    return blends[random_int(r, 0, GP_COUNT(blends) - 1)];
}

static void set_sprites(Random *r, Drawing *drawing, int number, GpDraw *draw)
{
    const Point *points = drawing->points[number];
    *draw = (GpDraw){
        .program = &flat_points,
        .uniforms = &uniforms,
        .geometry = { .primitive = GP_POINTS,
                      .vertex_count = (uint32_t)random_int(r, 1, POINTS),
                      .streams = { [GP_POSITION] = { points->position, sizeof *points, 3,
                                                     GP_FLOAT32 },
                                   [GP_COLOR] = { points->color, sizeof *points, 4, GP_FLOAT32 },
                                   [GP_POINT_SIZE] = { &points->size, sizeof *points, 1,
                                                       GP_FLOAT32 } } },
    };
}

static void set_copy(Random *r, const GpSurface *from, GpDraw *draw)
{
    const float(*corners)[3] = random_int(r, 0, 1) ? cover : part;
    *draw = (GpDraw){
        .program = &texel_copy_program,
        .geometry = { .vertex_count = 3,
                      .streams = { [GP_POSITION] = { corners, sizeof corners[0], 3,
                                                     GP_FLOAT32 } } },
    };
    draw->textures[0].surface = from;
}

/* Adds to one surface or brings another there, or both; beside it at times stands a target that
 * nothing is drawn to. */
static void set_pass(Random *r, Drawing *drawing, int number)
{
    GpPass *pass = &drawing->passes[number];
    const int target = random_int(r, 0, SURFACES - 1);
    const int other = (target + random_int(r, 1, SURFACES - 1)) % SURFACES;
    const bool two = random_int(r, 0, 2) == 0;
    *pass = (GpPass){ .draws = drawing->draws[number] };
    pass->color[0].surface = drawing->surfaces[target];
    if (two)
        pass->color[1].surface = drawing->surfaces[3 - target - other];
    for (int t = 0; t <= (int)two; t++) {
        pass->color[t].clear = random_int(r, 0, 1);
        for (int c = 0; c < 4; c++)
            pass->color[t].clear_color[c] = random_float(r, -1, 1);
    }
    if (pass->color[0].clear && random_int(r, 0, 3) == 0) {
        drawing->rects[number] =
            (GpRect){ 3, 5, random_int(r, 4, WIDTH), random_int(r, 6, HEIGHT) };
        pass->clear_rects = &drawing->rects[number];
        pass->clear_rect_count = 1;
    }
    if (random_int(r, 0, 5) == 0)
        pass->order = GP_ORDER_DEPTH_NEAR_FIRST;
    pass->draw_count = (uint32_t)random_int(r, 1, 2);
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        GpDraw *draw = &drawing->draws[number][i];
        if (random_int(r, 0, 1))
            set_sprites(r, drawing, number, draw);
        else
            set_copy(r, drawing->surfaces[other], draw);
        draw->state.blend[0] = random_blend(r);
    }
}

/* Any bits, of which many are no numbers. */
static void fill_with_bits(Random *r, GpSurface *surface)
{
    const GpLevel *level = &surface->level[0];
    const bool halves = surface->format == GP_G16R16F || surface->format == GP_A16B16G16R16F;
    for (size_t at = 0; at < level->pitch * level->height; at += 4) {
        uint32_t word = random_word(r);
        if (random_int(r, 0, 2) == 0)
            word |= halves ? 0x7c00 : 0x7f800000;
        memcpy(level->texels + at, &word, sizeof word);
    }
}

static void draw_seed(Drawing *drawing, int seed)
{
    Random r = { (uint64_t)seed };
    GpError error;
    const GpSurfaceDesc desc = { .format = formats[seed % (int)GP_COUNT(formats)],
                                 .width = WIDTH,
                                 .height = HEIGHT };
    for (int i = 0; i < SURFACES; i++)
        assert_int_equal(gp_surface_create(&desc, &drawing->surfaces[i], NULL), GP_OK);
    for (int i = 0; i < PASSES; i++) {
        set_points(&r, drawing->points[i]);
        set_pass(&r, drawing, i);
    }
    const GpList list = { drawing->passes, PASSES };
    if (gp_list_check(&list, &error))
        fail_msg("seed %d: %s", seed, error.text);
    char what[32];
    snprintf(what, sizeof what, "seed %d", seed);
    for (int i = 0; i < SURFACES; i++)
        if (seed / (int)GP_COUNT(formats) % 2)
            fill_with_bits(&r, drawing->surfaces[i]);
        else
            gp_surface_clear_color(drawing->surfaces[i], (float[]){ 0.5f, 0.25f, 0.75f, 0.125f });
    run_list_everywhere(&list, what);
    for (int i = 0; i < SURFACES; i++)
        gp_surface_destroy(&drawing->surfaces[i]);
}

static void passes_that_add_read_and_clear_in_turn(void **state)
{
    (void)state;
    static Drawing drawing;
    for (int seed = 1; seed <= SEEDS; seed++)
        draw_seed(&drawing, seed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(passes_that_add_read_and_clear_in_turn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
