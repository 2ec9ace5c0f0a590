/* Scenes: a JSON description turned into surfaces, geometry and a list of passes. */
#ifndef APPS_SCENE_SCENE_H
#define APPS_SCENE_SCENE_H

#include "apps/base/camera.h"
#include "apps/points/drawing/over.h"

#include <jansson.h>

enum { SCENE_MAX_LIGHTS = 8 };

typedef struct SceneOptions {
    uint32_t width, height; /* 0: the scene's own size */
    uint32_t fails;         /* for tests, as an arena has it */
    bool shadows;           /* as where the scene asks for them itself */
    GpRect window; /* the part of the picture to be drawn, as GpSurfaceDesc.window; empty: all */
    const json_t *changes; /* of the scene's text, as path_at gives them; NULL: none */
    double turn; /* degrees by which the camera goes round what it looks at, about its "up" */
} SceneOptions;

/* What a light's shadow map shall see and be; zero where the scene leaves it to the technique. */
typedef struct SceneShadow {
    double up[3];
    double fovy;      /* degrees; 0: the cone's, or a quarter turn */
    double height;    /* of a direction's wall of rays, world units; 0: as the scene needs */
    double near, far; /* far 0: both as the scene needs */
    uint32_t map;     /* texels a side */
    GpFormat format;
} SceneShadow;

typedef struct SceneLight {
    double position[3]; /* world; for a direction: the direction towards the light, unit length */
    bool directional;
    bool aims;    /* looks at `at`; else it shines to all sides */
    double at[3]; /* world */
    double cone; /* degrees from the centre of its cone to the edge, about `position`; 0: no edge */
    double size; /* side of the square that shines, across its aim; 0: a point */
    float color[3];
    float range; /* world units; 0: no end. Only programs that have many lights look at it */
    SceneShadow shadow;
} SceneLight;

/* Everything that a scene's list points to. Owned by the caller until scene_free. */
typedef struct Scene {
    GpList list;
    GpSurface *picture; /* the colour target that `render` writes */
    GpSurface *depth;   /* its depth target, or NULL */
    Camera camera;
    SceneLight lights[SCENE_MAX_LIGHTS];
    uint32_t light_count;
    float ambient[3], background[4];
    SplatGroup splats;           /* of the last pass that has any; sources in the list's memory */
    const Surfels *splat_models; /* [splats.source_count], all surfels of each, seen or not */
    uint32_t volume_count;       /* of all passes */
    bool has_passes;             /* of its own, instead of one for all objects */
    bool shadows;                /* it is to be drawn with them: shadow/shadowed.h */
    /* number of the pass from which on volumes, and then what is blended by depth, lie over the
     * rest; as many as there are where nothing does */
    uint32_t over;
    Frame frame;    /* private: what all this is made of */
    Frame shadowed; /* private: what else, with shadows */
} Scene;

/* Reads a scene file, found as data is (gp_data_find), and everything it names, which is looked for
 * beside it first.
 * errors GP_ERROR_IO (file); GP_ERROR_FORMAT (JSON, unknown keys, wrong types, numbers out of
 *        range, missing meshes and pictures) with the JSON path and the line, such as
 *        "x.json:12: objects[1].material.shininess: expected a number in [0, 10000]";
 *        GP_ERROR_MEMORY */
GpResult scene_load(const char *path, const SceneOptions *options, Scene *scene, GpError *error);

/* What can be told of a scene file without reading what it names; a scene that cannot be read has
 * the usual size, and the other functions say what is wrong with it. */
typedef struct SceneOutline {
    uint32_t width, height; /* of the picture */
    double cost; /* how long it takes to draw, beside others: by its pixels, passes and objects */
} SceneOutline;
SceneOutline scene_outline(const char *path);

/* The JSON Schema of scene files, as the reader tells it: every key with its type, range, default
 * and names; of materials one alternative for each program. The caller owns it. */
json_t *scene_schema(void);

/* Frees everything and zeroes the struct; a zeroed scene is fine. */
void scene_free(Scene *scene);

#endif
