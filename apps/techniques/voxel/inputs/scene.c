/* Models by name as voxels: which kind of input each is, its box, and the passes for it. */
#include "apps/techniques/voxel/inputs/scene.h"

#include "apps/scene/model.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define QUARTIC_REACH 2.27
#define RADIANS       0.017453292519943295 /* in a degree */

/* --- files and names -------------------------------------------------------------------------- */

static GpResult open_function(const char *text, VoxelScene *scene, GpError *error)
{
    GpResult result = voxel_function_parse(text, &scene->function, error);
    scene->input = VOXEL_FUNCTION;
    const double reach = strcmp(text, "quartic") == 0 ? QUARTIC_REACH : VOXEL_FUNCTION_REACH;
    scene->cube = (Bounds){ { -reach, -reach, -reach }, { reach, reach, reach } };
    return result;
}

/* Its cube is the volume of its box, less the margin. */
static GpResult open_surface(const char *name, VoxelScene *scene, GpError *error)
{
    enum { SIZE = 64 }; /* any: only its place counts */
    VoxelBox box;
    GpResult result = voxel_parametric_box(name, SIZE, &box, error);
    scene->input = VOXEL_PARAMETRIC;
    snprintf(scene->surface, sizeof scene->surface, "%s", name);
    for (int k = 0; k < 3 && !result; k++) {
        scene->cube.low[k] = (VOXEL_BOX_MARGIN - box.offset[k]) / box.scale;
        scene->cube.high[k] = (SIZE - VOXEL_BOX_MARGIN - box.offset[k]) / box.scale;
    }
    return result;
}

static GpResult open_mesh(const char *name, VoxelScene *scene, GpError *error)
{
    GpResult result = model_mesh(name, &scene->mesh, error);
    if (!result && scene->mesh.triangle_count == 0)
        scene->input = VOXEL_POINTS;
    return result;
}

GpResult voxel_scene_open(const char *path, VoxelScene *scene, GpError *error)
{
    const char *function = model_after(path, "implicit:");
    const char *surface = model_after(path, "parametric:");
    VoxelScene opened = { .input = VOXEL_MESH };
    GpResult result = function  ? open_function(function, &opened, error)
                      : surface ? open_surface(surface, &opened, error)
                                : open_mesh(path, &opened, error);
    if (!result)
        *scene = opened;
    return result;
}

void voxel_scene_close(VoxelScene *scene)
{
    gp_mesh_free(&scene->mesh);
    *scene = (VoxelScene){ .is_placed = false };
}

/* --- boxes ------------------------------------------------------------------------------------ */

/* Room for every vertex wherever it turns about the centre of a box, along y. */
static void widen_to_turn(const GpMesh *mesh, Bounds *bounds)
{
    const double x = (bounds->low[0] + bounds->high[0]) / 2;
    const double z = (bounds->low[2] + bounds->high[2]) / 2;
    double most = 0;
    for (size_t i = 0; i < 3 * (size_t)mesh->triangle_count; i++) {
        const float *p = mesh->positions + 3 * (size_t)mesh->indices[i];
        const double aside = (double)p[0] - x, back = (double)p[2] - z;
        most = fmax(most, aside * aside + back * back);
    }
    const double radius = sqrt(most);
    bounds->low[0] = x - radius;
    bounds->high[0] = x + radius;
    bounds->low[2] = z - radius;
    bounds->high[2] = z + radius;
}

Bounds voxel_scene_bounds(const VoxelScene *scene)
{
    if (scene->input == VOXEL_FUNCTION || scene->input == VOXEL_PARAMETRIC)
        return scene->cube;
    const GpMesh *mesh = &scene->mesh;
    if (scene->input == VOXEL_POINTS)
        return bounds_of(mesh->positions, 3 * sizeof(float), NULL, mesh->vertex_count);
    Bounds bounds =
        bounds_of(mesh->positions, 3 * sizeof(float), mesh->indices, 3 * mesh->triangle_count);
    if (scene->twist != 0)
        widen_to_turn(&scene->mesh, &bounds);
    return bounds;
}

VoxelBox voxel_scene_box(const VoxelScene *scene, uint32_t size)
{
    const Bounds bounds = voxel_scene_bounds(scene);
    return voxel_scene_box_around(scene, &bounds, size);
}

