#include "apps/techniques/shadow/kept.h"

enum { FITS = LIGHT_FIT_ADAPTIVE + 1, FACES = 6 };

typedef struct KeptLight {
    bool has_casters, has_views[FITS];
    SceneCasters casters;
    LightView views[FITS][FACES];
} KeptLight;

struct ShadowKept {
    const Scene *scene;
    Frame *memory;
    KeptLight *lights; /* [of the scene] */
};

ShadowKept *shadow_keep(const Scene *scene, Frame *memory)
{
    ShadowKept *kept = frame_alloc(memory, 1, sizeof *kept);
    KeptLight *lights = frame_alloc(memory, scene->light_count, sizeof *lights);
    if (!kept || !lights)
        return NULL;
    *kept = (ShadowKept){ scene, memory, lights };
    return kept;
}

const SceneCasters *shadow_kept_casters(ShadowKept *kept, uint32_t light)
{
    KeptLight *one = &kept->lights[light];
    if (!one->has_casters)
        one->casters = scene_casters(kept->scene, &kept->scene->lights[light], kept->memory);
    one->has_casters = true;
    return &one->casters;
}

const LightView *shadow_kept_views(ShadowKept *kept, uint32_t light, LightFit fit)
{
    KeptLight *one = &kept->lights[light];
    const int faces = light_shines_around(&kept->scene->lights[light]) ? FACES : 1;
    for (int face = 0; face < faces && !one->has_views[fit]; face++)
        one->views[fit][face] = light_fit(shadow_kept_casters(kept, light), face, fit);
    one->has_views[fit] = true;
    return one->views[fit];
}

GpResult shadow_kept_result(const ShadowKept *kept, GpError *error)
{
    return frame_result(kept->memory, error);
}
