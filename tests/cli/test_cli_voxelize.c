/* glasspipe voxelize as its user meets it. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

#include <sys/stat.h>

/* A tetrahedron, whole and without its last side, and a triangle of it turned over. */
static const char vertices[] = "0 0 0\n4 0 0\n0 4 0\n0 0 4\n";

static void write_meshes(void)
{
    char text[200];
    snprintf(text, sizeof text, "OFF\n4 4 0\n%s3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n", vertices);
    write_file("closed.off", text);
    snprintf(text, sizeof text, "OFF\n4 3 0\n%s3 0 2 1\n3 0 1 3\n3 0 3 2\n", vertices);
    write_file("open.off", text);
    snprintf(text, sizeof text, "OFF\n4 4 0\n%s3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 3 2\n", vertices);
    write_file("turned.off", text);
    unlink("scene.json");
}

/* --- what is refused -------------------------------------------------------------------------- */

static void wrong_arguments_are_usage_errors(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "", "expected a mesh file" },
        { "a.ply b.ply", "b.ply" },
        { "a.ply -n 7", "--size: expected a whole number from 8 to 1024, not '7'" },
        { "a.ply -n 1025", "--size" },
        { "a.ply --size 64x64", "--size" },
        { "a.ply --kind liquid", "--kind: expected surface or solid" },
        { "a.ply --method magic", "--method: expected auto, conservative" },
        { "a.ply --bits 17", "--bits" },
        { "a.ply --blend xor", "--blend" },
        { "a.ply --axes 4", "--axes" },
        { "a.ply --value x", "--value" },
        { "a.ply --xform 1 2 3", "--xform: expected four numbers" },
        { "a.ply --xform 0 1 2 3", "the first above 0" },
        { "a.ply --xform 1 2 x 3", "not 'x'" },
        { "a.ply --xform 1 2 3 nan", "not 'nan'" },
        { "a.ply --xform 1 2 3 -1e31", "not '-1e31'" },
        { "a.ply --error 5 -n 64", "--error chooses the setting" },
        { "a.ply -o a.jpg", ".nrrd or .bits, or that of a picture" },
        { "a.ply --twist 1441", "--twist: expected a number from -1440 to 1440" },
        { "a.ply --with b.ply --combine both", "--combine: expected union, intersection" },
        { "a.ply --with b.ply --fit 0", "--fit: expected a number from 0.001" },
        { "a.ply --with b.ply --move 1 2", "--move: expected three numbers" },
        { "a.ply --with b.ply --scan c.nrrd -o a.png", "--scan is around one model" },
        { "a.ply --combine union", "--combine needs a second model" },
        { "a.ply --move 1 2 3", "--move moves a second model" },
        { "a.ply --xform 1 2 3 4 --fit 2", "--xform places the model" },
        { "a.ply --scan c.nrrd", "--scan is for pictures: -o FILE.png" },
        { "a.ply --look opaque", "for pictures: -o FILE.png" },
        { "a.ply --shading none -o a.png", "--shading: expected smooth or cubes" },
        { "a.ply --picture 64 -o a.png", "--picture: expected WIDTHxHEIGHT" },
        { "a.ply --from 10 90 -o a.png", "-89 to 89 degrees, not 10 90" },
        { "a.ply --zoom 11 -o a.png", "--zoom: expected a number from 0.1 to 10" },
        { "a.ply -o ''", "-o" },
        { "a.ply --bits 8 --method sheets -o a.bits", "one bit a voxel, not 8" },
        { "a.ply --frobnicate", "frobnicate" },
    };
    expect_all_refused(2, "voxelize", wrong, GP_COUNT(wrong));
    assert_int_equal(mkdir("directory.nrrd", 0777), 0);
    expect_refused(2, "voxelize a.ply -o directory.nrrd", "directory");
}

