/* The methods that are to be exact, held against exact arithmetic: surfaces by columns, solids by
 * parity. */
#include "tests/support/random.h"
#include "tests/support/unit.h"
#include "tests/support/voxel_case.h"

/* Nearer to a decision than this, in voxels, either answer is right. */
static const double surface_margin = 1e-3, solid_margin = 1.0 / 128;

/* --- surfaces --------------------------------------------------------------------------------- */

typedef void Truth(const VoxelCase *subject, uint32_t size, double margin, uint8_t *bits);

static void touched(const VoxelCase *subject, uint32_t size, double margin, uint8_t *bits)
{
    voxel_surface(subject->triangles, subject->model.triangle_count, size, margin, bits);
}

static void sampled(const VoxelCase *subject, uint32_t size, double margin, uint8_t *bits)
{
    voxel_thin(subject->triangles, subject->model.triangle_count, size, VOXEL_ALL_AXES, margin,
               bits);
}

/* All that is certain is there, and nothing that is certainly not. Returns the voxels. */
static uint64_t check_between(const VoxelCase *subject, const char *name, uint32_t size,
                              VoxelMethod method)
{
    Truth *truth = method == VOXEL_THIN ? sampled : touched;
    const VoxelSetting setting = { .size = size, .bits = 1, .method = method };
    uint8_t *voxels = gp_alloc(voxel_bytes(size), 1);
    uint8_t *certain = gp_alloc(voxel_bytes(size), 1), *possible = gp_alloc(voxel_bytes(size), 1);
    assert_true(voxels && certain && possible);
    voxel_case_draw(subject, &setting, false, voxels);
    truth(subject, size, -surface_margin, certain);
    truth(subject, size, surface_margin, possible);
    uint64_t count = voxel_count(voxels, size),
             missing = voxel_count_without(certain, voxels, size);
    uint64_t extra = voxel_count_without(voxels, possible, size);
    if (missing || extra || !count)
        fail_msg("%s, %u: %lu voxels, of which %lu missing, %lu extra", name, size,
                 (unsigned long)count, (unsigned long)missing, (unsigned long)extra);
    gp_free(voxels);
    gp_free(certain);
    gp_free(possible);
    return count;
}

static void surfaces_of_shapes_are_exact(void **state)
{
    (void)state;
    static const char *const shapes[] = { "sphere", "torus", "cube",  "cone",
                                          "plane",  "ball",  "teapot" };
    static const uint32_t sizes[] = { 8, 33, 70 };
    for (size_t i = 0; i < GP_COUNT(shapes); i++)
        for (size_t j = 0; j < GP_COUNT(sizes); j++) {
            VoxelCase subject = voxel_case_open(shapes[i], 0, sizes[j]);
            check_between(&subject, shapes[i], sizes[j], VOXEL_CONSERVATIVE);
            check_between(&subject, shapes[i], sizes[j], VOXEL_THIN);
            voxel_case_free(&subject);
        }
}

/* How a random triangle is made: corners all over the volume, or near each other; two or three of
 * them on a line; edges along axes; coordinates on centres or sides of voxels. */
enum { ANYWHERE, TINY, SLIVER, UPRIGHT, FLAT, ON_LATTICE, MANNERS };

enum { MOST_TRIANGLES = 4 };

static void make_triangle(Random *random, int manner, uint32_t size, float corner[9])
{
    const float least = 1, most = (float)size - 1;
    for (int k = 0; k < 9; k++)
        corner[k] = random_float(random, least, most);
    for (int k = 3; k < 9; k++) {
        if (manner == TINY)
            corner[k] = corner[k % 3] + random_float(random, -0.6f, 0.6f);
        if (manner == SLIVER && k >= 6)
            corner[k] =
                0.4f * corner[k - 6] + 0.6f * corner[k - 3] + random_float(random, -0.01f, 0.01f);
        if (manner == ON_LATTICE)
            corner[k] = 0.5f * (float)random_int(random, 2, 2 * (int32_t)size - 2);
    }
    int axis = random_int(random, 0, 2);
    if (manner == UPRIGHT)
        corner[3 + axis] = corner[axis];
    if (manner == FLAT)
        corner[3 + axis] = corner[6 + axis] = corner[axis];
}

static VoxelCase random_subject(Random *random, uint32_t size, uint32_t triangles, int manner)
{
    float corners[MOST_TRIANGLES][9];
    for (uint32_t i = 0; i < triangles; i++)
        make_triangle(random, manner, size, corners[i]);
    return voxel_case_of(corners[0], triangles, size);
}

static void surfaces_of_any_triangles_are_exact(void **state)
{
    (void)state;
    static const char *const names[MANNERS] = { "anywhere", "tiny", "slivers",
                                                "upright",  "flat", "on the lattice" };
    Random random = { 5 };
    for (int manner = 0; manner < MANNERS; manner++)
        for (uint32_t size = 20; size <= 90; size += 35)
            for (uint32_t triangles = 1; triangles <= MOST_TRIANGLES; triangles += 3)
                for (int i = 0; i < 4; i++) {
                    VoxelCase subject = random_subject(&random, size, triangles, manner);
                    check_between(&subject, names[manner], size, VOXEL_CONSERVATIVE);
                    voxel_case_free(&subject);
                }
}

/* No voxel is lost where triangles have no area at all; a line of them is a line of voxels. */
static void triangles_without_area_are_lines_and_points(void **state)
{
    (void)state;
    static const float corners[] = { 3.3f, 3.4f, 3.6f,  20.3f, 9.4f, 50.6f, 20.3f, 9.4f, 50.6f,
                                     8.5f, 8.5f, 8.5f,  8.5f,  8.5f, 8.5f,  8.5f,  8.5f, 8.5f,
                                     9.5f, 4.5f, 20.5f, 9.5f,  4.5f, 40.5f, 9.5f,  4.5f, 30.5f };
    VoxelCase subject = voxel_case_of(corners, 3, 64);
    assert_true(check_between(&subject, "lines", 64, VOXEL_CONSERVATIVE) > 80);
    voxel_case_free(&subject);
}

