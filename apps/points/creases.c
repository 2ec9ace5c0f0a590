#include "apps/points/creases.h"

#include "apps/base/camera.h"
#include "apps/base/vector.h"
#include "apps/points/sides.h"

#include <string.h>

/* A copy of a vertex: of a side, and perhaps of more that are as good as one. */
typedef struct Copy {
    uint32_t side;   /* its number: a corner of it */
    uint32_t number; /* of the vertex */
    uint32_t next;   /* copy of the same vertex; 0: none */
} Copy;

typedef struct Splitter {
    GpMesh *mesh;
    double cosine;
    uint32_t *sides;      /* [corners] a corner farther on in the same side; the last is its own */
    double (*normals)[3]; /* [corners] of sides: sums */
    Copy *copies;         /* [corners + 1], from 1 on */
    uint32_t *first;      /* [vertices] copy */
    bool *strays;         /* [vertices] the normal is of no use for a side */
    uint32_t copy_count, count;
} Splitter;

static uint32_t side_of(uint32_t *sides, uint32_t corner)
{
    while (sides[corner] != corner) {
        sides[corner] = sides[sides[corner]];
        corner = sides[corner];
    }
    return corner;
}

static void unite(uint32_t *sides, size_t a, size_t b)
{
    const uint32_t x = side_of(sides, (uint32_t)a), y = side_of(sides, (uint32_t)b);
    sides[x > y ? x : y] = x > y ? y : x;
}

/* Those without a length are near to all. */
static bool is_near(const double a[3], const double b[3], double cosine)
{
    return vector_dot(a, b) >= cosine * sqrt(vector_dot(a, a) * vector_dot(b, b));
}

static void find_sides(const Sides *edges, Splitter *splitter)
{
    const GpMesh *mesh = splitter->mesh;
    const uint32_t corners = 3 * mesh->triangle_count, *welded = edges->corners;
    double own[3], other[3];
    for (uint32_t c = 0; c < corners; c++)
        splitter->sides[c] = c;
    for (size_t s = 0; s < corners; s++) {
        const size_t mate = edges->mate[s];
        if (mate == NO_SIDE || mate < s)
            continue;
        triangle_cross(mesh, s / 3, own);
        triangle_cross(mesh, mate / 3, other);
        if (!is_near(own, other, splitter->cosine))
            continue;
        const bool opposite = welded[s] == welded[side_end(mate)];
        unite(splitter->sides, s, opposite ? side_end(mate) : mate);
        unite(splitter->sides, side_end(s), opposite ? mate : side_end(mate));
    }
    for (uint32_t c = 0; c < corners; c++) {
        double *sum = splitter->normals[side_of(splitter->sides, c)];
        triangle_cross(mesh, c / 3, own);
        vector_add_scaled(sum, 1, own, sum);
    }
}

static void find_strays(const Splitter *splitter)
{
    const GpMesh *mesh = splitter->mesh;
    for (uint32_t c = 0; c < 3 * mesh->triangle_count; c++) {
        const uint32_t vertex = mesh->indices[c];
        const float *stored = mesh->normals + 3 * (size_t)vertex;
        const double normal[3] = { (double)stored[0], (double)stored[1], (double)stored[2] };
        splitter->strays[vertex] |=
            !mesh->had_normals ||
            !is_near(normal, splitter->normals[side_of(splitter->sides, c)], splitter->cosine);
    }
}

/* The vertex that a corner shall have. */
static uint32_t copy_for(Splitter *splitter, uint32_t corner)
{
    const uint32_t vertex = splitter->mesh->indices[corner],
                   side = side_of(splitter->sides, corner);
    const double *normal = splitter->normals[side];
    uint32_t number = UINT32_MAX;
    for (uint32_t at = splitter->first[vertex]; at; at = splitter->copies[at].next) {
        const Copy *copy = &splitter->copies[at];
        if (copy->side == side)
            return copy->number;
        if (number == UINT32_MAX &&
            is_near(splitter->normals[copy->side], normal, splitter->cosine))
            number = copy->number;
    }
    if (number == UINT32_MAX)
        number = splitter->first[vertex] ? splitter->count++ : vertex;
    splitter->copies[++splitter->copy_count] =
        (Copy){ .side = side, .number = number, .next = splitter->first[vertex] };
    splitter->first[vertex] = splitter->copy_count;
    return number;
}

/* indices: [corners] the new ones */
static void number_copies(Splitter *splitter, uint32_t *indices)
{
    const GpMesh *mesh = splitter->mesh;
    splitter->count = mesh->vertex_count;
    for (uint32_t c = 0; c < 3 * mesh->triangle_count; c++)
        indices[c] = splitter->strays[mesh->indices[c]] ? copy_for(splitter, c) : mesh->indices[c];
}

