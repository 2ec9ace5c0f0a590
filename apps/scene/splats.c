#include "apps/scene/splats.h"

#include "apps/base/machine.h"
#include "apps/points/drawing/choose.h"
#include "apps/points/vertices.h"
#include "apps/scene/materials.h"
#include "apps/scene/model.h"
#include "apps/scene/placing.h"
#include "apps/scene/shapes.h"
#include "apps/scene/volumes.h"
#include "shaders_c/points/over.h"

#include <stdio.h>
#include <string.h>

/* As `glasspipe points` calls them; the others have no place for what else is in a picture. */
static const char *const methods[] = { "adaptive", "ewa",  "reconstruction",
                                       "lowpass",  "area", "distance" };
_Static_assert(SPLAT_ADAPTIVE == 0 && SPLAT_DISTANCE == 5, "in the order of SplatMethod");

enum { MOST_SAMPLES = 1000000 };

static const SplatSetting setting = SPLAT_DEFAULTS;

/* Of points whose file has no colours: phong's own. */
static const uint8_t grey = 179;

static SplatView view_of(const SceneView *view)
{
    return (SplatView){
        .camera = view->camera, .width = view->width, .height = view->height, .lit = true
    };
}

/* --- what a pass must have -------------------------------------------------------------------- */

static bool has_size(const GpSurface *surface, const SceneView *view)
{
    return surface->width == view->width && surface->height == view->height;
}

static const char *why_not(const SceneView *view)
{
    const GpViewport *port = &view->viewport;
    if (view->camera.fovy <= 0)
        return "splats are seen by a perspective camera: expected a \"fovy\"";
    if (port->width > 0 || port->has_depth_range || port->d3d9_centers)
        return "splats fill the whole target: expected no viewport";
    if (!view->depth)
        return "splats and other objects hide each other by depth, which the pass has not";
    if (!view->color || view->color_count > 1)
        return "splats are drawn to one colour target";
    if (!has_size(view->color, view) || !has_size(view->depth, view))
        return "splats need targets of the pass's size";
    return NULL;
}

/* --- surfels ---------------------------------------------------------------------------------- */

static GpResult open_model(const Node *node, bool points, const ModelSampling *sampling,
                           GpPool *pool, Surfels *surfels, GpError *error)
{
    const char *name = node_string(*node, NULL);
    return name ? model_surfels(node->reader->file, name, points, sampling, pool, surfels, error)
                : GP_OK;
}

/* The model's surfels; none after a failure. */
static Surfels read_surfels(Node *object, GpPool *pool)
{
    Surfels surfels = { .count = 0 };
    GpError reason = { "" };
    Node mesh = node_member(object, "mesh"), points = node_member(object, "points");
    Node volume = node_member(object, "volume"), image = node_member(object, "depth_image");
    const Node *const shapes[] = { &mesh, &points, &volume, &image };
    node_one_of(shapes, GP_COUNT(shapes), SCENE_SHAPES);
    const ModelSampling sampling = {
        .subdivide = (uint32_t)node_integer(node_member(object, "subdivide"), 0, 0, 8),
        .sample = (uint32_t)node_integer(node_member(object, "sample"), 0, 0, MOST_SAMPLES),
    };
    if (object->schema || object->reader->result)
        return surfels;
    const Node *model = node_exists(&mesh) ? &mesh : &points;
    const GpResult result = open_model(model, model == &points, &sampling, pool, &surfels, &reason);
    if (result)
        scene_fail(model, result, &reason);
    return surfels;
}

static void place(Node *object, Surfels *surfels)
{
    Surfel *first = surfels->surfels;
    Node transform = node_member(object, "transform");
    const PlacedVertices vertices = { first ? first->position : NULL, first ? first->normal : NULL,
                                      sizeof *first, surfels->count };
    const Placed placed = scene_place(transform, node_member(object, "fit"), &vertices);
    if (placed.uneven)
        node_fail(&transform, GP_ERROR_FORMAT, "splats stay round: expected one scale");
    const SceneColor color = scene_color(node_member(object, "color"), &vertices);
    for (uint32_t i = 0; i < surfels->count; i++) {
        float rgba[4];
        first[i].radius *= (float)placed.scale;
        if (!color.given && !surfels->had_colors)
            memset(first[i].color, grey, sizeof first[i].color);
        if (!color.given)
            continue;
        scene_color_at(&color, first[i].position, first[i].normal, rgba);
        for (int k = 0; k < 3; k++)
            first[i].color[k] = color_byte(rgba[k]);
    }
}

/* --- what is drawn of them -------------------------------------------------------------------- */

static SplatSource all_of(const Surfels *surfels, SplatMethod method, Frame *frame)
{
    const SplatRun all = { method, 0, surfels->count, surfels_mean_radius(surfels), 0, false };
    return (SplatSource){ .surfels = surfels->surfels,
                          .runs = frame_copy(frame, &all, sizeof all),
                          .run_count = 1 };
}

