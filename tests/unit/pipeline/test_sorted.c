/* Passes that sort the fragments of a pixel, on every device, against a plain sort: each primitive
 * is drawn alone, which tells its fragments' depths and colours; these are sorted and blended
 * here. */
#include "pipeline/resources/compare.h"
#include "pipeline/units/blend.h"
#include "tests/shaders/exercise.h"
#include "tests/shaders/flat_points.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <stdlib.h>

static const GpBlend over = { .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA, .dst = GP_INV_SRC_ALPHA };
static const GpBlend add = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };

static GpSurface *surface_of(GpFormat format, uint32_t width, uint32_t height)
{
    GpSurface *surface = NULL;
    const GpSurfaceDesc desc = { .format = format, .width = width, .height = height };
    assert_int_equal(gp_surface_create(&desc, &surface, NULL), GP_OK);
    return surface;
}

static void *texel_at(const GpSurface *surface, uint32_t x, uint32_t y)
{
    return gp_surface_texel(&surface->level[0], gp_format_info(surface->format)->bytes, x, y);
}

/* --- fragments, one primitive at a time ------------------------------------------------------- */

enum { WIDTH = 90, HEIGHT = 70, MOST_DRAWS = 3, MOST_PRIMITIVES = 40, VERTEX_FLOATS = 10 };

/* A pass of some draws, in which each has vertices of its own. */
typedef struct Case {
    float vertices[MOST_DRAWS][3 * MOST_PRIMITIVES][VERTEX_FLOATS];
    ExerciseUniforms uniforms[MOST_DRAWS];
    GpDraw draw[MOST_DRAWS];
    GpPass pass;
    float before[4], depth_before;
    bool is_deep; /* large primitives, as many as there may be */
} Case;

typedef struct Fragment {
    float depth;
    int sequence, draw;
    float color[4];
} Fragment;

typedef struct Pixel {
    Fragment fragment[MOST_DRAWS * MOST_PRIMITIVES];
    int count;
} Pixel;

/* Colour that no shader here gives. */
static const float nothing[4] = { -9, -9, -9, -9 };

static void note_fragments(const GpPass *alone, int sequence, int draw, Pixel *pixels)
{
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        Fragment fragment = { .sequence = sequence, .draw = draw };
        uint32_t code;
        uint8_t stencil;
        gp_texel_load(GP_A32B32G32R32F, texel_at(alone->color[0].surface, i % WIDTH, i / WIDTH),
                      fragment.color);
        if (memcmp(fragment.color, nothing, sizeof nothing) == 0)
            continue;
        gp_depth_load(GP_D32F, texel_at(alone->depth.surface, i % WIDTH, i / WIDTH), &code,
                      &stencil);
        fragment.depth = gp_depth_from_code(GP_D32F, code);
        pixels[i].fragment[pixels[i].count++] = fragment;
    }
}

/* Every primitive by itself, into surfaces that round nothing, by a pass without an order. */
static void find_fragments(const Case *c, Pixel *pixels)
{
    int sequence = 0;
    GpDraw draw;
    GpPass alone = {
        .name = "alone",
        .color = { { surface_of(GP_A32B32G32R32F, WIDTH, HEIGHT), true, { -9, -9, -9, -9 } } },
        .depth = { .surface = surface_of(GP_D32F, WIDTH, HEIGHT), .clear_depth = true },
        .draws = &draw,
        .draw_count = 1,
    };
    for (uint32_t d = 0; d < c->pass.draw_count; d++) {
        const uint32_t corners = gp_primitive_corners(c->draw[d].geometry.primitive);
        for (uint32_t p = 0; p < c->draw[d].geometry.vertex_count / corners; p++) {
            draw = c->draw[d];
            for (int s = 0; s < GP_SEMANTICS; s++)
                if (draw.geometry.streams[s].data)
                    draw.geometry.streams[s].data = (const uint8_t *)draw.geometry.streams[s].data +
                                                    p * corners * VERTEX_FLOATS * sizeof(float);
            draw.geometry.vertex_count = corners;
            draw.state.blend[0] = (GpBlend){ .op = GP_BLEND_OFF };
            draw.state.depth = (GpDepthState){ .test = GP_ALWAYS, .write = true };
            run_list_on(device_here(0), &(GpList){ &alone, 1 });
            note_fragments(&alone, sequence++, (int)d, pixels);
        }
    }
    gp_surface_destroy(&alone.color[0].surface);
    gp_surface_destroy(&alone.depth.surface);
}

