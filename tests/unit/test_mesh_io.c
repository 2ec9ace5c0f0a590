/* Meshes from files: every format tells the same pyramid, no face is lost, normals are the weighted
 * sum, and no damaged file gets past the checks with anything but an error that says where. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "pipeline/io/file.h"
#include "pipeline/io/mesh.h"

#include <dirent.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[64];
static GpError error;

static const char *in_folder(const char *name)
{
    static char paths[4][400];
    static unsigned turn;
    char *path = paths[turn++ % 4];
    snprintf(path, sizeof paths[0], "%s/%s", folder, name);
    return path;
}

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

static int set_up(void **state)
{
    (void)state;
    strcpy(folder, "/tmp/glasspipe-mesh-XXXXXX");
    return mkdtemp(folder) ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    restore_output(); /* a check failed before it could */
    DIR *list = opendir(folder);
    assert_non_null(list);
    for (struct dirent *entry; (entry = readdir(list));) {
        if (entry->d_name[0] != '.')
            assert_int_equal(remove(in_folder(entry->d_name)), 0);
    }
    closedir(list);
    return rmdir(folder);
}

static const char *put_file(const char *name, const void *bytes, size_t size)
{
    const char *path = in_folder(name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
    return path;
}

static const char *put_text(const char *name, const char *text)
{
    return put_file(name, text, strlen(text));
}

static void assert_reads(const char *path, GpMesh *mesh)
{
    if (gp_mesh_read(path, GP_MESH_TRIANGLES, mesh, &error) != GP_OK)
        fail_msg("%s", error.text);
}

static uint32_t next_random(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(*seed >> 33);
}

/* --- the pyramid ------------------------------------------------------------------------------- */

/* A square and two of the four sides: five vertices, a quad and two triangles. */
static const float pyramid_positions[15] = {
    0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5f, 0.5f, -1.5f
};
static const uint32_t pyramid_indices[12] = { 3, 2, 1, 3, 1, 0, 0, 1, 4, 1, 2, 4 };

static void assert_pyramid(const char *path, GpMesh *mesh)
{
    assert_reads(path, mesh);
    if (mesh->vertex_count != 5 || mesh->triangle_count != 4 || mesh->skipped_count != 0)
        fail_msg("%s: %u vertices, %u triangles, %u skipped", path, mesh->vertex_count,
                 mesh->triangle_count, mesh->skipped_count);
    for (size_t i = 0; i < GP_COUNT(pyramid_positions); i++) {
        if (mesh->positions[i] != pyramid_positions[i])
            fail_msg("%s: coordinate %zu is %g", path, i, (double)mesh->positions[i]);
    }
    assert_memory_equal(mesh->indices, pyramid_indices, sizeof pyramid_indices);
}

static void assert_plain_pyramid(const char *path)
{
    GpMesh mesh;
    assert_pyramid(path, &mesh);
    assert_false(mesh.had_normals || mesh.had_colors || mesh.had_texcoords);
    assert_null(mesh.colors);
    assert_null(mesh.texcoords);
    gp_mesh_free(&mesh);
    assert_null(mesh.positions);
}

#define OFF_VERTICES "0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 +0.5e0 -15E-1\n"
#define OFF_FACES    "4 3 2 1 0\n3 0 1 4\n3 1 2 4\n"

static void off_in_its_dialects_gives_the_pyramid(void **state)
{
    (void)state;
    static const char *const files[] = {
        "OFF\n5 3 0\n" OFF_VERTICES OFF_FACES,
        "OFF 5 3 0\n" OFF_VERTICES OFF_FACES,
        "OFF\r\n5 3 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n.5 .5 -1.5\r\n4 3 2 1 0\r\n3 0 1 4\r\n"
        "3 1 2 4\r\n",
        "OFF # a comment\n# 9 9 9\n5 3 0 # counts\n\n0 0 0 # 7\n1 0 0\n\n1 1 0\n0 1 0\n.5 .5 -1.5\n"
        "#4 0 0 0 0\n4 3 2 1 0 #\n3 0 1 4\n3 1 2 4 # end",
        "OFF\n5 3 0\n0 0 0 9 9 9\n1 0 0\n1 1 0\n0 1 0 5\n.5 .5 -1.5\n"
        "4 3 2 1 0 0.1 0.2 0.3\n3 0 1 4 255 0 0\n  3\t1  2   4  1\n",
    };
    for (size_t i = 0; i < GP_COUNT(files); i++)
        assert_plain_pyramid(put_text("a.off", files[i]));
}

static void off_prefixes_add_attributes(void **state)
{
    (void)state;
    GpMesh mesh;
    assert_pyramid(put_text("a.off", "STCNOFF\n5 3 0\n"
                                     "0 0 0  0 0 1  255 0 51  0 0.25\n"
                                     "1 0 0\t0 0 2  255 0 51  0 0.25\n"
                                     "1 1 0  0 0 1  255 0 51 0  0 0.25\n"
                                     "0 1 0  0 1 0  0.5 0 1.0 0 0.25\n"
                                     ".5 .5 -1.5  0 0 0  .5 0 1 .75  0.5 0.75\n" OFF_FACES),
                   &mesh);
    assert_true(mesh.had_normals && mesh.had_colors && mesh.had_texcoords);
    static const float colors[20] = { 1,    0, 0.2f, 1, 1, 0, 0.2f, 1, 1, 0,
                                      0.2f, 0, 0.5f, 0, 1, 1, 0.5f, 0, 1, 0.75f };
    for (int i = 0; i < 20; i++)
        assert_true(mesh.colors[i] == colors[i]);
    assert_true(mesh.normals[5] == 2 && mesh.normals[10] == 1);
    assert_true(mesh.texcoords[1] == 0.25f && mesh.texcoords[8] == 0.5f);
    gp_mesh_free(&mesh);
}

#define OBJ_VERTICES "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 -1.5\n"

static void obj_in_its_dialects_gives_the_pyramid(void **state)
{
    (void)state;
    static const char *const files[] = {
        OBJ_VERTICES "f 4 3 2 1\nf 1 2 5\nf 2 3 5\n",
        OBJ_VERTICES "f -2 -3 -4 -5\nf -5 -4 -1\nf 2 3 -1",
        "# comment\r\no thing\r\nmtllib /dev/zero\r\ng part\r\n" OBJ_VERTICES
        "usemtl gold\r\ns 1\r\nf 4 3 2 1\r\n  f  1\t2 5  \r\nf 2 3 5\r\n",
        "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nv 0 0 0 1.0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 -1.5\n",
    };
    for (size_t i = 0; i < GP_COUNT(files); i++)
        assert_plain_pyramid(put_text("a.obj", files[i]));
}

/* Sixteen ways to write a PLY file; each bit is one thing that OpenMesh alone misreads or does not
 * know. */
enum {
    PLY_DOUBLES = 1,     /* coordinates of type double */
    PLY_LISTS = 2,       /* lists beside the corners, before and after them */
    PLY_SHORT_INDEX = 4, /* ushort corners, counted by int */
    PLY_ODD_HEADER = 8,  /* comments before the end, obj_info, an element in between */
    PLY_VARIANTS = 16
};

typedef struct Writer {
    char bytes[4096];
    size_t size;
    int encoding; /* 0 text, 1 little, 2 big */
} Writer;

static void put_string(Writer *writer, const char *text)
{
    memcpy(writer->bytes + writer->size, text, strlen(text));
    writer->size += strlen(text);
}

static void put_bits(Writer *writer, uint64_t bits, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        size_t shift = 8 * (writer->encoding == 1 ? i : size - 1 - i);
        writer->bytes[writer->size++] = (char)(bits >> shift & 255);
    }
}

