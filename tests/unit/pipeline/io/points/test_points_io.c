/* Points from files: every dialect tells the same points. */
#include "pipeline/io/points/points.h"
#include "tests/support/folder.h"
#include "tests/support/meshes/mesh_files.h"

static GpError error;

static GpPoints read_points(const char *path)
{
    GpPoints points = { .count = 0 };
    if (gp_points_read(path, &points, &error) != GP_OK)
        fail_msg("%s", error.text);
    return points;
}

enum { NORMALS = 1, RADII = 2, COLORS = 4 };

/* The two points that all files here hold. */
static const float positions[6] = { 1, -2, 0.5f, 4, 5, 6 };
static const float normals[6] = { 0, 0, 1, 0, -3, 0 };
static const float radii[2] = { 0.25f, 0 };
static const uint8_t colors[6] = { 255, 0, 51, 1, 2, 3 };

static void assert_points(const char *path, int expected)
{
    GpPoints points = read_points(path);
    const int has =
        (points.normals ? NORMALS : 0) | (points.radii ? RADII : 0) | (points.colors ? COLORS : 0);
    if (points.count != 2 || has != expected)
        fail_msg("%s: %u points with %d, not %d", path, points.count, has, expected);
    assert_memory_equal(points.positions, positions, sizeof positions);
    if (has & NORMALS)
        assert_memory_equal(points.normals, normals, sizeof normals);
    if (has & RADII)
        assert_memory_equal(points.radii, radii, sizeof radii);
    if (has & COLORS)
        assert_memory_equal(points.colors, colors, sizeof colors);
    gp_points_free(&points);
    assert_null(points.positions);
}

static void texts_are_read_by_their_columns(void **state)
{
    (void)state;
    static const struct {
        const char *name, *text;
        int has;
    } cases[] = {
        { "a.xyz", "1 -2 .5\n4 5 6\n", 0 },
        { "a.XYZ", "# x y z\r\n\r\n  1\t-2 5e-1\r\n// more\r\n#\r\n4 5 6", 0 },
        { "a.xyz", "1 -2 .5 77\n4 5 6 -2000\n", 0 },
        { "a.xyz", "1 -2 .5 0 0 1\n4 5 6 0 -3 0\n", NORMALS },
        { "a.asc", "1 -2 .5 255 0 51\n4 5 6 1 2 3\n", COLORS },
        { "a.txt", "1 -2 .5 0 0 1 255 0 51\n4 5 6 0 -3 0 1 2 3\n", NORMALS | COLORS },
        { "a.xyz", "1 -2 .5 255 0 51 0 0 1\n4 5 6 1 2 3 0 -3 0\n", NORMALS | COLORS },
        { "a.xyzn", "1 -2 .5 0 0 1\n4 5 6 0 -3 0\n", NORMALS },
        { "a.xyzn", "1 -2 .5 0 0 1 255 0 51\n4 5 6 0 -3 0 1 2 3\n", NORMALS | COLORS },
        { "a.xyzrgb", "1 -2 .5 255 0 51\n4 5 6 1 2 3\n", COLORS },
        { "a.xyzrgb", "1 -2 .5 1 0 .2\n4 5 6 .004 .008 .012\n", COLORS },
        { "a.pts", "1 -2 .5\n4 5 6\n", 0 },
        { "a.pts", "2\n1 -2 .5\n4 5 6\n", 0 },
        { "a.pts", "2\n1 -2 .5 -11 255 0 51\n4 5 6 9 1 2 3\n", COLORS },
        { "a.pts", "1\n1 -2 .5 -11 255 0 51\n1\n4 5 6 9 1 2 3\n", COLORS },
        { "a.pts", "2 \n1 -2 .5 255 0 51\n4 5 6 1 2 3\n", COLORS },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++)
        assert_points(put_text(cases[i].name, cases[i].text), cases[i].has);
}

static void small_integers_are_a_normal_where_none_is_above_one(void **state)
{
    (void)state;
    GpPoints points = read_points(put_text("a.xyz", "0 0 0 0 0 1\n1 1 1 1 0 0\n"));
    assert_non_null(points.normals);
    assert_null(points.colors);
    gp_points_free(&points);
}

/* --- PLY -------------------------------------------------------------------------------------- */