/* What lies outside is cut off, and does not come back in another patch of the flat texture. */
static void models_may_leave_their_volume(void **state)
{
    (void)state;
    enum { SIZE = 48, BYTES = SIZE * SIZE * SIZE / 8 };
    static uint8_t voxels[BYTES], certain[BYTES], possible[BYTES];
    const VoxelSetting setting = { .size = SIZE, .bits = 1, .method = VOXEL_CONSERVATIVE };
    Random random = { 9 };
    for (int i = 0; i < 40; i++) {
        float corners[9];
        for (int k = 0; k < 9; k++)
            corners[k] = random_float(&random, -SIZE, 2 * SIZE);
        VoxelCase subject = voxel_case_of(corners, 1, SIZE);
        memset(certain, 0, BYTES);
        memset(possible, 0, BYTES);
        voxel_case_draw(&subject, &setting, false, voxels);
        touched(&subject, SIZE, -surface_margin, certain);
        touched(&subject, SIZE, surface_margin, possible);
        assert_int_equal(voxel_count_without(certain, voxels, SIZE), 0);
        assert_int_equal(voxel_count_without(voxels, possible, SIZE), 0);
        voxel_case_free(&subject);
    }
}

/* --- solids ----------------------------------------------------------------------------------- */

static uint64_t check_solid(const char *name, uint32_t size)
{
    VoxelCase subject = voxel_case_open(name, 0, size);
    const VoxelSetting setting = {
        .size = size, .bits = 1, .kind = VOXEL_SOLID, .method = VOXEL_XOR
    };
    uint8_t *voxels = gp_alloc(voxel_bytes(size), 1);
    uint8_t *inside = gp_alloc(voxel_bytes(size), 1), *disputed = gp_alloc(voxel_bytes(size), 1);
    voxel_case_draw(&subject, &setting, false, voxels);
    voxel_solid(subject.triangles, subject.model.triangle_count, size, inside);
    voxel_near(subject.triangles, subject.model.triangle_count, size, solid_margin, disputed);
    for (size_t i = 0; i < voxel_bytes(size); i++)
        if ((voxels[i] ^ inside[i]) & ~disputed[i])
            fail_msg("%s, %u: other than the parity, at byte %zu", name, size, i);
    uint64_t count = voxel_count(voxels, size);
    gp_free(voxels);
    gp_free(inside);
    gp_free(disputed);
    voxel_case_free(&subject);
    return count;
}

static void solids_are_the_parity_of_centres(void **state)
{
    (void)state;
    static const char *const shapes[] = { "sphere", "torus", "cube", "knot", "cone" };
    static const uint32_t sizes[] = { 8, 31, 129 };
    for (size_t i = 0; i < GP_COUNT(shapes); i++)
        for (size_t j = 0; j < GP_COUNT(sizes); j++)
            assert_true(check_solid(shapes[i], sizes[j]) > 0);
}

/* --- known meshes ----------------------------------------------------------------------------- */

static void bunny_is_exact(void **state)
{
    (void)state;
    enum { SIZE = 64, TOUCHED = 12992, THIN = 7556 };
    VoxelCase bunny = voxel_case_open("meshes/bunny.ply", 0, SIZE);
    uint64_t count = check_between(&bunny, "bunny", SIZE, VOXEL_CONSERVATIVE);
    assert_in_range(count, TOUCHED - TOUCHED / 500, TOUCHED + TOUCHED / 500);
    count = check_between(&bunny, "bunny", SIZE, VOXEL_THIN);
    assert_in_range(count, THIN - 5, THIN + 5);
    voxel_case_free(&bunny);
}

static void horse_is_exact(void **state)
{
    (void)state;
    uint64_t count = check_solid("meshes/horse.ply", 128);
    assert_in_range(count, 84408 - 20, 84408 + 20);
}

/* --- one volume ------------------------------------------------------------------------------- */

static void every_device_makes_the_same_volume(void **state)
{
    (void)state;
    enum { MOST = 150 };
    static const VoxelSetting settings[] = {
        { .size = 50, .bits = 1, .method = VOXEL_CONSERVATIVE },
        { .size = 50, .bits = 1, .method = VOXEL_THIN },
        { .size = MOST, .bits = 1, .kind = VOXEL_SOLID, .method = VOXEL_XOR },
    };
    static uint8_t voxels[MOST * MOST * MOST / 8 + 1];
    for (size_t i = 0; i < GP_COUNT(settings); i++) {
        VoxelCase subject = voxel_case_open("knot", 0, settings[i].size);
        voxel_case_draw(&subject, &settings[i], true, voxels);
        assert_true(voxel_count(voxels, settings[i].size) > 1000);
        voxel_case_free(&subject);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(surfaces_of_shapes_are_exact),
        cmocka_unit_test(surfaces_of_any_triangles_are_exact),
        cmocka_unit_test(triangles_without_area_are_lines_and_points),
        cmocka_unit_test(models_may_leave_their_volume),
        cmocka_unit_test(solids_are_the_parity_of_centres),
        cmocka_unit_test(bunny_is_exact),
        cmocka_unit_test(horse_is_exact),
        cmocka_unit_test(every_device_makes_the_same_volume),
    };
    return cmocka_run_group_tests_name("exact voxels", tests, NULL, NULL);
}