static void put_integer(Writer *writer, uint32_t value, size_t size)
{
    char text[16];
    snprintf(text, sizeof text, "%u ", value);
    if (writer->encoding == 0)
        put_string(writer, text);
    else
        put_bits(writer, value, size);
}

static void put_number(Writer *writer, float value, bool is_double)
{
    char text[32];
    double wide = (double)value;
    uint64_t bits;
    memcpy(&bits, &wide, sizeof bits);
    snprintf(text, sizeof text, "%.9g ", wide);
    if (writer->encoding == 0)
        put_string(writer, text);
    else
        put_bits(writer, is_double ? bits : gp_float_bits(value), is_double ? 8 : 4);
}

static void write_ply(Writer *writer, int encoding, int variant)
{
    static const char *const names[] = { "ascii", "binary_little_endian", "binary_big_endian" };
    bool has_doubles = variant & PLY_DOUBLES, has_lists = variant & PLY_LISTS;
    bool is_short = variant & PLY_SHORT_INDEX, is_odd = variant & PLY_ODD_HEADER;
    const char *type = has_doubles ? "double" : "float32";
    char header[1024];
    snprintf(header, sizeof header,
             "ply\nformat %s 1.0\ncomment element vertex 9\n%selement vertex 5\n%s"
             "property %s x\nproperty %s y\nproperty %s z\n%selement face 3\n%s"
             "property list %s %s vertex_indices\n%s%send_header\n",
             names[encoding], is_odd ? "obj_info element vertex 7\n" : "",
             has_lists ? "property list uchar float weights\n" : "", type, type, type,
             is_odd ? "element material 2\nproperty list uchar uchar name\n" : "",
             has_lists ? "property list uchar short before\n" : "", is_short ? "int" : "uchar",
             is_short ? "ushort" : "int", has_lists ? "property uchar after\n" : "",
             is_odd ? "comment last\n" : "");
    *writer = (Writer){ .encoding = encoding };
    put_string(writer, header);
    for (int v = 0; v < 5; v++) {
        if (has_lists) {
            put_integer(writer, 2, 1);
            put_number(writer, 7, false);
            put_number(writer, 8, false);
        }
        for (int i = 0; i < 3; i++)
            put_number(writer, pyramid_positions[3 * v + i], has_doubles);
        put_string(writer, encoding == 0 ? "\n" : "");
    }
    for (uint32_t m = 0; m < 2 && is_odd; m++) {
        put_integer(writer, m + 1, 1);
        for (uint32_t i = 0; i <= m; i++)
            put_integer(writer, 'a', 1);
    }
    static const uint32_t faces[3][5] = { { 4, 3, 2, 1, 0 }, { 3, 0, 1, 4, 0 }, { 3, 1, 2, 4, 0 } };
    for (int f = 0; f < 3; f++) {
        if (has_lists) {
            put_integer(writer, 1, 1);
            put_integer(writer, 300, 2);
        }
        put_integer(writer, faces[f][0], is_short ? 4 : 1);
        for (uint32_t i = 0; i < faces[f][0]; i++)
            put_integer(writer, faces[f][1 + i], is_short ? 2 : 4);
        if (has_lists)
            put_integer(writer, 9, 1);
    }
}

