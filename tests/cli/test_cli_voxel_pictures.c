/* glasspipe voxelize beyond one mesh: other models, two models, scans, and pictures of them. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

/* --- models ----------------------------------------------------------------------------------- */

static void functions_surfaces_and_points_are_models_too(void **state)
{
    (void)state;
    unlink("scene.json");
    write_file("points.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                             "property float y\nproperty float z\nend_header\n"
                             "0 0 0\n1 0 0\n0 1 0.5\n");
    assert_int_equal(shell("glasspipe voxelize -q points.ply -n 16"), 0);
    expect_contains(out, "\nvoxels 3\n");
    assert_int_equal(shell("glasspipe voxelize -q builtin:cube --points -n 16"), 0);
    expect_contains(out, "\nvoxels 8\n");
    /* middles within 8 of the middle of 24 voxels, of which 4 are a unit: the volume of a ball */
    assert_int_equal(shell("glasspipe voxelize -q 'implicit:x^2+y^2+z^2-4' -n 24 --kind solid"), 0);
    expect_matches(out, "\nvoxels 2[01][0-9][0-9]\n");
    assert_int_equal(shell("glasspipe voxelize -q implicit:quartic -n 24"), 0);
    assert_int_equal(shell("glasspipe voxelize -q parametric:moebius -n 24 --json"), 0);
    json_t *object = parse_output();
    assert_null(json_object_get(object, "report"));
    json_decref(object);
    expect_files("cube.nrrd implicit.nrrd moebius.nrrd points.nrrd points.ply");
}

/* --- two of them ------------------------------------------------------------------------------ */

#define CUBE "glasspipe voxelize -q builtin:cube --xform 4 16 16 16 -n 32 --kind solid "

static void two_models_are_combined_or_collide(void **state)
{
    (void)state;
    static const struct {
        const char *options, *expected;
    } cases[] = {
        { "--with builtin:cube --move 0.5 0 0", "\nvoxels 768\n" },
        { "--with builtin:cube --move 0.5 0 0 --combine intersection", "\nvoxels 256\n" },
        { "--with builtin:cube --fit 0.5 --combine difference", "\nvoxels 448\n" },
        { "--with builtin:cube --move -0.5 0 -0.25 --combine collide",
          "\ntouching 192\nrange 12..15 12..19 12..17\n" },
        { "--with builtin:cube --move 0 2 0 --combine collide", "\ntouching 0\n" },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        assert_int_equal(shell(CUBE "%s", cases[i].options), 0);
        expect_contains(out, cases[i].expected);
        expect_contains(out, "hash VOXELS 32x32x32");
        assert_int_equal(shell(CUBE "%s -o a.png --picture 40x30", cases[i].options), 0);
        expect_contains(out, cases[i].expected);
        expect_contains(out, "hash A8R8G8B8 40x30");
    }
    assert_int_equal(shell(CUBE "%s --json", cases[3].options), 0);
    json_t *object = parse_output(), *range = json_object_get(object, "range");
    assert_int_equal(json_integer_value(json_object_get(object, "touching")), 192);
    assert_int_equal(json_integer_value(json_array_get(json_array_get(range, 2), 1)), 17);
    assert_int_equal(json_integer_value(json_object_get(object, "triangles")), 24);
    json_decref(object);
}

static void a_solid_warns_of_the_second_model_too(void **state)
{
    (void)state;
    write_file("open.off", "OFF\n4 3 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n");
    assert_int_equal(shell("glasspipe voxelize -q builtin:cube -n 16 --kind solid --with open.off"),
                     0);
    expect_contains(err, "warning: open.off is not closed");
    assert_null(strstr(err, "builtin:cube is not"));
}

/* --- pictures --------------------------------------------------------------------------------- */

static void pictures_are_drawn_of_volumes(void **state)
{
    (void)state;
    static const char *const ways[] = {
        "",
        "--look transparent",
        "--shading cubes",
        "--kind solid --look transparent",
        "--from 70 -20",
        "--up x",
        "--zoom 2",
        "--scan scan.raw --look transparent",
        "--scan scan.raw --fit 0.2 --move 0.1 0 0",
        "--twist 45",
        "--with builtin:torus --combine collide",
    };
    write_file("scan.raw", "12345678");
    write_file("scan.json", "{ \"dims\": [2, 2, 2], \"type\": \"uint8\" }\n");
    char seen[GP_COUNT(ways)][64];
    for (size_t i = 0; i < GP_COUNT(ways); i++) {
        static const char line[] =
            "glasspipe voxelize -q builtin:knot -n 32 %s -o a.png --picture 64x48 %s";
        assert_int_equal(shell(line, ways[i], ""), 0);
        expect_matches(out, "^hash A8R8G8B8 64x48 [0-9a-f]{16}\n(voxels|touching) [1-9]");
        char first[256];
        strcpy(first, out);
        snprintf(seen[i], sizeof seen[i], "%.60s", out);
        *strchr(seen[i], '\n') = '\0';
        for (size_t k = 0; k < i; k++)
            assert_string_not_equal(seen[k], seen[i]);
        if (i % 2 == 0)
            continue;
        assert_int_equal(shell(line, ways[i], "--threads 3 --executor reference"), 0);
        assert_string_equal(out, first);
    }
    assert_int_equal(shell("glasspipe voxelize builtin:cube -n 16 -o a.ppm --json"), 0);
    json_t *object = parse_output();
    assert_string_equal(json_string_value(json_object_get(object, "format")), "A8R8G8B8");
    assert_int_equal(json_integer_value(json_object_get(object, "width")), 512);
    assert_int_equal(json_integer_value(json_object_get(object, "voxels")), 1016);
    json_decref(object);
    assert_int_equal(shell("head -n 2 a.ppm"), 0);
    expect_contains(out, "P6\n512 512");
}

/* Of models that need no file; the README shows them. */
static void stored_pictures_are_what_their_commands_draw(void **state)
{
    (void)state;
    static const struct {
        const char *name, *options;
    } pictures[] = {
        { "solid", "implicit:quartic --kind solid -n 64 --shading cubes" },
        { "transparent", "parametric:klein -n 256 --look transparent --from 20 50 --zoom 1.2" },
        { "csg", "builtin:cube --kind solid -n 192 --with builtin:sphere --fit 1.3 "
                 "--combine difference" },
        { "collision", "builtin:torus -n 192 --with builtin:knot --combine collide "
                       "--look transparent --from 25 50 --zoom 1.2" },
    };
    for (size_t i = 0; i < GP_COUNT(pictures); i++) {
        assert_int_equal(
            shell("glasspipe voxelize -q %s --picture 384x384 -o a.png", pictures[i].options), 0);
        if (shell("glasspipe compare a.png '%s/../../scenes/pictures/voxelize_%s.png'", man_pages,
                  pictures[i].name))
            fail_msg("%s: %s%s", pictures[i].name, out, err);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(functions_surfaces_and_points_are_models_too),
        PROGRAM_TEST(two_models_are_combined_or_collide),
        PROGRAM_TEST(a_solid_warns_of_the_second_model_too),
        PROGRAM_TEST(pictures_are_drawn_of_volumes),
        PROGRAM_TEST(stored_pictures_are_what_their_commands_draw),
    };
    return cmocka_run_group_tests_name("voxelize pictures", tests, find_program, NULL);
}