static int direction; /* of the sort: 1 far first */

static int by_turn(const void *one, const void *other)
{
    const Fragment *a = one, *b = other;
    if (a->depth != b->depth)
        return (a->depth > b->depth ? -1 : 1) * direction;
    return a->sequence - b->sequence;
}

/* Depth test, blending and write mask of sorted fragments, in their turn. */
static void blend_pixel(const Case *c, Pixel *pixel, float rgba[4], uint32_t *depth)
{
    const GpFormat format = c->pass.color[0].surface->format;
    const GpSurface *tested = c->pass.depth.surface;
    uint8_t texel[16];
    gp_texel_store(format, texel, rgba, 0);
    direction = c->pass.order == GP_ORDER_DEPTH ? 1 : -1;
    qsort(pixel->fragment, (size_t)pixel->count, sizeof *pixel->fragment, by_turn);
    for (int i = 0; i < pixel->count; i++) {
        const Fragment *fragment = &pixel->fragment[i];
        const GpState *state = &c->draw[fragment->draw].state;
        const uint32_t code = tested ? gp_depth_code(tested->format, fragment->depth) : 0;
        float held[4], result[4];
        if (tested && !gp_compare_codes(state->depth.test, code, *depth))
            continue;
        if (tested && state->depth.write)
            *depth = code;
        gp_texel_load(format, texel, held);
        memcpy(result, fragment->color, sizeof result);
        if (state->blend[0].op != GP_BLEND_OFF)
            gp_blend(&state->blend[0], state->blend_constant, format, fragment->color, held,
                     result);
        gp_texel_store(format, texel, result, state->blend[0].keep);
    }
    gp_texel_load(format, texel, rgba);
}

/* Runs the case on every device; every texel is to be what sorting gives. */
static void expect_sorted(const Case *c, int seed)
{
    Pixel *pixels = calloc(WIDTH * HEIGHT, sizeof *pixels);
    assert_non_null(pixels);
    find_fragments(c, pixels);
    const GpFormat format = c->pass.color[0].surface->format;
    GpSurface *expected = surface_of(format, WIDTH, HEIGHT), *deep = NULL;
    if (c->pass.depth.surface)
        deep = surface_of(c->pass.depth.surface->format, WIDTH, HEIGHT);
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        float rgba[4];
        uint32_t depth = deep ? gp_depth_code(deep->format, c->depth_before) : 0;
        memcpy(rgba, c->before, sizeof rgba);
        blend_pixel(c, &pixels[i], rgba, &depth);
        gp_texel_store(format, texel_at(expected, i % WIDTH, i / WIDTH), rgba, 0);
        if (deep)
            gp_depth_store(deep->format, texel_at(deep, i % WIDTH, i / WIDTH), depth, 0);
    }
    for (size_t d = 0; device_here(d); d++) {
        run_list_on(device_here(d), &(GpList){ &c->pass, 1 });
        if (gp_surface_hash(c->pass.color[0].surface) != gp_surface_hash(expected))
            fail_msg("seed %d, %s: other colours", seed, device_name(device_here(d)));
        if (deep && gp_surface_hash(c->pass.depth.surface) != gp_surface_hash(deep))
            fail_msg("seed %d, %s: other depths", seed, device_name(device_here(d)));
    }
    gp_surface_destroy(&expected);
    gp_surface_destroy(&deep);
    free(pixels);
}

/* --- random passes ---------------------------------------------------------------------------- */

/* Half of the triangles lie in planes of few depths, so that many are equal; others go through
 * them. */
