#include "apps/scene/depth_images.h"

#include "apps/depth_images/depth_file.h"
#include "apps/depth_images/drawing/surface.h"
#include "apps/depth_images/making/capture_cylinder.h"
#include "apps/scene/materials.h"
#include "apps/scene/model.h"
#include "apps/scene/placing.h"
#include "apps/scene/state.h"
#include "apps/scene/volumes.h"
#include "pipeline/io/file.h"

#include <math.h>
#include <string.h>

/* Where an image's own space is in the world. */
typedef struct OwnSpace {
    double turn[3][3]; /* columns: its axes, unit length */
    double scale, origin[3];
} OwnSpace;

/* --- to the world ----------------------------------------------------------------------------- */

static uint32_t pixel_count(const DepthImage *image)
{
    return image->front.width * image->front.height;
}

static bool find_point(const DepthImage *image, uint32_t pixel, double point[3])
{
    const DepthPixels *pixels = &image->front;
    const double x = pixel % pixels->width + 0.5, y = pixel / pixels->width + 0.5;
    const double depth = (double)pixels->depth[pixel];
    if (!isfinite(depth))
        return false;
    if (image->is_cylinder)
        depth_cylinder_point(&image->cylinder, pixels, x, y, depth, point);
    else
        depth_plane_point(&image->plane, pixels, x, y, depth, point);
    return true;
}

/* All points of all images, each with a normal, and behind them the first again three times, whose
 * normals are the axes. NULL: there is no point, or no memory, of which the object's reader
 * knows. */
static float (*all_points(const Node *object, const DepthModel *model, uint32_t *count))[6]
{
    uint32_t room = 3, at = 0;
    for (uint32_t i = 0; i < model->count; i++)
        room += pixel_count(&model->images[i]);
    float(*points)[6] = gp_alloc(room, sizeof *points);
    if (!points)
        node_fail(object, GP_ERROR_MEMORY, "no memory");
    for (uint32_t i = 0; i < model->count && points; i++)
        for (uint32_t k = 0; k < pixel_count(&model->images[i]); k++) {
            double point[3];
            if (!find_point(&model->images[i], k, point))
                continue;
            for (int c = 0; c < 3; c++)
                points[at][c] = (float)point[c];
            at++;
        }
    for (int i = 0; i < 3 && at > 0; i++) {
        memcpy(points[at], points[0], sizeof *points);
        points[at++][3 + i] = 1;
    }
    *count = at;
    if (at > 0)
        return points;
    gp_free(points);
    return NULL;
}

/* "transform" and "fit", as of the points. */
static OwnSpace read_place(Node *object, const DepthModel *model)
{
    Node transform = node_member(object, "transform"), fit = node_member(object, "fit");
    OwnSpace space = { .scale = 1 };
    double first[3] = { 0 };
    uint32_t count = 0;
    float(*points)[6] = all_points(object, model, &count);
    for (int k = 0; k < 3 && points; k++)
        first[k] = (double)points[0][k];
    const PlacedVertices all = { points ? points[0] : NULL, points ? points[0] + 3 : NULL,
                                 sizeof *points, count };
    const Placed placed = scene_place(transform, fit, &all);
    if (placed.uneven || placed.mirrored)
        node_fail(&transform, GP_ERROR_FORMAT,
                  "depth images keep their shape: expected one scale above 0");
    space.scale = placed.scale;
    for (int k = 0; k < 3 && points; k++) {
        for (uint32_t i = 0; i < 3; i++)
            space.turn[k][i] = (double)points[count - 3 + i][3 + k];
        space.origin[k] = (double)points[0][k] - space.scale * vector_dot(space.turn[k], first);
    }
    gp_free(points);
    return space;
}

static void move_direction(const OwnSpace *space, double direction[3])
{
    const double own[3] = { direction[0], direction[1], direction[2] };
    for (int k = 0; k < 3; k++)
        direction[k] = vector_dot(space->turn[k], own);
}

