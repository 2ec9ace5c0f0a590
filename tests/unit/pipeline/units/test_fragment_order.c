#include "pipeline/units/fragment_order.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

static void r53_lesser_keys_are_farther_or_nearer(void **state)
{
    (void)state;
    Random r = { 1 };
    for (int i = 0; i < 10000; i++) {
        const float a = random_float(&r, 0, 1),
                    b = random_int(&r, 0, 4) ? random_float(&r, 0, 1) : a;
        const uint32_t far_a = gp_order_key(GP_ORDER_DEPTH, a, 0, 1);
        const uint32_t far_b = gp_order_key(GP_ORDER_DEPTH, b, 0, 1);
        const uint32_t near_a = gp_order_key(GP_ORDER_DEPTH_NEAR_FIRST, a, 0, 1);
        const uint32_t near_b = gp_order_key(GP_ORDER_DEPTH_NEAR_FIRST, b, 0, 1);
        assert_true((far_a < far_b) == (a > b) && (far_a == far_b) == (a == b));
        assert_true((near_a < near_b) == (a < b));
        assert_true(far_a <= GP_ORDER_KEY_MOST && near_a <= GP_ORDER_KEY_MOST);
        assert_true(gp_order_depth(GP_ORDER_DEPTH, far_a) == a);
        assert_true(gp_order_depth(GP_ORDER_DEPTH_NEAR_FIRST, near_a) == a);
    }
}

static void r53_depth_is_clamped_and_nan_is_behind_all(void **state)
{
    (void)state;
    for (GpOrder order = GP_ORDER_DEPTH; order < GP_ORDERS; order++) {
        assert_int_equal(gp_order_key(order, -3, 0.25f, 0.5f), gp_order_key(order, 0.25f, 0, 1));
        assert_int_equal(gp_order_key(order, INFINITY, 0.25f, 0.5f),
                         gp_order_key(order, 0.5f, 0, 1));
        assert_int_equal(gp_order_key(order, -0.0f, 0, 1), gp_order_key(order, 0, 0, 1));
    }
    assert_true(gp_order_key(GP_ORDER_DEPTH, NAN, 0, 1) < gp_order_key(GP_ORDER_DEPTH, 1, 0, 1));
    assert_true(gp_order_key(GP_ORDER_DEPTH_NEAR_FIRST, NAN, 0, 1) >
                gp_order_key(GP_ORDER_DEPTH_NEAR_FIRST, 1, 0, 1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r53_lesser_keys_are_farther_or_nearer),
        cmocka_unit_test(r53_depth_is_clamped_and_nan_is_behind_all),
    };
    return cmocka_run_group_tests_name("fragment order", tests, NULL, NULL);
}