VoxelBox voxel_scene_box_around(const VoxelScene *scene, const Bounds *bounds, uint32_t size)
{
    if (!scene->is_placed && scene->input == VOXEL_FUNCTION)
        return voxel_box_of_cube(scene->cube.high[0], size);
    VoxelBox box = voxel_box_of(bounds, size);
    if (scene->is_placed) {
        box.scale = scene->scale;
        memcpy(box.offset, scene->offset, sizeof box.offset);
    }
    return box;
}

VoxelRange voxel_scene_range(const Bounds *bounds, const VoxelBox *box)
{
    float to_voxels[4][4];
    voxel_box_matrix(box, to_voxels);
    return voxel_range(bounds->low, bounds->high, to_voxels, box->size);
}

/* --- passes ----------------------------------------------------------------------------------- */

VoxelModel voxel_scene_model(const VoxelScene *scene, const VoxelBox *box)
{
    const GpMesh *mesh = &scene->mesh;
    return (VoxelModel){ .positions = mesh->positions,
                         .normals = mesh->normals,
                         .colors = mesh->colors,
                         .indices = mesh->indices,
                         .vertex_count = mesh->vertex_count,
                         .triangle_count = mesh->triangle_count,
                         .motion = voxel_still(box) };
}

/* What a setting asks of an input that is no mesh. */
static GpResult check_input(const VoxelScene *scene, const VoxelSetting *setting, GpError *error)
{
    static const char *const names[] = { [VOXEL_FUNCTION] = "a function",
                                         [VOXEL_PARAMETRIC] = "a parametric surface",
                                         [VOXEL_POINTS] = "points" };
    const char *name = names[scene->input];
    if (setting->method != VOXEL_AUTO)
        return gp_fail(error, GP_ERROR_INVALID, "%s: --method is for meshes", name);
    if (setting->bits != 1)
        return gp_fail(error, GP_ERROR_INVALID, "%s: one bit a voxel, not %u", name, setting->bits);
    if (setting->kind == VOXEL_SOLID && scene->input != VOXEL_FUNCTION)
        return gp_fail(error, GP_ERROR_INVALID, "%s: no inside, so no --kind solid", name);
    if (scene->twist != 0)
        return gp_fail(error, GP_ERROR_INVALID, "%s: --twist is for meshes", name);
    return GP_OK;
}

static bool can_twist(VoxelMethod method)
{
    return method == VOXEL_AUTO || method == VOXEL_CONSERVATIVE || method == VOXEL_THIN ||
           method == VOXEL_XOR || method == VOXEL_WINDING;
}

/* A twisted model is one that moves, as far as lists of triangles are concerned. */
static GpResult twist_model(const VoxelScene *scene, const VoxelBox *box, Frame *frame,
                            VoxelModel *model, VoxelMethod method, GpError *error)
{
    if (!can_twist(method))
        return gp_fail(error, GP_ERROR_INVALID,
                       "--twist: expected --method conservative, thin, xor or winding");
    const Bounds bounds = voxel_scene_bounds(scene);
    const double height = (bounds.high[1] - bounds.low[1]) * box->scale;
    if (height > 0)
        model->motion.twist = (float)(scene->twist * RADIANS / height);
    model->most_twist = model->motion.twist;
    model->motions = frame_alloc(frame, 1, sizeof *model->motions);
    return GP_OK;
}

static GpResult draw_mesh(const VoxelScene *scene, const VoxelSetting *setting, const VoxelBox *box,
                          Frame *frame, const FlatTexture *flat, GpError *error)
{
    VoxelModel model = voxel_scene_model(scene, box);
    if (scene->twist != 0) {
        GpResult result = twist_model(scene, box, frame, &model, setting->method, error);
        if (result)
            return result;
    }
    return voxel_draw(&model, setting, frame, flat, error);
}

GpResult voxel_scene_draw(const VoxelScene *scene, const VoxelSetting *setting, const VoxelBox *box,
                          Frame *frame, const FlatTexture *flat, GpError *error)
{
    if (scene->input == VOXEL_MESH)
        return draw_mesh(scene, setting, box, frame, flat, error);
    GpResult result = check_input(scene, setting, error);
    if (result)
        return result;
    if (scene->input == VOXEL_FUNCTION)
        return voxel_implicit(&scene->function, box, setting->kind, frame, flat, error);
    if (scene->input == VOXEL_PARAMETRIC)
        return voxel_parametric(scene->surface, VOXEL_PARAMETRIC_CHORD, box, frame, flat, error);
    return voxel_points(scene->mesh.positions, scene->mesh.vertex_count, box, frame, flat, error);
}