static void move_point(const OwnSpace *space, double point[3])
{
    move_direction(space, point);
    for (int k = 0; k < 3; k++)
        point[k] = space->origin[k] + space->scale * point[k];
}

static void move_plane(const OwnSpace *space, DepthPlane *plane)
{
    move_point(space, plane->eye);
    move_direction(space, plane->right);
    move_direction(space, plane->up);
    move_direction(space, plane->forward);
    if (!plane->is_parallel)
        return;
    plane->left *= space->scale;
    plane->bottom *= space->scale;
    plane->width *= space->scale;
    plane->height *= space->scale;
}

static void move_cylinder(const OwnSpace *space, DepthCylinder *cylinder)
{
    move_point(space, cylinder->center);
    move_direction(space, cylinder->axis);
    move_direction(space, cylinder->zero);
    cylinder->radius *= space->scale;
    cylinder->height *= space->scale;
}

static void move_image(const OwnSpace *space, DepthImage *image)
{
    DepthPixels *pixels = &image->front;
    if (image->is_cylinder)
        move_cylinder(space, &image->cylinder);
    else
        move_plane(space, &image->plane);
    for (uint32_t i = 0; i < pixel_count(image); i++) {
        float *normal = pixels->normal ? &pixels->normal[3 * i] : NULL;
        double turned[3] = { 0 };
        pixels->depth[i] *= (float)space->scale;
        for (int k = 0; k < 3 && normal; k++)
            turned[k] = (double)normal[k];
        move_direction(space, turned);
        for (int k = 0; k < 3 && normal; k++)
            normal[k] = (float)turned[k];
    }
}

/* --- draws ------------------------------------------------------------------------------------ */

/* The cylinder about a mesh, and its caps. */
static GpResult capture(const char *path, const long pixels[2], DepthModel *model, GpError *error)
{
    const CaptureTurn turn = { .width = (uint32_t)pixels[0], .height = (uint32_t)pixels[1] };
    GpMesh mesh;
    GpDevice *device = NULL;
    GpResult result = model_mesh(path, &mesh, error);
    if (result)
        return result;
    const CaptureSource source = { &mesh, 0 };
    if (mesh.triangle_count == 0)
        result = gp_fail(error, GP_ERROR_FORMAT, "%.200s: no faces, which are captured", path);
    if (!result)
        result = gp_device_create(&(GpDeviceDesc){ .threads = 0 }, &device, error);
    if (!result)
        result = capture_cylinder(device, &source, &turn, model, error);
    gp_device_destroy(&device);
    gp_mesh_free(&mesh);
    return result;
}

static GpResult open_model(const char *scene, const char *name, const long pixels[2],
                           DepthModel *model, GpError *error)
{
    char path[4096];
    if (model_after(name, "builtin:"))
        return capture(name, pixels, model, error);
    const GpResult result = gp_data_find_beside(scene, name, path, sizeof path, error);
    if (result)
        return result;
    return depth_file_is_readable(path) ? depth_file_read(path, model, error)
                                        : capture(path, pixels, model, error);
}

static void read_model(Node *object, DepthModel *model)
{
    Node mesh = node_member(object, "mesh"), points = node_member(object, "points");
    Node volume = node_member(object, "volume"), node = node_member(object, "depth_image");
    Node size = node_member(object, "pixels");
    const Node *const shapes[] = { &mesh, &points, &volume, &node };
    long pixels[2] = { 512, 512 };
    GpError reason = { "" };
    node_one_of(shapes, GP_COUNT(shapes), SCENE_SHAPES);
    const char *name = node_string(node, NULL);
    node_integers(size, pixels, 2, 8, 4096);
    if (!name || object->reader->result)
        return;
    const GpResult result = open_model(object->reader->file, name, pixels, model, &reason);
    if (result)
        scene_fail(&node, result, &reason);
}

