/* glasspipe fragments as its user meets it. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

/* --- what is refused -------------------------------------------------------------------------- */

static void wrong_arguments_are_usage_errors(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "", "expected a mesh" },
        { "a.ply b.ply", "b.ply" },
        { "a.ply --method best", "--method: expected" },
        { "a.ply --alpha 1.5", "--alpha: expected a number from 0 to 1" },
        { "a.ply --sigma -1", "--sigma: expected a number" },
        { "a.ply --color pink", "--color: expected normals or material" },
        { "a.ply --method dp --hazard 16", "--hazard: expected --method kbuffer" },
        { "a.ply --method dp --kept 16", "--kept: expected --method kbuffer or stencil" },
        { "a.ply --hazard x", "--hazard: expected a whole number" },
        { "a.ply --method dp --tolerance 0.1", "--order, --cache: expected --method convex" },
        { "a.ply --cache a --method sorted", "--order, --cache: expected --method convex" },
        { "a.ply --pieces many", "--pieces: expected both, outward or merged" },
        { "a.ply --order some", "--order: expected exact or grid" },
        { "a.ply --as-printed", "--as-printed: expected --sigma" },
        { "a.ply --camera a.json --from 1 2", "--camera and --from" },
        { "a.ply --from 0 90", "-89 to 89 degrees" },
        { "a.ply --size 0x5", "--size" },
        { "a.ply --error 1 --method dp", "--error chooses the setting" },
        { "a.ply -o a.nrrd", ".png" },
    };
    unlink("scene.json");
    expect_all_refused(2, "fragments", wrong, GP_COUNT(wrong));
    expect_files("");
}

static void wrong_files_are_input_errors_of_one_line(void **state)
{
    (void)state;
    static const char *const rows[][2] = {
        { "missing.ply", "missing.ply: no such file" },
        { "builtin:nothing", "no builtin mesh 'nothing'" },
        { "builtin:spheres:3", "expected an even number of layers, 2 to 96" },
        { "builtin:spheres:98", "expected an even number of layers, 2 to 96" },
        { "builtin:spheres:x", "expected an even number of layers, 2 to 96" },
        { "builtin:spheres:4:5", "expected an even number of columns, 4 to 200" },
        { "builtin:spheres:4:", "expected an even number of columns, 4 to 200" },
        { "builtin:spheres:4:8x", "expected an even number of columns, 4 to 200" },
        { "builtin:spheresx", "no builtin mesh 'spheresx'" },
        { "points.off", "points.off: has no triangles" },
        { "builtin:ball --camera one_place.json", "one_place.json:1: eye, at and up give" },
        { "builtin:ball --sigma 1 --method weighted", "--sigma: this method knows no bodies" },
    };
    unlink("scene.json");
    write_file("one_place.json", "{ \"eye\": [1, 2, 3], \"at\": [1, 2, 3] }");
    write_file("points.off", "OFF\n1 0 0\n0 0 0\n");
    expect_input_errors("fragments -o a.png", rows, GP_COUNT(rows));
    expect_files("one_place.json points.off");
}

/* --- what is drawn ---------------------------------------------------------------------------- */

static void figures_are_told_as_lines_and_as_json(void **state)
{
    (void)state;
    unlink("scene.json");
    assert_int_equal(shell("glasspipe fragments builtin:ball -q -o a.png --size 64x48 --measure"),
                     0);
    expect_contains(out, "hash A16B16G16R16F 64x48 ");
    expect_contains(out, " pixels wrong, 0 of them beyond edges; 2 layers\n");
    static const char *const members[] = { "\"wrong\": ",
                                           "\"wrong_beyond_edges\": 0",
                                           "\"layers\": 2",
                                           "\"fragments\": ",
                                           "\"passes\": ",
                                           "\"readings\": 1",
                                           "\"bytes\": ",
                                           "\"triangles\": ",
                                           "\"setting\": \"--method sorted" };
    assert_int_equal(
        shell("glasspipe fragments builtin:ball -q -o a.png --size 64x48 --measure --json"), 0);
    for (size_t i = 0; i < GP_COUNT(members); i++)
        expect_contains(out, members[i]);
    expect_files("a.png");
}

