/* What a pixel shader gets, on every device, against exact values: behind cuts, and at extreme
 * w. */
#include <glasspipe/glasspipe.h>
#include "shaders_c/voxel/methods/layers.h"
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

enum { SIZE = 64 };

typedef struct Corner {
    float position[4], color[4], uv[2];
} Corner;

/* Colours and linear values in two float targets, and depth. */
typedef struct Maps {
    Frame frame;
    GpSurface *color, *linear, *depth;
    ExerciseUniforms uniforms;
} Maps;

static void begin_maps(uint32_t width, Maps *maps)
{
    *maps = (Maps){ .uniforms.color = { 1, 1, 1, 1 } };
    for (int i = 0; i < 4; i++)
        maps->uniforms.matrix[i][i] = 1;
    maps->color = frame_surface(&maps->frame, GP_A32B32G32R32F, width, SIZE, 1);
    maps->linear = frame_surface(&maps->frame, GP_A32B32G32R32F, width, SIZE, 1);
    maps->depth = frame_surface(&maps->frame, GP_D32F, width, SIZE, 1);
    GpPass *pass =
        frame_pass(&maps->frame, "maps", maps->color, maps->depth, (const float[4]){ 0 });
    pass->color[1] = (GpColorTarget){ .surface = maps->linear, .clear = true };
}

static GpDraw *draw_corners(Maps *maps, const Corner *corners, uint32_t count)
{
    const GpGeometry geometry = {
        .vertex_count = count,
        .streams = { [GP_POSITION] = { corners->position, sizeof *corners, 4, GP_FLOAT32 },
                     [GP_COLOR] = { corners->color, sizeof *corners, 4, GP_FLOAT32 },
                     [GP_TEXCOORD0] = { corners->uv, sizeof *corners, 2, GP_FLOAT32 } },
    };
    GpDraw *draw = frame_draw(&maps->frame, &exercise_targets2, &maps->uniforms, &geometry);
    draw->state.depth = (GpDepthState){ .test = GP_ALWAYS, .write = true };
    return draw;
}

static const float *texel(const GpSurface *surface, int x, int y)
{
    const GpLevel *level = &surface->level[0];
    const size_t bytes = surface->format == GP_A32B32G32R32F ? 16 : 4;
    return (const float *)(const void *)(level->texels + (size_t)y * level->pitch +
                                         (size_t)x * bytes);
}

/* --- behind cuts ------------------------------------------------------------------------------ */

/* z/w at a place on the screen, from the whole triangle: weights b with sum b (x, y, w) ~ (X, Y, 1)
 * are determinants. */
static double exact_depth(const Corner corner[3], double x, double y)
{
    const double place_x = x * 2 / SIZE - 1, place_y = 1 - y * 2 / SIZE;
    double z = 0, w = 0;
    for (int k = 0; k < 3; k++) {
        const float *a = corner[(k + 1) % 3].position, *b = corner[(k + 2) % 3].position;
        const double weight =
            place_x * ((double)a[1] * (double)b[3] - (double)a[3] * (double)b[1]) +
            place_y * ((double)a[3] * (double)b[0] - (double)a[0] * (double)b[3]) +
            ((double)a[0] * (double)b[1] - (double)a[1] * (double)b[0]);
        z += weight * (double)corner[k].position[2];
        w += weight * (double)corner[k].position[3];
    }
    return z / w;
}

/* How much it may differ for a place that is a few roundings of a corner beside another. */
static double change_nearby(const Corner corner[3], double x, double y)
{
    const double step = 1.0 / 64, here = exact_depth(corner, x, y);
    return fabs(exact_depth(corner, x + step, y) - here) +
           fabs(exact_depth(corner, x, y + step) - here);
}

typedef enum Cut { NEAR, FAR, BOTH, SIDES, CUTS } Cut;

