/* Validation: every mistake is refused before the first pixel, with its field's name. */
#include <glasspipe/glasspipe.h>
#include "tests/shaders/exercise.h"
#include "tests/support/unit.h"

#include <math.h>

/* A small valid list that each case breaks in one place. */
typedef struct Frame {
    GpSurface *color, *other, *small, *depth24, *depth16, *flat, *shallow, *borrowed;
    ExerciseUniforms uniforms;
    float vertices[3 * 10];
    uint32_t indices[3];
    GpDraw draw;
    GpPass pass;
    GpList list;
} Frame;

static const uint16_t outside[] = { 0, 1, 9 };
static const GpRect one_pixel = { 0, 0, 1, 1 };
static char long_text[400];

static GpSurface *surface(GpFormat format, uint32_t size, const char *name)
{
    GpSurface *s = NULL;
    GpSurfaceDesc desc = { .format = format, .width = size, .height = size, .name = name };
    assert_int_equal(gp_surface_create(&desc, &s, NULL), GP_OK);
    return s;
}

static GpSurface *part(uint32_t width, uint32_t height, GpRect window, const char *name)
{
    GpSurface *s = NULL;
    const GpSurfaceDesc desc = {
        .format = GP_A8R8G8B8, .width = width, .height = height, .window = window, .name = name
    };
    assert_int_equal(gp_surface_create(&desc, &s, NULL), GP_OK);
    return s;
}

static void set_up(Frame *w)
{
    memset(w, 0, sizeof *w);
    w->color = surface(GP_A8R8G8B8, 16, "color");
    w->other = surface(GP_A16B16G16R16F, 16, "other");
    w->small = surface(GP_A8R8G8B8, 8, "small");
    w->depth24 = surface(GP_D24S8, 16, "depth24");
    w->depth16 = surface(GP_D16, 16, "depth16");
    w->shallow = surface(GP_D16, 8, "shallow");
    w->flat = part(16, 8, (GpRect){ 0 }, "flat");
    memset(long_text, 'x', sizeof long_text - 1);
    const uint32_t stride = 10 * sizeof(float);
    w->draw = (GpDraw){
        .name = "tri",
        .program = &exercise_color,
        .uniforms = &w->uniforms,
        .geometry = { .vertex_count = 3,
                      .indices = w->indices,
                      .index_count = 3,
                      .streams = { [GP_POSITION] = { w->vertices, stride, 4, GP_FLOAT32 },
                                   [GP_COLOR] = { w->vertices + 4, stride, 4, GP_FLOAT32 },
                                   [GP_TEXCOORD0] = { w->vertices + 8, stride, 2, GP_FLOAT32 } } },
    };
    w->pass = (GpPass){ .name = "main",
                        .color[0] = { .surface = w->color },
                        .depth = { .surface = w->depth24 },
                        .draws = &w->draw,
                        .draw_count = 1 };
    w->list = (GpList){ &w->pass, 1 };
}

/* Another name for the colour target's memory. */
static void borrow(Frame *w, GpFormat format, GpSurface **surface)
{
    const GpSurfaceDesc desc = {
        .format = format, .width = 16, .height = 16, .memory = w->color->level[0].texels
    };
    gp_surface_destroy(&w->borrowed);
    assert_int_equal(gp_surface_create(&desc, &w->borrowed, NULL), GP_OK);
    *surface = w->borrowed;
}

static void ternary(Frame *w, GpCompare test, bool write, float epsilon)
{
    w->draw.state.depth = (GpDepthState){ test, write, true, epsilon };
}

static void tear_down(Frame *w)
{
    GpSurface **all[] = { &w->color,   &w->other, &w->small,   &w->depth24,
                          &w->depth16, &w->flat,  &w->shallow, &w->borrowed };
    for (size_t i = 0; i < GP_COUNT(all); i++)
        gp_surface_destroy(all[i]);
}

static void refuses(const Frame *w, const char *expected)
{
    GpError error = { "" };
    assert_int_equal(gp_list_check(&w->list, &error), GP_ERROR_INVALID);
    if (!strstr(error.text, expected))
        fail_msg("'%s' does not say '%s'", error.text, expected);
}

