/* Sprites that add to targets of floats, that only leave their depth, or that are one pixel each,
 * which the fast executor draws by ways of their own: overlapping, on the edges of pixels, tiles
 * and targets, behind the eye, behind others, under every test, in draws of any length, at every
 * width of lanes. */
#include <glasspipe/glasspipe.h>
#include "tests/shaders/splat_points.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { WIDTH = 150, HEIGHT = 140, POINTS = 600, SEEDS = 60, MOST_DRAWS = 4 };

static const SplatPointsUniforms uniforms = { { WIDTH, HEIGHT } };

typedef struct Point {
    float position[4], color[4], size;
} Point;

typedef struct Drawing {
    Point points[MOST_DRAWS][POINTS];
    uint32_t indices[MOST_DRAWS][POINTS];
    GpDraw draws[MOST_DRAWS];
    GpSurface *surfaces[3]; /* the last has depth */
    GpPass pass;
} Drawing;

/* --- frames ----------------------------------------------------------------------------------- */

/* Mostly as splats are; some vanish, some are wider than lanes, some than tiles. */
static float point_size(Random *r)
{
    switch (random_int(r, 0, 9)) {
    case 0:
        return 1;
    case 1:
        return random_float(r, -1, 1.5f);
    case 2:
        return random_int(r, 0, 9) ? random_float(r, 9, 40) : random_float(r, 50, 200);
    case 3:
        return random_int(r, 0, 9) ? 3 : __builtin_nanf("");
    default:
        return random_float(r, 2, 9);
    }
}

/* Neighbours lie on each other; many stand on edges and centres of pixels, some outside, in front
 * of the eye's plane or behind it, or past the far one. Few depths, so that some are equal. */
static void set_points(Random *r, Point *points)
{
    float middle[2] = { WIDTH / 2, HEIGHT / 2 };
    for (int i = 0; i < POINTS; i++) {
        if (random_int(r, 0, 20) == 0) {
            middle[0] = random_float(r, -5, WIDTH + 5);
            middle[1] = random_float(r, -5, HEIGHT + 5);
        }
        Point *p = &points[i];
        const bool on_grid = random_int(r, 0, 3) == 0;
        for (int k = 0; k < 2; k++) {
            p->position[k] = middle[k] + random_float(r, -6, 6);
            if (on_grid)
                p->position[k] = (float)(int)p->position[k] + 0.25f * (float)random_int(r, 0, 3);
        }
        p->position[2] = random_int(r, 0, 30) ? (float)random_int(r, 0, 8) / 8 : 2;
        p->position[3] = random_int(r, 0, 15) ? random_float(r, 0.5f, 8) : random_float(r, -2, 0);
        for (int c = 0; c < 4; c++)
            p->color[c] = random_int(r, 0, 99) ? random_float(r, -0.2f, 4) : 60000;
        p->size = point_size(r);
    }
}

static GpDepthState random_depth(Random *r)
{
    static const GpCompare tests[] = { GP_LESS,    GP_LESS_EQUAL, GP_LESS,  GP_LESS_EQUAL,
                                       GP_GREATER, GP_EQUAL,      GP_ALWAYS };
    if (random_int(r, 0, 5) == 0)
        return (GpDepthState){ .test = GP_LESS_EQUAL,
                               .write = true,
                               .ternary = true,
                               .epsilon = random_int(r, 0, 1) ? 0.2f : 0 };
    return (GpDepthState){ .test = tests[random_int(r, 0, GP_COUNT(tests) - 1)],
                           .write = random_int(r, 0, 1) };
}

/* How a draw treats its targets: it adds to them, blends in some other way, replaces, or leaves
 * them. */
static GpBlend random_blend(Random *r)
{
    switch (random_int(r, 0, 8)) {
    case 0:
        return (GpBlend){ .op = GP_BLEND_OFF };
    case 1:
        return (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_INV_SRC_ALPHA };
    case 2:
        return (GpBlend){ .op = GP_BLEND_OFF, .keep = 15 };
    case 3:
        return (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE, .keep = 4 };
    case 4: /* of two channels alpha is none, but there is a rule for it */
        return (
            GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE, .alpha_op = GP_BLEND_MAX };
    default:
        return (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };
    }
}

