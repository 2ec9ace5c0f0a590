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
    const double ax = (double)a[0], ay = (double)a[1], az = (double)a[2];
    const double ux = (double)b[0] - ax, uy = (double)b[1] - ay, uz = (double)b[2] - az;
    const double vx = (double)c[0] - ax, vy = (double)c[1] - ay, vz = (double)c[2] - az;
    const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    for (int k = 0; k < 3; k++) {
        double *sum = sums + 3 * (size_t)corner[k];
        sum[0] += x;
        sum[1] += y;
        sum[2] += z;
    }
}

static bool is_absent(const float normal[3])
{
    return normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
}

static bool lacks_normals(const GpMesh *mesh)
{
    bool lacks = false;
    for (size_t v = 0; v < mesh->vertex_count && !lacks; v++)
        lacks = is_absent(mesh->normals + 3 * v);
    return lacks;
}

GpResult gp_mesh_normals(GpMesh *mesh, bool all)
{
    GP_ASSERT(mesh);
    if (!all && !lacks_normals(mesh))
        return GP_OK;
    double *sums = gp_alloc(3 * (size_t)mesh->vertex_count, sizeof(double));
    if (!sums)
        return GP_ERROR_MEMORY;
    for (size_t t = 0; t < mesh->triangle_count; t++)
        add_triangle(mesh->positions, mesh->indices + 3 * t, sums);

    for (size_t v = 0; v < mesh->vertex_count; v++) {
        float *normal = mesh->normals + 3 * v;
        if (!all && !is_absent(normal))
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
