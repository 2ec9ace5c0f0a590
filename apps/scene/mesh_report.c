#include "apps/scene/mesh_report.h"

#include "apps/base/vector.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- vertices at the same place --------------------------------------------------------------- */

typedef struct Place {
    float position[3];
    uint32_t vertex;
} Place;

static int compare_places(const void *a, const void *b)
{
    const Place *p = a, *q = b;
    for (int k = 0; k < 3; k++)
        if (p->position[k] != q->position[k])
            return p->position[k] < q->position[k] ? -1 : 1;
    return 0;
}

/* Numbers the places: out place_of: [vertex_count]. errors GP_ERROR_MEMORY */
static GpResult find_places(const float *positions, uint32_t vertex_count, uint32_t *place_of)
{
    Place *places = gp_alloc(vertex_count, sizeof *places);
    if (!places)
        return GP_ERROR_MEMORY;
    for (uint32_t i = 0; i < vertex_count; i++) {
        memcpy(places[i].position, positions + 3 * (size_t)i, sizeof places[i].position);
        places[i].vertex = i;
    }
    qsort(places, vertex_count, sizeof *places, compare_places);
    uint32_t number = 0;
    for (uint32_t i = 0; i < vertex_count; i++) {
        number += i > 0 && compare_places(&places[i - 1], &places[i]) != 0;
        place_of[places[i].vertex] = number;
    }
    gp_free(places);
    return GP_OK;
}

/* --- values in groups ------------------------------------------------------------------------- */

/* Values sorted by a group and, within it, by value: [group_count + 1] begins, [count] values. */
typedef struct Groups {
    uint32_t count;
    uint32_t *begin;
    uint64_t *values;
} Groups;

static void groups_free(Groups *groups)
{
    gp_free(groups->begin);
    gp_free(groups->values);
}

static int compare_values(const void *a, const void *b)
{
    const uint64_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* in     group_of: [count], all < group_count. owns: the caller, until groups_free, always
 * errors GP_ERROR_MEMORY */
static GpResult make_groups(const uint32_t *group_of, const uint64_t *values, size_t count,
                            uint32_t group_count, Groups *groups)
{
    *groups = (Groups){ group_count, gp_alloc((size_t)group_count + 2, sizeof *groups->begin),
                        gp_alloc(count, sizeof *groups->values) };
    uint32_t *next = groups->begin + 1; /* where a group's next value goes; at last, its end */
    if (!groups->begin || !groups->values)
        return GP_ERROR_MEMORY;
    for (size_t i = 0; i < count; i++)
        next[group_of[i] + 1]++;
    for (uint32_t g = 0; g < group_count; g++)
        next[g + 1] += next[g];
    for (size_t i = 0; i < count; i++)
        groups->values[next[group_of[i]]++] = values[i];
    for (uint32_t g = 0; g < group_count; g++)
        qsort(groups->values + groups->begin[g], groups->begin[g + 1] - groups->begin[g],
              sizeof *values, compare_values);
    return GP_OK;
}

/* --- triangles -------------------------------------------------------------------------------- */

/* What is grouped: up to three values a triangle. */
typedef struct List {
    uint32_t *group_of;
    uint64_t *values;
    size_t count;
} List;

static void add(List *list, uint32_t group, uint64_t value)
{
    list->group_of[list->count] = group;
    list->values[list->count++] = value;
}

static bool has_three_corners(const uint32_t corner[3])
{
    return corner[0] != corner[1] && corner[1] != corner[2] && corner[2] != corner[0];
}

static void places_of(const uint32_t *place_of, const uint32_t *index, uint32_t corner[3])
{
    for (int c = 0; c < 3; c++)
        corner[c] = place_of[index[c]];
}

static void list_edges(const uint32_t *place_of, const uint32_t *indices, uint32_t triangle_count,
                       List *list)
{
    list->count = 0;
    for (size_t i = 0; i < triangle_count; i++) {
        uint32_t corner[3];
        places_of(place_of, indices + 3 * i, corner);
        for (int c = 0; c < 3 && has_three_corners(corner); c++) {
            uint32_t from = corner[c], to = corner[(c + 1) % 3];
            bool turned = from > to;
            add(list, turned ? to : from, (uint64_t)(turned ? from : to) << 1 | turned);
        }
    }
}

static void put_in_order(uint32_t *a, uint32_t *b)
{
    uint32_t low = *a < *b ? *a : *b, high = *a < *b ? *b : *a;
    *a = low;
    *b = high;
}

static void list_triangles(const uint32_t *place_of, const uint32_t *indices,
                           uint32_t triangle_count, List *list)
{
    list->count = 0;
    for (size_t i = 0; i < triangle_count; i++) {
        uint32_t corner[3];
        places_of(place_of, indices + 3 * i, corner);
        put_in_order(&corner[0], &corner[1]);
        put_in_order(&corner[1], &corner[2]);
        put_in_order(&corner[0], &corner[1]);
        add(list, corner[0], (uint64_t)corner[1] << 32 | corner[2]);
    }
}

static void count_edge(uint64_t ways[2], MeshReport *report)
{
    uint64_t triangles = ways[0] + ways[1];
    report->edges++;
    report->boundary_edges += triangles == 1;
    report->non_manifold_edges += triangles > 2;
    report->odd_edges += triangles % 2;
    report->inconsistent_edges += triangles == 2 && ways[0] != 1;
}

static void count_edges(const Groups *groups, MeshReport *report)
{
    for (uint32_t g = 0; g < groups->count; g++)
        for (uint32_t i = groups->begin[g], end = groups->begin[g + 1]; i < end;) {
            uint64_t edge = groups->values[i] >> 1, ways[2] = { 0 };
            for (; i < end && groups->values[i] >> 1 == edge; i++)
                ways[groups->values[i] & 1]++;
            count_edge(ways, report);
        }
}

static void count_duplicates(const Groups *groups, MeshReport *report)
{
    for (uint32_t g = 0; g < groups->count; g++)
        for (uint32_t i = groups->begin[g] + 1; i < groups->begin[g + 1]; i++)
            report->duplicates += groups->values[i] == groups->values[i - 1];
}

/* Six times the volume of the triangles' cones over the first vertex; and triangles without area.
 * Differences of floats of like size, and the products' sums, are exact in double. */
static void measure(const float *positions, const uint32_t *indices, uint32_t triangle_count,
                    MeshReport *report)
{
    double origin[3], sum = 0;
    for (size_t k = 0; k < 3; k++)
        origin[k] = (double)positions[3 * (size_t)indices[0] + k];
    for (size_t i = 0; i < triangle_count; i++) {
        double corner[3][3], side[2][3], normal[3], from[3];
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++)
                corner[c][k] =
                    (double)positions[3 * (size_t)indices[3 * i + (size_t)c] + (size_t)k];
        vector_subtract(corner[1], corner[0], side[0]);
        vector_subtract(corner[2], corner[0], side[1]);
        vector_cross(side[0], side[1], normal);
        vector_subtract(corner[0], origin, from);
        report->degenerate += normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
        sum += vector_dot(normal, from);
    }
    report->volume = sum / 6;
}

