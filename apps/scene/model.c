#include "apps/scene/model.h"

#include "apps/points/open.h"
#include "pipeline/io/file.h"

#include <string.h>

const char *model_after(const char *name, const char *prefix)
{
    const size_t length = strlen(prefix);
    return strncmp(name, prefix, length) == 0 ? name + length : NULL;
}

static GpResult read_file(const char *scene, const char *name, unsigned flags, GpMesh *mesh,
                          GpError *error)
{
    char path[4096];
    GpResult result = gp_data_find_beside(scene, name, path, sizeof path, error);
    return result ? result : gp_mesh_read(path, flags, mesh, error);
}

static GpResult make_builtin(const char *name, bool points, Shape *shape, GpError *error)
{
    GpResult result = points ? shape_create_points(name, shape) : shape_create(name, shape);
    if (result == GP_ERROR_INVALID)
        return gp_fail(error, result, "no builtin %s '%.40s'", points ? "points" : "mesh", name);
    return result ? gp_fail(error, result, "no memory") : GP_OK;
}

/* --- as a mesh -------------------------------------------------------------------------------- */

static GpResult mesh_of_shape(const Shape *shape, GpMesh *mesh)
{
    const uint32_t count = shape->vertex_count;
    *mesh = (GpMesh){ .positions = gp_alloc(count, 3 * sizeof(float)),
                      .normals = gp_alloc(count, 3 * sizeof(float)),
                      .colors = gp_alloc(count, 4 * sizeof(float)),
                      .indices = gp_alloc(shape->index_count, sizeof(uint32_t)),
                      .vertex_count = count,
                      .triangle_count = shape->index_count / 3,
                      .had_normals = true };
    if (!mesh->positions || !mesh->normals || !mesh->colors || !mesh->indices) {
        gp_mesh_free(mesh);
        return GP_ERROR_MEMORY;
    }
    for (uint32_t i = 0; i < count; i++) {
        const ShapeVertex *vertex = &shape->vertices[i];
        memcpy(mesh->positions + 3 * (size_t)i, vertex->position, sizeof vertex->position);
        memcpy(mesh->normals + 3 * (size_t)i, vertex->normal, sizeof vertex->normal);
        memcpy(mesh->colors + 4 * (size_t)i, vertex->color, sizeof vertex->color);
    }
    memcpy(mesh->indices, shape->indices, shape->index_count * sizeof *mesh->indices);
    return GP_OK;
}

GpResult model_mesh(const char *name, GpMesh *mesh, GpError *error)
{
    const char *builtin = model_after(name, "builtin:");
    if (!builtin)
        return read_file(NULL, name, GP_MESH_ALLOW_POINTS, mesh, error);
    Shape shape;
    GpResult result = make_builtin(builtin, false, &shape, error);
    if (result)
        return result;
    result = mesh_of_shape(&shape, mesh);
    shape_free(&shape);
    return result ? gp_fail(error, result, "%.200s: no memory", name) : GP_OK;
}

/* --- as depth images -------------------------------------------------------------------------- */

GpResult model_depth_images(const char *name, DepthModel *images, GpError *error)
{
    char path[4096];
    const GpResult result = gp_data_find(name, path, sizeof path, error);
    return result ? result : depth_file_read(path, images, error);
}

/* --- as points -------------------------------------------------------------------------------- */

GpResult model_points(const char *builtin, GpPoints *points, GpError *error)
{
    Shape shape;
    GpResult result = make_builtin(builtin, true, &shape, error);
    if (result)
        return result;
    GpPoints made = { .positions = gp_alloc(shape.vertex_count, 3 * sizeof(float)),
                      .normals = gp_alloc(shape.vertex_count, 3 * sizeof(float)),
                      .count = shape.vertex_count };
    if (made.positions && made.normals) {
        for (size_t i = 0; i < made.count; i++) {
            memcpy(made.positions + 3 * i, shape.vertices[i].position, 3 * sizeof(float));
            memcpy(made.normals + 3 * i, shape.vertices[i].normal, 3 * sizeof(float));
        }
        *points = made;
    } else {
        gp_points_free(&made);
        result = gp_fail(error, GP_ERROR_MEMORY, "builtin:points/%.40s: no memory", builtin);
    }
    shape_free(&shape);
    return result;
}

/* --- as a shape ------------------------------------------------------------------------------- */