static void ply_in_all_encodings_and_dialects_gives_the_pyramid(void **state)
{
    (void)state;
    for (int encoding = 0; encoding < 3; encoding++) {
        for (int variant = 0; variant < PLY_VARIANTS; variant++) {
            Writer writer;
            write_ply(&writer, encoding, variant);
            assert_plain_pyramid(put_file("a.ply", writer.bytes, writer.size));
        }
    }
}

static void ply_header_white_space_does_not_shift_the_body(void **state)
{
    (void)state;
    static const char body[] = "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\0\0"
                               "\0\0\0\0\0\0\0\x40\0\0\0\0\x3\0\0\0\0\x1\0\0\0\x2\0\0\0";
    static const char *const headers[] = {
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_index\nend_header\n",
        "ply\r\nformat binary_little_endian 1.0\r\nelement vertex 3\r\nproperty float x\r\n"
        "property float y\r\nproperty float z\r\nelement face 1\r\n"
        "property list uchar int vertex_index\r\nend_header\r\n",
        "ply \nformat  binary_little_endian 1.0\n\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nelement face 1 \n"
        "property list uchar int vertex_index \n\nend_header\n",
        "ply\nformat binary_little_endian 1.0\ncomment\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_index\ncomment  \nend_header\n",
    };
    for (size_t i = 0; i < GP_COUNT(headers); i++) {
        char bytes[512];
        size_t size = strlen(headers[i]);
        memcpy(bytes, headers[i], size);
        memcpy(bytes + size, body, sizeof body - 1);
        GpMesh mesh;
        assert_reads(put_file("a.ply", bytes, size + sizeof body - 1), &mesh);
        assert_true(mesh.positions[3] == 1 && mesh.positions[7] == 2);
        assert_int_equal(mesh.indices[2], 2);
        gp_mesh_free(&mesh);
    }
}

static void ply_attributes_are_read_in_any_order_and_type(void **state)
{
    (void)state;
    static const char *const files[] = {
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
        "property float s\nproperty float t\nproperty uchar red\nproperty uchar green\n"
        "property uchar blue\nproperty uchar alpha\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0 0 0 3 .25 .75 255 0 51 102\n1 0 0 0 0 3 .25 .75 255 0 51 102\n"
        "0 1 0 0 0 3 .25 .75 255 0 51 102\n3 0 1 2\n",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float red\nproperty float alpha\n"
        "property double nz\nproperty double nx\nproperty double ny\nproperty double texture_v\n"
        "property float texture_u\nproperty float green\nproperty float blue\nproperty int x\n"
        "property char y\nproperty short z\nproperty float quality\nelement face 1\n"
        "property uchar red\nproperty list int uint vertex_index\nend_header\n"
        "1 .4 3 0 0 .75 .25 0 .2 0 0 0 nan\n1 .4 3 0 0 .75 .25 0 .2 1 0 0 1\n"
        "1.5 .4 3 0 0 .75 .25 -1 .2 0 1 0 2\n7 3 0 1 2\n",
    };
    for (size_t i = 0; i < GP_COUNT(files); i++) {
        GpMesh mesh;
        assert_reads(put_text("a.ply", files[i]), &mesh);
        assert_true(mesh.had_normals && mesh.had_colors && mesh.had_texcoords);
        static const float color[4] = { 1, 0, 0.2f, 0.4f };
        for (int v = 0; v < 3; v++) {
            assert_memory_equal(mesh.colors + 4 * v, color, sizeof color);
            assert_true(mesh.normals[3 * v + 2] == 3 && mesh.normals[3 * v] == 0);
            assert_true(mesh.texcoords[2 * v] == 0.25f && mesh.texcoords[2 * v + 1] == 0.75f);
        }
        assert_true(mesh.positions[3] == 1 && mesh.positions[7] == 1);
        gp_mesh_free(&mesh);
    }
}

static const char stl_text[] =
    "solid outer facet\n"
    "  facet normal nan nan nan\n    OUTER LOOP\n      vertex 0 0 0\n      vertex 1 0 0\n"
    "      vertex 0 1 0\n    endloop\n  endfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 0 0\nvertex 0 5 0\nendloop\nendfacet\n"
    "facet normal 0 0 1\nOuter Loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "endsolid outer\n";

/* The same four facets in binary. */
static size_t write_stl(Writer *writer, const char *header)
{
    static const float corners[4][9] = { { 0, 0, 0, 1, 0, 0, 0, 1, 0 },
                                         { 1, 0, 0, 1, 1, 0, 0, 1, 0 },
                                         { 1, 0, 0, 1, 0, 0, 0, 5, 0 },
                                         { 0, 0, 0, 1, 0, 0, 0, 1, 0 } };
    *writer = (Writer){ .encoding = 1 };
    put_string(writer, header);
    writer->size = 80;
    put_bits(writer, 4, 4);
    for (int f = 0; f < 4; f++) {
        for (int i = 0; i < 3; i++)
            put_bits(writer, 0x7fc00000u, 4); /* a normal of nan */
        for (int i = 0; i < 9; i++)
            put_number(writer, corners[f][i], false);
        put_bits(writer, 0xffff, 2);
    }
    return writer->size;
}