typedef struct Property {
    const char *name; /* that of a list begins with '*' */
    int type;         /* of `types` */
} Property;

static const struct Type {
    const char *name;
    size_t size; /* negative numbers and fractions where it is a float */
    bool is_float;
} types[] = { { "char", 1, false },   { "uint8", 1, false }, { "short", 2, false },
              { "ushort", 2, false }, { "int32", 4, false }, { "uint", 4, false },
              { "float", 4, true },   { "double", 8, true } };

enum { I8, U8, I16, U16, I32, U32, F32, F64 };

/* What a property of a point is; texts, since types differ. */
static double value_of(const char *name, int point, int type)
{
    static const char *const names[] = { "x",  "y",      "z",   "nx",    "ny",
                                         "nz", "radius", "red", "green", "blue" };
    const double color_scale = type == U16 ? 257 : types[type].is_float ? 1 / 255.0 : 1;
    for (int i = 0; i < 10; i++) {
        if (strcmp(name, names[i]) != 0)
            continue;
        return i < 3   ? (double)positions[3 * point + i]
               : i < 6 ? (double)normals[3 * point + i - 3]
               : i < 7 ? (double)radii[point]
                       : colors[3 * point + i - 7] * color_scale;
    }
    return 7; /* what is to be skipped */
}

static void put_value(MeshBytes *bytes, int type, double value)
{
    char text[16];
    snprintf(text, sizeof text, "%d ", (int)value);
    if (types[type].is_float)
        mesh_put_number(bytes, (float)value, type == F64);
    else if (bytes->encoding == 0)
        mesh_put_string(bytes, text);
    else
        mesh_put_integer(bytes, (uint32_t)(int32_t)value, types[type].size);
}

static void write_ply(MeshBytes *bytes, int encoding, const Property *properties)
{
    static const char *const encodings[] = { "ascii", "binary_little_endian", "binary_big_endian" };
    char line[160];
    *bytes = (MeshBytes){ .encoding = encoding };
    snprintf(line, sizeof line,
             "ply\nformat %s 1.0\ncomment c\nelement camera 1\nproperty float f\n"
             "element vertex 2\n",
             encodings[encoding]);
    mesh_put_string(bytes, line);
    for (const Property *p = properties; p->name; p++) {
        snprintf(line, sizeof line, "property %s%s %s\n", p->name[0] == '*' ? "list uchar " : "",
                 types[p->type].name, p->name);
        mesh_put_string(bytes, line);
    }
    mesh_put_string(bytes, "element strip 1\nproperty list uchar int corners\nend_header\n");
    put_value(bytes, F32, 3);
    for (int point = 0; point < 2; point++) {
        for (const Property *p = properties; p->name; p++) {
            if (p->name[0] == '*')
                put_value(bytes, U8, 2);
            for (int i = 0; i < (p->name[0] == '*' ? 2 : 1); i++)
                put_value(bytes, p->type, value_of(p->name, point, p->type));
        }
    }
    for (uint32_t i = 0; i < 4; i++)
        mesh_put_integer(bytes, i == 0 ? 3 : i % 2, i == 0 ? 1 : 4);
}

static void ply_properties_come_in_any_order_type_and_encoding(void **state)
{
    (void)state;
    static const struct {
        Property properties[16];
        int has;
    } cases[] = {
        { { { "x", F32 }, { "y", F32 }, { "z", F32 } }, 0 },
        { { { "z", F64 }, { "y", I8 }, { "other", I16 }, { "x", I32 } }, 0 },
        { { { "nx", I16 }, { "x", U32 }, { "ny", I8 }, { "y", F64 }, { "nz", F32 }, { "z", F32 } },
          NORMALS },
        { { { "x", F32 }, { "y", F32 }, { "z", F32 }, { "nx", F32 }, { "ny", F32 } }, 0 },
        { { { "*list", I32 },
            { "x", F32 },
            { "y", F32 },
            { "z", F32 },
            { "radius", F64 },
            { "*after", F64 } },
          RADII },
        { { { "red", U8 },
            { "green", U8 },
            { "blue", U8 },
            { "alpha", U8 },
            { "x", F32 },
            { "y", F32 },
            { "z", F32 } },
          COLORS },
        { { { "blue", U16 },
            { "x", F32 },
            { "y", F32 },
            { "z", F32 },
            { "green", U16 },
            { "red", U16 },
            { "radius", F32 } },
          RADII | COLORS },
        { { { "x", F32 },
            { "y", F32 },
            { "z", F32 },
            { "nz", F32 },
            { "ny", F32 },
            { "nx", F32 },
            { "red", F64 },
            { "green", F32 },
            { "blue", I32 },
            { "radius", F32 } },
          NORMALS | RADII | COLORS },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        for (int encoding = 0; encoding < 3; encoding++) {
            MeshBytes bytes;
            write_ply(&bytes, encoding, cases[i].properties);
            const char *path = put_file("a.ply", bytes.data, bytes.size);
            assert_points(path, cases[i].has);
            GpPoints points = read_points(path);
            assert_int_equal(points.face_count, 0);
            gp_points_free(&points);
        }
    }
}