/* One broken thing a line: what is done to a valid list, and what the message must hold. */
#define CASE(name, change, expected)                                                               \
    static void name(void **state)                                                                 \
    {                                                                                              \
        (void)state;                                                                               \
        Frame w;                                                                                   \
        set_up(&w);                                                                                \
        assert_int_equal(gp_list_check(&w.list, NULL), GP_OK);                                     \
        change;                                                                                    \
        refuses(&w, expected);                                                                     \
        tear_down(&w);                                                                             \
    }

#define IN_PASS "pass 0 'main': "
#define IN_DRAW "pass 0 'main', draw 0 'tri': "

/* clang-format off */
CASE(no_target, (w.pass.color[0].surface = NULL, w.pass.depth.surface = NULL),
     IN_PASS "color[0].surface: the pass has no target at all")
CASE(gap_in_targets, w.pass.color[2].surface = w.other, IN_PASS "color[2].surface: targets in use")
CASE(target_twice, w.pass.color[1].surface = w.color, IN_PASS "color[1].surface: is also color[0]")
CASE(depth_as_color, w.pass.color[0].surface = w.depth16, "D16 is no render target format")
CASE(color_as_depth, w.pass.depth.surface = w.color, "A8R8G8B8 is no depth format")
CASE(sizes_differ, w.pass.color[1].surface = w.small, "'small' is 8x8, but the pass is 16x16")
CASE(clear_of_no_stencil, (w.pass.depth.surface = w.depth16, w.pass.depth.clear_stencil = true),
     "depth.clear_stencil: D16 has no stencil")
CASE(clear_depth_of_two, (w.pass.depth.clear_depth = true, w.pass.depth.depth_value = 2),
     "depth.depth_value: expected a number in [0, 1]")
CASE(rectangles_missing, (w.pass.color[0].clear = true, w.pass.clear_rect_count = 2),
     IN_PASS "clear_rects: NULL, but clear_rect_count is 2")
CASE(rectangles_of_nothing, (w.pass.clear_rects = &one_pixel,
                             w.pass.clear_rect_count = 1), "clear_rects: the pass clears nothing")
CASE(memory_twice, borrow(&w, GP_X8R8G8B8, &w.pass.color[1].surface),
     "color[1].surface: shares memory with color[0]")
CASE(memory_of_depth, borrow(&w, GP_D24S8, &w.pass.depth.surface),
     "depth.surface: shares memory with color[0]")
CASE(draws_missing, w.pass.draws = NULL, IN_PASS "draws: NULL")
CASE(program_missing, w.draw.program = NULL, IN_DRAW "program: NULL")
CASE(uniforms_missing, w.draw.uniforms = NULL, IN_DRAW "uniforms: NULL")
CASE(targets_missing, w.draw.program = &exercise_targets4, "writes target 1, which the pass")
CASE(stream_missing, w.draw.geometry.streams[GP_COLOR].data = NULL, "geometry.streams[")
CASE(stream_of_nine, w.draw.geometry.streams[GP_COLOR].components = 9, "has 9 components")
CASE(stream_type, w.draw.geometry.streams[GP_COLOR].type = (GpComponentType)99, "component type")
CASE(index_out_of_range, w.indices[1] = 3, "geometry.indices: index 1 is 3, but there are 3")
CASE(short_index_out_of_range, (w.draw.geometry.indices = NULL,
                                w.draw.geometry.indices16 = outside),
     "geometry.indices16: index 2 is 9, but there are 3")
CASE(indices_twice, w.draw.geometry.indices16 = outside,
     "geometry.indices16: there are indices of 32 bits too")
CASE(strip_of_two, (w.draw.geometry.primitive = GP_TRIANGLE_STRIP,
                    w.draw.geometry.index_count = 2), "2 of a triangle strip make no triangle")
CASE(fan_of_one, (w.draw.geometry.primitive = GP_TRIANGLE_FAN, w.draw.geometry.indices = NULL,
                  w.draw.geometry.vertex_count = 1), "geometry.vertex_count: 1 of a triangle fan")
CASE(color_of_three, (w.draw.geometry.streams[GP_COLOR].type = GP_D3DCOLOR,
                      w.draw.geometry.streams[GP_COLOR].components = 3), "a D3DCOLOR has 4")
