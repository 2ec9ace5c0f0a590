/* Solids by the winding number: exact beside every counter's limit, full where parity is hollow,
 * and wrong beyond the limits, each failure beside its remedy. */
#include "apps/truth/voxel_winding.h"
#include "tests/support/unit.h"
#include "tests/support/voxel_case.h"

/* Corners are snapped to 1/256 of a voxel: nearer to the surface than this, either answer is
 * right. */
static const double margin = 1.0 / 128;

/* --- models ----------------------------------------------------------------------------------- */

/* A part: a built-in shape, scaled (turned over where that is negative) and moved, in parts of the
 * volume's side. */
typedef struct Part {
    const char *name;
    double scale, at[3];
} Part;

enum { MOST_PARTS = 4 };

static VoxelCase make_model(const Part *parts, size_t count, uint32_t size)
{
    enum { MOST = 100000 };
    static float corners[9 * MOST];
    uint32_t triangles = 0;
    for (size_t i = 0; i < count && parts[i].name; i++) {
        VoxelCase part = voxel_case_open(parts[i].name, 0.3, 16);
        assert_true(triangles + part.model.triangle_count <= MOST);
        for (uint32_t t = 0; t < part.model.triangle_count; t++, triangles++)
            for (int c = 0; c < 3; c++)
                for (int k = 0; k < 3; k++) {
                    const double *from = part.triangles[t].corner[parts[i].scale < 0 ? 2 - c : c];
                    const double place = fabs(parts[i].scale) * (from[k] / 16 - 0.5);
                    corners[9 * triangles + (uint32_t)(3 * c + k)] =
                        (float)((place + parts[i].at[k]) * size);
                }
        voxel_case_free(&part);
    }
    return voxel_case_of(corners, triangles, size);
}

/* Boxes one in the other, all turned outwards, in a volume of 16: their floors and lids are crossed
 * within one group of counters. */
static VoxelCase make_nest(uint32_t count, bool inside_out)
{
    static const int face[12][3] = { { 0, 2, 1 }, { 1, 2, 3 }, { 4, 5, 6 }, { 5, 7, 6 },
                                     { 0, 1, 4 }, { 1, 5, 4 }, { 2, 6, 3 }, { 3, 6, 7 },
                                     { 0, 4, 2 }, { 2, 4, 6 }, { 1, 3, 5 }, { 3, 7, 5 } };
    float *corners = gp_alloc((size_t)count * 12 * 9, sizeof *corners);
    assert_non_null(corners);
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t j = 0; j < 36; j++)
            for (int k = 0; k < 3; k++) {
                const int corner = face[j / 3][inside_out ? 2 - j % 3 : j % 3];
                const float in = 2.25f + 1.0f / 1024 * (float)i;
                corners[(i * 36 + j) * 3 + (uint32_t)k] = corner >> k & 1 ? 16 - in : in;
            }
    VoxelCase nest = voxel_case_of(corners, 12 * count, 16);
    gp_free(corners);
    return nest;
}

/* --- measures --------------------------------------------------------------------------------- */

typedef struct Wrong {
    uint64_t missing, extra, inside;
} Wrong;

static Wrong measure(const VoxelCase *subject, VoxelMethod method, VoxelCounters counters)
{
    const uint32_t size = subject->size, count = subject->model.triangle_count;
    const VoxelSetting setting = {
        .size = size, .bits = 1, .kind = VOXEL_SOLID, .method = method, .counters = counters
    };
    VoxelWinding winding;
    uint8_t *voxels = voxel_case_volume(subject, &setting);
    uint8_t *near = gp_alloc(voxel_bytes(size), 1);
    assert_non_null(near);
    assert_int_equal(voxel_winding_make(subject->triangles, count, size, 2, &winding), GP_OK);
    voxel_near(subject->triangles, count, size, margin, near);
    Wrong wrong = { .inside = voxel_count(winding.inside, size) };
    for (size_t i = 0; i < voxel_bytes(size); i++) {
        const unsigned missing = winding.inside[i] & ~voxels[i] & ~near[i];
        const unsigned extra = voxels[i] & ~winding.inside[i] & ~near[i];
        wrong.missing += (uint64_t)__builtin_popcount(missing & 0xff);
        wrong.extra += (uint64_t)__builtin_popcount(extra & 0xff);
    }
    voxel_winding_free(&winding);
    gp_free(voxels);
    gp_free(near);
    return wrong;
}

static void expect_exact(const VoxelCase *subject, const char *name)
{
    for (int counters = VOXEL_HALF; counters <= VOXEL_BYTE; counters++) {
        const Wrong wrong = measure(subject, VOXEL_WINDING, (VoxelCounters)counters);
        if (wrong.missing || wrong.extra || !wrong.inside)
            fail_msg("%s, %u, counters %d: %lu inside, %lu missing, %lu extra", name, subject->size,
                     counters, (unsigned long)wrong.inside, (unsigned long)wrong.missing,
                     (unsigned long)wrong.extra);
    }
}

/* --- facts ------------------------------------------------------------------------------------ */

