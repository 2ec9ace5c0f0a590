/* A table says for each program where every uniform comes from: from the material, by its key, with
 * a default and limits; or from the pass (matrix, eye, light).
 */
#include "apps/scene/materials.h"

#include "apps/scene/textures.h"
#include "shaders_c/common/blit.h"
#include "shaders_c/materials/deferred.h"
#include "shaders_c/materials/depth.h"
#include "shaders_c/common/depth_only.h"
#include "shaders_c/materials/gbuffer.h"
#include "shaders_c/materials/gouraud.h"
#include "shaders_c/materials/normals.h"
#include "shaders_c/materials/phong.h"
#include "shaders_c/materials/sprite.h"
#include "shaders_c/materials/textured.h"
#include "shaders_c/materials/textured_phong.h"
#include "shaders_c/materials/toon.h"
#include "shaders_c/materials/unlit.h"
#include "shaders_c/materials/vertex_color.h"

#include <string.h>

typedef enum Source {
    FROM_MATERIAL = 0,
    FROM_CAMERA,  /* float[4][4]: world to clip space */
    FROM_EYE,     /* float[3] */
    FROM_LIGHT,   /* float[3]: unit length, towards the first light, as seen from the point that
                        the camera looks at */
    FROM_LIGHTS,  /* all lights: position, colour, 1 / range^2 of each; black where there is none */
    FROM_AMBIENT, /* float[3]: the scene's ambient light times the material's diffuse colour */
    FROM_BACKGROUND, /* float[3] */
    FROM_NEAR,
    FROM_FAR,
    FROM_HEIGHT, /* of the viewport, in pixels */
} Source;

/* A uniform. With a key, the material may give it; its source is then the default. */
typedef struct Uniform {
    Source source;
    size_t offset;
    int count; /* floats; 0 ends a list */
    const char *key;
    float low, high;   /* limits of what the material gives */
    float fallback[4]; /* FROM_MATERIAL: where it does not */
} Uniform;

typedef struct Entry {
    const char *name;
    const GpProgram *program;
    Uniform uniforms[12];
} Entry;

enum { LIGHT_FLOATS = 7, MAX_FLOATS = LIGHT_FLOATS * SCENE_MAX_LIGHTS };

/* clang-format off */
#define FLOATS(type, name) (int)(sizeof(((type *)0)->name) / (sizeof(float)))
#define GIVEN(type, name, from) \
    { from, offsetof(type, name), FLOATS(type, name), NULL, 0, 0, { 0 } }
#define ASKED(type, name, from, low, high, ...) \
    { from, offsetof(type, name), FLOATS(type, name), #name, low, high, \
      { __VA_ARGS__ } }
#define CAMERA(type)                GIVEN(type, mvp, FROM_CAMERA)
#define LIGHT(type)                 GIVEN(type, light, FROM_LIGHT)
#define VALUE(type, name, low, high, ...) ASKED(type, name, FROM_MATERIAL, low, high, __VA_ARGS__)
#define SURFACE(type, ...)          VALUE(type, diffuse, 0, 100, __VA_ARGS__), \
                                    ASKED(type, ambient, FROM_AMBIENT, 0, 100, 0)
#define SHINE(type)  GIVEN(type, eye, FROM_EYE), VALUE(type, specular, 0, 100, 0.3f), \
                                    VALUE(type, shininess, 0, 10000, 32)

