/* The oracle of voxels against what can be counted by hand, by other means, or is known. */
#include "tests/support/random.h"
#include "tests/support/unit.h"
#include "apps/truth/voxel_truth.h"

#include "pipeline/io/file.h"
#include "pipeline/io/mesh/mesh_file.h"

enum { SIZE = 16 };

static uint8_t bits[SIZE * SIZE * SIZE / 8];

static bool get(const uint8_t *volume, uint32_t size, uint32_t x, uint32_t y, uint32_t z)
{
    size_t i = x + size * (y + size * (size_t)z);
    return volume[i / 8] >> i % 8 & 1;
}

/* The twelve triangles of a box, turned outwards. */
static void make_box(const double low[3], const double high[3], TruthTriangle *triangles)
{
    static const int face[12][3] = { { 0, 2, 1 }, { 1, 2, 3 }, { 4, 5, 6 }, { 5, 7, 6 },
                                     { 0, 1, 4 }, { 1, 5, 4 }, { 2, 6, 3 }, { 3, 6, 7 },
                                     { 0, 4, 2 }, { 2, 4, 6 }, { 1, 3, 5 }, { 3, 7, 5 } };
    for (int i = 0; i < 12; i++)
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++)
                triangles[i].corner[c][k] = face[i][c] >> k & 1 ? high[k] : low[k];
}

static void a_box_is_its_shell_and_its_inside(void **state)
{
    (void)state;
    const double low[3] = { 3.3, 4.4, 5.1 }, high[3] = { 9.2, 10.7, 8.6 };
    TruthTriangle box[12];
    make_box(low, high, box);
    memset(bits, 0, sizeof bits);
    voxel_surface(box, 12, SIZE, 0, bits);
    /* 7 x 7 x 4 voxels, of which 5 x 5 x 2 are not touched */
    assert_int_equal(voxel_count(bits, SIZE), 7 * 7 * 4 - 5 * 5 * 2);
    assert_true(get(bits, SIZE, 3, 4, 5) && get(bits, SIZE, 9, 10, 8) && !get(bits, SIZE, 5, 6, 6));
    memset(bits, 0, sizeof bits);
    voxel_solid(box, 12, SIZE, bits);
    /* centres from 3.5 to 8.5, 4.5 to 10.5, 5.5 to 8.5 */
    assert_int_equal(voxel_count(bits, SIZE), 6 * 7 * 4);
}

static void a_face_between_voxels_touches_both(void **state)
{
    (void)state;
    const TruthTriangle wall = { { { 4, 4.5, 4.5 }, { 4, 5.5, 4.5 }, { 4, 4.5, 5.5 } } };
    memset(bits, 0, sizeof bits);
    voxel_surface(&wall, 1, SIZE, 0, bits);
    assert_int_equal(voxel_count(bits, SIZE), 2 * 4); /* the far corner just meets its edge */
    memset(bits, 0, sizeof bits);
    voxel_surface(&wall, 1, SIZE, -1e-3, bits);
    assert_int_equal(voxel_count(bits, SIZE), 0);
}

/* A point of the triangle in a voxel proves that it is touched. */
static void overlap_agrees_with_points_of_the_triangle(void **state)
{
    (void)state;
    Random random = { 7 };
    for (int i = 0; i < 300; i++) {
        TruthTriangle t;
        for (int c = 0; c < 9; c++)
            t.corner[c / 3][c % 3] = (double)random_float(&random, 2, 14);
        memset(bits, 0, sizeof bits);
        voxel_surface(&t, 1, SIZE, 0, bits);
        static uint8_t found[sizeof bits];
        memset(found, 0, sizeof found);
        enum { STEPS = 120 };
        for (int a = 0; a <= STEPS; a++)
            for (int b = 0; a + b <= STEPS; b++) {
                uint32_t at[3];
                for (int k = 0; k < 3; k++)
                    at[k] = (uint32_t)((a * t.corner[0][k] + b * t.corner[1][k] +
                                        (STEPS - a - b) * t.corner[2][k]) /
                                       STEPS);
                size_t v = at[0] + SIZE * (at[1] + SIZE * (size_t)at[2]);
                assert_true(get(bits, SIZE, at[0], at[1], at[2]));
                found[v / 8] = (uint8_t)(found[v / 8] | 1u << v % 8);
            }
        /* What dense points do not find is only grazed, and rare. */
        uint64_t touched = voxel_count(bits, SIZE), seen = voxel_count(found, SIZE);
        assert_true(touched >= seen && touched - seen <= 4 + touched / 5);
    }
}