static void of_a_mesh_only_its_faces_are_counted(void **state)
{
    (void)state;
    GpPoints points = read_points(put_text(
        "a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                 "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
                 "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n"));
    assert_int_equal(points.face_count, 2);
    assert_int_equal(points.count, 0);
    assert_null(points.positions);
    gp_points_free(&points);
}

/* --- what is wrong ---------------------------------------------------------------------------- */

#define PLY(rows)                                                                                  \
    "ply\nformat ascii 1.0\nelement vertex " rows "\nproperty float x\nproperty float y\n"         \
    "property float z\nproperty float radius\nproperty short red\nproperty short green\n"          \
    "property short blue\nend_header\n"

static const struct {
    const char *name, *text, *part;
    GpResult result;
} error_cases[] = {
    { "a.3ds", "0 0 0\n", ".xyzrgb", GP_ERROR_UNSUPPORTED },
    { "a.pts", "", "empty", GP_ERROR_FORMAT },
    { "a.xyz", "\n# nothing\n// at all\n", "no points", GP_ERROR_FORMAT },
    { "a.pts", "0\n", "no points", GP_ERROR_FORMAT },
    { "a.xyz", "0 0\n", "line 1: expected 3, 4, 6 or 9 numbers in a line, found 2",
      GP_ERROR_FORMAT },
    { "a.xyz", "0 0 0 0 0 0 0 0 0 0 0\n",
      "line 1: expected 3, 4, 6 or 9 numbers in a line, found "
      "more than 9",
      GP_ERROR_FORMAT },
    { "a.xyzn", "0 0 0\n", "line 1: expected 6 or 9", GP_ERROR_FORMAT },
    { "a.xyzrgb", "0 0 0\n", "line 1: expected 6", GP_ERROR_FORMAT },
    { "a.pts", "0 0 0 1 2\n", "line 1: expected 3, 4, 6 or 7", GP_ERROR_FORMAT },
    { "a.xyz", "0 0 0\n\n0 0 0 1\n", "line 3: expected 3 numbers, as before, found 4",
      GP_ERROR_FORMAT },
    { "a.xyz", "0 0 0\n0 nan 0\n", "line 2: expected a finite number, found 'nan'",
      GP_ERROR_FORMAT },
    { "a.xyz", "0 0 1e39\n", "line 1: expected a finite number, found '1e39'", GP_ERROR_FORMAT },
    { "a.xyz", "1,5 2,5 3,5\n", "found '1,5'", GP_ERROR_FORMAT },
    { "a.pts", "2147483648\n0 0 0\n", "line 1: 2147483648 points are promised", GP_ERROR_FORMAT },
    { "a.pts", "-1\n0 0 0\n", "line 1: -1 points are promised", GP_ERROR_FORMAT },
    { "a.pts", "3\n0 0 0\n0 0 0\n", "line 1: 3 points are promised, but only 13 bytes follow",
      GP_ERROR_FORMAT },
    { "a.pts", "3\n0 0 0\n0.25 0.25 0.25\n", "but 1 more points are expected", GP_ERROR_FORMAT },
    { "a.pts", "1\n0 0 0\n0 0 0\n", "line 3: expected the end of the file after the 1 points",
      GP_ERROR_FORMAT },
    { "a.pts", "0 0 0 1 2 3\n0 0 0 1 2 256\n", "point 0: expected colours", GP_ERROR_FORMAT },
    { "a.ply", "plx\n", "line 1: expected 'ply'", GP_ERROR_FORMAT },
    { "a.ply", PLY("2147483648") "0 0 0 1 0 0 0\n", "line 3: 2147483648 elements are promised",
      GP_ERROR_FORMAT },
    { "a.ply", PLY("99") "0 0 0 1 0 0 0\n", "99 points are promised, which need 1386 bytes",
      GP_ERROR_FORMAT },
    { "a.ply", PLY("0"), "no points", GP_ERROR_FORMAT },
    { "a.ply", PLY("1") "0 0 0 1 0 0 256\n", "line 12: vertex 0: expected a colour in 0..255",
      GP_ERROR_FORMAT },
    { "a.ply", PLY("1") "0 0 0 -1 0 0 0\n", "vertex 0: expected a radius of 0 or more",
      GP_ERROR_FORMAT },
    { "a.ply", PLY("1") "0 0 inf 1 0 0 0\n", "line 12: vertex 0: expected a finite number",
      GP_ERROR_FORMAT },
    { "a.ply", PLY("1") "0 0 0 1 0 0 0 7\n", "expected the end of the file", GP_ERROR_FORMAT },
};

