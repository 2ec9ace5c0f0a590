/* How voxelization fails, and what mends it: each failure of the thesis's chapter 2 as a pair of
 * rows,
 * in voxels of volumes of 64 a side. What is extra no triangle touches, or lies outside; what is
 * missing some triangle touches, or lies inside. */
#include "apps/techniques/voxel/technique.h"
#include "tests/support/technique/technique_case.h"
#include "tests/support/unit.h"

#define N64     "--size 64 "
#define SHEETS  N64 "--method sheets "
#define TEAPOT  "builtin:teapot"
#define CUBE    "builtin:cube"
#define TORUS   "builtin:torus"
#define KNOT    "builtin:knot"
#define DEFAULT N64

static const TechniqueCase carry[] = {
    { "a bit that is added twice is its neighbour", TEAPOT, SHEETS "--blend add", "extra", 10, 25 },
    { "or sets it once", TEAPOT, SHEETS "--blend or", "extra", 0, 0 },
};

static const TechniqueCase lost[] = {
    { "triangles beside all centres are lost", TORUS, SHEETS "--blend or", "missing", 4300, 5200 },
    { "triangles along the view are lost", CUBE, SHEETS "--blend or --axes 1", "missing", 14000,
      15300 },
    { "... not along three axes", CUBE, SHEETS "--blend or", "missing", 0, 0 },
    { "... by slices", TORUS, N64 "--method slices", "missing", 7700, 9100 },
    { "... by layers", TORUS, N64 "--method ldi", "missing", 7700, 9100 },
    { "whoever touches a column looks at it", TORUS, DEFAULT, "missing", 0, 0 },
    { "whoever touches a column looks at it", TORUS, DEFAULT, "extra", 0, 0 },
    { "... the cube's too", CUBE, DEFAULT, "missing", 0, 0 },
    { "... the cube's too", CUBE, DEFAULT, "extra", 0, 0 },
};

static const TechniqueCase solids[] = {
    { "one row's streaks", KNOT, SHEETS "--kind solid --axes 1", "missing", 70, 140 },
    { "a majority of three rows", KNOT, SHEETS "--kind solid", "missing", 0, 0 },
    { "... keeps voxels that the surface only crosses", KNOT, SHEETS "--kind solid", "extra", 1900,
      2300 },
    { "hollows that no face sees are filled", KNOT, N64 "--kind solid --method faces", "extra", 190,
      250 },
    { "parity knows neither", KNOT, DEFAULT "--kind solid", "missing", 0, 0 },
    { "parity knows neither", KNOT, DEFAULT "--kind solid", "extra", 0, 0 },
    { "... of a mesh that crosses itself, either", TEAPOT, DEFAULT "--kind solid", "missing", 0,
      0 },
    { "... of a mesh that crosses itself, either", TEAPOT, DEFAULT "--kind solid", "extra", 0, 0 },
};

static void check(const TechniqueCase *cases, size_t count)
{
    GpError error = { "" };
    if (technique_cases_check(&voxel_technique, cases, count, &error))
        fail_msg("%s", error.text);
}

static void adding_carries_and_or_does_not(void **state)
{
    (void)state;
    check(carry, GP_COUNT(carry));
}

static void samples_lose_what_columns_keep(void **state)
{
    (void)state;
    check(lost, GP_COUNT(lost));
}

static void rows_and_faces_are_wrong_where_parity_is_right(void **state)
{
    (void)state;
    check(solids, GP_COUNT(solids));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(adding_carries_and_or_does_not),
        cmocka_unit_test(samples_lose_what_columns_keep),
        cmocka_unit_test(rows_and_faces_are_wrong_where_parity_is_right),
    };
    return cmocka_run_group_tests_name("failures of voxelization", tests, NULL, NULL);
}
