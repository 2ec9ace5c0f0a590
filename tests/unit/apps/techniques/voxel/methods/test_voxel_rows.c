/* The printed solid: rows scanned along three axes, what one of them gets wrong, and what the
 * majority mends. */
#include "apps/techniques/voxel/methods/solid_rows.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"
#include "tests/support/voxel_case.h"

#include <math.h>

enum { SIZE = 48 };

static const VoxelSetting solid = { .kind = VOXEL_SOLID,
                                    .method = VOXEL_SHEETS,
                                    .size = SIZE,
                                    .bits = 1,
                                    .blend = VOXEL_OR,
                                    .axes = 3 };

/* --- a scan in two parts ---------------------------------------------------------------------- */

/* Crossings, drawn; then a scan of them, between which a test may change them. */
typedef struct Scan {
    Frame draws, rows;
    VoxelDirections crossings, solids;
    FlatTexture merged;
} Scan;

static void scan_begin(const VoxelCase *given, Scan *scan)
{
    *scan = (Scan){ .merged = { .texels = NULL } };
    scan->crossings = voxel_directions_make(&solid, &scan->draws, NULL);
    voxel_directions_draw(&given->model, &solid, VOXEL_ALONG_ALL, &scan->draws, &scan->crossings);
    run_list(&scan->draws.list);
}

static void scan_end(Scan *scan)
{
    scan->merged = flat_texture_make(&scan->rows, SIZE, 1);
    scan->solids = voxel_row_scan(&solid, &scan->rows, &scan->crossings, &scan->merged);
    run_list(&scan->rows.list);
}

static void scan_free(Scan *scan)
{
    frame_free(&scan->draws);
    frame_free(&scan->rows);
}

/* --- against the truth ------------------------------------------------------------------------ */

/* Voxels that no triangle touches: inside or outside, whatever is asked of them. */
typedef struct Truth {
    uint8_t *inside, *touched;
} Truth;

static Truth find_truth(const VoxelCase *given)
{
    Truth truth = { gp_alloc(voxel_bytes(SIZE), 1), gp_alloc(voxel_bytes(SIZE), 1) };
    voxel_solid(given->triangles, given->model.triangle_count, SIZE, truth.inside);
    voxel_surface(given->triangles, given->model.triangle_count, SIZE, 1.0 / 128, truth.touched);
    return truth;
}

static void free_truth(Truth *truth)
{
    gp_free(truth->inside);
    gp_free(truth->touched);
}

static uint64_t count_wrong(const uint8_t *voxels, const Truth *truth)
{
    uint64_t wrong = 0;
    for (size_t i = 0; i < voxel_bytes(SIZE); i++)
        wrong += (uint64_t)__builtin_popcount((voxels[i] ^ truth->inside[i]) &
                                              (uint8_t)~truth->touched[i]);
    return wrong;
}

/* Voxels that are wrong along x, y, z, and in the majority; of those untouched by the surface. */
typedef struct Wrong {
    uint64_t along[3], merged;
} Wrong;

static Wrong measure(const VoxelCase *given, const Truth *truth)
{
    Wrong wrong;
    Scan scan;
    scan_begin(given, &scan);
    scan_end(&scan);
    for (int axis = 0; axis < 3; axis++) {
        uint8_t *voxels = voxel_read(&scan.solids.along[axis]);
        assert_int_equal(flat_texture_count(&scan.solids.along[axis]), voxel_count(voxels, SIZE));
        wrong.along[axis] = count_wrong(voxels, truth);
        gp_free(voxels);
    }
    uint8_t *voxels = voxel_read(&scan.merged);
    wrong.merged = count_wrong(voxels, truth);
    gp_free(voxels);
    scan_free(&scan);
    return wrong;
}

/* Returns how many voxels are inside. */
static uint64_t check_wrong(const VoxelCase *given, const Wrong *expected)
{
    Truth truth = find_truth(given);
    const Wrong wrong = measure(given, &truth);
    const uint64_t inside = voxel_count(truth.inside, SIZE);
    for (int axis = 0; axis < 3; axis++)
        assert_int_equal(wrong.along[axis], expected->along[axis]);
    assert_int_equal(wrong.merged, expected->merged);
    free_truth(&truth);
    return inside;
}

