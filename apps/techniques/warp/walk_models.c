#include "apps/techniques/warp/walk_models.h"

#include "apps/depth_images/making/capture_cylinder.h"
#include "apps/scene/model.h"

#include <string.h>

static const char *const usual[] = { "builtin:teapot", "builtin:knot", "builtin:sphere",
                                     "builtin:torus" };
static const float colors[][3] = {
    { 0.85f, 0.5f, 0.35f }, { 0.4f, 0.55f, 0.85f }, { 0.85f, 0.8f, 0.5f }, { 0.8f, 0.35f, 0.4f }
};

/* All vertices of a mesh that has no colours of a file's. */
static GpResult paint(const char *name, const float color[3], GpMesh *mesh)
{
    if (mesh->colors && !model_after(name, "builtin:"))
        return GP_OK;
    if (!mesh->colors)
        mesh->colors = gp_alloc(mesh->vertex_count, 4 * sizeof *mesh->colors);
    for (size_t i = 0; i < mesh->vertex_count && mesh->colors; i++) {
        memcpy(mesh->colors + 4 * i, color, 3 * sizeof *color);
        mesh->colors[4 * i + 3] = 1;
    }
    return mesh->colors ? GP_OK : GP_ERROR_MEMORY;
}

static GpResult open_model(GpDevice *device, const char *name, const float color[3],
                           uint32_t pixels, DepthModel *model, GpError *error)
{
    const CaptureTurn turn = { .width = pixels, .height = pixels };
    GpMesh mesh;
    GpResult result = model_mesh(name, &mesh, error);
    if (result)
        return result;
    if (mesh.triangle_count == 0)
        result = gp_fail(error, GP_ERROR_FORMAT, "%.200s: no faces, which are captured", name);
    else if (paint(name, color, &mesh))
        result = gp_fail(error, GP_ERROR_MEMORY, "%.200s: no memory", name);
    if (!result)
        result = capture_cylinder(device, &(CaptureSource){ &mesh, 0 }, &turn, model, error);
    gp_mesh_free(&mesh);
    return result;
}

GpResult walk_open_models(GpDevice *device, const WalkOptions *options, Walk *walk, GpError *error)
{
    const uint32_t count = options->name_count ? options->name_count : GP_COUNT(usual);
    const char *const *names = options->name_count ? options->names : usual;
    DepthModel *models = gp_alloc(count, sizeof *models);
    GpResult result = models ? GP_OK : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (uint32_t i = 0; i < count && !result; i++)
        result = open_model(device, names[i], colors[i % GP_COUNT(colors)], options->pixels,
                            &models[i], error);
    if (!result)
        result = walk_open(models, count, options->objects, walk, error);
    for (uint32_t i = 0; i < count && models; i++)
        depth_model_free(&models[i]);
    gp_free(models);
    return result;
}