static const struct {
    const char *name;
    uint64_t hollow; /* least that parity leaves out, in 64 voxels a side */
    Part parts[MOST_PARTS];
} models[] = {
    { "one", 0, { { "knot", 0.9, { 0.5, 0.5, 0.5 } } } },
    { "overlapping",
      2000,
      { { "ball", 0.6, { 0.4, 0.5, 0.45 } }, { "cube", 0.5, { 0.6, 0.45, 0.55 } } } },
    { "nested",
      2000,
      { { "ball", 0.9, { 0.5, 0.5, 0.5 } }, { "torus", 0.5, { 0.45, 0.5, 0.52 } } } },
    { "a hollow",
      0,
      { { "ball", 0.9, { 0.5, 0.5, 0.5 } }, { "cube", -0.4, { 0.5, 0.48, 0.52 } } } },
    { "inside out",
      2000,
      { { "ball", -0.6, { 0.4, 0.5, 0.45 } }, { "cube", -0.5, { 0.6, 0.45, 0.55 } } } },
    { "beyond the volume",
      500,
      { { "ball", 0.8, { 0.9, 0.1, 0.9 } },
        { "cube", 0.7, { 0.8, 0.2, 1.1 } },
        { "cone", 0.6, { 0.4, 0.4, -0.1 } } } },
    { "crossing itself",
      1000,
      { { "torus", 0.8, { 0.4, 0.5, 0.5 } },
        { "torus", 0.8, { 0.6, 0.5, 0.5 } },
        { "knot", 0.8, { 0.5, 0.5, 0.5 } } } },
};

static void solids_are_the_winding_numbers_of_centres(void **state)
{
    (void)state;
    static const uint32_t sizes[] = { 9, 16, 33 };
    for (size_t i = 0; i < GP_COUNT(models); i++)
        for (size_t j = 0; j < GP_COUNT(sizes); j++) {
            VoxelCase subject = make_model(models[i].parts, MOST_PARTS, sizes[j]);
            expect_exact(&subject, models[i].name);
            voxel_case_free(&subject);
        }
}

static void parity_hollows_what_overlaps_or_is_nested(void **state)
{
    (void)state;
    for (size_t i = 0; i < GP_COUNT(models); i++) {
        VoxelCase subject = make_model(models[i].parts, MOST_PARTS, 64);
        const Wrong wrong = measure(&subject, VOXEL_XOR, VOXEL_HALF);
        if (models[i].hollow ? wrong.missing < models[i].hollow : wrong.missing > 0)
            fail_msg("%s: parity misses %lu", models[i].name, (unsigned long)wrong.missing);
        assert_int_equal(wrong.extra, 0);
        voxel_case_free(&subject);
    }
}

/* A file whose tubes run through each other. */
static void cycloidal_is_full(void **state)
{
    (void)state;
    VoxelCase subject = voxel_case_open("meshes/cycloidal.ply", 0, 64);
    expect_exact(&subject, "cycloidal");
    assert_true(measure(&subject, VOXEL_XOR, VOXEL_HALF).missing > 1000);
    voxel_case_free(&subject);
}

/* Triangles are drawn up side first: 200 of one facing are more than a byte has room for, whatever
 * the sum is in the end; 2100 are more than the whole numbers of a half float. */
static void counters_are_right_up_to_their_limit(void **state)
{
    (void)state;
    static const struct {
        uint32_t boxes;
        VoxelCounters counters;
        bool is_right;
    } cases[] = {
        { 127, VOXEL_BYTE, true },  { 200, VOXEL_BYTE, false },  { 200, VOXEL_HALF, true },
        { 2048, VOXEL_HALF, true }, { 2100, VOXEL_HALF, false },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++)
        for (int inside_out = 0; inside_out < 2; inside_out++) {
            VoxelCase nest = make_nest(cases[i].boxes, inside_out);
            const Wrong wrong = measure(&nest, VOXEL_WINDING, cases[i].counters);
            if ((wrong.missing + wrong.extra == 0) != cases[i].is_right)
                fail_msg("%u boxes, counters %d: %lu missing, %lu extra", cases[i].boxes,
                         (int)cases[i].counters, (unsigned long)wrong.missing,
                         (unsigned long)wrong.extra);
            voxel_case_free(&nest);
        }
}

static void every_device_makes_the_same_volume(void **state)
{
    (void)state;
    enum { SIZE = 35 };
    static uint8_t voxels[SIZE * SIZE * SIZE / 8 + 1];
    VoxelCase subject = make_model(models[5].parts, MOST_PARTS, SIZE);
    for (int counters = VOXEL_HALF; counters <= VOXEL_BYTE; counters++) {
        const VoxelSetting setting = { .size = SIZE,
                                       .bits = 1,
                                       .kind = VOXEL_SOLID,
                                       .method = VOXEL_WINDING,
                                       .counters = (VoxelCounters)counters };
        voxel_case_draw(&subject, &setting, true, voxels);
        assert_true(voxel_count(voxels, SIZE) > 500);
    }
    voxel_case_free(&subject);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(solids_are_the_winding_numbers_of_centres),
        cmocka_unit_test(parity_hollows_what_overlaps_or_is_nested),
        cmocka_unit_test(cycloidal_is_full),
        cmocka_unit_test(counters_are_right_up_to_their_limit),
        cmocka_unit_test(every_device_makes_the_same_volume),
    };
    return cmocka_run_group_tests_name("winding solids", tests, NULL, NULL);
}
