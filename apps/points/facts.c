#include "apps/points/facts.h"

#include "apps/points/edges.h"
#include "apps/points/triangle.h"

#include <string.h>

void facts_of_surfels(const Surfels *surfels, PointsFacts *facts)
{
    FactRange radius = { .least = (double)INFINITY };
    facts->count = surfels->count;
    facts->had_normals = surfels->had_normals;
    facts->had_radii = surfels->had_radii;
    facts->had_colors = surfels->had_colors;
    facts->area = 0;
    for (uint32_t i = 0; i < surfels->count; i++) {
        const Surfel *surfel = &surfels->surfels[i];
        for (int k = 0; k < 3; k++) {
            const float at = surfel->position[k];
            facts->low[k] = i == 0 || at < facts->low[k] ? at : facts->low[k];
            facts->high[k] = i == 0 || at > facts->high[k] ? at : facts->high[k];
        }
        radius.least = fmin(radius.least, (double)surfel->radius);
        radius.most = fmax(radius.most, (double)surfel->radius);
        radius.mean += (double)surfel->radius;
        facts->area += surfel_area(surfel);
    }
    radius.mean /= surfels->count;
    facts->radius = radius;
}

/* --- meshes ----------------------------------------------------------------------------------- */

static uint32_t root_of(uint32_t *parents, uint32_t vertex)
{
    while (parents[vertex] != vertex) {
        parents[vertex] = parents[parents[vertex]];
        vertex = parents[vertex];
    }
    return vertex;
}

typedef struct MeshWalk {
    uint32_t *parents;
    float *nearest2;   /* squared length of the shortest edge at a vertex */
    uint8_t *sides;    /* triangles at an edge, up to 2 */
    bool *is_boundary; /* of a vertex */
} MeshWalk;

static void walk_edges(const GpMesh *mesh, const Edges *edges, const MeshWalk *walk,
                       PointsFacts *facts)
{
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        walk->parents[v] = v;
        walk->nearest2[v] = INFINITY;
    }
    for (size_t s = 0; s < 3 * (size_t)mesh->triangle_count; s++)
        if (walk->sides[edges->of_side[s]] < 2)
            walk->sides[edges->of_side[s]]++;
    for (size_t e = 0; e < edges->count; e++) {
        const uint32_t *ends = edges->ends + 2 * e;
        const float length2 = (float)triangle_side(mesh->positions + 3 * (size_t)ends[0],
                                                   mesh->positions + 3 * (size_t)ends[1]);
        for (int i = 0; i < 2; i++) {
            if (length2 < walk->nearest2[ends[i]])
                walk->nearest2[ends[i]] = length2;
            walk->is_boundary[ends[i]] |= walk->sides[e] == 1;
        }
        const uint32_t a = root_of(walk->parents, ends[0]), b = root_of(walk->parents, ends[1]);
        walk->parents[a > b ? a : b] = a > b ? b : a;
    }
    facts->spacing = (FactRange){ .least = (double)INFINITY };
    facts->boundary = facts->components = 0;
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        const double nearest = sqrt((double)walk->nearest2[v]);
        facts->spacing.least = fmin(facts->spacing.least, nearest);
        facts->spacing.most = fmax(facts->spacing.most, nearest);
        facts->spacing.mean += nearest / mesh->vertex_count;
        facts->boundary += walk->is_boundary[v];
        facts->components += walk->parents[v] == v;
    }
}

GpResult facts_of_mesh(const GpMesh *mesh, PointsFacts *facts)
{
    Edges edges;
    if (edges_find(mesh, &edges) != GP_OK)
        return GP_ERROR_MEMORY;
    const size_t count = mesh->vertex_count;
    MeshWalk walk = { .parents = gp_alloc(count, sizeof(uint32_t)),
                      .nearest2 = gp_alloc(count, sizeof(float)),
                      .sides = gp_alloc(edges.count, 1),
                      .is_boundary = gp_alloc(count, sizeof(bool)) };
    const bool has_room = walk.parents && walk.nearest2 && walk.sides && walk.is_boundary;
    if (has_room)
        walk_edges(mesh, &edges, &walk, facts);
    gp_free(walk.parents);
    gp_free(walk.nearest2);
    gp_free(walk.sides);
    gp_free(walk.is_boundary);
    edges_free(&edges);
    return has_room ? GP_OK : GP_ERROR_MEMORY;
}

/* --- clouds ----------------------------------------------------------------------------------- */

void facts_of_cloud(const CloudFacts *cloud, const GpPoints *points, uint32_t surfels,
                    PointsFacts *facts)
{
    facts->left_out = cloud->duplicates;
    facts->normals_made = cloud->planes.estimated;
    facts->normals_undefined = cloud->planes.undefined;
    facts->zero_normals = cloud->zero_normals;
    facts->radii_made = points->radii ? cloud->zero_radii : surfels;
    facts->spacing = (FactRange){ .least = cloud->cells.nearest_least,
                                  .mean = cloud->cells.nearest_sum / surfels,
                                  .most = cloud->cells.nearest_most };
    facts->boundary = cloud->cells.boundary;
    facts->components = cloud->planes.components;
}