static void stl_corners_are_welded_and_flat_faces_skipped(void **state)
{
    (void)state;
    static const uint32_t indices[9] = { 0, 1, 2, 1, 3, 2, 0, 1, 2 };
    for (int i = 0; i < 3; i++) {
        Writer writer;
        GpMesh mesh;
        write_stl(&writer, i == 1 ? "made by hand" : "solid but binary");
        assert_reads(i == 0 ? put_text("a.stl", stl_text)
                            : put_file("a.STL", writer.bytes, writer.size),
                     &mesh);
        assert_int_equal(mesh.vertex_count, 5); /* 0 5 0 is only in the skipped face */
        assert_int_equal(mesh.triangle_count, 3);
        assert_int_equal(mesh.skipped_count, 1);
        assert_memory_equal(mesh.indices, indices, sizeof indices);
        assert_false(mesh.had_normals);
        assert_true(mesh.normals[2] == 1);
        gp_mesh_free(&mesh);
    }
}

/* Written by OpenMesh 9: half-edges, normals, colours 1 2 3, texture coordinates i/4, 1/2. */
static const unsigned char om_bytes[] = {
    0x4f, 0x4d, 0x50, 0x42, 0x05, 0x00, 0x00, 0x00, 0x03, 0x00, 0x00, 0x00, 0x07, 0x00, 0x00, 0x00,
    0x00, 0x16, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x80, 0x3f, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x3f, 0x00, 0x00,
    0x80, 0x3f, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x3f, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x3f, 0x00, 0x00, 0x00, 0x3f, 0x00, 0x00, 0xc0, 0xbf, 0x20, 0x16,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x3f, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x3f, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x80, 0x3f, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x3f,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x3f, 0x80, 0x10, 0x01, 0x02,
    0x03, 0x01, 0x02, 0x03, 0x01, 0x02, 0x03, 0x01, 0x02, 0x03, 0x01, 0x02, 0x03, 0x40, 0x0e, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x3f, 0x00, 0x00, 0x80, 0x3e, 0x00, 0x00, 0x00, 0x3f, 0x00,
    0x00, 0x00, 0x3f, 0x00, 0x00, 0x00, 0x3f, 0x00, 0x00, 0x40, 0x3f, 0x00, 0x00, 0x00, 0x3f, 0x00,
    0x00, 0x80, 0x3f, 0x00, 0x00, 0x00, 0x3f, 0xf8, 0x16, 0x02, 0x02, 0x00, 0x07, 0x03, 0xff, 0x04,
    0x01, 0x00, 0x0c, 0x02, 0x02, 0x06, 0x00, 0x00, 0x08, 0x01, 0x01, 0x00, 0x03, 0x00, 0x0b, 0x00,
    0xff, 0x0a, 0x04, 0x01, 0x03, 0x01, 0x02, 0x05, 0x00, 0x01, 0x0d, 0x04, 0xff, 0x09, 0x04, 0x02,
    0x01, 0x02, 0xff, 0xe0, 0x06, 0x0b, 0x03, 0x01, 0x07, 0x0d, 0xe8, 0x06, 0x06, 0x0a, 0x09, 0x1c,
    0x00,
};

/* Version 1 stored faces as polygons. */
static size_t write_om1(Writer *writer)
{
    *writer = (Writer){ .encoding = 1 };
    put_string(writer, "OMP\x22");
    put_bits(writer, 5, 4);
    put_bits(writer, 3, 4);
    put_bits(writer, 7, 4);
    put_bits(writer, 2 << 11 | 1 << 10, 2); /* vertex positions */
    for (int i = 0; i < 15; i++)
        put_number(writer, pyramid_positions[i], false);
    put_bits(writer, 7 << 5 | 2 << 2, 2); /* face topology in bytes */
    static const uint32_t faces[3][5] = { { 4, 3, 2, 1, 0 }, { 3, 0, 1, 4, 0 }, { 3, 1, 2, 4, 0 } };
    for (int f = 0; f < 3; f++) {
        put_bits(writer, faces[f][0], 2);
        for (uint32_t i = 0; i < faces[f][0]; i++)
            put_bits(writer, faces[f][1 + i], 1);
    }
    put_bits(writer, 7 << 2, 2); /* the end */
    return writer->size;
}

static void om_of_both_generations_gives_the_pyramid(void **state)
{
    (void)state;
    Writer writer;
    write_om1(&writer);
    assert_plain_pyramid(put_file("a.om", writer.bytes, writer.size));

    GpMesh mesh;
    assert_pyramid(put_file("b.om", om_bytes, sizeof om_bytes), &mesh);
    assert_true(mesh.had_normals && mesh.had_colors && mesh.had_texcoords);
    for (int v = 0; v < 5; v++) {
        assert_true(mesh.texcoords[2 * v] == 0.25f * (float)v);
        assert_true(mesh.colors[4 * v + 2] == 3 / 255.0f && mesh.colors[4 * v + 3] == 1);
        assert_true(mesh.normals[3 * v + 2] == 1);
    }
    gp_mesh_free(&mesh);
}

