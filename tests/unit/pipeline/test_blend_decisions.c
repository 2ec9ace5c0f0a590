/* Decisions of blending, and of the order in which a pixel's fragments are blended, condition by
 * condition. */
#include "pipeline/reference/waiting.h"
#include "pipeline/units/blend.h"
#include "tests/support/decision.h"

#include <math.h>

/* --- blending --------------------------------------------------------------------------------- */

/* channel == 3 && alpha_op != OFF: whether alpha's own operation serves. */
static void alphas_own_operation_serves_alpha_alone(void **state)
{
    (void)state;
    const float none[4] = { 0 }, source[4] = { 0.5f, 0.5f, 0.5f, 0.5f },
                target[4] = { 0.25f, 0.25f, 0.25f, 0.25f };
    float with[4], without[4];
    GpBlend blend = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };
    gp_blend(&blend, none, GP_A8R8G8B8, source, target, without);
    blend.alpha_op = GP_BLEND_MIN;
    gp_blend(&blend, none, GP_A8R8G8B8, source, target, with);
    Decision decision = { .name = "alpha's own" };
    decided(&decision, "TT", true, with[3] == 0.25f);
    decided(&decision, "FT", false, with[2] == 0.25f);
    decided(&decision, "TF", false, without[3] == 0.25f);
    every_condition_decides(&decision);
}

/* s < d || d != d: whether the lesser is the source; likewise the greater. */
static void r30_the_lesser_and_the_greater_decide_by_order_then_by_nan(void **state)
{
    (void)state;
    static const struct {
        const char *conditions;
        float source, target;
    } rows[] = { { "T-", 1, 2 }, { "FF", 2, 1 }, { "FT", 3, NAN }, { "FF", NAN, 4 } };
    Decision least = { .name = "min" }, greatest = { .name = "max" };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const float none[4] = { 0 }, s[4] = { rows[i].source }, d[4] = { rows[i].target };
        const float minus_s[4] = { -s[0] }, minus_d[4] = { -d[0] };
        float result[4];
        gp_blend(&(GpBlend){ .op = GP_BLEND_MIN }, none, GP_R32F, s, d, result);
        decided(&least, rows[i].conditions, i % 2 == 0, result[0] == s[0]);
        gp_blend(&(GpBlend){ .op = GP_BLEND_MAX }, none, GP_R32F, minus_s, minus_d, result);
        decided(&greatest, rows[i].conditions, i % 2 == 0, result[0] == minus_s[0]);
    }
    every_condition_decides(&least);
    every_condition_decides(&greatest);
}

/* in > 0, then in < 1; and whether the format asks for it at all. */
static void r32_each_end_clamps_where_the_format_is_unorm(void **state)
{
    (void)state;
    static const struct {
        float in, unorm;
    } rows[] = { { -0.5f, 0 }, { 0, 0 }, { 0.5f, 0.5f }, { 1, 1 }, { 1.5f, 1 }, { NAN, 0 } };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const float in[4] = { rows[i].in, rows[i].in, rows[i].in, rows[i].in },
                    one[4] = { 1, 1, 1, 1 };
        const GpBlend blend = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_BLEND_CONSTANT };
        float result[4], factors[2][4];
        gp_blend(&blend, in, GP_A8R8G8B8, in, one, result);
        assert_true(result[0] == rows[i].unorm + rows[i].unorm);
        gp_blend_factors(&blend, in, GP_A8R8G8B8, in, one, factors);
        assert_true(factors[0][0] == 1 && factors[1][0] == rows[i].unorm);
        gp_blend(&blend, in, GP_A32B32G32R32F, in, one, result);
        assert_true(isnan(in[0]) ? isnan(result[0]) : result[0] == in[0] + in[0]);
    }
}

/* channel == 3, then alpha < 1 - target's alpha. */
static void saturated_alpha_takes_the_lesser_but_for_alpha(void **state)
{
    (void)state;
    static const struct {
        float source, target, factor;
    } rows[] = { { 0.25f, 0.5f, 0.25f }, { 0.75f, 0.5f, 0.5f }, { 0.5f, 0.5f, 0.5f } };
    const GpBlend blend = { .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA_SAT };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const float none[4] = { 0 }, s[4] = { 1, 1, 1, rows[i].source },
                    d[4] = { 0, 0, 0, rows[i].target };
        float factors[2][4];
        gp_blend_factors(&blend, none, GP_A32B32G32R32F, s, d, factors);
        assert_true(factors[0][0] == rows[i].factor && factors[0][3] == 1);
    }
}

/* op >= ADD && op <= REV_SUBTRACT has factors; op >= AND && op <= XOR works on bits; all but off
 * read the target. */