/* Where a line meets the surface twice in one voxel, as it does where it grazes it, the row is
 * streaked from there on. Two other directions mostly say otherwise; not where two streaks meet. */
static void the_majority_mends_streaks(void **state)
{
    (void)state;
    static const struct {
        const char *shape;
        double turn;
        uint32_t inside; /* voxels */
        Wrong wrong;
    } cases[] = {
        { "sphere", 0, 49072, { { 0, 0, 0 }, 0 } },
        { "cube", 0.2, 31024, { { 350, 306, 169 }, 0 } },
        { "knot", 0, 9662, { { 326, 362, 214 }, 5 } },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        VoxelCase given = voxel_case_open(cases[i].shape, cases[i].turn, SIZE);
        assert_int_equal(check_wrong(&given, &cases[i].wrong), cases[i].inside);
        voxel_case_free(&given);
    }
}

/* The majority is what two of three say, voxel by voxel. */
static void the_solid_is_the_majority(void **state)
{
    (void)state;
    VoxelCase given = voxel_case_open("teapot", 1, SIZE);
    Scan scan;
    scan_begin(&given, &scan);
    scan_end(&scan);
    uint8_t *a = voxel_read(&scan.solids.along[0]), *b = voxel_read(&scan.solids.along[1]),
            *c = voxel_read(&scan.solids.along[2]);
    uint8_t *merged = voxel_read(&scan.merged);
    for (size_t i = 0; i < voxel_bytes(SIZE); i++)
        assert_int_equal(merged[i], (a[i] & b[i]) | (b[i] & c[i]) | (a[i] & c[i]));
    assert_true(memcmp(a, b, voxel_bytes(SIZE)) != 0); /* they do not agree on all */
    VoxelSetting setting = solid;
    uint8_t *whole = voxel_case_volume(&given, &setting);
    assert_memory_equal(whole, merged, voxel_bytes(SIZE));
    setting.axes = 1; /* the scan along z alone */
    uint8_t *alone = voxel_case_volume(&given, &setting);
    assert_memory_equal(alone, c, voxel_bytes(SIZE));
    gp_free(a);
    gp_free(b);
    gp_free(c);
    gp_free(merged);
    gp_free(whole);
    gp_free(alone);
    scan_free(&scan);
    voxel_case_free(&given);
}

/* --- streaks ---------------------------------------------------------------------------------- */

/* Takes away the last crossing of the row along x through (y, z). */
static uint32_t lose_crossing(const FlatTexture *along_x, uint32_t y, uint32_t z)
{
    for (uint32_t x = SIZE; x-- > 0;) {
        uint8_t *texel = flat_texture_texel(along_x, x / 32, y, z);
        uint32_t word;
        memcpy(&word, texel, sizeof word);
        if (word >> x % 32 & 1) {
            word &= ~(1u << x % 32);
            memcpy(texel, &word, sizeof word);
            return x;
        }
    }
    fail_msg("no crossing in row %u, %u", y, z);
    return 0;
}

/* One voxel that is missing streaks the rest of its row; the other two directions outvote it. */
static void a_missing_voxel_streaks_its_row(void **state)
{
    (void)state;
    VoxelCase given = voxel_case_open("sphere", 0, SIZE);
    Scan whole, broken;
    scan_begin(&given, &whole);
    scan_end(&whole);
    scan_begin(&given, &broken);
    const uint32_t y = SIZE / 2 + 3, z = SIZE / 2 - 5;
    const uint32_t lost = lose_crossing(&broken.crossings.along[0], y, z);
    scan_end(&broken);

    uint8_t *before = voxel_read(&whole.solids.along[0]),
            *after = voxel_read(&broken.solids.along[0]);
    for (uint32_t x = lost + 1; x < SIZE; x++) {
        assert_false(voxel_at(before, SIZE, x, y, z));
        assert_true(voxel_at(after, SIZE, x, y, z));
    }
    assert_int_equal(voxel_count(after, SIZE), voxel_count(before, SIZE) + SIZE - 1 - lost);
    gp_free(before);
    gp_free(after);
    before = voxel_read(&whole.merged);
    after = voxel_read(&broken.merged);
    assert_memory_equal(before, after, voxel_bytes(SIZE));
    gp_free(before);
    gp_free(after);
    scan_free(&whole);
    scan_free(&broken);
    voxel_case_free(&given);
}

