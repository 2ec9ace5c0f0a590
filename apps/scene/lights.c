#include "apps/scene/lights.h"

#include <string.h>

/* "shadow" of a light: what its map sees. */
static void read_shadow(Node node, const SceneLight *light, SceneShadow *shadow)
{
    node_define(&node, "shadow");
    Node fovy = node_member(&node, "fovy"), height = node_member(&node, "height");
    Node near = node_member(&node, "near"), far = node_member(&node, "far");
    static const char *const format_names[] = { "auto", "d16", "d24", "d32f" };
    static const GpFormat formats[] = { GP_FORMAT_NONE, GP_D16, GP_D24S8, GP_D32F };
    *shadow = (SceneShadow){ .up = { 0, 1, 0 } };
    node_doubles(node_member(&node, "up"), shadow->up, 3, -1e6, 1e6);
    shadow->fovy = node_double(fovy, 0, 1, 170);
    shadow->height = node_double(height, 0, 1e-6, 1e6);
    shadow->near = node_double(near, 0, 1e-6, 1e6);
    shadow->far = node_double(far, 0, 1e-6, 1e6);
    shadow->map = (uint32_t)node_integer(node_member(&node, "map"), 0, 16, GP_MAX_SIZE);
    shadow->format =
        formats[node_name(node_member(&node, "format"), 0, format_names, GP_COUNT(formats))];
    bool has_near = node_exists(&near), has_far = node_exists(&far);
    if (has_near != has_far || (has_far && shadow->near >= shadow->far))
        node_fail(&node, GP_ERROR_FORMAT, "expected near < far, or neither");
    if (node_exists(&fovy) && !light->aims)
        node_fail(&fovy, GP_ERROR_FORMAT, "the light looks at nothing: it has no \"at\"");
    if (node_exists(&height) && !light->directional)
        node_fail(&height, GP_ERROR_FORMAT, "only parallel rays have a height");
    node_close(&node);
}

static void read_light(Node node, SceneLight *light)
{
    node_define(&node, "light");
    Node position = node_member(&node, "position"), direction = node_member(&node, "direction");
    Node at = node_member(&node, "at"), cone = node_member(&node, "cone");
    Node size = node_member(&node, "size");
    *light = (SceneLight){ .color = { 1, 1, 1 },
                           .directional = node_exists(&direction),
                           .aims = node_exists(&at) };
    node_doubles(position, light->position, 3, -1e6, 1e6);
    node_doubles(direction, light->position, 3, -1e6, 1e6);
    node_one_of((const Node *const[]){ &position, &direction }, 2, "a position or a direction");
    if (light->directional && vector_dot(light->position, light->position) == 0.0)
        node_fail(&direction, GP_ERROR_FORMAT, "a direction has some length");
    if (light->directional)
        vector_normalize(light->position);
    node_numbers(node_member(&node, "color"), light->color, 3, 0, 100);
    light->range = node_number(node_member(&node, "range"), 0, 0, 1e6f);
    node_doubles(at, light->at, 3, -1e6, 1e6);
    node_without_default(&at);
    if (light->aims && !light->directional &&
        memcmp(light->at, light->position, sizeof light->at) == 0)
        node_fail(&at, GP_ERROR_FORMAT, "the light looks at itself");
    light->cone = node_double(cone, 0, 0.1, 85);
    if (light->cone > 0 && (!light->aims || light->directional))
        node_fail(&cone, GP_ERROR_FORMAT, "a cone needs a position, and \"at\" for its axis");
    light->size = node_double(size, 0, 0, 1e6);
    if (light->size > 0 && (!light->aims || light->directional))
        node_fail(&size, GP_ERROR_FORMAT, "a light with a size needs a position, and \"at\"");
    read_shadow(node_member(&node, "shadow"), light, &light->shadow);
    node_close(&node);
}

void scene_read_lights(Scene *scene, Node node)
{
    scene->lights[0] =
        (SceneLight){ .position = { 0.4, 0.8, 0.45 }, .directional = true, .color = { 1, 1, 1 } };
    vector_normalize(scene->lights[0].position);
    scene->light_count = 1;
    if (node_exists(&node)) {
        scene->light_count = (uint32_t)node_length(node, SCENE_MAX_LIGHTS);
        for (uint32_t i = 0; i < scene->light_count; i++)
            read_light(node_element(&node, i), &scene->lights[i]);
    }
}
