#include "pipeline/io/mesh/mesh_file.h"

#include "pipeline/io/file.h"
#include "pipeline/io/mesh/mesh_formats.h"

typedef struct FormatEntry {
    const char *extension;
    void (*read)(GpInput *, GpMeshBuilder *);
} FormatEntry;

static const FormatEntry formats[] = {
    { "off", gp_mesh_read_off }, { "obj", gp_mesh_read_obj }, { "ply", gp_mesh_read_ply },
    { "stl", gp_mesh_read_stl }, { "om", gp_mesh_read_om },
};

static const FormatEntry *find_format(const char *path)
{
    for (size_t i = 0; i < GP_COUNT(formats); i++)
        if (gp_file_has_extension(path, formats[i].extension))
            return &formats[i];
    return NULL;
}

bool gp_mesh_is_readable(const char *path)
{
    return find_format(path) != NULL;
}

/* From what the file holds to what gp_mesh_read promises. */
static GpResult finish(const char *path, unsigned flags, GpMeshBuilder *builder, GpMesh *mesh,
                       GpError *error)
{
    size_t faces = builder->face_count;
    if (builder->vertex_count == 0)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: no vertices", path);
    if (faces == 0 && !(flags & GP_MESH_ALLOW_POINTS))
        return gp_fail(error, GP_ERROR_FORMAT, "%s: no faces", path);

    GpMesh loaded;
    if (gp_mesh_builder_finish(builder, &loaded) != GP_OK)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for the mesh", path);
    GpResult result = GP_OK;
    if (loaded.triangle_count == 0 && faces > 0)
        result = gp_fail(error, GP_ERROR_FORMAT, "%s: no faces with an area", path);
    else if (gp_mesh_normals(&loaded, !loaded.had_normals) != GP_OK)
        result = gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for normals", path);
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
    const FormatEntry *entry = find_format(path);
    if (!entry)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%s: expected a name that ends with .off, .obj, .ply, .stl or .om", path);

    GpFile file;
    GpInput input;
    GpResult result = gp_input_open(path, &file, &input, error);
    if (result != GP_OK)
        return result;
    GpMeshBuilder builder = { .vertex_count = 0 };
    entry->read(&input, &builder);
    gp_file_free(&file);
    result = input.result;
    if (result == GP_OK)
        result = finish(path, flags, &builder, mesh, error);
    gp_mesh_builder_free(&builder);
    return result;
}
