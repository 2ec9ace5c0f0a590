/* Voxelization as a technique: what it refuses, what its figures say of volumes that are right and
 * of volumes that were spoiled, and that it takes every mesh. */
#include "apps/techniques/voxel/technique.h"
#include "apps/techniques/voxel/models.h"
#include "apps/techniques/voxel/facts.h"
#include "apps/techniques/voxel/truths.h"
#include "pipeline/io/file.h"
#include "tests/support/technique/technique_case.h"
#include "tests/support/unit.h"
#include "apps/truth/voxel_truth.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>

/* --- figures ---------------------------------------------------------------------------------- */

static void the_exact_methods_have_no_wrong_voxel(void **state)
{
    (void)state;
    static const TechniqueCase cases[] = {
        { "touched", "builtin:knot", "--size 8", "missing", 0, 0 },
        { "touched", "builtin:knot", "--size 8", "extra", 0, 0 },
        { "touched", "builtin:knot", "--size 33", "missing", 0, 0 },
        { "touched", "builtin:knot", "--size 33", "extra", 0, 0 },
        { "touched", "builtin:knot", "--method conservative --size 48", "missing", 0, 0 },
        { "touched", "builtin:knot", "--method conservative --size 48", "extra", 0, 0 },
        { "met by lines", "builtin:knot", "--method thin --size 48", "missing", 0, 0 },
        { "met by lines", "builtin:knot", "--method thin --size 48", "extra", 0, 0 },
        { "more are touched", "builtin:knot", "--size 48", "voxels", 7000, 9000 },
        { "than are met", "builtin:knot", "--method thin --size 48", "voxels", 4000, 6000 },
        { "inside", "builtin:knot", "--kind solid --size 48", "missing", 0, 0 },
        { "inside", "builtin:knot", "--kind solid --size 48", "extra", 0, 0 },
        /* 29.5 voxels a side, from 1.25 to 30.75: a shell of 30^3 without 28^3 */
        { "a shell", "builtin:cube", "--size 32", "voxels", 5048, 5048 },
    };
    GpError error = { "" };
    if (technique_cases_check(&voxel_technique, cases, GP_COUNT(cases), &error))
        fail_msg("%s", error.text);
}

static void solids_are_held_against_their_inside(void **state)
{
    (void)state;
    const TechniqueCase cases[] = {
        { "inside", "builtin:knot", "--kind solid --size 48", "missing", 0, 0 },
        { "inside", "builtin:knot", "--kind solid --size 48", "extra", 0, 0 },
        { "inside", "builtin:cube", "--kind solid --size 32", "voxels", 29 * 29 * 29,
          30 * 30 * 30 },
    };
    GpError error = { "" };
    if (technique_cases_check(&voxel_technique, cases, GP_COUNT(cases), &error))
        fail_msg("%s", error.text);
}

/* Conservative: 500 / (N - 2.5), of every model. What is lost is above it, at any size; what voxels
 * hold is no matter. */
static void errors_tell_sizes_and_methods_apart(void **state)
{
    (void)state;
    static const TechniqueCase cases[] = {
        { "half a voxel", "builtin:knot", "--size 16", "error", 35.5, 38.5 },
        { "of half the size", "builtin:knot", "--size 32", "error", 16.4, 17.5 },
        { "of a quarter", "builtin:knot", "--size 64", "error", 7.9, 8.4 },
        { "thin", "builtin:knot", "--size 64 --method thin", "error", 8.4, 8.8 },
        { "printed", "builtin:knot", "--size 64 --method sheets", "error", 8.5, 8.9 },
        { "holes", "builtin:knot", "--size 64 --method sheets --axes 1", "error", 12, 16 },
        { "densities", "builtin:knot", "--size 64 --method sheets --bits 8", "error", 8.5, 8.9 },
        { "colours", "builtin:knot", "--size 64 --method sheets --bits 16 --value color", "error",
          8.5, 8.9 },
        { "walls lost", "builtin:cube", "--size 32 --method ldi", "error", 150, 250 },
        { "nothing lost", "builtin:cube", "--size 32", "error", 16, 18 },
    };
    static const TechniqueCase solid_cases[] = {
        { "a quarter voxel", "builtin:sphere", "--kind solid --size 32", "error", 46, 52 },
        { "of half the size", "builtin:sphere", "--kind solid --size 64", "error", 22, 25 },
        { "rows keep what the surface crosses", "builtin:sphere",
          "--kind solid --size 64 --method sheets", "error", 28, 35 },
    };
    GpError error = { "" };
    if (technique_cases_check(&voxel_technique, cases, GP_COUNT(cases), &error) ||
        technique_cases_check(&voxel_technique, solid_cases, GP_COUNT(solid_cases), &error))
        fail_msg("%s", error.text);
}