static void set_draw(Random *r, Drawing *drawing, int number, int targets)
{
    static const GpProgram *const programs[] = { &splat_points, &splat_points_plain };
    GpDraw *draw = &drawing->draws[number];
    const Point *points = drawing->points[number];
    *draw = (GpDraw){
        .program = targets == 2 ? &splat_points_targets2 : programs[random_int(r, 0, 1)],
        .uniforms = &uniforms,
        .geometry = { .primitive = GP_POINTS, .vertex_count = (uint32_t)random_int(r, 1, POINTS) },
    };
    GpStream *streams = draw->geometry.streams;
    streams[GP_POSITION] = (GpStream){ points->position, sizeof *points, 4, GP_FLOAT32 };
    streams[GP_COLOR] = (GpStream){ points->color, sizeof *points, 4, GP_FLOAT32 };
    streams[GP_POINT_SIZE] = (GpStream){ &points->size, sizeof *points, 1, GP_FLOAT32 };
    if (random_int(r, 0, 5) == 0) {
        draw->geometry.indices = drawing->indices[number];
        draw->geometry.index_count = draw->geometry.vertex_count;
        for (uint32_t i = 0; i < draw->geometry.vertex_count; i++)
            drawing->indices[number][i] = i * 37 % draw->geometry.vertex_count;
    }
    const GpBlend blend = random_blend(r);
    for (int t = 0; t < targets; t++)
        draw->state.blend[t] = random_int(r, 0, 9) ? blend : random_blend(r);
    if (!drawing->pass.depth.surface)
        return;
    draw->state.depth = random_depth(r);
    if (drawing->pass.depth.surface->format == GP_D24S8 && random_int(r, 0, 5) == 0)
        draw->state.stencil =
            (GpStencilState){ .enable = true,
                              .front = { .test = GP_LESS_EQUAL, .pass = GP_STENCIL_INCR_SAT },
                              .reference = 3 };
}

static void create_drawing(Random *r, Drawing *drawing)
{
    static const GpFormat colors[] = { GP_A32B32G32R32F, GP_A16B16G16R16F, GP_G16R16F, GP_R32F,
                                       GP_A8R8G8B8 };
    static const GpFormat depths[] = { GP_D32F, GP_D24S8, GP_D16 };
    const int targets = random_int(r, 1, 2);
    memset(drawing, 0, sizeof *drawing);
    drawing->pass.name = "sprites";
    for (int i = 0; i < 3; i++) {
        const GpFormat format = i < 2 ? colors[random_int(r, 0, GP_COUNT(colors) - 1)]
                                      : depths[random_int(r, 0, GP_COUNT(depths) - 1)];
        const GpSurfaceDesc desc = { .format = format, .width = WIDTH, .height = HEIGHT };
        assert_int_equal(gp_surface_create(&desc, &drawing->surfaces[i], NULL), GP_OK);
        if (i < targets)
            drawing->pass.color[i] =
                (GpColorTarget){ drawing->surfaces[i], true, { 0.2f, 0.6f, 0.1f, 0.9f } };
    }
    if (random_int(r, 0, 3))
        drawing->pass.depth =
            (GpDepthTarget){ .surface = drawing->surfaces[2],
                             .clear_depth = true,
                             .clear_stencil = drawing->surfaces[2]->format == GP_D24S8,
                             .depth_value = 1 };
    drawing->pass.draws = drawing->draws;
    drawing->pass.draw_count = (uint32_t)random_int(r, 1, MOST_DRAWS);
    for (uint32_t i = 0; i < drawing->pass.draw_count; i++) {
        set_points(r, drawing->points[i]);
        set_draw(r, drawing, (int)i, targets);
    }
}

static void destroy_drawing(Drawing *drawing)
{
    for (size_t i = 0; i < GP_COUNT(drawing->surfaces); i++)
        gp_surface_destroy(&drawing->surfaces[i]);
}

/* --- runs ------------------------------------------------------------------------------------- */

static void sprites_are_the_references(void **state)
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
    const struct CMUnitTest tests[] = { cmocka_unit_test(sprites_are_the_references) };
    return cmocka_run_group_tests_name("fast sprites", tests, NULL, NULL);
}
