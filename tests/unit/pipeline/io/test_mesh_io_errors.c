/* Bad mesh files: no damaged file gets past the checks with anything but an error that says where,
 * in silence. */
#include "pipeline/io/mesh/mesh_file.h"
#include "tests/support/folder.h"
#include "tests/support/meshes/mesh_files.h"
#include "tests/support/random.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>

static GpError error;

/* Between begin and end, what goes to stdout and stderr goes to a file, which must stay empty. */
static int silent_file = -1, saved_output[2];

static void restore_output(void)
{
    if (silent_file < 0)
        return;
    fflush(stdout);
    fflush(stderr);
    for (int i = 0; i < 2; i++) {
        dup2(saved_output[i], 1 + i);
        close(saved_output[i]);
    }
    close(silent_file);
    silent_file = -1;
}

static int tear_down(void **state)
{
    restore_output(); /* a check failed before it could */
    return folder_tear_down(state);
}

static void begin_silence(void)
{
    fflush(stdout);
    fflush(stderr);
    int file = open(in_folder("output"), O_RDWR | O_CREAT | O_TRUNC, 0600);
    assert_true(file >= 0);
    for (int i = 0; i < 2; i++) {
        saved_output[i] = dup(1 + i);
        dup2(file, 1 + i);
    }
    silent_file = file;
}

static void end_silence(void)
{
    struct stat info;
    restore_output();
    assert_int_equal(stat(in_folder("output"), &info), 0);
    assert_int_equal(info.st_size, 0);
}

/* --- errors ----------------------------------------------------------------------------------- */

static void assert_refused(const char *path, GpResult expected, const char *part)
{
    GpMesh mesh = { .vertex_count = 77 };
    error.text[0] = '\0';
    GpResult result = gp_mesh_read(path, GP_MESH_TRIANGLES, &mesh, &error);
    if (result != expected || !strstr(error.text, part) || !strstr(error.text, path))
        fail_msg("expected '%s': got %s, '%s'", part, gp_result_name(result), error.text);
    assert_int_equal(mesh.vertex_count, 77);
}

static void unreadable_paths_are_told_apart(void **state)
{
    (void)state;
    assert_refused(in_folder("none.ply"), GP_ERROR_IO, "No such file");
    assert_refused(in_folder("none"), GP_ERROR_UNSUPPORTED, ".ply");
    assert_refused(put_text("a.3ds", "x"), GP_ERROR_UNSUPPORTED, ".ply");
    assert_int_equal(mkdir(in_folder("folder.off"), 0777), 0);
    assert_refused(in_folder("folder.off"), GP_ERROR_IO, "folder");
    static const char *const names[] = { "a.off", "a.obj", "a.ply", "a.stl", "a.om" };
    for (size_t i = 0; i < GP_COUNT(names); i++)
        assert_refused(put_text(names[i], ""), GP_ERROR_FORMAT, "empty");
}

#define PLY_HEADER(vertices, faces)                                                                \
    "ply\nformat ascii 1.0\nelement vertex " vertices "\nproperty float x\nproperty float y\n"     \
    "property float z\nelement face " faces                                                        \
    "\nproperty list uchar int vertex_indices\nend_header\n"

