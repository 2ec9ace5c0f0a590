/* The ternary depth test: what replaces, is added, is dropped, on every device. Points of powers of
 * two are added, so that a sum tells which of them it has. */
#include "tests/shaders/flat_points.h"
#include "tests/shaders/splat.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

static const GpFormat depth_formats[] = { GP_D16, GP_D24S8, GP_D32F };
static const GpBlend add = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };

static GpSurface *surface_of(GpFormat format, uint32_t width, uint32_t height)
{
    GpSurface *surface = NULL;
    const GpSurfaceDesc desc = { .format = format, .width = width, .height = height };
    assert_int_equal(gp_surface_create(&desc, &surface, NULL), GP_OK);
    return surface;
}

/* --- one pixel -------------------------------------------------------------------------------- */

enum { SIDE = 8, MOST = 8 };

/* Points over the same pixels, one after the other. */
typedef struct Stack {
    float position[MOST][3], color[MOST][4], size[MOST];
    GpDraw draw;
    GpPass pass;
    GpList list;
} Stack;

static const FlatPointsUniforms stack_uniforms = { { SIDE, SIDE } };

/* count depths, near to far from 0 to 1; colours are 1, 2, 4 ... */
static void set_stack(Stack *s, GpFormat color, GpFormat depth, float epsilon, int count,
                      const float *depths)
{
    memset(s, 0, sizeof *s);
    for (int i = 0; i < count; i++) {
        s->position[i][0] = s->position[i][1] = SIDE / 2.0f;
        s->position[i][2] = depths[i];
        s->color[i][2] = s->color[i][3] = (float)(1 << i); /* flat_points leaves blue alone */
        s->size[i] = 3;
    }
    s->draw = (GpDraw){
        .program = &flat_points,
        .uniforms = &stack_uniforms,
        .geometry = { .primitive = GP_POINTS, .vertex_count = (uint32_t)count },
        .state = { .depth = { GP_LESS_EQUAL, true, true, epsilon }, .blend = { add } },
    };
    GpStream *streams = s->draw.geometry.streams;
    streams[GP_POSITION] = (GpStream){ s->position, 0, 3, GP_FLOAT32 };
    streams[GP_COLOR] = (GpStream){ s->color, 0, 4, GP_FLOAT32 };
    streams[GP_POINT_SIZE] = (GpStream){ s->size, 0, 1, GP_FLOAT32 };
    s->pass = (GpPass){
        .name = "stack",
        .color = { { surface_of(color, SIDE, SIDE), true, { 0, 0, 0, 0 } } },
        .depth = { .surface = surface_of(depth, SIDE, SIDE),
                   .clear_depth = true,
                   .depth_value = 1 },
        .draws = &s->draw,
        .draw_count = 1,
    };
    s->list = (GpList){ &s->pass, 1 };
}

static void free_stack(Stack *s)
{
    gp_surface_destroy(&s->pass.color[0].surface);
    gp_surface_destroy(&s->pass.depth.surface);
}

/* Blue of the middle pixel, on every device the same. */
static float run_stack(Stack *s)
{
    float rgba[4] = { 0 }, first = 0;
    for (size_t d = 0; device_here(d); d++) {
        run_list_on(device_here(d), &s->list);
        const GpSurface *surface = s->pass.color[0].surface;
        gp_texel_load(surface->format,
                      gp_surface_texel(&surface->level[0], gp_format_info(surface->format)->bytes,
                                       SIDE / 2, SIDE / 2),
                      rgba);
        if (d == 0)
            first = rgba[2];
        else if (rgba[2] != first)
            fail_msg("%s: %g, not %g", device_name(device_here(d)), (double)rgba[2], (double)first);
    }
    return first;
}

static float stored_depth(const Stack *s)
{
    const GpSurface *depth = s->pass.depth.surface;
    uint32_t code;
    uint8_t stencil;
    gp_depth_load(depth->format,
                  gp_surface_texel(&depth->level[0], gp_format_info(depth->format)->bytes, SIDE / 2,
                                   SIDE / 2),
                  &code, &stencil);
    return gp_depth_from_code(depth->format, code);
}

/* In every depth format: which of the points are in the sum, a bit each, and what depth is left. */
static void expect_sum(float epsilon, int count, const float *depths, int points, float depth)
{
    for (size_t f = 0; f < GP_COUNT(depth_formats); f++) {
        Stack s;
        set_stack(&s, GP_A32B32G32R32F, depth_formats[f], epsilon, count, depths);
        assert_float_equal(run_stack(&s), (float)points, 0);
        assert_float_equal(stored_depth(&s), depth, 1e-4f);
        free_stack(&s);
    }
}

