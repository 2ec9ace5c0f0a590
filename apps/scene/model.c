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

/* Takes what a mesh has of it. */
static GpMesh mesh_of_shape(Shape *shape)
{
    const GpMesh mesh = { .positions = shape->positions,
                          .normals = shape->normals,
                          .colors = shape->colors,
                          .indices = shape->indices,
                          .vertex_count = shape->vertex_count,
                          .triangle_count = shape->index_count / 3,
                          .had_normals = true };
    shape->positions = shape->normals = shape->colors = NULL;
    shape->indices = NULL;
    return mesh;
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
    result = shape_need_colors(&shape);
    if (!result)
        *mesh = mesh_of_shape(&shape);
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

/* Takes what points have of it. */
static GpPoints points_of_shape(Shape *shape)
{
    const GpPoints points = { .positions = shape->positions,
                              .normals = shape->normals,
                              .count = shape->vertex_count };
    shape->positions = shape->normals = NULL;
    return points;
}

GpResult model_points(const char *builtin, GpPoints *points, GpError *error)
{
    Shape shape;
    GpResult result = make_builtin(builtin, true, &shape, error);
    if (result)
        return result;
    *points = points_of_shape(&shape);
    shape_free(&shape);
    return GP_OK;
}

/* --- as a shape ------------------------------------------------------------------------------- */

/* Takes what a shape has of it. Files have v = 0 at the bottom of a picture. */
static Shape shape_of_mesh(GpMesh *mesh, bool points)
{
    Shape shape = { .positions = mesh->positions,
                    .normals = mesh->normals,
                    .texcoords = mesh->texcoords,
                    .colors = mesh->colors,
                    .vertex_count = mesh->vertex_count };
    mesh->positions = mesh->normals = mesh->texcoords = mesh->colors = NULL;
    for (size_t i = 0; shape.texcoords && i < shape.vertex_count; i++)
        shape.texcoords[2 * i + 1] = 1 - shape.texcoords[2 * i + 1];
    if (!points) {
        shape.indices = mesh->indices;
        shape.index_count = 3 * mesh->triangle_count;
        mesh->indices = NULL;
    }
    return shape;
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
    *shape = shape_of_mesh(&mesh, points);
    gp_mesh_free(&mesh);
    return GP_OK;
}

/* --- as surfels ------------------------------------------------------------------------------- */

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
                      : points ? model_points(builtin, &cloud, error)
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