static void wrong_meshes_and_settings_are_input_errors(void **state)
{
    (void)state;
    write_meshes();
    write_file("text.ply", "this is no mesh\n");
    write_file("empty.off", "OFF\n0 0 0\n");
    write_file("points.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
    write_file("scan.raw", "1234567");
    write_file("scan.json", "{ \"dims\": [2, 2, 2], \"type\": \"uint8\" }\n");
    expect_refused(3, "voxelize missing.ply", "missing.ply");
    expect_refused(3, "voxelize text.ply", "text.ply");
    expect_refused(3, "voxelize empty.off", "empty.off");
    expect_refused(3, "voxelize .", ".");
    expect_refused(3, "voxelize builtin:nothing", "no builtin mesh 'nothing'");
    expect_refused(3, "voxelize closed.off --method xor", "--kind solid");
    expect_refused(3, "voxelize closed.off --kind solid --method thin", "not solids");
    expect_refused(2, "voxelize closed.off --bits 3 --method sheets", "expected 1, 8 or 16");
    expect_refused(3, "voxelize closed.off --error 5 --trust-chart",
                   "`glasspipe chart voxelize' makes a chart");
    expect_refused(3, "voxelize 'implicit:x^'", "expected");
    expect_refused(3, "voxelize parametric:cube", "no parametric surface");
    expect_refused(3, "voxelize points.off --kind solid", "points: no inside");
    expect_refused(3, "voxelize closed.off --points --kind solid", "points: no inside");
    expect_refused(3, "voxelize implicit:quartic --method thin", "--method is for meshes");
    expect_refused(3, "voxelize implicit:quartic --report", "--report is for meshes");
    expect_refused(3, "voxelize closed.off --with missing.ply", "missing.ply");
    expect_refused(3, "voxelize closed.off --with builtin:cube --twist 9", "--twist turns about");
    expect_refused(3, "voxelize closed.off --kind solid --with points.off", "points.off: points");
    expect_refused(3, "voxelize closed.off --scan missing.nrrd -o a.png", "missing.nrrd");
    expect_refused(3, "voxelize closed.off --scan scan.raw -o a.png", "scan.raw");
    expect_refused(3, "voxelize closed.off --method sheets --bits 8 -o a.png", "one bit a voxel");
    expect_files("closed.off empty.off open.off points.off scan.json scan.raw text.ply turned.off");
}

static void options_that_do_not_go_together_are_usage_errors(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "--bits 8", "only --method sheets" },
        { "--axes 2", "--axes: expected 1 or 3, not 2" },
        { "--axes 2 --method sheets", "--axes: expected 1 or 3, not 2" },
        { "--axes 1", "--axes is for --method sheets" },
        { "--blend or --method thin", "--blend is for --method sheets" },
        { "--counters byte", "--counters is for --method winding" },
        { "--value density", "--value is for --bits 8 and 16" },
        { "--value density --method sheets", "--value is for --bits 8 and 16" },
        { "--twist 9 --method slices", "--twist: expected --method" },
        { "--twist 9 --method sheets", "--twist: expected --method" },
    };
    expect_all_refused(2, "voxelize none.off", wrong, GP_COUNT(wrong)); /* before it is read */
    expect_files("scene.json");
}

/* A tetrahedron of a size, at a place along x. */
static void write_tetrahedron(const char *path, double side, double place)
{
    char text[400];
    snprintf(text, sizeof text,
             "OFF\n4 4 0\n%g 0 0\n%g 0 0\n%g %g 0\n%g 0 %g\n"
             "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
             place, place + side, place, side, place, side);
    write_file(path, text);
}

/* What has the right voxels has those of any other size. */
static void sizes_beyond_floats_are_refused_and_others_are_right(void **state)
{
    (void)state;
    static const double sides[] = { 1e-35, 1e-20, 1e20, 1e38 };
    write_tetrahedron("a.off", 1, 0);
    assert_int_equal(shell("glasspipe voxelize a.off -n 64 --kind solid"), 0);
    static char first[sizeof out];
    strcpy(first, out);
    expect_matches(out, "voxels [1-9]");
    for (size_t i = 0; i < GP_COUNT(sides); i++) {
        write_tetrahedron("b.off", sides[i], 0);
        assert_int_equal(shell("glasspipe voxelize b.off -n 64 --kind solid"), 0);
        assert_string_equal(out, first);
    }
    write_tetrahedron("c.off", 1e-37, 0);
    expect_refused(3, "voxelize c.off", "c.off: 1e-37 is no longest side for voxels of ");
    expect_refused(3, "voxelize c.off --kind solid", "c.off: 1e-37");
    expect_refused(3, "voxelize c.off --points", "c.off: 1e-37");
    expect_refused(3, "voxelize a.off --with c.off --fit 1", "c.off: 1e-37");
    expect_refused(3, "voxelize a.off --xform 1e-42 0 0 0", "a.off: 1 is no longest side");
}

