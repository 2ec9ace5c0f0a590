#include "apps/scene/bounds.h"
#include "apps/techniques/shadow/parts.h"

#include "shaders_c/common/depth_only.h"
#include "shaders_c/materials/phong.h"
#include "shaders_c/shadow/shadow_map.h"
#include "shaders_c/materials/textured_phong.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const float black[4] = { 0 };
static const GpDepthState nearer = { .test = GP_LESS, .write = true };
static const GpDepthState same = { .test = GP_EQUAL };
static const GpBlend added = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };

const ShadowSetting shadow_defaults = {
    .method = SHADOW_HARDWARE,
    .filter = SHADOW_BILINEAR,
    .facing = SHADOW_FLAT,
    .fit = LIGHT_FIT_CASTERS,
    .bias = SHADOW_AUTO,
    .slope = SHADOW_AUTO,
};

static void round_matrix(double from[4][4], float to[4][4])
{
    for (int i = 0; i < 16; i++)
        to[i / 4][i % 4] = (float)from[i / 4][i % 4];
}

/* --- the map ---------------------------------------------------------------------------------- */

/* Direct3D 9's pixel centres, as printed: the second pass moves its texture coordinates by half a
 * texel for that. Six sides are ours. */
static GpViewport map_viewport(const ShadowLamp *lamp, int side)
{
    float size = (float)lamp->size;
    if (!lamp->six_sides)
        return (GpViewport){ .d3d9_centers = true };
    return (
        GpViewport){ (float)(side / 2) * size, (float)(side % 2) * size, size, size, 0, 1, false };
}

/* Whether each object is drawn into a light's map; a map of all that the light shines at, as printed,
 * has them all. */
static const bool *find_casts(const ShadowBuild *build, const SceneLight *light)
{
    const GpPass *scene = &build->scene->list.passes[0];
    bool *casts = frame_alloc(build->frame, scene->draw_count, sizeof *casts);
    for (uint32_t i = 0; i < scene->draw_count; i++)
        casts[i] = build->setting->fit == LIGHT_FIT_LIGHT ||
                   !only_receives(build->scene, light, &scene->draws[i]);
    return casts;
}

void shadow_draw_caster(const ShadowBuild *build, const ShadowLamp *lamp, uint32_t object,
                        const void *uniforms, const GpViewport *viewport, bool scissor)
{
    /* Outsides turn counter-clockwise. */
    static const GpCull culled[] = {
        [SHADOW_NEAR_SIDES] = GP_CULL_CW, [SHADOW_FAR_SIDES] = GP_CULL_CCW
    };
    const ShadowSetting *setting = build->setting;
    const GpDraw *caster = &build->scene->list.passes[0].draws[object];
    if (!lamp->casts[object])
        return;
    bool plain = setting->method == SHADOW_PLAIN;
    GpDraw *draw = frame_draw(build->frame, plain ? &shadow_map_program : &depth_only_program,
                              uniforms, &caster->geometry);
    GpRasterState *raster = &draw->state.raster;
    draw->name = caster->name;
    draw->viewport = *viewport;
    draw->state.depth = nearer;
    raster->slope_depth_bias = (float)shadow_slope(setting, lamp);
    raster->cull = culled[setting->casters];
    if (!scissor)
        return;
    raster->scissor = true;
    raster->scissor_x0 = (int32_t)viewport->x;
    raster->scissor_y0 = (int32_t)viewport->y;
    raster->scissor_x1 = (int32_t)(viewport->x + viewport->width);
    raster->scissor_y1 = (int32_t)(viewport->y + viewport->height);
}

static void draw_map(const ShadowBuild *build, ShadowLamp *lamp)
{
    static const float farthest[4] = { 1, 1, 1, 1 };
    Frame *frame = build->frame;
    GpFormat format = shadow_map_format(build->setting, lamp->light);
    uint32_t columns = lamp->six_sides ? 3 : 1, rows = lamp->six_sides ? 2 : 1;
    uint32_t width = columns * lamp->size, height = rows * lamp->size;
    lamp->map = frame_surface(frame, format, width, height, 1);
    if (gp_format_info(format)->is_depth)
        frame_pass(frame, "map", NULL, lamp->map, NULL)->depth.clear_stencil =
            gp_format_info(format)->has_stencil;
    else
        frame_pass(frame, "map", lamp->map, frame_surface(frame, GP_D32F, width, height, 1),
                   farthest);
    for (int side = 0; side < (lamp->six_sides ? 6 : 1); side++) {
        const GpPass *scene = &build->scene->list.passes[0];
        GpViewport viewport = map_viewport(lamp, side);
        float clip[4][4];
        round_matrix(lamp->view[side].clip, clip);
        const void *uniforms = frame_copy(frame, clip, sizeof clip);
        for (uint32_t i = 0; i < scene->draw_count; i++)
            shadow_draw_caster(build, lamp, i, uniforms, &viewport, lamp->six_sides);
    }
}

