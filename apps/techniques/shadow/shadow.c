#include "apps/techniques/shadow/shadow.h"

#include "apps/techniques/shadow/adaptive.h"
#include "apps/techniques/shadow/discs.h"
#include "shaders_c/materials/phong.h"
#include "shaders_c/shadow/shadow_splats.h"

#include <string.h>

static const GpDepthState same = { .test = GP_EQUAL };
static const GpBlend added = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };

/* --- the picture ------------------------------------------------------------------------------ */

/* By facing, then without and with a texture. */
#define PROGRAMS(form)                                                                             \
    {                                                                                              \
        { &shadow_##form##_smooth_program, &shadow_##form##_smooth_textured_program },             \
            { &shadow_##form##_flat_program, &shadow_##form##_flat_textured_program },             \
    }

static const GpProgram *choose_program(const ShadowBuild *build, const ShadowLight *light,
                                       bool textured)
{
    const ShadowSetting *setting = build->setting;
    static const GpProgram *const plain[][2][2] = {
        [SHADOW_NEAREST] = PROGRAMS(plain_nearest),
        [SHADOW_BILINEAR] = PROGRAMS(plain_bilinear),
        [SHADOW_SOFT] = PROGRAMS(soft),
    };
    static const GpProgram *const hardware[2][2] = PROGRAMS(hardware);
    static const GpProgram *const cube[2][2] = PROGRAMS(cube);
    static const GpProgram *const tiles[2][2] = PROGRAMS(tiles);
    if (light->atlas)
        return tiles[setting->facing][textured];
    if (light->cube)
        return cube[setting->facing][textured];
    return setting->method == SHADOW_PLAIN ? plain[setting->filter][setting->facing][textured]
                                           : hardware[setting->facing][textured];
}

/* The first light brings depth and the ambient light, the others are added to what is seen. */
static void draw_lit(const ShadowBuild *build, const ShadowLight *light, bool first)
{
    Frame *frame = build->frame;
    const GpPass *scene = &build->scene->list.passes[0];
    GpPass *pass = frame_pass(frame, "lit", frame->color, frame->depth, build->scene->background);
    pass->color[0].clear_color[3] = 0;
    pass->color[0].clear = pass->depth.clear_depth = first;
    for (uint32_t i = 0; i < scene->draw_count; i++) {
        const GpDraw *object = &scene->draws[i];
        if (shadow_is_disc(object))
            continue;
        bool textured = object->program != &phong_program;
        GpDraw *draw =
            shadow_draw_object(build, light, object, choose_program(build, light, textured), first);
        if (!first) {
            draw->state.depth = same;
            draw->state.blend[0] = added;
        }
        draw->textures[0] = object->textures[0];
        if (!light->atlas)
            continue;
        draw->textures[2] =
            (GpTexture){ light->table, { .address_u = GP_BORDER, .address_v = GP_BORDER } };
        draw->textures[3] = draw->textures[1];
        draw->textures[3].surface = light->atlas;
    }
}

/* The splats of a scene under its one light, over all else. */
static void draw_splats(const ShadowBuild *build, const ShadowLight *light)
{
    static const SplatNames names = { "visibility", "splats", "lit splats" };
    static const GpProgram *const plain[] = {
        [SHADOW_NEAREST] = &shadow_splats_plain_nearest_program,
        [SHADOW_BILINEAR] = &shadow_splats_plain_bilinear_program,
    };
    const ShadowSetting *setting = build->setting;
    const SplatGroup *group = &build->scene->splats;
    ShadowSplatsUniforms uniforms = { .lift = splat_largest_radius(group) }, solid;
    ShadowUniforms *shadow = &uniforms.shadow;
    shadow->specular = SPLAT_SPECULAR;
    shadow->shininess = SPLAT_SHININESS;
    memcpy(shadow->ambient, build->scene->ambient, sizeof shadow->ambient);
    for (int k = 0; k < 3; k++) {
        shadow->diffuse[k] = 1;
        shadow->eye[k] = (float)group->view.camera.eye[k];
    }
    shadow_set_light(build, light, shadow);
    solid = uniforms;
    solid.solid = 1;
    const SplatShading shading = {
        .program = setting->method == SHADOW_PLAIN ? plain[setting->filter]
                                                   : &shadow_splats_hardware_program,
        .uniforms = &uniforms,
        .solid = &solid,
        .map = { light->map, shadow_map_sampler(setting) },
        .surface_slot = 3,
    };
    splat_build_over(group, &names, &shading, build->frame->color, build->frame->depth,
                     build->frame);
}

/* Volumes, and what is blended by depth, as the scene has them: they cast no shadows, receive none,
 * and leave alpha as it is. */
static void draw_over(const ShadowBuild *build)
{
    enum { ALPHA = 8 }; /* channel of a target */
    const Scene *scene = build->scene;
    const GpSurface *own_depth = scene->list.passes[0].depth.surface;
    Frame *frame = build->frame;
    for (uint32_t p = scene->over; p < scene->list.pass_count; p++) {
        const GpPass *from = &scene->list.passes[p];
        GpSurface *depth = from->depth.surface ? frame->depth : NULL;
        GpPass *pass = frame_pass(frame, from->name, frame->color, depth, scene->background);
        pass->color[0].clear = pass->depth.clear_depth = false;
        pass->order = from->order;
        for (uint32_t i = 0; i < from->draw_count; i++) {
            GpDraw *draw = frame_draw(frame, NULL, NULL, &from->draws[i].geometry);
            *draw = from->draws[i];
            draw->state.blend[0].keep |= ALPHA;
            for (int k = 0; k < GP_MAX_SAMPLERS; k++)
                if (own_depth && draw->textures[k].surface == own_depth)
                    draw->textures[k].surface = frame->depth;
        }
    }
}

/* --- the frame -------------------------------------------------------------------------------- */

GpResult shadow_build(const Scene *scene, ShadowKept *kept, const ShadowSetting *setting,
                      GpDevice *device, Frame *frame, GpError *error)
{
    GpResult result = shadow_check(scene, setting, error);
    if (result)
        return result;
    const ShadowBuild build = { scene, kept ? kept : shadow_keep(scene, frame), setting, device,
                                frame };
    if (!build.kept)
        result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    bool adaptive = setting->fit == LIGHT_FIT_ADAPTIVE;
    frame->color = frame_target(frame, GP_A8R8G8B8, scene->picture->width, scene->picture->height);
    frame->depth = frame_target(frame, GP_D32F, scene->picture->width, scene->picture->height);
    for (uint32_t i = 0; i < scene->light_count && !result; i++) {
        ShadowLight light = shadow_draw_map(&build, i);
        if (adaptive)
            result = shadow_draw_tiles(&build, &light, error);
        if (!result)
            draw_lit(&build, &light, i == 0);
        if (!result && scene->splats.source_count > 0)
            draw_splats(&build, &light);
    }
    if (!result)
        draw_over(&build);
    if (!result)
        result = frame_result(frame, error);
    if (!result)
        result = shadow_kept_result(build.kept, error);
    if (result)
        frame_free(frame);
    return result;
}