/* A triangle round the middle of the screen that is cut; some corners lie behind the eye. */
static void make_cut_triangle(Random *random, Cut cut, Corner corner[3])
{
    const int out = random_int(random, 0, 2);
    for (int k = 0; k < 3; k++) {
        const float turn = 2.1f * (float)k + random_float(random, 0, 1);
        const bool outside = k == out;
        float w = random_float(random, 0.5f, 3), reach = w * random_float(random, 0.8f, 3);
        float z = w * random_float(random, 0.05f, 0.95f);
        if (outside && cut == SIDES)
            reach = w * random_float(random, 1500, 30000);
        else if (outside && cut == FAR)
            z = w * random_float(random, 1.1f, 3);
        else if (outside && (cut == NEAR || cut == BOTH))
            z = random_float(random, -2, -0.1f), w = random_float(random, -1, 1);
        else if (cut == BOTH && k == (out + 1) % 3)
            z = w * random_float(random, 1.1f, 3);
        w = fabsf(w) < 0.2f ? 0.2f : w;
        corner[k] = (Corner){ { reach * cosf(turn), reach * sinf(turn), z, w },
                              { 0, 0, 0, 0 },
                              { z / w, 1 } };
    }
}

/* Pixels that were drawn; each of them right. */
static int check_depths(const Maps *maps, const Corner corner[3])
{
    int drawn = 0;
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            const float *given = texel(maps->linear, x, y);
            if (given[1] == 0)
                continue;
            const double exact = exact_depth(corner, x + 0.5, y + 0.5);
            const double change = change_nearby(corner, x + 0.5, y + 0.5);
            if (!(fabs((double)given[0] - exact) <= change + 2e-6))
                fail_msg("(%d, %d): %.9g instead of %.9g", x, y, (double)given[0], exact);
            assert_true(fabsf(given[0] - *texel(maps->depth, x, y)) <= 2e-6f);
            assert_true(given[1] == 1);
            drawn++;
        }
    return drawn;
}

static void z_over_w_is_linear_on_the_screen_behind_every_cut(void **state)
{
    (void)state;
    Random random = { 14 };
    for (Cut cut = NEAR; cut < CUTS; cut++) {
        int drawn = 0;
        for (int i = 0; i < 12; i++) {
            Corner corner[3];
            Maps maps;
            begin_maps(SIZE, &maps);
            make_cut_triangle(&random, cut, corner);
            draw_corners(&maps, corner, 3);
            run_everywhere(&maps.frame);
            drawn += check_depths(&maps, corner);
            frame_free(&maps.frame);
        }
        assert_true(drawn > 4000);
    }
}

/* Layers of a model that the near and the far plane cut: what is peeled is the depth itself. */
static void layers_of_cut_triangles_are_their_depths(void **state)
{
    (void)state;
    static const Corner corner[3] = { { .position = { -0.9f, -0.9f, -1, 1 } },
                                      { .position = { 0.9f, -0.8f, 2.5f, 1 } },
                                      { .position = { 0.1f, 0.9f, 0.5f, 1 } } };
    VoxelPeelUniforms uniforms = { { { 1 }, { 0, 1 }, { 0, 0, 1 }, { 0, 0, 0, 1 } } };
    const GpGeometry geometry = {
        .vertex_count = 3,
        .streams = { [GP_POSITION] = { corner->position, sizeof *corner, 3, GP_FLOAT32 } },
    };
    Frame frame = { .color = NULL };
    GpSurface *layer = frame_surface(&frame, GP_R32F, SIZE, SIZE, 1);
    GpSurface *depth = frame_surface(&frame, GP_D32F, SIZE, SIZE, 1);
    frame_pass(&frame, "layer", layer, depth, (const float[4]){ VOXEL_NO_LAYER });
    frame_draw(&frame, &voxel_peel_first_program, &uniforms, &geometry)->state.depth =
        (GpDepthState){ .test = GP_LESS, .write = true };
    run_everywhere(&frame);
    int drawn = 0;
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            const double z = (double)*texel(layer, x, y);
            if (z == (double)VOXEL_NO_LAYER)
                continue;
            assert_true(fabs(z - exact_depth(corner, x + 0.5, y + 0.5)) <=
                        change_nearby(corner, x + 0.5, y + 0.5) + 2e-6);
            assert_true(z >= 0 && z <= 1 && *texel(depth, x, y) == (float)z);
            drawn++;
        }
    assert_true(drawn > 300);
    frame_free(&frame);
}

