/* What a setting leaves open, and what it cannot ask for. */
#include "apps/techniques/shadow/setting.h"

#include "apps/techniques/shadow/discs.h"
#include "shaders_c/materials/mapped_phong.h"
#include "shaders_c/materials/phong.h"
#include "shaders_c/materials/textured_phong.h"

enum { DEFAULT_MAP = 1024 };

const ShadowSetting shadow_defaults = {
    .method = SHADOW_HARDWARE,
    .filter = SHADOW_BILINEAR,
    .facing = SHADOW_FLAT,
    .fit = LIGHT_FIT_CASTERS,
    .bias = SHADOW_AUTO,
    .slope = SHADOW_AUTO,
};

/* --- the map ---------------------------------------------------------------------------------- */

uint32_t shadow_map_size(const ShadowSetting *setting, const SceneLight *light)
{
    if (setting->map)
        return setting->map;
    return light->shadow.map ? light->shadow.map : DEFAULT_MAP;
}

GpFormat shadow_map_format(const ShadowSetting *setting, const SceneLight *light)
{
    static const GpFormat formats[] = { [SHADOW_D16] = GP_D16,
                                        [SHADOW_D24] = GP_D24S8,
                                        [SHADOW_D32F] = GP_D32F,
                                        [SHADOW_R32F] = GP_R32F };
    if (setting->depth != SHADOW_DEPTH_AUTO)
        return formats[setting->depth];
    if (setting->method == SHADOW_PLAIN)
        return GP_R32F;
    return light->shadow.format ? light->shadow.format : GP_D24S8;
}

GpSampler shadow_map_sampler(const ShadowSetting *setting)
{
    bool hardware = setting->method == SHADOW_HARDWARE;
    GpFilter filter = hardware && setting->filter == SHADOW_BILINEAR ? GP_LINEAR : GP_POINT;
    GpAddress outside = setting->outside == SHADOW_OUTSIDE_PRINTED ? GP_CLAMP : GP_BORDER;
    return (GpSampler){ .min = filter,
                        .mag = filter,
                        .address_u = outside,
                        .address_v = outside,
                        .border = { 1, 1, 1, 1 },
                        .compare = hardware };
}

/* --- refusals --------------------------------------------------------------------------------- */

/* Lights to all sides: three of their maps lie side by side. */
static GpResult check_cubes(const Scene *scene, const ShadowSetting *setting, GpError *error)
{
    for (uint32_t i = 0; i < scene->light_count; i++) {
        uint32_t size = shadow_map_size(setting, &scene->lights[i]);
        if (!light_shines_around(&scene->lights[i]))
            continue;
        if (setting->method == SHADOW_PLAIN)
            return gp_fail(
                error, GP_ERROR_INVALID,
                "lights[%u] shines to all sides, which the hardware method draws; for the "
                "plain one it must look at something (\"at\")",
                i);
        if (setting->fit == LIGHT_FIT_ADAPTIVE)
            return gp_fail(
                error, GP_ERROR_INVALID,
                "lights[%u] shines to all sides, whose cube map has no tiles; for the adaptive "
                "fit it must look at something (\"at\")",
                i);
        if (3 * size > GP_MAX_SIZE)
            return gp_fail(error, GP_ERROR_INVALID,
                           "lights[%u] shines to all sides: its map has at most %d texels a side, "
                           "not %u",
                           i, GP_MAX_SIZE / 3, size);
    }
    return GP_OK;
}

static bool has_size(const Scene *scene)
{
    bool any = false;
    for (uint32_t i = 0; i < scene->light_count; i++)
        any |= scene->lights[i].size > 0;
    return any;
}

/* Splats are lit once a pixel, when all else is drawn: by one light, whose map is one picture. */
static GpResult check_splats(const Scene *scene, const ShadowSetting *setting, GpError *error)
{
    if (scene->splats.source_count == 0)
        return GP_OK;
    if (scene->light_count != 1)
        return gp_fail(error, GP_ERROR_INVALID,
                       "splats have shadows under one light, and the scene has %u",
                       scene->light_count);
    if (light_shines_around(&scene->lights[0]))
        return gp_fail(error, GP_ERROR_INVALID,
                       "lights[0] shines to all sides, and splats have no shadows from a cube map; "
                       "it must look at something (\"at\")");
    if (setting->filter == SHADOW_SOFT)
        return gp_fail(error, GP_ERROR_INVALID, "splats have no soft shadows");
    if (setting->fit == LIGHT_FIT_ADAPTIVE)
        return gp_fail(error, GP_ERROR_INVALID,
                       "splats have no shadows by the adaptive fit, which asks object by object");
    return GP_OK;
}

GpResult shadow_check(const Scene *scene, const ShadowSetting *setting, GpError *error)
{
    bool plain = setting->method == SHADOW_PLAIN;
    if (plain && setting->depth != SHADOW_DEPTH_AUTO && setting->depth != SHADOW_R32F)
        return gp_fail(error, GP_ERROR_INVALID, "the plain method has its depths in r32f");
    if (!plain && setting->depth == SHADOW_R32F)
        return gp_fail(error, GP_ERROR_INVALID,
                       "r32f is no depth format: hardware has no use for it");
    if (!plain && setting->filter == SHADOW_SOFT)
        return gp_fail(error, GP_ERROR_INVALID,
                       "soft shadows read the depths themselves: they need the plain method");
    if (setting->filter == SHADOW_SOFT && !has_size(scene))
        return gp_fail(error, GP_ERROR_INVALID,
                       "no light has a size, so that there is nothing to soften");
    if (setting->filter == SHADOW_SOFT && setting->fit == LIGHT_FIT_EYE)
        return gp_fail(error, GP_ERROR_INVALID,
                       "soft shadows measure on the map, which the eye's fit warps");
    if (setting->fit == LIGHT_FIT_ADAPTIVE && (plain || setting->filter != SHADOW_BILINEAR))
        return gp_fail(
            error, GP_ERROR_INVALID,
            "the adaptive fit looks for edges where the hardware's bilinear filter finds "
            "them: it needs both");
    if (plain && setting->slope > 0)
        return gp_fail(error, GP_ERROR_INVALID,
                       "the plain method's depths are colours, which the rasterizer does not bias");
    if (scene->has_passes)
        return gp_fail(error, GP_ERROR_INVALID, "the scene has passes of its own");
    if (scene->light_count == 0)
        return gp_fail(error, GP_ERROR_INVALID, "the scene has no light");
    for (uint32_t i = 0; i < scene->list.passes[0].draw_count; i++) {
        const GpDraw *draw = &scene->list.passes[0].draws[i];
        if (draw->state.blend[0].op != GP_BLEND_OFF)
            return gp_fail(error, GP_ERROR_INVALID,
                           "%s is blended, which among shadows asks for the scene's \"order\": "
                           "\"depth\"",
                           draw->name[0] ? draw->name : "an object");
        if (draw->program != &phong_program && draw->program != &textured_phong_program &&
            draw->program != &mapped_phong_program && !shadow_is_disc(draw))
            return gp_fail(error, GP_ERROR_INVALID,
                           "objects[%u]: program %s has no shadows; phong, textured_phong and "
                           "mapped_phong have",
                           i, draw->program->name);
    }
    const GpResult result = check_splats(scene, setting, error);
    return result ? result : check_cubes(scene, setting, error);
}
