/* What may be set of shadow maps, what that leaves to be chosen, and what it refuses. */
#ifndef APPS_TECHNIQUES_SHADOW_SETTING_H
#define APPS_TECHNIQUES_SHADOW_SETTING_H

#include "apps/techniques/shadow/light_fit.h"

typedef enum ShadowMethod { SHADOW_PLAIN, SHADOW_HARDWARE } ShadowMethod;
typedef enum ShadowFilter { SHADOW_NEAREST, SHADOW_BILINEAR, SHADOW_SOFT } ShadowFilter;
typedef enum ShadowFacing { SHADOW_SMOOTH, SHADOW_FLAT } ShadowFacing;
typedef enum ShadowDepth {
    SHADOW_DEPTH_AUTO, /* r32f for the plain method; else the light's, or d24 */
    SHADOW_D16,
    SHADOW_D24,
    SHADOW_D32F,
    SHADOW_R32F
} ShadowDepth;

/* Which sides of objects are drawn into the map: all; those turned to the light, which are all that
 * can be nearest where objects are closed; or those turned away, so that the bias lies inside
 * objects. DEVIATES: Wang and Molnar's second-depth shadow mapping (1994) takes the second surface
 * whichever way it turns; culling gives the same for closed objects, in one pass. */
typedef enum ShadowCasters { SHADOW_ALL_SIDES, SHADOW_NEAR_SIDES, SHADOW_FAR_SIDES } ShadowCasters;

/* What lies beside the map or behind the light: lit; or, as printed, whatever is found at the map's
 * edge and at the mirrored place. */
typedef enum ShadowOutside { SHADOW_OUTSIDE_LIT, SHADOW_OUTSIDE_PRINTED } ShadowOutside;

typedef struct ShadowSetting {
    ShadowMethod method;
    ShadowFilter filter;
    ShadowFacing facing;
    ShadowDepth depth;
    ShadowCasters casters;
    LightFit fit;
    ShadowOutside outside;
    uint32_t map;  /* texels a side; 0: the light's, or 1024 */
    double bias;   /* the printed epsilon: taken from the depth that is compared, in depth units */
    double slope;  /* added to the map's depth: times the depth's change over a texel (R22) */
    double offset; /* out of the surface, along its normal, in texels */
} ShadowSetting;

/* Bias or slope that says: choose. Slope: a texel's depth may be off by what a surface rises over
 * half a texel in u and in v, so at most its slope; twice that where four texels are compared.
 * Bias: a step of the format; in the plain method, which knows no slope, the rise of a steep
 * surface over a texel half way between near and far. Neither where an offset or far sides do their
 * work. */
#define SHADOW_AUTO (-1.0)

extern const ShadowSetting shadow_defaults;

/* errors GP_ERROR_INVALID: those of shadow_build */
GpResult shadow_check(const Scene *scene, const ShadowSetting *setting, GpError *error);

/* A light's map: texels a side, format, and how programs sample it. */
uint32_t shadow_map_size(const ShadowSetting *setting, const SceneLight *light);
GpFormat shadow_map_format(const ShadowSetting *setting, const SceneLight *light);
GpSampler shadow_map_sampler(const ShadowSetting *setting);

#endif
