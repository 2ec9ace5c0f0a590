/* The format of the library OpenMesh: a header, then chunks of one attribute for all vertices, faces,
 * edges or half-edges. Versions before 2 store faces as vertex numbers, later ones the half-edges.
 * source OpenMesh 9, OMFormat.hh */
#include "pipeline/io/mesh/mesh_formats.h"

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

typedef struct Halfedge {
    uint32_t next, to;
} Halfedge;

typedef struct Om {
    const char *path;
    const char *begin, *next, *end;
    GpMeshBuilder *mesh;
    GpBytes halfedges; /* Halfedge */
    GpBytes starts;    /* uint32_t: one half-edge of every face */
    size_t vertices, faces, edges;
    char kind;          /* 'T', 'Q' or 'P': corners of every face */
    bool has_halfedges; /* version 2 */
    bool seen[8][8];    /* [entity][type] */
} Om;

/* The bit fields of a chunk's header, from the low end: reserved 1, named 1, entity 3, type 4,
 * signed 1, float 1, dimension - 1 3, size class 2. */
typedef struct OmChunk {
    unsigned entity, type, dimension, bits;
    bool is_named, is_float;
} OmChunk;

static GpResult fail(const Om *om, const char *at, const char *expected, GpError *error)
{
    return gp_fail(error, GP_ERROR_FORMAT, "%s: byte %zu: expected %s", om->path,
                   (size_t)(at - om->begin), expected);
}

/* Vectors of float; values: where they are kept, NULL for nowhere. */
static GpResult read_floats(Om *om, const OmChunk *chunk, size_t count, unsigned dimension,
                            GpBytes *values, GpError *error)
{
    if (!chunk->is_float || chunk->bits != 0 || chunk->dimension != dimension)
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: byte %zu: only vectors of float are read",
                       om->path, (size_t)(om->next - om->begin));
    if (count * dimension > (size_t)(om->end - om->next) / 4)
        return fail(om, om->next, "more numbers, but the file ends", error);
    for (size_t i = 0; i < count * dimension; i++, om->next += 4) {
        float number = gp_bits_float((uint32_t)gp_load_little(om->next, 4));
        if (!isfinite(number))
            return fail(om, om->next, "a finite number", error);
        if (values)
            gp_bytes_append(values, &number, sizeof number);
    }
    return GP_OK;
}

static GpResult read_colors(Om *om, const OmChunk *chunk, size_t count, GpBytes *values,
                            GpError *error)
{
    if (chunk->is_float || chunk->bits != 0 || chunk->dimension != 3)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%s: byte %zu: only colours of 3 bytes are read", om->path,
                       (size_t)(om->next - om->begin));
    if (count > (size_t)(om->end - om->next) / 3)
        return fail(om, om->next, "more colours, but the file ends", error);
    for (size_t i = 0; i < count; i++, om->next += 3) {
        float color[4] = { 0, 0, 0, 1 };
        for (int k = 0; k < 3; k++)
            color[k] = (float)(unsigned char)om->next[k] / 255.0f;
        if (values)
            gp_bytes_append(values, color, sizeof color);
    }
    return GP_OK;
}

/* One stored index in least <= index < count; OpenMesh stores signed ones for half-edges, -1 for
 * none, and unsigned ones for the corners of version 1. */
static GpResult read_index(Om *om, const OmChunk *chunk, int64_t least, size_t count,
                           uint32_t *value, GpError *error)
{
    size_t size = (size_t)1 << chunk->bits;
    if (size > (size_t)(om->end - om->next))
        return fail(om, om->next, "an index, but the file ends", error);
    uint64_t bits = gp_load_little(om->next, size);
    unsigned shift = 64 - 8 * (unsigned)size;
    int64_t index =
        om->has_halfedges ? (int64_t)(bits << shift) >> shift : (int64_t)(bits & INT64_MAX);
    if (index < least || index >= (int64_t)count)
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%s: byte %zu: refers to number %lld, but there are %zu", om->path,
                       (size_t)(om->next - om->begin), (long long)index, count);
    om->next += size;
    *value = (uint32_t)index;
    return GP_OK;
}

/* Per edge, twice: next half-edge, vertex it points to, face or -1. */
static GpResult read_halfedges(Om *om, const OmChunk *chunk, GpError *error)
{
    GpResult result = GP_OK;
    for (size_t i = 0; i < 2 * om->edges && result == GP_OK; i++) {
        Halfedge halfedge;
        uint32_t face;
        result = read_index(om, chunk, 0, 2 * om->edges, &halfedge.next, error);
        if (result == GP_OK)
            result = read_index(om, chunk, 0, om->vertices, &halfedge.to, error);
        if (result == GP_OK)
            result = read_index(om, chunk, -1, om->faces, &face, error);
        if (result == GP_OK)
            gp_bytes_append(&om->halfedges, &halfedge, sizeof halfedge);
    }
    return result;
}