static void open_stage(const char *scene, TechniqueStage *stage)
{
    GpError error = { "" };
    if (technique_stage_open(&voxel_technique, scene, 0, 0, stage, &error))
        fail_msg("%s", error.text);
}

static void measure(const TechniqueStage *stage, const Frame *frame, TechniqueError *measured)
{
    GpError error = { "" };
    if (voxel_technique.experiments->measure(stage->scene, frame, measured, &error))
        fail_msg("%s", error.text);
}

static void flip_voxel(const FlatTexture *flat, uint32_t x, uint32_t y, uint32_t z)
{
    uint8_t *texel = flat_texture_texel(flat, z / 32, x, y);
    texel[z % 32 / 8] = (uint8_t)(texel[z % 32 / 8] ^ 1u << z % 8);
}

static void a_lost_voxel_is_missing_and_a_strange_one_is_extra(void **state)
{
    (void)state;
    TechniqueStage stage;
    Frame frame;
    GpError error = { "" };
    TechniqueError measured;
    open_stage("builtin:cube", &stage);
    assert_int_equal(technique_stage_draw(&stage, "--size 40", &frame, &error), GP_OK);
    const VoxelMade *made = frame.made;
    assert_int_equal(made->setting.size, 40);
    assert_ptr_equal(made->pair.result.texels, frame.color);

    measure(&stage, &frame, &measured);
    const double whole = measured.error;
    flip_voxel(&made->pair.result, 1, 20, 35); /* of the shell */
    measure(&stage, &frame, &measured);
    assert_true(measured.metrics[1] == 1 && measured.metrics[2] == 0);
    assert_true(measured.error > whole);
    double voxels = measured.metrics[0];
    flip_voxel(&made->pair.result, 20, 20, 20); /* inside */
    flip_voxel(&made->pair.result, 0, 0, 39);   /* outside */
    measure(&stage, &frame, &measured);
    assert_true(measured.metrics[1] == 1 && measured.metrics[2] == 2);
    assert_true(measured.metrics[0] == voxels + 2);
    frame_free(&frame);
    technique_stage_close(&stage);
}

/* --- truth ------------------------------------------------------------------------------------ */

static void truths_are_bounds_and_are_kept(void **state)
{
    (void)state;
    VoxelScene scene;
    VoxelTruths truths = { .count = 0 };
    GpError error = { "" };
    assert_int_equal(voxel_scene_open("builtin:sphere", &scene, &error), GP_OK);
    const VoxelTruthKind kinds[] = { VOXEL_TRUTH_TOUCHED, VOXEL_TRUTH_SAMPLED, VOXEL_TRUTH_INSIDE };
    for (uint32_t size = 16; size <= 24; size += 8)
        for (size_t k = 0; k < GP_COUNT(kinds); k++) {
            const VoxelBox box = voxel_scene_box(&scene, size);
            const VoxelTruth *truth = voxel_truths_find(&truths, &scene, kinds[k], &box);
            assert_non_null(truth);
            for (size_t i = 0; i < voxel_bytes(size); i++)
                assert_int_equal(truth->least[i] & ~truth->most[i], 0);
            uint64_t least = voxel_count(truth->least, size), most = voxel_count(truth->most, size);
            assert_true(least > 100 && most - least < least / 10);
            assert_ptr_equal(truth, voxel_truths_find(&truths, &scene, kinds[k], &box));
        }
    assert_int_equal(truths.count, 6);

    /* the ball's volume in voxels, from its radius of (24 - 2.5) / 2 */
    const VoxelBox box = voxel_scene_box(&scene, 24);
    const VoxelTruth *inside = voxel_truths_find(&truths, &scene, VOXEL_TRUTH_INSIDE, &box);
    double voxels = (double)voxel_count(inside->least, 24);
    assert_true(fabs(voxels - 4.18879 * 10.75 * 10.75 * 10.75) < 100);
    voxel_truths_free(&truths);
    voxel_scene_close(&scene);
}

