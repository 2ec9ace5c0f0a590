/* What is drawn without depth hides all that came before it where it covers a tile: one triangle,
 * or two halves of a rectangle. Whether they do is told from their corners; where they leave a
 * pixel, because halves stand a sub-pixel apart, face two ways, or are not the last, the picture is
 * right too: on every device the bits are the reference's. */
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { WIDTH = 130, HEIGHT = 70, MOST = 60, CORNER_FLOATS = 10, SEEDS = 300 };

static float corners[3 * MOST][CORNER_FLOATS];
static uint32_t count; /* triangles */

static uint32_t random_choice(Random *random, int32_t choices)
{
    return (uint32_t)random_int(random, 0, choices - 1);
}

/* In pixels. */
typedef struct Place {
    double x, y;
} Place;

/* Each corner has a colour of its own. */
static void add_triangle(Random *random, Place a, Place b, Place c, bool turned)
{
    const Place places[3] = { a, turned ? c : b, turned ? b : c };
    for (int k = 0; k < 3; k++) {
        float *corner = corners[3 * count + (uint32_t)k];
        corner[0] = (float)(2 * places[k].x / WIDTH - 1);
        corner[1] = (float)(1 - 2 * places[k].y / HEIGHT);
        corner[2] = 0;
        corner[3] = 1;
        for (int i = 4; i < CORNER_FLOATS; i++)
            corner[i] = random_float(random, 0, 1);
    }
    count++;
}

static Place random_place(Random *random)
{
    const double x = (double)random_float(random, -20, WIDTH + 20);
    const double y = (double)random_float(random, -20, HEIGHT + 20);
    return (Place){ x, y };
}

/* A rectangle in two halves that mostly face one way, and are mostly side by side: over all the
 * picture, or from a pixel's centre on. */
static void add_halves(Random *random)
{
    const double step = 1.0 / 256, edge = random_choice(random, 2) ? 0 : 0.5;
    const double x0 = edge, y0 = edge, x1 = WIDTH - edge, y1 = HEIGHT - edge;
    const Place corner[4] = { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
    const uint32_t first = random_choice(random, 4), odd = random_choice(random, 6);
    const bool turned = random_choice(random, 2);
    Place from = corner[first], to = corner[(first + 2) % 4];
    add_triangle(random, from, corner[(first + 1) % 4], to, turned);
    if (odd == 1)
        from.x += random_choice(random, 2) ? step : -step;
    if (odd == 2)
        to.y += random_choice(random, 2) ? step : -step;
    if (odd == 3)
        add_triangle(random, random_place(random), random_place(random), random_place(random),
                     false);
    const Place last = corner[(first + (odd == 5 ? 1 : 3)) % 4]; /* folded over the first */
    add_triangle(random, to, last, from, odd == 4 ? !turned : turned);
}

static void add_something(Random *random)
{
    const Place far[3] = { { -WIDTH, -HEIGHT }, { 4 * WIDTH, -HEIGHT }, { -WIDTH, 4 * HEIGHT } };
    const uint32_t kind = random_choice(random, 8);
    if (kind < 4)
        add_halves(random);
    else if (kind < 5)
        add_triangle(random, far[0], far[1], far[2], random_choice(random, 2));
    else
        add_triangle(random, random_place(random), random_place(random), random_place(random),
                     random_choice(random, 2));
}

static void covers_hide_what_came_before(void **state)
{
    (void)state;
    static const GpCull culls[] = { GP_CULL_NONE, GP_CULL_CW, GP_CULL_CCW };
    ExerciseUniforms uniforms = { .color = { 1, 1, 1, 1 } };
    for (int i = 0; i < 4; i++)
        uniforms.matrix[i][i] = 1;
    GpSurface *surface = NULL;
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = WIDTH, .height = HEIGHT };
    assert_int_equal(gp_surface_create(&desc, &surface, NULL), GP_OK);
    for (int seed = 0; seed < SEEDS; seed++) {
        Random random = { (uint64_t)seed };
        const uint32_t wanted = 1 + random_choice(&random, MOST - 3);
        for (count = 0; count < wanted;)
            add_something(&random);
        GpDraw draw = { .program = &exercise_color, .uniforms = &uniforms };
        draw.state.raster.cull = culls[random_choice(&random, 3)];
        draw.state.raster.scissor = random_choice(&random, 4) == 0;
        draw.state.raster.scissor_x1 = WIDTH - (int32_t)random_choice(&random, 2);
        draw.state.raster.scissor_y1 = HEIGHT;
        draw.geometry.vertex_count = 3 * count;
        const uint32_t stride = sizeof corners[0];
        draw.geometry.streams[GP_POSITION] = (GpStream){ corners[0], stride, 4, GP_FLOAT32 };
        draw.geometry.streams[GP_COLOR] = (GpStream){ corners[0] + 4, stride, 4, GP_FLOAT32 };
        draw.geometry.streams[GP_TEXCOORD0] = (GpStream){ corners[0] + 8, stride, 2, GP_FLOAT32 };
        const GpPass pass = { .color = { { surface, true, { 0.3f, 0.6f, 0.9f, 0.2f } } },
                              .draws = &draw,
                              .draw_count = 1 };
        run_seed_everywhere(&pass, seed);
    }
    gp_surface_destroy(&surface);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(covers_hide_what_came_before),
    };
    return cmocka_run_group_tests_name("fast, covers", tests, NULL, NULL);
}
