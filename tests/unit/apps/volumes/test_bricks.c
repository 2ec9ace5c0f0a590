/* Bricks against a search through all samples: what they show, and how far they are alike. */
#include "apps/volumes/bricks.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { X = 23, Y = 14, Z = 9, MOST = 6 * 4 * 2 };

static uint8_t samples[Z][Y][X];
static const Transfer narrow = {
    4, { { 99, { 1, 1, 1, 0 } }, { 99.5, { 1, 1, 1, 1 } }, { 100, { 1, 1, 1, 0 } }, { 255, { 0 } } }
};

static Field scattered(uint64_t seed, int one_in)
{
    Random random = { seed };
    for (int i = 0; i < X * Y * Z; i++)
        (&samples[0][0][0])[i] = (uint8_t)(random_int(&random, 0, one_in - 1) ? 10 : 200);
    return (Field){ .size = { X, Y, Z }, .scale = { 1, 1, 1 }, .value = &samples[0][0][0] };
}

static Bricks bricks_of(const Field *field)
{
    Bricks bricks;
    assert_int_equal(bricks_make(field, &bricks, NULL), GP_OK);
    return bricks;
}

static void sides_are_rounded_up_and_samples_between_are_both_bricks(void **state)
{
    (void)state;
    Field field = scattered(1, 1000000);
    samples[4][8][4] = 250;
    Bricks bricks = bricks_of(&field);
    assert_true(bricks.count[0] == 6 && bricks.count[1] == 4 && bricks.count[2] == 2);
    for (uint32_t i = 0, z = 0; z < 2; z++)
        for (uint32_t y = 0; y < 4; y++)
            for (uint32_t x = 0; x < 6; x++, i++) {
                const bool touches = x <= 1 && (y == 1 || y == 2);
                assert_int_equal(bricks.range[i][0], 10);
                assert_int_equal(bricks.range[i][1], touches ? 250 : 10);
            }
    bricks_free(&bricks);
}

/* Sides around the numbers of samples that are looked at together. */
static void ranges_are_those_of_all_samples(void **state)
{
    (void)state;
    enum { SAMPLES = 1024 * 9 * 4 };
    static const uint32_t sizes[][3] = { { 1, 1, 1 },   { 2, 3, 5 },    { 15, 9, 8 },
                                         { 16, 8, 9 },  { 17, 17, 10 }, { 33, 21, 10 },
                                         { 40, 9, 17 }, { 1024, 9, 4 } };
    static uint8_t values[SAMPLES];
    Random random = { 5 };
    for (int i = 0; i < SAMPLES; i++)
        values[i] = (uint8_t)random_int(&random, i % 7 ? 90 : 0, i % 5 ? 160 : 255);
    for (size_t s = 0; s < GP_COUNT(sizes); s++) {
        const uint32_t *size = sizes[s];
        const Field field = { .size = { size[0], size[1], size[2] }, .value = values };
        Bricks bricks = bricks_of(&field);
        for (size_t b = 0; b < bricks_total(&bricks); b++) {
            const size_t at[3] = { b % bricks.count[0], b / bricks.count[0] % bricks.count[1],
                                   b / bricks.count[0] / bricks.count[1] };
            uint8_t least = 255, most = 0;
            for (size_t i = 0; i < (size_t)size[0] * size[1] * size[2]; i++) {
                const size_t place[3] = { i % size[0], i / size[0] % size[1],
                                          i / size[0] / size[1] };
                bool inside = true;
                for (int k = 0; k < 3; k++)
                    inside = inside && place[k] >= at[k] * BRICK_SIDE &&
                             place[k] <= (at[k] + 1) * BRICK_SIDE;
                least = inside && values[i] < least ? values[i] : least;
                most = inside && values[i] > most ? values[i] : most;
            }
            assert_int_equal(bricks.range[b][0], least);
            assert_int_equal(bricks.range[b][1], most);
        }
        bricks_free(&bricks);
    }
}