static void in_front_replaces_within_is_added_behind_is_dropped(void **state)
{
    (void)state;
    expect_sum(0.1f, 2, (const float[]){ 0.5f, 0.3f }, 2, 0.3f);
    expect_sum(0.1f, 2, (const float[]){ 0.5f, 0.45f }, 3, 0.45f);
    expect_sum(0.1f, 2, (const float[]){ 0.5f, 0.55f }, 3, 0.5f);
    expect_sum(0.1f, 2, (const float[]){ 0.5f, 0.7f }, 1, 0.5f);
    expect_sum(0.1f, 5, (const float[]){ 0.5f, 0.7f, 0.45f, 0.2f, 0.25f }, 8 + 16, 0.2f);
}

static void the_first_is_replaced_by_nothing_but_what_was_there(void **state)
{
    (void)state;
    Stack s;
    const float depths[] = { 0.5f };
    set_stack(&s, GP_A32B32G32R32F, GP_D24S8, 0.1f, 1, depths);
    s.pass.color[0].clear_color[2] = 7; /* behind it lies the background */
    assert_float_equal(run_stack(&s), 1, 0);
    s.pass.depth.depth_value = 0.55f; /* now within epsilon of it */
    assert_float_equal(run_stack(&s), 8, 0);
    free_stack(&s);
}

static void epsilon_0_adds_equal_depths_alone(void **state)
{
    (void)state;
    expect_sum(0, 4, (const float[]){ 0.5f, 0.5f, 0.51f, 0.5f }, 1 + 2 + 8, 0.5f);
    expect_sum(0, 4, (const float[]){ 0.5f, 0.49f, 0.5f, 0.49f }, 2 + 8, 0.49f);
}

/* Back to front by steps below epsilon all are added; front to back only what is within one. */
static void a_chain_creeps_towards_the_eye_and_never_away(void **state)
{
    (void)state;
    expect_sum(0.1f, 4, (const float[]){ 0.5f, 0.44f, 0.38f, 0.32f }, 15, 0.32f);
    expect_sum(0.1f, 4, (const float[]){ 0.32f, 0.38f, 0.44f, 0.5f }, 3, 0.32f);
}

/* What is within epsilon of the nearest is in the sum whatever the order, as two passes would have
 * it, and the depth that is left is the nearest. */
static void no_order_loses_what_is_within_epsilon_of_the_nearest(void **state)
{
    (void)state;
    const float epsilon = 0.1f;
    for (int seed = 0; seed < 40; seed++) {
        Random r = { (uint64_t)seed };
        float depths[MOST], nearest = 1;
        for (int i = 0; i < MOST; i++) {
            depths[i] = (float)random_int(&r, 20, 80) / 128.0f + 0.002f;
            nearest = depths[i] < nearest ? depths[i] : nearest;
        }
        Stack s;
        set_stack(&s, GP_A32B32G32R32F, depth_formats[seed % 3], epsilon, MOST, depths);
        const int sum = (int)run_stack(&s);
        assert_float_equal(stored_depth(&s), nearest, 1e-4f);
        for (int i = 0; i < MOST; i++)
            if (depths[i] <= nearest + epsilon)
                assert_true(sum >> i & 1);
        free_stack(&s);
    }
}

/* As if the target had been cleared through the write mask, then blended with. */
static void what_replaces_is_blended_with_zero(void **state)
{
    (void)state;
    static const GpFormat formats[] = { GP_A8R8G8B8, GP_X8R8G8B8, GP_A16B16G16R16F };
    for (size_t f = 0; f < GP_COUNT(formats); f++) {
        Stack s;
        const float depths[] = { 0.5f, 0.2f };
        set_stack(&s, formats[f], GP_D32F, 0.1f, 2, depths);
        s.color[0][2] = 0.2f;
        s.color[1][2] = 0.8f;
        s.draw.state.blend[0].op = GP_BLEND_MIN;
        assert_float_equal(run_stack(&s), 0, 0);
        s.draw.state.blend[0].op = GP_BLEND_MAX;
        assert_float_equal(run_stack(&s), 0.8f, 0.001f);
        s.draw.state.blend[0] = (GpBlend){ .op = GP_BLEND_OFF };
        assert_float_equal(run_stack(&s), 0.8f, 0.001f);
        s.pass.color[0].clear_color[2] = 0.4f;
        s.draw.state.blend[0] = add;
        s.draw.state.blend[0].keep = 4; /* blue */
        assert_float_equal(run_stack(&s), 0.4f, 0.002f);
        free_stack(&s);
    }
}

