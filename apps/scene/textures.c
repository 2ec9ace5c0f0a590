#include "apps/scene/textures.h"

#include "apps/frame/picture.h"
#include "apps/scene/model.h"
#include "apps/scene/patterns.h"
#include "pipeline/io/file.h"

#include <string.h>

/* --- pictures --------------------------------------------------------------------------------- */

GpResult scene_open_picture(const char *scene, const char *name, bool srgb, bool mips,
                            GpSurface **surface, GpError *error)
{
    char path[4096];
    const char *pattern = model_after(name, "builtin:");
    if (pattern)
        return pattern_create(pattern, srgb, mips, surface, error);
    GpResult result = gp_data_find_beside(scene, name, path, sizeof path, error);
    return result ? result : picture_read_surface(path, srgb, mips, surface, error);
}

/* A picture that the scene has already, or a new one. */
static const GpSurface *find_image(Loader *loader, const Node *node, const char *name, bool srgb,
                                   bool mips)
{
    for (const SceneImage *image = loader->images; image; image = image->next)
        if (strcmp(image->name, name) == 0 && image->srgb == srgb && image->mips == mips)
            return image->surface;
    GpSurface *surface = NULL;
    GpError reason = { "" };
    GpResult result = scene_open_picture(loader->reader.file, name, srgb, mips, &surface, &reason);
    if (result) {
        scene_fail(node, result, &reason);
        return NULL;
    }
    surface = arena_own_surface(&loader->frame->arena, surface);
    SceneImage *image = frame_alloc(loader->frame, 1, sizeof *image);
    if (image) {
        *image = (SceneImage){ loader->images, name, surface, srgb, mips };
        loader->images = image;
    }
    return surface;
}

/* --- samplers --------------------------------------------------------------------------------- */

/* "address": one name for both directions, or two. */
static void read_address(Node node, GpSampler *sampler)
{
    Node u = node, v = node;
    if (node_is(&node, JSON_ARRAY) && node_has_length(node, 2, "one name or two")) {
        u = node_element(&node, 0);
        v = node_element(&node, 1);
    }
    sampler->address_u =
        (GpAddress)node_name(u, (int)sampler->address_u, gp_address_names, GP_ADDRESSES);
    sampler->address_v =
        (GpAddress)node_name(v, (int)sampler->address_v, gp_address_names, GP_ADDRESSES);
    if (node_is_not(&node, JSON_ARRAY)) /* of a target it is another */
        node_name(node, 0, gp_address_names, GP_ADDRESSES);
    node_without_default(&node);
}

static void read_sampler(Node *object, GpSampler *sampler)
{
    node_enum(object, "min", gp_filter_names, GP_FILTERS, &sampler->min);
    node_enum(object, "mag", gp_filter_names, GP_FILTERS, &sampler->mag);
    node_enum(object, "mip", gp_mip_filter_names, GP_MIP_FILTERS, &sampler->mip);
    Node mip = node_member(object, "mip");
    node_without_default(&mip); /* of a target it is another */
    read_address(node_member(object, "address"), sampler);
    node_numbers(node_member(object, "border"), sampler->border, 4, 0, 1);
    sampler->lod_bias = node_number(node_member(object, "lod_bias"), 0, -16, 15);
    sampler->min_lod = node_number(node_member(object, "min_lod"), 0, 0, GP_MAX_LEVELS);
    sampler->max_lod = node_number(node_member(object, "max_lod"), GP_MAX_LEVELS, 0, GP_MAX_LEVELS);
    sampler->has_max_lod = true;
    sampler->compare = node_bool(node_member(object, "compare"), false);
}

void scene_read_texture(Loader *loader, Node node, GpTexture *texture)
{
    node_define(&node, "texture");
    Node image = node_member(&node, "image"), srgb_node = node_member(&node, "srgb");
    node_require(&image);
    const char *name = node_string(image, "");
    node_examples(&image, "builtin:", pattern_name);
    bool is_target = strncmp(name, "pass:", 5) == 0;
    bool srgb = node_bool(srgb_node, false);
    GpSampler *sampler = &texture->sampler;
    sampler->min = sampler->mag = GP_LINEAR;
    sampler->mip = is_target ? GP_MIP_NONE : GP_MIP_LINEAR;
    sampler->address_u = sampler->address_v = is_target ? GP_CLAMP : GP_WRAP;
    read_sampler(&node, sampler);
    node_close(&node);
    if (loader->reader.result || node_lacks(&node))
        return;
    if (is_target && srgb)
        node_fail(&srgb_node, GP_ERROR_FORMAT, "targets of passes are linear");
    texture->surface = is_target
                           ? scene_target(loader, &image, name)
                           : find_image(loader, &image, name, srgb, sampler->mip != GP_MIP_NONE);
}
