#include "apps/points/orient.h"

#include "apps/base/vector.h"
#include "apps/points/sides.h"

#include <string.h>

enum { MAX_SHELLS = 32 }; /* the largest closed parts: the others may be inside of them */

/* What the triangles of a part add up to, all turned as its first one is. */
typedef struct Part {
    double origin[3];   /* its first corner */
    double vectors[3];  /* sum of area vectors */
    double volume;      /* seen from the origin */
    double area, other; /* of all; of those that the file turns the other way than the first */
    double vote;        /* cosines of the file's normals and the triangles', by area */
    double low[3], high[3];
    bool is_closed;
    bool is_twisted; /* no way to turn all fits */
    bool turns;      /* against the first triangle of the file */
    bool turns_normals;
} Part;

/* Triangles as sets; each knows whether it is to be turned against its parent. */
typedef struct Forest {
    uint32_t *parents;
    bool *odd;
} Forest;

static uint32_t root_of(const Forest *forest, uint32_t at, bool *odd)
{
    *odd = false;
    while (forest->parents[at] != at) {
        const uint32_t parent = forest->parents[at];
        forest->odd[at] ^= forest->odd[parent];
        forest->parents[at] = forest->parents[parent];
        *odd ^= forest->odd[at];
        at = forest->parents[at];
    }
    return at;
}

/* Returns false where the two are of one part already, and it does not fit. */
static bool unite(const Forest *forest, uint32_t a, uint32_t b, bool against)
{
    bool odd_a, odd_b;
    const uint32_t root_a = root_of(forest, a, &odd_a), root_b = root_of(forest, b, &odd_b);
    const bool odd = odd_a ^ odd_b ^ against;
    if (root_a == root_b)
        return !odd;
    forest->parents[root_a > root_b ? root_a : root_b] = root_a > root_b ? root_b : root_a;
    forest->odd[root_a > root_b ? root_a : root_b] = odd;
    return true;
}

/* What connects a mesh's triangles. */
typedef struct Connection {
    const uint32_t *corners; /* welded */
    Forest forest;
    bool *twisted; /* [triangle_count] something does not fit there */
} Connection;

/* Across an edge of two triangles they turn one way where they pass it in opposite directions.
 * Where more meet, the file's word is taken for how they turn. */
static void connect_edge(void *context, const uint32_t ends[2], const uint32_t *sides, size_t count)
{
    const Connection *connection = context;
    const uint32_t *corners = connection->corners;
    const bool against = count == 2 && corners[sides[0]] == corners[sides[1]];
    for (size_t i = 1; i < count && ends[0] != ends[1]; i++)
        if (!unite(&connection->forest, sides[i] / 3, sides[0] / 3, against))
            connection->twisted[sides[i] / 3] = true;
}

static void add_triangle(const GpMesh *mesh, size_t triangle, bool odd, bool begins, Part *part)
{
    double cross[3], from[3], normals = 0;
    triangle_cross(mesh, triangle, cross);
    const double area = sqrt(vector_dot(cross, cross)) / 2, sign = odd ? -1 : 1;
    for (int i = 0; i < 3; i++) {
        const size_t vertex = 3 * (size_t)mesh->indices[3 * triangle + (size_t)i];
        for (int k = 0; k < 3; k++) {
            const double at = (double)mesh->positions[vertex + (size_t)k];
            if (begins && i == 0)
                part->origin[k] = part->low[k] = part->high[k] = at;
            part->low[k] = at < part->low[k] ? at : part->low[k];
            part->high[k] = at > part->high[k] ? at : part->high[k];
            from[k] = at - part->origin[k];
            normals += (double)mesh->normals[vertex + (size_t)k] * cross[k];
        }
    }
    vector_add_scaled(part->vectors, sign / 2, cross, part->vectors);
    part->volume += sign * vector_dot(from, cross) / 6;
    part->area += area;
    part->other += odd ? area : 0;
    part->vote += sign * normals;
}

/* 1: the part shows its outside, -1: its inside, 0: that cannot be said. */
static int find_sign(const Part *part)
{
    const double rounding = 1e-7 * part->area * sqrt(part->area);
    int sign = 0;
    if (part->is_twisted || !(sqrt(vector_dot(part->vectors, part->vectors)) <= 0.02 * part->area))
        return 0;
    for (int i = 0; i < 8; i++) {
        double corner[3];
        for (int k = 0; k < 3; k++)
            corner[k] = (i >> k & 1 ? part->high[k] : part->low[k]) - part->origin[k];
        const double volume = part->volume - vector_dot(part->vectors, corner) / 3;
        const int own = volume > rounding ? 1 : volume < -rounding ? -1 : 0;
        if (own == 0 || own == -sign)
            return 0;
        sign = own;
    }
    return sign;
}

static bool is_inside(const Part *part, const Part *shell)
{
    for (int k = 0; k < 3; k++)
        if (!(part->low[k] > shell->low[k] && part->high[k] < shell->high[k]))
            return false;
    return true;
}

/* The largest closed parts, by area; returns how many. */
static int find_shells(const Part *parts, uint32_t count, const Part *shells[MAX_SHELLS])
{
    int found = 0;
    for (uint32_t p = 0; p < count; p++) {
        int at = found;
        if (!parts[p].is_closed)
            continue;
        for (; at > 0 && parts[p].area > shells[at - 1]->area; at--)
            if (at < MAX_SHELLS)
                shells[at] = shells[at - 1];
        if (at < MAX_SHELLS)
            shells[at] = &parts[p];
        found += found < MAX_SHELLS;
    }
    return found;
}