CASE(half_a_triangle, w.draw.geometry.index_count = 2, "geometry.index_count: 2 is no multiple")
CASE(primitive_unknown, w.draw.geometry.primitive = (GpPrimitive)5, "geometry.primitive")
CASE(viewport_without_size, w.draw.viewport.x = 3, "viewport: has a place but no size")
CASE(viewport_negative, (w.draw.viewport.width = -3, w.draw.viewport.height = 3), "viewport: ")
CASE(viewport_nan, w.draw.viewport = ((GpViewport){ .y = NAN, .width = 4, .height = 4 }),
     "viewport: x and y")
CASE(viewport_depth, (w.draw.viewport.min_depth = 0.5f, w.draw.viewport.max_depth = 0.25f),
     "min_depth <= max_depth")
CASE(cull_unknown, w.draw.state.raster.cull = (GpCull)3, "state.raster.cull")
CASE(bias_infinite, w.draw.state.raster.depth_bias = INFINITY, "state.raster.depth_bias")
CASE(scissor_backwards, (w.draw.state.raster.scissor = true, w.draw.state.raster.scissor_x0 = 4),
     "state.raster.scissor")
CASE(seventh_plane, w.draw.state.raster.clip_planes = 64, "state.raster.clip_planes")
CASE(depth_without_target, (w.pass.depth.surface = NULL, w.draw.state.depth.write = true),
     "state.depth: is on, but the pass has no depth target")
CASE(depth_test_unknown, w.draw.state.depth.test = (GpCompare)8, "state.depth.test")
CASE(epsilon_negative, w.draw.state.depth.epsilon = -0.5f,
     "state.depth.epsilon: expected a finite number from 0 on")
CASE(epsilon_infinite, ternary(&w, GP_LESS_EQUAL, true, INFINITY), "state.depth.epsilon: expected")
CASE(epsilon_nan, ternary(&w, GP_LESS_EQUAL, true, NAN), "state.depth.epsilon: expected")
CASE(order_unknown, w.pass.order = (GpOrder)7, "order: unknown")
CASE(epsilon_alone, w.draw.state.depth.epsilon = 0.5f, "is of the ternary test, which is off")
CASE(ternary_less, ternary(&w, GP_LESS, true, 0.5f),
     "state.depth.ternary: needs the test less-equal, and write")
CASE(ternary_without_write, ternary(&w, GP_LESS_EQUAL, false, 0), "state.depth.ternary: needs")
CASE(ternary_without_depth, (ternary(&w, GP_LESS_EQUAL, true, 0), w.pass.depth.surface = NULL),
     "state.depth: is on, but the pass has no depth target")
CASE(alpha_test_unknown, w.draw.state.alpha_test.test = (GpCompare)-1, "state.alpha_test.test")
CASE(stencil_without_bits, (w.pass.depth.surface = w.depth16, w.draw.state.stencil.enable = true),
     "state.stencil.enable")
CASE(stencil_op_unknown, (w.draw.state.stencil.enable = true,
                          w.draw.state.stencil.back.pass = (GpStencilOp)8), "state.stencil: ")
CASE(blend_op_unknown, w.draw.state.blend[0].op = (GpBlendOp)20, "state.blend[0]: unknown")
CASE(saturate_as_destination, w.draw.state.blend[1].dst = GP_SRC_ALPHA_SAT, "source factor only")
CASE(alpha_alone, w.draw.state.blend[0].alpha_op = GP_BLEND_ADD, "alpha blends, but colour")
CASE(logic_on_floats, (w.pass.color[0].surface = w.other,
                       w.draw.state.blend[0].op = GP_BLEND_LOGIC_OR), "need an unorm target")
CASE(logic_half, (w.draw.state.blend[0].op = GP_BLEND_LOGIC_OR,
                  w.draw.state.blend[0].alpha_op = GP_BLEND_ADD), "colour and alpha alike")
CASE(logic_differs, (w.draw.state.blend[0].op = GP_BLEND_LOGIC_OR,
                     w.draw.state.blend[0].alpha_op = GP_BLEND_LOGIC_AND), "colour and alpha alike")
CASE(texture_unbound, w.draw.program = &exercise_local, IN_DRAW "textures[3].surface: not bound")
CASE(texture_is_target, (w.draw.program = &exercise_local, w.draw.textures[3].surface = w.color),
     "'color' is a render target of this pass")
