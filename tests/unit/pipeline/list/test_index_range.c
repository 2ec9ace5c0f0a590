/* Ranges of index arrays: as a plain loop finds them, by lanes, threads, and from memory. */
#include "pipeline/list/index_range.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { MOST = 300001 }; /* some parts, and a rest that fills no lanes */

static uint32_t indices[MOST];

static void set_up(void)
{
    Random random = { 1 };
    for (uint32_t i = 0; i < MOST; i++)
        indices[i] = random_word(&random);
}

static void agrees(GpIndexRanges *ranges, const uint32_t *first, uint32_t count)
{
    const GpGeometry geometry = { .primitive = GP_POINTS, .indices = first, .index_count = count };
    uint32_t low = UINT32_MAX, high = 0;
    for (uint32_t i = 0; i < count; i++) {
        low = first[i] < low ? first[i] : low;
        high = first[i] > high ? first[i] : high;
    }
    GpIndexRange range = gp_index_range(ranges, &geometry);
    assert_int_equal(range.low, low);
    assert_int_equal(range.high, high);
}

static void counts(void **state)
{
    (void)state;
    set_up();
    for (uint32_t count = 1; count < 40; count++) {
        GpIndexRanges ranges = { .pool = NULL };
        agrees(&ranges, indices + count, count);
    }
}

static void threads(void **state)
{
    (void)state;
    set_up();
    GpPool *pool = NULL;
    assert_int_equal(gp_pool_create(3, &pool, NULL), GP_OK);
    static const uint32_t extremes[] = { 0, 1, MOST / 2, MOST - 2, MOST - 1 };
    for (size_t i = 0; i < GP_COUNT(extremes); i++) {
        GpIndexRanges ranges = { .pool = pool };
        indices[extremes[i]] = 0;
        indices[MOST - 1 - extremes[i]] = UINT32_MAX - 1;
        agrees(&ranges, indices, MOST);
        agrees(&ranges, indices, MOST);
        set_up();
    }
    gp_pool_destroy(&pool);
}

/* More arrays than are remembered, some of them the same but for their count. */
static void many(void **state)
{
    (void)state;
    set_up();
    GpIndexRanges ranges = { .pool = NULL };
    for (int again = 0; again < 2; again++)
        for (uint32_t i = 0; i < 1000; i++)
            agrees(&ranges, indices + 16 * (i / 3), 10 + i % 3);
}

/* Short and long indices at one address do not stand for each other. */
static void short_indices(void **state)
{
    (void)state;
    set_up();
    const uint16_t *narrow = (const uint16_t *)(const void *)indices;
    GpIndexRanges ranges = { .pool = NULL };
    for (uint32_t count = 1; count < 2000; count += 37) {
        uint32_t low = UINT32_MAX, high = 0;
        for (uint32_t i = 0; i < count; i++) {
            low = narrow[i] < low ? narrow[i] : low;
            high = narrow[i] > high ? narrow[i] : high;
        }
        agrees(&ranges, indices, count);
        const GpGeometry geometry = { .indices16 = narrow, .index_count = count };
        const GpIndexRange range = gp_index_range(&ranges, &geometry);
        assert_true(range.low == low && range.high == high);
    }
}

static void none(void **state)
{
    (void)state;
    GpIndexRanges ranges = { .pool = NULL };
    GpIndexRange range = gp_index_range(&ranges, &(GpGeometry){ .indices = indices });
    assert_true(range.low > range.high);
    range = gp_index_range(&ranges, &(GpGeometry){ .vertex_count = 0 });
    assert_true(range.low > range.high);
    range = gp_index_range(&ranges, &(GpGeometry){ .vertex_count = 7 });
    assert_int_equal(range.low, 0);
    assert_int_equal(range.high, 6);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(counts), cmocka_unit_test(threads),
                                        cmocka_unit_test(many), cmocka_unit_test(short_indices),
                                        cmocka_unit_test(none) };
    return cmocka_run_group_tests_name("index_range", tests, NULL, NULL);
}