static const struct {
    const char *name, *text, *part;
    GpResult result;
} error_cases[] = {
    { "a.off", "ply\n", "line 1: expected OFF, found 'ply'", GP_ERROR_FORMAT },
    { "a.off", " OFF\n0 0 0\n", "line 1: expected OFF", GP_ERROR_FORMAT },
    { "a.off", "4OFF\n0 0 0\n", "three dimensions", GP_ERROR_UNSUPPORTED },
    { "a.off", "nOFF\n0 0 0\n", "three dimensions", GP_ERROR_UNSUPPORTED },
    { "a.off", "OFF BINARY\n0 0 0\n", "binary OFF", GP_ERROR_UNSUPPORTED },
    { "a.off", "OFF\n3 x 0\n", "line 2: expected the counts", GP_ERROR_FORMAT },
    { "a.off", "OFF\n-3 1 0\n", "line 2: expected the counts", GP_ERROR_FORMAT },
    { "a.off", "OFF\n0 0 0\n", "no vertices", GP_ERROR_FORMAT },
    { "a.off", "OFF\n1 0 0\n0 0 0\n", "no faces", GP_ERROR_FORMAT },
    { "a.off", "OFF\n2147483647 1 0\n0 0 0\n", "2147483647 vertices", GP_ERROR_FORMAT },
    { "a.off", "OFF\n1 2147483647 0\n0 0 0\n", "2147483647 faces", GP_ERROR_FORMAT },
    { "a.off", "OFF\n-99999999999999999999 1 0\n", "line 2: expected the counts", GP_ERROR_FORMAT },
    { "a.off", "OFF\n0 0 0", "no vertices", GP_ERROR_FORMAT },
    { "a.off", "OFF\n1 0 0 7\n0 0 0\n", "expected nothing after the counts", GP_ERROR_FORMAT },
    { "a.off", "OFF\n2147483648 1 0\n0 0 0\n", "line 2", GP_ERROR_FORMAT },
    { "a.off", "OFF\n2 1 0\n0 0 0\n\n0 nan 0\n3 0 0 0\n", "line 5: vertex 1", GP_ERROR_FORMAT },
    { "a.off", "OFF\n1 1 0\n0 1e39 0\n3 0 0 0\n", "found '1e39'", GP_ERROR_FORMAT },
    { "a.off", "OFF\n1 1 0\n0 0x1 0\n3 0 0 0\n", "found '0x1'", GP_ERROR_FORMAT },
    { "a.off", "OFF\n2 1 0\n0 0\n0 0 0\n3 0 0 0\n", "line 3: vertex 0 has 2", GP_ERROR_FORMAT },
    { "a.off", "OFF\n1 1 0\n0 0 0\n3 0 1 0\n", "line 4: face 0 refers to vertex 1, but there are 1",
      GP_ERROR_FORMAT },
    { "a.off", "OFF\n1 1 0\n0 0 0\n3 0 -1 0\n", "vertex -1", GP_ERROR_FORMAT },
    { "a.off", "OFF\n1 1 0\n0 0 0\nx 0 0 0\n", "line 4: face 0", GP_ERROR_FORMAT },
    { "a.off", "OFF\n1 1 0\n0 1234567890123456789012345678901234567890x 0\n3 0 0 0\n",
      "found '1234567890123456789012345678901234567890...'", GP_ERROR_FORMAT },
    { "a.off", "OFF\n1 1 0\n0 0 0\n2 0 0   \n", "found '2'", GP_ERROR_FORMAT },
    { "a.off", "OFF\n1 1 0\n0 0 0\n3 0 0   \n", "expected 3 vertex numbers", GP_ERROR_FORMAT },
    { "a.off", "OFF\n1 2 0\n0 0 0\n3 0 0 0\n", "line 4: the file ends, but face 1 of 2",
      GP_ERROR_FORMAT },
    { "a.off", "COFF\n1 1 0\n0 0 0 1 2 256\n3 0 0 0\n", "colour", GP_ERROR_FORMAT },
    { "a.off", "COFF\n1 1 0\n0 0 0 1 2 .5\n3 0 0 0\n", "colour", GP_ERROR_FORMAT },

    { "a.obj", "v 0 0\n", "line 1: a vertex has no 2 numbers", GP_ERROR_FORMAT },
    { "a.obj", "v 0 0 inf\n", "found 'inf'", GP_ERROR_FORMAT },
    { "a.obj", "v 0 0 0\n\nf 1 1 2\n", "line 3: face 0 refers to vertex 2, but there are 1",
      GP_ERROR_FORMAT },
    { "a.obj", "v 0 0 0\nf 1 1 -2\nv 0 0 0\n", "vertex -2, but there are 1", GP_ERROR_FORMAT },
    { "a.obj", "v 0 0 0\nf 0 1 1\n", "vertex 0", GP_ERROR_FORMAT },
    { "a.obj", "v 0 0 0\nf 1/1 1 1\n", "texture coordinate 1, but", GP_ERROR_FORMAT },
    { "a.obj", "v 0 0 0\nf 1//1 1 1\n", "normal 1, but there are 0", GP_ERROR_FORMAT },
    { "a.obj", "v 0 0 0\nf 1/ 1 1\n", "found '1/'", GP_ERROR_FORMAT },
    { "a.obj", "v 0 0 0\nf a 1 1\n", "found 'a'", GP_ERROR_FORMAT },
    { "a.obj", "v 0 0 0\nf 1 1\n", "face 0 has 2 corners", GP_ERROR_FORMAT },
    { "a.obj", "v 0 0 0\nf 1 1 \\\n1\n", "line 2: lines continued", GP_ERROR_UNSUPPORTED },
    { "a.obj", "v 0 0 0\nv 0 0 1 1 1 1\nf 1 1 2\n", "1 of 2 vertices", GP_ERROR_FORMAT },
    { "a.obj", "v 0 0 0\nvc 1 1 1\n", "line 2: colours apart from vertices (vc)",
      GP_ERROR_UNSUPPORTED },
    { "a.obj", "v 0 0 0\nvt 1\n", "line 2: a texture coordinate", GP_ERROR_FORMAT },
    { "a.obj", "v 0 0 0\n", "no faces", GP_ERROR_FORMAT },
    { "a.obj", "v 0 0 0\nf 1 1 1\n", "no faces with an area", GP_ERROR_FORMAT },
    { "a.obj", "hello\n", "no vertices", GP_ERROR_FORMAT },

    { "a.ply", "plx\n", "line 1: expected 'ply'", GP_ERROR_FORMAT },
    { "a.ply", " ply\nformat ascii 1.0\n", "line 1: expected 'ply'", GP_ERROR_FORMAT },
    { "a.ply", "\n \n", "line 1: expected 'ply'", GP_ERROR_FORMAT },
    { "a.ply", "ply\nformat ascii\n", "line 2: expected 'format'", GP_ERROR_FORMAT },
    { "a.ply", "ply\nformat ascii 2.0\n", "line 2: expected 'format'", GP_ERROR_FORMAT },
    { "a.ply", "ply\nformat utf8 1.0\n", "line 2: expected ascii", GP_ERROR_FORMAT },
    { "a.ply", "ply\nformat ascii 1.0\nelement vertex 1\n", "end_header", GP_ERROR_FORMAT },
    { "a.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n", "line 3: expected an",
      GP_ERROR_FORMAT },
    { "a.ply", "ply\nformat ascii 1.0\nelement vertex -1\n", "line 3: expected an element's name",
      GP_ERROR_FORMAT },
    { "a.ply", "ply\nformat ascii 1.0\nelement face\n", "line 3: expected an element's name",
      GP_ERROR_FORMAT },
    { "a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\nend_header\n",
      "line 4: expected a property's type", GP_ERROR_FORMAT },
    { "a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar\nend_header\n",
      "line 4: expected a property's type", GP_ERROR_FORMAT },
    { "a.ply", "ply\nformat ascii 1.0\nelement face 1\nend_header\n", "faces before",
      GP_ERROR_UNSUPPORTED },
    { "a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\nend_header\n",
      "line 4: expected a property's type", GP_ERROR_FORMAT },
    { "a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n",
      "properties x, y and z", GP_ERROR_FORMAT },
    { "a.ply", PLY_HEADER("2147483647", "1"), "line 3: 2147483647", GP_ERROR_FORMAT },
    { "a.ply", PLY_HEADER("1", "2147483648") "0 0 0", "line 7: 2147483648", GP_ERROR_FORMAT },
    { "a.ply", PLY_HEADER("1", "0") "0 0 0", "no faces", GP_ERROR_FORMAT },
    { "a.ply", PLY_HEADER("1", "1") "0 0 inf\n",
      "line 10: vertex 0: expected a finite number, "
      "found 'inf'",
      GP_ERROR_FORMAT },
    { "a.ply", PLY_HEADER("1", "1") "0 0 0\n2 0 0\n", "line 11: face 0: expected 3 or more",
      GP_ERROR_FORMAT },
    { "a.ply", PLY_HEADER("1", "1") "0 0 0\n3 0 0 1\n",
      "line 11: face 0: expected a vertex below 1, but it refers to vertex 1", GP_ERROR_FORMAT },
    { "a.ply", PLY_HEADER("1", "1") "0 0 0\n3 0 0 1.0\n", "found '1.0'", GP_ERROR_FORMAT },
    { "a.ply", PLY_HEADER("1", "1") "0 0 0\n3 0 0\n", "the file ends", GP_ERROR_FORMAT },
    { "a.ply", PLY_HEADER("1", "1") "0 0 0\n3 0 0 0 0\n", "expected the end of the file",
      GP_ERROR_FORMAT },

    { "a.stl", "facet\n", "expected 'solid'", GP_ERROR_FORMAT },
    { "a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0\n",
      "line 5: face 0: expected 'vertex * * *'", GP_ERROR_FORMAT },
    { "a.stl", "solid\nfacet normal 0 0 1\nouter loop\n\nvertex 0 0 0\n", "line 5",
      GP_ERROR_FORMAT },
    { "a.stl", "solid\nendsolid\nfacet normal 0 0 1\n", "line 3: face 0: expected 'solid'",
      GP_ERROR_FORMAT },
    { "a.stl", "solid\nendsolid\n", "no vertices", GP_ERROR_FORMAT },
    { "a.stl", "solid x\n", "ends inside a solid", GP_ERROR_FORMAT },

    { "a.om", "OFF", "byte 0: expected OM", GP_ERROR_FORMAT },
    { "a.om", "OMX\x22zzzzzzzzzzzz", "byte 2: expected T, Q or P", GP_ERROR_FORMAT },
    { "a.om", "OMT\x7fzzzzzzzzzzzz", "byte 3: version", GP_ERROR_UNSUPPORTED },
    { "a.om", "OMT\x22zzzzzzzzzzzz", "are promised", GP_ERROR_FORMAT },
};