/* --- the picture ------------------------------------------------------------------------------ */

/* Clip space to texture coordinates, before the division (thesis, section 4.3). */
static void map_matrix(const ShadowBuild *build, const ShadowLamp *lamp, float map[4][4])
{
    double half_texel = 0.5 / lamp->size, epsilon = shadow_bias(build->setting, lamp);
    const double to_texture[4][4] = {
        { 0.5, 0, 0, 0.5 + half_texel },
        { 0, -0.5, 0, 0.5 + half_texel },
        { 0, 0, 1, -epsilon },
        { 0, 0, 0, 1 },
    };
    double product[4][4], scale[4][4], clip[4][4];
    memcpy(scale, to_texture, sizeof scale);
    memcpy(clip, lamp->view[0].clip, sizeof clip);
    matrix_multiply(scale, clip, product);
    round_matrix(product, map);
}

static void set_light(const ShadowBuild *build, const ShadowLamp *lamp, ShadowUniforms *uniforms)
{
    const ShadowSetting *setting = build->setting;
    const SceneLight *light = lamp->light;
    const LightView *view = &lamp->view[0];
    double axis[3], clip[4][4], near = view->near, far = view->far;
    memcpy(clip, view->clip, sizeof clip);
    if (setting->method == SHADOW_PLAIN)
        round_matrix(clip, uniforms->map);
    else
        map_matrix(build, lamp, uniforms->map);
    for (int k = 0; k < 3; k++) {
        uniforms->light[k] = (float)light->position[k];
        uniforms->color[k] = light->color[k];
        axis[k] = light->at[k] - light->position[k];
    }
    vector_normalize(axis);
    for (int k = 0; k < 3; k++)
        uniforms->axis[k] = (float)axis[k];
    double sine, cosine = -2;
    if (light->cone > 0)
        angle_sincos(light->cone, &sine, &cosine);
    uniforms->axis[3] = (float)cosine;
    uniforms->light[3] = light->directional ? 0 : 1;
    uniforms->half_texel = 0.5f / (float)lamp->size;
    uniforms->epsilon = (float)shadow_bias(setting, lamp);
    uniforms->map_size = (float)lamp->size;
    uniforms->offset = (float)setting->offset;
    uniforms->texel = (float)(view->width / lamp->size);
    bool nowhere_is_behind = lamp->six_sides || setting->outside == SHADOW_OUTSIDE_PRINTED;
    uniforms->least_w = nowhere_is_behind ? -FLT_MAX : 0;
    uniforms->side_depth[0] = (float)(far / (far - near));
    uniforms->side_depth[1] = (float)(far * near / (far - near));
    uniforms->nearest = (float)near;
    uniforms->light_size = (float)(light->size / view->width);
    if (view->parallel) {
        memcpy(uniforms->distance, (float[4]){ (float)near, (float)(far - near), 1, 0 },
               sizeof uniforms->distance);
        uniforms->spread[0] = 1;
    } else {
        memcpy(uniforms->distance,
               (float[4]){ (float)(near * far), 0, (float)far, (float)(near - far) },
               sizeof uniforms->distance);
        uniforms->spread[1] = 1;
    }
}

/* What phong and textured_phong have in common, in either's uniforms. */
static void set_surface(const GpDraw *draw, ShadowUniforms *uniforms)
{
    _Static_assert(sizeof(PhongUniforms) == sizeof(TexturedPhongUniforms), "one material");
    const PhongUniforms *material = draw->uniforms;
    memcpy(uniforms->mvp, material->mvp, sizeof uniforms->mvp);
    memcpy(uniforms->eye, material->eye, sizeof uniforms->eye);
    memcpy(uniforms->ambient, material->ambient, sizeof uniforms->ambient);
    memcpy(uniforms->diffuse, material->diffuse, sizeof uniforms->diffuse);
    uniforms->specular = material->specular;
    uniforms->shininess = material->shininess;
}

void shadow_set_uniforms(const ShadowBuild *build, const ShadowLamp *lamp, const GpDraw *object,
                         ShadowTilesUniforms *uniforms)
{
    set_surface(object, &uniforms->shadow);
    set_light(build, lamp, &uniforms->shadow);
    uniforms->tiles = SHADOW_TILES;
    if (!lamp->atlas)
        return;
    uniforms->inset = 0.5f / (float)lamp->tile;
    uniforms->atlas_tiles[0] = 1 / (float)lamp->columns;
    uniforms->atlas_tiles[1] = 1 / (float)lamp->rows;
}

#define PAIR(form)                                                                                 \
    {                                                                                              \
        &shadow_##form##_program, &shadow_##form##_textured_program                                \
    }