static GpResult count_all(const uint32_t *place_of, uint32_t vertex_count, const uint32_t *indices,
                          uint32_t triangle_count, List *list, MeshReport *report)
{
    Groups groups;
    list_edges(place_of, indices, triangle_count, list);
    GpResult result = make_groups(list->group_of, list->values, list->count, vertex_count, &groups);
    if (!result)
        count_edges(&groups, report);
    groups_free(&groups);
    if (result)
        return result;
    list_triangles(place_of, indices, triangle_count, list);
    result = make_groups(list->group_of, list->values, list->count, vertex_count, &groups);
    if (!result)
        count_duplicates(&groups, report);
    groups_free(&groups);
    return result;
}

GpResult mesh_report(const float *positions, uint32_t vertex_count, const uint32_t *indices,
                     uint32_t triangle_count, MeshReport *report)
{
    MeshReport found = { .edges = 0 };
    uint32_t *place_of = gp_alloc(vertex_count, sizeof *place_of);
    List list = { gp_alloc(3 * (size_t)triangle_count, sizeof *list.group_of),
                  gp_alloc(3 * (size_t)triangle_count, sizeof *list.values), 0 };
    GpResult result = place_of && list.group_of && list.values ? GP_OK : GP_ERROR_MEMORY;
    if (!result)
        result = find_places(positions, vertex_count, place_of);
    if (!result)
        result = count_all(place_of, vertex_count, indices, triangle_count, &list, &found);
    if (!result && triangle_count > 0)
        measure(positions, indices, triangle_count, &found);
    gp_free(place_of);
    gp_free(list.group_of);
    gp_free(list.values);
    if (result)
        return result;
    found.is_closed = found.edges > 0 && !found.boundary_edges && !found.non_manifold_edges &&
                      !found.inconsistent_edges;
    found.is_inside_out = found.is_closed && found.volume < 0;
    *report = found;
    return GP_OK;
}

void mesh_report_faults(const MeshReport *report, char *text, size_t size)
{
    const struct {
        uint64_t count;
        const char *what;
    } faults[] = { { report->boundary_edges, "boundary" },
                   { report->non_manifold_edges, "non-manifold" },
                   { report->inconsistent_edges, "inconsistently oriented" } };
    size_t used = 0;
    snprintf(text, size, "no triangle with three corners");
    for (size_t i = 0; i < GP_COUNT(faults) && used < size; i++)
        if (faults[i].count > 0)
            used += (size_t)snprintf(text + used, size - used, "%s%llu %s edge%s", used ? ", " : "",
                                     (unsigned long long)faults[i].count, faults[i].what,
                                     faults[i].count == 1 ? "" : "s");
}
