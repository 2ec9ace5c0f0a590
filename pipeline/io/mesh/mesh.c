#include "pipeline/io/mesh/mesh.h"

#include "pipeline/io/mesh/mesh_import.h"

#include <math.h>
#include <string.h>

typedef struct FormatEntry {
    const char *extension;
    GpMeshFormat format;
    GpResult (*check)(GpMeshSource *, GpError *);
} FormatEntry;

static const FormatEntry formats[] = {
    { "off", GP_MESH_OFF, gp_mesh_check_off }, { "obj", GP_MESH_OBJ, gp_mesh_check_obj },
    { "ply", GP_MESH_PLY, gp_mesh_check_ply }, { "stl", GP_MESH_STL, gp_mesh_check_stl },
    { "om", GP_MESH_OM, gp_mesh_check_om },
};

static GpResult read_source(const FormatEntry *entry, unsigned flags, GpMeshSource *source,
                            GpMesh *mesh, GpError *error)
{
    GpResult result = entry->check(source, error);
    if (result != GP_OK)
        return result;
    if (source->vertex_count == 0)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: no vertices", source->path);
    if (source->face_count == 0 && !(flags & GP_MESH_ALLOW_POINTS))
        return gp_fail(error, GP_ERROR_FORMAT, "%s: no faces", source->path);

    GpMesh loaded;
    result = gp_mesh_import(source, &loaded, error);
    if (result != GP_OK)
        return result;
    if (loaded.triangle_count == 0 && source->face_count > 0)
        result = gp_fail(error, GP_ERROR_FORMAT, "%s: no faces with an area", source->path);
    else if (gp_mesh_normals(&loaded, !loaded.had_normals) != GP_OK)
        result = gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for normals", source->path);
    if (result != GP_OK) {
        gp_mesh_free(&loaded);
        return result;
    }
    *mesh = loaded;
    return GP_OK;
}

GpResult gp_mesh_read(const char *path, unsigned flags, GpMesh *mesh, GpError *error)
{
    GP_ASSERT(path && mesh);
    char extension[8];
    gp_file_extension(path, extension);
    const FormatEntry *entry = NULL;
    for (size_t i = 0; i < GP_COUNT(formats); i++) {
        if (strcmp(extension, formats[i].extension) == 0)
            entry = &formats[i];
    }
    if (!entry)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%s: expected a name that ends with .off, .obj, .ply, .stl or .om", path);

    GpMeshSource source = { .path = path, .reading = entry->extension, .format = entry->format };
    GpResult result = gp_file_read(path, &source.file, error);
    if (result != GP_OK)
        return result;
    if (source.file.size == 0)
        result = gp_fail(error, GP_ERROR_FORMAT, "%s: the file is empty", path);
    else
        result = read_source(entry, flags, &source, mesh, error);
    gp_file_free(&source.file);
    return result;
}

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

uint64_t gp_load_little(const void *bytes, size_t size)
{
    const unsigned char *at = bytes;
    uint64_t value = 0;
    for (size_t i = size; i-- > 0;)
        value = value << 8 | at[i];
    return value;
}

uint64_t gp_load_big(const void *bytes, size_t size)
{
    const unsigned char *at = bytes;
    uint64_t value = 0;
    for (size_t i = 0; i < size; i++)
        value = value << 8 | at[i];
    return value;
}
