/* Depth and stencil: every compare function, every operation, both faces, on stored codes. */
#include "pipeline/units/depth_stencil.h"
#include "tests/support/unit.h"

static GpSurface *one_texel(GpFormat format, float depth, uint8_t stencil)
{
    GpSurface *surface = NULL;
    assert_int_equal(
        gp_surface_create(&(GpSurfaceDesc){ .format = format, .width = 1, .height = 1 }, &surface,
                          NULL),
        GP_OK);
    gp_surface_clear_depth(surface, depth, stencil, true, true);
    return surface;
}

static GpQuad one_pixel(float depth, bool front)
{
    GpQuad quad = { .mask = 1, .front = front };
    quad.depth[0] = depth;
    return quad;
}

static GpDepthStencil unit_on(GpSurface *surface)
{
    return (GpDepthStencil){ .surface = surface, .max_depth = 1 };
}

static bool relation_holds(GpCompare test, int order) /* order: sign of incoming - stored */
{
    switch (test) {
    case GP_NEVER:
        return false;
    case GP_LESS:
        return order < 0;
    case GP_EQUAL:
        return order == 0;
    case GP_LESS_EQUAL:
        return order <= 0;
    case GP_GREATER:
        return order > 0;
    case GP_NOT_EQUAL:
        return order != 0;
    case GP_GREATER_EQUAL:
        return order >= 0;
    default:
        return true;
    }
}

static void every_depth_compare_in_every_format(void **state)
{
    (void)state;
    static const GpFormat formats[] = { GP_D16, GP_D24S8, GP_D32F };
    static const float incoming[] = { 0.25f, 0.5f, 0.75f };
    for (size_t f = 0; f < GP_COUNT(formats); f++)
        for (int test = 0; test < GP_COMPARES; test++)
            for (int order = -1; order <= 1; order++) {
                GpSurface *surface = one_texel(formats[f], 0.5f, 0);
                GpDepthStencil unit = unit_on(surface);
                unit.depth = (GpDepthState){ .test = (GpCompare)test, .write = true };
                GpQuad quad = one_pixel(incoming[order + 1], true);
                gp_depth_stencil(&unit, &quad);
                bool passes = relation_holds((GpCompare)test, order);
                assert_int_equal(quad.mask, passes);
                uint32_t code;
                uint8_t stencil;
                gp_depth_load(formats[f], surface->level[0].texels, &code, &stencil);
                assert_int_equal(code,
                                 gp_depth_code(formats[f], passes ? incoming[order + 1] : 0.5f));
                gp_surface_destroy(&surface);
            }
}

static void depth_is_kept_where_writing_is_off(void **state)
{
    (void)state;
    GpSurface *surface = one_texel(GP_D24S8, 0.5f, 7);
    GpDepthStencil unit = unit_on(surface);
    unit.depth.test = GP_LESS;
    GpQuad quad = one_pixel(0.1f, true);
    gp_depth_stencil(&unit, &quad);
    assert_int_equal(quad.mask, 1);
    uint32_t code;
    uint8_t stencil;
    gp_depth_load(GP_D24S8, surface->level[0].texels, &code, &stencil);
    assert_int_equal(code, gp_depth_code(GP_D24S8, 0.5f));
    assert_int_equal(stencil, 7);
    gp_surface_destroy(&surface);
}

static void r18_shader_depth_is_clamped_to_the_viewport_range(void **state)
{
    (void)state;
    static const float wild[] = { -3, 7 };
    for (int i = 0; i < 2; i++) {
        GpSurface *surface = one_texel(GP_D32F, 0.5f, 0);
        GpDepthStencil unit = unit_on(surface);
        unit.min_depth = 0.25f;
        unit.max_depth = 0.75f;
        unit.depth.write = true;
        GpQuad quad = one_pixel(wild[i], true);
        gp_depth_stencil(&unit, &quad);
        assert_int_equal(quad.depth_incoming[0], gp_float_bits(i ? 0.75f : 0.25f));
        gp_surface_destroy(&surface);
    }
}

static void r21_compares_converted_values_not_floats(void **state)
{
    (void)state;
    float a = 0.5f, b = 0.5f + 1e-6f; /* differ as floats, same code in 16 bits */
    assert_int_equal(gp_depth_code(GP_D16, a), gp_depth_code(GP_D16, b));
    GpSurface *surface = one_texel(GP_D16, b, 0);
    GpDepthStencil unit = unit_on(surface);
    unit.depth.test = GP_LESS;
    GpQuad quad = one_pixel(a, true);
    gp_depth_stencil(&unit, &quad);
    assert_int_equal(quad.mask, 0);
    gp_surface_destroy(&surface);
}

