/* Loading: what belongs to the scene as a whole. */
#include "apps/scene/scene.h"

#include "apps/scene/lights.h"
#include "apps/scene/passes.h"
#include "apps/scene/path.h"
#include "apps/scene/state.h"
#include "pipeline/io/file.h"

#include <string.h>

static void read_view(Loader *loader, Node *root, const SceneOptions *options)
{
    Scene *scene = loader->scene;
    SceneView *view = &loader->view;
    view->scene = scene;
    view->width = view->height = 512;
    scene_read_size(node_member(root, "size"), view);
    if (options && options->width)
        view->width = options->width;
    if (options && options->height)
        view->height = options->height;
    if (options)
        loader->frame->window = options->window;
    loader->frame->window_of[0] = view->width;
    loader->frame->window_of[1] = view->height;
    view->camera =
        (Camera){ .eye = { 0, 1, 4 }, .up = { 0, 1, 0 }, .fovy = 40, .near = 0.1, .far = 100 };
    scene_read_camera(node_member(root, "camera"), &view->camera);
    if (options)
        camera_turn(&view->camera, options->turn);
    scene->camera = view->camera;
    scene->ambient[0] = scene->ambient[1] = scene->ambient[2] = 0.2f;
    node_numbers(node_member(root, "ambient"), scene->ambient, 3, 0, 100);
    scene->background[3] = 1;
    node_numbers(node_member(root, "background"), scene->background, 4, 0, 1);
    scene_read_lights(scene, node_member(root, "lights"));
    scene->shadows =
        node_bool(node_member(root, "shadows"), false) || (options && options->shadows);
}

static void read_passes(Loader *loader, Node *root)
{
    Node passes = node_member(root, "passes");
    if (node_lacks(&passes))
        scene_read_pass_body(loader, root, &loader->view, "main");
    if (!node_exists(&passes))
        return;
    loader->scene->has_passes = true;
    size_t count = node_length(passes, SIZE_MAX);
    if (count == 0)
        node_fail(&passes, GP_ERROR_FORMAT, "no pass");
    for (size_t i = 0; i < count && !loader->reader.result; i++)
        scene_read_pass(loader, node_element(&passes, i));
}

/* The picture is the last pass's, or the named one's. */
static void choose_picture(Loader *loader, Node node)
{
    const char *name = node_string(node, NULL);
    const GpPass *pass = name ? scene_find_pass(loader, name, strlen(name))
                              : &loader->frame->list.passes[loader->pass_count - 1];
    if (!pass)
        node_fail(&node, GP_ERROR_FORMAT, "no pass has this name");
    else if (!pass->color[0].surface)
        node_fail(&node, GP_ERROR_FORMAT, "the picture's pass has no colour target");
    loader->scene->list = loader->frame->list;
    loader->scene->picture = pass ? pass->color[0].surface : NULL;
    loader->scene->depth = pass ? pass->depth.surface : NULL;
}

static void read_scene(Loader *loader, const SceneOptions *options)
{
    Node root = node_root(&loader->reader);
    node_string(node_member(&root, "about"), "");   /* for people */
    node_string(node_member(&root, "$schema"), ""); /* for editors */
    read_view(loader, &root, options);
    read_passes(loader, &root);
    Node picture = node_member(&root, "picture");
    if (!loader->reader.result && !loader->frame->arena.result)
        choose_picture(loader, picture);
    node_close(&root);
}

SceneOutline scene_outline(const char *path)
{
    const double of_object =
        30000; /* in pixels of a pass: a mesh is read, and its vertices shaded */
    SceneOutline outline = { .width = 512, .height = 512 };
    char found[4096];
    Reader reader;
    GpError unused = { "" };
    if (gp_data_find(path, found, sizeof found, &unused) || reader_open(&reader, found, &unused))
        return outline;
    const json_t *size = json_object_get(reader.root, "size");
    const json_t *passes = json_object_get(reader.root, "passes");
    const json_int_t width = json_integer_value(json_array_get(size, 0));
    const json_int_t height = json_integer_value(json_array_get(size, 1));
    if (width >= 1 && width <= GP_MAX_SIZE && height >= 1 && height <= GP_MAX_SIZE) {
        outline.width = (uint32_t)width;
        outline.height = (uint32_t)height;
    }
    size_t objects = json_array_size(json_object_get(reader.root, "objects"));
    const size_t count = json_array_size(passes);
    for (size_t p = 0; p < count; p++)
        objects += json_array_size(json_object_get(json_array_get(passes, p), "objects"));
    outline.cost = (double)outline.width * outline.height * (double)(count ? count : 1) +
                   of_object * (double)objects;
    reader_close(&reader);
    return outline;
}

json_t *scene_schema(void)
{
    Scene scene = { .frame = { .list = { .passes = NULL } } };
    Loader loader = { .scene = &scene, .frame = &scene.frame };
    reader_describe(&loader.reader);
    json_t *schema = loader.reader.schema;
    json_object_set_new(schema, "$schema", json_string("http://json-schema.org/draft-07/schema#"));
    json_object_set_new(schema, "title",
                        json_string("A scene of glasspipe; see glasspipe-scene(5)"));
    read_scene(&loader, NULL);
    scene_free(&scene);
    return schema;
}

GpResult scene_load(const char *path, const SceneOptions *options, Scene *scene, GpError *error)
{
    GpError unused;
    Scene made = { .frame = { .arena = { .fails = options ? options->fails : 0 } } };
    Loader loader = { .scene = &made, .frame = &made.frame };
    GpError reason = { "" };
    char found[4096];
    GpResult result = gp_data_find(path, found, sizeof found, error);
    if (!result)
        result = reader_open(&loader.reader, found, error ? error : &unused);
    if (result)
        return result;
    if (options && options->changes)
        result = path_change(loader.reader.root, options->changes, &reason);
    if (result)
        loader.reader.result = gp_fail(error, result, "%.200s: %s", path, reason.text);
    else
        read_scene(&loader, options);
    result = loader.reader.result;
    if (made.frame.arena.result)
        result = gp_fail(error, made.frame.arena.result, "%.200s: %s", path,
                         made.frame.arena.error.text);
    reader_close(&loader.reader);
    if (result)
        scene_free(&made);
    else
        *scene = made;
    return result;
}

void scene_free(Scene *scene)
{
    frame_free(&scene->shadowed);
    frame_free(&scene->frame);
    *scene = (Scene){ 0 };
}