/* A peak between two whole values is seen, and values next to it are too near to be left out. */
static void what_shows_anything_is_shown(void **state)
{
    static const struct {
        uint8_t least, most;
        bool shown;
    } rows[] = { { 0, 97, false },    { 0, 98, false },    { 0, 99, true },
                 { 99, 99, true },    { 100, 100, true },  { 0, 255, true },
                 { 101, 101, false }, { 102, 255, false }, { 100, 255, true } };
    (void)state;
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        uint8_t range[1][2] = { { rows[i].least, rows[i].most } }, shown = 2;
        const Bricks one = { { 1, 1, 1 }, range };
        bricks_show(&one, &narrow, &shown);
        if (shown != rows[i].shown)
            fail_msg("%d to %d: %d", rows[i].least, rows[i].most, shown);
    }
}

static bool is_alike(const Bricks *bricks, const uint8_t *shown, const int at[3], unsigned way,
                     int side)
{
    int place[3];
    const uint32_t *n = bricks->count;
    const uint8_t kind = shown[((uint32_t)at[2] * n[1] + (uint32_t)at[1]) * n[0] + (uint32_t)at[0]];
    for (int i = 0; i < side * side * side; i++) {
        const int step[3] = { i % side, i / side % side, i / side / side };
        bool inside = true;
        for (int k = 0; k < 3; k++) {
            place[k] = at[k] + (way >> k & 1 ? -step[k] : step[k]);
            inside = inside && place[k] >= 0 && place[k] < (int)n[k];
        }
        if (inside &&
            shown[((uint32_t)place[2] * n[1] + (uint32_t)place[1]) * n[0] + (uint32_t)place[0]] !=
                kind)
            return false;
    }
    return true;
}

static void runs_are_the_largest_cubes_along_each_way(void **state)
{
    (void)state;
    static const int rarities[] = { 3, 60, 300, 2000 };
    static const Transfer high = { 2, { { 100, { 1, 1, 1, 0 } }, { 150, { 1, 1, 1, 1 } } } };
    for (size_t r = 0; r < GP_COUNT(rarities); r++) {
        Field field = scattered(7 + r, rarities[r]);
        Bricks bricks = bricks_of(&field);
        uint8_t shown[MOST], runs[MOST];
        assert_true(bricks_total(&bricks) == MOST);
        bricks_show(&bricks, &high, shown);
        for (unsigned way = 0; way < BRICK_WAYS; way++) {
            assert_int_equal(bricks_runs(&bricks, shown, way, runs, NULL), GP_OK);
            for (int i = 0; i < MOST; i++) {
                const int at[3] = { i % 6, i / 6 % 4, i / 24 };
                const int side = runs[i] > BRICKS_FAR ? runs[i] - BRICKS_FAR : runs[i];
                assert_true(side > 0 && (runs[i] > BRICKS_FAR) == !shown[i]);
                const int tried = side < 8 ? side : 8; /* longer ones leave the volume */
                assert_true(is_alike(&bricks, shown, at, way, tried));
                assert_true(side == BRICKS_FAR || !is_alike(&bricks, shown, at, way, side + 1));
            }
        }
        bricks_free(&bricks);
    }
}

static void a_volume_one_sample_thin_has_none(void **state)
{
    (void)state;
    Field field = scattered(3, 3);
    field.size[1] = 1;
    Bricks bricks = bricks_of(&field);
    assert_int_equal(bricks_total(&bricks), 0);
    bricks_free(&bricks);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ranges_are_those_of_all_samples),
        cmocka_unit_test(sides_are_rounded_up_and_samples_between_are_both_bricks),
        cmocka_unit_test(what_shows_anything_is_shown),
        cmocka_unit_test(runs_are_the_largest_cubes_along_each_way),
        cmocka_unit_test(a_volume_one_sample_thin_has_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