/* A square of squares, two triangles each: binary PLY, since it has 190 MB. */
static void write_grid(const char *path, uint32_t side)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    fprintf(file,
            "ply\nformat binary_little_endian 1.0\nelement vertex %u\nproperty float x\n"
            "property float y\nproperty float z\nelement face %u\n"
            "property list uchar int vertex_indices\nend_header\n",
            side * side, 2 * (side - 1) * (side - 1));
    for (uint32_t i = 0; i < side * side; i++) {
        const float at[3] = { (float)(i % side), (float)(i / side), 0 };
        fwrite(at, sizeof at, 1, file);
    }
    for (uint32_t y = 0; y + 1 < side; y++)
        for (uint32_t x = 0; x + 1 < side; x++) {
            const uint32_t i = y * side + x;
            const uint32_t faces[2][3] = { { i, i + 1, i + side },
                                           { i + 1, i + side + 1, i + side } };
            for (int k = 0; k < 2; k++) {
                fputc(3, file);
                fwrite(faces[k], sizeof faces[k], 1, file);
            }
        }
    assert_int_equal(fclose(file), 0);
}

/* Ten million triangles, many to a voxel: the same voxels as two triangles have. */
static void ten_million_triangles_are_voxelized(void **state)
{
    (void)state;
    if (!getenv("GP_TEST_LARGE")) {
        print_message("# skipped: takes seconds and 190 MB; GP_TEST_LARGE=1 runs it\n");
        skip();
    }
    write_grid("two.ply", 2);
    assert_int_equal(shell("glasspipe voxelize two.ply"), 0);
    static char first[sizeof out];
    strcpy(first, out);
    write_grid("grid.ply", 2237);
    assert_int_equal(shell("glasspipe voxelize grid.ply"), 0);
    assert_string_equal(out, first);
}

/* --- what is made ----------------------------------------------------------------------------- */

static void volumes_are_written_and_hashed(void **state)
{
    (void)state;
    char first[256];
    static unsigned char bits[16 * 16 * 2 + 2];
    assert_int_equal(shell("glasspipe voxelize builtin:cube -n 16 -o a.bits"), 0);
    /* 13.5 voxels, from 1.25 to 14.75: 14^3 without 12^3 */
    expect_matches(out, "^hash VOXELS 16x16x16 [0-9a-f]{16}\nvoxels 1016\n$");
    expect_contains(err, "wrote a.bits");
    strcpy(first, out);
    assert_int_equal(read_file("a.bits", (char *)bits, sizeof bits), 512);
    assert_int_equal(bits[0], 0);
    assert_int_equal(bits[2 * (1 + 16 * 1)], 0xfe); /* x from 1 to 14 at y = z = 1 */
    assert_int_equal(bits[2 * (1 + 16 * 1) + 1], 0x7f);
    assert_int_equal(bits[2 * (5 + 16 * 7)], 0x02); /* only the sides inside */

    assert_int_equal(shell("glasspipe voxelize -q builtin:cube --size=16"), 0);
    assert_string_equal(out, first);
    assert_string_equal(err, "");
    assert_int_equal(shell("head -n 1 cube.nrrd"), 0);
    expect_contains(out, "NRRD000");
    assert_int_equal(mkdir("out", 0777), 0);
    assert_int_equal(shell("glasspipe voxelize builtin:cube -n 16"), 0);
    expect_contains(err, "wrote out/cube.nrrd");
    expect_files("a.bits cube.nrrd out scene.json");
}

static void a_volume_is_the_same_on_everything(void **state)
{
    (void)state;
    static const char *const settings[] = { "", "--method thin", "--kind solid" };
    for (size_t i = 0; i < GP_COUNT(settings); i++) {
        char first[256];
        assert_int_equal(shell("glasspipe voxelize -q builtin:knot -n 40 %s", settings[i]), 0);
        strcpy(first, out);
        static const char *const same[] = { "--threads 1", "--threads 3", "--executor reference" };
        for (size_t k = 0; k < GP_COUNT(same); k++) {
            assert_int_equal(
                shell("glasspipe voxelize -q builtin:knot -n 40 %s %s", settings[i], same[k]), 0);
            assert_string_equal(out, first);
        }
    }
}

