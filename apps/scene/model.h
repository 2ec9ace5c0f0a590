/* Models by name: builtin:NAME (shapes.h), or a file that gp_data_find finds.
 *
 * errors of all: GP_ERROR_INVALID: no such builtin; those of gp_data_find and gp_mesh_read */
#ifndef APPS_SCENE_MODEL_H
#define APPS_SCENE_MODEL_H

#include "apps/depth_images/depth_file.h"
#include "apps/points/surfels.h"
#include "apps/scene/shapes.h"
#include "pipeline/base/pool.h"
#include "pipeline/io/mesh/mesh_file.h"
#include "pipeline/io/points/points.h"

/* What follows a prefix of a name, such as "builtin:"; NULL where it does not begin so. */
const char *model_after(const char *name, const char *prefix);

/* A mesh, or points where a file has no faces.
 * owns   the caller, until gp_mesh_free */
GpResult model_mesh(const char *name, GpMesh *mesh, GpError *error);

/* A depth image of a file.
 * errors also those of depth_file_read
 * owns   the caller, until depth_model_free */
GpResult model_depth_images(const char *name, DepthModel *images, GpError *error);

/* A point set of shapes.h, by what follows "builtin:points/" in a name.
 * errors GP_ERROR_INVALID: no such points; GP_ERROR_MEMORY
 * owns   the caller, until gp_points_free */
GpResult model_points(const char *builtin, GpPoints *points, GpError *error);

/* What a scene names: a file is looked for beside the scene's first (NULL: it has none).
 * A mesh, which has faces; or (points) the vertices of one. Texture coordinates have v = 0 at the
 * top, as pictures have.
 * owns   the caller, until shape_free */
GpResult model_shape(const char *scene, const char *name, bool points, Shape *shape,
                     GpError *error);

/* What an object of a scene names, as surfels: the points of a file, or the vertices of one with
 * faces, after midpoint subdivisions or as so many samples of its area (open.h); of builtins, the
 * points or the mesh of that name.
 * errors also those of points_open
 * owns   the caller, until surfels_free */
typedef struct ModelSampling {
    uint32_t subdivide, sample;
} ModelSampling;

GpResult model_surfels(const char *scene, const char *name, bool points,
                       const ModelSampling *sampling, GpPool *pool, Surfels *surfels,
                       GpError *error);

#endif
