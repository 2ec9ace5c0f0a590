/* The header of a PLY file (internal, for the readers of meshes and of points).
 * source Greg Turk, "The PLY Polygon File Format", 1994 */
#ifndef GP_IO_PLY_HEADER_H
#define GP_IO_PLY_HEADER_H

#include "pipeline/io/input.h"

typedef enum PlyType {
    PLY_INT8,
    PLY_UINT8,
    PLY_INT16,
    PLY_UINT16,
    PLY_INT32,
    PLY_UINT32,
    PLY_FLOAT32,
    PLY_FLOAT64,
    PLY_TYPES
} PlyType;

/* What a property means here: for a vertex, its place in the row (mesh_builder.h). */
typedef enum PlyRole {
    PLY_X,
    PLY_Y,
    PLY_Z,
    PLY_NX,
    PLY_NY,
    PLY_NZ,
    PLY_U,
    PLY_V,
    PLY_RED,
    PLY_GREEN,
    PLY_BLUE,
    PLY_ALPHA,
    PLY_RADIUS, /* of a point */
    PLY_VERTEX_ROLES,
    PLY_CORNERS = PLY_VERTEX_ROLES, /* the list of a face */
    PLY_IGNORED
} PlyRole;

typedef struct PlyProperty {
    PlyRole role;
    bool is_list;
    PlyType type;       /* of the value, or of a list's entries */
    PlyType count_type; /* of a list's length */
} PlyProperty;

typedef enum PlyKind { PLY_VERTEX, PLY_FACE, PLY_OTHER } PlyKind;

typedef struct PlyElement {
    PlyKind kind;
    size_t count;
    size_t first, end; /* properties */
} PlyElement;

typedef enum PlyEncoding { PLY_ASCII, PLY_LITTLE, PLY_BIG } PlyEncoding;

typedef struct PlyHeader {
    PlyEncoding encoding;
    PlyElement element[16];
    PlyProperty property[128];
    size_t element_count, property_count;
    /* roles that occur; incomplete groups are already made PLY_IGNORED */
    bool has[PLY_IGNORED + 1];
} PlyHeader;

/* Parses and checks the header and leaves input after it; false after a fault. */
bool gp_ply_header(GpInput *input, PlyHeader *header);

/* Bytes of one binary value. */
size_t gp_ply_size(PlyType type);

#endif