static void a_placed_model_lies_where_it_is_told(void **state)
{
    (void)state;
    static const char line[] =
        "glasspipe voxelize -q %s -n 16 --kind solid -o a.bits && sha256sum a.bits";
    char first[512];
    assert_int_equal(shell(line, "--xform 6.75 8 8 8 builtin:cube"), 0); /* its own box */
    strcpy(first, out);
    assert_int_equal(shell(line, "builtin:cube --xform 6.75 8 8 8"), 0);
    assert_string_equal(out, first);
    assert_int_equal(shell(line, "builtin:cube"), 0);
    assert_string_equal(out, first);
    assert_int_equal(shell(line, "builtin:cube --xform 2 2 -1 8"), 0);
    expect_contains(out, "voxels 16\n"); /* 4 x 1 x 4 of 4 x 4 x 4 are inside */
}

static void json_has_the_volume_its_times_and_the_report(void **state)
{
    (void)state;
    char hash[256];
    assert_int_equal(shell("glasspipe voxelize builtin:torus -n 24 --kind solid"), 0);
    strcpy(hash, out);
    assert_int_equal(shell("glasspipe voxelize builtin:torus -n 24 --kind solid --json"), 0);
    json_t *object = parse_output(), *told = json_object_get(object, "report");
    expect_contains(hash, json_string_value(json_object_get(object, "hash")));
    static const char *const numbers[] = { "ms", "first_ms", "cpu_ms" };
    for (size_t i = 0; i < GP_COUNT(numbers); i++)
        assert_true(json_number_value(json_object_get(object, numbers[i])) > 0);
    static const char *const integers[] = { "voxels", "triangles", "passes", "threads" };
    for (size_t i = 0; i < GP_COUNT(integers); i++)
        assert_true(json_integer_value(json_object_get(object, integers[i])) > 0);
    assert_int_equal(json_integer_value(json_object_get(object, "bytes")), 24 * 24 * 24 / 8);
    assert_int_equal(json_integer_value(json_object_get(object, "depth")), 24);
    expect_contains(json_string_value(json_object_get(object, "setting")),
                    "--size 24 --kind solid --method xor");
    assert_true(json_is_true(json_object_get(told, "closed")));
    assert_true(json_is_false(json_object_get(told, "inside_out")));
    assert_int_equal(json_integer_value(json_object_get(told, "boundary_edges")), 0);
    assert_int_equal(json_integer_value(json_object_get(told, "odd_columns_z")), 0);
    assert_non_null(json_object_get(told, "disagreeing_voxels"));
    json_decref(object);
}

/* --- meshes that are not closed --------------------------------------------------------------- */

static void a_solid_of_an_open_mesh_warns(void **state)
{
    (void)state;
    write_meshes();
    assert_int_equal(shell("glasspipe voxelize -q closed.off -n 16 --kind solid"), 0);
    assert_string_equal(err, "");
    assert_int_equal(shell("glasspipe voxelize -q open.off -n 16"), 0);
    assert_string_equal(err, "");
    assert_int_equal(shell("glasspipe voxelize -q open.off -n 16 --kind solid"), 0);
    expect_contains(err, "warning: open.off is not closed: 3 boundary edges");
    expect_contains(err, "odd number of triangles");
    assert_int_equal(shell("glasspipe voxelize -q open.off -n 16 --report"), 0);
    expect_matches(out, "\nnon-manifold edges +0\n");
    assert_int_equal(shell("glasspipe voxelize -q turned.off -n 16 --kind solid --json"), 0);
    expect_contains(err, "turned.off is not closed: 3 inconsistently oriented edges");
    json_t *object = parse_output(), *told = json_object_get(object, "report");
    assert_true(json_is_false(json_object_get(told, "closed")));
    assert_int_equal(json_integer_value(json_object_get(told, "inconsistently_oriented_edges")), 3);
    assert_int_equal(json_integer_value(json_object_get(told, "odd_columns_z")), 0);
    json_decref(object);
}

/* Methods that draw surfaces inside the volume alone say so where the model leaves it. */
static void a_solid_that_leaves_its_volume_warns(void **state)
{
    static const struct {
        const char *options;
        bool warns;
    } rows[] = {
        { "--fit 1.3", false },
        { "--fit 1.3 --method winding", false },
        { "--fit 1.3 --method slices", true },
        { "--fit 1.3 --method ldi", true },
        { "--fit 1.3 --method faces", true },
        { "--fit 1.3 --method sheets", true },
        { "--fit 1.3 --method sheets --axes 1", true },
        { "--fit 0.9 --method slices", false },
        { "--fit 0.9 --method faces", false },
        { "--xform 7 0 8 8 --method slices", false }, /* beside the lines that it looks along */
        { "--xform 7 0 8 8 --method faces", true },
    };
    (void)state;
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        assert_int_equal(
            shell("glasspipe voxelize -q builtin:sphere -n 16 --kind solid %s", rows[i].options),
            0);
        if (rows[i].warns)
            expect_contains(err, "warning: builtin:sphere reaches out of the volume");
        else
            assert_string_equal(err, "");
    }
}