/* However many sizes and places are asked for, the last ones are kept. */
static void there_is_room_for_every_truth(void **state)
{
    (void)state;
    VoxelScene scene;
    VoxelTruths truths = { .count = 0 };
    GpError error = { "" };
    uint64_t first = 0;
    assert_int_equal(voxel_scene_open("builtin:cube", &scene, &error), GP_OK);
    for (uint32_t i = 0; i <= 2 * VOXEL_MAX_TRUTHS + 1; i++) {
        VoxelBox box = voxel_scene_box(&scene, 8);
        box.scale *= 1 - i % (VOXEL_MAX_TRUTHS + 1) / 64.0;
        const VoxelTruth *truth = voxel_truths_find(&truths, &scene, VOXEL_TRUTH_INSIDE, &box);
        assert_non_null(truth);
        assert_ptr_equal(truth, voxel_truths_find(&truths, &scene, VOXEL_TRUTH_INSIDE, &box));
        const uint64_t most = voxel_count(truth->most, 8);
        if (i == 0)
            first = most;
        assert_true(i % (VOXEL_MAX_TRUTHS + 1) ? most <= first : most == first);
    }
    voxel_truths_free(&truths);
    voxel_scene_close(&scene);
}

/* Half as wide as its volume, a model is known as well as in a volume of half the size. */
static void errors_are_measured_where_the_model_lies(void **state)
{
    (void)state;
    static const char *const kinds[][2] = {
        { "--size 31 --method thin", "--size 60 --method thin" },
        { "--size 31 --kind solid", "--size 60 --kind solid" },
    };
    for (size_t k = 0; k < GP_COUNT(kinds); k++) {
        TechniqueStage stage;
        TechniqueError filled, half;
        GpError error = { "" };
        open_stage("builtin:knot", &stage);
        VoxelModels *models = stage.scene;
        assert_int_equal(technique_stage_measure(&stage, kinds[k][0], &filled, &error), GP_OK);
        models->pair.place.fit = 0.5;
        assert_int_equal(technique_stage_measure(&stage, kinds[k][1], &half, &error), GP_OK);
        if (half.metrics[1] + half.metrics[2] != 0 || fabs(half.error / filled.error - 1) > 0.2)
            fail_msg("%s: %g missing, %g extra, error %g instead of %g", kinds[k][1],
                     half.metrics[1], half.metrics[2], half.error, filled.error);
        technique_stage_close(&stage);
    }
}

/* A model that its placement moves half out of the volume is cut off there, and nowhere else. */
static void a_placed_model_is_cut_at_the_sides(void **state)
{
    (void)state;
    static const double offsets[][3] = {
        { 0, 16, 16 }, { 16, 33, 16 }, { 16, 16, -1 }, { 2, 30, 31 }
    };
    for (size_t i = 0; i < GP_COUNT(offsets); i++) {
        TechniqueStage stage;
        TechniqueError measured;
        GpError error = { "" };
        open_stage("builtin:torus", &stage);
        VoxelScene *scene = stage.scene;
        scene->is_placed = true;
        scene->scale = 9;
        memcpy(scene->offset, offsets[i], sizeof scene->offset);
        static const char *const options[] = { "--size 32", "--size 40",
                                               "--size 32 --method thin" };
        for (size_t k = 0; k < GP_COUNT(options); k++) {
            assert_int_equal(technique_stage_measure(&stage, options[k], &measured, &error), GP_OK);
            assert_true(measured.metrics[0] > 100);
            if (measured.metrics[1] + measured.metrics[2] != 0)
                fail_msg("%s, placement %zu: %g missing, %g extra", options[k], i,
                         measured.metrics[1], measured.metrics[2]);
        }
        technique_stage_close(&stage);
    }
}

