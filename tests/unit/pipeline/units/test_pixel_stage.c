/* Pixel stage: how a quad is laid out for a shader, and what becomes of its results. */
#include "pipeline/units/pixel_stage.h"
#include "tests/support/unit.h"

enum { VARYINGS = 2, TARGETS = 2, X = 6, Y = 10 };

/* A shader by hand: colours tell the varyings, place and facing of each lane; two pixels are
 * killed. */
static void shade(const GpShaderCall *call)
{
    const int lanes = *(const int *)call->uniforms;
    assert_int_equal(call->packets, 1);
    for (int lane = 0; lane < lanes; lane++) {
        const float told[TARGETS * 4] = { call->in[lane],
                                          call->in[lanes + lane],
                                          call->pixel[lane],
                                          call->pixel[lanes + lane],
                                          call->face[lane],
                                          5,
                                          6,
                                          7 };
        for (int c = 0; c < TARGETS * 4; c++)
            call->color[c * lanes + lane] = told[c];
        if (call->depth)
            call->depth[lane] = 0.25f * (float)(lane % 4);
        if (call->killed)
            call->killed[lane] = lane % 4 == 1 || lane % 4 == 2 ? -1 : 0;
    }
}

static GpQuad shaded(int lanes, bool front, bool writes_depth, bool may_discard)
{
    const GpProgram program = { .varying_components = VARYINGS,
                                .color_components = TARGETS * 4,
                                .writes_depth = writes_depth,
                                .may_discard = may_discard };
    const GpProgramCode code = { .lanes = lanes, .pixel = shade };
    const GpPixelStage stage = { .program = &program, .code = &code, .uniforms = &lanes };
    GpQuad quad = { .x = X, .y = Y, .mask = 9, .front = front, .killed = 8 };
    for (int p = 0; p < 4; p++) {
        quad.varying[0][p] = (float)(100 + p);
        quad.varying[1][p] = (float)(200 + p);
        quad.depth[p] = -1;
    }
    gp_shade_quad(&stage, &quad);
    return quad;
}

static void all_four_pixels_are_shaded_at_any_width(void **state)
{
    (void)state;
    for (int lanes = 4; lanes <= 16; lanes *= 2)
        for (int front = 0; front < 2; front++) {
            const GpQuad quad = shaded(lanes, front, false, false);
            for (int p = 0; p < 4; p++) {
                assert_true(quad.color[0][0][p] == (float)(100 + p));
                assert_true(quad.color[0][1][p] == (float)(200 + p));
                assert_true(quad.color[0][2][p] == (float)(X + p % 2));
                assert_true(quad.color[0][3][p] == (float)(Y + p / 2));
                assert_true(quad.color[1][0][p] == (front ? 1.0f : -1.0f));
                assert_true(quad.color[1][3][p] == 7);
            }
            assert_int_equal(quad.mask, 9); /* the caller's business */
        }
}

static void depth_and_kills_are_taken_where_they_are_declared(void **state)
{
    (void)state;
    for (int lanes = 4; lanes <= 16; lanes *= 2)
        for (int declared = 0; declared < 4; declared++) {
            const GpQuad quad = shaded(lanes, true, declared & 1, declared & 2);
            for (int p = 0; p < 4; p++)
                assert_true(quad.depth[p] == (declared & 1 ? 0.25f * (float)p : -1));
            assert_int_equal(quad.killed, declared & 2 ? 6 : 0);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_four_pixels_are_shaded_at_any_width),
        cmocka_unit_test(depth_and_kills_are_taken_where_they_are_declared),
    };
    return cmocka_run_group_tests_name("pixel_stage", tests, NULL, NULL);
}