static const Entry programs[] = {
    { "phong", &phong_program, { CAMERA(PhongUniforms), LIGHT(PhongUniforms),
        SURFACE(PhongUniforms, 0.7f, 0.7f, 0.7f), SHINE(PhongUniforms) } },
    { "gouraud", &gouraud_program, { CAMERA(PhongUniforms), LIGHT(PhongUniforms),
        SURFACE(PhongUniforms, 0.7f, 0.7f, 0.7f), SHINE(PhongUniforms) } },
    { "textured", &textured_program, { CAMERA(TexturedUniforms), LIGHT(TexturedUniforms),
        SURFACE(TexturedUniforms, 1, 1, 1) } },
    { "textured_phong", &textured_phong_program, {
        CAMERA(PhongUniforms), LIGHT(PhongUniforms),
        SURFACE(PhongUniforms, 1, 1, 1), SHINE(PhongUniforms) } },
    { "toon", &toon_program, { CAMERA(ToonUniforms), GIVEN(ToonUniforms, eye, FROM_EYE),
        LIGHT(ToonUniforms), SURFACE(ToonUniforms, 0.7f, 0.7f, 0.7f),
        VALUE(ToonUniforms, bands, -1, 1, 0.1f, 0.7f), VALUE(ToonUniforms, outline, -1, 1, 0.25f),
        VALUE(ToonUniforms, ink, 0, 100, 0.02f, 0.02f, 0.03f) } },
    { "unlit", &unlit_program, { CAMERA(UnlitUniforms),
        VALUE(UnlitUniforms, color, 0, 100, 1, 1, 1, 1) } },
    { "vertex_color", &vertex_color_program, { CAMERA(VertexColorUniforms) } },
    { "normals", &normals_program, { CAMERA(NormalsUniforms) } },
    { "depth", &depth_program, { CAMERA(DepthUniforms),
        ASKED(DepthUniforms, near, FROM_NEAR, 0, 1e6f, 0),
        ASKED(DepthUniforms, far, FROM_FAR, 0, 1e6f, 0) } },
    { "depth_only", &depth_only_program, { CAMERA(DepthOnlyUniforms) } },
    { "sprite", &sprite_program, { CAMERA(SpriteUniforms), LIGHT(SpriteUniforms),
        VALUE(SpriteUniforms, ambient, 0, 100, 0.25f),
        GIVEN(SpriteUniforms, height, FROM_HEIGHT) } },
    { "gbuffer", &gbuffer_program, { CAMERA(GbufferUniforms),
        VALUE(GbufferUniforms, diffuse, 0, 100, 0.7f, 0.7f, 0.7f) } },
    { "deferred", &deferred_program, { ASKED(DeferredUniforms, ambient, FROM_AMBIENT, 0, 100, 0),
        ASKED(DeferredUniforms, background, FROM_BACKGROUND, 0, 100, 0),
        GIVEN(DeferredUniforms, lights, FROM_LIGHTS) } },
    { "blit", &blit_program, { { .count = 0 } } },
};
/* clang-format on */

static const Entry *find_program(const Node *node, const char *name)
{
    char list[240] = "";
    for (size_t i = 0; i < GP_COUNT(programs); i++) {
        if (strcmp(programs[i].name, name) == 0)
            return &programs[i];
        strncat(list, i ? ", " : "", sizeof list - strlen(list) - 1);
        strncat(list, programs[i].name, sizeof list - strlen(list) - 1);
    }
    node_fail(node, GP_ERROR_FORMAT, "expected one of %s", list);
    return NULL;
}

/* Direction towards the first light. */
static void light_direction(const SceneView *view, float direction[3])
{
    double towards[3] = { 0, 0, 0 };
    for (int i = 0; i < 3 && view->light_count; i++)
        towards[i] =
            view->lights[0].position[i] - (view->lights[0].directional ? 0.0 : view->camera.at[i]);
    vector_normalize(towards);
    for (int i = 0; i < 3; i++)
        direction[i] = (float)towards[i];
}

/* The scene's ambient light on the material's diffuse colour. */
static void ambient_color(const Entry *entry, const SceneView *view, const char *uniforms,
                          float color[3])
{
    memcpy(color, view->ambient, sizeof view->ambient);
    for (const Uniform *u = entry->uniforms; u->count; u++) {
        float diffuse[3];
        if (!u->key || strcmp(u->key, "diffuse") != 0)
            continue;
        memcpy(diffuse, uniforms + u->offset, sizeof diffuse);
        for (int i = 0; i < 3; i++)
            color[i] *= diffuse[i];
    }
}