static void set_vertices(Random *r, float (*vertex)[VERTEX_FLOATS], int count, int corners,
                         bool are_large)
{
    float size = 1, level = 0;
    for (int i = 0; i < count; i++) {
        float *v = vertex[i];
        const bool flat = i / corners % 2;
        if (i % corners == 0) {
            size = are_large ? random_float(r, 2, 6) : random_float(r, 0.02f, 1.2f);
            level = (float)random_int(r, 0, 4) / 4;
            v[0] = random_float(r, -1, 1);
            v[1] = random_float(r, -1, 1);
        } else {
            v[0] = vertex[i - i % corners][0] + random_float(r, -size, size);
            v[1] = vertex[i - i % corners][1] + random_float(r, -size, size);
        }
        v[2] = flat ? level : random_float(r, 0, 1);
        v[3] = 1;
        for (int c = 4; c < VERTEX_FLOATS; c++)
            v[c] = random_float(r, 0, 1);
    }
}

static GpBlend some_blend(Random *r)
{
    static const GpBlend some[] = {
        { .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA, .dst = GP_INV_SRC_ALPHA },
        { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_INV_SRC_ALPHA },
        { .op = GP_BLEND_ADD, .src = GP_INV_DEST_ALPHA, .dst = GP_ONE },
        { .op = GP_BLEND_OFF },
        { .op = GP_BLEND_ADD, .src = GP_DEST_COLOR, .dst = GP_SRC_COLOR },
        { .op = GP_BLEND_REV_SUBTRACT, .src = GP_SRC_ALPHA, .dst = GP_ONE },
        { .op = GP_BLEND_ADD, .src = GP_BLEND_CONSTANT, .dst = GP_INV_BLEND_CONSTANT, .keep = 2 },
        { .op = GP_BLEND_ADD,
          .src = GP_SRC_ALPHA,
          .dst = GP_INV_SRC_ALPHA,
          .alpha_op = GP_BLEND_ADD,
          .alpha_src = GP_ONE,
          .alpha_dst = GP_INV_SRC_ALPHA },
    };
    return some[random_int(r, 0, GP_COUNT(some) - 1)];
}

static void set_draw(Random *r, Case *c, int number)
{
    static const GpProgram *const programs[] = { &exercise_flat, &exercise_color, &exercise_discard,
                                                 &exercise_depth, &exercise_point };
    GpDraw *draw = &c->draw[number];
    float(*vertex)[VERTEX_FLOATS] = c->vertices[number];
    ExerciseUniforms *u = &c->uniforms[number];
    const int program = random_int(r, 0, 6);
    *draw = (GpDraw){ .program = programs[program < 5 ? program : 0], .uniforms = u };
    const bool points = draw->program == &exercise_point;
    draw->geometry.primitive = points ? GP_POINTS : GP_TRIANGLES;
    draw->geometry.vertex_count =
        (points ? 1 : 3) *
        (uint32_t)random_int(r, c->is_deep ? MOST_PRIMITIVES : 1, MOST_PRIMITIVES);
    set_vertices(r, vertex, (int)draw->geometry.vertex_count, points ? 1 : 3, c->is_deep);
    const uint32_t stride = VERTEX_FLOATS * sizeof(float);
    draw->geometry.streams[GP_POSITION] = (GpStream){ vertex[0], stride, 4, GP_FLOAT32 };
    draw->geometry.streams[GP_COLOR] = (GpStream){ vertex[0] + 4, stride, 4, GP_FLOAT32 };
    draw->geometry.streams[GP_TEXCOORD0] = (GpStream){ vertex[0] + 8, stride, 2, GP_FLOAT32 };
    for (int row = 0; row < 4; row++) {
        u->matrix[row][row] = 1;
        u->color[row] = random_float(r, 0, 1);
        u->scale[row] = random_float(r, 0, 1);
        draw->state.blend_constant[row] = random_float(r, 0, 1);
    }
    u->scale[3] = points ? random_float(r, 2, 40) : u->scale[3];
    draw->state.blend[0] = some_blend(r);
    if (random_int(r, 0, 3) == 0)
        draw->state.raster = (GpRasterState){
            .scissor = true, .scissor_x0 = 10, .scissor_y0 = 5, .scissor_x1 = 80, .scissor_y1 = 66
        };
    if (random_int(r, 0, 3) == 0)
        draw->viewport = (GpViewport){
            .x = 4, .y = 3, .width = 80, .height = 60, .min_depth = 0.25f, .max_depth = 0.75f
        };
    if (random_int(r, 0, 3) == 0)
        draw->state.alpha_test = (GpAlphaTest){ GP_GREATER, 100 };
    draw->state.depth.test = random_int(r, 0, 1) ? GP_LESS_EQUAL : GP_ALWAYS;
}

