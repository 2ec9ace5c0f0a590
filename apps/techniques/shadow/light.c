#include "apps/techniques/shadow/light.h"

#include "apps/techniques/shadow/discs.h"
#include "shaders_c/common/depth_only.h"
#include "shaders_c/materials/phong.h"
#include "shaders_c/shadow/shadow_map.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* --- the bias --------------------------------------------------------------------------------- */

/* Slope and bias are as given or, where they are to be chosen, chosen: see SHADOW_AUTO. An offset
 * is of no use to a cube map, in which things are looked up by where they are. */
static bool needs_bias(const ShadowSetting *setting, const ShadowLight *light)
{
    return setting->casters != SHADOW_FAR_SIDES && (light->cube || !(setting->offset > 0));
}

static double slope_of(const ShadowSetting *setting, const ShadowLight *light)
{
    if (setting->slope >= 0 || setting->method == SHADOW_PLAIN || !needs_bias(setting, light))
        return fmax(setting->slope, 0);
    return setting->filter == SHADOW_BILINEAR ? 2 : 1;
}

static double bias_of(const ShadowSetting *setting, const ShadowLight *light)
{
    const LightView *view = &light->view[0];
    const double steep = 16; /* rise over a texel's side */
    if (setting->bias >= 0 || !needs_bias(setting, light))
        return fmax(setting->bias, 0);
    if (setting->method == SHADOW_HARDWARE)
        return shadow_map_format(setting, light->source) == GP_D16 ? 0x1p-16 : 0x1p-24;
    /* Depth grows by this over a unit of length, and a texel is so many units wide. */
    double centre = 0.5 * (view->near + view->far), range = view->far - view->near;
    double growth = view->parallel ? 1 / range : view->near * view->far / range / (centre * centre);
    return steep * growth * view->width * (view->parallel ? 1 : centre) / light->size;
}

/* --- the map ---------------------------------------------------------------------------------- */

/* Direct3D 9's pixel centres, as printed: the second pass moves its texture coordinates by half a
 * texel for that. The cube map is ours. */
static GpViewport map_viewport(const ShadowLight *light, int face)
{
    float size = (float)light->size;
    if (!light->cube)
        return (GpViewport){ .d3d9_centers = true };
    return (GpViewport){
        .x = (float)(face / 2) * size, .y = (float)(face % 2) * size, .width = size, .height = size
    };
}

/* The triangles of an object that are drawn into a light's map; a map of all that the light shines
 * at, as printed, has them all. */
static GpGeometry find_caster(const ShadowBuild *build, const ShadowLight *light, uint32_t object)
{
    GpGeometry geometry = build->scene->list.passes[0].draws[object].geometry;
    if (build->setting->fit == LIGHT_FIT_LIGHT)
        return geometry;
    const bool casts = caster_casts(light->casters, object);
    geometry.indices = casts ? light->casters->objects[object].indices : NULL;
    geometry.index_count = casts ? light->casters->objects[object].index_count : 0;
    return geometry;
}

void shadow_draw_caster(const ShadowBuild *build, const ShadowLight *light, uint32_t object,
                        const void *clip, const GpViewport *viewport, bool scissor)
{
    /* Outsides turn counter-clockwise. */
    static const GpCull culled[] = {
        [SHADOW_NEAR_SIDES] = GP_CULL_CW, [SHADOW_FAR_SIDES] = GP_CULL_CCW
    };
    const ShadowSetting *setting = build->setting;
    const GpDraw *caster = &build->scene->list.passes[0].draws[object];
    const GpGeometry geometry = find_caster(build, light, object);
    if (!geometry.index_count)
        return;
    const bool plain = setting->method == SHADOW_PLAIN;
    const GpProgram *triangles = plain ? &shadow_map_program : &depth_only_program;
    const GpProgram *discs = plain ? &shadow_disc_map_program : &shadow_disc_program;
    GpDraw *draw =
        frame_draw(build->frame, shadow_is_disc(caster) ? discs : triangles, clip, &geometry);
    GpRasterState *raster = &draw->state.raster;
    draw->name = caster->name;
    draw->viewport = *viewport;
    draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    raster->slope_depth_bias = (float)slope_of(setting, light);
    raster->cull = culled[setting->casters];
    if (!scissor)
        return;
    raster->scissor = true;
    raster->scissor_x0 = (int32_t)viewport->x;
    raster->scissor_y0 = (int32_t)viewport->y;
    raster->scissor_x1 = (int32_t)(viewport->x + viewport->width);
    raster->scissor_y1 = (int32_t)(viewport->y + viewport->height);
}

/* The pass, whose map is a depth surface, or a colour target beside one. */
static void begin_map(const ShadowBuild *build, ShadowLight *light)
{
    static const float farthest[4] = { 1, 1, 1, 1 };
    Frame *frame = build->frame;
    const GpFormat format = shadow_map_format(build->setting, light->source);
    const uint32_t width = (light->cube ? 3 : 1) * light->size;
    const uint32_t height = (light->cube ? 2 : 1) * light->size;
    light->map = frame_surface(frame, format, width, height, 1);
    if (gp_format_info(format)->is_depth)
        frame_pass(frame, "map", NULL, light->map, NULL)->depth.clear_stencil =
            gp_format_info(format)->has_stencil;
    else
        frame_pass(frame, "map", light->map, frame_surface(frame, GP_D32F, width, height, 1),
                   farthest);
}

