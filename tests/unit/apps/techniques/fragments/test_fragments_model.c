/* What a mesh of fragments keeps from frame to frame, and what it tells of long work. */
#include "apps/techniques/fragments/model.h"
#include "apps/techniques/fragments/technique.h"
#include "tests/support/unit.h"

#include <unistd.h>

typedef struct Told {
    uint32_t calls, last, total;
    bool falls;
} Told;

static void hear(const void *user, uint32_t done, uint32_t total, const char *text)
{
    Told *told = *(Told *const *)user;
    assert_non_null(text);
    told->falls |= told->calls > 0 && done < told->last;
    told->calls++;
    told->last = done;
    told->total = total;
}

/* Makes the pieces of a knot by options; returns how often its progress was told. */
static Told open_and_make(const char *cache, ConvexOrder order, uint32_t *parted)
{
    Told told = { .calls = 0 }, *user = &told;
    FragmentOptions options = fragment_option_defaults;
    GpError error = { "" };
    void *made;
    options.method = FRAGMENTS_CONVEX;
    options.order = order;
    options.cache = cache;
    const TechniqueInput input = {
        .path = "builtin:knot", .setting = &options, .progress = hear, .user = &user
    };
    assert_int_equal(fragment_technique.open(&input, &made, &error), GP_OK);
    FragmentModel *model = made;
    if (fragment_model_convex(model, &options, &error))
        fail_msg("%s", error.text);
    assert_string_equal(model->cache_fault.text, "");
    *parted = model->convex.partings ? model->convex.partings->count : 0;
    fragment_technique.close(model);
    return told;
}

static void making_pieces_is_told_from_the_first_to_the_last(void **state)
{
    (void)state;
    for (int order = 0; order < 2; order++) {
        uint32_t parted;
        const Told told = open_and_make(NULL, (ConvexOrder)order, &parted);
        assert_true(told.calls > 10);
        assert_false(told.falls);
        assert_int_equal(told.last, told.total);
        assert_true((parted > 0) == (order == CONVEX_ORDER_GRID));
    }
}

/* A cache has pieces first, then what parts them too, and gives both to any order. */
static void a_cache_keeps_all_that_is_made(void **state)
{
    (void)state;
    static const struct {
        ConvexOrder order;
        bool makes;
    } rows[] = { { CONVEX_ORDER_EXACT, true },  { CONVEX_ORDER_EXACT, false },
                 { CONVEX_ORDER_GRID, true },   { CONVEX_ORDER_GRID, false },
                 { CONVEX_ORDER_EXACT, false }, { CONVEX_ORDER_GRID, false } };
    char path[] = "/tmp/test_fragments_model.XXXXXX";
    uint32_t parted, first = 0;
    close(mkstemp(path));
    unlink(path);
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const Told told = open_and_make(path, rows[i].order, &parted);
        assert_true((told.calls > 1) == rows[i].makes); /* the last is told in any case */
        if (rows[i].order == CONVEX_ORDER_GRID) {
            first = first ? first : parted;
            assert_int_equal(parted, first);
        }
    }
    unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(making_pieces_is_told_from_the_first_to_the_last),
        cmocka_unit_test(a_cache_keeps_all_that_is_made),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