static void set_case(Random *r, int seed, Case *c)
{
    static const GpFormat formats[] = { GP_A8R8G8B8, GP_A16B16G16R16F, GP_A32B32G32R32F };
    static const GpFormat depths[] = { GP_D16, GP_D24S8, GP_D32F };
    memset(c, 0, sizeof *c);
    c->pass = (GpPass){ .name = "sorted",
                        .order = seed % 3 ? GP_ORDER_DEPTH : GP_ORDER_DEPTH_NEAR_FIRST,
                        .draws = c->draw,
                        .draw_count = (uint32_t)random_int(r, 1, MOST_DRAWS) };
    c->is_deep = seed % 5 == 4;
    if (c->is_deep)
        c->pass.draw_count = MOST_DRAWS;
    c->depth_before = seed % 2 ? 0.6f : 1;
    for (int channel = 0; channel < 4; channel++)
        c->before[channel] = (float)channel / 4;
    c->pass.color[0] = (GpColorTarget){ surface_of(formats[seed % 3], WIDTH, HEIGHT),
                                        true,
                                        { 0, 0.25f, 0.5f, 0.75f } };
    if (seed % 4)
        c->pass.depth = (GpDepthTarget){ .surface = surface_of(depths[seed / 4 % 3], WIDTH, HEIGHT),
                                         .clear_depth = true,
                                         .depth_value = c->depth_before };
    for (uint32_t d = 0; d < c->pass.draw_count; d++) {
        set_draw(r, c, (int)d);
        if (!c->pass.depth.surface)
            c->draw[d].state.depth.test = GP_ALWAYS;
        else
            c->draw[d].state.depth.write = seed % 8 > 4; /* in turn */
    }
}

static void free_case(Case *c)
{
    gp_surface_destroy(&c->pass.color[0].surface);
    gp_surface_destroy(&c->pass.depth.surface);
}

static void fragments_are_blended_as_if_they_came_in_order(void **state)
{
    (void)state;
    static Case c;
    for (int seed = 0; seed < 24; seed++) {
        Random r = { (uint64_t)seed };
        set_case(&r, seed, &c);
        expect_sorted(&c, seed);
        free_case(&c);
    }
}

/* --- one pixel's fragments -------------------------------------------------------------------- */

enum { SIDE = 70, MOST = 300 };

/* Points over the same pixels, one after the other; colours in blue and alpha. */
typedef struct Stack {
    float position[MOST][3], color[MOST][4], size[MOST];
    GpDraw draw;
    GpPass pass;
} Stack;

static const FlatPointsUniforms stack_uniforms = { { SIDE, SIDE } };

static void set_stack(Stack *s, GpFormat format, int count)
{
    memset(s, 0, sizeof *s);
    for (int i = 0; i < count; i++) {
        s->position[i][0] = s->position[i][1] = SIDE / 2.0f;
        s->size[i] = SIDE / 2;
    }
    s->draw = (GpDraw){ .program = &flat_points,
                        .uniforms = &stack_uniforms,
                        .geometry = { .primitive = GP_POINTS, .vertex_count = (uint32_t)count } };
    GpStream *streams = s->draw.geometry.streams;
    streams[GP_POSITION] = (GpStream){ s->position, 0, 3, GP_FLOAT32 };
    streams[GP_COLOR] = (GpStream){ s->color, 0, 4, GP_FLOAT32 };
    streams[GP_POINT_SIZE] = (GpStream){ s->size, 0, 1, GP_FLOAT32 };
    s->pass = (GpPass){ .name = "stack",
                        .color = { { surface_of(format, SIDE, SIDE), true, { 0 } } },
                        .draws = &s->draw,
                        .draw_count = 1,
                        .order = GP_ORDER_DEPTH };
}

/* Blue of the middle pixel, where the point's own alpha holds. */
static float middle(const Stack *s)
{
    const GpSurface *surface = s->pass.color[0].surface;
    float rgba[4];
    gp_texel_load(surface->format, texel_at(surface, SIDE / 2, SIDE / 2), rgba);
    return rgba[2];
}

