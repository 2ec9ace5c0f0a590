#include "apps/scene/passes.h"

#include "apps/scene/blended.h"
#include "apps/scene/objects.h"
#include "apps/scene/splats.h"
#include "apps/scene/volumes.h"
#include "apps/scene/state.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

/* Bytes that all surfaces of a scene's passes may have together. */
static const uint64_t max_texels = (uint64_t)1 << 30;

/* Formats of depth targets, or of colour targets, in small letters; capitals are taken too. */
static GpFormat read_format(Node node, bool depth, GpFormat fallback)
{
    char names[GP_FORMATS][24];
    const char *list[GP_FORMATS];
    GpFormat formats[GP_FORMATS];
    const char *given = node_string(node, NULL);
    int count = 0, number = 0;
    for (GpFormat format = GP_FORMAT_NONE + 1; format < GP_FORMATS; format++) {
        const GpFormatInfo *info = gp_format_info(format);
        if (depth ? !info->is_depth : !info->is_target)
            continue;
        for (size_t i = 0; i <= strlen(info->name); i++)
            names[format][i] = (char)tolower((unsigned char)info->name[i]);
        number = format == fallback ? count : number;
        formats[count] = format;
        list[count++] = names[format];
        if (given && strcasecmp(given, info->name) == 0)
            return format;
    }
    return formats[node_name(node, number, list, count)];
}

/* "use": a target of an earlier pass, kept unless it is cleared; otherwise a new surface. */
static GpSurface *read_surface(Loader *loader, Node *node, const SceneView *view, bool depth,
                               GpFormat format, bool *is_new)
{
    Node use = node_member(node, "use"), format_node = node_member(node, "format");
    const char *name = node_string(use, NULL);
    *is_new = node_lacks(&use);
    format = read_format(format_node, depth, format);
    if (!*is_new) {
        if (node_exists(&format_node))
            node_fail(&format_node, GP_ERROR_FORMAT, "a target that is used again has its format");
        return name ? scene_target(loader, &use, name) : NULL;
    }
    if (loader->reader.result)
        return NULL;
    GpSurface *surface = frame_target(loader->frame, format, view->width, view->height);
    const GpRect *window = &surface->window;
    loader->texels += (uint64_t)(window->x1 - window->x0) * (uint64_t)(window->y1 - window->y0) *
                      gp_format_info(format)->bytes;
    if (loader->texels > max_texels)
        node_fail(node, GP_ERROR_FORMAT, "the targets take over %d MB", (int)(max_texels >> 20));
    return loader->reader.result ? NULL : surface;
}

/* "clear": a colour, or false. What is not said: the background for new surfaces. */
static void read_color_target(Loader *loader, Node node, const SceneView *view,
                              GpColorTarget *target)
{
    node_define(&node, "target");
    Node clear = node_member(&node, "clear");
    target->surface = read_surface(loader, &node, view, false, GP_A8R8G8B8, &target->clear);
    memcpy(target->clear_color, view->scene->background, sizeof view->scene->background);
    if (node_exists(&clear)) {
        target->clear = !node_is_false(&clear);
        if (target->clear)
            node_numbers(clear, target->clear_color, 4, -65504, 65504);
        node_without_default(&clear);
    }
    if (target->surface && !gp_format_info(target->surface->format)->is_target)
        node_fail(&node, GP_ERROR_FORMAT, "%s is no format for a colour target",
                  gp_format_info(target->surface->format)->name);
    node_close(&node);
}

/* "depth": false, or an object with "clear": a depth or false, "stencil": a value or false. */
static void read_depth_target(Loader *loader, Node node, const SceneView *view,
                              GpDepthTarget *target)
{
    if (node_is_false(&node))
        return;
    node_define(&node, "depth_target");
    Node clear = node_member(&node, "clear"), stencil = node_member(&node, "stencil");
    bool is_new;
    target->surface = read_surface(loader, &node, view, true, GP_D24S8, &is_new);
    target->clear_depth = node_exists(&clear) ? !node_is_false(&clear) : is_new;
    target->clear_stencil = node_exists(&stencil) ? !node_is_false(&stencil) : is_new;
    target->depth_value = 1;
    if (target->clear_depth)
        target->depth_value = node_number(clear, 1, 0, 1);
    if (target->clear_stencil)
        target->stencil_value = (uint8_t)node_integer(stencil, 0, 0, 255);
    if (target->surface) {
        const GpFormatInfo *info = gp_format_info(target->surface->format);
        target->clear_stencil = target->clear_stencil && info->has_stencil;
        if (!info->is_depth)
            node_fail(&node, GP_ERROR_FORMAT, "%s is no format for depth", info->name);
    }
    node_close(&node);
}