/* A cube without the side at the end of an axis. */
static VoxelCase open_cube(int axis)
{
    VoxelCase given = voxel_case_open("cube", 0, SIZE);
    for (uint32_t i = 0; i < given.model.triangle_count; i++) {
        const TruthTriangle *t = &given.triangles[i];
        double lowest = fmin(t->corner[0][axis], fmin(t->corner[1][axis], t->corner[2][axis]));
        if (lowest > SIZE - 2)
            memset(given.scene.mesh.indices + 3 * (size_t)i, 0, 3 * sizeof(uint32_t));
    }
    return given;
}

/* Rows that leave a model by a side that it lacks never end, and the scans disagree. */
static void an_open_mesh_makes_scans_disagree(void **state)
{
    (void)state;
    VoxelCase cube = voxel_case_open("cube", 0, SIZE);
    Truth truth = find_truth(&cube);
    Wrong closed = measure(&cube, &truth);
    assert_int_equal(closed.along[0] + closed.along[1] + closed.along[2] + closed.merged, 0);
    for (int axis = 0; axis < 3; axis++) {
        VoxelCase given = open_cube(axis);
        Wrong open = measure(&given, &truth);
        /* the cube is 45.5 long, from 1.25 to 46.75: 46 x 46 rows, and one voxel behind its end */
        for (int k = 0; k < 3; k++)
            assert_int_equal(open.along[k], k == axis ? 46 * 46 : 0);
        assert_int_equal(open.merged, 0);
        voxel_case_free(&given);
    }
    free_truth(&truth);
    voxel_case_free(&cube);
}

/* A horse is closed, and thin here and there. A bunny stands on holes: rows that leave by them are
 * streaked along y, ten times as much, and the majority is wrong too. (What is inside of it is told
 * by its parity along z, which holes below spoil least.) */
static void a_closed_mesh_is_mended_and_an_open_one_is_not(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        Wrong wrong;
    } cases[] = {
        { "meshes/horse.ply", { { 299, 376, 302 }, 5 } },
        { "meshes/bunny.ply", { { 738, 3872, 560 }, 350 } },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        VoxelCase given = voxel_case_open(cases[i].name, 0, SIZE);
        check_wrong(&given, &cases[i].wrong);
        voxel_case_free(&given);
    }
}

/* --- the other reading of the print ----------------------------------------------------------- */

/* Rows along x of the synthesized surface, toggled at every voxel of it: what the scan would make
 * of runs of surface voxels. Plain C, since nothing else needs it. */
static void rows_of_the_synthesized_surface_make_no_solid(void **state)
{
    (void)state;
    VoxelCase given = voxel_case_open("sphere", 0, SIZE);
    VoxelSetting surface = solid;
    surface.kind = VOXEL_SURFACE;
    uint8_t *voxels = voxel_case_volume(&given, &surface);
    uint8_t *filled = gp_alloc(voxel_bytes(SIZE), 1);
    for (size_t row = 0; row < SIZE * SIZE; row++) {
        bool inside = false;
        for (size_t i = row * SIZE; i < (row + 1) * SIZE; i++) {
            bool crossing = voxels[i / 8] >> i % 8 & 1;
            filled[i / 8] = (uint8_t)(filled[i / 8] | (unsigned)(inside || crossing) << i % 8);
            inside ^= crossing;
        }
    }
    Truth truth = find_truth(&given);
    assert_int_equal(count_wrong(filled, &truth), 4848); /* of 49072; scans of crossings: 0 */
    free_truth(&truth);
    gp_free(filled);
    gp_free(voxels);
    voxel_case_free(&given);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_majority_mends_streaks),
        cmocka_unit_test(the_solid_is_the_majority),
        cmocka_unit_test(a_missing_voxel_streaks_its_row),
        cmocka_unit_test(an_open_mesh_makes_scans_disagree),
        cmocka_unit_test(a_closed_mesh_is_mended_and_an_open_one_is_not),
        cmocka_unit_test(rows_of_the_synthesized_surface_make_no_solid),
    };
    return cmocka_run_group_tests_name("voxel rows", tests, NULL, NULL);
}