static bool is_turned(const Part *part)
{
    return part->turns != (part->other > part->area / 2);
}

static void decide(Part *parts, uint32_t count, bool had_normals)
{
    for (uint32_t p = 0; p < count; p++) {
        Part *part = &parts[p];
        const int sign = find_sign(part);
        part->is_closed = sign != 0;
        part->turns = sign != 0 ? sign < 0
                      : had_normals && fabs(part->vote) > 0.02 * part->area
                          ? part->vote < 0
                          : part->other > part->area / 2;
    }
    const Part *shells[MAX_SHELLS];
    const int shell_count = find_shells(parts, count, shells);
    for (uint32_t p = 0; p < count; p++) {
        Part *part = &parts[p];
        for (int i = 0; i < shell_count && part->is_closed; i++) {
            if (!is_inside(part, shells[i]))
                continue;
            part->turns = is_turned(shells[i]) != (part->other > part->area / 2);
            break;
        }
    }
    for (uint32_t p = 0; p < count; p++) {
        parts[p].turns &= !parts[p].is_twisted;
        parts[p].turns_normals =
            had_normals && !parts[p].is_twisted && (parts[p].turns ? -1 : 1) * parts[p].vote < 0;
    }
}

/* number: of a triangle's part, [triangle_count] */
static void turn(GpMesh *mesh, const Part *parts, const uint32_t *number, const Forest *forest,
                 bool *done)
{
    bool odd, any = false;
    for (uint32_t t = 0; t < mesh->triangle_count; t++) {
        uint32_t *corner = mesh->indices + 3 * (size_t)t;
        const Part *part = &parts[number[t]];
        root_of(forest, t, &odd);
        for (int i = 0; i < 3 && part->turns_normals; i++) {
            float *normal = mesh->normals + 3 * (size_t)corner[i];
            for (int k = 0; k < 3 && !done[corner[i]]; k++)
                normal[k] = -normal[k];
            done[corner[i]] = true;
        }
        if (part->is_twisted || odd == part->turns)
            continue;
        const uint32_t second = corner[1];
        corner[1] = corner[2];
        corner[2] = second;
        any = true;
    }
    if (any && !mesh->had_normals)
        memset(mesh->normals, 0, 3 * (size_t)mesh->vertex_count * sizeof *mesh->normals);
}

/* Returns the number of parts; twisted triangles make their parts so. */
static uint32_t number_parts(const GpMesh *mesh, const Forest *forest, uint32_t *number)
{
    uint32_t count = 0;
    bool odd;
    for (uint32_t t = 0; t < mesh->triangle_count; t++) {
        const uint32_t root = root_of(forest, t, &odd); /* the first of its part */
        number[t] = root == t ? count++ : number[root];
    }
    return count;
}

static GpResult orient_parts(GpMesh *mesh, const Forest *forest, const bool *twisted,
                             uint32_t *number, bool *done, uint32_t *turned)
{
    const uint32_t count = number_parts(mesh, forest, number);
    Part *parts = gp_alloc(count, sizeof *parts);
    if (!parts)
        return GP_ERROR_MEMORY;
    for (uint32_t t = 0; t < mesh->triangle_count; t++) {
        bool odd;
        Part *part = &parts[number[t]];
        const bool begins = root_of(forest, t, &odd) == t;
        add_triangle(mesh, t, odd, begins, part);
        part->is_twisted |= twisted[t];
    }
    decide(parts, count, mesh->had_normals);
    turn(mesh, parts, number, forest, done);
    *turned = 0;
    for (uint32_t p = 0; p < count; p++)
        *turned += !parts[p].is_twisted && is_turned(&parts[p]);
    gp_free(parts);
    return mesh->had_normals ? GP_OK : gp_mesh_normals(mesh, false);
}

GpResult mesh_orient(GpMesh *mesh, uint32_t *turned)
{
    const size_t triangles = mesh->triangle_count;
    const Forest forest = { .parents = gp_alloc_unset(triangles * sizeof(uint32_t) + 1),
                            .odd = gp_alloc(triangles + 1, sizeof(bool)) };
    bool *twisted = gp_alloc(triangles + 1, sizeof *twisted);
    bool *done = gp_alloc(mesh->vertex_count + 1, sizeof *done);
    uint32_t *number = gp_alloc_unset(triangles * sizeof *number + 1);
    uint32_t *welded = NULL;
    GpResult result = GP_ERROR_MEMORY;
    if (forest.parents && forest.odd && twisted && done && number)
        result = corners_weld(mesh, &welded);
    const uint32_t *corners = welded ? welded : mesh->indices;
    for (uint32_t t = 0; result == GP_OK && t < triangles; t++)
        forest.parents[t] = t;
    if (result == GP_OK)
        result =
            edges_visit(mesh, corners, connect_edge, &(Connection){ corners, forest, twisted });
    gp_free(welded);
    if (result == GP_OK)
        result = orient_parts(mesh, &forest, twisted, number, done, turned);
    gp_free(forest.parents);
    gp_free(forest.odd);
    gp_free(twisted);
    gp_free(done);
    gp_free(number);
    return result;
}