/* Files have v = 0 at the bottom of a picture. */
static void copy_vertex(const GpMesh *mesh, uint32_t i, ShapeVertex *vertex)
{
    *vertex = (ShapeVertex){ .color = { 1, 1, 1, 1 } };
    memcpy(vertex->position, mesh->positions + 3 * (size_t)i, sizeof vertex->position);
    memcpy(vertex->normal, mesh->normals + 3 * (size_t)i, sizeof vertex->normal);
    if (mesh->colors)
        memcpy(vertex->color, mesh->colors + 4 * (size_t)i, sizeof vertex->color);
    if (mesh->texcoords) {
        vertex->texcoord[0] = mesh->texcoords[2 * (size_t)i];
        vertex->texcoord[1] = 1 - mesh->texcoords[2 * (size_t)i + 1];
    }
}

/* Takes the mesh's indices with it. */
static GpResult shape_of_mesh(GpMesh *mesh, bool points, Shape *shape)
{
    ShapeVertex *vertices = gp_alloc(mesh->vertex_count, sizeof *vertices);
    if (!vertices)
        return GP_ERROR_MEMORY;
    for (uint32_t i = 0; i < mesh->vertex_count; i++)
        copy_vertex(mesh, i, &vertices[i]);
    *shape = (Shape){ .vertices = vertices, .vertex_count = mesh->vertex_count };
    if (!points) {
        shape->indices = mesh->indices;
        shape->index_count = 3 * mesh->triangle_count;
        mesh->indices = NULL;
    }
    return GP_OK;
}

GpResult model_shape(const char *scene, const char *name, bool points, Shape *shape, GpError *error)
{
    const char *builtin = model_after(name, "builtin:");
    if (builtin)
        return make_builtin(builtin, points, shape, error);
    GpMesh mesh = { 0 };
    GpResult result = read_file(scene, name, points ? GP_MESH_ALLOW_POINTS : 0, &mesh, error);
    if (result)
        return result;
    result = shape_of_mesh(&mesh, points, shape);
    gp_mesh_free(&mesh);
    return result ? gp_fail(error, result, "%.200s: no memory", name) : GP_OK;
}

/* --- as surfels ------------------------------------------------------------------------------- */

static GpResult points_of_shape(const Shape *shape, GpPoints *points)
{
    const uint32_t count = shape->vertex_count;
    *points = (GpPoints){ .positions = gp_alloc(count, 3 * sizeof(float)),
                          .normals = gp_alloc(count, 3 * sizeof(float)),
                          .count = count };
    if (!points->positions || !points->normals) {
        gp_points_free(points);
        return GP_ERROR_MEMORY;
    }
    for (uint32_t i = 0; i < count; i++) {
        const ShapeVertex *vertex = &shape->vertices[i];
        memcpy(points->positions + 3 * (size_t)i, vertex->position, sizeof vertex->position);
        memcpy(points->normals + 3 * (size_t)i, vertex->normal, sizeof vertex->normal);
    }
    return GP_OK;
}

static GpResult builtin_points(const char *name, GpPoints *points, GpError *error)
{
    Shape shape;
    GpResult result = make_builtin(name, true, &shape, error);
    if (result)
        return result;
    result = points_of_shape(&shape, points);
    shape_free(&shape);
    return result ? gp_fail(error, result, "no memory") : GP_OK;
}

GpResult model_surfels(const char *scene, const char *name, bool points,
                       const ModelSampling *sampling, GpPool *pool, Surfels *surfels,
                       GpError *error)
{
    const char *builtin = model_after(name, "builtin:");
    GpPoints cloud = { .count = 0 };
    GpMesh mesh = { .vertex_count = 0 };
    PointsSource source = { .name = name,
                            .subdivide = sampling->subdivide,
                            .sample = sampling->sample,
                            .each_radius = true };
    char path[4096];
    GpResult result = !builtin ? gp_data_find_beside(scene, name, path, sizeof path, error)
                      : points ? builtin_points(builtin, &cloud, error)
                               : model_mesh(name, &mesh, error);
    source.path = builtin ? NULL : path;
    source.points = builtin && points ? &cloud : NULL;
    source.mesh = builtin && !points ? &mesh : NULL;
    if (!result)
        result = points_open(&source, pool, surfels, NULL, error);
    gp_points_free(&cloud);
    gp_mesh_free(&mesh);
    if (!result && builtin)
        surfels->had_colors = false; /* a shape is white where nothing else is said */
    return result;
}