/* --- splats ----------------------------------------------------------------------------------- */

enum { WIDTH = 150, HEIGHT = 140, SPLATS = 1500, SEEDS = 24 };

typedef struct Splat {
    float position[3], color[3], normal[3], ellipse[3], size;
} Splat;

static const SplatUniforms splat_uniforms = { { WIDTH, HEIGHT } };

/* Mostly a few pixels; some wider than packets, and than tiles. */
static void set_splats(Random *r, Splat *splats)
{
    for (int i = 0; i < SPLATS; i++) {
        Splat *s = &splats[i];
        s->position[0] = random_float(r, -10, WIDTH + 10);
        s->position[1] = random_float(r, -10, HEIGHT + 10);
        s->position[2] = random_float(r, 0, 1);
        for (int c = 0; c < 3; c++) {
            s->color[c] = random_float(r, 0, 1);
            s->normal[c] = random_float(r, -1, 1);
        }
        s->size = (float)random_int(r, 1, 9);
        if (random_int(r, 0, 40) == 0)
            s->size = random_float(r, 10, 90);
        const float square = 4 / (s->size * s->size);
        s->ellipse[0] = square * random_float(r, 1, 3);
        s->ellipse[1] = square * random_float(r, -0.5f, 0.5f);
        s->ellipse[2] = square * random_float(r, 1, 3);
    }
}

static void splats_on_two_targets_are_the_references(void **state)
{
    (void)state;
    static Splat splats[SPLATS];
    static const GpFormat formats[] = { GP_A16B16G16R16F, GP_A32B32G32R32F, GP_A8R8G8B8,
                                        GP_G16R16F };
    for (int seed = 0; seed < SEEDS; seed++) {
        Random r = { (uint64_t)seed };
        set_splats(&r, splats);
        GpDraw draw = { .program = seed % 2 ? &splat : &splat_square,
                        .uniforms = &splat_uniforms,
                        .geometry = { .primitive = GP_POINTS, .vertex_count = SPLATS } };
        draw.state.depth =
            (GpDepthState){ GP_LESS_EQUAL, true, true, seed % 5 ? 0.03f * (float)(seed % 5) : 0 };
        draw.state.blend[0] = draw.state.blend[1] = add;
        GpStream *streams = draw.geometry.streams;
        streams[GP_POSITION] = (GpStream){ splats->position, sizeof *splats, 3, GP_FLOAT32 };
        streams[GP_COLOR] = (GpStream){ splats->color, sizeof *splats, 3, GP_FLOAT32 };
        streams[GP_NORMAL] = (GpStream){ splats->normal, sizeof *splats, 3, GP_FLOAT32 };
        streams[GP_TEXCOORD0] = (GpStream){ splats->ellipse, sizeof *splats, 3, GP_FLOAT32 };
        streams[GP_POINT_SIZE] = (GpStream){ &splats->size, sizeof *splats, 1, GP_FLOAT32 };
        GpPass pass = { .name = "splats", .draws = &draw, .draw_count = 1 };
        for (int t = 0; t < 2; t++)
            pass.color[t] = (GpColorTarget){ surface_of(formats[(seed / 2 + t) % 4], WIDTH, HEIGHT),
                                             true,
                                             { 0, 0, 0, 0 } };
        pass.depth = (GpDepthTarget){ .surface = surface_of(depth_formats[seed % 3], WIDTH, HEIGHT),
                                      .clear_depth = true,
                                      .depth_value = 1 };
        const GpList list = { &pass, 1 };
        run_list_on(device_here(0), &list);
        const uint64_t expected = hash_targets(&list);
        for (size_t d = 1; device_here(d); d++) {
            run_list_on(device_here(d), &list);
            if (hash_targets(&list) != expected)
                fail_msg("seed %d, %s: other bits", seed, device_name(device_here(d)));
        }
        for (int t = 0; t < 2; t++)
            gp_surface_destroy(&pass.color[t].surface);
        gp_surface_destroy(&pass.depth.surface);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_front_replaces_within_is_added_behind_is_dropped),
        cmocka_unit_test(the_first_is_replaced_by_nothing_but_what_was_there),
        cmocka_unit_test(epsilon_0_adds_equal_depths_alone),
        cmocka_unit_test(a_chain_creeps_towards_the_eye_and_never_away),
        cmocka_unit_test(no_order_loses_what_is_within_epsilon_of_the_nearest),
        cmocka_unit_test(what_replaces_is_blended_with_zero),
        cmocka_unit_test(splats_on_two_targets_are_the_references),
    };
    return cmocka_run_group_tests_name("ternary", tests, NULL, NULL);
}