static void the_report_tells_what_is_open(void **state)
{
    (void)state;
    write_meshes();
    assert_int_equal(shell("glasspipe voxelize -q closed.off -n 16 --report"), 0);
    expect_matches(out, "\nclosed +yes\n.*\nenclosed volume +10\\.6666667\n");
    assert_null(strstr(out, "odd columns"));
    assert_int_equal(shell("glasspipe voxelize -q open.off -n 16 --kind solid --report"), 0);
    expect_matches(out, "\nclosed +no\n");
    expect_matches(out, "\nboundary edges +3\n");
    expect_matches(out, "\nodd columns z +[1-9][0-9]*\n");
    expect_matches(out, "\ndisagreeing voxels +[1-9][0-9]*\n");
}

/* Two tetrahedra, the second over a corner of the first: of an overlap parity makes a hollow. */
static void a_solid_of_overlapping_shells_warns(void **state)
{
    (void)state;
    char text[400];
    unsigned voxels[2];
    snprintf(text, sizeof text,
             "OFF\n8 8 0\n%s1 1 1\n6 1 1\n1 6 1\n1 1 6\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
             "3 4 6 5\n3 4 5 7\n3 4 7 6\n3 5 6 7\n",
             vertices);
    write_file("two.off", text);
    assert_int_equal(shell("glasspipe voxelize -q two.off -n 40"), 0);
    assert_string_equal(err, "");
    assert_int_equal(shell("glasspipe voxelize -q two.off -n 40 --kind solid --report"), 0);
    expect_matches(err, "warning: two.off overlaps itself or has shells inside others: [1-9][0-9]* "
                        "voxels are inside");
    expect_contains(err, "--method winding fills them");
    expect_matches(out, "\nclosed +yes\n");
    expect_matches(out, "\ndisagreeing voxels +0\ndoubled voxels +[1-9][0-9]*\n");
    const unsigned doubled = (unsigned)strtoul(strstr(out, "doubled voxels") + 14, NULL, 10);
    assert_int_equal(sscanf(strstr(out, "voxels "), "voxels %u", &voxels[0]), 1);
    assert_int_equal(shell("glasspipe voxelize -q two.off -n 40 --kind solid --method winding"), 0);
    assert_string_equal(err, "");
    assert_int_equal(sscanf(strstr(out, "voxels "), "voxels %u", &voxels[1]), 1);
    assert_int_equal(voxels[1], voxels[0] + doubled);
}

typedef struct Point {
    const char *options;
    double ms, error;
} Point;

/* A chart as `glasspipe chart' writes it. */
static void write_chart(const char *file, const char *technique, const Point *points, size_t count)
{
    char text[4096];
    int used = snprintf(
        text, sizeof text,
        "{ \"technique\": \"%s\", \"title\": \"made\", \"scene\": \"closed.off\",\n"
        "  \"error_name\": \"thousandths\", \"metrics\": [], \"machine\": \"none\",\n"
        "  \"isa\": \"sse2\", \"threads\": 1, \"width\": 0, \"height\": 0, \"points\": [\n",
        technique);
    for (size_t i = 0; i < count; i++)
        used += snprintf(text + used, sizeof text - (size_t)used,
                         "%s{ \"method\": \"m\", \"options\": \"%s\", \"ms\": %g, \"min_ms\": %g, "
                         "\"cpu_ms\": %g, \"frames\": 5, \"error\": %g, \"metrics\": [], "
                         "\"best\": false, \"picture\": \"\" }",
                         i ? ",\n" : "", points[i].options, points[i].ms, points[i].ms,
                         points[i].ms, points[i].error);
    snprintf(text + used, sizeof text - (size_t)used, " ] }\n");
    write_file(file, text);
}

/* As the chart has it: the smallest volume that is near enough, by the method that loses no more
 * than that: each halving of the error is a finer volume. */
