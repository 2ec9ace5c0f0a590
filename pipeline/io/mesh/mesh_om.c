/* The format of the library OpenMesh: a header, then chunks of one attribute for all vertices,
 * faces, edges or half-edges. Versions before 2 store faces as vertex numbers, later ones the
 * half-edges.
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
    GpInput *input;
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

static void fail(const Om *om, const char *expected)
{
    gp_input_fail(om->input, GP_ERROR_FORMAT, "expected %s", expected);
}

/* Vectors of float or colours of 3 bytes; values: where they are kept, NULL for nowhere. */
static void read_values(const Om *om, const OmChunk *chunk, size_t count, GpBytes *values)
{
    bool are_colors = chunk->type == TYPE_COLOR;
    unsigned dimension = chunk->type == TYPE_TEXCOORD ? 2 : 3;
    if (chunk->is_float == are_colors || chunk->bits != 0 || chunk->dimension != dimension) {
        gp_input_fail(om->input, GP_ERROR_UNSUPPORTED, "only %s are read",
                      are_colors ? "colours of 3 bytes" : "vectors of float");
        return;
    }
    size_t size = are_colors ? 1 : 4;
    const char *at = gp_input_take(om->input, count * dimension * size);
    if (!at)
        fail(om,
             are_colors ? "more colours, but the file ends" : "more numbers, but the file ends");
    for (size_t i = 0; i < count * dimension && om->input->result == GP_OK; i++, at += size) {
        const float opaque = 1;
        float value = are_colors ? (float)(unsigned char)*at / 255.0f
                                 : gp_bits_float((uint32_t)gp_load_little(at, 4));
        om->input->place = at;
        if (!isfinite(value))
            fail(om, "a finite number");
        if (values)
            gp_bytes_append(values, &value, sizeof value);
        if (values && are_colors && i % 3 == 2)
            gp_bytes_append(values, &opaque, sizeof opaque);
    }
}

/* One stored index in least <= index < count, 0 after a fault; OpenMesh stores signed ones for
 * half-edges, -1 for none, and unsigned ones for the corners of version 1. */
static uint32_t read_index(const Om *om, const OmChunk *chunk, int64_t least, size_t count)
{
    size_t size = (size_t)1 << chunk->bits;
    const char *bytes = gp_input_take(om->input, size);
    if (!bytes) {
        fail(om, "an index, but the file ends");
        return 0;
    }
    uint64_t bits = gp_load_little(bytes, size);
    unsigned shift = 64 - 8 * (unsigned)size;
    int64_t index =
        om->has_halfedges ? (int64_t)(bits << shift) >> shift : (int64_t)(bits & INT64_MAX);
    if (index >= least && index < (int64_t)count)
        return (uint32_t)index;
    gp_input_fail(om->input, GP_ERROR_FORMAT, "refers to number %lld, but there are %zu",
                  (long long)index, count);
    return 0;
}

/* Per edge, twice: next half-edge, vertex it points to, face or -1. */
static void read_halfedges(Om *om, const OmChunk *chunk)
{
    for (size_t i = 0; i < 2 * om->edges && om->input->result == GP_OK; i++) {
        Halfedge halfedge;
        halfedge.next = read_index(om, chunk, 0, 2 * om->edges);
        halfedge.to = read_index(om, chunk, 0, om->vertices);
        read_index(om, chunk, -1, om->faces);
        gp_bytes_append(&om->halfedges, &halfedge, sizeof halfedge);
    }
}

static void read_corners(const Om *om, const OmChunk *chunk)
{
    for (size_t face = 0; face < om->faces && om->input->result == GP_OK; face++) {
        size_t corners = om->kind == 'T' ? 3 : 4;
        if (om->kind == 'P') {
            const char *bytes = gp_input_take(om->input, 2);
            corners = bytes ? gp_load_little(bytes, 2) : 0;
            if (corners < 3)
                fail(om, bytes ? "3 or more corners" : "a face, but the file ends");
        }
        gp_mesh_begin_face(om->mesh);
        for (size_t i = 0; i < corners && om->input->result == GP_OK; i++)
            gp_mesh_add_corner(om->mesh, read_index(om, chunk, 0, om->vertices));
    }
}

static void read_topology(Om *om, const OmChunk *chunk)
{
    bool is_face = chunk->entity == ENTITY_FACE;
    if (chunk->entity == ENTITY_HALFEDGE && om->has_halfedges) {
        read_halfedges(om, chunk);
    } else if (is_face && !om->has_halfedges) {
        read_corners(om, chunk);
    } else if (chunk->entity == ENTITY_HALFEDGE || !om->has_halfedges) {
        fail(om, "faces as this version stores them");
    } else { /* One half-edge for every vertex (-1 where it is isolated) or face. */
        size_t count = is_face ? om->faces : om->vertices;
        for (size_t i = 0; i < count && om->input->result == GP_OK; i++) {
            uint32_t start = read_index(om, chunk, is_face ? 0 : -1, 2 * om->edges);
            if (is_face)
                gp_bytes_append(&om->starts, &start, sizeof start);
        }
    }
}

/* Walks around every face once the half-edges are there. A face starts at the edge that ends in its
 * first corner. All walks together take each half-edge once in a valid file, so a longer one is
 * caught in a loop. */
