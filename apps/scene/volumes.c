#include "apps/scene/volumes.h"

#include "apps/scene/bounds.h"
#include "apps/scene/materials.h"
#include "apps/scene/placing.h"
#include "apps/volumes/drawing/raycast.h"
#include "pipeline/io/file.h"
#include "shaders_c/materials/phong.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct SceneVolume {
    SceneVolume *next;  /* of the pass that is read */
    SceneVolume *older; /* of the whole scene */
    Field field;
    RaycastVolume rays;
    RaycastSetting setting;
    bool lit;
    double origin[3],
        axes[3][3]; /* where sample (0, 0, 0) is in the world, and steps of 1 along x, y, z */
    double scale;   /* their length */
};

/* --- what a pass must have -------------------------------------------------------------------- */

static bool has_size(const GpSurface *surface, const SceneView *view)
{
    return surface->width == view->width && surface->height == view->height;
}

static const char *why_not(const SceneView *view)
{
    const GpViewport *port = &view->viewport;
    if (port->width > 0 || port->has_depth_range || port->d3d9_centers)
        return "volumes fill the whole target: expected no viewport";
    if (!view->color || view->color_count > 1)
        return "volumes are drawn to one colour target";
    if (!has_size(view->color, view) || (view->depth && !has_size(view->depth, view)))
        return "volumes need targets of the pass's size";
    return NULL;
}

void scene_refuse_without_volume(Node *object)
{
    static const char *const keys[] = { "transfer", "step", "lit" };
    scene_refuse(object, keys, GP_COUNT(keys), "of volumes: expected a volume");
}

/* --- reading ---------------------------------------------------------------------------------- */

/* Frees what volumes have beside the frame's memory. */
static void release(void *held)
{
    for (SceneVolume *volume = held; volume; volume = volume->older) {
        raycast_close(&volume->rays);
        field_free(&volume->field);
    }
}

/* Corners of its box to the world, and from them the way back. */
static void place(Node *object, SceneVolume *volume)
{
    Node transform = node_member(object, "transform"), fit = node_member(object, "fit");
    float corners[8][2][3] = { { { 0 } } }; /* with normals, which nobody needs */
    double extent[3];
    for (int i = 0; i < 3; i++)
        extent[i] =
            volume->field.value ? (volume->field.size[i] - 1.0) * volume->field.scale[i] : 1;
    for (int k = 0; k < 8; k++)
        for (int i = 0; i < 3; i++)
            corners[k][0][i] = (float)(k >> i & 1 ? extent[i] : 0);
    const PlacedVertices vertices = { corners[0][0], corners[0][1], sizeof corners[0], 8 };
    const Placed placed = scene_place(transform, fit, &vertices);
    if (placed.uneven || placed.mirrored)
        node_fail(&transform, GP_ERROR_FORMAT,
                  "volumes keep their shape: expected one scale above 0");
    volume->scale = placed.scale;
    for (int i = 0; i < 3; i++) {
        volume->origin[i] = (double)corners[0][0][i];
        for (int k = 0; k < 3; k++)
            volume->axes[i][k] = ((double)corners[1 << i][0][k] - (double)corners[0][0][k]) /
                                 (extent[i] > 0 ? extent[i] : 1);
    }
}

static GpResult open_field(const char *scene, const char *name, Field *field, GpError *error)
{
    char path[4096];
    if (strncmp(name, "builtin:", strlen("builtin:")) == 0)
        return field_open(name, field, error);
    const GpResult result = gp_data_find_beside(scene, name, path, sizeof path, error);
    return result ? result : field_open(path, field, error);
}

static GpResult open_transfer(const char *scene, const char *name, const Field *field,
                              Transfer *transfer, GpError *error)
{
    char path[4096];
    for (size_t i = 0; transfer_names[i]; i++)
        if (strcmp(name, transfer_names[i]) == 0)
            return transfer_open(name, field, transfer, error);
    const GpResult result = gp_data_find_beside(scene, name, path, sizeof path, error);
    return result ? result : transfer_open(path, field, transfer, error);
}

/* The volume and its transfer function; an empty one after a failure. */
static void read_field(Node *object, SceneVolume *volume)
{
    Node name_node = node_member(object, "volume"), transfer_node = node_member(object, "transfer");
    Node mesh = node_member(object, "mesh"), points = node_member(object, "points");
    Node image = node_member(object, "depth_image");
    const Node *const shapes[] = { &mesh, &points, &name_node, &image };
    GpError reason = { "" };
    Transfer transfer;
    node_one_of(shapes, GP_COUNT(shapes), SCENE_SHAPES);
    const char *name = node_string(name_node, NULL);
    const char *transfer_name = node_string(transfer_node, NULL);
    node_without_default(&transfer_node);
    if (!name || object->reader->result)
        return;
    const char *scene = object->reader->file;
    GpResult result = open_field(scene, name, &volume->field, &reason);
    if (result) {
        scene_fail(&name_node, result, &reason);
        return;
    }
    if (transfer_name)
        result = open_transfer(scene, transfer_name, &volume->field, &transfer, &reason);
    else
        transfer_choose(&volume->field, &transfer);
    if (result) {
        scene_fail(&transfer_node, result, &reason);
        return;
    }
    result = raycast_open(&volume->field, &volume->rays, &reason);
    if (result)
        scene_fail(&name_node, result, &reason);
    else
        raycast_classify(&volume->rays, &transfer);
}

