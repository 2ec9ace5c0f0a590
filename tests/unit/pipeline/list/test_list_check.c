/* Validation: every mistake is refused before the first pixel, with its field's name. */
#include <glasspipe/glasspipe.h>
#include "tests/shaders/exercise.h"
#include "tests/support/unit.h"

#include <math.h>

/* A small valid list that each case breaks in one place. */
typedef struct Frame {
    GpSurface *color, *other, *small, *depth24, *depth16, *borrowed;
    ExerciseUniforms uniforms;
    float vertices[3 * 10];
    uint32_t indices[3];
    GpDraw draw;
    GpPass pass;
    GpList list;
} Frame;

static const uint16_t outside[] = { 0, 1, 9 };
static const GpRect one_pixel = { 0, 0, 1, 1 };

static GpSurface *surface(GpFormat format, uint32_t size, const char *name)
{
    GpSurface *s = NULL;
    GpSurfaceDesc desc = { .format = format, .width = size, .height = size, .name = name };
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
    GpSurface **all[] = { &w->color, &w->other, &w->small, &w->depth24, &w->depth16, &w->borrowed };
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
CASE(passes_missing, w.list.passes = NULL, "passes: NULL, but pass_count is 1")
/* clang-format on */

int main(void)
{
    const struct CMUnitTest tests[] = {
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
        cmocka_unit_test(texture_unbound),
        cmocka_unit_test(texture_is_target),
        cmocka_unit_test(local_of_other_size),
        cmocka_unit_test(sampler_unknown),
        cmocka_unit_test(sampler_lod_nan),
        cmocka_unit_test(compare_on_color),
        cmocka_unit_test(passes_missing),
    };
    return cmocka_run_group_tests_name("list_check", tests, NULL, NULL);
}
