#include "apps/points/open.h"

#include "apps/points/clips.h"
#include "apps/points/creases.h"
#include "apps/points/orient.h"
#include "apps/points/sample.h"
#include "apps/points/subdivide.h"
#include "apps/points/vertices.h"
#include "pipeline/io/file.h"
#include "pipeline/io/mesh/mesh_file.h"

/* What is being made, and of what. */
typedef struct Opening {
    const PointsSource *source;
    const char *name;
    GpPool *pool;
    GpError *error;
    bool wants_facts;
    Surfels surfels;
    PointsFacts facts;
} Opening;

/* A result of what gives no message itself. */
static GpResult tell(const Opening *opening, GpResult result)
{
    if (result == GP_ERROR_MEMORY)
        return gp_fail(opening->error, result, "%s: no memory for the points", opening->name);
    if (result == GP_ERROR_UNSUPPORTED)
        return gp_fail(opening->error, result, "%s: that would be too many points", opening->name);
    return result;
}

/* --- points ----------------------------------------------------------------------------------- */

static GpResult open_points(Opening *opening, const GpPoints *points)
{
    CloudFacts cloud;
    const GpResult result =
        surfels_of_points(points, opening->wants_facts, opening->pool, &opening->surfels, &cloud);
    if (result == GP_ERROR_INVALID)
        return gp_fail(opening->error, GP_ERROR_FORMAT,
                       "%s: %u point%s at one place, without a radius: expected two places, or the "
                       "property radius",
                       opening->name, points->count, points->count == 1 ? "" : "s");
    if (result != GP_OK)
        return tell(opening, result);
    opening->facts.read = points->count;
    facts_of_cloud(&cloud, points, opening->surfels.count, &opening->facts);
    return GP_OK;
}

static GpResult open_cloud(Opening *opening, const GpPoints *points)
{
    if (opening->source->sample || opening->source->subdivide)
        return gp_fail(opening->error, GP_ERROR_INVALID,
                       "%s: only a mesh can be subdivided or sampled, and this has no faces",
                       opening->name);
    return open_points(opening, points);
}

/* --- meshes ----------------------------------------------------------------------------------- */

static GpResult open_samples(Opening *opening, const GpMesh *mesh)
{
    GpPoints points;
    const PointsFacts of_mesh = opening->facts;
    GpResult result = tell(opening, mesh_sample(mesh, opening->source->sample, &points));
    if (result == GP_ERROR_INVALID)
        return gp_fail(opening->error, result, "%s: %u points are more than can be sampled, 2^30",
                       opening->name, opening->source->sample);
    if (result != GP_OK)
        return result;
    result = open_points(opening, &points);
    gp_points_free(&points);
    opening->surfels.had_normals = mesh->had_normals;
    opening->facts.sampled = opening->surfels.count;
    opening->facts.read = of_mesh.read;
    opening->facts.left_out = of_mesh.left_out;
    return result;
}

static GpResult open_vertices(Opening *opening, const GpMesh *mesh)
{
    GpResult result = surfels_of_vertices(mesh, opening->source->each_radius, &opening->surfels);
    if (result == GP_OK && opening->source->sharp > 0)
        result = surfels_clip(mesh, opening->source->sharp, &opening->surfels);
    if (result == GP_OK && opening->wants_facts)
        result = facts_of_mesh(mesh, &opening->facts);
    opening->facts.normals_made = mesh->had_normals ? 0 : mesh->vertex_count;
    opening->facts.radii_made = mesh->vertex_count;
    return tell(opening, result);
}

/* mesh: is freed */
static GpResult open_prepared(Opening *opening, GpMesh *mesh)
{
    GpResult result = GP_OK;
    for (uint32_t i = 0; i < opening->source->subdivide && result == GP_OK; i++) {
        GpMesh finer;
        result = tell(opening, mesh_subdivide(mesh, &finer));
        if (result != GP_OK)
            break;
        gp_mesh_free(mesh);
        *mesh = finer;
    }
    if (result == GP_OK)
        result =
            opening->source->sample ? open_samples(opening, mesh) : open_vertices(opening, mesh);
    gp_mesh_free(mesh);
    return result;
}