static void errors_name_the_place_and_what_was_expected(void **state)
{
    (void)state;
    for (size_t i = 0; i < GP_COUNT(error_cases); i++) {
        GpPoints points = { .count = 77 };
        const char *path = put_text(error_cases[i].name, error_cases[i].text);
        error.text[0] = '\0';
        GpResult result = gp_points_read(path, &points, &error);
        if (result != error_cases[i].result || !strstr(error.text, error_cases[i].part) ||
            !strstr(error.text, path))
            fail_msg("expected '%s': got %s, '%s'", error_cases[i].part, gp_result_name(result),
                     error.text);
        assert_int_equal(points.count, 77);
    }
    GpPoints points;
    assert_int_equal(gp_points_read(in_folder("none.pts"), &points, &error), GP_ERROR_IO);
}

static void binary_errors_name_the_byte(void **state)
{
    (void)state;
    static const Property plain[] = { { "x", F32 }, { "y", F32 }, { "z", F32 }, { NULL, 0 } };
    MeshBytes bytes;
    write_ply(&bytes, 2, plain);
    const size_t first = bytes.size - 13 - 24;
    bytes.data[first + 16] = 0x7f; /* the second y is infinite */
    bytes.data[first + 17] = (char)0x80;
    bytes.data[first + 18] = bytes.data[first + 19] = 0;
    char part[80];
    snprintf(part, sizeof part, "byte %zu: vertex 1: expected a finite number", first + 16);
    GpPoints points;
    assert_int_equal(gp_points_read(put_file("a.ply", bytes.data, bytes.size), &points, &error),
                     GP_ERROR_FORMAT);
    if (!strstr(error.text, part))
        fail_msg("expected '%s', got '%s'", part, error.text);
}

/* Reads a file that may be damaged. What is taken must keep what the reader promises. */
static GpResult read_and_verify(const char *path)
{
    GpPoints points = { .count = 0 };
    error.text[0] = '\0';
    const GpResult result = gp_points_read(path, &points, &error);
    if (result != GP_OK && !strstr(error.text, path))
        fail_msg("no file is named: '%s'", error.text);
    if (result == GP_OK && points.count == 0 && points.face_count == 0)
        fail_msg("%s: no points, no error", path);
    for (size_t i = 0; i < 3 * (size_t)points.count; i++) {
        const float zero = points.positions[i] - points.positions[i];
        if (zero != 0 || (points.normals && points.normals[i] - points.normals[i] != 0))
            fail_msg("%s: number %zu is not finite", path, i);
    }
    for (size_t i = 0; points.radii && i < points.count; i++)
        assert_true(points.radii[i] >= 0);
    gp_points_free(&points);
    return result;
}

typedef struct Sample {
    const char *name;
    MeshBytes bytes;
    bool is_counted; /* then each truncation is an error, but that of a last blank */
} Sample;