static void errors_name_the_place_and_what_was_expected(void **state)
{
    (void)state;
    for (size_t i = 0; i < GP_COUNT(error_cases); i++)
        assert_refused(put_text(error_cases[i].name, error_cases[i].text), error_cases[i].result,
                       error_cases[i].part);
}

/* As many elements, or properties, as a header has no room for: more than any file has that means a
 * mesh. */
static void headers_of_many_parts_are_refused(void **state)
{
    (void)state;
    static const char *const lines[] = { "element some 0\n", "property float x\n" };
    static const char *const parts[] = { "elements", "properties" };
    for (int kind = 0; kind < 2; kind++) {
        char text[8000] = "ply\nformat ascii 1.0\nelement vertex 1\n";
        for (int i = 0; i < 300; i++)
            strcat(text, lines[kind]);
        assert_refused(put_text("a.ply", text), GP_ERROR_UNSUPPORTED, "more than ");
        assert_non_null(strstr(error.text, parts[kind]));
    }
}

/* Corners that weld: each pair of the three, which leaves no area; such faces are skipped. */
static void facets_without_area_are_skipped(void **state)
{
    (void)state;
    static const char *const corners[4][3] = { { "0 0 0", "0 0 0", "1 0 0" },
                                               { "0 0 0", "1 0 0", "1 0 0" },
                                               { "0 0 0", "1 0 0", "0 0 0" },
                                               { "0 0 0", "1 0 0", "0 1 0" } };
    char text[2000] = "solid\n";
    for (int i = 0; i < 4; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text),
                 "facet normal 0 0 1\nouter loop\nvertex %s\nvertex %s\nvertex %s\nendloop\n"
                 "endfacet\n",
                 corners[i][0], corners[i][1], corners[i][2]);
    strcat(text, "endsolid\n");
    GpMesh mesh;
    assert_int_equal(gp_mesh_read(put_text("a.stl", text), GP_MESH_TRIANGLES, &mesh, &error),
                     GP_OK);
    assert_int_equal(mesh.triangle_count, 1);
    assert_int_equal(mesh.vertex_count, 3);
    gp_mesh_free(&mesh);
}

