/* Volumes of functions and points against what double precision says. */
#include "apps/techniques/voxel/inputs/implicit.h"
#include "apps/techniques/voxel/inputs/parametric.h"
#include "pipeline/io/file.h"
#include "pipeline/io/mesh/mesh_file.h"
#include "tests/support/polynomial_value.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"
#include "tests/support/voxel_case.h"

#include <math.h>

enum { MOST = 64, FULL = MOST * MOST * MOST / 8 };

/* --- implicit surfaces ------------------------------------------------------------------------ */

static const char heart[] = "(x^2 + 9/4 y^2 + z^2 - 1)^3 = x^2 z^3 + 9/80 y^2z^3";

typedef struct Implicit {
    VoxelFunction function;
    double reach;
    VoxelKind kind;
} Implicit;

static void append_implicit(const void *context, Frame *frame, const FlatTexture *flat)
{
    const Implicit *i = context;
    const VoxelBox box = voxel_box_of_cube(i->reach, flat->size);
    GpError error = { "" };
    if (voxel_implicit(&i->function, &box, i->kind, frame, flat, &error))
        fail_msg("%s", error.text);
}

static double evaluate(const Implicit *i, const VoxelBox *box, double x, double y, double z)
{
    const double q[3] = { x, y, z };
    double p[3];
    for (int k = 0; k < 3; k++)
        p[k] = (q[k] - box->offset[k]) / box->scale;
    return i->function.evaluate ? i->function.evaluate(i->function.user, p)
                                : polynomial_value(&i->function.polynomial, p);
}

/* What a voxel should be: 0 or 1; 2 where a sample is within `margin` of 0. */
static int expect(const Implicit *f, const VoxelBox *box, const uint32_t at[3], double margin)
{
    const double x = at[0], y = at[1], z = at[2];
    if (f->kind == VOXEL_SOLID) {
        const double value = evaluate(f, box, x + 0.5, y + 0.5, z + 0.5);
        return fabs(value) < margin ? 2 : value < 0;
    }
    int inside = 0;
    bool near = false;
    for (int i = 0; i < 8; i++) {
        const double value = evaluate(f, box, x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
        near = near || fabs(value) < margin;
        inside += value < 0;
    }
    return near ? 2 : inside > 0 && inside < 8;
}

/* Draws a volume and checks each voxel, of which few may be undecided; returns how many are set. */
static uint64_t check_implicit(const Implicit *f, uint32_t size, double margin, bool everywhere)
{
    static uint8_t bits[FULL];
    const VoxelBox box = voxel_box_of_cube(f->reach, size);
    voxel_run(append_implicit, f, size, everywhere, bits);
    uint32_t at[3], undecided = 0;
    for (at[2] = 0; at[2] < size; at[2]++)
        for (at[1] = 0; at[1] < size; at[1]++)
            for (at[0] = 0; at[0] < size; at[0]++) {
                const int wanted = expect(f, &box, at, margin);
                undecided += wanted == 2;
                if (wanted < 2 && voxel_at(bits, size, at[0], at[1], at[2]) != wanted)
                    fail_msg("voxel %u %u %u of %u should be %d", at[0], at[1], at[2], size,
                             wanted);
            }
    assert_true(undecided <= voxel_count(bits, size) / 5);
    return voxel_count(bits, size);
}

static void polynomials_have_the_signs_of_double(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double reach;
        uint32_t size;
    } cases[] = {
        { "quartic", VOXEL_FUNCTION_REACH, 64 },
        { heart, 1.5, 40 },
        { "x^2+y^2+z^2-1", 1.2, 33 },
        { "x^5 - y^3 z + x y z^4/10 - 0.3", 2, 36 },
        { "z = 0.03", 1, 32 },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++)
        for (VoxelKind kind = VOXEL_SURFACE; kind <= VOXEL_SOLID; kind++) {
            Implicit f = { .reach = cases[i].reach, .kind = kind };
            assert_int_equal(voxel_function_parse(cases[i].text, &f.function, NULL), GP_OK);
            const uint64_t set = check_implicit(&f, cases[i].size, 1e-4, false);
            assert_true(set > 500);
        }
}

/* The centres of a ball of radius 2 in a cube of 4 a side: a voxel is 1/8, and nothing is near
 * 0. */
static void a_ball_is_counted_by_hand(void **state)
{
    (void)state;
    Implicit f = { .reach = 4, .kind = VOXEL_SOLID };
    assert_int_equal(voxel_function_parse("x^2+y^2+z^2-4.01", &f.function, NULL), GP_OK);
    uint64_t wanted = 0;
    for (int z = -32; z < 32; z++)
        for (int y = -32; y < 32; y++)
            for (int x = -32; x < 32; x++)
                wanted += (2 * x + 1) * (2 * x + 1) + (2 * y + 1) * (2 * y + 1) +
                              (2 * z + 1) * (2 * z + 1) <
                          4.01 * 256;
    assert_int_equal(check_implicit(&f, 64, 0, false), wanted);
}

static double gyroid(void *user, const double p[3])
{
    const double *level = user;
    return sin(p[0]) * cos(p[1]) + sin(p[1]) * cos(p[2]) + sin(p[2]) * cos(p[0]) - *level;
}

static double plain_quartic(const double p[3])
{
    double sum = 11.8;
    for (int k = 0; k < 3; k++)
        sum += p[k] * p[k] * p[k] * p[k] - 5 * p[k] * p[k];
    return sum;
}

static double quartic_again(void *user, const double p[3])
{
    (void)user;
    return plain_quartic(p);
}