static void expect_middle(Stack *s, float expected)
{
    for (size_t d = 0; device_here(d); d++) {
        run_list_on(device_here(d), &(GpList){ &s->pass, 1 });
        if (middle(s) != expected)
            fail_msg("%s: %g, not %g", device_name(device_here(d)), (double)middle(s),
                     (double)expected);
    }
}

static void the_last_in_turn_replaces_and_equal_depths_stay_as_submitted(void **state)
{
    (void)state;
    static const float depth[5] = { 0.5f, 0.25f, 0.75f, 0.25f, 0.75f };
    static Stack s;
    set_stack(&s, GP_A32B32G32R32F, 5);
    for (int i = 0; i < 5; i++) {
        s.position[i][2] = depth[i];
        s.color[i][2] = (float)i;
    }
    expect_middle(&s, 3); /* the later of the two nearest */
    s.pass.order = GP_ORDER_DEPTH_NEAR_FIRST;
    expect_middle(&s, 4);
    s.pass.order = GP_ORDER_SUBMITTED;
    s.color[4][2] = 9;
    expect_middle(&s, 9);
    gp_surface_destroy(&s.pass.color[0].surface);
}

/* The stencil lets two fragments through: in whose turn it is. */
static void stencil_is_asked_in_turn(void **state)
{
    (void)state;
    static const float depth[4] = { 0.5f, 0.125f, 0.25f, 0.75f };
    static Stack s;
    set_stack(&s, GP_A32B32G32R32F, 4);
    for (int i = 0; i < 4; i++) {
        s.position[i][2] = depth[i];
        s.color[i][2] = (float)(1 << i);
    }
    s.pass.depth.surface = surface_of(GP_D24S8, SIDE, SIDE);
    s.pass.depth.clear_stencil = true;
    s.draw.state.blend[0] = add;
    s.draw.state.stencil = (GpStencilState){
        .enable = true, .front = { .test = GP_GREATER, .pass = GP_STENCIL_INCR }, .reference = 2
    };
    expect_middle(&s, 8 + 1);
    s.pass.order = GP_ORDER_DEPTH_NEAR_FIRST;
    expect_middle(&s, 2 + 4);
    gp_surface_destroy(&s.pass.color[0].surface);
    gp_surface_destroy(&s.pass.depth.surface);
}

/* --- many layers ------------------------------------------------------------------------------ */

static int by_depth(const void *one, const void *other)
{
    const float *a = one, *b = other;
    return a[2] != b[2] ? (a[2] > b[2] ? -1 : 1) : a[0] < b[0] ? -1 : 1;
}

/* "Over" of the middle pixel's layers in 8 bits, sorted. */
static float blend_layers(const Stack *s, int count)
{
    float layer[MOST][3]; /* number, unused, depth */
    uint8_t texel[4] = { 0 };
    for (int i = 0; i < count; i++) {
        layer[i][0] = (float)i;
        layer[i][2] = s->position[i][2];
    }
    qsort(layer, (size_t)count, sizeof *layer, by_depth);
    float held[4];
    for (int i = 0; i < count; i++) {
        static const float constant[4] = { 0 };
        float result[4];
        gp_texel_load(GP_A8R8G8B8, texel, held);
        gp_blend(&over, constant, GP_A8R8G8B8, s->color[(int)layer[i][0]], held, result);
        gp_texel_store(GP_A8R8G8B8, texel, result, 0);
    }
    gp_texel_load(GP_A8R8G8B8, texel, held);
    return held[2];
}

/* kinds: all depths differ, some are equal, all are, but for one layer behind them. */
static void set_layers(Stack *s, int count, int kind, Random *r)
{
    set_stack(s, GP_A8R8G8B8, count);
    s->draw.state.blend[0] = over;
    for (int i = 0; i < count; i++) {
        s->position[i][2] = kind == 0   ? random_float(r, 0, 1)
                            : kind == 1 ? (float)random_int(r, 0, 9) / 10
                                        : 0.5f;
        s->color[i][2] = random_float(r, 0, 1);
        s->color[i][3] = random_float(r, 0.02f, 0.2f);
    }
    s->position[count - 1][2] = kind == 2 ? 0.9f : s->position[count - 1][2];
}