/* --- extreme w -------------------------------------------------------------------------------- */

enum { MOST = 40, ORDERS = 6, CHANNELS = 6 };

/* Triangles on known places of the 24.8 grid. Of equal depth each, and each before the last. */
typedef struct Triangle {
    int64_t x[3], y[3];
    Corner corner[3]; /* values: random, w, 0 or 1, equal; on the screen: random, equal */
} Triangle;

static void make_triangle(Random *random, int number, int32_t reach, Triangle *t)
{
    const int32_t middle[2] = { random_int(random, 0, SIZE * 256),
                                random_int(random, 0, SIZE * 256) };
    const float depth = 0.9f - 0.02f * (float)number;
    for (int k = 0; k < 3; k++) {
        const float w = powf(10, random_float(random, -4.5f, 4.5f));
        t->x[k] = middle[0] + random_int(random, -reach, reach);
        t->y[k] = middle[1] + random_int(random, -reach, reach);
        const float x = (float)t->x[k] / (128 * SIZE) - 1, y = 1 - (float)t->y[k] / (128 * SIZE);
        t->corner[k] = (Corner){ { x * w, y * w, depth * w, w },
                                 { random_float(random, -1, 1), w, (float)(k == 1), 0.3f },
                                 { random_float(random, -1, 1), 0.7f } };
    }
}

/* Edge functions at a pixel's centre; false outside. */
static bool find_edges(const Triangle *t, int x, int y, double edge[3])
{
    bool positive = false, negative = false;
    for (int k = 0; k < 3; k++) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        const int64_t dx = t->x[b] - t->x[a], dy = t->y[b] - t->y[a];
        const int64_t value = dx * (y * 256 + 128 - t->y[a]) - dy * (x * 256 + 128 - t->x[a]);
        positive |= value > 0;
        negative |= value < 0;
        edge[k] = fabs((double)value);
    }
    return positive != negative;
}

static double value_of(const Corner *corner, int channel)
{
    return (double)(channel < 4 ? corner->color[channel] : corner->uv[channel - 4]);
}

/* What CONVENTIONS.md promises of a pixel. Returns whether it lies in the triangle; on an edge,
 * which may be another's, it is not looked at. */
static bool check_pixel(const Triangle *t, int x, int y, const float given[CHANNELS])
{
    const double half = 0x1p-24;
    double edge[3], sum[2] = { 0, 0 }, share[2][3];
    if (!find_edges(t, x, y, edge))
        return false;
    if (edge[0] == 0 || edge[1] == 0 || edge[2] == 0)
        return true;
    for (int on_screen = 0; on_screen < 2; on_screen++) {
        for (int k = 0; k < 3; k++) {
            const double w = (double)t->corner[k].position[3];
            sum[on_screen] += share[on_screen][k] = edge[k] / (on_screen ? 1 : w);
        }
        for (int k = 0; k < 3; k++)
            share[on_screen][k] /= sum[on_screen];
    }
    int nearest = 0;
    for (int k = 1; k < 3; k++)
        nearest = t->corner[k].position[3] < t->corner[nearest].position[3] ? k : nearest;
    for (int c = 0; c < CHANNELS; c++) {
        const double first = value_of(&t->corner[nearest], c);
        double exact = first, spread = 0;
        for (int k = 0; k < 3; k++) {
            const double to = value_of(&t->corner[k], c) - first, weight = share[c >= 4][k];
            exact += weight * to;
            spread += weight * fabs(to);
        }
        const double bound = half * fabs(exact) + 18 * half * spread;
        if (!(fabs((double)given[c] - exact) <= bound))
            fail_msg("(%d, %d), value %d: %.9g instead of %.9g", x, y, c, (double)given[c], exact);
    }
    return true;
}