static GpResult levels_of(const Surfels *surfels, SplatMethod method, const SceneView *view,
                          GpPool *pool, Frame *frame, SplatSource *source, GpError *error)
{
    const SplatView seen = view_of(view);
    const SplatDetail detail = { .pixels = 0 };
    SplatSetting chosen = setting;
    Patches patches = { .surfels = NULL };
    chosen.method = method;
    GpResult result = patches_build(surfels, NULL, pool, NULL, &patches, error);
    if (!result)
        result = splat_choose(&patches, &seen, &chosen, &detail, frame, source, error);
    if (!result)
        source->surfels =
            frame_copy(frame, patches.surfels, patches.surfel_count * sizeof *patches.surfels);
    patches_free(&patches);
    return result;
}

/* Room for one more of each; false without memory. */
static bool make_room(Loader *loader)
{
    if (loader->splat_count < loader->splat_room)
        return true;
    const uint32_t count = loader->splat_count, room = count ? 2 * count : 4;
    SplatSource *splats = frame_alloc(loader->frame, room, sizeof *splats);
    Surfels *models = frame_alloc(loader->frame, room, sizeof *models);
    if (!splats || !models)
        return false;
    if (count) {
        memcpy(splats, loader->splats, count * sizeof *splats);
        memcpy(models, loader->models, count * sizeof *models);
    }
    loader->splats = splats;
    loader->models = models;
    loader->splat_room = room;
    return true;
}

static void keep(Loader *loader, const Node *object, const SceneView *view, SplatMethod method,
                 GpPool *pool, const Surfels *surfels)
{
    Frame *frame = loader->frame;
    GpError reason = { "" };
    Surfel *all = frame_alloc(frame, surfels->count, sizeof *all);
    if (!all || !make_room(loader))
        return;
    SplatSource *source = &loader->splats[loader->splat_count];
    Surfels *model = &loader->models[loader->splat_count++];
    memcpy(all, surfels->surfels, surfels->count * sizeof *all);
    *model = (Surfels){ .surfels = all, .count = surfels->count };
    if (!splat_needs_patches(method)) {
        *source = all_of(model, method, frame);
        return;
    }
    const GpResult result = levels_of(surfels, method, view, pool, frame, source, &reason);
    if (result)
        scene_fail(object, result, &reason);
}

void scene_read_splats(Loader *loader, Node *object, const SceneView *view)
{
    static const char *const others[] = {
        "material", "state", "viewport", "tile", "size", "pixels"
    };
    GpPool *pool = NULL;
    GpError reason = { "" };
    Node method = node_member(object, "method");
    node_string(node_member(object, "name"), "");
    const int number = node_name(method, 0, methods, GP_COUNT(methods));
    node_without_default(&method);
    scene_refuse(object, others, GP_COUNT(others), "splats have none of their own");
    scene_refuse_without_volume(object);
    if (!object->schema && why_not(view))
        node_fail(object, GP_ERROR_FORMAT, "%s", why_not(view));
    const GpResult result = gp_pool_create(machine_processors(), &pool, &reason);
    if (result)
        scene_fail(object, result, &reason);
    Surfels surfels = read_surfels(object, pool);
    place(object, &surfels);
    if (!loader->reader.result && surfels.count > 0)
        keep(loader, object, view, (SplatMethod)number, pool, &surfels);
    surfels_free(&surfels);
    gp_pool_destroy(&pool);
}

/* --- the passes ------------------------------------------------------------------------------- */

static const char *pass_name(Loader *loader, const char *name, const char *what)
{
    char text[300];
    snprintf(text, sizeof text, "%.200s-%s", name, what);
    return scene_copy(loader, text);
}

void scene_draw_splats(Loader *loader, const SceneView *view, const char *name)
{
    const SplatGroup group = { loader->splats, loader->splat_count, view_of(view), setting };
    const SplatNames names = { pass_name(loader, name, "visibility"),
                               pass_name(loader, name, "splats"),
                               pass_name(loader, name, "surface") };
    OverUniforms uniforms = { .normalize = { .specular = SPLAT_SPECULAR,
                                             .shininess = SPLAT_SHININESS } };
    const SplatShading shading = { .program = &splat_over_program,
                                   .uniforms = &uniforms,
                                   .surface_slot = 1 };
    const Surfels *models = loader->models;
    loader->splats = NULL;
    loader->splat_count = loader->splat_room = 0;
    if (group.source_count == 0 || loader->frame->arena.result)
        return;
    scene_light_direction(view, uniforms.normalize.light);
    memcpy(uniforms.ambient, view->scene->ambient, sizeof uniforms.ambient);
    loader->scene->splats = group;
    loader->scene->splat_models = models;
    splat_build_over(&group, &names, &shading, view->color, view->depth, loader->frame);
}