static uint64_t slices_drawn(const GpDeviceDesc *desc, const GpList *list)
{
    GpDevice *device = device_open(desc);
    assert_int_equal(gp_device_run(device, list, NULL), GP_OK);
    const uint64_t slices = gp_device_counters(device)->sorted_slices;
    gp_device_destroy(&device);
    return slices;
}

/* From one layer to more than a tile remembers, which is then drawn in slices. */
static void any_number_of_layers_is_sorted(void **state)
{
    (void)state;
    static const int counts[] = { 1, 2, 3, 16, 17, 96, 100, 101, MOST };
    static Stack s;
    Random r = { 7 };
    for (size_t i = 0; i < GP_COUNT(counts); i++)
        for (int kind = 0; kind < 3; kind++) {
            set_layers(&s, counts[i], kind, &r);
            const GpList list = { &s.pass, 1 };
            expect_middle(&s, blend_layers(&s, counts[i]));
            const uint64_t slices = slices_drawn(&(GpDeviceDesc){ .threads = 1 }, &list);
            assert_true(counts[i] <= 96 ? slices == 0 : counts[i] == 100 || slices > 0);
            gp_surface_destroy(&s.pass.color[0].surface);
        }
}

/* --- what is told ----------------------------------------------------------------------------- */

typedef struct Told {
    int sorted, outputs;
    uint32_t primitive[8];
    float depth[8];
} Told;

static void note_event(void *user, const GpTraceEvent *event)
{
    Told *told = user;
    if (event->kind == GP_TRACE_SORT) {
        assert_int_equal(event->sort.place, told->sorted);
        assert_int_equal(event->sort.count, 3);
        assert_int_equal(told->outputs, told->sorted); /* the one before has been blended */
        told->primitive[told->sorted] = event->primitive;
        told->depth[told->sorted++] = event->sort.depth;
    } else if (event->kind == GP_TRACE_OUTPUT)
        told->outputs++;
}

static void a_trace_tells_whose_turn_it_is(void **state)
{
    (void)state;
    static Stack s;
    set_stack(&s, GP_A8R8G8B8, 3);
    s.position[0][2] = 0.25f;
    s.position[1][2] = 0.75f;
    s.position[2][2] = 0.5f;
    Told told = { .sorted = 0 };
    const GpDeviceDesc desc = { .executor = GP_EXECUTOR_REFERENCE,
                                .trace = { .event = note_event,
                                           .user = &told,
                                           .one_pixel = true,
                                           .x = SIDE / 2,
                                           .y = SIDE / 2 } };
    run_list_on(&desc, &(GpList){ &s.pass, 1 });
    assert_int_equal(told.outputs, 3);
    assert_true(told.primitive[0] == 1 && told.primitive[1] == 2 && told.primitive[2] == 0);
    assert_true(told.depth[0] == 0.75f && told.depth[1] == 0.5f && told.depth[2] == 0.25f);
    gp_surface_destroy(&s.pass.color[0].surface);
}

static void executors_count_the_same_fragments(void **state)
{
    (void)state;
    static Stack s;
    set_stack(&s, GP_A8R8G8B8, 5);
    for (size_t d = 0; device_here(d); d++) {
        GpDevice *device = device_open(device_here(d));
        assert_int_equal(gp_device_run(device, &(GpList){ &s.pass, 1 }, NULL), GP_OK);
        assert_int_equal(gp_device_counters(device)->fragments_sorted, 5 * (SIDE / 2) * (SIDE / 2));
        gp_device_destroy(&device);
    }
    gp_surface_destroy(&s.pass.color[0].surface);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fragments_are_blended_as_if_they_came_in_order),
        cmocka_unit_test(the_last_in_turn_replaces_and_equal_depths_stay_as_submitted),
        cmocka_unit_test(stencil_is_asked_in_turn),
        cmocka_unit_test(any_number_of_layers_is_sorted),
        cmocka_unit_test(a_trace_tells_whose_turn_it_is),
        cmocka_unit_test(executors_count_the_same_fragments),
    };
    return cmocka_run_group_tests_name("sorted", tests, NULL, NULL);
}