static void an_error_chooses_the_size(void **state)
{
    (void)state;
    static const Point points[] = {
        { "--method sheets --axes 1 --size 32", 0.5, 30 },
        { "--method conservative --size 16", 1, 37 },
        { "--method conservative --size 32", 2, 17 },
        { "--method thin --size 32", 3, 18 },
        { "--method conservative --size 64", 4, 8 },
        { "--method slices --size 64", 90, 14 },
    };
    static const struct {
        const char *error, *chosen, *made;
    } cases[] = {
        { "40", "chose --method sheets --axes 1 --size 32", "32x32x32" },
        { "20", "chose --method conservative --size 32", "32x32x32" },
        { "16", "chose --method conservative --size 64", "64x64x64" },
        { "8", "chose --method conservative --size 64", "64x64x64" },
    };
    write_meshes();
    write_chart("made.json", "voxelize", points, GP_COUNT(points));
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        assert_int_equal(shell("glasspipe voxelize closed.off --error %s --curve made.json "
                               "--trust-chart -o a.bits",
                               cases[i].error),
                         0);
        expect_contains(err, cases[i].chosen);
        expect_contains(out, cases[i].made);
    }
    expect_contains(err, "error 8 (expected, from another scene)");
    assert_int_equal(
        shell("glasspipe voxelize closed.off --error 7 --curve made.json --trust-chart -o a.bits"),
        1);
    expect_contains(err,
                    "not reached: the most exact of made.json, --method conservative --size 64");
    expect_contains(out, "64x64x64");
}

/* A chart that lies about sizes does not matter: the error is measured. Options of the key are
 * refused, but those that say what is meant. */
static void an_error_is_kept_whatever_the_chart_says(void **state)
{
    (void)state;
    static const Point lie = { "--method conservative --size 32", 1, 0.1 };
    write_meshes();
    write_chart("made.json", "voxelize", &lie, 1);
    assert_int_equal(
        shell("glasspipe voxelize closed.off --error 0.9%% --curve made.json -o a.bits"), 0);
    expect_matches(err, "chose --method (conservative|thin) --size 64 .*: error 0\\.[0-9]+% "
                        "\\(measured\\), [5-8]\\.[0-9]+ RMS");
    assert_int_equal(shell("glasspipe voxelize closed.off --kind solid --error 30%% -o a.bits"), 0);
    expect_matches(err, "chose --kind solid --method xor --size (32|64) \\(xor\\): error [0-9.]+% "
                        "\\(measured\\)");
    expect_refused(2, "voxelize closed.off --error 5 --kind solid --method xor",
                   "--error chooses the setting");
    expect_refused(3, "voxelize closed.off --error 5 --twist 20", "not twisted");
}

/* Solids have a chart of their own; what other techniques have is none of voxelize's. */
static void the_chart_of_solids_serves_too(void **state)
{
    (void)state;
    static const Point solid = { "--kind solid --method xor --size 32", 1, 12 };
    write_meshes();
    write_chart("solids.json", "solids", &solid, 1);
    assert_int_equal(
        shell(
            "glasspipe voxelize closed.off --error 12 --curve solids.json --trust-chart -o a.bits"),
        0);
    expect_contains(err, "chose --kind solid --method xor --size 32");
    expect_contains(err, "measured on closed.off, 1 thread, none");
    write_chart("shadow.json", "shadow", &solid, 1);
    expect_refused(3, "voxelize closed.off --error 12 --curve shadow.json", "a chart of shadow");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(options_that_do_not_go_together_are_usage_errors),
        PROGRAM_TEST(wrong_arguments_are_usage_errors),
        PROGRAM_TEST(wrong_meshes_and_settings_are_input_errors),
        PROGRAM_TEST(sizes_beyond_floats_are_refused_and_others_are_right),
        PROGRAM_TEST(ten_million_triangles_are_voxelized),
        PROGRAM_TEST(an_error_chooses_the_size),
        PROGRAM_TEST(an_error_is_kept_whatever_the_chart_says),
        PROGRAM_TEST(the_chart_of_solids_serves_too),
        PROGRAM_TEST(volumes_are_written_and_hashed),
        PROGRAM_TEST(a_volume_is_the_same_on_everything),
        PROGRAM_TEST(a_placed_model_lies_where_it_is_told),
        PROGRAM_TEST(json_has_the_volume_its_times_and_the_report),
        PROGRAM_TEST(a_solid_of_an_open_mesh_warns),
        PROGRAM_TEST(a_solid_that_leaves_its_volume_warns),
        PROGRAM_TEST(the_report_tells_what_is_open),
        PROGRAM_TEST(a_solid_of_overlapping_shells_warns),
    };
    return cmocka_run_group_tests_name("voxelize command", tests, find_program, NULL);
}
