/* What the readers of a scene share: where it is built, and what has been read so far. */
#ifndef APPS_SCENE_LOADER_H
#define APPS_SCENE_LOADER_H

#include "apps/base/camera.h"
#include "apps/base/json_reader.h"
#include "apps/scene/scene.h"

/* What all objects of a pass see. */
typedef struct SceneView {
    Camera camera;
    uint32_t width, height; /* of the targets */
    float world_to_clip[4][4];
    GpViewport viewport;
    const Scene *scene;       /* lights, ambient light and background */
    bool has_depth;           /* the pass has a depth target */
    GpSurface *color, *depth; /* the first targets, or NULL */
    uint32_t color_count;     /* 2 stands for more than one */
} SceneView;

/* A picture that is loaded already: the same name with the same treatment is not loaded again. */
typedef struct SceneImage {
    struct SceneImage *next;
    const char *name;
    const GpSurface *surface;
    bool srgb, mips;
} SceneImage;

typedef struct SceneVolume SceneVolume; /* volumes.h */

/* The state of loading. Memory that runs short is the frame's failure, which loading ends with. */
typedef struct Loader {
    Reader reader;
    Scene *scene;
    Frame *frame;   /* the scene's */
    SceneView view; /* the scene's, copied and changed by passes */
    SceneImage *images;
    uint32_t pass_count; /* of passes that are whole: those that others may refer to */
    uint64_t texels;     /* bytes of all surfaces of passes */
    SplatSource *splats; /* of the pass that is read */
    Surfels *models;     /* as many */
    uint32_t splat_count, splat_room;
    SceneVolume *volumes; /* likewise */
} Loader;

#define SCENE_SHAPES "a mesh, points, a volume or a depth image" /* that an object has one of */

/* Keys that an object of its kind has not, with the reason why. */
void scene_refuse(Node *object, const char *const *keys, size_t count, const char *reason);

/* A copy of a text that lives as long as the scene. */
const char *scene_copy(Loader *loader, const char *text);

/* A pass that is whole; NULL where none has this name. */
const GpPass *scene_find_pass(const Loader *loader, const char *name, size_t length);

/* A target of such a pass: "pass:NAME", "pass:NAME.1", "pass:NAME.depth". NULL, with a failure at
 * the node, where there is none. */
GpSurface *scene_target(const Loader *loader, const Node *node, const char *name);

/* Keeps the failure of a function that is not a reader's own, with its reason. */
void scene_fail(const Node *node, GpResult result, const GpError *reason);

#endif
