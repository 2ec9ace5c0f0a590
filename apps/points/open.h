/* Surfels of whatever a user has: points or a mesh, from a file or from memory. */
#ifndef APPS_POINTS_OPEN_H
#define APPS_POINTS_OPEN_H

#include "apps/points/facts.h"

/* One of path, mesh and points is set. */
typedef struct PointsSource {
    const char *path; /* a file that gp_points_read or gp_mesh_read reads, found by gp_data_find */
    const GpMesh *mesh;     /* with triangles */
    const GpPoints *points; /* face_count counts for nothing */
    const char *name;       /* of a mesh or points in memory, for messages */

    /* Of a mesh: */
    uint32_t subdivide; /* times its triangles are cut into four first; 0: never */
    uint32_t sample;    /* points spread over it; 0: its vertices */
    /* a vertex where triangles meet at more degrees is one for each side of the crease; 0: not
     * so */
    double sharp;
    bool each_radius; /* a radius for each vertex rather than one for all (vertices.h) */
} PointsSource;

/* Makes the triangles ready whose vertices, or samples, become surfels: without what is not used,
 * turned outwards, and cut along creases where `sharp` says so or samples are taken, which look as
 * the face does that they lie on (creases.h).
 * in/out mesh: with triangles; on failure it is no good any more
 * out    facts: untouched on failure; of them read, triangles, left_out, turned and split
 * errors GP_ERROR_MEMORY, GP_ERROR_UNSUPPORTED */
GpResult points_surface(const PointsSource *source, GpMesh *mesh, PointsFacts *facts);

/* Makes surfels.
 *
 * A file with faces is a mesh: of it (its vertices after subdivision, or `sample` points)
 * vertices.h, orient.h, creases.h, subdivide.h and sample.h tell all; of points, cloud.h. Samples
 * are points with normals, so that each has the radius and the area of its cell.
 *
 * in     facts: NULL: they are not asked for, which is quicker
 * out    surfels, at least one, and facts: untouched on failure
 * errors those of gp_data_find, gp_points_read and gp_mesh_read; GP_ERROR_FORMAT: points that are
 *        all at one place, without a radius, a mesh without area; GP_ERROR_INVALID: points that are
 *        to be subdivided or sampled; GP_ERROR_UNSUPPORTED: too many; GP_ERROR_MEMORY
 * owns   the caller, until surfels_free */
GpResult points_open(const PointsSource *source, GpPool *pool, Surfels *surfels, PointsFacts *facts,
                     GpError *error);

#endif
