/* What the files of the shadow technique share: tech_shadow.c has the frame, tech_shadow_choices.c
 * what a setting leaves open, and tech_shadow_adaptive.c the finer tiles of a map. */
#ifndef APPS_TECHNIQUES_SHADOW_PARTS_H
#define APPS_TECHNIQUES_SHADOW_PARTS_H

#include "apps/techniques/shadow/shadow.h"
#include "shaders_c/shadow/shadow_tiles.h"

/* One light of the frame. A light that does not aim has six views, +x -x +y -y +z -z, in one map of
 * three by two. */
typedef struct ShadowLamp {
    const SceneLight *light;
    bool six_sides;
    LightView view[6];
    uint32_t size; /* of a view, in texels */
    GpSurface *map;
    const bool *casts; /* of each object of the scene: drawn into the map */

    /* adaptive */
    GpSurface *table, *atlas;     /* no atlas: no tile was asked for */
    uint32_t tile, columns, rows; /* texels a side of a tile; tiles of the atlas */
} ShadowLamp;

typedef struct ShadowBuild {
    const Scene *scene;
    const ShadowSetting *setting;
    Frame *frame;
} ShadowBuild;

/* --- choices ---------------------------------------------------------------------------------- */

/* errors GP_ERROR_INVALID: those of tech_shadow_build */
GpResult shadow_check(const Scene *scene, const ShadowSetting *setting, GpError *error);

bool shadow_has_six_sides(const SceneLight *light);
uint32_t shadow_map_size(const ShadowSetting *setting, const SceneLight *light);
GpFormat shadow_map_format(const ShadowSetting *setting, const SceneLight *light);

/* Slope and bias as given or, where they are to be chosen, chosen (see SHADOW_AUTO). */
double shadow_slope(const ShadowSetting *setting, const ShadowLamp *lamp);
double shadow_bias(const ShadowSetting *setting, const ShadowLamp *lamp);

/* --- passes ----------------------------------------------------------------------------------- */

/* An object as the light sees it, in a part of the map: a draw of the present pass, or none where the
 * object casts nothing.
 * in   object: its number; uniforms: float[4][4], world to the part's clip space; belongs to the work */
void shadow_draw_caster(const ShadowBuild *build, const ShadowLamp *lamp, uint32_t object,
                        const void *uniforms, const GpViewport *viewport, bool scissor);

/* What a light and a material are to the programs. */
void shadow_set_uniforms(const ShadowBuild *build, const ShadowLamp *lamp, const GpDraw *object,
                         ShadowTilesUniforms *uniforms);

GpSampler shadow_map_sampler(const ShadowSetting *setting);

enum {
    SHADOW_TILES = 16,      /* of a map, a side */
    SHADOW_MAX_TILES = 256, /* drawn again, of one map */
    SHADOW_TILE_PASSES = 3,
};

/* Draws that a light's tiles take at most. */
uint32_t shadow_tile_draws(uint32_t objects);

/* After the pass that draws the map: passes that ask for finer tiles of it, and one that draws those.
 * To know which, it runs the passes up to there, on a device of its own.
 * out  lamp->table and what follows
 * errors GP_ERROR_MEMORY, and those of gp_device_create */
GpResult shadow_draw_tiles(const ShadowBuild *build, ShadowLamp *lamp, GpError *error);

#endif
