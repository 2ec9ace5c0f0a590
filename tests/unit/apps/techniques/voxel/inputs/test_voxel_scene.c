/* What may be voxelized: names, boxes, twists, and what does not go together. */
#include "apps/techniques/voxel/inputs/scene.h"
#include "tests/support/unit.h"
#include "tests/support/voxel_case.h"

#include <math.h>

enum { SIZE = 40, BYTES = SIZE * SIZE * SIZE / 8 };

static void open_scene(const char *path, VoxelScene *scene)
{
    GpError error = { "" };
    if (voxel_scene_open(path, scene, &error))
        fail_msg("%s: %s", path, error.text);
}

static void append(const void *context, Frame *frame, const FlatTexture *flat)
{
    const VoxelScene *scene = context;
    const VoxelSetting setting = { .size = SIZE, .bits = 1, .axes = 3 };
    const VoxelBox box = voxel_scene_box(scene, SIZE);
    GpError error = { "" };
    if (voxel_scene_draw(scene, &setting, &box, frame, flat, &error))
        fail_msg("%s", error.text);
}

/* --- names ------------------------------------------------------------------------------------ */

static void names_tell_what_is_meant(void **state)
{
    (void)state;
    static const struct {
        const char *path;
        int input;
    } names[] = {
        { "builtin:torus", VOXEL_MESH },
        { "implicit:quartic", VOXEL_FUNCTION },
        { "implicit:x^2 + y^2 + z^2 = 4", VOXEL_FUNCTION },
        { "parametric:klein", VOXEL_PARAMETRIC },
    };
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        VoxelScene scene;
        open_scene(names[i].path, &scene);
        assert_int_equal(scene.input, names[i].input);
        voxel_scene_close(&scene);
    }
}

static void wrong_names_are_refused(void **state)
{
    (void)state;
    static const char *const names[][2] = {
        { "builtin:nothing", "no builtin mesh" },
        { "implicit:", "expected" },
        { "implicit:x^", "expected" },
        { "parametric:", "no parametric surface" },
        { "parametric:torus of a very long name", "no parametric surface" },
        { "missing.ply", "missing.ply" },
    };
    VoxelScene scene = { .twist = 7 };
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        GpError error = { "" };
        assert_int_not_equal(voxel_scene_open(names[i][0], &scene, &error), GP_OK);
        if (!strstr(error.text, names[i][1]))
            fail_msg("%s: %s", names[i][0], error.text);
        assert_true(scene.twist == 7);
    }
}

static void settings_that_do_not_go_with_an_input_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *path;
        VoxelSetting setting;
        double twist;
        const char *part;
    } cases[] = {
        { "parametric:torus", { .kind = VOXEL_SOLID, .bits = 1 }, 0, "no inside" },
        { "parametric:torus", { .bits = 8 }, 0, "not 8" },
        { "implicit:quartic", { .method = VOXEL_THIN, .bits = 1 }, 0, "--method is for meshes" },
        { "implicit:quartic", { .bits = 1 }, 9, "--twist is for meshes" },
        { "builtin:cube", { .method = VOXEL_SHEETS, .bits = 1, .axes = 3 }, 9, "conservative" },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        VoxelScene scene;
        Frame frame = { .color = NULL };
        GpError error = { "" };
        open_scene(cases[i].path, &scene);
        scene.twist = cases[i].twist;
        VoxelSetting setting = cases[i].setting;
        setting.size = SIZE;
        const VoxelBox box = voxel_scene_box(&scene, SIZE);
        const FlatTexture flat = flat_texture_make(&frame, SIZE, setting.bits);
        assert_int_equal(voxel_scene_draw(&scene, &setting, &box, &frame, &flat, &error),
                         GP_ERROR_INVALID);
        if (!strstr(error.text, cases[i].part))
            fail_msg("%s: %s", cases[i].path, error.text);
        frame_free(&frame);
        voxel_scene_close(&scene);
    }
}

/* --- boxes ------------------------------------------------------------------------------------ */

/* Of all bits that are set. */
static VoxelRange range_of(const uint8_t *bits)
{
    VoxelRange range = { { SIZE, SIZE, SIZE }, { 0, 0, 0 } };
    for (uint32_t i = 0; i < SIZE * SIZE * SIZE; i++) {
        const uint32_t at[3] = { i % SIZE, i / SIZE % SIZE, i / SIZE / SIZE };
        for (int k = 0; k < 3 && bits[i / 8] >> i % 8 & 1; k++) {
            range.low[k] = at[k] < range.low[k] ? at[k] : range.low[k];
            range.end[k] = at[k] + 1 > range.end[k] ? at[k] + 1 : range.end[k];
        }
    }
    return range;
}