ShadowLight shadow_draw_map(const ShadowBuild *build, uint32_t number)
{
    const Scene *scene = build->scene;
    const SceneLight *source = &scene->lights[number];
    ShadowLight light = { .source = source,
                          .cube = light_shines_around(source),
                          .view = shadow_kept_views(build->kept, number, build->setting->fit),
                          .size = shadow_map_size(build->setting, source),
                          .casters = shadow_kept_casters(build->kept, number) };
    begin_map(build, &light);
    for (int face = 0; face < (light.cube ? 6 : 1); face++) {
        GpViewport viewport = map_viewport(&light, face);
        LightView view = light.view[face];
        float clip[4][4];
        matrix_round(view.clip, clip);
        const void *uniforms = frame_copy(build->frame, clip, sizeof clip);
        for (uint32_t i = 0; i < scene->list.passes[0].draw_count; i++)
            shadow_draw_caster(build, &light, i, uniforms, &viewport, light.cube);
    }
    return light;
}

void shadow_choose(const Scene *scene, ShadowKept *kept, uint32_t number, ShadowSetting *setting)
{
    static const ShadowDepth depths[GP_FORMATS] = { [GP_D16] = SHADOW_D16,
                                                    [GP_D24S8] = SHADOW_D24,
                                                    [GP_D32F] = SHADOW_D32F,
                                                    [GP_R32F] = SHADOW_R32F };
    const SceneLight *source = &scene->lights[number];
    const ShadowLight light = { .source = source,
                                .cube = light_shines_around(source),
                                .view = shadow_kept_views(kept, number, setting->fit),
                                .size = shadow_map_size(setting, source) };
    const double bias = bias_of(setting, &light), slope = slope_of(setting, &light);
    setting->depth = depths[shadow_map_format(setting, source)];
    setting->map = light.size;
    setting->bias = bias;
    setting->slope = slope;
}

/* --- what programs know of it ----------------------------------------------------------------- */

/* Clip space to texture coordinates, before the division (thesis, section 4.3). */
static void map_matrix(const ShadowBuild *build, const ShadowLight *light, float map[4][4])
{
    double half_texel = 0.5 / light->size, epsilon = bias_of(build->setting, light);
    const double to_texture[4][4] = {
        { 0.5, 0, 0, 0.5 + half_texel },
        { 0, -0.5, 0, 0.5 + half_texel },
        { 0, 0, 1, -epsilon },
        { 0, 0, 0, 1 },
    };
    double product[4][4], scale[4][4], clip[4][4];
    memcpy(scale, to_texture, sizeof scale);
    memcpy(clip, light->view[0].clip, sizeof clip);
    matrix_multiply(scale, clip, product);
    matrix_round(product, map);
}

void shadow_set_light(const ShadowBuild *build, const ShadowLight *light, ShadowUniforms *uniforms)
{
    const ShadowSetting *setting = build->setting;
    const SceneLight *source = light->source;
    const LightView *view = &light->view[0];
    double axis[3], clip[4][4], near = view->near, far = view->far;
    memcpy(clip, view->clip, sizeof clip);
    if (setting->method == SHADOW_PLAIN)
        matrix_round(clip, uniforms->map);
    else
        map_matrix(build, light, uniforms->map);
    vector_subtract(source->at, source->position, axis);
    vector_normalize(axis);
    for (int k = 0; k < 3; k++) {
        uniforms->light[k] = (float)source->position[k];
        uniforms->color[k] = source->color[k];
        uniforms->axis[k] = (float)axis[k];
    }
    double sine, cosine = -2;
    if (source->cone > 0)
        angle_sincos(source->cone, &sine, &cosine);
    uniforms->axis[3] = (float)cosine;
    uniforms->light[3] = source->directional ? 0 : 1;
    uniforms->half_texel = 0.5f / (float)light->size;
    uniforms->epsilon = (float)bias_of(setting, light);
    uniforms->map_size = (float)light->size;
    uniforms->offset = (float)setting->offset;
    uniforms->texel = (float)(view->width / light->size);
    bool nowhere_is_behind = light->cube || setting->outside == SHADOW_OUTSIDE_PRINTED;
    uniforms->least_w = nowhere_is_behind ? -FLT_MAX : 0;
    uniforms->face_depth[0] = (float)(far / (far - near));
    uniforms->face_depth[1] = (float)(far * near / (far - near));
    uniforms->nearest = (float)near;
    uniforms->light_size = (float)(source->size / view->width);
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

static void set_surface(const GpDraw *draw, ShadowUniforms *uniforms)
{
    const PhongUniforms *material = draw->uniforms;
    memcpy(uniforms->mvp, material->mvp, sizeof uniforms->mvp);
    memcpy(uniforms->eye, material->eye, sizeof uniforms->eye);
    memcpy(uniforms->ambient, material->ambient, sizeof uniforms->ambient);
    memcpy(uniforms->diffuse, material->diffuse, sizeof uniforms->diffuse);
    uniforms->specular = material->specular;
    uniforms->shininess = material->shininess;
}

GpDraw *shadow_draw_object(const ShadowBuild *build, const ShadowLight *light, const GpDraw *object,
                           const GpProgram *program, bool has_ambient)
{
    ShadowTilesUniforms uniforms = { .tiles = SHADOW_TILES };
    set_surface(object, &uniforms.shadow);
    shadow_set_light(build, light, &uniforms.shadow);
    if (!has_ambient)
        memset(uniforms.shadow.ambient, 0, sizeof uniforms.shadow.ambient);
    if (light->atlas) {
        uniforms.inset = 0.5f / (float)light->tile;
        uniforms.atlas_tiles[0] = 1 / (float)light->columns;
        uniforms.atlas_tiles[1] = 1 / (float)light->rows;
    }
    GpDraw *draw = frame_draw_copied(build->frame, program, &uniforms, &object->geometry);
    draw->name = object->name;
    draw->state.raster = object->state.raster;
    draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    draw->textures[1] = (GpTexture){ light->map, shadow_map_sampler(build->setting) };
    return draw;
}
