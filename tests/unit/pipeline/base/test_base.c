/* Errors and memory: names of results, texts that are cut, sizes that no memory has. */
#include "pipeline/base/base.h"
#include "tests/support/unit.h"

static void every_result_has_a_name_of_its_own(void **state)
{
    (void)state;
    static const GpResult results[] = { GP_OK,           GP_ERROR_INVALID,
                                        GP_ERROR_MEMORY, GP_ERROR_UNSUPPORTED,
                                        GP_ERROR_IO,     GP_ERROR_FORMAT };
    for (size_t i = 0; i < GP_COUNT(results); i++) {
        assert_string_not_equal(gp_result_name(results[i]), "unknown");
        for (size_t j = 0; j < i; j++)
            assert_string_not_equal(gp_result_name(results[i]), gp_result_name(results[j]));
    }
    assert_string_equal(gp_result_name((GpResult)99), "unknown");
}

static void failing_gives_the_result_and_a_text_that_fits(void **state)
{
    (void)state;
    GpError error;
    assert_int_equal(gp_fail(&error, GP_ERROR_IO, "%d %0999d", 5, 7), GP_ERROR_IO);
    assert_int_equal(strlen(error.text), sizeof error.text - 1);
    assert_memory_equal(error.text, "5 000", 5);
    assert_int_equal(gp_fail(NULL, GP_ERROR_FORMAT, "nobody asks"), GP_ERROR_FORMAT);
}

static void memory_is_zero_aligned_and_never_less_than_asked_for(void **state)
{
    (void)state;
    static const size_t sizes[] = {
        0,
        1,
        63,
        64,
        65,
        4 << 20, /* and those around half a huge page, and one and a half */
        (1 << 20) - 1,
        1 << 20,
        (3 << 20) - 1,
        3 << 20
    };
    for (size_t i = 0; i < 3 * GP_COUNT(sizes); i++) { /* again: what was freed is not zero */
        const size_t size = sizes[i % GP_COUNT(sizes)];
        unsigned char *memory = gp_alloc(size, 1);
        assert_non_null(memory);
        assert_int_equal((uintptr_t)memory % 64, 0);
        for (size_t k = 0; k < size; k++)
            if (memory[k])
                fail_msg("byte %zu of %zu", k, size);
        memset(memory, 255, size);
        gp_free(memory);
        memory = gp_alloc_unset(size);
        assert_non_null(memory);
        assert_int_equal((uintptr_t)memory % 64, 0);
        memset(memory, 255, size);
        gp_free(memory);
    }
    assert_null(gp_alloc(SIZE_MAX / 2, 3)); /* the product has no place in a size_t */
    assert_null(gp_alloc_unset(SIZE_MAX - 1));
    gp_free(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_result_has_a_name_of_its_own),
        cmocka_unit_test(failing_gives_the_result_and_a_text_that_fits),
        cmocka_unit_test(memory_is_zero_aligned_and_never_less_than_asked_for),
    };
    return cmocka_run_group_tests_name("base", tests, NULL, NULL);
}