CASE(local_of_other_size, (w.draw.program = &exercise_local,
                           w.draw.textures[3].surface = w.small), "read in place it must be 16x16")
CASE(sampler_unknown, (w.draw.program = &exercise_local, w.draw.textures[3].surface = w.other,
                       w.draw.textures[3].sampler.mip = (GpMipFilter)4), "filter or address")
CASE(sampler_lod_nan, (w.draw.program = &exercise_local, w.draw.textures[3].surface = w.other,
                       w.draw.textures[3].sampler.lod_bias = NAN), "must be finite")
CASE(compare_on_color, (w.draw.program = &exercise_local, w.draw.textures[3].surface = w.other,
                        w.draw.textures[3].sampler.compare = true), "is no depth format")
CASE(height_differs, w.pass.color[1].surface = w.flat, "'flat' is 16x8, but the pass is 16x16")
CASE(depth_of_other_size, w.pass.depth.surface = w.shallow, IN_PASS "depth.surface: 'shallow' is 8x8")
CASE(local_of_other_height, (w.draw.program = &exercise_local,
                             w.draw.textures[3].surface = w.flat), "read in place it must be 16x16")
CASE(stencil_without_depth, (w.pass.depth.surface = NULL, w.draw.state.stencil.enable = true),
     "state.stencil.enable: the pass has no stencil bits")
CASE(long_name, (w.pass.name = long_text, w.draw.program = NULL), "xxxxxxxx: program: NULL")
CASE(nameless, (w.pass.name = w.draw.name = NULL, w.draw.program = NULL), "pass 0 '', draw 0 '': ")
CASE(passes_missing, w.list.passes = NULL, "passes: NULL, but pass_count is 1")
/* clang-format on */

/* What a row of the tables below does to a valid list: one member of the draw is another. */
static void refuses_member(size_t offset, const void *value, size_t size, const char *expected)
{
    Frame w;
    set_up(&w);
    w.draw.program = &exercise_local;
    w.draw.textures[3].surface = w.other;
    w.draw.state.stencil.enable = true;
    assert_int_equal(gp_list_check(&w.list, NULL), GP_OK);
    memcpy((char *)&w.draw + offset, value, size);
    refuses(&w, expected);
    tear_down(&w);
}

/* Windows of one picture: the pass's, another, and the whole. */
static void a_pass_has_one_window(void **state)
{
    (void)state;
    Frame w;
    set_up(&w);
    GpSurface *left = part(256, 128, (GpRect){ 0, 0, 128, 128 }, "left");
    GpSurface *again = part(256, 128, (GpRect){ 0, 0, 128, 128 }, "again");
    GpSurface *right = part(256, 128, (GpRect){ 128, 0, 256, 128 }, "right");
    GpSurface *whole = part(256, 128, (GpRect){ 0 }, "whole");
    GpSurface *depth = NULL;
    const GpSurfaceDesc desc = { .format = GP_D16, .width = 256, .height = 128, .name = "depth" };
    assert_int_equal(gp_surface_create(&desc, &depth, NULL), GP_OK);
    w.pass.color[0].surface = left;
    w.pass.depth.surface = NULL;
    assert_int_equal(gp_list_check(&w.list, NULL), GP_OK);
    w.pass.color[1].surface = right;
    refuses(&w, IN_PASS "color: 'right' has another window than the pass");
    w.pass.color[1].surface = again;
    assert_int_equal(gp_list_check(&w.list, NULL), GP_OK);
    w.pass.depth.surface = depth;
    refuses(&w, IN_PASS "depth.surface: 'depth' has another window than the pass");
    w.pass.depth.surface = NULL;
    w.pass.color[1].surface = NULL;
    w.draw.program = &exercise_local;
    GpTexture *read = &w.draw.textures[3];
    read->surface = right;
    refuses(&w, "textures[3].surface: 'right' has another window than the pass");
    read->surface = again;
    assert_int_equal(gp_list_check(&w.list, NULL), GP_OK);
    read->surface = whole;
    assert_int_equal(gp_list_check(&w.list, NULL), GP_OK);
    w.draw.program = &exercise_texture;
    for (int i = 0; i < GP_MAX_SAMPLERS; i++)
        w.draw.textures[i].surface = again;
    refuses(&w, "'again' has a window: it is read only in place");
    GpSurface **all[] = { &left, &again, &right, &whole, &depth };
    for (size_t i = 0; i < GP_COUNT(all); i++)
        gp_surface_destroy(all[i]);
    tear_down(&w);
}

