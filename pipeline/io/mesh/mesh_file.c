#include "pipeline/io/mesh/mesh_file.h"

#include "pipeline/io/mesh/mesh_check.h"
#include "pipeline/io/mesh/mesh_openmesh.h"

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
