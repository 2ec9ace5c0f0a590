/* OpenMesh's own format: a header, then chunks of one attribute for all vertices, faces, edges or
 * half-edges. Versions before 2 store faces as vertex numbers, later ones the half-edges.
 * source OpenMesh 9, OMFormat.hh */
#include "pipeline/io/bytes.h"
#include "pipeline/io/mesh/mesh_check.h"

#include <math.h>
#include <string.h>

enum {
    ENTITY_VERTEX = 0,
    ENTITY_FACE = 2,
    ENTITY_HALFEDGE = 6,
    ENTITY_SENTINEL = 7,
    TYPE_POSITION = 0,
    TYPE_NORMAL = 1,
    TYPE_TEXCOORD = 2,
    TYPE_COLOR = 4,
    TYPE_TOPOLOGY = 7,
};

typedef struct OmCheck {
    const char *path;
    const char *begin, *next, *end;
    size_t vertices, faces, edges;
    char mesh;          /* 'T', 'Q' or 'P': corners of every face */
    bool has_halfedges; /* version 2 */
    bool seen[8][8];    /* [entity][type] */
} OmCheck;

/* The bit fields of a chunk's header, from the low end: reserved 1, named 1, entity 3, type 4,
 * signed 1, float 1, dimension - 1 3, size class 2. */
typedef struct OmChunk {
    unsigned entity, type, dimension, bits;
    bool is_named, is_float;
} OmChunk;

static GpResult fail(const OmCheck *check, const char *at, const char *expected, GpError *error)
{
    return gp_fail(error, GP_ERROR_FORMAT, "%s: byte %zu: expected %s", check->path,
                   (size_t)(at - check->begin), expected);
}

static GpResult check_floats(OmCheck *check, const OmChunk *chunk, size_t count, unsigned dimension,
                             GpError *error)
{
    if (!chunk->is_float || chunk->bits != 0 || chunk->dimension != dimension)
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: byte %zu: only vectors of float are read",
                       check->path, (size_t)(check->next - check->begin));
    if (count * dimension > (size_t)(check->end - check->next) / 4)
        return fail(check, check->next, "more numbers, but the file ends", error);
    for (size_t i = 0; i < count * dimension; i++, check->next += 4) {
        if (!isfinite(gp_bits_float((uint32_t)gp_load_little(check->next, 4))))
            return fail(check, check->next, "a finite number", error);
    }
    return GP_OK;
}

static GpResult check_colors(OmCheck *check, const OmChunk *chunk, size_t count, GpError *error)
{
    if (chunk->is_float || chunk->bits != 0 || chunk->dimension != 3)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%s: byte %zu: only colours of 3 bytes are read", check->path,
                       (size_t)(check->next - check->begin));
    if (count > (size_t)(check->end - check->next) / 3)
        return fail(check, check->next, "more colours, but the file ends", error);
    check->next += 3 * count;
    return GP_OK;
}

/* One stored index in least <= index < count; OpenMesh stores signed ones for half-edges, -1 for
 * none, and unsigned ones for the corners of version 1. */
static GpResult check_index(OmCheck *check, const OmChunk *chunk, int64_t least, size_t count,
                            GpError *error)
{
    size_t size = (size_t)1 << chunk->bits;
    if (size > (size_t)(check->end - check->next))
        return fail(check, check->next, "an index, but the file ends", error);
    uint64_t bits = gp_load_little(check->next, size);
    unsigned shift = 64 - 8 * (unsigned)size;
    int64_t index =
        check->has_halfedges ? (int64_t)(bits << shift) >> shift : (int64_t)(bits & INT64_MAX);
    if (index < least || index >= (int64_t)count)
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%s: byte %zu: refers to number %lld, but there are %zu", check->path,
                       (size_t)(check->next - check->begin), (long long)index, count);
    check->next += size;
    return GP_OK;
}

/* Per edge, twice: next half-edge, vertex it points to, face or -1. */
static GpResult check_halfedges(OmCheck *check, const OmChunk *chunk, GpError *error)
{
    GpResult result = GP_OK;
    for (size_t i = 0; i < 2 * check->edges && result == GP_OK; i++) {
        result = check_index(check, chunk, 0, 2 * check->edges, error);
        if (result == GP_OK)
            result = check_index(check, chunk, 0, check->vertices, error);
        if (result == GP_OK)
            result = check_index(check, chunk, -1, check->faces, error);
    }
    return result;
}

static GpResult check_corners(OmCheck *check, const OmChunk *chunk, GpError *error)
{
    for (size_t face = 0; face < check->faces; face++) {
        size_t corners = check->mesh == 'T' ? 3 : 4;
        if (check->mesh == 'P') {
            if (check->end - check->next < 2)
                return fail(check, check->next, "a face, but the file ends", error);
            corners = gp_load_little(check->next, 2);
            if (corners < 3)
                return fail(check, check->next, "3 or more corners", error);
            check->next += 2;
        }
        for (size_t i = 0; i < corners; i++) {
            GpResult result = check_index(check, chunk, 0, check->vertices, error);
            if (result != GP_OK)
                return result;
        }
    }
    return GP_OK;
}

