/* Loading: what belongs to the scene as a whole, and what is freed with it. */
#include "apps/scene/loader.h"

#include <stdio.h>
#include <string.h>

/* --- memory ---------------------------------------------------------------------------------- */

typedef struct SceneBlock {
    struct SceneBlock *next;
    void *memory;
} SceneBlock;

bool scene_own_memory(Loader *loader, void *memory)
{
    SceneBlock *block = memory ? gp_alloc(1, sizeof *block) : NULL;
    if (!block) {
        gp_free(memory);
        Node root = node_root(&loader->reader);
        node_fail(&root, GP_ERROR_MEMORY, "no memory");
        return false;
    }
    *block = (SceneBlock){ loader->store->blocks, memory };
    loader->store->blocks = block;
    return true;
}

void *scene_alloc(Loader *loader, size_t count, size_t size)
{
    void *memory = gp_alloc(count, size);
    return scene_own_memory(loader, memory) ? memory : NULL;
}

void scene_own(Loader *loader, GpSurface *surface)
{
    SceneStore *store = loader->store;
    if (store->surface_count < SCENE_MAX_SURFACES) {
        store->surfaces[store->surface_count++] = surface;
        return;
    }
    gp_surface_destroy(&surface);
    Node root = node_root(&loader->reader);
    node_fail(&root, GP_ERROR_FORMAT, "more than %d surfaces", SCENE_MAX_SURFACES);
}

void scene_free(Scene *scene)
{
    SceneStore *store = scene->store;
    if (store) {
        while (store->blocks) {
            SceneBlock *block = store->blocks;
            store->blocks = block->next;
            gp_free(block->memory);
            gp_free(block);
        }
        for (uint32_t i = 0; i < store->surface_count; i++)
            gp_surface_destroy(&store->surfaces[i]);
        gp_free(store);
    }
    *scene = (Scene){ 0 };
}

void scene_fail(const Node *node, GpResult result, const GpError *reason)
{
    node_fail(node, result == GP_ERROR_MEMORY ? result : GP_ERROR_FORMAT, "%s",
              reason->text[0] ? reason->text : gp_result_name(result));
}

/* --- names of targets ------------------------------------------------------------------------ */

static const GpPass *find_pass(const Scene *scene, const char *name, size_t length)
{
    for (uint32_t i = 0; i < scene->list.pass_count; i++) {
        const GpPass *pass = &scene->list.passes[i];
        if (strlen(pass->name) == length && memcmp(pass->name, name, length) == 0)
            return pass;
    }
    return NULL;
}

GpSurface *scene_target(Loader *loader, const Node *node, const char *name)
{
    const char *pass_name = strncmp(name, "pass:", 5) == 0 ? name + 5 : name;
    const char *dot = strchr(pass_name, '.');
    size_t length = dot ? (size_t)(dot - pass_name) : strlen(pass_name);
    const GpPass *pass = find_pass(loader->scene, pass_name, length);
    GpSurface *surface = NULL;
    if (pass && dot && strcmp(dot, ".depth") == 0)
        surface = pass->depth.surface;
    else if (pass && dot && dot[1] >= '0' && dot[1] < '0' + GP_MAX_TARGETS && !dot[2])
        surface = pass->color[dot[1] - '0'].surface;
    else if (pass && !dot)
        surface = pass->color[0].surface;
    if (!surface)
        node_fail(node, GP_ERROR_FORMAT, "no earlier pass has a target '%.60s'", name);
    return surface;
}

/* --- the scene as a whole -------------------------------------------------------------------- */

