/* Points whose values are flat, which the fast executor packs side by side where bits are combined:
 * of many sides, overlapping, across tiles, in draws of any length and state, at every width of
 * lanes. */
#include <glasspipe/glasspipe.h>
#include "tests/shaders/flat_points.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { WIDTH = 150, HEIGHT = 140, POINTS = 700, SEEDS = 60, MOST_DRAWS = 4 };

static const FlatPointsUniforms uniforms = { { WIDTH, HEIGHT } };

typedef struct Point {
    float position[3], color[4], size;
} Point;

typedef struct Drawing {
    Point points[MOST_DRAWS][POINTS];
    uint32_t indices[MOST_DRAWS][POINTS];
    GpDraw draws[MOST_DRAWS];
    GpSurface *surfaces[GP_MAX_TARGETS + 1];
    GpPass pass;
} Drawing;

/* --- frames ----------------------------------------------------------------------------------- */

/* Mostly a few pixels; some vanish, some are wider than lanes, some than tiles. */
static float point_size(Random *r)
{
    switch (random_int(r, 0, 9)) {
    case 0:
        return 0;
    case 1:
        return random_float(r, -1, 0.7f);
    case 2:
        return random_float(r, 4, 30);
    case 3:
        return random_int(r, 0, 9) ? 3 : random_float(r, 50, 200);
    default:
        return (float)random_int(r, 1, 5);
    }
}

/* Neighbours lie close to each other; some points are outside, or no numbers. */
static void set_points(Random *r, Point *points)
{
    float middle[2] = { WIDTH / 2, HEIGHT / 2 };
    for (int i = 0; i < POINTS; i++) {
        if (random_int(r, 0, 20) == 0) {
            middle[0] = random_float(r, -5, WIDTH + 5);
            middle[1] = random_float(r, -5, HEIGHT + 5);
        }
        Point *p = &points[i];
        p->position[0] = middle[0] + random_float(r, -8, 8);
        p->position[1] = middle[1] + random_float(r, -8, 8);
        p->position[2] = random_int(r, 0, 30) ? random_float(r, 0, 1) : 2;
        for (int c = 0; c < 4; c++)
            p->color[c] = random_float(r, -0.2f, 1.2f);
        p->size = random_int(r, 0, 40) ? point_size(r) : __builtin_nanf("");
    }
}

static GpBlend random_blend(Random *r)
{
    static const GpBlendOp ops[] = { GP_BLEND_LOGIC_OR, GP_BLEND_LOGIC_XOR, GP_BLEND_LOGIC_AND,
                                     GP_BLEND_LOGIC_OR, GP_BLEND_LOGIC_XOR, GP_BLEND_ADD,
                                     GP_BLEND_OFF };
    GpBlend blend = { .op = ops[random_int(r, 0, GP_COUNT(ops) - 1)],
                      .src = GP_ONE,
                      .dst = GP_ONE };
    if (random_int(r, 0, 4) == 0)
        blend.keep = (uint8_t)random_int(r, 0, 15);
    if (blend.op == GP_BLEND_ADD && random_int(r, 0, 1)) {
        blend.alpha_op = GP_BLEND_ADD;
        blend.alpha_src = blend.alpha_dst = GP_ONE;
    }
    return blend;
}

static void set_draw(Random *r, Drawing *drawing, int number, bool four, bool has_depth)
{
    GpDraw *draw = &drawing->draws[number];
    const Point *points = drawing->points[number];
    const bool discards = random_int(r, 0, 1);
    *draw = (GpDraw){
        .program = four       ? &flat_points_targets4
                   : discards ? &flat_points_discard
                              : &flat_points,
        .uniforms = &uniforms,
        .geometry = { .primitive = GP_POINTS, .vertex_count = (uint32_t)random_int(r, 1, POINTS) },
    };
    GpStream *streams = draw->geometry.streams;
    streams[GP_POSITION] = (GpStream){ points->position, sizeof *points, 3, GP_FLOAT32 };
    streams[GP_COLOR] = (GpStream){ points->color, sizeof *points, 4, GP_FLOAT32 };
    streams[GP_POINT_SIZE] = (GpStream){ &points->size, sizeof *points, 1, GP_FLOAT32 };
    if (random_int(r, 0, 4) == 0)
        streams[GP_COLOR].type = GP_UNORM8;
    if (random_int(r, 0, 5) == 0) {
        draw->geometry.indices = drawing->indices[number];
        draw->geometry.index_count = draw->geometry.vertex_count;
        for (uint32_t i = 0; i < draw->geometry.vertex_count; i++)
            drawing->indices[number][i] = i * 37 % draw->geometry.vertex_count;
    }
    for (int t = 0; t < (four ? 4 : 1); t++)
        draw->state.blend[t] = random_blend(r);
    if (has_depth && random_int(r, 0, 1))
        draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    if (random_int(r, 0, 5) == 0)
        draw->state.alpha_test = (GpAlphaTest){ GP_GREATER, 100 };
    if (random_int(r, 0, 5) == 0) {
        draw->state.raster.scissor = true;
        draw->state.raster.scissor_x0 = 13;
        draw->state.raster.scissor_y0 = 7;
        draw->state.raster.scissor_x1 = 131;
        draw->state.raster.scissor_y1 = 99;
    }
}

static void create_drawing(Random *r, Drawing *drawing)
{
    const bool four = random_int(r, 0, 1), has_depth = random_int(r, 0, 3) == 0;
    const int targets = four ? 4 : 1;
    memset(drawing, 0, sizeof *drawing);
    drawing->pass.name = "points";
    for (int i = 0; i <= targets; i++) {
        const GpSurfaceDesc desc = { .format = i < targets ? GP_A8R8G8B8 : GP_D24S8,
                                     .width = WIDTH,
                                     .height = HEIGHT };
        assert_int_equal(gp_surface_create(&desc, &drawing->surfaces[i], NULL), GP_OK);
        if (i < targets)
            drawing->pass.color[i] =
                (GpColorTarget){ drawing->surfaces[i], true, { 0.2f, 0.6f, 0.1f, 0.9f } };
        else if (has_depth)
            drawing->pass.depth = (GpDepthTarget){ .surface = drawing->surfaces[i],
                                                   .clear_depth = true,
                                                   .depth_value = 1 };
    }
    drawing->pass.draws = drawing->draws;
    drawing->pass.draw_count = (uint32_t)random_int(r, 1, MOST_DRAWS);
    for (uint32_t i = 0; i < drawing->pass.draw_count; i++) {
        set_points(r, drawing->points[i]);
        set_draw(r, drawing, (int)i, four, has_depth);
    }
}

static void destroy_drawing(Drawing *drawing)
{
    for (size_t i = 0; i < GP_COUNT(drawing->surfaces); i++)
        gp_surface_destroy(&drawing->surfaces[i]);
}

/* --- runs ------------------------------------------------------------------------------------- */

static void flat_points_are_the_references(void **state)
{
    (void)state;
    static Drawing drawing;
    for (int seed = 0; seed < SEEDS; seed++) {
        Random random = { (uint64_t)seed };
        create_drawing(&random, &drawing);
        run_seed_everywhere(&drawing.pass, seed);
        destroy_drawing(&drawing);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(flat_points_are_the_references) };
    return cmocka_run_group_tests_name("fast points", tests, NULL, NULL);
}