/* A sample keeps its sign when it is rounded to a float: no margin. */
static void callbacks_keep_every_sign(void **state)
{
    (void)state;
    double level = 0.2;
    for (uint32_t size = 31; size <= 48; size += 17)
        for (VoxelKind kind = VOXEL_SURFACE; kind <= VOXEL_SOLID; kind++) {
            const Implicit sines = { { .evaluate = gyroid, .user = &level },
                                     .reach = 5,
                                     .kind = kind };
            const Implicit quartic = { { .evaluate = quartic_again }, .reach = 3, .kind = kind };
            assert_true(check_implicit(&sines, size, 0, false) > 2000);
            assert_true(check_implicit(&quartic, size, 0, false) > 500);
        }
}

static void too_many_samples_are_refused(void **state)
{
    (void)state;
    const VoxelFunction function = { .evaluate = quartic_again };
    const FlatTexture flat = { .size = 1024, .bits = 1, .per_texel = 32, .slabs = 32 };
    const VoxelBox box = voxel_box_of_cube(3, flat.size);
    Frame frame = { .color = NULL };
    GpError error = { "" };
    assert_int_equal(voxel_implicit(&function, &box, VOXEL_SURFACE, &frame, &flat, &error),
                     GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "1025 samples a side"));
    assert_int_equal(frame.arena.calls, 0);
}

/* --- points ----------------------------------------------------------------------------------- */

typedef struct Points {
    const float *positions;
    uint32_t count;
    VoxelBox box;
} Points;

static void append_points(const void *context, Frame *frame, const FlatTexture *flat)
{
    const Points *p = context;
    assert_int_equal(voxel_points(p->positions, p->count, &p->box, frame, flat, NULL), GP_OK);
}

/* The same in plain floats. */
static void set_points(const Points *p, uint8_t *bits)
{
    const float scale = (float)p->box.scale;
    const uint32_t size = p->box.size;
    memset(bits, 0, voxel_bytes(size));
    for (uint32_t i = 0; i < p->count; i++) {
        size_t index = 0;
        bool outside = false;
        for (int k = 2; k >= 0; k--) {
            const float q =
                p->positions[3 * (size_t)i + (size_t)k] * scale + (float)p->box.offset[k];
            outside = outside || q < 0 || q >= (float)size;
            index = index * size + (outside ? 0 : (size_t)q);
        }
        if (!outside)
            bits[index / 8] = (uint8_t)(bits[index / 8] | 1u << index % 8);
    }
}

static void points_set_their_voxels(void **state)
{
    (void)state;
    enum { COUNT = 5000 };
    static float positions[3 * COUNT];
    static uint8_t bits[FULL], wanted[FULL];
    Random random = { 5 };
    for (size_t i = 0; i < GP_COUNT(positions); i++)
        positions[i] = random_float(&random, -1.2f, 1.2f); /* some outside */
    for (uint32_t size = 33; size <= 64; size += 31) {
        const Points points = { positions, COUNT, voxel_box_of_cube(1, size) };
        voxel_run(append_points, &points, size, true, bits);
        set_points(&points, wanted);
        assert_memory_equal(bits, wanted, voxel_bytes(size));
        assert_true(voxel_count(bits, size) > COUNT / 3);
    }
    Frame frame = { .color = NULL };
    GpError error = { "" };
    const VoxelBox box = voxel_box_of_cube(1, 64);
    const FlatTexture flat = { .bits = 1 };
    assert_int_equal(voxel_points(positions, 0, &box, &frame, &flat, &error), GP_ERROR_INVALID);
}

static void a_scanned_point_set_sets_its_voxels(void **state)
{
    (void)state;
    static uint8_t bits[FULL], wanted[FULL];
    char path[400];
    GpError error = { "" };
    GpMesh mesh;
    if (gp_data_find("points/lion_takanawa.ply", path, sizeof path, &error))
        skip();
    if (gp_mesh_read(path, GP_MESH_ALLOW_POINTS, &mesh, &error))
        fail_msg("%s", error.text);
    const Points points = { mesh.positions, mesh.vertex_count,
                            voxel_box(mesh.positions, NULL, mesh.vertex_count, 64) };
    voxel_run(append_points, &points, 64, false, bits);
    set_points(&points, wanted);
    assert_memory_equal(bits, wanted, voxel_bytes(64));
    print_message("# %u points: %lu voxels\n", mesh.vertex_count, voxel_count(bits, 64));
    gp_mesh_free(&mesh);
}

/* --- bits ------------------------------------------------------------------------------------- */

static void every_device_draws_the_same_bits(void **state)
{
    (void)state;
    double level = 0;
    for (VoxelKind kind = VOXEL_SURFACE; kind <= VOXEL_SOLID; kind++) {
        Implicit f = { .reach = 1.5, .kind = kind };
        assert_int_equal(voxel_function_parse(heart, &f.function, NULL), GP_OK);
        assert_true(check_implicit(&f, 33, 1e-4, true) > 500);
        f = (Implicit){ { .evaluate = gyroid, .user = &level }, .reach = 4, .kind = kind };
        assert_true(check_implicit(&f, 33, 0, true) > 500);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(polynomials_have_the_signs_of_double),
        cmocka_unit_test(a_ball_is_counted_by_hand),
        cmocka_unit_test(callbacks_keep_every_sign),
        cmocka_unit_test(too_many_samples_are_refused),
        cmocka_unit_test(points_set_their_voxels),
        cmocka_unit_test(a_scanned_point_set_sets_its_voxels),
        cmocka_unit_test(every_device_draws_the_same_bits),
    };
    return cmocka_run_group_tests_name("voxel inputs", tests, NULL, NULL);
}