/* The level that a view asks for. */
static const SurfaceLevel *level_for(const DepthSurface *surface, const SceneView *view)
{
    const WarpView seen = { .camera = view->camera, .width = view->width, .height = view->height };
    const uint32_t step = surface_step(surface, &seen);
    const SurfaceLevel *level = surface->levels, *last = level + surface->level_count - 1;
    while (level < last && level[1].step <= step)
        level++;
    return level;
}

static void set_geometry(Frame *frame, const SurfaceLevel *level, GpGeometry *geometry)
{
    const SurfaceVertex *first =
        frame_copy(frame, level->vertices, level->mesh.vertex_count * sizeof *level->vertices);
    const uint32_t *indices = frame_copy(frame, level->mesh.indices,
                                         level->mesh.index_count * sizeof *level->mesh.indices);
    const uint32_t stride = sizeof *first;
    if (!first || !indices)
        return;
    *geometry = (GpGeometry){
        .vertex_count = level->mesh.vertex_count,
        .indices = indices,
        .index_count = level->mesh.index_count,
        .streams = { [GP_POSITION] = { first->position, stride, 3, GP_FLOAT32 },
                     [GP_NORMAL] = { first->normal, stride, 3, GP_FLOAT32 },
                     [GP_TEXCOORD0] = { first->texcoord, stride, 2, GP_FLOAT32 } },
    };
}

/* One image of a model that is in the world, drawn as another is; its textures become the
 * frame's. */
static void add_image(Loader *loader, const Node *object, const DepthImage *image, GpDraw *draw,
                      const SceneView *view)
{
    GpSampler sampler = { .min = GP_LINEAR, .mag = GP_LINEAR, .mip = GP_MIP_LINEAR };
    Arena *arena = &loader->frame->arena;
    GpError reason = { "" };
    DepthSurface surface;
    const GpResult result = surface_open(image, NULL, &surface, &reason);
    if (result) {
        scene_fail(object, result, &reason);
        return;
    }
    sampler.address_u = image->is_cylinder ? GP_WRAP : GP_CLAMP;
    sampler.address_v = GP_CLAMP;
    draw->textures[0] = (GpTexture){ arena_own_surface(arena, surface.textures.color), sampler };
    draw->textures[1] = (GpTexture){ arena_own_surface(arena, surface.textures.normal), sampler };
    surface.textures = (DepthTextures){ .color = NULL };
    set_geometry(loader->frame, level_for(&surface, view), &draw->geometry);
    surface_close(&surface);
}

void scene_read_depth_image(Loader *loader, Node *object, const SceneView *view)
{
    static const char *const others[] = {
        "tile", "size", "color", "method", "subdivide", "sample"
    };
    DepthModel *model = gp_alloc(1, sizeof *model);
    GpDraw draw = { .viewport = view->viewport };
    SceneView own = *view;
    if (!model) {
        node_fail(object, GP_ERROR_MEMORY, "no memory");
        return;
    }
    draw.name = scene_copy(loader, node_string(node_member(object, "name"), ""));
    scene_refuse(object, others, GP_COUNT(others), "depth images have none of their own");
    scene_refuse_without_volume(object);
    scene_read_viewport(node_member(object, "viewport"), &own.viewport);
    draw.viewport = own.viewport;
    if (view->has_depth)
        draw.state.depth = (GpDepthState){ .test = GP_LESS_EQUAL, .write = true };
    read_model(object, model);
    const OwnSpace space = read_place(object, model);
    scene_read_state(node_member(object, "state"), view, &draw.state);
    Node material = node_member(object, "material");
    for (uint32_t i = 0; i < model->count && !loader->reader.result; i++) {
        move_image(&space, &model->images[i]);
        add_image(loader, object, &model->images[i], &draw, &own);
        Node again = material;
        scene_read_material(loader, again, &own, "mapped_phong", &draw);
        if (draw.geometry.index_count && !loader->reader.result)
            *frame_draw(loader->frame, draw.program, draw.uniforms, &draw.geometry) = draw;
    }
    if (object->schema)
        scene_read_material(loader, material, &own, "mapped_phong", &draw);
    depth_model_free(model);
    gp_free(model);
}