GpResult points_surface(const PointsSource *source, GpMesh *mesh, PointsFacts *facts)
{
    const uint32_t vertices = mesh->vertex_count, triangles = mesh->triangle_count;
    uint32_t turned = 0;
    GpResult result = mesh_keep_referenced(mesh);
    const uint32_t used = mesh->vertex_count;
    if (result == GP_OK)
        result = mesh_orient(mesh, &turned);
    if (result == GP_OK && (source->sharp > 0 || source->sample))
        result = mesh_split_creases(mesh, source->sharp > 0 ? source->sharp : CREASE_DEGREES);
    if (result != GP_OK)
        return result;
    facts->read = vertices;
    facts->triangles = triangles;
    facts->left_out = vertices - used;
    facts->turned = turned;
    facts->split = mesh->vertex_count - used;
    return GP_OK;
}

/* mesh: is freed */
static GpResult open_mesh(Opening *opening, GpMesh *mesh)
{
    GpResult result = tell(opening, points_surface(opening->source, mesh, &opening->facts));
    if (result == GP_OK && !mesh_has_area(mesh))
        result =
            gp_fail(opening->error, GP_ERROR_FORMAT, "%s: no triangle with an area", opening->name);
    if (result != GP_OK) {
        gp_mesh_free(mesh);
        return result;
    }
    opening->facts.subdivided = opening->source->subdivide;
    return open_prepared(opening, mesh);
}

static GpResult open_copy(Opening *opening, const GpMesh *mesh)
{
    GpMesh copy;
    const GpResult result = tell(opening, mesh_copy(mesh, &copy));
    return result == GP_OK ? open_mesh(opening, &copy) : result;
}

/* --- files ------------------------------------------------------------------------------------ */

/* Vertices without faces, as OFF and OBJ files may have them. owns: points borrows the arrays but
 * for the colours */
static GpResult open_lone_vertices(Opening *opening, const GpMesh *mesh)
{
    GpPoints points = { .positions = mesh->positions,
                        .normals = mesh->had_normals ? mesh->normals : NULL,
                        .colors = mesh->colors ? gp_alloc(mesh->vertex_count, 3) : NULL,
                        .count = mesh->vertex_count };
    if (mesh->colors && !points.colors)
        return tell(opening, GP_ERROR_MEMORY);
    for (size_t i = 0; mesh->colors && i < 3 * (size_t)mesh->vertex_count; i++)
        points.colors[i] = color_byte(mesh->colors[i / 3 * 4 + i % 3]);
    const GpResult result = open_cloud(opening, &points);
    gp_free(points.colors);
    return result;
}

static GpResult open_mesh_file(Opening *opening, const char *path)
{
    GpMesh mesh;
    GpResult result = gp_mesh_read(path, GP_MESH_ALLOW_POINTS, &mesh, opening->error);
    if (result != GP_OK)
        return result;
    if (mesh.triangle_count > 0)
        return open_mesh(opening, &mesh);
    result = open_lone_vertices(opening, &mesh);
    gp_mesh_free(&mesh);
    return result;
}

static GpResult open_file(Opening *opening)
{
    char path[4096];
    const char *name = opening->source->path;
    if (!gp_points_is_readable(name) && !gp_mesh_is_readable(name))
        return gp_fail(opening->error, GP_ERROR_UNSUPPORTED,
                       "%s: expected a name that ends with .ply, .xyz, .xyzn, .xyzrgb, .pts, .asc, "
                       ".txt, .off, .obj, .stl or .om",
                       name);
    GpResult result = gp_data_find(name, path, sizeof path, opening->error);
    if (result != GP_OK)
        return result;
    if (!gp_points_is_readable(path))
        return open_mesh_file(opening, path);
    GpPoints points;
    result = gp_points_read(path, &points, opening->error);
    if (result != GP_OK)
        return result;
    const bool is_mesh = points.face_count > 0;
    if (!is_mesh)
        result = open_cloud(opening, &points);
    gp_points_free(&points);
    return is_mesh ? open_mesh_file(opening, path) : result;
}

GpResult points_open(const PointsSource *source, GpPool *pool, Surfels *surfels, PointsFacts *facts,
                     GpError *error)
{
    GP_ASSERT((source->path != NULL) + (source->mesh != NULL) + (source->points != NULL) == 1);
    Opening opening = { .source = source,
                        .name = source->path   ? source->path
                                : source->name ? source->name
                                               : "the model",
                        .pool = pool,
                        .error = error,
                        .wants_facts = facts != NULL };
    const GpResult result = source->path   ? open_file(&opening)
                            : source->mesh ? open_copy(&opening, source->mesh)
                                           : open_cloud(&opening, source->points);
    if (result != GP_OK) {
        surfels_free(&opening.surfels);
        return result;
    }
    if (facts) {
        facts_of_surfels(&opening.surfels, &opening.facts);
        *facts = opening.facts;
    }
    *surfels = opening.surfels;
    return GP_OK;
}