static size_t make_samples(Sample samples[8])
{
    static const Property all[] = { { "x", F64 },   { "nx", I8 },      { "y", F32 },
                                    { "z", F32 },   { "red", U16 },    { "green", U8 },
                                    { "blue", U8 }, { "ny", F32 },     { "*l", U16 },
                                    { "nz", F32 },  { "radius", F32 }, { NULL, 0 } };
    static const char *const texts[][2] = {
        { "a.xyz", "# c\n1 -2 .5 0 0 1\n// d\n4 5 6 0 -3e0 0\n" },
        { "a.pts", "2\n1 -2 .5 -11 255 0 51\n4 5 6 9 1 2 3\n" },
        { "a.xyzrgb", "1 -2 .5 1 0 .2\n4 5 6 .004 .008 .012\n" },
    };
    size_t count = 0;
    for (; count < 3; count++) {
        samples[count] = (Sample){ .name = "a.ply", .is_counted = true };
        write_ply(&samples[count].bytes, (int)count, all);
    }
    for (size_t i = 0; i < GP_COUNT(texts); i++, count++) {
        samples[count] = (Sample){ .name = texts[i][0] };
        mesh_put_string(&samples[count].bytes, texts[i][1]);
    }
    return count;
}

static void every_truncation_is_refused_or_whole_lines(void **state)
{
    (void)state;
    static Sample samples[8];
    const size_t count = make_samples(samples);
    for (size_t i = 0; i < count; i++) {
        const MeshBytes *bytes = &samples[i].bytes;
        const char *path = put_file(samples[i].name, bytes->data, bytes->size);
        assert_int_equal(read_and_verify(path), GP_OK);
        for (size_t size = bytes->size; size-- > 0;) {
            assert_int_equal(truncate(path, (off_t)size), 0);
            const GpResult result = read_and_verify(path);
            if (samples[i].is_counted && size + (bytes->encoding ? 0 : 1) < bytes->size &&
                result == GP_OK)
                fail_msg("%s, encoding %d: %zu bytes of %zu are taken", path, bytes->encoding, size,
                         bytes->size);
        }
    }
}

static void every_byte_changed_gives_points_or_an_error(void **state)
{
    (void)state;
    static const char likely[] = { 0, 1, '0', '9', ' ', '\n', '-', '.', '/', '#', 'e', 127, -1 };
    static Sample samples[8];
    const size_t count = make_samples(samples);
    unsigned refused = 0, taken = 0;
    for (size_t i = 0; i < count; i++) {
        MeshBytes *bytes = &samples[i].bytes;
        for (size_t at = 0; at < bytes->size; at++) {
            const char before = bytes->data[at];
            for (size_t c = 0; c < sizeof likely; c++) {
                bytes->data[at] = likely[c];
                const char *path = put_file(samples[i].name, bytes->data, bytes->size);
                *(read_and_verify(path) == GP_OK ? &taken : &refused) += 1;
            }
            bytes->data[at] = before;
        }
    }
    assert_true(taken > 1000 && refused > 1000);
}

static void scans_are_read_whole(void **state)
{
    (void)state;
    static const struct {
        const char *path;
        uint32_t count;
        bool has_colors;
    } scans[] = { { "../shared/data/points/lion_takanawa.ply", 341989, true },
                  { "../shared/data/points/rangemap_lato315.ply", 62361, false } };
    for (size_t i = 0; i < GP_COUNT(scans); i++) {
        if (access(scans[i].path, R_OK) != 0) {
            print_message("skipped: %s is not there\n", scans[i].path);
            continue;
        }
        GpPoints points = read_points(scans[i].path);
        assert_int_equal(points.count, scans[i].count);
        assert_non_null(points.normals);
        assert_true((points.colors != NULL) == scans[i].has_colors);
        assert_int_equal(points.face_count, 0);
        gp_points_free(&points);
    }
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, folder_tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(texts_are_read_by_their_columns),
        TEST(small_integers_are_a_normal_where_none_is_above_one),
        TEST(ply_properties_come_in_any_order_type_and_encoding),
        TEST(of_a_mesh_only_its_faces_are_counted),
        TEST(errors_name_the_place_and_what_was_expected),
        TEST(binary_errors_name_the_byte),
        TEST(every_truncation_is_refused_or_whole_lines),
        TEST(every_byte_changed_gives_points_or_an_error),
        cmocka_unit_test(scans_are_read_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