/* --- what a reader could lose ------------------------------------------------------------------- */

static void non_manifold_duplicate_and_flat_faces_are_kept(void **state)
{
    (void)state;
    /* Four faces on one edge, one of them twice, one turned over, one flat; vertex 6 unused. */
    GpMesh mesh;
    assert_reads(put_text("a.off",
                          "OFF\n7 7 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n9 9 9\n"
                          "3 0 1 2\n3 0 1 3\n3 0 1 4\n3 0 1 5\n3 0 1 2\n3 2 1 0\n3 1 1 0\n"),
                 &mesh);
    static const uint32_t indices[21] = { 0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1,
                                          5, 0, 1, 2, 2, 1, 0, 1, 1, 0 };
    assert_int_equal(mesh.vertex_count, 7);
    assert_int_equal(mesh.triangle_count, 7);
    assert_int_equal(mesh.skipped_count, 0);
    assert_memory_equal(mesh.indices, indices, sizeof indices);
    gp_mesh_free(&mesh);
}

static void obj_corners_with_other_attributes_become_copies(void **state)
{
    (void)state;
    GpMesh mesh;
    assert_reads(put_text("a.obj", OBJ_VERTICES
                          "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n"
                          "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/1/1 4/2/1\nf 1/1/2 2/2/1 5//2\n"
                          "f 3/1/1 3/3/1 1/1/2\nf 1 2 2\n"),
                 &mesh);
    /* Third face: 1 with another normal (6). Second face: 3 with another texcoord (5). */
    static const uint32_t indices[9] = { 0, 1, 2, 0, 5, 3, 6, 1, 4 };
    assert_int_equal(mesh.vertex_count, 7);
    assert_memory_equal(mesh.indices, indices, sizeof indices);
    assert_memory_equal(mesh.positions + 15, mesh.positions + 6, 12);
    assert_memory_equal(mesh.positions + 18, mesh.positions, 12);
    assert_true(mesh.texcoords[4] == 1 && mesh.texcoords[5] == 1); /* 3/3 */
    assert_true(mesh.texcoords[10] == 0 && mesh.texcoords[11] == 0);
    assert_true(mesh.normals[2] == 1 && mesh.normals[19] == 1);
    /* Both later faces have fewer than three different vertices: OpenMesh drops them. */
    assert_int_equal(mesh.triangle_count, 3);
    assert_int_equal(mesh.skipped_count, 2);
    gp_mesh_free(&mesh);
}

static void obj_colours_follow_their_vertices(void **state)
{
    (void)state;
    GpMesh mesh;
    assert_reads(put_text("a.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 .5 0\nv 0 1 0 0 0 .25\nf 1 2 3\n"),
                 &mesh);
    static const float colors[12] = { 1, 0, 0, 1, 0, 0.5f, 0, 1, 0, 0, 0.25f, 1 };
    assert_true(mesh.had_colors);
    assert_memory_equal(mesh.colors, colors, sizeof colors);
    gp_mesh_free(&mesh);
}

/* --- normals ------------------------------------------------------------------------------------- */