/* "shadow" of a light: what its map sees. */
static void read_shadow(Node node, const SceneLight *light, SceneShadow *shadow)
{
    Node up = node_member(&node, "up"), fovy = node_member(&node, "fovy");
    Node height = node_member(&node, "height"), near = node_member(&node, "near");
    Node far = node_member(&node, "far"), map = node_member(&node, "map");
    Node format = node_member(&node, "format");
    static const char *const format_names[] = { "auto", "d16", "d24", "d32f" };
    static const GpFormat formats[] = { GP_FORMAT_NONE, GP_D16, GP_D24S8, GP_D32F };
    *shadow = (SceneShadow){ .up = { 0, 1, 0 } };
    node_doubles(&up, shadow->up, 3, -1e6, 1e6);
    shadow->fovy = node_double(&fovy, 0, 1, 170);
    shadow->height = node_double(&height, 0, 1e-6, 1e6);
    shadow->near = node_double(&near, 0, 1e-6, 1e6);
    shadow->far = node_double(&far, 0, 1e-6, 1e6);
    shadow->map = (uint32_t)node_integer(&map, 0, 16, GP_MAX_SIZE);
    shadow->format = formats[node_name(&format, 0, format_names, GP_COUNT(formats))];
    bool has_near = node_exists(&near), has_far = node_exists(&far);
    if (has_near != has_far || (has_far && shadow->near >= shadow->far))
        node_fail(&node, GP_ERROR_FORMAT, "expected near < far, or neither");
    if (node_exists(&fovy) && !light->aims)
        node_fail(&fovy, GP_ERROR_FORMAT, "the light looks at nothing: it has no \"at\"");
    if (node_exists(&height) && !light->directional)
        node_fail(&height, GP_ERROR_FORMAT, "only parallel rays have a height");
    if (node_exists(&node))
        node_close(&node);
}

static void read_light(Node node, SceneLight *light)
{
    Node position = node_member(&node, "position"), direction = node_member(&node, "direction");
    Node color = node_member(&node, "color"), range = node_member(&node, "range");
    Node at = node_member(&node, "at"), cone = node_member(&node, "cone");
    Node size = node_member(&node, "size");
    *light = (SceneLight){ .color = { 1, 1, 1 },
                           .directional = node_exists(&direction),
                           .aims = node_exists(&at) };
    if (node_exists(&position) == node_exists(&direction))
        node_fail(&node, GP_ERROR_FORMAT, "expected a position or a direction");
    node_doubles(light->directional ? &direction : &position, light->position, 3, -1e6, 1e6);
    if (light->directional && vector_dot(light->position, light->position) == 0.0)
        node_fail(&direction, GP_ERROR_FORMAT, "a direction has some length");
    if (light->directional)
        vector_normalize(light->position);
    node_numbers(&color, light->color, 3, 0, 100);
    light->range = node_number(&range, 0, 0, 1e6f);
    node_doubles(&at, light->at, 3, -1e6, 1e6);
    if (light->aims && !light->directional &&
        memcmp(light->at, light->position, sizeof light->at) == 0)
        node_fail(&at, GP_ERROR_FORMAT, "the light looks at itself");
    light->cone = node_double(&cone, 0, 0.1, 85);
    if (light->cone > 0 && (!light->aims || light->directional))
        node_fail(&cone, GP_ERROR_FORMAT, "a cone needs a position, and \"at\" for its axis");
    light->size = node_double(&size, 0, 0, 1e6);
    if (light->size > 0 && (!light->aims || light->directional))
        node_fail(&size, GP_ERROR_FORMAT, "a light with a size needs a position, and \"at\"");
    read_shadow(node_member(&node, "shadow"), light, &light->shadow);
    node_close(&node);
}

static void read_lights(Loader *loader, Node node)
{
    Scene *scene = loader->scene;
    scene->lights[0] =
        (SceneLight){ .position = { 0.4, 0.8, 0.45 }, .directional = true, .color = { 1, 1, 1 } };
    vector_normalize(scene->lights[0].position);
    scene->light_count = 1;
    if (node_exists(&node)) {
        scene->light_count = (uint32_t)node_length(&node, SCENE_MAX_LIGHTS);
        for (uint32_t i = 0; i < scene->light_count; i++)
            read_light(node_element(&node, i), &scene->lights[i]);
    }
    loader->view.lights = scene->lights;
    loader->view.light_count = scene->light_count;
}

