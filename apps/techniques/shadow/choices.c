/* What a setting leaves open, and what it cannot ask for. */
#include "apps/techniques/shadow/parts.h"

#include "shaders_c/materials/phong.h"
#include "shaders_c/materials/textured_phong.h"

#include <math.h>

enum { DEFAULT_MAP = 1024 };

/* --- the map ---------------------------------------------------------------------------------- */

bool shadow_has_six_sides(const SceneLight *light)
{
    return !light->directional && !light->aims;
}

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

/* --- the bias --------------------------------------------------------------------------------- */

/* An offset is of no use to six sides, which look things up by where they are. */
static bool needs_bias(const ShadowSetting *setting, const ShadowLamp *lamp)
{
    return setting->casters != SHADOW_FAR_SIDES && (lamp->six_sides || !(setting->offset > 0));
}

double shadow_slope(const ShadowSetting *setting, const ShadowLamp *lamp)
{
    if (setting->slope >= 0 || setting->method == SHADOW_PLAIN || !needs_bias(setting, lamp))
        return fmax(setting->slope, 0);
    return setting->filter == SHADOW_BILINEAR ? 2 : 1;
}

double shadow_bias(const ShadowSetting *setting, const ShadowLamp *lamp)
{
    const LightView *view = &lamp->view[0];
    const double steep = 16; /* rise over a texel's side */
    if (setting->bias >= 0 || !needs_bias(setting, lamp))
        return fmax(setting->bias, 0);
    if (setting->method == SHADOW_HARDWARE)
        return lamp->map->format == GP_D16 ? 0x1p-16 : 0x1p-24;
    /* Depth grows by this over a unit of length, and a texel is so many units wide. */
    double middle = 0.5 * (view->near + view->far), range = view->far - view->near;
    double scaling =
        view->parallel ? 1 / range : view->near * view->far / range / (middle * middle);
    return steep * scaling * view->width * (view->parallel ? 1 : middle) / lamp->size;
}

/* --- refusals --------------------------------------------------------------------------------- */

/* Lights to all sides: three of their maps lie side by side. */
static GpResult check_six_sides(const Scene *scene, const ShadowSetting *setting, GpError *error)
{
    for (uint32_t i = 0; i < scene->light_count; i++) {
        uint32_t size = shadow_map_size(setting, &scene->lights[i]);
        if (!shadow_has_six_sides(&scene->lights[i]))
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
                "lights[%u] shines to all sides, whose map has no tiles; for the adaptive "
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
    if (scene->list.pass_count != 1)
        return gp_fail(error, GP_ERROR_INVALID, "the scene has passes of its own");
    if (scene->light_count == 0)
        return gp_fail(error, GP_ERROR_INVALID, "the scene has no light");
    for (uint32_t i = 0; i < scene->list.passes[0].draw_count; i++) {
        const GpDraw *draw = &scene->list.passes[0].draws[i];
        if (draw->program != &phong_program && draw->program != &textured_phong_program)
            return gp_fail(error, GP_ERROR_INVALID,
                           "objects[%u]: program %s has no shadows; phong and textured_phong have",
                           i, draw->program->name);
    }
    return check_six_sides(scene, setting, error);
}