/* A stored code, and those that lie at epsilon from it and one beyond, on both sides. */
static void ternary_verdicts_turn_one_code_beyond_epsilon(void **state)
{
    (void)state;
    static const GpFormat formats[] = { GP_D16, GP_D24S8, GP_D32F };
    const float epsilon = 0.125f, depth = 0.5f;
    for (size_t f = 0; f < GP_COUNT(formats); f++) {
        const uint32_t stored = gp_depth_code(formats[f], depth);
        const uint32_t far = gp_depth_put_back(formats[f], stored, epsilon);
        uint32_t near = gp_depth_code(formats[f], depth - epsilon);
        while (gp_depth_put_back(formats[f], near, epsilon) < stored)
            near++;
        while (gp_depth_put_back(formats[f], near - 1, epsilon) >= stored)
            near--;
        assert_true(near < stored && stored < far);
        const struct {
            uint32_t code;
            bool passes, replaces;
        } cases[] = { { near - 1, true, true },
                      { near, true, false },
                      { stored, true, false },
                      { far, true, false },
                      { far + 1, false, false } };
        for (size_t i = 0; i < GP_COUNT(cases); i++) {
            GpSurface *surface = one_texel(formats[f], depth, 3);
            GpDepthStencil unit = unit_on(surface);
            unit.depth = (GpDepthState){ GP_LESS_EQUAL, true, true, epsilon };
            GpQuad quad = one_pixel(gp_depth_from_code(formats[f], cases[i].code), true);
            gp_depth_stencil(&unit, &quad);
            assert_int_equal(quad.depth_incoming[0], cases[i].code);
            assert_int_equal(quad.mask, cases[i].passes);
            assert_int_equal(quad.replaced, cases[i].replaces);
            uint32_t code;
            uint8_t stencil;
            gp_depth_load(formats[f], surface->level[0].texels, &code, &stencil);
            assert_int_equal(code, cases[i].code < stored ? cases[i].code : stored);
            gp_surface_destroy(&surface);
        }
    }
}

static void what_fails_the_stencil_replaces_nothing(void **state)
{
    (void)state;
    GpSurface *surface = one_texel(GP_D24S8, 0.5f, 3);
    GpDepthStencil unit = unit_on(surface);
    unit.depth = (GpDepthState){ GP_LESS_EQUAL, true, true, 0.1f };
    unit.stencil = (GpStencilState){ .enable = true, .reference = 4, .front = { GP_EQUAL } };
    GpQuad quad = one_pixel(0.1f, true);
    gp_depth_stencil(&unit, &quad);
    assert_true(quad.mask == 0 && quad.replaced == 0);
    gp_surface_destroy(&surface);
}

/* Runs one pixel against a stencil value; returns what is stored after. */
static uint8_t run_stencil(const GpStencilState *stencil, uint8_t stored, bool front,
                           bool depth_passes, bool *passed)
{
    GpSurface *surface = one_texel(GP_D24S8, 0.5f, stored);
    GpDepthStencil unit = unit_on(surface);
    unit.stencil = *stencil;
    unit.stencil.enable = true;
    unit.depth.test = GP_LESS;
    GpQuad quad = one_pixel(depth_passes ? 0.25f : 0.75f, front);
    gp_depth_stencil(&unit, &quad);
    *passed = quad.mask == 1;
    uint32_t code;
    uint8_t after;
    gp_depth_load(GP_D24S8, surface->level[0].texels, &code, &after);
    gp_surface_destroy(&surface);
    return after;
}

static uint8_t expected_op(GpStencilOp op, int stored, int reference)
{
    const int table[GP_STENCIL_OPS] = {
        [GP_STENCIL_KEEP] = stored,
        [GP_STENCIL_ZERO] = 0,
        [GP_STENCIL_REPLACE] = reference,
        [GP_STENCIL_INCR_SAT] = stored + 1 > 255 ? 255 : stored + 1,
        [GP_STENCIL_DECR_SAT] = stored - 1 < 0 ? 0 : stored - 1,
        [GP_STENCIL_INVERT] = 255 - stored,
        [GP_STENCIL_INCR] = (stored + 1) % 256,
        [GP_STENCIL_DECR] = (stored + 255) % 256,
    };
    return (uint8_t)table[op];
}