static void read_targets(Loader *loader, Node *node, const SceneView *view, GpPass *pass)
{
    Node targets = node_member(node, "targets");
    if (node_exists(&targets)) {
        size_t count = node_length(targets, GP_MAX_TARGETS);
        for (size_t i = 0; i < count; i++)
            read_color_target(loader, node_element(&targets, i), view, &pass->color[i]);
    } else {
        read_color_target(loader, targets, view, &pass->color[0]);
    }
    read_depth_target(loader, node_member(node, "depth"), view, &pass->depth);
}

static void read_draws(Loader *loader, Node *node, const SceneView *view)
{
    const GpGeometry none = { .vertex_count = 0 };
    Node objects = node_member(node, "objects"), quad = node_member(node, "quad");
    size_t count = node_length(objects, SIZE_MAX);
    for (size_t i = 0; i < count && !loader->reader.result; i++)
        scene_read_object(loader, node_element(&objects, i), view);
    if (node_exists(&quad))
        scene_read_quad(loader, quad, view, frame_draw(loader->frame, NULL, NULL, &none));
}

void scene_read_pass_body(Loader *loader, Node *node, const SceneView *view, const char *name)
{
    SceneView own = *view;
    scene_read_viewport(node_member(node, "viewport"), &own.viewport);
    double width = (double)own.viewport.width, height = (double)own.viewport.height;
    double aspect = width > 0 ? width / height : (double)own.width / own.height;
    camera_matrix(&own.camera, aspect, own.world_to_clip);
    GpPass *pass = frame_pass(loader->frame, name, NULL, NULL, NULL);
    read_targets(loader, node, &own, pass);
    node_enum(node, "order", gp_order_names, GP_ORDERS, &pass->order);
    own.has_depth = pass->depth.surface != NULL;
    own.color = pass->color[0].surface;
    own.color_count = pass->color[1].surface ? 2 : 1;
    own.depth = pass->depth.surface;
    if (!loader->reader.result)
        read_draws(loader, node, &own);
    const SceneBlended blended = scene_take_blended(loader, node);
    if (blended.count > 0)
        pass->order = GP_ORDER_SUBMITTED; /* of opaque things it makes no difference */
    if (!loader->reader.result)
        scene_draw_splats(loader, &own, name);
    loader->scene->over = loader->frame->list.pass_count;
    if (!loader->reader.result) {
        SceneVolume *volumes = scene_draw_volumes(loader, &own, name);
        scene_draw_blended(loader, node, &blended, volumes, &own, name);
    }
    loader->pass_count = loader->frame->list.pass_count;
}

void scene_read_size(Node node, SceneView *view)
{
    if (!node_exists(&node))
        return;
    long size[2] = { view->width, view->height };
    node_integers(node, size, 2, 1, GP_MAX_SIZE);
    view->width = (uint32_t)size[0];
    view->height = (uint32_t)size[1];
}

void scene_read_pass(Loader *loader, Node node)
{
    SceneView view = loader->view;
    node_define(&node, "pass");
    Node name_node = node_member(&node, "name");
    node_require(&name_node);
    const char *name = scene_copy(loader, node_string(name_node, ""));
    if (strchr(name, '.') || !name[0])
        node_fail(&name_node, GP_ERROR_FORMAT, "expected a name without dots");
    if (scene_find_pass(loader, name, strlen(name)))
        node_fail(&name_node, GP_ERROR_FORMAT, "another pass has this name");
    Node size = node_member(&node, "size");
    scene_read_size(size, &view);
    node_without_default(&size);
    scene_read_camera(node_member(&node, "camera"), &view.camera);
    scene_read_pass_body(loader, &node, &view, name);
    node_close(&node);
}
