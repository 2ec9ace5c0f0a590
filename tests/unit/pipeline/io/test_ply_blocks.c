/* PLY files of more items than are read together: every encoding gives the same, wherever in the
 * file the rows of floats or the triangles end, and a fault is told of the item that has it. */
#include "pipeline/io/mesh/mesh_file.h"
#include "pipeline/io/ply/ply_items.h"
#include "pipeline/io/points/points.h"
#include "tests/support/folder.h"
#include "tests/support/random.h"

#include <math.h>

enum { VERTICES = 2 * PLY_BLOCK + 100, FACES = 700, MOST_BYTES = 1 << 18 };

/* --- a file, value by value ------------------------------------------------------------------- */

typedef struct Writer {
    PlyEncoding encoding;
    char bytes[MOST_BYTES];
    size_t size;
} Writer;

static Writer writer;

static void put_line(const char *line)
{
    writer.size +=
        (size_t)snprintf(writer.bytes + writer.size, MOST_BYTES - writer.size, "%s\n", line);
}

static void put_bits(uint64_t bits, size_t size)
{
    for (size_t i = 0; i < size; i++)
        writer.bytes[writer.size++] =
            (char)(bits >> 8 * (writer.encoding == PLY_BIG ? size - 1 - i : i));
}

static void put_integer(uint32_t value, size_t size)
{
    char text[16];
    snprintf(text, sizeof text, "%u", value);
    if (writer.encoding == PLY_ASCII)
        put_line(text);
    else
        put_bits(value, size);
}

static void put_float(float value, bool as_double)
{
    char text[32];
    union {
        double value;
        uint64_t bits;
    } pun = { .value = (double)value };
    snprintf(text, sizeof text, "%.9g", (double)value);
    if (writer.encoding == PLY_ASCII)
        put_line(text);
    else
        put_bits(as_double ? pun.bits : gp_float_bits(value), as_double ? 8 : 4);
}

/* --- what is in it ---------------------------------------------------------------------------- */

/* How a file stores what all of them have. */
typedef struct Storage {
    PlyEncoding encoding;
    bool doubles;    /* positions are, which are then read value by value */
    bool flags;      /* a property that means nothing, between others */
    uint32_t quad;   /* the face with four corners, which interrupts the triangles */
    uint32_t bad;    /* the vertex, or the radius, that has a fault; FAULTLESS: none */
    uint32_t beyond; /* the face that refers to a vertex that is not there */
} Storage;

enum { FAULTLESS = UINT32_MAX };

static uint32_t number_of(uint32_t vertex, uint32_t component)
{
    return random_word(&(Random){ 16 * vertex + component });
}

static float value_of(uint32_t vertex, uint32_t component)
{
    return (float)(number_of(vertex, component) % 2001) / 1000.0f - 1;
}

static uint8_t color_of(uint32_t vertex, uint32_t channel)
{
    return (uint8_t)number_of(vertex, 6 + channel);
}

