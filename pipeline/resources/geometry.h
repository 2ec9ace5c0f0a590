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

/* By value: "position", "texcoord0". */
extern const char *const gp_semantic_names[GP_SEMANTICS];

/* Which indices (or vertices) make primitive i. The first that is named is corner 0: flat varyings
 * take its value, as Direct3D's flat shading does. */
typedef enum GpPrimitive {
    GP_TRIANGLES = 0, /* 3i, 3i + 1, 3i + 2 */
    GP_POINTS,        /* i: a point sprite, a screen-aligned square, never culled (R12) */
    /* i, i + 1, i + 2; where i is odd i, i + 2, i + 1, so that all turn one way */
    GP_TRIANGLE_STRIP,
    GP_TRIANGLE_FAN, /* i + 1, i + 2, 0 */
    GP_PRIMITIVES
} GpPrimitive;

/* Vertices of one primitive. */
static inline uint32_t gp_primitive_corners(GpPrimitive primitive)
{
    return primitive == GP_POINTS ? 1 : 3;
}

extern const char *const gp_primitive_names[GP_PRIMITIVES]; /* "triangles", "triangle strip" ... */

/* How a component is stored: Direct3D 9's D3DDECLTYPE (without the two of 10 bits a component) and
 * OpenGL ES 2's types (without GL_FIXED); any of them with 1 to 4 components. */
typedef enum GpComponentType {
    GP_FLOAT32 = 0, /* FLOAT1..4 */
    GP_UNORM8,      /* UBYTE4N: bytes / 255 */
    GP_D3DCOLOR,    /* D3DCOLOR: UNORM8 whose bytes are blue, green, red, alpha; 4 components */
    GP_UINT8,       /* UBYTE4 */
    GP_INT8,        /* GL_BYTE */
    GP_SNORM8,      /* GL_BYTE, normalized: max(code / 127, -1) (R25) */
    GP_UINT16,      /* GL_UNSIGNED_SHORT */
    GP_INT16,       /* SHORT2, SHORT4 */
    GP_UNORM16,     /* USHORT2N, USHORT4N: code / 65535 */
    GP_SNORM16,     /* SHORT2N, SHORT4N: max(code / 32767, -1) */
    GP_FLOAT16,     /* FLOAT16_2, FLOAT16_4 */
    GP_COMPONENT_TYPES
} GpComponentType;

/* Bytes of one component. */
static inline size_t gp_component_bytes(GpComponentType type)
{
    return type == GP_FLOAT32 ? 4 : type >= GP_UINT16 ? 2 : 1;
}

/* One attribute of the vertices. Components that the program wants and the stream lacks read as
 * (0, 0, 0, 1). */
typedef struct GpStream {
    const void *data; /* NULL: not there; any alignment */
    uint32_t stride;  /* bytes from one vertex to the next; 0: packed */
    uint8_t components;
    GpComponentType type;
} GpStream;

/* Bytes from vertex to vertex. */
static inline size_t gp_stream_stride(const GpStream *stream)
{
    return stream->stride ? stream->stride : gp_component_bytes(stream->type) * stream->components;
}

/* Vertices and how they are joined; everything is borrowed until the run returns. */
typedef struct GpGeometry {
    GpPrimitive primitive;
    uint32_t vertex_count;
    const uint32_t *indices; /* NULL: vertices in order, unless there are: */
    uint32_t index_count;
    GpStream streams[GP_SEMANTICS];
    const uint16_t *indices16; /* index_count of them, instead of `indices` */
} GpGeometry;

/* Number of triangles or points of a geometry. */
uint32_t gp_geometry_primitives(const GpGeometry *geometry);

/* Whether indices name the vertices. */
static inline bool gp_geometry_is_indexed(const GpGeometry *geometry)
{
    return geometry->indices || geometry->indices16;
}

/* Indices of a geometry, or vertices where it has none: what primitives are made of. */
static inline uint32_t gp_geometry_elements(const GpGeometry *geometry)
{
    return gp_geometry_is_indexed(geometry) ? geometry->index_count : geometry->vertex_count;
}

/* The vertex that element `at` names. */
static inline uint32_t gp_geometry_vertex(const GpGeometry *geometry, uint32_t at)
{
    return geometry->indices     ? geometry->indices[at]
           : geometry->indices16 ? geometry->indices16[at]
                                 : at;
}

#ifdef __cplusplus
}
#endif

#endif