void scene_read_volume(Loader *loader, Node *object, const SceneView *view)
{
    static const char *const others[] = { "material", "state",  "viewport",  "tile",   "size",
                                          "color",    "method", "subdivide", "sample", "pixels" };
    Frame *frame = loader->frame;
    SceneVolume none = { .next = NULL }, *volume = frame_alloc(frame, 1, sizeof *volume);
    if (!volume)
        volume = &none;
    node_string(node_member(object, "name"), "");
    scene_refuse(object, others, GP_COUNT(others), "volumes have none of their own");
    if (!object->schema && why_not(view))
        node_fail(object, GP_ERROR_FORMAT, "%s", why_not(view));
    volume->setting.step = node_double(node_member(object, "step"), 1, 0.05, 16);
    volume->lit = node_bool(node_member(object, "lit"), false);
    if (volume != &none) {
        volume->older = frame->held;
        frame->held = volume;
        frame->release = release;
        read_field(object, volume);
    }
    place(object, volume);
    if (loader->reader.result || !volume->field.value)
        return;
    volume->next = loader->volumes;
    loader->volumes = volume;
    loader->scene->volume_count++;
}

/* --- drawing ---------------------------------------------------------------------------------- */

/* A place, or a direction, of the world where sample (0, 0, 0) is the origin and x, y, z its
 * axes. */
static void turn(const SceneVolume *volume, const double world[3], bool place_, double own[3])
{
    for (int i = 0; i < 3; i++) {
        own[i] = 0;
        for (int k = 0; k < 3; k++)
            own[i] += (world[k] - (place_ ? volume->origin[k] : 0)) * volume->axes[i][k];
        own[i] /= volume->scale * volume->scale;
    }
}

static VolumeView view_of(const SceneVolume *volume, const SceneView *view)
{
    const Camera *camera = &view->camera;
    VolumeView own = {
        .camera = *camera, .width = view->width, .height = view->height, .lit = volume->lit
    };
    turn(volume, camera->eye, true, own.camera.eye);
    turn(volume, camera->at, true, own.camera.at);
    turn(volume, camera->up, false, own.camera.up);
    own.camera.height = camera->height / volume->scale;
    own.camera.near = camera->near / volume->scale;
    own.camera.far = camera->far / volume->scale;
    return own;
}

/* Of the middle of a volume's box, along the view. */
static double distance_of(const SceneVolume *volume, const SceneView *view)
{
    const CameraAxes axes = camera_axes(&view->camera, (double)view->width / view->height);
    const Field *field = &volume->field;
    double distance = 0;
    for (int k = 0; k < 3; k++) {
        double middle = volume->origin[k] - view->camera.eye[k];
        for (int i = 0; i < 3; i++)
            middle += volume->axes[i][k] * (field->size[i] - 1) * field->scale[i] / 2;
        distance += middle * axes.forward[k];
    }
    return distance;
}

/* Takes the farthest out of the list; of equal ones that which was read last. */
static SceneVolume *take_farthest(SceneVolume **list, const SceneView *view)
{
    SceneVolume **farthest = list, *taken;
    for (SceneVolume **at = list; *at; at = &(*at)->next)
        if (distance_of(*at, view) > distance_of(*farthest, view))
            farthest = at;
    taken = *farthest;
    *farthest = taken->next;
    return taken;
}

SceneVolume *scene_draw_volumes(Loader *loader, const SceneView *view, const char *name)
{
    const VolumeTarget target = { view->color, view->depth };
    SceneVolume *list = loader->volumes, *drawn = NULL;
    char text[300];
    loader->volumes = NULL;
    while (list && !loader->frame->arena.result) {
        SceneVolume *volume = take_farthest(&list, view);
        const VolumeView own = view_of(volume, view);
        snprintf(text, sizeof text, "%.200s-volume", name);
        volume->setting.name = scene_copy(loader, text);
        if (raycast_add(&volume->rays, &own, &volume->setting, &target, loader->frame, NULL))
            frame_fail(loader->frame); /* no memory */
        volume->next = drawn;
        drawn = volume;
    }
    return drawn;
}

/* --- what is seen through them ---------------------------------------------------------------- */

static bool is_before(const SceneVolume *volume, const SceneView *view, const Bounds *box)
{
    const VolumeView own = view_of(volume, view);
    double corners[8][3];
    for (int corner = 0; corner < 8; corner++) {
        double world[3];
        for (int k = 0; k < 3; k++)
            world[k] = corner >> k & 1 ? box->high[k] : box->low[k];
        turn(volume, world, true, corners[corner]);
    }
    return raycast_is_before(&volume->rays, &own, corners);
}

static void find_to_field(const SceneVolume *volume, double to_field[3][4])
{
    for (int k = 0; k < 4; k++) {
        const double column[3] = { k == 0, k == 1, k == 2 };
        double own[3];
        turn(volume, column, k == 3, own);
        for (int i = 0; i < 3; i++)
            to_field[i][k] = own[i];
    }
}

void scene_see_through(Loader *loader, const Node *pass, SceneVolume *volumes,
                       const SceneView *view, GpDraw *draw)
{
    const Bounds box = draw_bounds(draw);
    SceneVolume *before = NULL;
    double to_field[3][4];
    GpError reason = { "" };
    for (; volumes; volumes = volumes->next) {
        if (!is_before(volumes, view, &box))
            continue;
        if (before)
            node_fail(pass, GP_ERROR_FORMAT,
                      "%s is blended, and two volumes are before it: expected one", draw->name);
        before = volumes;
    }
    if (!before || loader->reader.result)
        return;
    if (draw->program != &phong_program) {
        node_fail(pass, GP_ERROR_FORMAT,
                  "%s is blended, and a volume is before it: expected program phong, not %s",
                  draw->name, scene_program_name(draw->program));
        return;
    }
    const VolumeView own = view_of(before, view);
    find_to_field(before, to_field);
    if (raycast_see_through(&before->rays, &own, &before->setting, to_field, draw, loader->frame,
                            &reason))
        node_fail(pass, GP_ERROR_MEMORY, "%s", reason.text);
}