/* What is sampled is touched, and one axis finds no more than three. */
static void thin_is_within_the_surface(void **state)
{
    (void)state;
    Random random = { 11 };
    for (int i = 0; i < 200; i++) {
        TruthTriangle t;
        for (int c = 0; c < 9; c++)
            t.corner[c / 3][c % 3] = (double)random_float(&random, 2, 14);
        static uint8_t thin[sizeof bits], one[sizeof bits];
        memset(bits, 0, sizeof bits);
        memset(thin, 0, sizeof thin);
        memset(one, 0, sizeof one);
        voxel_surface(&t, 1, SIZE, 1e-9, bits);
        voxel_thin(&t, 1, SIZE, VOXEL_ALL_AXES, 0, thin);
        voxel_thin(&t, 1, SIZE, 0, 0, one);
        for (size_t k = 0; k < sizeof bits; k++) {
            assert_int_equal(thin[k] & ~bits[k], 0);
            assert_int_equal(one[k] & ~thin[k], 0);
        }
    }
}

/* Of a triangle in a plane z = 5.25: a quarter from the centres of voxels below it, and 3/4
 * above. */
static void nearness_is_a_distance(void **state)
{
    (void)state;
    const TruthTriangle t = { { { 3, 3, 5.25 }, { 9, 3, 5.25 }, { 3, 9, 5.25 } } };
    const struct {
        double distance;
        uint32_t x, y, z;
        bool near;
    } known[] = {
        { 0.26, 4, 4, 5, true },  { 0.24, 4, 4, 5, false }, { 0.76, 4, 4, 4, true },
        { 0.74, 4, 4, 4, false }, { 0.55, 2, 4, 5, false }, /* beside an edge: sqrt(1/4 + 1/16) */
        { 0.57, 2, 4, 5, true },  { 0.74, 2, 2, 5, false }, /* and a corner: sqrt(1/4 + 1/4 + 1/16) */
        { 0.76, 2, 2, 5, true },
    };
    for (size_t i = 0; i < GP_COUNT(known); i++) {
        memset(bits, 0, sizeof bits);
        voxel_near(&t, 1, SIZE, known[i].distance, bits);
        assert_int_equal(get(bits, SIZE, known[i].x, known[i].y, known[i].z), known[i].near);
    }
}

static void read_mesh(const char *name, GpMesh *mesh)
{
    char path[400];
    GpError error = { "" };
    if (gp_data_find(name, path, sizeof path, &error))
        skip();
    if (gp_mesh_read(path, GP_MESH_TRIANGLES, mesh, &error))
        fail_msg("%s", error.text);
}

/* Counts that other programs give. */
static void known_meshes_have_known_counts(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        uint32_t size, surface, thin, solid; /* 0: not known */
    } known[] = {
        { "meshes/bunny.ply", 64, 12992, 7556, 0 },
        { "meshes/bunny.ply", 128, 53866, 31662, 0 },
        { "meshes/horse.ply", 64, 0, 0, 9937 },
        { "meshes/horse.ply", 128, 0, 0, 84408 },
    };
    for (size_t i = 0; i < GP_COUNT(known); i++) {
        GpMesh mesh;
        read_mesh(known[i].name, &mesh);
        uint32_t count = mesh.triangle_count, size = known[i].size;
        VoxelBox space = voxel_box(mesh.positions, mesh.indices, 3 * count, size);
        TruthTriangle *triangles = gp_alloc(count, sizeof *triangles);
        uint8_t *volume[3];
        voxel_triangles(mesh.positions, mesh.indices, count, &space, triangles);
        for (int k = 0; k < 3; k++)
            volume[k] = gp_alloc(voxel_bytes(size), 1);
        if (known[i].surface) {
            voxel_surface(triangles, count, size, 0, volume[0]);
            voxel_thin(triangles, count, size, VOXEL_ALL_AXES, 0, volume[1]);
            assert_int_equal(voxel_count(volume[0], size), known[i].surface);
            assert_int_equal(voxel_count(volume[1], size), known[i].thin);
        } else {
            voxel_solid(triangles, count, size, volume[2]);
            assert_int_equal(voxel_count(volume[2], size), known[i].solid);
        }
        for (int k = 0; k < 3; k++)
            gp_free(volume[k]);
        gp_free(triangles);
        gp_mesh_free(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_box_is_its_shell_and_its_inside),
        cmocka_unit_test(a_face_between_voxels_touches_both),
        cmocka_unit_test(overlap_agrees_with_points_of_the_triangle),
        cmocka_unit_test(thin_is_within_the_surface),
        cmocka_unit_test(nearness_is_a_distance),
        cmocka_unit_test(known_meshes_have_known_counts),
    };
    return cmocka_run_group_tests_name("voxel truth", tests, NULL, NULL);
}