/* --- the report ------------------------------------------------------------------------------- */

static void add_count(Text *lines, const char *what, uint32_t count, const char *unit)
{
    char number[32];
    text_for_people(count, 12, number);
    text_add(lines, "%s%s%s", what, number, unit);
}

static void tell_source(const PointsFacts *facts, Text *lines)
{
    add_count(lines, "points ", facts->count, "");
    if (facts->triangles > 0) {
        add_count(lines, facts->sampled ? " spread over " : ", vertices of ", facts->triangles,
                  " triangles");
        if (facts->subdivided > 0)
            add_count(lines, " subdivided ", facts->subdivided,
                      facts->subdivided == 1 ? " time" : " times");
    }
    add_count(lines, "; the file has ", facts->read, facts->triangles ? " vertices" : " points");
    if (facts->left_out > 0)
        add_count(lines, ", ", facts->left_out,
                  facts->triangles ? " of no triangle left out"
                                   : " at the place of another left out");
    if (facts->turned > 0)
        add_count(lines, "; ", facts->turned,
                  facts->turned == 1 ? " part turned inside out" : " parts turned inside out");
    if (facts->split > 0)
        add_count(lines, "; ", facts->split, " more for the sides of creases");
    text_add(lines, "\n");
}

static void tell_made(const PointsFacts *facts, Text *lines)
{
    text_add(lines, "normals ");
    if (facts->triangles > 0)
        text_add(lines, facts->had_normals ? "of the file" : "of the triangles");
    else if (facts->normals_made == 0)
        text_add(lines, "of the file");
    else
        add_count(lines, "", facts->normals_made, " estimated");
    if (facts->zero_normals > 0)
        add_count(lines, ", which were zero in the file: ", facts->zero_normals, "");
    if (facts->normals_undefined > 0)
        add_count(lines, ", ", facts->normals_undefined, " on a line");
    if (facts->radii_made == 0)
        text_add(lines, "; radii of the file");
    else
        add_count(lines, "; radii ", facts->radii_made, " estimated");
    text_add(lines, "; colours %s\n", facts->had_colors ? "of the file" : "white");
}

static void tell_range(const char *name, const FactRange *range, Text *lines)
{
    char least[32], mean[32], most[32];
    text_for_people(range->least, 4, least);
    text_for_people(range->mean, 4, mean);
    text_for_people(range->most, 4, most);
    text_add(lines, "%s %s, from %s to %s\n", name, mean, least, most);
}

static json_t *range_json(const FactRange *range)
{
    return json_pack("{s:f, s:f, s:f}", "min", range->least, "mean", range->mean, "max",
                     range->most);
}

static void fill_json(const PointsFacts *facts, json_t *members)
{
    const struct {
        const char *name;
        uint32_t value;
    } counts[] = {
        { "points", facts->count },
        { "read", facts->read },
        { "triangles", facts->triangles },
        { "left_out", facts->left_out },
        { "turned", facts->turned },
        { "split", facts->split },
        { "subdivided", facts->subdivided },
        { "sampled", facts->sampled },
        { "normals_estimated", facts->normals_made },
        { "normals_undefined", facts->normals_undefined },
        { "zero_normals", facts->zero_normals },
        { "radii_estimated", facts->radii_made },
        { "boundary_points", facts->boundary },
        { "components", facts->components },
    };
    for (size_t i = 0; i < GP_COUNT(counts); i++)
        json_object_set_new(members, counts[i].name, json_integer((json_int_t)counts[i].value));
    json_object_set_new(members, "had_normals", json_boolean(facts->had_normals));
    json_object_set_new(members, "had_radii", json_boolean(facts->had_radii));
    json_object_set_new(members, "had_colors", json_boolean(facts->had_colors));
    json_object_set_new(
        members, "box",
        json_pack("[o, o]", json_floats(facts->low, 3), json_floats(facts->high, 3)));
    json_object_set_new(members, "spacing", range_json(&facts->spacing));
    json_object_set_new(members, "radius", range_json(&facts->radius));
    json_object_set_new(members, "area", json_real(facts->area));
}

void facts_report(const PointsFacts *facts, Text *lines, json_t *members)
{
    char area[32];
    tell_source(facts, lines);
    tell_made(facts, lines);
    text_add(lines, "box (%g, %g, %g) to (%g, %g, %g)\n", (double)facts->low[0],
             (double)facts->low[1], (double)facts->low[2], (double)facts->high[0],
             (double)facts->high[1], (double)facts->high[2]);
    tell_range("spacing", &facts->spacing, lines);
    tell_range("radius", &facts->radius, lines);
    text_for_people(facts->area, 4, area);
    text_add(lines, "area %s\n", area);
    add_count(lines, "boundary ", facts->boundary, facts->boundary == 1 ? " point" : " points");
    add_count(lines, " at an edge or a hole; ", facts->components,
              facts->components == 1 ? " component\n" : " components\n");
    if (members)
        fill_json(facts, members);
}