static void put_header(const Storage *storage, bool faces)
{
    static const char *const names[] = { "ascii", "binary_little_endian", "binary_big_endian" };
    static const char *const floats[] = { "x", "y", "z", "nx", "ny", "nz" };
    char line[80];
    writer.encoding = storage->encoding;
    writer.size = 0;
    put_line("ply");
    snprintf(line, sizeof line, "format %s 1.0", names[storage->encoding]);
    put_line(line);
    snprintf(line, sizeof line, "element vertex %d", VERTICES);
    put_line(line);
    for (size_t i = 0; i < GP_COUNT(floats); i++) {
        snprintf(line, sizeof line, "property %s %s",
                 storage->doubles && i < 3 ? "double" : "float", floats[i]);
        put_line(line);
        if (i == 3 && storage->flags)
            put_line("property ushort flags");
    }
    put_line(
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float radius");
    snprintf(line, sizeof line, "element face %d\nproperty list uchar int vertex_indices", FACES);
    put_line(faces ? line : "comment no faces");
    put_line("end_header");
}

static const char *put_ply(const Storage *storage, bool faces)
{
    put_header(storage, faces);
    for (uint32_t v = 0; v < VERTICES; v++) {
        for (uint32_t i = 0; i < 6; i++) {
            put_float(v == storage->bad && i == 4 && faces ? INFINITY : value_of(v, i),
                      storage->doubles && i < 3);
            if (i == 3 && storage->flags)
                put_integer(v % 7, 2);
        }
        for (uint32_t i = 0; i < 3; i++)
            put_integer(color_of(v, i), 1);
        put_float(v == storage->bad && !faces ? -1.0f : 1 + value_of(v, 9), false);
    }
    for (uint32_t f = 0; f < FACES && faces; f++) {
        const uint32_t corners = f == storage->quad ? 4 : 3;
        put_integer(corners, 1);
        for (uint32_t k = 0; k < corners; k++)
            put_integer(f == storage->beyond && k == 1 ? VERTICES : (f + 3 * k) % VERTICES, 4);
    }
    assert_true(writer.size < MOST_BYTES);
    return put_file("blocks.ply", writer.bytes, writer.size);
}

/* --- tests ------------------------------------------------------------------------------------ */

static const Storage plain = { PLY_LITTLE, .quad = 300, .bad = FAULTLESS, .beyond = FAULTLESS };

static void check_mesh(const Storage *storage)
{
    GpMesh mesh;
    GpError error = { "" };
    if (gp_mesh_read(put_ply(storage, true), 0, &mesh, &error) != GP_OK)
        fail_msg("%s", error.text);
    assert_int_equal(mesh.vertex_count, VERTICES);
    assert_int_equal(mesh.triangle_count, FACES + (storage->quad < FACES));
    for (uint32_t v = 0; v < VERTICES; v++) {
        for (uint32_t i = 0; i < 3; i++) {
            assert_true(mesh.positions[3 * v + i] == value_of(v, i));
            assert_true(mesh.normals[3 * v + i] == value_of(v, 3 + i));
            assert_true(mesh.colors[4 * v + i] == (float)color_of(v, i) / 255.0f);
        }
        assert_true(mesh.colors[4 * v + 3] == 1);
    }
    uint32_t at = 0;
    for (uint32_t f = 0; f < FACES; f++)
        for (uint32_t k = 2; k < (f == storage->quad ? 4U : 3U); k++, at += 3) {
            assert_int_equal(mesh.indices[at], f);
            assert_int_equal(mesh.indices[at + 1], f + 3 * (k - 1));
            assert_int_equal(mesh.indices[at + 2], f + 3 * k);
        }
    gp_mesh_free(&mesh);
}

static void check_points(const Storage *storage)
{
    GpPoints points;
    GpError error = { "" };
    if (gp_points_read(put_ply(storage, false), &points, &error) != GP_OK)
        fail_msg("%s", error.text);
    assert_int_equal(points.count, VERTICES);
    for (uint32_t v = 0; v < VERTICES; v++) {
        for (uint32_t i = 0; i < 3; i++) {
            assert_true(points.positions[3 * v + i] == value_of(v, i));
            assert_true(points.normals[3 * v + i] == value_of(v, 3 + i));
            assert_int_equal(points.colors[3 * v + i], color_of(v, i));
        }
        assert_true(points.radii[v] == 1 + value_of(v, 9));
    }
    gp_points_free(&points);
}

static void every_encoding_gives_the_same(void **state)
{
    (void)state;
    for (int encoding = PLY_ASCII; encoding <= PLY_BIG; encoding++)
        for (int i = 0; i < 4; i++) {
            Storage storage = plain;
            storage.encoding = (PlyEncoding)encoding;
            storage.doubles = i & 1;
            storage.flags = i >> 1;
            check_mesh(&storage);
            check_points(&storage);
        }
}

static void a_polygon_may_stand_anywhere_among_triangles(void **state)
{
    (void)state;
    static const uint32_t places[] = { 0, 1, 350, FACES - 1, FACES };
    for (size_t i = 0; i < GP_COUNT(places); i++) {
        Storage storage = plain;
        storage.quad = places[i];
        check_mesh(&storage);
    }
}

static void assert_fault(GpResult result, const GpError *error, const char *words)
{
    assert_int_equal(result, GP_ERROR_FORMAT);
    if (!strstr(error->text, words))
        fail_msg("'%s' does not say '%s'", error->text, words);
}

static void a_fault_is_told_of_the_item_that_has_it(void **state)
{
    (void)state;
    static const uint32_t places[] = { 0, PLY_BLOCK - 1, PLY_BLOCK, 2 * PLY_BLOCK + 99 };
    GpMesh mesh;
    GpPoints points;
    for (size_t i = 0; i < GP_COUNT(places); i++) {
        GpError error = { "" };
        char words[80];
        Storage storage = plain;
        storage.bad = places[i];
        snprintf(words, sizeof words, "vertex %u: expected a finite number", places[i]);
        assert_fault(gp_mesh_read(put_ply(&storage, true), 0, &mesh, &error), &error, words);
        snprintf(words, sizeof words, "vertex %u: expected a radius of 0 or more", places[i]);
        assert_fault(gp_points_read(put_ply(&storage, false), &points, &error), &error, words);
        storage = plain;
        storage.beyond = places[i] % FACES;
        snprintf(words, sizeof words, "face %u: expected a vertex below %d", storage.beyond,
                 VERTICES);
        assert_fault(gp_mesh_read(put_ply(&storage, true), 0, &mesh, &error), &error, words);
    }
}

static void a_file_that_ends_within_a_block_is_refused(void **state)
{
    (void)state;
    GpMesh mesh;
    GpError error = { "" };
    put_ply(&plain, true);
    const size_t faces = FACES * 13 + 4, vertex = 6 * 4 + 3 + 4;
    const char *path = put_file("cut.ply", writer.bytes, writer.size - faces - 50 * vertex - 1);
    assert_fault(gp_mesh_read(path, 0, &mesh, &error), &error,
                 "vertex 1073: expected more bytes, but the file ends");
    path = put_file("cut.ply", writer.bytes, writer.size - 13 * 10 - 1);
    assert_fault(gp_mesh_read(path, 0, &mesh, &error), &error, "face 689: expected");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_encoding_gives_the_same),
        cmocka_unit_test(a_polygon_may_stand_anywhere_among_triangles),
        cmocka_unit_test(a_fault_is_told_of_the_item_that_has_it),
        cmocka_unit_test(a_file_that_ends_within_a_block_is_refused),
    };
    return cmocka_run_group_tests_name("ply_blocks", tests, folder_set_up, folder_tear_down);
}
