/* One small mesh in the bytes of every format and dialect, for the tests of readers. */
#ifndef TESTS_MESH_FILES_H
#define TESTS_MESH_FILES_H

#include "pipeline/base/base.h"

/* A square and two of the four sides: five vertices, a quad and two triangles. */
extern const float pyramid_positions[15];
extern const uint32_t pyramid_indices[12];

#define OFF_VERTICES "0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 +0.5e0 -15E-1\n"
#define OFF_FACES    "4 3 2 1 0\n3 0 1 4\n3 1 2 4\n"
#define OBJ_VERTICES "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 -1.5\n"

/* A facet twice, one beside it and one without area: a text of odd case, a name that misleads. */
extern const char mesh_stl_text[];

/* The pyramid as OpenMesh 9 writes it: half-edges, normals 0 0 1, colours 1 2 3, texture
 * coordinates i/4 and 1/2. */
enum { OM_SIZE = 257 };
extern const unsigned char mesh_om_bytes[OM_SIZE];

typedef struct MeshBytes {
    char data[4096];
    size_t size;
    int encoding; /* 0 text, 1 little, 2 big */
} MeshBytes;

/* Appends; integers and numbers as text with a blank after them, or in the byte order. */
void mesh_put_string(MeshBytes *bytes, const char *text);
void mesh_put_bits(MeshBytes *bytes, uint64_t bits, size_t size);
void mesh_put_integer(MeshBytes *bytes, uint32_t value, size_t size);
void mesh_put_number(MeshBytes *bytes, float value, bool is_double);

/* Sixteen ways to write a PLY file; each bit is one thing that not every reader knows. */
enum {
    PLY_DOUBLES = 1,     /* coordinates of type double */
    PLY_LISTS = 2,       /* lists beside the corners, before and after them */
    PLY_SHORT_INDEX = 4, /* ushort corners, counted by int */
    PLY_ODD_HEADER = 8,  /* comments before the end, obj_info, an element in between */
    PLY_VARIANTS = 16
};

void mesh_write_ply(MeshBytes *bytes, int encoding, int variant);

/* The facets of mesh_stl_text in binary; the header may start with anything. */
void mesh_write_stl(MeshBytes *bytes, const char *header);

/* The pyramid as OpenMesh 1 wrote it: faces as polygons. */
void mesh_write_om1(MeshBytes *bytes);

#endif
