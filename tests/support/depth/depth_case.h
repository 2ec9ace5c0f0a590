/* What tests of depth images share: meshes as they are captured, and rays at them. */
#ifndef TESTS_DEPTH_CASE_H
#define TESTS_DEPTH_CASE_H

#include "apps/depth_images/capture.h"
#include "apps/truth/ray_scene.h"
#include "tests/support/meshes/named_mesh.h"
#include "tests/support/unit.h"

/* A mesh by name, moved; rays are cast at a copy of it. */
typedef struct DepthCase {
    GpMesh mesh;
    TruthScene *truth;
} DepthCase;

static inline void depth_case_open(const char *name, double scale, const double move[3],
                                   DepthCase *made)
{
    made->mesh = named_mesh(name);
    for (uint32_t i = 0; i < 3 * made->mesh.vertex_count; i++)
        made->mesh.positions[i] =
            (float)((double)made->mesh.positions[i] * scale + (move ? move[i % 3] : 0));
    TruthTriangle *triangles = gp_alloc(made->mesh.triangle_count, sizeof *triangles);
    assert_non_null(triangles);
    for (uint32_t i = 0; i < 3 * made->mesh.triangle_count; i++)
        for (uint32_t k = 0; k < 3; k++)
            triangles[i / 3].corner[i % 3][k] =
                (double)made->mesh.positions[3 * made->mesh.indices[i] + k];
    assert_int_equal(truth_scene_create(triangles, made->mesh.triangle_count, &made->truth), GP_OK);
    gp_free(triangles);
}

static inline void depth_case_close(DepthCase *made)
{
    truth_scene_destroy(&made->truth);
    gp_mesh_free(&made->mesh);
}

/* The nearest that the ray of a pixel meets beyond a depth; false: nothing. `t` of the hit is the
 * depth, whose point is point[]. in square: unit or not, the triangle's normal goes there */
static inline bool depth_case_hit(const DepthCase *made, const DepthPlane *plane,
                                  const DepthPixels *pixels, double x, double y, double beyond,
                                  double *depth, double square[3])
{
    double from[3], to[3], direction[3];
    depth_plane_point(plane, pixels, x, y, beyond, from);
    depth_plane_point(plane, pixels, x, y, beyond + 1, to);
    vector_subtract(to, from, direction);
    TruthHit hit;
    if (!truth_first_hit(made->truth, from, direction, &hit))
        return false;
    *depth = beyond + hit.t;
    const TruthTriangle *triangle = truth_scene_triangle(made->truth, hit.triangle);
    double a[3], b[3];
    vector_subtract(triangle->corner[1], triangle->corner[0], a);
    vector_subtract(triangle->corner[2], triangle->corner[0], b);
    vector_cross(a, b, square);
    vector_normalize(square);
    return true;
}

#endif