static const GpProgram *choose_program(const ShadowBuild *build, const ShadowLamp *lamp,
                                       bool textured)
{
    const ShadowSetting *setting = build->setting;
    static const GpProgram *const plain[][2][2] = {
        [SHADOW_NEAREST] = { PAIR(plain_nearest_smooth), PAIR(plain_nearest_flat) },
        [SHADOW_BILINEAR] = { PAIR(plain_bilinear_smooth), PAIR(plain_bilinear_flat) },
        [SHADOW_SOFT] = { PAIR(soft_smooth), PAIR(soft_flat) },
    };
    static const GpProgram *const hardware[2][2] = { PAIR(hardware_smooth), PAIR(hardware_flat) };
    static const GpProgram *const six_sides[2][2] = { PAIR(six_sides_smooth),
                                                      PAIR(six_sides_flat) };
    static const GpProgram *const tiles[2][2] = { PAIR(tiles_smooth), PAIR(tiles_flat) };
    if (lamp->atlas)
        return tiles[setting->facing][textured];
    if (lamp->six_sides)
        return six_sides[setting->facing][textured];
    return setting->method == SHADOW_PLAIN ? plain[setting->filter][setting->facing][textured]
                                           : hardware[setting->facing][textured];
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

/* The first light brings depth and the ambient light, the others are added to what is seen. */
static void draw_lit(const ShadowBuild *build, const ShadowLamp *lamp, bool first)
{
    Frame *frame = build->frame;
    const GpPass *scene = &build->scene->list.passes[0];
    GpPass *pass = frame_pass(frame, "lit", frame->color, frame->depth, build->scene->background);
    pass->color[0].clear_color[3] = 0;
    pass->color[0].clear = pass->depth.clear_depth = first;
    ShadowTilesUniforms *uniforms = frame_alloc(frame, scene->draw_count, sizeof *uniforms);
    for (uint32_t i = 0; i < scene->draw_count; i++) {
        const GpDraw *object = &scene->draws[i];
        bool textured = object->program == &textured_phong_program;
        shadow_set_uniforms(build, lamp, object, &uniforms[i]);
        if (!first)
            memcpy(uniforms[i].shadow.ambient, black, sizeof uniforms[i].shadow.ambient);
        GpDraw *draw = frame_draw(frame, choose_program(build, lamp, textured), &uniforms[i],
                                  &object->geometry);
        draw->name = object->name;
        draw->state.raster = object->state.raster;
        draw->state.depth = first ? nearer : same;
        if (!first)
            draw->state.blend[0] = added;
        draw->textures[0] = object->textures[0];
        draw->textures[1] = (GpTexture){ lamp->map, shadow_map_sampler(build->setting) };
        if (!lamp->atlas)
            continue;
        draw->textures[2] =
            (GpTexture){ lamp->table, { .address_u = GP_BORDER, .address_v = GP_BORDER } };
        draw->textures[3] = draw->textures[1];
        draw->textures[3].surface = lamp->atlas;
    }
}

/* --- the frame -------------------------------------------------------------------------------- */

GpResult tech_shadow_build(const Scene *scene, const ShadowSetting *setting, Frame *frame,
                           GpError *error)
{
    GpResult result = shadow_check(scene, setting, error);
    if (result)
        return result;
    const ShadowBuild build = { scene, setting, frame };
    bool adaptive = setting->fit == LIGHT_FIT_ADAPTIVE;
    uint32_t objects = scene->list.passes[0].draw_count;
    uint32_t passes = 2, draws = 7 * objects; /* of a light, at most */
    if (adaptive) {
        passes += SHADOW_TILE_PASSES;
        draws += shadow_tile_draws(objects);
    }
    frame_reserve(frame, scene->light_count * passes, scene->light_count * draws);
    frame->color =
        frame_surface(frame, GP_A8R8G8B8, scene->picture->width, scene->picture->height, 1);
    frame->depth = frame_surface(frame, GP_D32F, scene->picture->width, scene->picture->height, 1);
    for (uint32_t i = 0; i < scene->light_count; i++) {
        const SceneLight *light = &scene->lights[i];
        ShadowLamp lamp = { .light = light,
                            .six_sides = shadow_has_six_sides(light),
                            .size = shadow_map_size(setting, light),
                            .casts = find_casts(&build, light) };
        for (int side = 0; side < (lamp.six_sides ? 6 : 1); side++)
            lamp.view[side] = light_view(scene, lamp.light, side, (LightFit)setting->fit);
        draw_map(&build, &lamp);
        if (adaptive && (result = shadow_draw_tiles(&build, &lamp, error))) {
            frame_free(frame);
            return result;
        }
        draw_lit(&build, &lamp, i == 0);
    }
    return GP_OK;
}
