/* What the files that load a scene share; private to apps/scene*.c. */
#ifndef APPS_SCENE_LOADER_H
#define APPS_SCENE_LOADER_H

#include "apps/base/camera.h"
#include "apps/scene/scene.h"
#include "apps/base/json_reader.h"
#include "apps/scene/shapes.h"

enum {
    SCENE_MAX_PASSES = 64,
    SCENE_MAX_OBJECTS = 1024, /* in one pass */
    SCENE_MAX_SURFACES = 512,
    SCENE_MAX_IMAGES = 128,
};

/* Everything that is freed with a scene. */
typedef struct SceneStore {
    struct SceneBlock *blocks;
    GpSurface *surfaces[SCENE_MAX_SURFACES];
    uint32_t surface_count;
    GpPass passes[SCENE_MAX_PASSES];
} SceneStore;

/* What all objects of a pass see. */
typedef struct SceneView {
    Camera camera;
    uint32_t width, height; /* of the targets */
    float world_to_clip[4][4];
    GpViewport viewport;
    const SceneLight *lights;
    uint32_t light_count;
    float ambient[3], background[4];
    bool has_depth; /* the pass has a depth target */
} SceneView;

/* A picture that is loaded already: the same name with the same treatment is not loaded again. */
typedef struct SceneImage {
    const char *name;
    const GpSurface *surface;
    bool srgb, mips;
} SceneImage;

/* The state of loading. */
typedef struct Loader {
    Reader reader;
    GpError *error;
    Scene *scene;
    SceneStore *store;
    SceneView view; /* the scene's, copied and changed by passes */
    SceneImage images[SCENE_MAX_IMAGES];
    uint32_t image_count;
    uint64_t texels; /* bytes of all surfaces of passes */
} Loader;

/* Zeroed memory that lives as long as the scene; NULL, with a failure kept, where there is none. */
void *scene_alloc(Loader *loader, size_t count, size_t size);

/* Hands memory of gp_alloc over to the scene. False, with a failure kept and the memory freed,
 * where that is not possible. */
bool scene_own_memory(Loader *loader, void *memory);

/* A copy of a text that lives as long as the scene. */
const char *scene_copy(Loader *loader, const char *text);

/* Hands a surface over to the scene. */
void scene_own(Loader *loader, GpSurface *surface);

/* A target of a pass that is already read: "pass:NAME", "pass:NAME.1", "pass:NAME.depth". NULL,
 * with a failure at the node, where there is none. */
GpSurface *scene_target(Loader *loader, const Node *node, const char *name);

/* Keeps the failure of a function that is not a reader's own, with its reason. */
void scene_fail(const Node *node, GpResult result, const GpError *reason);

/* --- one file each --------------------------------------------------------------------------- */

/* "size" of the scene or of a pass. */
void scene_read_size(const Node *node, SceneView *view);

/* "camera": changes what is given. */
void scene_read_camera(Node node, Camera *camera);

/* "state" of an object; `state` holds the defaults. World-space clip planes are turned into clip
 * space by the view. */
void scene_read_state(Node node, const SceneView *view, GpState *state);

/* "viewport" of a pass or an object. */
void scene_read_viewport(Node node, GpViewport *viewport);

/* "material": program, uniforms, textures.
 * in   program: the one where none is named */
void scene_read_material(Loader *loader, Node node, const SceneView *view, const char *program,
                         GpDraw *draw);

/* A file as a surface. errors GP_ERROR_IO, GP_ERROR_FORMAT, GP_ERROR_MEMORY */
GpResult scene_load_image(const char *path, bool srgb, bool mips, GpSurface **surface,
                          GpError *error);

/* One element of "textures". */
void scene_read_texture(Loader *loader, Node node, GpTexture *texture);

/* One element of "objects": mesh or points, transformed to the world, with material and state. */
void scene_read_object(Loader *loader, Node node, const SceneView *view, GpDraw *draw);

/* "quad" of a pass: a rectangle over the whole viewport, in clip space, without depth test. */
void scene_read_quad(Loader *loader, Node node, const SceneView *view, GpDraw *draw);

/* One element of "passes". */
void scene_read_pass(Loader *loader, Node node, GpPass *pass);

/* What a pass and a scene without "passes" share: targets, depth, viewport, objects, quad. */
void scene_read_pass_body(Loader *loader, Node *node, const SceneView *view, GpPass *pass);

#endif
