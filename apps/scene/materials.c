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
#include "shaders_c/materials/mapped_phong.h"
#include "shaders_c/materials/normals.h"
#include "shaders_c/materials/phong.h"
#include "shaders_c/materials/sprite.h"
#include "shaders_c/materials/textured.h"
#include "shaders_c/materials/textured_phong.h"
#include "shaders_c/materials/toon.h"
#include "shaders_c/materials/unlit.h"
#include "shaders_c/materials/vertex_color.h"

#include <string.h>

/* What a pass says of its uniforms. */
typedef struct Given {
    float camera[4][4]; /* world to clip space */
    float eye[3];
    /* unit length, towards the first light, as seen from the point that the camera looks at */
    float light[3];
    float lights[SCENE_MAX_LIGHTS]
                [7];  /* position, colour, 1 / range^2; black where there is none */
    float ambient[3]; /* the scene's light times the material's diffuse colour */
    float background[3];
    float near, far;
    float height; /* of the viewport, in pixels */
} Given;

/* Where a uniform comes from: the material, or a member of Given. */
#define FROM_MATERIAL SIZE_MAX
#define FROM(member)  offsetof(Given, member)

/* A uniform. With a key, the material may give it; its source is then the default. */
typedef struct Uniform {
    size_t source, offset;
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

/* clang-format off */
#define FLOATS(type, name) (int)(sizeof(((type *)0)->name) / (sizeof(float)))
#define GIVEN(type, name, from) \
    { from, offsetof(type, name), FLOATS(type, name), NULL, 0, 0, { 0 } }
#define ASKED(type, name, from, low, high, ...) \
    { from, offsetof(type, name), FLOATS(type, name), #name, low, high, \
      { __VA_ARGS__ } }
#define CAMERA(type)                GIVEN(type, mvp, FROM(camera))
#define LIGHT(type)                 GIVEN(type, light, FROM(light))
#define VALUE(type, name, low, high, ...) ASKED(type, name, FROM_MATERIAL, low, high, __VA_ARGS__)
#define SURFACE(type, ...)          VALUE(type, diffuse, 0, 100, __VA_ARGS__), \
                                    ASKED(type, ambient, FROM(ambient), 0, 100, 0)
#define SHINE(type)  GIVEN(type, eye, FROM(eye)), VALUE(type, specular, 0, 100, 0.3f), \
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
    { "mapped_phong", &mapped_phong_program, {
        CAMERA(PhongUniforms), LIGHT(PhongUniforms),
        SURFACE(PhongUniforms, 1, 1, 1), SHINE(PhongUniforms) } },
    { "toon", &toon_program, { CAMERA(ToonUniforms), GIVEN(ToonUniforms, eye, FROM(eye)),
        LIGHT(ToonUniforms), SURFACE(ToonUniforms, 0.7f, 0.7f, 0.7f),
        VALUE(ToonUniforms, bands, -1, 1, 0.1f, 0.7f), VALUE(ToonUniforms, outline, -1, 1, 0.25f),
        VALUE(ToonUniforms, ink, 0, 100, 0.02f, 0.02f, 0.03f) } },
    { "unlit", &unlit_program, { CAMERA(UnlitUniforms),
        VALUE(UnlitUniforms, color, 0, 100, 1, 1, 1, 1) } },
    { "vertex_color", &vertex_color_program, { CAMERA(VertexColorUniforms) } },
    { "normals", &normals_program, { CAMERA(NormalsUniforms) } },
    { "depth", &depth_program, { CAMERA(DepthUniforms),
        ASKED(DepthUniforms, near, FROM(near), 0, 1e6f, 0),
        ASKED(DepthUniforms, far, FROM(far), 0, 1e6f, 0) } },
    { "depth_only", &depth_only_program, { CAMERA(DepthOnlyUniforms) } },
    { "sprite", &sprite_program, { CAMERA(SpriteUniforms), LIGHT(SpriteUniforms),
        VALUE(SpriteUniforms, ambient, 0, 100, 0.25f),
        GIVEN(SpriteUniforms, height, FROM(height)) } },
    { "gbuffer", &gbuffer_program, { CAMERA(GbufferUniforms),
        VALUE(GbufferUniforms, diffuse, 0, 100, 0.7f, 0.7f, 0.7f) } },
    { "deferred", &deferred_program, { ASKED(DeferredUniforms, ambient, FROM(ambient), 0, 100, 0),
        ASKED(DeferredUniforms, background, FROM(background), 0, 100, 0),
        GIVEN(DeferredUniforms, lights, FROM(lights)) } },
    { "blit", &blit_program, { { .count = 0 } } },
};
/* clang-format on */

static const Entry *find_program(Node node, const char *fallback)
{
    const char *names[GP_COUNT(programs)];
    int number = 0;
    for (int i = 0; i < (int)GP_COUNT(programs); i++) {
        names[i] = programs[i].name;
        number = strcmp(names[i], fallback) == 0 ? i : number;
    }
    return &programs[node_name(node, number, names, GP_COUNT(programs))];
}

void scene_light_direction(const SceneView *view, float direction[3])
{
    double towards[3] = { 0, 0, 0 };
    for (int i = 0; i < 3 && view->scene->light_count; i++)
        towards[i] = view->scene->lights[0].position[i] -
                     (view->scene->lights[0].directional ? 0.0 : view->camera.at[i]);
    vector_normalize(towards);
    for (int i = 0; i < 3; i++)
        direction[i] = (float)towards[i];
}

