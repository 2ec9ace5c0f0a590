#include "apps/scene/loader.h"

#include "apps/frame/passes.h"

#include <string.h>

const char *scene_copy(Loader *loader, const char *text)
{
    const char *copy = frame_copy(loader->frame, text, strlen(text) + 1);
    return copy ? copy : "";
}

void scene_fail(const Node *node, GpResult result, const GpError *reason)
{
    node_fail(node, result == GP_ERROR_MEMORY ? result : GP_ERROR_FORMAT, "%s",
              reason->text[0] ? reason->text : gp_result_name(result));
}

const GpPass *scene_find_pass(const Loader *loader, const char *name, size_t length)
{
    for (uint32_t i = 0; i < loader->pass_count; i++) {
        const GpPass *pass = &loader->frame->list.passes[i];
        if (strlen(pass->name) == length && memcmp(pass->name, name, length) == 0)
            return pass;
    }
    return NULL;
}

GpSurface *scene_target(const Loader *loader, const Node *node, const char *name)
{
    const char *pass_name = strncmp(name, "pass:", 5) == 0 ? name + 5 : name;
    const char *dot = strchr(pass_name, '.');
    size_t length = dot ? (size_t)(dot - pass_name) : strlen(pass_name);
    const GpPass *pass = scene_find_pass(loader, pass_name, length);
    GpSurface *surface = pass ? pass_target(pass, dot ? dot + 1 : "0") : NULL;
    if (!surface)
        node_fail(node, GP_ERROR_FORMAT, "no earlier pass has a target '%.60s'", name);
    return surface;
}

void scene_refuse(Node *object, const char *const *keys, size_t count, const char *reason)
{
    for (size_t i = 0; i < count && !object->schema; i++) {
        Node node = node_member(object, keys[i]);
        if (node_exists(&node))
            node_fail(&node, GP_ERROR_FORMAT, "%s", reason);
    }
}