static GpResult read_corners(Om *om, const OmChunk *chunk, GpError *error)
{
    for (size_t face = 0; face < om->faces; face++) {
        size_t corners = om->kind == 'T' ? 3 : 4;
        if (om->kind == 'P') {
            if (om->end - om->next < 2)
                return fail(om, om->next, "a face, but the file ends", error);
            corners = gp_load_little(om->next, 2);
            if (corners < 3)
                return fail(om, om->next, "3 or more corners", error);
            om->next += 2;
        }
        gp_mesh_begin_face(om->mesh);
        for (size_t i = 0; i < corners; i++) {
            uint32_t vertex;
            GpResult result = read_index(om, chunk, 0, om->vertices, &vertex, error);
            if (result != GP_OK)
                return result;
            gp_mesh_add_corner(om->mesh, vertex);
        }
    }
    return GP_OK;
}

static GpResult read_topology(Om *om, const OmChunk *chunk, GpError *error)
{
    GpResult result = GP_OK;
    if (chunk->entity == ENTITY_HALFEDGE && om->has_halfedges)
        return read_halfedges(om, chunk, error);
    if (chunk->entity == ENTITY_FACE && !om->has_halfedges)
        return read_corners(om, chunk, error);
    if (chunk->entity == ENTITY_HALFEDGE || !om->has_halfedges)
        return fail(om, om->next, "faces as this version stores them", error);

    /* One half-edge for every vertex (-1 where it is isolated) or face. */
    bool is_face = chunk->entity == ENTITY_FACE;
    size_t count = is_face ? om->faces : om->vertices;
    for (size_t i = 0; i < count && result == GP_OK; i++) {
        uint32_t start;
        result = read_index(om, chunk, is_face ? 0 : -1, 2 * om->edges, &start, error);
        if (result == GP_OK && is_face)
            gp_bytes_append(&om->starts, &start, sizeof start);
    }
    return result;
}

/* Walks around every face once the half-edges are there. A face starts at the edge that ends in its
 * first corner. All walks together take each half-edge once in a valid file, so a longer one is
 * caught in a loop. */
static GpResult resolve_faces(Om *om, GpError *error)
{
    if (om->halfedges.failed || om->starts.failed)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for half-edges", om->path);
    const Halfedge *halfedges = (const Halfedge *)om->halfedges.data;
    const uint32_t *starts = (const uint32_t *)om->starts.data;
    size_t steps = 0;
    for (size_t face = 0; face < om->starts.size / sizeof *starts; face++) {
        gp_mesh_begin_face(om->mesh);
        uint32_t at = starts[face];
        do {
            if (++steps > 2 * om->edges)
                return gp_fail(error, GP_ERROR_FORMAT, "%s: face %zu: its half-edges do not close",
                               om->path, face);
            gp_mesh_add_corner(om->mesh, halfedges[at].to);
            at = halfedges[at].next;
        } while (at != starts[face]);
        if (om->mesh->corner_count < 3)
            return gp_fail(error, GP_ERROR_FORMAT, "%s: face %zu: expected 3 or more corners",
                           om->path, face);
    }
    return GP_OK;
}

/* Chunks of floats or bytes by what they hold. */
static GpResult read_attribute(Om *om, const OmChunk *chunk, GpError *error)
{
    bool is_vertex = chunk->entity == ENTITY_VERTEX, is_face = chunk->entity == ENTITY_FACE;
    size_t count = is_face ? om->faces : om->vertices;
    static const GpMeshAttribute attributes[] = { [TYPE_POSITION] = GP_MESH_POSITION,
                                                  [TYPE_NORMAL] = GP_MESH_NORMAL,
                                                  [TYPE_TEXCOORD] = GP_MESH_TEXCOORD,
                                                  [TYPE_COLOR] = GP_MESH_COLOR };
    bool is_shared = chunk->type == TYPE_NORMAL || chunk->type == TYPE_COLOR; /* with faces */
    bool is_own = chunk->type == TYPE_POSITION || chunk->type == TYPE_TEXCOORD;
    if (!(is_vertex && (is_own || is_shared)) && !(is_face && is_shared))
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%s: byte %zu: unknown attribute %u of entity %u", om->path,
                       (size_t)(om->next - om->begin), chunk->type, chunk->entity);
    GpBytes *values = NULL;
    if (is_vertex) {
        values = &om->mesh->values[attributes[chunk->type]];
        om->mesh->has[attributes[chunk->type]] = true;
    }
    if (chunk->type == TYPE_COLOR)
        return read_colors(om, chunk, count, values, error);
    return read_floats(om, chunk, count, chunk->type == TYPE_TEXCOORD ? 2 : 3, values, error);
}