static void every_enumeration_ends(void **state)
{
    (void)state;
    static const struct {
        size_t offset;
        int count;
        const char *says;
    } rows[] = {
        { offsetof(GpDraw, state.raster.cull), GP_CULLS, "state.raster.cull: unknown" },
        { offsetof(GpDraw, state.depth.test), GP_COMPARES, "state.depth.test: unknown" },
        { offsetof(GpDraw, state.alpha_test.test), GP_COMPARES, "state.alpha_test.test: unknown" },
        { offsetof(GpDraw, state.stencil.front.test), GP_COMPARES, "state.stencil: unknown" },
        { offsetof(GpDraw, state.stencil.front.fail), GP_STENCIL_OPS, "state.stencil: unknown" },
        { offsetof(GpDraw, state.stencil.front.depth_fail), GP_STENCIL_OPS,
          "state.stencil: unknown" },
        { offsetof(GpDraw, state.stencil.front.pass), GP_STENCIL_OPS, "state.stencil: unknown" },
        { offsetof(GpDraw, state.stencil.back.test), GP_COMPARES, "state.stencil: unknown" },
        { offsetof(GpDraw, state.blend[0].op), GP_BLEND_OPS, "state.blend[0]: unknown" },
        { offsetof(GpDraw, state.blend[0].src), GP_BLEND_FACTORS, "state.blend[0]: unknown" },
        { offsetof(GpDraw, state.blend[0].dst), GP_BLEND_FACTORS, "state.blend[0]: unknown" },
        { offsetof(GpDraw, state.blend[1].alpha_op), GP_BLEND_OPS, "state.blend[1]: unknown" },
        { offsetof(GpDraw, state.blend[2].alpha_src), GP_BLEND_FACTORS, "state.blend[2]: unknown" },
        { offsetof(GpDraw, state.blend[3].alpha_dst), GP_BLEND_FACTORS, "state.blend[3]: unknown" },
        { offsetof(GpDraw, textures[3].sampler.min), GP_FILTERS, "filter or address" },
        { offsetof(GpDraw, textures[3].sampler.mag), GP_FILTERS, "filter or address" },
        { offsetof(GpDraw, textures[3].sampler.mip), GP_MIP_FILTERS, "filter or address" },
        { offsetof(GpDraw, textures[3].sampler.address_u), GP_ADDRESSES, "filter or address" },
        { offsetof(GpDraw, textures[3].sampler.address_v), GP_ADDRESSES, "filter or address" },
        { offsetof(GpDraw, geometry.primitive), GP_PRIMITIVES, "geometry.primitive: unknown" },
        { offsetof(GpDraw, geometry.streams[GP_COLOR].type), GP_COMPONENT_TYPES, "component type" },
        { offsetof(GpDraw, geometry.streams[GP_COLOR].components), 0, "has 0 components" },
        { offsetof(GpDraw, state.blend[1].alpha_dst), GP_SRC_ALPHA_SAT, "source factor only" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        refuses_member(rows[i].offset, &rows[i].count, sizeof rows[i].count, rows[i].says);
}

static void every_number_has_a_range(void **state)
{
    (void)state;
    static const struct {
        size_t offset;
        float value;
        const char *says;
    } rows[] = {
        { offsetof(GpDraw, viewport.y), 3, "viewport: has a place but no size" },
        { offsetof(GpDraw, viewport.x), NAN, "viewport: has a place but no size" },
        { offsetof(GpDraw, viewport.width), 3, "viewport: width and height must be in" },
        { offsetof(GpDraw, viewport.height), 3, "viewport: width and height must be in" },
        { offsetof(GpDraw, viewport.min_depth), -0.5f, "expected 0 <= min_depth" },
        { offsetof(GpDraw, viewport.min_depth), 1.5f, "expected 0 <= min_depth" },
        { offsetof(GpDraw, viewport.max_depth), -0.5f, "expected 0 <= min_depth" },
        { offsetof(GpDraw, viewport.max_depth), 1.5f, "expected 0 <= min_depth" },
        { offsetof(GpDraw, state.raster.depth_bias), NAN, "state.raster.depth_bias" },
        { offsetof(GpDraw, state.raster.slope_depth_bias), INFINITY, "state.raster.depth_bias" },
        { offsetof(GpDraw, textures[3].sampler.lod_bias), INFINITY, "must be finite" },
        { offsetof(GpDraw, textures[3].sampler.min_lod), NAN, "must be finite" },
        { offsetof(GpDraw, textures[3].sampler.max_lod), INFINITY, "must be finite" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        refuses_member(rows[i].offset, &rows[i].value, sizeof rows[i].value, rows[i].says);
    const float most = 2.0f * GP_MAX_SIZE;
    static const GpViewport good = { .x = -3, .y = 4, .width = 5, .height = 6 };
    const struct {
        GpViewport viewport;
        const char *says;
    } viewports[] = {
        { { .x = -2 * most, .y = 4, .width = 5, .height = 6 }, "viewport: x and y" },
        { { .x = -3, .y = NAN, .width = 5, .height = 6 }, "viewport: x and y" },
        { { .x = -3, .y = 4, .width = 2 * most, .height = 6 }, "viewport: width and height" },
        { { .x = -3, .y = 4, .width = 5, .height = -6 }, "viewport: width and height" },
        { { .x = -3, .y = 4, .width = 5, .height = 2 * most }, "viewport: width and height" },
        { { .x = -3, .y = 4, .width = NAN, .height = 6 }, "viewport: width and height" },
    };
    Frame w;
    set_up(&w);
    w.draw.viewport = good;
    assert_int_equal(gp_list_check(&w.list, NULL), GP_OK);
    tear_down(&w);
    for (size_t i = 0; i < GP_COUNT(viewports); i++)
        refuses_member(offsetof(GpDraw, viewport), &viewports[i].viewport, sizeof(GpViewport),
                       viewports[i].says);
    GpRasterState upright = { .scissor = true, .scissor_x1 = 4, .scissor_y0 = 4, .scissor_y1 = 3 };
    refuses_member(offsetof(GpDraw, state.raster), &upright, sizeof upright,
                   "state.raster.scissor");
}

static void what_asks_for_nothing_may_miss_what_it_would_need(void **state)
{
    (void)state;
    Frame w;
    set_up(&w);
    w.pass.depth = (GpDepthTarget){ .clear_depth = true, .clear_stencil = true, .depth_value = 2 };
    w.draw.state.stencil.front.test = (GpCompare)99; /* off */
    w.draw.geometry.indices = NULL;
    w.draw.geometry.vertex_count = 0;
    w.draw.geometry.streams[GP_POSITION].data = NULL;
    assert_int_equal(gp_list_check(&w.list, NULL), GP_OK);
    w.pass.depth =
        (GpDepthTarget){ .surface = w.depth24, .clear_depth = true, .depth_value = -0.5f };
    refuses(&w, "depth.depth_value: expected a number in [0, 1]");
    tear_down(&w);
}

/* Draws that are as the one before them are right as that one is: what one has of its own is looked
 * at. */
static void a_draw_is_refused_for_what_differs_from_the_one_before(void **state)
{
    (void)state;
    Frame w;
    set_up(&w);
    GpDraw draws[3] = { w.draw, w.draw, w.draw };
    w.pass.draws = draws;
    w.pass.draw_count = 3;
    assert_int_equal(gp_list_check(&w.list, NULL), GP_OK);
    draws[2].uniforms = NULL;
    refuses(&w, "draw 2 'tri': uniforms: NULL");
    draws[2] = w.draw;
    draws[2].geometry.vertex_count = 2;
    w.indices[2] = 2;
    refuses(&w, "draw 2 'tri': geometry.indices: index 2 is 2, but there are 2");
    draws[2] = w.draw;
    draws[2].geometry.streams[GP_COLOR].data = NULL;
    refuses(&w, "draw 2 'tri': geometry.streams[");
    draws[2] = w.draw;
    draws[2].state.blend[3].alpha_op = GP_BLEND_ADD;
    refuses(&w, "draw 2 'tri': state.blend[3]: alpha blends, but colour");
    draws[2] = w.draw;
    draws[2].viewport.max_depth = -1;
    refuses(&w, "draw 2 'tri': viewport: ");
    draws[2] = w.draw;
    draws[2].program = &exercise_targets4;
    refuses(&w, "draw 2 'tri': program: ");
    draws[1].program = draws[2].program = &exercise_local; /* which reads a texture */
    draws[1].textures[3].surface = w.other;
    refuses(&w, "draw 2 'tri': textures[3].surface: not bound");
    tear_down(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_draw_is_refused_for_what_differs_from_the_one_before),
        cmocka_unit_test(no_target),
        cmocka_unit_test(gap_in_targets),
        cmocka_unit_test(target_twice),
        cmocka_unit_test(depth_as_color),
        cmocka_unit_test(color_as_depth),
        cmocka_unit_test(sizes_differ),
        cmocka_unit_test(clear_of_no_stencil),
        cmocka_unit_test(clear_depth_of_two),
        cmocka_unit_test(rectangles_missing),
        cmocka_unit_test(rectangles_of_nothing),
        cmocka_unit_test(memory_twice),
        cmocka_unit_test(memory_of_depth),
        cmocka_unit_test(draws_missing),
        cmocka_unit_test(program_missing),
        cmocka_unit_test(uniforms_missing),
        cmocka_unit_test(targets_missing),
        cmocka_unit_test(stream_missing),
        cmocka_unit_test(stream_of_nine),
        cmocka_unit_test(stream_type),
        cmocka_unit_test(index_out_of_range),
        cmocka_unit_test(short_index_out_of_range),
        cmocka_unit_test(indices_twice),
        cmocka_unit_test(strip_of_two),
        cmocka_unit_test(fan_of_one),
        cmocka_unit_test(color_of_three),
        cmocka_unit_test(half_a_triangle),
        cmocka_unit_test(primitive_unknown),
        cmocka_unit_test(viewport_without_size),
        cmocka_unit_test(viewport_negative),
        cmocka_unit_test(viewport_nan),
        cmocka_unit_test(viewport_depth),
        cmocka_unit_test(cull_unknown),
        cmocka_unit_test(bias_infinite),
        cmocka_unit_test(scissor_backwards),
        cmocka_unit_test(seventh_plane),
        cmocka_unit_test(depth_without_target),
        cmocka_unit_test(depth_test_unknown),
        cmocka_unit_test(epsilon_negative),
        cmocka_unit_test(epsilon_infinite),
        cmocka_unit_test(epsilon_nan),
        cmocka_unit_test(epsilon_alone),
        cmocka_unit_test(order_unknown),
        cmocka_unit_test(ternary_less),
        cmocka_unit_test(ternary_without_write),
        cmocka_unit_test(ternary_without_depth),
        cmocka_unit_test(alpha_test_unknown),
        cmocka_unit_test(stencil_without_bits),
        cmocka_unit_test(stencil_op_unknown),
        cmocka_unit_test(blend_op_unknown),
        cmocka_unit_test(saturate_as_destination),
        cmocka_unit_test(alpha_alone),
        cmocka_unit_test(logic_on_floats),
        cmocka_unit_test(logic_half),
        cmocka_unit_test(logic_differs),
        cmocka_unit_test(texture_unbound),
        cmocka_unit_test(texture_is_target),
        cmocka_unit_test(local_of_other_size),
        cmocka_unit_test(sampler_unknown),
        cmocka_unit_test(sampler_lod_nan),
        cmocka_unit_test(compare_on_color),
        cmocka_unit_test(height_differs),
        cmocka_unit_test(depth_of_other_size),
        cmocka_unit_test(local_of_other_height),
        cmocka_unit_test(stencil_without_depth),
        cmocka_unit_test(long_name),
        cmocka_unit_test(nameless),
        cmocka_unit_test(passes_missing),
        cmocka_unit_test(a_pass_has_one_window),
        cmocka_unit_test(every_enumeration_ends),
        cmocka_unit_test(every_number_has_a_range),
        cmocka_unit_test(what_asks_for_nothing_may_miss_what_it_would_need),
    };
    return cmocka_run_group_tests_name("list_check", tests, NULL, NULL);
}