static GpResult check_topology(OmCheck *check, const OmChunk *chunk, GpError *error)
{
    GpResult result = GP_OK;
    if (chunk->entity == ENTITY_HALFEDGE && check->has_halfedges)
        return check_halfedges(check, chunk, error);
    if (chunk->entity == ENTITY_FACE && !check->has_halfedges)
        return check_corners(check, chunk, error);
    if (chunk->entity == ENTITY_HALFEDGE || !check->has_halfedges)
        return fail(check, check->next, "faces as this version stores them", error);

    /* One half-edge for every vertex (-1 where it is isolated) or face. */
    size_t count = chunk->entity == ENTITY_FACE ? check->faces : check->vertices;
    for (size_t i = 0; i < count && result == GP_OK; i++)
        result = check_index(check, chunk, chunk->entity == ENTITY_FACE ? 0 : -1, 2 * check->edges,
                             error);
    return result;
}

static GpResult check_chunk(OmCheck *check, const OmChunk *chunk, GpError *error)
{
    size_t count = chunk->entity == ENTITY_FACE ? check->faces : check->vertices;
    bool is_vertex = chunk->entity == ENTITY_VERTEX, is_face = chunk->entity == ENTITY_FACE;
    bool *seen = &check->seen[chunk->entity][chunk->type & 7];
    if (chunk->is_named || chunk->type > TYPE_TOPOLOGY)
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: byte %zu: custom properties are not read",
                       check->path, (size_t)(check->next - check->begin));
    if (*seen)
        return fail(check, check->next, "every attribute once", error);
    *seen = true;
    if (!check->seen[ENTITY_VERTEX][TYPE_POSITION])
        return fail(check, check->next, "vertex positions first", error);
    if (chunk->type == TYPE_TOPOLOGY && (is_vertex || is_face || chunk->entity == ENTITY_HALFEDGE))
        return check_topology(check, chunk, error);
    if (is_vertex && chunk->type == TYPE_POSITION)
        return check_floats(check, chunk, count, 3, error);
    if ((is_vertex || is_face) && chunk->type == TYPE_NORMAL)
        return check_floats(check, chunk, count, 3, error);
    if (is_vertex && chunk->type == TYPE_TEXCOORD)
        return check_floats(check, chunk, count, 2, error);
    if ((is_vertex || is_face) && chunk->type == TYPE_COLOR)
        return check_colors(check, chunk, count, error);
    return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: byte %zu: unknown attribute %u of entity %u",
                   check->path, (size_t)(check->next - check->begin), chunk->type, chunk->entity);
}

static GpResult check_header(GpMeshSource *source, OmCheck *check, GpError *error)
{
    size_t size = source->file.size;
    if (size < 2 || memcmp(check->begin, "OM", 2) != 0)
        return fail(check, check->begin, "OM", error);
    if (size < 16)
        return fail(check, check->end, "a header of 16 bytes, but the file ends", error);
    check->mesh = check->begin[2];
    if (!strchr("TQP", check->mesh) || check->mesh == '\0')
        return fail(check, check->begin + 2, "T, Q or P", error);
    unsigned version = (unsigned char)check->begin[3]; /* major << 5 | minor */
    if (version > (2 << 5 | 2))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: byte 3: version %u.%u, 2.2 is read",
                       source->path, version >> 5, version & 31);
    check->has_halfedges = version >= 2 << 5;
    check->vertices = gp_load_little(check->begin + 4, 4);
    check->faces = gp_load_little(check->begin + 8, 4);
    check->edges = gp_load_little(check->begin + 12, 4);
    /* A vertex takes 12 bytes, a face at least 1, an edge of version 2 at least 6. */
    if (check->vertices > size / 12 || check->faces > size ||
        (check->has_halfedges && check->edges > size / 6))
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%s: byte 4: %zu vertices, %zu faces and %zu edges are promised, but the "
                       "file has %zu bytes",
                       source->path, check->vertices, check->faces, check->edges, size);
    check->next += 16;
    return GP_OK;
}

GpResult gp_mesh_check_om(GpMeshSource *source, GpError *error)
{
    OmCheck check = { .path = source->path,
                      .begin = source->file.data,
                      .next = source->file.data,
                      .end = source->file.data + source->file.size };
    GpResult result = check_header(source, &check, error);
    while (result == GP_OK) {
        if (check.end - check.next < 2)
            return fail(&check, check.next, "another chunk, but the file ends", error);
        unsigned bits = (unsigned)gp_load_little(check.next, 2);
        OmChunk chunk = { .is_named = bits >> 1 & 1,
                          .entity = bits >> 2 & 7,
                          .type = bits >> 5 & 15,
                          .is_float = bits >> 10 & 1,
                          .dimension = (bits >> 11 & 7) + 1,
                          .bits = bits >> 14 & 3 };
        check.next += 2;
        if (chunk.entity == ENTITY_SENTINEL)
            break;
        result = check_chunk(&check, &chunk, error);
    }
    if (result != GP_OK)
        return result;
    const bool *vertex = check.seen[ENTITY_VERTEX];
    bool has_faces = check.seen[ENTITY_FACE][TYPE_TOPOLOGY] &&
                     (!check.has_halfedges || check.seen[ENTITY_HALFEDGE][TYPE_TOPOLOGY]);
    if (!vertex[TYPE_POSITION] || (check.faces > 0 && !has_faces))
        return fail(&check, check.next, "positions and faces before the end", error);
    source->vertex_count = check.vertices;
    source->face_count = check.faces;
    source->has_normals = vertex[TYPE_NORMAL];
    source->has_texcoords = vertex[TYPE_TEXCOORD];
    source->has_colors = vertex[TYPE_COLOR];
    return GP_OK;
}
