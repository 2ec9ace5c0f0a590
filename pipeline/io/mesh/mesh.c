#include "pipeline/io/mesh/mesh.h"

#include <math.h>
#include <string.h>

/* Adds the cross product of two edges, whose length is twice the area, to the three corners. Edges
 * and products of floats are exact enough in double that no triangle loses its direction. */
static void add_triangle(const float *positions, const uint32_t corner[3], double *sums)
{
    const float *a = positions + 3 * (size_t)corner[0];
    const float *b = positions + 3 * (size_t)corner[1];
    const float *c = positions + 3 * (size_t)corner[2];
    double u[3], v[3];
    for (int i = 0; i < 3; i++) {
        u[i] = (double)b[i] - (double)a[i];
        v[i] = (double)c[i] - (double)a[i];
    }
    double normal[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                         u[0] * v[1] - u[1] * v[0] };
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            sums[3 * (size_t)corner[k] + (size_t)i] += normal[i];
    }
}

GpResult gp_mesh_normals(GpMesh *mesh, bool all)
{
    GP_ASSERT(mesh);
    double *sums = gp_alloc(3 * (size_t)mesh->vertex_count, sizeof(double));
    if (!sums)
        return GP_ERROR_MEMORY;
    for (size_t t = 0; t < mesh->triangle_count; t++)
        add_triangle(mesh->positions, mesh->indices + 3 * t, sums);

    for (size_t v = 0; v < mesh->vertex_count; v++) {
        float *normal = mesh->normals + 3 * v;
        bool is_absent = normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
        if (!all && !is_absent)
            continue;
        const double *sum = sums + 3 * v;
        double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
        for (int i = 0; i < 3; i++)
            normal[i] = length > 0 ? (float)(sum[i] / length) : (float)(i == 2);
    }
    gp_free(sums);
    return GP_OK;
}

void gp_mesh_free(GpMesh *mesh)
{
    if (!mesh)
        return;
    gp_free(mesh->positions);
    gp_free(mesh->normals);
    gp_free(mesh->colors);
    gp_free(mesh->texcoords);
    gp_free(mesh->indices);
    memset(mesh, 0, sizeof *mesh);
}