static void normals_are_the_area_weighted_sum(void **state)
{
    (void)state;
    GpMesh mesh;
    uint64_t seed = 7;
    Writer writer = { .encoding = 0 };
    put_string(&writer, "OFF\n20 40 0\n");
    for (int i = 0; i < 60; i++)
        put_number(&writer, (float)next_random(&seed) / 1e9f, false),
            put_string(&writer, i % 3 == 2 ? "\n" : " ");
    for (int f = 0; f < 40; f++) {
        put_integer(&writer, 3, 1);
        for (int i = 0; i < 3; i++)
            put_integer(&writer, next_random(&seed) % 19, 1);
        put_string(&writer, "\n");
    }
    assert_reads(put_file("a.off", writer.bytes, writer.size), &mesh);
    for (uint32_t v = 0; v < 20; v++) {
        long double sum[3] = { 0, 0, 0 };
        for (uint32_t c = 0; c < 3 * mesh.triangle_count; c++) {
            if (mesh.indices[c] != v)
                continue;
            const uint32_t *t = mesh.indices + c - c % 3;
            long double e[2][3];
            for (int k = 0; k < 6; k++)
                e[k / 3][k % 3] = (long double)mesh.positions[3 * t[1 + k / 3] + (uint32_t)k % 3] -
                                  (long double)mesh.positions[3 * t[0] + (uint32_t)k % 3];
            for (int k = 0; k < 3; k++)
                sum[k] +=
                    e[0][(k + 1) % 3] * e[1][(k + 2) % 3] - e[0][(k + 2) % 3] * e[1][(k + 1) % 3];
        }
        long double length = sqrtl(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
        for (int k = 0; k < 3; k++) {
            long double expected = length > 0 ? sum[k] / length : k == 2;
            assert_true(fabsl((long double)mesh.normals[3 * v + (uint32_t)k] - expected) < 1e-7L);
        }
    }
    assert_true(mesh.normals[59] == 1); /* vertex 19 has no face */
    gp_mesh_free(&mesh);
}

static void tiny_and_huge_triangles_have_normals(void **state)
{
    (void)state;
    static const char *const scales[] = { "e-44", "e-20", "e0", "e37" };
    for (size_t i = 0; i < GP_COUNT(scales); i++) {
        char text[256];
        GpMesh mesh;
        snprintf(text, sizeof text, "OFF\n3 1 0\n0 0 0\n0 3%s 0\n0 0 3%s\n3 0 1 2\n", scales[i],
                 scales[i]);
        assert_reads(put_text("a.off", text), &mesh);
        for (int v = 0; v < 3; v++)
            assert_true(mesh.normals[3 * v] == 1 && mesh.normals[3 * v + 2] == 0);
        gp_mesh_free(&mesh);
    }
}

static void stored_normals_stay_and_zero_ones_are_computed(void **state)
{
    (void)state;
    GpMesh mesh;
    assert_reads(put_text("a.off", "NOFF\n4 1 0\n0 0 0 .1 .2 .3\n1 0 0 0 0 0\n0 1 0 0 -7 0\n"
                                   "5 5 5 0 0 0\n3 0 1 2\n"),
                 &mesh);
    static const float expected[12] = { 0.1f, 0.2f, 0.3f, 0, 0, 1, 0, -7, 0, 0, 0, 1 };
    assert_true(mesh.had_normals);
    assert_memory_equal(mesh.normals, expected, sizeof expected);
    gp_mesh_free(&mesh);
}

/* --- errors -------------------------------------------------------------------------------------- */

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

static void errors_name_the_place_and_what_was_expected(void **state)
{
    (void)state;
    static const struct {
        const char *name, *text, *part;
        GpResult result;
    } cases[] = {
        { "a.off", "ply\n", "line 1: expected OFF, found 'ply'", GP_ERROR_FORMAT },
        { "a.off", " OFF\n0 0 0\n", "line 1: expected OFF", GP_ERROR_FORMAT },
        { "a.off", "4OFF\n0 0 0\n", "three dimensions", GP_ERROR_UNSUPPORTED },
        { "a.off", "OFF BINARY\n0 0 0\n", "binary OFF", GP_ERROR_UNSUPPORTED },
        { "a.off", "OFF\n3 x 0\n", "line 2: expected the counts", GP_ERROR_FORMAT },
        { "a.off", "OFF\n-3 1 0\n", "line 2: expected the counts", GP_ERROR_FORMAT },
        { "a.off", "OFF\n0 0 0\n", "no vertices", GP_ERROR_FORMAT },
        { "a.off", "OFF\n1 0 0\n0 0 0\n", "no faces", GP_ERROR_FORMAT },
        { "a.off", "OFF\n2147483647 1 0\n0 0 0\n", "2147483647 vertices", GP_ERROR_FORMAT },
        { "a.off", "OFF\n1 2147483647 0\n0 0 0\n", "2147483647 faces", GP_ERROR_FORMAT },
        { "a.off", "OFF\n2147483648 1 0\n0 0 0\n", "line 2", GP_ERROR_FORMAT },
        { "a.off", "OFF\n2 1 0\n0 0 0\n\n0 nan 0\n3 0 0 0\n", "line 5: vertex 1", GP_ERROR_FORMAT },
        { "a.off", "OFF\n1 1 0\n0 1e39 0\n3 0 0 0\n", "found '1e39'", GP_ERROR_FORMAT },
        { "a.off", "OFF\n1 1 0\n0 0x1 0\n3 0 0 0\n", "found '0x1'", GP_ERROR_FORMAT },
        { "a.off", "OFF\n2 1 0\n0 0\n0 0 0\n3 0 0 0\n", "line 3: vertex 0 has 2", GP_ERROR_FORMAT },
        { "a.off", "OFF\n1 1 0\n0 0 0\n3 0 1 0\n",
          "line 4: face 0 refers to vertex 1, but there "
          "are 1",
          GP_ERROR_FORMAT },
        { "a.off", "OFF\n1 1 0\n0 0 0\n3 0 -1 0\n", "vertex -1", GP_ERROR_FORMAT },
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
        { "a.obj", "v 0 0 0\nvt 1\n", "line 2: a texture coordinate", GP_ERROR_FORMAT },
        { "a.obj", "v 0 0 0\n", "no faces", GP_ERROR_FORMAT },
        { "a.obj", "v 0 0 0\nf 1 1 1\n", "no faces with an area", GP_ERROR_FORMAT },
        { "a.obj", "hello\n", "no vertices", GP_ERROR_FORMAT },

        { "a.ply", "plx\n", "line 1: expected 'ply'", GP_ERROR_FORMAT },
        { "a.ply", "ply\nformat ascii 2.0\n", "line 2: expected 'format'", GP_ERROR_FORMAT },
        { "a.ply", "ply\nformat utf8 1.0\n", "line 2: expected ascii", GP_ERROR_FORMAT },
        { "a.ply", "ply\nformat ascii 1.0\nelement vertex 1\n", "end_header", GP_ERROR_FORMAT },
        { "a.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n", "line 3: expected an",
          GP_ERROR_FORMAT },
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
          "line 11: face 0: expected a vertex below 1, but it refers to vertex 1",
          GP_ERROR_FORMAT },
        { "a.ply", PLY_HEADER("1", "1") "0 0 0\n3 0 0 1.0\n", "found '1.0'", GP_ERROR_FORMAT },
        { "a.ply", PLY_HEADER("1", "1") "0 0 0\n3 0 0\n", "the file ends", GP_ERROR_FORMAT },
        { "a.ply", PLY_HEADER("1", "1") "0 0 0\n3 0 0 0 0\n", "expected the end of the file",
          GP_ERROR_FORMAT },

        { "a.stl", "facet\n", "expected 'solid'", GP_ERROR_FORMAT },
        { "a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0\n",
          "line 5: face 0: expected 'vertex * * *'", GP_ERROR_FORMAT },
        { "a.stl", "solid\nfacet normal 0 0 1\nouter loop\n\nvertex 0 0 0\n", "line 5",
          GP_ERROR_FORMAT },
        { "a.stl", "solid\nendsolid\n", "no vertices", GP_ERROR_FORMAT },
        { "a.stl", "solid x\n", "ends inside a solid", GP_ERROR_FORMAT },

        { "a.om", "OFF", "byte 0: expected OM", GP_ERROR_FORMAT },
        { "a.om", "OMX\x22zzzzzzzzzzzz", "byte 2: expected T, Q or P", GP_ERROR_FORMAT },
        { "a.om", "OMT\x7fzzzzzzzzzzzz", "byte 3: version", GP_ERROR_UNSUPPORTED },
        { "a.om", "OMT\x22zzzzzzzzzzzz", "are promised", GP_ERROR_FORMAT },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++)
        assert_refused(put_text(cases[i].name, cases[i].text), cases[i].result, cases[i].part);
}

