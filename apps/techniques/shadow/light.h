/* A light of the frame, and its shadow map: what is drawn into it, and what programs know of it. */
#ifndef APPS_TECHNIQUES_SHADOW_LIGHT_H
#define APPS_TECHNIQUES_SHADOW_LIGHT_H

#include "apps/frame/frame.h"
#include "apps/techniques/shadow/kept.h"
#include "apps/techniques/shadow/setting.h"
#include "shaders_c/shadow/shadow_tiles.h"

/* What all parts of a frame share. */
typedef struct ShadowBuild {
    const Scene *scene;
    ShadowKept *kept; /* of the scene */
    const ShadowSetting *setting;
    GpDevice *device;
    Frame *frame;
} ShadowBuild;

enum { SHADOW_TILES = 16 }; /* of an adaptive map, a side */

typedef struct ShadowLight {
    const SceneLight *source;
    bool cube; /* it shines to all sides: six views, +x -x +y -y +z -z, in one map of 3 x 2 */
    const LightView *view; /* [6] of a cube */
    uint32_t size;         /* of a view, in texels */
    GpSurface *map;
    /* what is drawn into the map, but where it is to have all, as printed */
    const SceneCasters *casters;

    /* adaptive */
    GpSurface *table, *atlas;     /* no atlas: no tile was asked for */
    uint32_t tile, columns, rows; /* texels a side of a tile; tiles of the atlas */
} ShadowLight;

/* The views of a light of the scene, by its number, and the pass that draws its map. */
ShadowLight shadow_draw_map(const ShadowBuild *build, uint32_t number);

/* Sets what a setting leaves open to what it is for a light: map, depth, bias and slope. */
void shadow_choose(const Scene *scene, ShadowKept *kept, uint32_t number, ShadowSetting *setting);

/* An object as the light sees it, in a part of the map: a draw of the present pass, or none where
 * the object casts nothing.
 * in   object: its number; clip: float[4][4], world to the part's clip space; belongs to the
 *      frame */
void shadow_draw_caster(const ShadowBuild *build, const ShadowLight *light, uint32_t object,
                        const void *clip, const GpViewport *viewport, bool scissor);

/* What programs know of the light and its map; the surface is left alone. */
void shadow_set_light(const ShadowBuild *build, const ShadowLight *light, ShadowUniforms *uniforms);

/* An object as the eye sees it under the light, by a program of shadow.h or shadow_tiles.h: a draw
 * of the present pass, with the light's map in slot 1. */
GpDraw *shadow_draw_object(const ShadowBuild *build, const ShadowLight *light, const GpDraw *object,
                           const GpProgram *program, bool has_ambient);

#endif