static void binary_errors_name_the_byte(void **state)
{
    (void)state;
    MeshBytes bytes;
    mesh_write_ply(&bytes, 1, 0);
    bytes.data[bytes.size - 4] = 99;
    char part[160];
    snprintf(part, sizeof part,
             "byte %zu: face 2: expected a vertex below 5, but it refers to "
             "vertex 99",
             bytes.size - 4);
    assert_refused(put_file("a.ply", bytes.data, bytes.size), GP_ERROR_FORMAT, part);
    bytes.data[bytes.size - 1] = -1; /* negative */
    assert_refused(put_file("a.ply", bytes.data, bytes.size), GP_ERROR_FORMAT, "vertex -16777");

    mesh_write_stl(&bytes, "");
    bytes.data[84 + 50 + 12 + 12 + 3] = 0x7f;
    bytes.data[84 + 50 + 12 + 12 + 2] = (char)0x80;
    assert_refused(put_file("a.stl", bytes.data, bytes.size), GP_ERROR_FORMAT,
                   "byte 158: corner 1 of face 1 is not finite");
    mesh_write_stl(&bytes, "");
    memset(bytes.data + 80, 0xff, 4);
    assert_refused(put_file("a.stl", bytes.data, bytes.size), GP_ERROR_FORMAT,
                   "byte 80: 4294967295 triangles need");

    mesh_write_om1(&bytes);
    bytes.data[bytes.size - 3] = 5;
    snprintf(part, sizeof part, "byte %zu: refers to number 5, but there are 5", bytes.size - 3);
    assert_refused(put_file("a.om", bytes.data, bytes.size), GP_ERROR_FORMAT, part);
}