static void each_operation_is_of_its_kind(void **state)
{
    (void)state;
    const float none[4] = { 0 }, value[4] = { 0.5f, 0.5f, 0.5f, 0.5f };
    Decision factors = { .name = "has factors" }, logic = { .name = "is logic" };
    for (GpBlendOp op = 0; op < GP_BLEND_OPS; op++) {
        const GpBlend blend = { .op = op, .src = GP_ONE, .dst = GP_ONE };
        float factor[2][4];
        gp_blend_factors(&blend, none, GP_A8R8G8B8, value, value, factor);
        const bool after = op > GP_BLEND_REV_SUBTRACT, late = op >= GP_BLEND_LOGIC_AND;
        decided(&factors,
                op == GP_BLEND_OFF ? "F-"
                : after            ? "TF"
                                   : "TT",
                op && !after, factor[0][0] == 1 && factor[1][3] == 1);
        decided(&logic, late ? "TT" : "F-", late, gp_blend_is_logic(op));
        assert_int_equal(gp_blend_reads_target(&blend), op != GP_BLEND_OFF);
    }
    decided(&logic, "TF", false, gp_blend_is_logic(GP_BLEND_OPS));
    every_condition_decides(&factors);
    every_condition_decides(&logic);
}

/* --- the order of blending -------------------------------------------------------------------- */

static void add_fragment(GpWaiting *waiting, GpOrder order, int32_t x, int32_t y, float depth)
{
    const int pixel = (x & 1) + 2 * (y & 1);
    GpQuad quad = { .x = x & ~1, .y = y & ~1, .mask = 1u << pixel };
    quad.depth[pixel] = depth;
    gp_waiting_add(waiting, order, &quad, 0, 1, 0, (uint32_t)waiting->count);
}

/* Row, then column, then depth by the pass's order, then submission: which of two has its turn
 * first. */
static void r53_row_column_depth_and_submission_decide_in_turn(void **state)
{
    (void)state;
    static const struct {
        const char *what;
        int32_t x[2], y[2];
        float depth[2];
        bool second_far, second_near; /* whether the second comes first */
    } rows[] = {
        { "row", { 1, 1 }, { 2, 1 }, { 0.5f, 0.5f }, true, true },
        { "row before column", { 0, 1 }, { 2, 1 }, { 0.5f, 0.5f }, true, true },
        { "row, the other way", { 1, 0 }, { 1, 2 }, { 0.5f, 0.5f }, false, false },
        { "column", { 2, 1 }, { 1, 1 }, { 0.5f, 0.5f }, true, true },
        { "column, the other way", { 1, 2 }, { 1, 1 }, { 0.5f, 0.5f }, false, false },
        { "column before depth", { 2, 1 }, { 1, 1 }, { 0.75f, 0.25f }, true, true },
        { "farther", { 1, 1 }, { 1, 1 }, { 0.25f, 0.75f }, true, false },
        { "nearer", { 1, 1 }, { 1, 1 }, { 0.75f, 0.25f }, false, true },
        { "submission", { 1, 1 }, { 1, 1 }, { 0.5f, 0.5f }, false, false },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        for (GpOrder order = GP_ORDER_DEPTH; order < GP_ORDERS; order++) {
            GpWaiting waiting = { .fragment = NULL };
            for (int k = 0; k < 2; k++)
                add_fragment(&waiting, order, rows[i].x[k], rows[i].y[k], rows[i].depth[k]);
            gp_waiting_sort(&waiting);
            const bool second = order == GP_ORDER_DEPTH ? rows[i].second_far : rows[i].second_near;
            if (waiting.fragment[0].primitive != second)
                fail_msg("%s: expected %d first", rows[i].what, second);
            gp_waiting_free(&waiting);
        }
}

/* first + count < all && same x && same y: how far a pixel's fragments reach. */
static void a_pixels_fragments_end_with_its_row_its_column_or_the_pass(void **state)
{
    (void)state;
    static const struct {
        const char *conditions;
        bool another;
        int fragments;
        int32_t x, y; /* of the second */
    } rows[] = {
        { "TTT", true, 2, 4, 4 },
        { "F--", false, 1, 4, 4 },
        { "TF-", false, 2, 5, 4 },
        { "TTF", false, 2, 4, 5 },
    };
    Decision decision = { .name = "another of the pixel" };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        GpWaiting waiting = { .fragment = NULL };
        add_fragment(&waiting, GP_ORDER_DEPTH, 4, 4, 0.5f);
        if (rows[i].fragments == 2)
            add_fragment(&waiting, GP_ORDER_DEPTH, rows[i].x, rows[i].y, 0.5f);
        gp_waiting_sort(&waiting);
        decided(&decision, rows[i].conditions, rows[i].another,
                gp_waiting_of_pixel(&waiting, 0) == 2);
        gp_waiting_free(&waiting);
    }
    every_condition_decides(&decision);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(alphas_own_operation_serves_alpha_alone),
        cmocka_unit_test(r30_the_lesser_and_the_greater_decide_by_order_then_by_nan),
        cmocka_unit_test(r32_each_end_clamps_where_the_format_is_unorm),
        cmocka_unit_test(saturated_alpha_takes_the_lesser_but_for_alpha),
        cmocka_unit_test(each_operation_is_of_its_kind),
        cmocka_unit_test(r53_row_column_depth_and_submission_decide_in_turn),
        cmocka_unit_test(a_pixels_fragments_end_with_its_row_its_column_or_the_pass),
    };
    return cmocka_run_group_tests_name("decisions of blending", tests, NULL, NULL);
}