static void r39_every_operation_on_every_value(void **state)
{
    (void)state;
    for (int op = 0; op < GP_STENCIL_OPS; op++)
        for (int value = 0; value < 256; value++)
            assert_int_equal(gp_stencil_apply((GpStencilOp)op, (uint8_t)value, 0x5a),
                             expected_op((GpStencilOp)op, value, 0x5a));
}

static void each_outcome_has_its_own_operation(void **state)
{
    (void)state;
    bool passed;
    GpStencilState s = {
        .reference = 9, .front = { GP_EQUAL, GP_STENCIL_ZERO, GP_STENCIL_INVERT, GP_STENCIL_INCR }
    };
    assert_int_equal(run_stencil(&s, 5, true, true, &passed), 0); /* stencil fails */
    assert_false(passed);
    assert_int_equal(run_stencil(&s, 9, true, false, &passed), 246); /* depth fails */
    assert_false(passed);
    assert_int_equal(run_stencil(&s, 9, true, true, &passed), 10); /* both pass */
    assert_true(passed);
}

static void every_stencil_compare_is_reference_against_stored(void **state)
{
    (void)state;
    for (int test = 0; test < GP_COMPARES; test++)
        for (int order = -1; order <= 1; order++) {
            bool passed;
            GpStencilState s = { .reference = (uint8_t)(100 + order),
                                 .front.test = (GpCompare)test };
            run_stencil(&s, 100, true, true, &passed);
            assert_int_equal(passed, relation_holds((GpCompare)test, order));
        }
}

static void ignored_bits_are_not_compared_and_kept_bits_not_written(void **state)
{
    (void)state;
    bool passed;
    GpStencilState s = { .reference = 0x35,
                         .ignore = 0xf0,
                         .keep = 0x0f,
                         .front = { .test = GP_EQUAL, .pass = GP_STENCIL_REPLACE } };
    assert_int_equal(run_stencil(&s, 0xa5, true, true, &passed), 0x35);
    assert_true(passed);
    s.front.pass = GP_STENCIL_ZERO;
    assert_int_equal(run_stencil(&s, 0xa5, true, true, &passed), 0x05);
}

static void two_sided_stencil_takes_the_face_of_the_triangle(void **state)
{
    (void)state;
    bool passed;
    GpStencilState s = { .front.pass = GP_STENCIL_INCR, .back.pass = GP_STENCIL_DECR };
    assert_int_equal(run_stencil(&s, 10, true, true, &passed), 11);
    assert_int_equal(run_stencil(&s, 10, false, true, &passed), 11); /* one-sided */
    s.two_sided = true;
    assert_int_equal(run_stencil(&s, 10, true, true, &passed), 11);
    assert_int_equal(run_stencil(&s, 10, false, true, &passed), 9);
}

static void r38_depth_off_counts_as_passed_for_the_stencil(void **state)
{
    (void)state;
    GpSurface *surface = one_texel(GP_D24S8, 0.0f, 3);
    GpDepthStencil unit = unit_on(surface);
    unit.stencil =
        (GpStencilState){ .enable = true,
                          .front = { .depth_fail = GP_STENCIL_ZERO, .pass = GP_STENCIL_INCR } };
    GpQuad quad = one_pixel(1, true); /* behind, if anybody asked */
    gp_depth_stencil(&unit, &quad);
    assert_int_equal(quad.stencil_after[0], 4);
    gp_surface_destroy(&surface);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_depth_compare_in_every_format),
        cmocka_unit_test(depth_is_kept_where_writing_is_off),
        cmocka_unit_test(r18_shader_depth_is_clamped_to_the_viewport_range),
        cmocka_unit_test(r21_compares_converted_values_not_floats),
        cmocka_unit_test(ternary_verdicts_turn_one_code_beyond_epsilon),
        cmocka_unit_test(what_fails_the_stencil_replaces_nothing),
        cmocka_unit_test(r39_every_operation_on_every_value),
        cmocka_unit_test(each_outcome_has_its_own_operation),
        cmocka_unit_test(every_stencil_compare_is_reference_against_stored),
        cmocka_unit_test(ignored_bits_are_not_compared_and_kept_bits_not_written),
        cmocka_unit_test(two_sided_stencil_takes_the_face_of_the_triangle),
        cmocka_unit_test(r38_depth_off_counts_as_passed_for_the_stencil),
    };
    return cmocka_run_group_tests_name("depth_stencil", tests, NULL, NULL);
}