static void binary_errors_name_the_byte(void **state)
{
    (void)state;
    Writer writer;
    write_ply(&writer, 1, 0);
    writer.bytes[writer.size - 4] = 99;
    char part[160];
    snprintf(part, sizeof part,
             "byte %zu: face 2: expected a vertex below 5, but it refers to "
             "vertex 99",
             writer.size - 4);
    assert_refused(put_file("a.ply", writer.bytes, writer.size), GP_ERROR_FORMAT, part);
    writer.bytes[writer.size - 1] = -1; /* negative */
    assert_refused(put_file("a.ply", writer.bytes, writer.size), GP_ERROR_FORMAT, "vertex -16777");

    write_stl(&writer, "");
    writer.bytes[84 + 50 + 12 + 12 + 3] = 0x7f;
    writer.bytes[84 + 50 + 12 + 12 + 2] = (char)0x80;
    assert_refused(put_file("a.stl", writer.bytes, writer.size), GP_ERROR_FORMAT,
                   "byte 158: corner 1 of face 1 is not finite");
    write_stl(&writer, "");
    memset(writer.bytes + 80, 0xff, 4);
    assert_refused(put_file("a.stl", writer.bytes, writer.size), GP_ERROR_FORMAT,
                   "byte 80: 4294967295 triangles need");

    write_om1(&writer);
    writer.bytes[writer.size - 3] = 5;
    snprintf(part, sizeof part, "byte %zu: refers to number 5, but there are 5", writer.size - 3);
    assert_refused(put_file("a.om", writer.bytes, writer.size), GP_ERROR_FORMAT, part);
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
            unsigned char bytes[sizeof om_bytes];
            GpMesh mesh;
            memcpy(bytes, om_bytes, sizeof bytes);
            bytes[FIRST + 3 * i] = next;
            GpResult result = gp_mesh_read(put_file("a.om", bytes, sizeof bytes), 0, &mesh, &error);
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

/* --- damage --------------------------------------------------------------------------------------- */

typedef struct Sample {
    const char *name;
    bool has_counts; /* a shorter file cannot be whole */
    Writer writer;
} Sample;

static size_t make_samples(Sample samples[16])
{
    static const char *const texts[][2] = {
        { "a.off", "OFF\n5 3 0\n" OFF_VERTICES OFF_FACES },
        { "a.off", "STCNOFF 3 1 0\n0 0 0 0 0 1 255 0 51 0 0\n1 0 0 0 0 1 .5 0 0 1 0 0\n"
                   "0 1 0 0 0 1 1 2 3 4 0 0\n3 0 1 2\n" },
        { "a.obj", OBJ_VERTICES "vt 0 0\nvt 1 0 1\nvn 0 0 1\nf 4/1/1 3/2/1 2//1 1\nf 1 2 -1\n" },
        { "a.stl", stl_text },
    };
    size_t count = 0;
    for (size_t i = 0; i < GP_COUNT(texts); i++) {
        samples[count] = (Sample){ .name = texts[i][0],
                                   .has_counts = texts[i][0][2] == 'o' && texts[i][0][3] == 'f' };
        put_string(&samples[count++].writer, texts[i][1]);
    }
    for (int i = 0; i < 6; i++) {
        samples[count] = (Sample){ .name = "a.ply", .has_counts = true };
        write_ply(&samples[count++].writer, i % 3, i < 3 ? 0 : PLY_VARIANTS - 1);
    }
    samples[count] = (Sample){ .name = "a.stl", .has_counts = true };
    write_stl(&samples[count++].writer, "solid");
    samples[count] = (Sample){ .name = "a.om", .has_counts = true };
    write_om1(&samples[count++].writer);
    samples[count] = (Sample){ .name = "a.om", .has_counts = true };
    memcpy(samples[count].writer.bytes, om_bytes, sizeof om_bytes);
    samples[count++].writer.size = sizeof om_bytes;
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
        const Writer *writer = &samples[i].writer;
        const char *path = put_file(samples[i].name, writer->bytes, writer->size);
        assert_int_equal(read_and_verify(path), GP_OK);
        bool is_binary = memchr(writer->bytes, '\0', writer->size) != NULL;
        for (size_t size = writer->size; size-- > 0;) {
            assert_int_equal(truncate(path, (off_t)size), 0);
            GpResult result = read_and_verify(path);
            /* The last byte of a text is white space, which may be missing. */
            if (samples[i].has_counts && size + (is_binary ? 0 : 1) < writer->size)
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
    uint64_t seed = 2005;
    unsigned refused = 0, read = 0;
    for (size_t i = 0; i < count; i++) {
        const Writer *writer = &samples[i].writer;
        const char *path = put_file(samples[i].name, writer->bytes, writer->size);
        int file = open(path, O_RDWR);
        assert_true(file >= 0);
        for (int round = 0; round < 2000; round++) {
            /* In text mostly digits, blanks and signs: other bytes are refused too soon. */
            static const char likely[] = "0123456789 \n\t-./#e";
            uint32_t changes = 1 + next_random(&seed) % 3;
            size_t at[3];
            for (uint32_t c = 0; c < changes; c++) {
                at[c] = next_random(&seed) % writer->size;
                char byte = (char)next_random(&seed);
                if (next_random(&seed) % 2)
                    byte = likely[next_random(&seed) % (sizeof likely - 1)];
                assert_int_equal(pwrite(file, &byte, 1, (off_t)at[c]), 1);
            }
            if (read_and_verify(path) == GP_OK)
                read++;
            else
                refused++;
            for (uint32_t c = 0; c < changes; c++)
                assert_int_equal(pwrite(file, writer->bytes + at[c], 1, (off_t)at[c]), 1);
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

/* --- the shared meshes ---------------------------------------------------------------------------- */

static void shared_meshes_keep_every_vertex_and_face(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        uint32_t vertices, triangles;
        bool has_normals;
    } cases[] = {
        { "meshes/bunny.ply", 35947, 69451, false },
        { "meshes/teapot.ply", 3644, 6320, false },
        { "meshes/cycloidal.ply", 21384, 43368, false },
        { "meshes/dragon_100k.ply", 50000, 100000, true },
        { "meshes/dragon_res2.ply", 100250, 202520, false },
        { "meshes/happy_buddha.ply", 543628, 1087716, true },
        { "meshes/dirty/beast.ply", 32311, 64618, false },
        { "meshes/dirty/boeing.ply", 2741, 2564, false },
        { "meshes/dirty/chair_dup_faces.ply", 3186, 12756, false },
        { "meshes/dirty/conrod.ply", 3223, 6442, false },
        { "meshes/dirty/non_manifold_hole.ply", 432, 755, false },
        { "meshes/dirty/office_chair.ply", 3476, 6893, false },
        { "meshes/dirty/triangle_soup.ply", 300, 100, false },
        { "meshes/dirty/wallhole.ply", 92, 66, false },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        char path[PATH_MAX];
        GpMesh mesh;
        if (gp_data_find(cases[i].name, path, sizeof path, NULL) != GP_OK)
            skip();
        assert_reads(path, &mesh);
        if (mesh.vertex_count != cases[i].vertices || mesh.triangle_count != cases[i].triangles ||
            mesh.had_normals != cases[i].has_normals)
            fail_msg("%s: %u vertices, %u triangles", path, mesh.vertex_count, mesh.triangle_count);
        gp_mesh_free(&mesh);
    }
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(off_in_its_dialects_gives_the_pyramid),
        TEST(off_prefixes_add_attributes),
        TEST(obj_in_its_dialects_gives_the_pyramid),
        TEST(ply_in_all_encodings_and_dialects_gives_the_pyramid),
        TEST(ply_header_white_space_does_not_shift_the_body),
        TEST(ply_attributes_are_read_in_any_order_and_type),
        TEST(stl_corners_are_welded_and_flat_faces_skipped),
        TEST(om_of_both_generations_gives_the_pyramid),
        TEST(non_manifold_duplicate_and_flat_faces_are_kept),
        TEST(obj_corners_with_other_attributes_become_copies),
        TEST(obj_colours_follow_their_vertices),
        TEST(normals_are_the_area_weighted_sum),
        TEST(tiny_and_huge_triangles_have_normals),
        TEST(stored_normals_stay_and_zero_ones_are_computed),
        TEST(unreadable_paths_are_told_apart),
        TEST(errors_name_the_place_and_what_was_expected),
        TEST(binary_errors_name_the_byte),
        TEST(om_faces_that_do_not_close_are_refused),
        TEST(points_are_read_only_where_asked_for),
        TEST(every_truncation_is_an_error_and_silent),
        TEST(damaged_bytes_give_a_mesh_or_an_error_and_silence),
        TEST(shared_meshes_keep_every_vertex_and_face),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