/* --- meshes ----------------------------------------------------------------------------------- */

static void every_dirty_mesh_is_voxelized_exactly(void **state)
{
    (void)state;
    char folder[400];
    GpError error = { "" };
    if (gp_data_find("meshes/dirty", folder, sizeof folder, &error))
        skip();
    DIR *list = opendir(folder);
    assert_non_null(list);
    int count = 0;
    for (struct dirent *entry; (entry = readdir(list));) {
        char path[800];
        TechniqueStage stage;
        TechniqueError measured;
        if (entry->d_name[0] == '.')
            continue;
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        open_stage(path, &stage);
        assert_int_equal(technique_stage_measure(&stage, "--size 32", &measured, &error), GP_OK);
        if (measured.metrics[1] + measured.metrics[2] != 0 || measured.metrics[0] < 100)
            fail_msg("%s: %g voxels, %g missing, %g extra", path, measured.metrics[0],
                     measured.metrics[1], measured.metrics[2]);
        technique_stage_close(&stage);
        count++;
    }
    closedir(list);
    assert_true(count >= 13);
}

/* --- facts ------------------------------------------------------------------------------------ */

static VoxelFacts facts_of(VoxelScene *scene, uint32_t size)
{
    GpError error = { "" };
    VoxelFacts facts;
    assert_int_equal(voxel_facts_find(scene, &facts, &error), GP_OK);
    assert_false(facts.has_solids);
    assert_int_equal(voxel_facts_find_solids(scene, size, &facts, &error), GP_OK);
    assert_true(facts.has_solids);
    return facts;
}

/* A plane across y is crossed once by columns along y, 29.5 voxels a side, and by no other: half of
 * each of those columns is inside along y alone. */
static void a_plane_is_odd_along_its_normal(void **state)
{
    (void)state;
    VoxelScene scene;
    GpError error = { "" };
    assert_int_equal(voxel_scene_open("builtin:plane", &scene, &error), GP_OK);
    VoxelFacts facts = facts_of(&scene, 32);
    assert_false(facts.mesh.is_closed);
    assert_int_equal(facts.odd_columns[0] + facts.odd_columns[2], 0);
    assert_in_range(facts.odd_columns[1], 29 * 29, 30 * 30);
    assert_int_equal(facts.disagreements, facts.odd_columns[1] * 16);
    voxel_scene_close(&scene);
}

/* Where its volume cuts a model off, that is not the model's fault. */
static void a_closed_mesh_has_no_odd_column_wherever_it_is_placed(void **state)
{
    (void)state;
    VoxelScene scene;
    GpError error = { "" };
    assert_int_equal(voxel_scene_open("builtin:torus", &scene, &error), GP_OK);
    scene.is_placed = true;
    scene.scale = 20;
    VoxelFacts facts = facts_of(&scene, 32);
    assert_true(facts.mesh.is_closed);
    assert_int_equal(facts.odd_columns[0] + facts.odd_columns[1] + facts.odd_columns[2], 0);
    assert_int_equal(facts.disagreements, 0);
    voxel_scene_close(&scene);
}

/* --- what is refused -------------------------------------------------------------------------- */

