/* Parametric surfaces as points: close enough that none of their voxels is missed, or not. */
#include "apps/techniques/voxel/inputs/parametric.h"
#include "tests/support/unit.h"
#include "tests/support/voxel_case.h"

#include <math.h>

enum { MOST = 64, FULL = MOST * MOST * MOST / 8 };

static const char *const names[] = { "sphere", "torus", "moebius", "klein", "teapot", NULL };

typedef struct Parametric {
    const char *name;
    double step;
} Parametric;

static void append_parametric(const void *context, Frame *frame, const FlatTexture *flat)
{
    const Parametric *p = context;
    VoxelBox box;
    GpError error = { "" };
    if (voxel_parametric_box(p->name, flat->size, &box, &error) ||
        voxel_parametric(p->name, p->step, &box, frame, flat, &error))
        fail_msg("%s", error.text);
    assert_int_equal(frame->list.pass_count, 1);
}

/* Distance from the surface, negative inside. */
static double sphere_distance(const double p[3])
{
    return sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - 1;
}

static double torus_distance(const double p[3])
{
    return hypot(hypot(p[0], p[2]) - 0.7, p[1]) - 0.3;
}

typedef struct Shell {
    uint64_t holes; /* neighbours whose centres the surface parts, and neither is set */
    uint64_t stray; /* voxels that the surface does not come near */
} Shell;

static Shell inspect_shell(const Parametric *p, double (*distance)(const double p[3]),
                           uint32_t size)
{
    static uint8_t bits[FULL];
    static double centre[MOST][MOST][MOST]; /* in voxels */
    VoxelBox box;
    assert_int_equal(voxel_parametric_box(p->name, size, &box, NULL), GP_OK);
    voxel_run(append_parametric, p, size, false, bits);
    for (uint32_t z = 0; z < size; z++)
        for (uint32_t y = 0; y < size; y++)
            for (uint32_t x = 0; x < size; x++) {
                const uint32_t q[3] = { x, y, z };
                double at[3];
                for (int k = 0; k < 3; k++)
                    at[k] = (q[k] + 0.5 - box.offset[k]) / box.scale;
                centre[z][y][x] = distance(at) * box.scale;
            }
    Shell shell = { 0, 0 };
    for (uint32_t z = 0; z + 1 < size; z++)
        for (uint32_t y = 0; y + 1 < size; y++)
            for (uint32_t x = 0; x + 1 < size; x++) {
                const bool set = voxel_at(bits, size, x, y, z);
                const double here = centre[z][y][x];
                shell.stray += set && fabs(here) > sqrt(0.75) + 1e-3;
                for (uint32_t k = 0; k < 3; k++) {
                    const uint32_t u = x + (k == 0), v = y + (k == 1), w = z + (k == 2);
                    const double there = centre[w][v][u];
                    const bool parted = here * there < 0 && fabs(here) > 1e-3 && fabs(there) > 1e-3;
                    shell.holes += parted && !set && !voxel_at(bits, size, u, v, w);
                }
            }
    return shell;
}

/* The step that is promised leaves no hole, and four times that does. */
static void points_close_enough_leave_no_hole(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double (*distance)(const double p[3]);
    } cases[] = { { "sphere", sphere_distance }, { "torus", torus_distance } };
    for (size_t i = 0; i < GP_COUNT(cases); i++)
        for (uint32_t size = 48; size <= 64; size += 16) {
            const Parametric fine = { cases[i].name, VOXEL_PARAMETRIC_STEP };
            const Parametric coarse = { cases[i].name, 4 * VOXEL_PARAMETRIC_STEP };
            Shell shell = inspect_shell(&fine, cases[i].distance, size);
            assert_int_equal(shell.holes, 0);
            assert_int_equal(shell.stray, 0);
            shell = inspect_shell(&coarse, cases[i].distance, size);
            assert_true(shell.holes > 3000);
            assert_int_equal(shell.stray, 0);
        }
}

/* Pieces that do not touch, not even at a corner. Clears the bits. */
static uint32_t count_pieces(uint8_t *bits, uint32_t size)
{
    static uint32_t stack[MOST * MOST * MOST];
    uint32_t pieces = 0;
    for (uint32_t start = 0; start < size * size * size; start++) {
        uint32_t count = 0;
        if (bits[start / 8] >> start % 8 & 1) {
            bits[start / 8] = (uint8_t)(bits[start / 8] & ~(1u << start % 8));
            stack[count++] = start;
            pieces++;
        }
        while (count) {
            const uint32_t voxel = stack[--count];
            const int at[3] = { (int)(voxel % size), (int)(voxel / size % size),
                                (int)(voxel / size / size) };
            for (int n = 0; n < 27; n++) {
                const int x = at[0] + n % 3 - 1, y = at[1] + n / 3 % 3 - 1, z = at[2] + n / 9 - 1;
                const int end = (int)size;
                if (x < 0 || y < 0 || z < 0 || x >= end || y >= end || z >= end)
                    continue;
                const uint32_t i = (uint32_t)(x + end * (y + end * z));
                if (bits[i / 8] >> i % 8 & 1) {
                    bits[i / 8] = (uint8_t)(bits[i / 8] & ~(1u << i % 8));
                    stack[count++] = i;
                }
            }
        }
    }
    return pieces;
}