typedef enum Way { OPAQUE, BLENDED, SORTED, WAYS } Way;

/* The same triangles six times side by side, with their corners in every order. */
static void draw_orders(Maps *maps, Way way, const Triangle *triangles, uint32_t count,
                        Corner corners[ORDERS][3 * MOST])
{
    static const uint8_t orders[ORDERS][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 },
                                               { 0, 2, 1 }, { 2, 1, 0 }, { 1, 0, 2 } };
    for (int order = 0; order < ORDERS; order++) {
        for (uint32_t i = 0; i < 3 * count; i++)
            corners[order][i] = triangles[i / 3].corner[orders[order][i % 3]];
        GpDraw *draw = draw_corners(maps, corners[order], 3 * count);
        draw->viewport = (GpViewport){ .x = (float)(order * SIZE), .width = SIZE, .height = SIZE };
        if (way == BLENDED) {
            draw->state.depth = (GpDepthState){ .write = false };
            draw->state.blend[0] = draw->state.blend[1] =
                (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ZERO };
        } else if (way == SORTED) {
            draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
            draw->state.alpha_test = (GpAlphaTest){ .test = GP_GREATER, .reference = 1 };
        }
    }
}

static void read_values(const Maps *maps, int x, int y, float values[CHANNELS])
{
    memcpy(values, texel(maps->color, x, y), 4 * sizeof *values);
    memcpy(values + 4, texel(maps->linear, x, y), 2 * sizeof *values);
}

/* Pixels of the last triangle that has them; all orders have the same bits. */
static int check_orders(const Maps *maps, const Triangle *triangles, int count)
{
    int checked = 0;
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            float values[CHANNELS], others[CHANNELS];
            read_values(maps, x, y, values);
            for (int order = 1; order < ORDERS; order++) {
                read_values(maps, order * SIZE + x, y, others);
                assert_memory_equal(others, values, sizeof values);
            }
            if (values[3] == 0)
                continue;
            assert_true(values[3] == 0.3f && values[5] == 0.7f);
            for (int i = count - 1; i >= 0; i--)
                if (check_pixel(&triangles[i], x, y, values)) {
                    checked++;
                    break;
                }
        }
    return checked;
}

static void r16_no_value_depends_on_which_corner_comes_first(void **state)
{
    (void)state;
    static const struct {
        int32_t reach; /* sub-pixels */
        int count, least;
    } kinds[] = { { 400, MOST, 60 }, { 3000, 20, 1000 }, { 16000, 8, 4000 }, { 500000, 6, 4000 } };
    static Corner corners[ORDERS][3 * MOST];
    Random random = { 163 };
    for (size_t kind = 0; kind < GP_COUNT(kinds); kind++)
        for (Way way = OPAQUE; way < WAYS; way++) {
            int checked = 0;
            for (int i = 0; i < 3; i++) {
                Triangle triangles[MOST];
                Maps maps;
                begin_maps(ORDERS * SIZE, &maps);
                for (int k = 0; k < kinds[kind].count; k++)
                    make_triangle(&random, k, kinds[kind].reach, &triangles[k]);
                draw_orders(&maps, way, triangles, (uint32_t)kinds[kind].count, corners);
                run_everywhere(&maps.frame);
                checked += check_orders(&maps, triangles, kinds[kind].count);
                frame_free(&maps.frame);
            }
            assert_true(checked > kinds[kind].least);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(z_over_w_is_linear_on_the_screen_behind_every_cut),
        cmocka_unit_test(r16_no_value_depends_on_which_corner_comes_first),
        cmocka_unit_test(layers_of_cut_triangles_are_their_depths),
    };
    return cmocka_run_group_tests_name("interpolants", tests, NULL, NULL);
}
