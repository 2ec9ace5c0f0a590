/* Geometry: vertex streams, indices and the primitives they make. */
#ifndef GP_GEOMETRY_H
#define GP_GEOMETRY_H

#include "pipeline/base/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a vertex stream holds, and what a program's input wants. */
typedef enum GpSemantic {
    GP_POSITION = 0,
    GP_NORMAL,
    GP_COLOR,
    GP_TEXCOORD0,
    GP_TEXCOORD1,
    GP_TEXCOORD2,
    GP_TEXCOORD3,
    GP_TANGENT,
    GP_POINT_SIZE,
    GP_SEMANTICS
} GpSemantic;

extern const char *const gp_semantic_names[GP_SEMANTICS];

typedef enum GpPrimitive {
    GP_TRIANGLES = 0, /* three indices (or vertices) a triangle */
    GP_POINTS,        /* one a point sprite: a screen-aligned square, never culled (R12) */
    GP_PRIMITIVES
} GpPrimitive;

typedef enum GpComponentType {
    GP_FLOAT32 = 0,
    GP_UNORM8, /* bytes / 255 */
} GpComponentType;

/* One attribute of the vertices. Components that the program wants and the stream lacks read as
 * (0, 0, 0, 1). */
typedef struct GpStream {
    const void *data; /* NULL: not there */
    uint32_t stride;  /* bytes from one vertex to the next; 0: packed */
    uint8_t components;
    GpComponentType type;
} GpStream;

typedef struct GpGeometry {
    GpPrimitive primitive;
    uint32_t vertex_count;
    const uint32_t *indices; /* NULL: vertices in order */
    uint32_t index_count;
    GpStream streams[GP_SEMANTICS];
} GpGeometry;

/* Number of triangles or points of a geometry. */
uint32_t gp_geometry_primitives(const GpGeometry *geometry);

#ifdef __cplusplus
}
#endif

#endif