/* Points half as far apart find a tenth more, what the surface grazes; each surface is one piece,
 * which a coarse grid is not. */
static void every_surface_is_one_piece(void **state)
{
    (void)state;
    static uint8_t bits[FULL], denser[FULL];
    const uint32_t size = 48;
    for (const char *const *name = names; *name; name++) {
        const Parametric fine = { *name, VOXEL_PARAMETRIC_STEP };
        const Parametric finer = { *name, VOXEL_PARAMETRIC_STEP / 2 };
        const Parametric coarse = { *name, 8 * VOXEL_PARAMETRIC_STEP };
        voxel_run(append_parametric, &fine, size, false, bits);
        voxel_run(append_parametric, &finer, size, false, denser);
        const uint64_t set = voxel_count(bits, size);
        assert_true(set > 1500);
        assert_in_range(voxel_count_without(denser, bits, size), 1, set / 10);
        assert_in_range(voxel_count_without(bits, denser, size), 0, set / 300);
        assert_int_equal(count_pieces(bits, size), 1);
        voxel_run(append_parametric, &coarse, size, false, bits);
        assert_true(count_pieces(bits, size) > 100);
    }
}

/* The patches are the mesh's, whose chords lie up to this from them, in voxels. */
static void the_teapot_is_the_teapot(void **state)
{
    (void)state;
    enum { SIZE = 64 };
    static uint8_t bits[FULL], touched[FULL], deep[FULL];
    const double chord = 0.1, nearest = 0.36 + chord;
    const Parametric teapot = { "teapot", VOXEL_PARAMETRIC_STEP };
    VoxelCase mesh = voxel_case_open("teapot", 0, SIZE);
    VoxelBox box;
    assert_int_equal(voxel_parametric_box("teapot", SIZE, &box, NULL), GP_OK);
    voxel_triangles(mesh.model.positions, mesh.model.indices, mesh.model.triangle_count, &box,
                    mesh.triangles);
    memset(touched, 0, FULL);
    memset(deep, 0, FULL);
    voxel_surface(mesh.triangles, mesh.model.triangle_count, SIZE, chord, touched);
    voxel_surface(mesh.triangles, mesh.model.triangle_count, SIZE, -nearest, deep);
    voxel_run(append_parametric, &teapot, SIZE, false, bits);
    assert_int_equal(voxel_count_without(bits, touched, SIZE), 0);
    assert_true(voxel_count(deep, SIZE) > 500);
    assert_int_equal(voxel_count_without(deep, bits, SIZE), 0);
    voxel_case_free(&mesh);
}

static void unknown_surfaces_and_too_many_points_are_refused(void **state)
{
    (void)state;
    const FlatTexture flat = { .size = 1024, .bits = 1, .per_texel = 32, .slabs = 32 };
    VoxelBox box;
    Frame frame = { .color = NULL };
    GpError error = { "" };
    assert_int_equal(voxel_parametric_box("cup", 64, &box, &error), GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "'cup' is no parametric surface"));
    for (const char *const *name = names; *name; name++) {
        assert_int_equal(voxel_parametric_box(*name, flat.size, &box, &error), GP_OK);
        assert_int_equal(voxel_parametric(*name, 0.01, &box, &frame, &flat, &error),
                         GP_ERROR_INVALID);
        assert_non_null(strstr(error.text, "points of 0.01 voxels apart"));
        assert_int_equal(frame.arena.calls, 0);
    }
}

static void every_device_draws_the_same_bits(void **state)
{
    (void)state;
    static uint8_t bits[FULL];
    for (const char *const *name = names; *name; name++) {
        const Parametric p = { *name, 1 };
        voxel_run(append_parametric, &p, 33, true, bits);
        assert_true(voxel_count(bits, 33) > 500);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_close_enough_leave_no_hole),
        cmocka_unit_test(every_surface_is_one_piece),
        cmocka_unit_test(the_teapot_is_the_teapot),
        cmocka_unit_test(unknown_surfaces_and_too_many_points_are_refused),
        cmocka_unit_test(every_device_draws_the_same_bits),
    };
    return cmocka_run_group_tests_name("voxel parametric", tests, NULL, NULL);
}