static GpResult read_chunk(Om *om, const OmChunk *chunk, GpError *error)
{
    bool *seen = &om->seen[chunk->entity][chunk->type & 7];
    if (chunk->is_named || chunk->type > TYPE_TOPOLOGY)
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: byte %zu: custom properties are not read",
                       om->path, (size_t)(om->next - om->begin));
    if (*seen)
        return fail(om, om->next, "every attribute once", error);
    *seen = true;
    if (!om->seen[ENTITY_VERTEX][TYPE_POSITION])
        return fail(om, om->next, "vertex positions first", error);
    bool has_topology = chunk->entity == ENTITY_VERTEX || chunk->entity == ENTITY_FACE ||
                        chunk->entity == ENTITY_HALFEDGE;
    if (chunk->type == TYPE_TOPOLOGY && has_topology)
        return read_topology(om, chunk, error);
    return read_attribute(om, chunk, error);
}

static GpResult read_header(Om *om, GpError *error)
{
    size_t size = (size_t)(om->end - om->begin);
    if (size < 2 || memcmp(om->begin, "OM", 2) != 0)
        return fail(om, om->begin, "OM", error);
    if (size < 16)
        return fail(om, om->end, "a header of 16 bytes, but the file ends", error);
    om->kind = om->begin[2];
    if (!strchr("TQP", om->kind) || om->kind == '\0')
        return fail(om, om->begin + 2, "T, Q or P", error);
    unsigned version = (unsigned char)om->begin[3]; /* major << 5 | minor */
    if (version > (2 << 5 | 2))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: byte 3: version %u.%u, 2.2 is read",
                       om->path, version >> 5, version & 31);
    om->has_halfedges = version >= 2 << 5;
    om->vertices = gp_load_little(om->begin + 4, 4);
    om->faces = gp_load_little(om->begin + 8, 4);
    om->edges = gp_load_little(om->begin + 12, 4);
    /* A vertex takes 12 bytes, a face at least 1, an edge of version 2 at least 6. */
    if (om->vertices > size / 12 || om->faces > size || (om->has_halfedges && om->edges > size / 6))
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%s: byte 4: %zu vertices, %zu faces and %zu edges are promised, but the "
                       "file has %zu bytes",
                       om->path, om->vertices, om->faces, om->edges, size);
    om->next += 16;
    return GP_OK;
}

static GpResult read_chunks(Om *om, GpError *error)
{
    GpResult result = read_header(om, error);
    while (result == GP_OK) {
        if (om->end - om->next < 2)
            return fail(om, om->next, "another chunk, but the file ends", error);
        unsigned bits = (unsigned)gp_load_little(om->next, 2);
        OmChunk chunk = { .is_named = bits >> 1 & 1,
                          .entity = bits >> 2 & 7,
                          .type = bits >> 5 & 15,
                          .is_float = bits >> 10 & 1,
                          .dimension = (bits >> 11 & 7) + 1,
                          .bits = bits >> 14 & 3 };
        om->next += 2;
        if (chunk.entity == ENTITY_SENTINEL)
            break;
        result = read_chunk(om, &chunk, error);
    }
    return result;
}

GpResult gp_mesh_read_om(const char *path, GpFile *file, GpMeshBuilder *mesh, GpError *error)
{
    Om om = { .path = path,
              .begin = file->data,
              .next = file->data,
              .end = file->data + file->size,
              .mesh = mesh };
    GpResult result = read_chunks(&om, error);
    bool has_faces = om.seen[ENTITY_FACE][TYPE_TOPOLOGY] &&
                     (!om.has_halfedges || om.seen[ENTITY_HALFEDGE][TYPE_TOPOLOGY]);
    if (result == GP_OK && (!om.seen[ENTITY_VERTEX][TYPE_POSITION] || (om.faces > 0 && !has_faces)))
        result = fail(&om, om.next, "positions and faces before the end", error);
    if (result == GP_OK)
        result = resolve_faces(&om, error);
    mesh->vertex_count = om.vertices;
    gp_free(om.halfedges.data);
    gp_free(om.starts.data);
    return result;
}