static void read_view(Loader *loader, Node *root, const SceneOptions *options)
{
    SceneView *view = &loader->view;
    Node size_node = node_member(root, "size"), background = node_member(root, "background");
    Node ambient = node_member(root, "ambient");
    view->width = view->height = 512;
    scene_read_size(&size_node, view);
    if (options && options->width)
        view->width = options->width;
    if (options && options->height)
        view->height = options->height;
    view->camera =
        (Camera){ .eye = { 0, 1, 4 }, .up = { 0, 1, 0 }, .fovy = 40, .near = 0.1, .far = 100 };
    scene_read_camera(node_member(root, "camera"), &view->camera);
    view->ambient[0] = view->ambient[1] = view->ambient[2] = 0.2f;
    node_numbers(&ambient, view->ambient, 3, 0, 100);
    view->background[3] = 1;
    node_numbers(&background, view->background, 4, 0, 1);
    read_lights(loader, node_member(root, "lights"));
    loader->scene->camera = view->camera;
    memcpy(loader->scene->ambient, view->ambient, sizeof view->ambient);
    memcpy(loader->scene->background, view->background, sizeof view->background);
}

static void read_passes(Loader *loader, Node *root)
{
    Node passes = node_member(root, "passes");
    GpList *list = &loader->scene->list;
    list->passes = loader->store->passes;
    if (!node_exists(&passes)) {
        scene_read_pass_body(loader, root, &loader->view, &loader->store->passes[0]);
        list->pass_count = 1;
        return;
    }
    size_t count = node_length(&passes, SCENE_MAX_PASSES);
    if (count == 0)
        node_fail(&passes, GP_ERROR_FORMAT, "no pass");
    for (size_t i = 0; i < count && !loader->reader.result; i++) {
        scene_read_pass(loader, node_element(&passes, i), &loader->store->passes[i]);
        list->pass_count++;
    }
}

/* The picture is the last pass's, or the named one's. */
static void choose_picture(Loader *loader, Node node)
{
    Scene *scene = loader->scene;
    const GpPass *pass = &scene->list.passes[scene->list.pass_count - 1];
    const char *name = node_string(&node, NULL);
    if (name) {
        pass = find_pass(scene, name, strlen(name));
        if (!pass)
            node_fail(&node, GP_ERROR_FORMAT, "no pass has this name");
    }
    if (pass && !pass->color[0].surface)
        node_fail(&node, GP_ERROR_FORMAT, "the picture's pass has no colour target");
    scene->picture = pass ? pass->color[0].surface : NULL;
    scene->depth = pass ? pass->depth.surface : NULL;
}

static void read_scene(Loader *loader, const SceneOptions *options)
{
    Node root = node_root(&loader->reader);
    Node about = node_member(&root, "about"); /* for people */
    node_string(&about, "");
    read_view(loader, &root, options);
    read_passes(loader, &root);
    Node picture = node_member(&root, "picture");
    if (!loader->reader.result)
        choose_picture(loader, picture);
    node_close(&root);
}

GpResult scene_load(const char *path, const SceneOptions *options, Scene *scene, GpError *error)
{
    GpError unused;
    Scene made = { 0 };
    Loader loader = { .scene = &made, .error = error ? error : &unused };
    GpResult result = reader_open(&loader.reader, path, loader.error);
    if (result)
        return result;
    made.store = loader.store = gp_alloc(1, sizeof *made.store);
    if (made.store)
        read_scene(&loader, options);
    else
        loader.reader.result = gp_fail(error, GP_ERROR_MEMORY, "%.200s: no memory", path);
    result = loader.reader.result;
    reader_close(&loader.reader);
    if (result)
        scene_free(&made);
    else
        *scene = made;
    return result;
}