/* All lights, one after the other; a direction is a very distant place. */
static void all_lights(const SceneView *view, float *values)
{
    memset(values, 0, MAX_FLOATS * sizeof *values);
    for (uint32_t i = 0; i < view->light_count; i++) {
        const SceneLight *light = &view->lights[i];
        for (int k = 0; k < 3; k++) {
            values[k] = (float)(light->position[k] * (light->directional ? 1e4 : 1.0));
            values[3 + k] = light->color[k];
        }
        values[6] = light->range > 0 ? 1 / (light->range * light->range) : 0;
        values += LIGHT_FLOATS;
    }
}

/* What the pass says about a uniform. */
static void default_values(const Entry *entry, const Uniform *u, const SceneView *view,
                           const char *uniforms, float values[MAX_FLOATS])
{
    const Camera *camera = &view->camera;
    switch (u->source) {
    case FROM_MATERIAL:
        memcpy(values, u->fallback, sizeof u->fallback);
        break;
    case FROM_CAMERA:
        memcpy(values, view->world_to_clip, sizeof view->world_to_clip);
        break;
    case FROM_EYE:
        for (int i = 0; i < 3; i++)
            values[i] = (float)camera->eye[i];
        break;
    case FROM_LIGHT:
        light_direction(view, values);
        break;
    case FROM_LIGHTS:
        all_lights(view, values);
        break;
    case FROM_AMBIENT:
        ambient_color(entry, view, uniforms, values);
        break;
    case FROM_BACKGROUND:
        memcpy(values, view->background, sizeof view->background);
        break;
    case FROM_NEAR:
        values[0] = (float)camera->near;
        break;
    case FROM_FAR:
        values[0] = (float)camera->far;
        break;
    case FROM_HEIGHT:
        values[0] = view->viewport.height > 0 ? view->viewport.height : (float)view->height;
        break;
    }
}

static void read_uniform(const Entry *entry, const Uniform *u, Node *material,
                         const SceneView *view, char *uniforms)
{
    float values[MAX_FLOATS];
    default_values(entry, u, view, uniforms, values);
    if (u->key) {
        Node node = node_member(material, u->key);
        if (u->count == 1)
            values[0] = node_number(node, values[0], u->low, u->high);
        else
            node_numbers(node, values, u->count, u->low, u->high);
    }
    memcpy(uniforms + u->offset, values, (size_t)u->count * sizeof values[0]);
}

void scene_read_material(Loader *loader, Node node, const SceneView *view, const char *program,
                         GpDraw *draw)
{
    Node program_node = node_member(&node, "program"), textures = node_member(&node, "textures");
    const Entry *entry = find_program(&program_node, node_string(program_node, program));
    char *uniforms = entry ? frame_alloc(loader->frame, 1, entry->program->uniform_bytes) : NULL;
    if (!uniforms)
        return;
    for (const Uniform *u = entry->uniforms; u->count; u++)
        read_uniform(entry, u, &node, view, uniforms);
    draw->program = entry->program;
    draw->uniforms = uniforms;
    size_t count = node_length(textures, GP_MAX_SAMPLERS);
    for (size_t i = 0; i < count; i++)
        scene_read_texture(loader, node_element(&textures, i), &draw->textures[i]);
    unsigned read =
        entry->program->samplers | entry->program->vertex_samplers | entry->program->local_reads;
    for (unsigned i = 0; i < GP_MAX_SAMPLERS; i++)
        if ((read >> i & 1) && !draw->textures[i].surface)
            node_fail(node_exists(&textures) ? &textures : &node, GP_ERROR_FORMAT,
                      "program %s reads texture %u", entry->name, i);
    if (node_exists(&node))
        node_close(&node);
}
