#include "apps/techniques/shadow/shadowed.h"

#include "apps/frame/window.h"
#include "apps/techniques/shadow/discs.h"
#include "apps/techniques/shadow/shadow.h"

#include <string.h>

/* Alpha, which tells techniques how much light there is, stays as it was cleared. */
static void keep_alpha(Frame *frame, const float background[4])
{
    enum { ALPHA = 8 }; /* channel of a target */
    GpDraw *draws = frame->draws;
    for (uint32_t p = 0; p < frame->list.pass_count; p++) {
        GpPass *pass = &frame->passes[p];
        for (uint32_t i = 0; i < pass->draw_count && pass->color[0].surface == frame->color; i++)
            draws[i].state.blend[0].keep |= ALPHA;
        draws += pass->draw_count;
        if (pass->color[0].surface == frame->color)
            pass->color[0].clear_color[3] = background[3];
    }
}

static GpResult add_shadows(Scene *scene, GpError *error)
{
    Scene with_discs;
    scene->shadowed.window = scene->frame.window;
    memcpy(scene->shadowed.window_of, scene->frame.window_of, sizeof scene->shadowed.window_of);
    GpResult result = shadow_scene_with_discs(scene, &scene->frame, &with_discs, error);
    if (!result)
        result = shadow_build(&with_discs, NULL, &shadow_defaults, NULL, &scene->shadowed, error);
    if (result)
        return result;
    keep_alpha(&scene->shadowed, scene->background);
    scene->list = scene->shadowed.list;
    scene->picture = scene->shadowed.color;
    scene->depth = scene->shadowed.depth;
    return GP_OK;
}

GpResult shadowed_scene_load(const char *path, const SceneOptions *options, Scene *scene,
                             GpError *error)
{
    Scene made;
    GpError reason = { "" };
    GpResult result = scene_load(path, options, &made, error);
    if (result)
        return result;
    const char *part = "shadows";
    if (made.shadows)
        result = add_shadows(&made, &reason);
    if (!result && !gp_rect_is_empty(made.frame.window)) {
        part = "window";
        result = window_settle(&made.list, &reason);
    }
    if (result) {
        scene_free(&made);
        return gp_fail(error, result == GP_ERROR_INVALID ? GP_ERROR_FORMAT : result,
                       "%.200s: %s: %s", path, part, reason.text);
    }
    *scene = made;
    return GP_OK;
}