static void what_contradicts_itself_is_refused(void **state)
{
    (void)state;
    static const char *const wrong[] = {
        "--axes 2",
        "--kind solid --method thin",
        "--method xor",
        "--method winding",
        "--bits 8",
        "--kind solid --method conservative",
        "--method sheets --bits 3",
        "--size 1024 --method sheets --bits 16",
    };
    TechniqueStage stage;
    open_stage("builtin:cube", &stage);
    for (size_t i = 0; i < GP_COUNT(wrong); i++) {
        Frame frame;
        GpError error = { "" };
        if (technique_stage_draw(&stage, wrong[i], &frame, &error) != GP_ERROR_INVALID)
            fail_msg("%s is not refused", wrong[i]);
        assert_true(error.text[0]);
        assert_int_equal(frame.arena.calls, 0);
    }
    technique_stage_close(&stage);
}

static void models_that_are_none_are_refused(void **state)
{
    (void)state;
    void *scene = NULL;
    GpError error = { "" };
    assert_int_equal(technique_open(&voxel_technique, "builtin:nothing", 0, 0, &scene, &error),
                     GP_ERROR_INVALID);
    assert_non_null(strstr(error.text, "nothing"));
    assert_int_equal(technique_open(&voxel_technique, "no/mesh.ply", 0, 0, &scene, &error),
                     GP_ERROR_IO);
    assert_non_null(strstr(error.text, "no/mesh.ply"));
    assert_int_equal(technique_open(&voxel_technique, "builtin:cube", 64, 64, &scene, &error),
                     GP_ERROR_INVALID);
    assert_null(scene);
}

static void only_meshes_have_a_truth(void **state)
{
    (void)state;
    static const char *const models[] = { "implicit:quartic", "parametric:torus" };
    for (size_t i = 0; i < GP_COUNT(models); i++) {
        void *scene;
        GpError error = { "" };
        assert_int_equal(technique_open(&voxel_technique, models[i], 0, 0, &scene, &error), GP_OK);
        assert_int_equal(voxel_technique.experiments->find_truth(scene, 1, &error),
                         GP_ERROR_INVALID);
        assert_non_null(strstr(error.text, "expected a mesh"));
        voxel_technique.close(scene);
    }
}

static void models_that_are_changed_have_no_truth(void **state)
{
    (void)state;
    VoxelOptions changed[] = { voxel_option_defaults, voxel_option_defaults,
                               voxel_option_defaults };
    changed[0].twist = 90;
    changed[1].with = "builtin:cube";
    changed[2].takes_points = true;
    for (size_t i = 0; i < GP_COUNT(changed); i++) {
        const TechniqueInput input = { .path = "builtin:torus", .setting = &changed[i] };
        void *scene;
        GpError error = { "" };
        assert_int_equal(voxel_technique.open(&input, &scene, &error), GP_OK);
        assert_int_equal(voxel_technique.experiments->find_truth(scene, 1, &error),
                         GP_ERROR_INVALID);
        voxel_technique.close(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_meshes_have_a_truth),
        cmocka_unit_test(models_that_are_changed_have_no_truth),
        cmocka_unit_test(the_exact_methods_have_no_wrong_voxel),
        cmocka_unit_test(solids_are_held_against_their_inside),
        cmocka_unit_test(errors_tell_sizes_and_methods_apart),
        cmocka_unit_test(a_lost_voxel_is_missing_and_a_strange_one_is_extra),
        cmocka_unit_test(truths_are_bounds_and_are_kept),
        cmocka_unit_test(there_is_room_for_every_truth),
        cmocka_unit_test(errors_are_measured_where_the_model_lies),
        cmocka_unit_test(a_placed_model_is_cut_at_the_sides),
        cmocka_unit_test(every_dirty_mesh_is_voxelized_exactly),
        cmocka_unit_test(a_plane_is_odd_along_its_normal),
        cmocka_unit_test(a_closed_mesh_has_no_odd_column_wherever_it_is_placed),
        cmocka_unit_test(what_contradicts_itself_is_refused),
        cmocka_unit_test(models_that_are_none_are_refused),
    };
    return cmocka_run_group_tests_name("voxelization as a technique", tests, NULL, NULL);
}