/* The third chunk holds the half-edges: next, vertex, face in a byte each, 14 of them. Any next one
 * below 14 is in range, but most do not lead around the face. */
static void om_faces_that_do_not_close_are_refused(void **state)
{
    (void)state;
    enum { FIRST = 201, HALFEDGES = 14 };
    unsigned refused = 0;
    for (size_t i = 0; i < HALFEDGES; i++) {
        for (unsigned char next = 0; next < HALFEDGES; next++) {
            unsigned char changed[OM_SIZE];
            GpMesh mesh;
            memcpy(changed, mesh_om_bytes, OM_SIZE);
            changed[FIRST + 3 * i] = next;
            GpResult result = gp_mesh_read(put_file("a.om", changed, OM_SIZE), 0, &mesh, &error);
            if (result == GP_OK)
                gp_mesh_free(&mesh);
            else
                refused += strstr(error.text, "do not close") != NULL;
        }
    }
    assert_true(refused > HALFEDGES);
}

static void points_are_read_only_where_asked_for(void **state)
{
    (void)state;
    GpMesh mesh;
    const char *path = put_text("a.ply", "ply\nformat ascii 1.0\nelement vertex 2\n"
                                         "property float x\nproperty float y\nproperty float z\n"
                                         "property float nx\nproperty float ny\nproperty float nz\n"
                                         "end_header\n1 2 3 0 1 0\n4 5 6 0 0 0\n");
    assert_refused(path, GP_ERROR_FORMAT, "no faces");
    assert_int_equal(gp_mesh_read(path, GP_MESH_ALLOW_POINTS, &mesh, &error), GP_OK);
    static const float normals[6] = { 0, 1, 0, 0, 0, 1 };
    assert_int_equal(mesh.vertex_count, 2);
    assert_int_equal(mesh.triangle_count, 0);
    assert_memory_equal(mesh.normals, normals, sizeof normals);
    gp_mesh_free(&mesh);
}

/* --- damage ----------------------------------------------------------------------------------- */

typedef struct Sample {
    const char *name;
    bool has_counts; /* a shorter file cannot be whole */
    MeshBytes bytes;
} Sample;

static size_t make_samples(Sample samples[16])
{
    static const char *const texts[][2] = {
        { "a.off", "OFF\n5 3 0\n" OFF_VERTICES OFF_FACES },
        { "a.off", "STCNOFF 3 1 0\n0 0 0 0 0 1 255 0 51 0 0\n1 0 0 0 0 1 .5 0 0 1 0 0\n"
                   "0 1 0 0 0 1 1 2 3 4 0 0\n3 0 1 2\n" },
        { "a.obj", OBJ_VERTICES "vt 0 0\nvt 1 0 1\nvn 0 0 1\nf 4/1/1 3/2/1 2//1 1\nf 1 2 -1\n" },
        { "a.stl", mesh_stl_text },
    };
    size_t count = 0;
    for (size_t i = 0; i < GP_COUNT(texts); i++) {
        samples[count] = (Sample){ .name = texts[i][0],
                                   .has_counts = texts[i][0][2] == 'o' && texts[i][0][3] == 'f' };
        mesh_put_string(&samples[count++].bytes, texts[i][1]);
    }
    for (int i = 0; i < 6; i++) {
        samples[count] = (Sample){ .name = "a.ply", .has_counts = true };
        mesh_write_ply(&samples[count++].bytes, i % 3, i < 3 ? 0 : PLY_VARIANTS - 1);
    }
    samples[count] = (Sample){ .name = "a.stl", .has_counts = true };
    mesh_write_stl(&samples[count++].bytes, "solid");
    samples[count] = (Sample){ .name = "a.om", .has_counts = true };
    mesh_write_om1(&samples[count++].bytes);
    samples[count] = (Sample){ .name = "a.om", .has_counts = true };
    memcpy(samples[count].bytes.data, mesh_om_bytes, OM_SIZE);
    samples[count++].bytes.size = OM_SIZE;
    return count;
}