static void resolve_faces(const Om *om)
{
    const Halfedge *halfedges = (const Halfedge *)om->halfedges.data;
    const uint32_t *starts = (const uint32_t *)om->starts.data;
    size_t steps = 0;
    if (om->halfedges.failed || om->starts.failed)
        gp_input_fail(om->input, GP_ERROR_MEMORY, "no memory for half-edges");
    for (size_t face = 0; face < om->starts.size / sizeof *starts; face++) {
        if (om->input->result != GP_OK)
            return;
        gp_mesh_begin_face(om->mesh);
        uint32_t at = starts[face];
        do {
            gp_mesh_add_corner(om->mesh, halfedges[at].to);
            at = halfedges[at].next;
        } while (++steps <= 2 * om->edges && at != starts[face]);
        if (steps > 2 * om->edges)
            gp_input_fail(om->input, GP_ERROR_FORMAT, "the half-edges of face %zu do not close",
                          face);
        if (om->mesh->corner_count < 3)
            fail(om, "3 or more corners");
    }
}

static void read_chunk(Om *om, const OmChunk *chunk)
{
    static const GpMeshAttribute attributes[8] = { [TYPE_POSITION] = GP_MESH_POSITION,
                                                   [TYPE_NORMAL] = GP_MESH_NORMAL,
                                                   [TYPE_TEXCOORD] = GP_MESH_TEXCOORD,
                                                   [TYPE_COLOR] = GP_MESH_COLOR };
    const unsigned topology = 1 << TYPE_TOPOLOGY, shared = 1 << TYPE_NORMAL | 1 << TYPE_COLOR;
    const unsigned known[8] = {
        [ENTITY_VERTEX] = topology | shared | 1 << TYPE_POSITION | 1 << TYPE_TEXCOORD,
        [ENTITY_FACE] = topology | shared,
        [ENTITY_HALFEDGE] = topology,
    };
    bool *seen = &om->seen[chunk->entity][chunk->type & 7];
    om->input->place = om->input->next;
    if (chunk->is_named || chunk->type > TYPE_TOPOLOGY) {
        gp_input_fail(om->input, GP_ERROR_UNSUPPORTED, "custom properties are not read");
        return;
    }
    if (*seen)
        fail(om, "every attribute once");
    *seen = true;
    if (!om->seen[ENTITY_VERTEX][TYPE_POSITION])
        fail(om, "vertex positions first");
    GpMeshAttribute attribute = attributes[chunk->type];
    if (!(known[chunk->entity] >> chunk->type & 1)) {
        gp_input_fail(om->input, GP_ERROR_UNSUPPORTED, "unknown attribute %u of entity %u",
                      chunk->type, chunk->entity);
    } else if (chunk->type == TYPE_TOPOLOGY) {
        read_topology(om, chunk);
    } else if (chunk->entity == ENTITY_FACE) {
        read_values(om, chunk, om->faces, NULL);
    } else {
        om->mesh->has[attribute] = true;
        read_values(om, chunk, om->vertices, &om->mesh->values[attribute]);
    }
}

static void read_header(Om *om)
{
    GpInput *input = om->input;
    size_t size = (size_t)(input->end - input->begin);
    const char *header = gp_input_take(input, 16);
    if (size < 2 || memcmp(input->begin, "OM", 2) != 0)
        fail(om, "OM");
    input->place = input->end;
    if (!header) {
        fail(om, "a header of 16 bytes, but the file ends");
        return;
    }
    om->kind = header[2];
    unsigned version = (unsigned char)header[3]; /* major << 5 | minor */
    om->has_halfedges = version >= 2 << 5;
    om->vertices = gp_load_little(header + 4, 4);
    om->faces = gp_load_little(header + 8, 4);
    om->edges = gp_load_little(header + 12, 4);
    input->place = header + 2;
    if (!strchr("TQP", om->kind) || om->kind == '\0')
        fail(om, "T, Q or P");
    input->place = header + 3;
    if (version > (2 << 5 | 2))
        gp_input_fail(input, GP_ERROR_UNSUPPORTED, "version %u.%u, 2.2 is read", version >> 5,
                      version & 31);
    /* A vertex takes 12 bytes, a face at least 1, an edge of version 2 at least 6. */
    input->place = header + 4;
    if (om->vertices > size / 12 || om->faces > size || (om->has_halfedges && om->edges > size / 6))
        gp_input_fail(input, GP_ERROR_FORMAT,
                      "%zu vertices, %zu faces and %zu edges are promised, but the file has %zu "
                      "bytes",
                      om->vertices, om->faces, om->edges, size);
}

static void read_chunks(Om *om)
{
    while (om->input->result == GP_OK) {
        const char *header = gp_input_take(om->input, 2);
        if (!header) {
            fail(om, "another chunk, but the file ends");
            return;
        }
        unsigned bits = (unsigned)gp_load_little(header, 2);
        OmChunk chunk = { .is_named = bits >> 1 & 1,
                          .entity = bits >> 2 & 7,
                          .type = bits >> 5 & 15,
                          .is_float = bits >> 10 & 1,
                          .dimension = (bits >> 11 & 7) + 1,
                          .bits = bits >> 14 & 3 };
        if (chunk.entity == ENTITY_SENTINEL)
            return;
        read_chunk(om, &chunk);
    }
}

void gp_mesh_read_om(GpInput *input, GpMeshBuilder *mesh)
{
    Om om = { .input = input, .mesh = mesh };
    read_header(&om);
    read_chunks(&om);
    bool has_faces = om.seen[ENTITY_FACE][TYPE_TOPOLOGY] &&
                     (!om.has_halfedges || om.seen[ENTITY_HALFEDGE][TYPE_TOPOLOGY]);
    input->place = input->next;
    if (!om.seen[ENTITY_VERTEX][TYPE_POSITION] || (om.faces > 0 && !has_faces))
        fail(&om, "positions and faces before the end");
    resolve_faces(&om);
    mesh->vertex_count = om.vertices;
    gp_free(om.halfedges.data);
    gp_free(om.starts.data);
}