/* Vertices of the mesh that have copies, or whose normal strays, get normals of their sides. */
static void set_normals(const Splitter *splitter, const uint32_t *indices, GpMesh *made)
{
    const GpMesh *mesh = splitter->mesh;
    double(*sums)[3] = splitter->normals;
    const bool all = mesh->had_normals; /* else those of a vertex without copies are right */
    for (uint32_t c = 0; c < 3 * mesh->triangle_count; c++) {
        const uint32_t vertex = mesh->indices[c], first = splitter->first[vertex];
        if (!splitter->strays[vertex] || (!all && !splitter->copies[first].next))
            continue;
        double sum[3] = { 0, 0, 0 };
        for (uint32_t at = first; at; at = splitter->copies[at].next)
            if (splitter->copies[at].number == indices[c])
                vector_add_scaled(sum, 1, sums[splitter->copies[at].side], sum);
        if (!(vector_dot(sum, sum) > 0))
            continue;
        vector_normalize(sum);
        for (size_t k = 0; k < 3; k++)
            made->normals[3 * (size_t)indices[c] + k] = (float)sum[k];
    }
}

static void copy_vertices(const GpMesh *mesh, const uint32_t *indices, GpMesh *made)
{
    const size_t count = mesh->vertex_count;
    memcpy(made->positions, mesh->positions, 3 * count * sizeof(float));
    memcpy(made->normals, mesh->normals, 3 * count * sizeof(float));
    if (mesh->colors)
        memcpy(made->colors, mesh->colors, 4 * count * sizeof(float));
    for (size_t c = 0; c < 3 * (size_t)mesh->triangle_count; c++) {
        const size_t from = mesh->indices[c], to = indices[c];
        if (to < count)
            continue;
        memcpy(made->positions + 3 * to, mesh->positions + 3 * from, 3 * sizeof(float));
        if (mesh->colors)
            memcpy(made->colors + 4 * to, mesh->colors + 4 * from, 4 * sizeof(float));
    }
}

/* indices: become the mesh's */
static GpResult take_copies(const Splitter *splitter, uint32_t *indices)
{
    GpMesh *mesh = splitter->mesh, made = *mesh;
    made.vertex_count = splitter->count;
    made.positions = gp_alloc(splitter->count, 3 * sizeof(float));
    made.normals = gp_alloc(splitter->count, 3 * sizeof(float));
    made.colors = mesh->colors ? gp_alloc(splitter->count, 4 * sizeof(float)) : NULL;
    made.texcoords = NULL;
    made.indices = indices;
    if (!made.positions || !made.normals || (mesh->colors && !made.colors)) {
        made.indices = NULL;
        gp_mesh_free(&made);
        return GP_ERROR_MEMORY;
    }
    copy_vertices(mesh, indices, &made);
    set_normals(splitter, indices, &made);
    gp_mesh_free(mesh);
    *mesh = made;
    return GP_OK;
}

static GpResult split(const Sides *edges, Splitter *splitter)
{
    const size_t corners = 3 * (size_t)splitter->mesh->triangle_count;
    uint32_t *indices = gp_alloc_unset(corners * sizeof *indices + 1);
    if (!indices || !splitter->sides || !splitter->normals || !splitter->copies ||
        !splitter->first || !splitter->strays) {
        gp_free(indices);
        return GP_ERROR_MEMORY;
    }
    find_sides(edges, splitter);
    find_strays(splitter);
    number_copies(splitter, indices);
    const GpResult result = take_copies(splitter, indices);
    if (result != GP_OK)
        gp_free(indices);
    return result;
}

GpResult mesh_split_creases(GpMesh *mesh, double degrees)
{
    Sides edges;
    double sine;
    if (mesh->triangle_count > (1u << 30) / 3)
        return GP_ERROR_UNSUPPORTED;
    GpResult result = sides_find(mesh, &edges);
    if (result != GP_OK)
        return result;
    const size_t corners = 3 * (size_t)mesh->triangle_count, vertices = mesh->vertex_count;
    Splitter splitter = { .mesh = mesh,
                          .sides = gp_alloc_unset(corners * sizeof(uint32_t) + 1),
                          .normals = gp_alloc(corners, 3 * sizeof(double)),
                          .copies = gp_alloc_unset((corners + 1) * sizeof(Copy)),
                          .first = gp_alloc(vertices, sizeof(uint32_t)),
                          .strays = gp_alloc(vertices, sizeof(bool)) };
    angle_sincos(degrees, &sine, &splitter.cosine);
    result = split(&edges, &splitter);
    gp_free(splitter.sides);
    gp_free(splitter.normals);
    gp_free(splitter.copies);
    gp_free(splitter.first);
    gp_free(splitter.strays);
    sides_free(&edges);
    return result;
}