/* An option of one method means that method; alpha is in EXR, and of its own in a picture. */
static void options_mean_their_method_and_alpha_is_written(void **state)
{
    (void)state;
    unlink("scene.json");
    assert_int_equal(
        shell("glasspipe fragments builtin:ball -q -o a.exr --size 32x32 --hazard 4 --json"), 0);
    expect_contains(out, "--method kbuffer");
    assert_int_equal(shell("glasspipe fragments builtin:ball -q -o a.exr --size 32x32 --alpha 0.5 "
                           "--output-opacity b.pfm"),
                     0);
    expect_files("a.exr b.pfm");
}

/* Made once, read again, told and made anew where they are of something else. */
static void convex_pieces_are_kept(void **state)
{
    (void)state;
    static const char *const of_other = "a.pieces: a cache of another mesh or of other settings";
    unlink("scene.json");
    assert_int_equal(shell("glasspipe fragments builtin:ball -q -o a.exr --size 32x32 --pieces "
                           "outward --cache a.pieces --json"),
                     0);
    expect_contains(out, "--method convex");
    expect_contains(out, "\"pieces\": ");
    for (int i = 0; i < 2; i++) {
        assert_int_equal(shell("glasspipe fragments builtin:ball -q -o a.exr --size 32x32 "
                               "--pieces outward --cache a.pieces"),
                         0);
        expect_contains(out, " convex pieces in ");
        assert_null(strstr(err, "cache"));
    }
    assert_int_equal(
        shell("glasspipe fragments builtin:ball -o a.exr --size 32x32 --cache a.pieces"), 0);
    expect_contains(err, of_other);
    expect_files("a.exr a.pieces");
}

/* From inside, from behind, by parallel rays, with nothing in view, and pictures of one pixel. */
static void odd_places_and_sizes_are_drawn(void **state)
{
    (void)state;
    static const char *const methods[] = { "sorted",  "convex",  "dp",      "ddp",      "kbuffer",
                                           "stencil", "bucket1", "bucket2", "adaptive", "mdt",
                                           "abuffer", "cpu",     "weighted" };
    unlink("scene.json");
    write_file("inside.json", "{ \"eye\": [0.1, 0.2, 0], \"at\": [0, 0, 1], \"near\": 0.01 }");
    write_file("behind.json", "{ \"eye\": [0, 0, -9], \"at\": [0, 0, -10] }");
    write_file("parallel.json", "{ \"eye\": [0, 2, 9], \"at\": [0, 1, 0], \"height\": 5 }");
    for (size_t i = 0; i < GP_COUNT(methods); i++) {
        static const char *const views[] = { "--camera inside.json", "--camera behind.json",
                                             "--camera parallel.json", "--size 1x1" };
        for (size_t k = 0; k < GP_COUNT(views); k++)
            if (shell("glasspipe fragments builtin:ball -q -o a.exr --size 40x30 %s --method %s",
                      views[k], methods[i]))
                fail_msg("%s %s: %s", methods[i], views[k], err);
    }
    expect_files("a.exr behind.json inside.json parallel.json");
}

/* The README shows them. */
static void stored_pictures_are_what_their_commands_draw(void **state)
{
    (void)state;
    static const char *const pictures[][2] = {
        { "fragments_sorted", "" },
        { "fragments_glass", "--sigma 15" },
        { "fragments_weighted", "--method weighted" },
    };
    for (size_t i = 0; i < GP_COUNT(pictures); i++) {
        const int code =
            shell("glasspipe fragments meshes/bunny.ply --from 10 15 --size 256x256 -q "
                  "-o a.png %s",
                  pictures[i][1]);
        if (code == 3 && strstr(err, "no such file")) /* the scan is not here */
            continue;
        assert_int_equal(code, 0);
        expect_stored_picture(pictures[i][0]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(wrong_arguments_are_usage_errors),
        PROGRAM_TEST(wrong_files_are_input_errors_of_one_line),
        PROGRAM_TEST(figures_are_told_as_lines_and_as_json),
        PROGRAM_TEST(options_mean_their_method_and_alpha_is_written),
        PROGRAM_TEST(convex_pieces_are_kept),
        PROGRAM_TEST(odd_places_and_sizes_are_drawn),
        PROGRAM_TEST(stored_pictures_are_what_their_commands_draw),
    };
    return cmocka_run_group_tests_name("fragments", tests, find_program, NULL);
}