static void models_stay_in_their_range_and_fill_their_volume(void **state)
{
    (void)state;
    static const struct {
        const char *path;
        double twist;
        uint32_t least; /* voxels along the longest side */
    } cases[] = {
        { "builtin:knot", 0, SIZE - 3 },     { "builtin:cube", 45, SIZE / 2 },
        { "builtin:cube", 180, SIZE / 2 },   { "builtin:teapot", -700, SIZE / 2 },
        { "implicit:quartic", 0, SIZE - 2 }, { "implicit:x^2+y^2+z^2-4", 0, SIZE * 2 / 3 - 1 },
        { "parametric:torus", 0, SIZE - 3 }, { "parametric:teapot", 0, SIZE - 4 },
    };
    static uint8_t bits[BYTES];
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        VoxelScene scene;
        open_scene(cases[i].path, &scene);
        scene.twist = cases[i].twist;
        voxel_run(append, &scene, SIZE, false, bits);
        const VoxelBox box = voxel_scene_box(&scene, SIZE);
        const Bounds bounds = voxel_scene_bounds(&scene);
        const VoxelRange may = voxel_scene_range(&bounds, &box), range = range_of(bits);
        uint32_t longest = 0;
        for (int k = 0; k < 3; k++) {
            assert_in_range(range.low[k], may.low[k], may.end[k]);
            assert_in_range(range.end[k], may.low[k], may.end[k]);
            assert_true(scene.input == VOXEL_FUNCTION || (range.low[k] > 0 && range.end[k] < SIZE));
            longest = range.end[k] - range.low[k] > longest ? range.end[k] - range.low[k] : longest;
        }
        assert_in_range(longest, cases[i].least, SIZE);
        voxel_scene_close(&scene);
    }
}

static void vertices_are_points_where_they_are_asked_for(void **state)
{
    (void)state;
    static uint8_t bits[BYTES], expected[BYTES];
    VoxelScene scene;
    open_scene("builtin:knot", &scene);
    scene.input = VOXEL_POINTS;
    voxel_run(append, &scene, SIZE, false, bits);
    const VoxelBox box = voxel_scene_box(&scene, SIZE);
    for (uint32_t i = 0; i < scene.mesh.vertex_count; i++) {
        size_t at = 0;
        for (int k = 2; k >= 0; k--)
            at = at * SIZE +
                 (size_t)floor(box.scale * (double)scene.mesh.positions[3 * i + (uint32_t)k] +
                               box.offset[k]);
        expected[at / 8] |= (uint8_t)(1 << at % 8);
    }
    /* a vertex on a side of voxels may be in either */
    assert_in_range(voxel_count_without(bits, expected, SIZE), 0, 2);
    assert_in_range(voxel_count_without(expected, bits, SIZE), 0, 2);
    assert_true(voxel_count(bits, SIZE) > 1000);
    voxel_scene_close(&scene);
}

/* --- twists ----------------------------------------------------------------------------------- */

static void a_twist_turns_the_top_against_the_floor(void **state)
{
    (void)state;
    const double radians = 3.14159265358979323846 / 180;
    static uint8_t bits[BYTES], certain[BYTES], possible[BYTES];
    VoxelScene scene;
    open_scene("builtin:cube", &scene);
    scene.twist = 70;
    voxel_run(append, &scene, SIZE, true, bits);
    const VoxelBox box = voxel_scene_box(&scene, SIZE);
    VoxelCase c = voxel_case_open("cube", 0, SIZE);
    const double centre = SIZE / 2.0;
    for (uint32_t i = 0; i < c.model.triangle_count; i++)
        for (uint32_t j = 0; j < 3; j++) {
            const float *p = c.model.positions + 3 * (size_t)c.model.indices[3 * i + j];
            const double angle = (double)p[1] * 35 * radians; /* the cube is from -1 to 1 */
            const double x = (double)p[0] * box.scale, z = (double)p[2] * box.scale;
            double *q = c.triangles[i].corner[j];
            q[0] = centre + cos(angle) * x + sin(angle) * z;
            q[1] = centre + (double)p[1] * box.scale;
            q[2] = centre + cos(angle) * z - sin(angle) * x;
        }
    voxel_surface(c.triangles, c.model.triangle_count, SIZE, -2e-3, certain);
    voxel_surface(c.triangles, c.model.triangle_count, SIZE, 2e-3, possible);
    assert_int_equal(voxel_count_without(certain, bits, SIZE), 0);
    assert_int_equal(voxel_count_without(bits, possible, SIZE), 0);
    voxel_case_free(&c);
    voxel_scene_close(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_tell_what_is_meant),
        cmocka_unit_test(wrong_names_are_refused),
        cmocka_unit_test(settings_that_do_not_go_with_an_input_are_refused),
        cmocka_unit_test(models_stay_in_their_range_and_fill_their_volume),
        cmocka_unit_test(vertices_are_points_where_they_are_asked_for),
        cmocka_unit_test(a_twist_turns_the_top_against_the_floor),
    };
    return cmocka_run_group_tests_name("voxel scene", tests, NULL, NULL);
}
