#include "tests/support/meshes/mesh_files.h"

#include <stdio.h>
#include <string.h>

const float pyramid_positions[15] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5f, 0.5f, -1.5f };
const uint32_t pyramid_indices[12] = { 3, 2, 1, 3, 1, 0, 0, 1, 4, 1, 2, 4 };

const char mesh_stl_text[] =
    "solid outer facet\n"
    "  facet normal nan nan nan\n    OUTER LOOP\n      vertex 0 0 0\n      vertex 1 0 0\n"
    "      vertex 0 1 0\n    endloop\n  endfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 0 0\nvertex 0 5 0\nendloop\nendfacet\n"
    "facet normal 0 0 1\nOuter Loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "endsolid outer\n";

/* clang-format off */
const unsigned char mesh_om_bytes[OM_SIZE] = {
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
/* clang-format on */

void mesh_put_string(MeshBytes *bytes, const char *text)
{
    memcpy(bytes->data + bytes->size, text, strlen(text));
    bytes->size += strlen(text);
}

void mesh_put_bits(MeshBytes *bytes, uint64_t bits, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        size_t shift = 8 * (bytes->encoding == 1 ? i : size - 1 - i);
        bytes->data[bytes->size++] = (char)(bits >> shift & 255);
    }
}

void mesh_put_integer(MeshBytes *bytes, uint32_t value, size_t size)
{
    char text[16];
    snprintf(text, sizeof text, "%u ", value);
    if (bytes->encoding == 0)
        mesh_put_string(bytes, text);
    else
        mesh_put_bits(bytes, value, size);
}

void mesh_put_number(MeshBytes *bytes, float value, bool is_double)
{
    char text[32];
    double wide = (double)value;
    uint64_t bits;
    memcpy(&bits, &wide, sizeof bits);
    snprintf(text, sizeof text, "%.9g ", wide);
    if (bytes->encoding == 0)
        mesh_put_string(bytes, text);
    else
        mesh_put_bits(bytes, is_double ? bits : gp_float_bits(value), is_double ? 8 : 4);
}

void mesh_write_ply(MeshBytes *bytes, int encoding, int variant)
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
    *bytes = (MeshBytes){ .encoding = encoding };
    mesh_put_string(bytes, header);
    for (int v = 0; v < 5; v++) {
        if (has_lists) {
            mesh_put_integer(bytes, 2, 1);
            mesh_put_number(bytes, 7, false);
            mesh_put_number(bytes, 8, false);
        }
        for (int i = 0; i < 3; i++)
            mesh_put_number(bytes, pyramid_positions[3 * v + i], has_doubles);
        mesh_put_string(bytes, encoding == 0 ? "\n" : "");
    }
    for (uint32_t m = 0; m < 2 && is_odd; m++) {
        mesh_put_integer(bytes, m + 1, 1);
        for (uint32_t i = 0; i <= m; i++)
            mesh_put_integer(bytes, 'a', 1);
    }
    static const uint32_t faces[3][5] = { { 4, 3, 2, 1, 0 }, { 3, 0, 1, 4, 0 }, { 3, 1, 2, 4, 0 } };
    for (int f = 0; f < 3; f++) {
        if (has_lists) {
            mesh_put_integer(bytes, 1, 1);
            mesh_put_integer(bytes, 300, 2);
        }
        mesh_put_integer(bytes, faces[f][0], is_short ? 4 : 1);
        for (uint32_t i = 0; i < faces[f][0]; i++)
            mesh_put_integer(bytes, faces[f][1 + i], is_short ? 2 : 4);
        if (has_lists)
            mesh_put_integer(bytes, 9, 1);
    }
}

void mesh_write_stl(MeshBytes *bytes, const char *header)
{
    static const float corners[4][9] = { { 0, 0, 0, 1, 0, 0, 0, 1, 0 },
                                         { 1, 0, 0, 1, 1, 0, 0, 1, 0 },
                                         { 1, 0, 0, 1, 0, 0, 0, 5, 0 },
                                         { 0, 0, 0, 1, 0, 0, 0, 1, 0 } };
    *bytes = (MeshBytes){ .encoding = 1 };
    mesh_put_string(bytes, header);
    bytes->size = 80;
    mesh_put_bits(bytes, 4, 4);
    for (int f = 0; f < 4; f++) {
        for (int i = 0; i < 3; i++)
            mesh_put_bits(bytes, 0x7fc00000u, 4); /* a normal of nan */
        for (int i = 0; i < 9; i++)
            mesh_put_number(bytes, corners[f][i], false);
        mesh_put_bits(bytes, 0xffff, 2);
    }
}

void mesh_write_om1(MeshBytes *bytes)
{
    *bytes = (MeshBytes){ .encoding = 1 };
    mesh_put_string(bytes, "OMP\x22");
    mesh_put_bits(bytes, 5, 4);
    mesh_put_bits(bytes, 3, 4);
    mesh_put_bits(bytes, 7, 4);
    mesh_put_bits(bytes, 2 << 11 | 1 << 10, 2); /* vertex positions */
    for (int i = 0; i < 15; i++)
        mesh_put_number(bytes, pyramid_positions[i], false);
    mesh_put_bits(bytes, 7 << 5 | 2 << 2, 2); /* face topology in bytes */
    static const uint32_t faces[3][5] = { { 4, 3, 2, 1, 0 }, { 3, 0, 1, 4, 0 }, { 3, 1, 2, 4, 0 } };
    for (int f = 0; f < 3; f++) {
        mesh_put_bits(bytes, faces[f][0], 2);
        for (uint32_t i = 0; i < faces[f][0]; i++)
            mesh_put_bits(bytes, faces[f][1 + i], 1);
    }
    mesh_put_bits(bytes, 7 << 2, 2); /* the end */
}