/* All lights; a direction is a very distant place. */
static void all_lights(const SceneView *view, float values[SCENE_MAX_LIGHTS][7])
{
    for (uint32_t i = 0; i < view->scene->light_count; i++) {
        const SceneLight *light = &view->scene->lights[i];
        for (int k = 0; k < 3; k++) {
            values[i][k] = (float)(light->position[k] * (light->directional ? 1e4 : 1.0));
            values[i][3 + k] = light->color[k];
        }
        values[i][6] = light->range > 0 ? 1 / (light->range * light->range) : 0;
    }
}

static Given given_by(const SceneView *view)
{
    Given given = { .near = (float)view->camera.near,
                    .far = (float)view->camera.far,
                    .height =
                        view->viewport.height > 0 ? view->viewport.height : (float)view->height };
    memcpy(given.camera, view->world_to_clip, sizeof given.camera);
    memcpy(given.ambient, view->scene->ambient, sizeof given.ambient);
    memcpy(given.background, view->scene->background, sizeof given.background);
    for (int k = 0; k < 3; k++)
        given.eye[k] = (float)view->camera.eye[k];
    scene_light_direction(view, given.light);
    all_lights(view, given.lights);
    return given;
}

static void read_uniform(const Uniform *u, Node *material, Given *given, char *uniforms)
{
    float *values = (void *)(uniforms + u->offset);
    const void *from =
        u->source == FROM_MATERIAL ? u->fallback : (const void *)((char *)given + u->source);
    memcpy(values, from, (size_t)u->count * sizeof *values);
    if (!u->key)
        return;
    Node node = node_member(material, u->key);
    if (u->count == 1)
        values[0] = node_number(node, values[0], u->low, u->high);
    else
        node_numbers(node, values, u->count, u->low, u->high);
    if (u->source != FROM_MATERIAL)
        node_without_default(&node);
    for (int k = 0; k < 3 && strcmp(u->key, "diffuse") == 0; k++)
        given->ambient[k] *= values[k];
}

const char *scene_program_name(const GpProgram *program)
{
    const Entry *entry = programs;
    while (entry->program != program)
        entry++;
    return entry->name;
}

/* Slots that a program reads; they count from 0. */
static unsigned texture_count(const GpProgram *program)
{
    const unsigned read = program->samplers | program->vertex_samplers | program->local_reads;
    GP_ASSERT((read & (read + 1)) == 0);
    return (unsigned)__builtin_popcount(read);
}

/* "textures": as many as the program reads, unless the draw has some already. */
static void read_textures(Loader *loader, Node *material, const Entry *entry, GpDraw *draw)
{
    const unsigned needed = draw->textures[0].surface ? 0 : texture_count(entry->program);
    Node textures = node_member(material, "textures");
    const size_t count = node_length(textures, GP_MAX_SAMPLERS);
    if (count > needed)
        node_fail(&textures, GP_ERROR_FORMAT, "program %s reads %s", entry->name,
                  needed == 0   ? "no texture"
                  : needed == 1 ? "one texture"
                  : needed == 2 ? "two textures"
                                : "three textures");
    for (size_t i = 0; i < count; i++)
        scene_read_texture(loader, node_element(&textures, i), &draw->textures[i]);
    if (count < needed)
        node_fail(node_exists(&textures) ? &textures : material, GP_ERROR_FORMAT,
                  "program %s reads texture %zu", entry->name, count);
}

/* What can stand in a material, program by program. */
static void describe(Loader *loader, const Node *material, const SceneView *view, bool quad)
{
    GpDraw draw = { .program = NULL };
    for (size_t i = 0; i < GP_COUNT(programs); i++) {
        const Entry *entry = &programs[i];
        Node one = node_alternative(material, entry->name);
        Node name = node_member(&one, "program");
        const bool of_quads = strcmp(entry->name, "blit") == 0;
        const bool of_objects =
            strcmp(entry->name, "phong") == 0 || strcmp(entry->name, "sprite") == 0;
        const bool is_default = quad ? of_quads : of_objects;
        char *uniforms = frame_alloc(loader->frame, 1, entry->program->uniform_bytes);
        Given given = given_by(view);
        node_name(name, is_default ? 0 : -1, &entry->name, 1);
        if (!is_default)
            node_require(&name);
        for (const Uniform *u = entry->uniforms; u->count && uniforms; u++)
            read_uniform(u, &one, &given, uniforms);
        const unsigned needed = texture_count(entry->program);
        if (needed) {
            read_textures(loader, &one, entry, &draw);
            Node textures = node_member(&one, "textures");
            node_has_length(textures, needed, "exactly these");
            node_require(&textures);
        }
        node_close(&one);
    }
}

void scene_read_material(Loader *loader, Node node, const SceneView *view, const char *program,
                         GpDraw *draw)
{
    if (node.schema) {
        const bool quad = strcmp(program, "blit") == 0;
        node_define(&node, quad ? "quad_material" : "material");
        describe(loader, &node, view, quad);
        return;
    }
    const Entry *entry = find_program(node_member(&node, "program"), program);
    char *uniforms = frame_alloc(loader->frame, 1, entry->program->uniform_bytes);
    if (!uniforms)
        return;
    Given given = given_by(view);
    for (const Uniform *u = entry->uniforms; u->count; u++)
        read_uniform(u, &node, &given, uniforms);
    draw->program = entry->program;
    draw->uniforms = uniforms;
    read_textures(loader, &node, entry, draw);
    node_close(&node);
}
