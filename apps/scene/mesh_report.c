#include "apps/scene/mesh_report.h"

#include "apps/base/mesh_places.h"
#include "apps/base/vector.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- values in groups ------------------------------------------------------------------------- */

/* Up to three values a triangle, each of a group: sorted by group and, within it, by value. They
 * are listed twice, to be counted and to be put in their places, which takes less than to keep the
 * list. */
typedef struct Groups {
    uint32_t group_count;
    /* [group_count + 2] of each group in sorted; while they are listed, one further */
    uint32_t *begin;
    uint64_t *sorted;
    bool puts;
} Groups;

static void add(Groups *groups, uint32_t group, uint64_t value)
{
    if (groups->puts)
        groups->sorted[groups->begin[group + 1]++] = value;
    else
        groups->begin[group + 2]++;
}

static int compare_values(const void *a, const void *b)
{
    const uint64_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* Most groups have a handful. */
static void sort_values(uint64_t *values, uint32_t count)
{
    enum { FEW = 16 };
    if (count > FEW) {
        qsort(values, count, sizeof *values, compare_values);
        return;
    }
    for (uint32_t i = 1; i < count; i++) {
        const uint64_t value = values[i];
        uint32_t at = i;
        for (; at > 0 && values[at - 1] > value; at--)
            values[at] = values[at - 1];
        values[at] = value;
    }
}

/* --- triangles -------------------------------------------------------------------------------- */

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
                       Groups *groups)
{
    for (size_t i = 0; i < triangle_count; i++) {
        uint32_t corner[3];
        places_of(place_of, indices + 3 * i, corner);
        for (int c = 0; c < 3 && has_three_corners(corner); c++) {
            uint32_t from = corner[c], to = corner[(c + 1) % 3];
            bool turned = from > to;
            add(groups, turned ? to : from, (uint64_t)(turned ? from : to) << 1 | turned);
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
                           uint32_t triangle_count, Groups *groups)
{
    for (size_t i = 0; i < triangle_count; i++) {
        uint32_t corner[3];
        places_of(place_of, indices + 3 * i, corner);
        put_in_order(&corner[0], &corner[1]);
        put_in_order(&corner[1], &corner[2]);
        put_in_order(&corner[0], &corner[1]);
        add(groups, corner[0], (uint64_t)corner[1] << 32 | corner[2]);
    }
}

typedef void List(const uint32_t *place_of, const uint32_t *indices, uint32_t triangle_count,
                  Groups *groups);

static void sort_groups(List *list, const uint32_t *place_of, const uint32_t *indices,
                        uint32_t triangle_count, Groups *groups)
{
    const uint32_t group_count = groups->group_count;
    memset(groups->begin, 0, ((size_t)group_count + 2) * sizeof *groups->begin);
    groups->puts = false;
    list(place_of, indices, triangle_count, groups);
    for (uint32_t g = 0; g < group_count; g++)
        groups->begin[g + 2] += groups->begin[g + 1];
    groups->puts = true;
    list(place_of, indices, triangle_count, groups);
    for (uint32_t g = 0; g < group_count; g++)
        sort_values(groups->sorted + groups->begin[g], groups->begin[g + 1] - groups->begin[g]);
}

static void count_edge(uint64_t ways[2], MeshReport *report)
{
    uint64_t triangles = ways[0] + ways[1];
    report->edges++;
    report->boundary_edges += triangles == 1;
    report->non_manifold_edges += triangles > 2;
    report->odd_edges += triangles % 2;
    report->inconsistent_edges += triangles == 2 && ways[0] != 1;
    report->unbalanced_edges += ways[0] != ways[1];
}

static void count_edges(const Groups *groups, MeshReport *report)
{
    for (uint32_t g = 0; g < groups->group_count; g++)
        for (uint32_t i = groups->begin[g], end = groups->begin[g + 1]; i < end;) {
            uint64_t edge = groups->sorted[i] >> 1, ways[2] = { 0 };
            for (; i < end && groups->sorted[i] >> 1 == edge; i++)
                ways[groups->sorted[i] & 1]++;
            count_edge(ways, report);
        }
}

static void count_duplicates(const Groups *groups, MeshReport *report)
{
    for (uint32_t g = 0; g < groups->group_count; g++)
        for (uint32_t i = groups->begin[g] + 1; i < groups->begin[g + 1]; i++)
            report->duplicates += groups->sorted[i] == groups->sorted[i - 1];
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

GpResult mesh_report(const float *positions, uint32_t vertex_count, const uint32_t *indices,
                     uint32_t triangle_count, MeshReport *report)
{
    MeshReport found = { .edges = 0 };
    uint32_t *place_of = gp_alloc(vertex_count, sizeof *place_of);
    const size_t corners = 3 * (size_t)triangle_count;
    Groups groups = { .group_count = vertex_count,
                      .begin = gp_alloc((size_t)vertex_count + 2, sizeof *groups.begin),
                      .sorted = gp_alloc(corners, sizeof *groups.sorted) };
    GpResult result = place_of && groups.begin && groups.sorted
                          ? mesh_places(positions, vertex_count, place_of)
                          : GP_ERROR_MEMORY;
    if (!result) {
        sort_groups(list_edges, place_of, indices, triangle_count, &groups);
        count_edges(&groups, &found);
        sort_groups(list_triangles, place_of, indices, triangle_count, &groups);
        count_duplicates(&groups, &found);
    }
    if (!result && triangle_count > 0)
        measure(positions, indices, triangle_count, &found);
    gp_free(place_of);
    gp_free(groups.begin);
    gp_free(groups.sorted);
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