/* Whatever comes out must be a mesh that can be drawn without looking. */
static GpResult read_and_verify(const char *path)
{
    GpMesh mesh;
    GpResult result = gp_mesh_read(path, GP_MESH_ALLOW_POINTS, &mesh, &error);
    if (result != GP_OK) {
        assert_true(result == GP_ERROR_FORMAT || result == GP_ERROR_UNSUPPORTED);
        return result;
    }
    for (size_t i = 0; i < 3 * (size_t)mesh.triangle_count; i++)
        assert_true(mesh.indices[i] < mesh.vertex_count);
    for (size_t i = 0; i < 3 * (size_t)mesh.vertex_count; i++)
        assert_true(isfinite(mesh.positions[i]) && isfinite(mesh.normals[i]));
    gp_mesh_free(&mesh);
    return result;
}

static void check_truncations(void)
{
    static Sample samples[16];
    size_t count = make_samples(samples);
    for (size_t i = 0; i < count; i++) {
        const MeshBytes *bytes = &samples[i].bytes;
        const char *path = put_file(samples[i].name, bytes->data, bytes->size);
        assert_int_equal(read_and_verify(path), GP_OK);
        bool is_binary = memchr(bytes->data, '\0', bytes->size) != NULL;
        for (size_t size = bytes->size; size-- > 0;) {
            assert_int_equal(truncate(path, (off_t)size), 0);
            GpResult result = read_and_verify(path);
            /* The last byte of a text is white space, which may be missing. */
            if (samples[i].has_counts && size + (is_binary ? 0 : 1) < bytes->size)
                assert_int_not_equal(result, GP_OK);
        }
    }
}

static void every_truncation_is_an_error_and_silent(void **state)
{
    (void)state;
    begin_silence();
    check_truncations();
    end_silence();
}

static void check_damage(void)
{
    static Sample samples[16];
    size_t count = make_samples(samples);
    Random random = { .state = 2005 };
    unsigned refused = 0, read = 0;
    for (size_t i = 0; i < count; i++) {
        const MeshBytes *bytes = &samples[i].bytes;
        const char *path = put_file(samples[i].name, bytes->data, bytes->size);
        int file = open(path, O_RDWR);
        assert_true(file >= 0);
        for (int round = 0; round < 2000; round++) {
            /* In text mostly digits, blanks and signs: other bytes are refused too soon. */
            static const char likely[] = "0123456789 \n\t-./#e";
            uint32_t changes = (uint32_t)random_int(&random, 1, 3);
            size_t at[3];
            for (uint32_t c = 0; c < changes; c++) {
                at[c] = random_bits(&random) % bytes->size;
                char byte = (char)random_bits(&random);
                if (random_int(&random, 0, 1))
                    byte = likely[random_bits(&random) % (sizeof likely - 1)];
                assert_int_equal(pwrite(file, &byte, 1, (off_t)at[c]), 1);
            }
            if (read_and_verify(path) == GP_OK)
                read++;
            else
                refused++;
            for (uint32_t c = 0; c < changes; c++)
                assert_int_equal(pwrite(file, bytes->data + at[c], 1, (off_t)at[c]), 1);
        }
        close(file);
    }
    assert_true(read > 1000 && refused > 1000);
}

static void damaged_bytes_give_a_mesh_or_an_error_and_silence(void **state)
{
    (void)state;
    begin_silence();
    check_damage();
    end_silence();
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(unreadable_paths_are_told_apart),
        TEST(errors_name_the_place_and_what_was_expected),
        TEST(headers_of_many_parts_are_refused),
        TEST(facets_without_area_are_skipped),
        TEST(binary_errors_name_the_byte),
        TEST(om_faces_that_do_not_close_are_refused),
        TEST(points_are_read_only_where_asked_for),
        TEST(every_truncation_is_an_error_and_silent),
        TEST(damaged_bytes_give_a_mesh_or_an_error_and_silence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
