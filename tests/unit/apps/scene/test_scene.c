/* Scene files: what they mean, and what is said about those that mean nothing. */
#include "apps/base/json_lines.h"
#include "apps/scene/scene.h"

#include "pipeline/units/viewport.h"
#include "shaders_c/materials/phong.h"
#include "tests/support/random.h"
#include "tests/support/scene_text.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <unistd.h>

static Scene load(const char *text)
{
    Scene scene = load_scene(text);
    GpError error = { "" };
    if (gp_list_check(&scene.list, &error))
        fail_msg("%s", error.text);
    return scene;
}

/* The text must be refused with a message that ends so, behind "FILE:". */
static void refused(const char *text, const char *expected)
{
    Scene scene = { 0 };
    GpError error = { "" };
    GpResult result = load_scene_text(text, strlen(text), NULL, &scene, &error);
    if (result != GP_ERROR_FORMAT)
        fail_msg("%s gives '%s', not '%s'", text, gp_result_name(result), expected);
    const char *line = strchr(error.text, ':');
    if (!line || strncmp(line + 1, expected, strlen(expected)) != 0)
        fail_msg("'%s' instead of '%s'", error.text, expected);
    assert_null(scene.frame.arena.chunks);
}

/* --- lines ------------------------------------------------------------------------------------ */

static void a_path_leads_to_the_line_of_its_value(void **state)
{
    (void)state;
    static const char text[] =
        "\n{\n\"a\": [1, \"]}\\\"\",\n  { \"b\": {\"x\": [ [],{} ]},\n\"c\"\n:\n7 } ],"
        "\n\"d\": true }";
    static const JsonStep to_c[] = { { "a", 0 }, { NULL, 2 }, { "c", 0 } };
    static const JsonStep to_d[] = { { "d", 0 } };
    static const JsonStep nowhere[] = { { "a", 0 }, { NULL, 2 }, { "z", 0 } };
    assert_int_equal(json_line(text, strlen(text), NULL, 0), 2);
    assert_int_equal(json_line(text, strlen(text), to_c, 1), 3);
    assert_int_equal(json_line(text, strlen(text), to_c, 2), 4);
    assert_int_equal(json_line(text, strlen(text), to_c, 3), 5);
    assert_int_equal(json_line(text, strlen(text), to_d, 1), 8);
    assert_int_equal(json_line(text, strlen(text), nowhere, 3), 4);
}

/* Whatever the bytes, the search stays inside them (the sanitizer build watches). */
static void broken_text_does_not_lead_the_search_outside(void **state)
{
    (void)state;
    static const char alphabet[] = "{}[]\",:\\ 1a\n";
    static const JsonStep path[] = { { "a", 0 }, { NULL, 1 } };
    Random random = { 1 };
    for (int round = 0; round < 20000; round++) {
        char text[24];
        for (size_t i = 0; i < sizeof text; i++) {
            text[i] = alphabet[random_word(&random) % (sizeof alphabet - 1)];
        }
        int line = json_line(text, sizeof text, path, 2);
        assert_true(line >= 1 && line <= (int)sizeof text + 1);
    }
}

/* --- what scenes mean ------------------------------------------------------------------------- */

static void one_object_is_enough(void **state)
{
    (void)state;
    Scene scene = load("{ \"objects\": [ { \"mesh\": \"builtin:cube\" } ] }");
    assert_int_equal(scene.list.pass_count, 1);
    const GpPass *pass = &scene.list.passes[0];
    assert_string_equal(pass->name, "main");
    assert_int_equal(pass->draw_count, 1);
    assert_int_equal(scene.picture->format, GP_A8R8G8B8);
    assert_int_equal(scene.picture->width, 512);
    assert_int_equal(scene.depth->format, GP_D24S8);
    const GpDraw *draw = &pass->draws[0];
    assert_ptr_equal(draw->program, &phong_program);
    assert_int_equal(draw->geometry.index_count, 36);
    assert_int_equal(draw->state.depth.test, GP_LESS_EQUAL);
    assert_true(draw->state.depth.write);
    assert_true(pass->color[0].clear && pass->depth.clear_depth && pass->depth.depth_value == 1);
    scene_free(&scene);
    assert_null(scene.frame.arena.chunks);
}

static const float *position(const GpDraw *draw, uint32_t vertex)
{
    const GpStream *stream = &draw->geometry.streams[GP_POSITION];
    return (const float *)(const void *)((const char *)stream->data +
                                         (size_t)vertex * stream->stride);
}

static void fit_puts_the_box_on_its_floor(void **state)
{
    (void)state;
    Scene scene =
        load("{ \"objects\": [ { \"mesh\": \"builtin:cylinder\", \"transform\": {\"scale\": "
             "[1, 2, 1], \"rotate\": [0, 0, 1, 90]}, \"fit\": [3, 0.5, -1, 1.5] } ] }");
    float low[3] = { 99, 99, 99 }, high[3] = { -99, -99, -99 };
    const GpDraw *draw = &scene.list.passes[0].draws[0];
    for (uint32_t i = 0; i < draw->geometry.vertex_count; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = fminf(low[k], position(draw, i)[k]);
            high[k] = fmaxf(high[k], position(draw, i)[k]);
        }
    /* twice as tall, turned on its side, centre (3, -1), floor 0.5, longest side 1.5 */
    const float expected[2][3] = { { 2.25f, 0.5f, -1.375f }, { 3.75f, 1.25f, -0.625f } };
    for (int k = 0; k < 3; k++) {
        assert_true(fabsf(low[k] - expected[0][k]) < 1e-5f);
        assert_true(fabsf(high[k] - expected[1][k]) < 1e-5f);
    }
    scene_free(&scene);
}

static void a_mirrored_mesh_keeps_its_outside(void **state)
{
    (void)state;
    Scene scene =
        load("{ \"objects\": [ { \"mesh\": \"builtin:sphere\", \"transform\": {\"scale\": "
             "[-1, 2, 1], \"translate\": [0, 5, 0]} } ] }");
    const GpDraw *draw = &scene.list.passes[0].draws[0];
    const GpStream *normals = &draw->geometry.streams[GP_NORMAL];
    for (uint32_t i = 0; i < draw->geometry.index_count; i += 3) {
        const uint32_t *t = draw->geometry.indices + i;
        const float *p = position(draw, t[0]), *q = position(draw, t[1]), *r = position(draw, t[2]);
        const float *n = (const float *)(const void *)((const char *)normals->data +
                                                       (size_t)t[0] * normals->stride);
        float along = 0;
        for (int k = 0; k < 3; k++) {
            int a = (k + 1) % 3, b = (k + 2) % 3;
            along += n[k] * ((q[a] - p[a]) * (r[b] - p[b]) - (q[b] - p[b]) * (r[a] - p[a]));
        }
        assert_true(along > 0);
        assert_true(n[0] * p[0] + n[1] * (p[1] - 5) + n[2] * p[2] > 0);
    }
    scene_free(&scene);
}

static void a_ternary_test_has_its_epsilon(void **state)
{
    (void)state;
    Scene scene = load("{ \"objects\": [ { \"mesh\": \"builtin:sphere\", \"state\": { \"depth\": "
                       "{ \"ternary\": true, \"epsilon\": 0.125 } } } ] }");
    const GpDepthState *depth = &scene.list.passes[0].draws[0].state.depth;
    assert_true(depth->test == GP_LESS_EQUAL && depth->write); /* as objects have by themselves */
    assert_true(depth->ternary && depth->epsilon == 0.125f);
    scene_free(&scene);
}

static void state_names_are_those_of_the_tables(void **state)
{
    (void)state;
    Scene scene = load("{ \"objects\": [ { \"mesh\": \"builtin:quad\", \"state\": {"
                       "\"cull\": \"cw\", \"scissor\": [1, 2, 30, 40], \"depth_bias\": -0.001,"
                       "\"depth\": { \"test\": \"greater\", \"write\": false },"
                       "\"stencil\": { \"test\": \"equal\", \"pass\": \"incr-sat\", \"reference\": "
                       "3, \"ignore\": 240,"
                       "               \"back\": { \"depth_fail\": \"decr\" } },"
                       "\"alpha_test\": { \"test\": \"greater-equal\", \"reference\": 128 },"
                       "\"blend\": { \"op\": \"add\", \"src\": \"src-alpha\", \"dst\": "
                       "\"inv-src-alpha\", \"keep\": "
                       "\"ga\" } } } ] }");
    const GpState *s = &scene.list.passes[0].draws[0].state;
    assert_int_equal(s->raster.cull, GP_CULL_CW);
    assert_true(s->raster.scissor && s->raster.scissor_x0 == 1 && s->raster.scissor_y1 == 40);
    assert_true(s->raster.depth_bias == -0.001f);
    assert_true(s->depth.test == GP_GREATER && !s->depth.write);
    assert_true(s->stencil.enable && s->stencil.two_sided);
    assert_int_equal(s->stencil.front.test, GP_EQUAL);
    assert_int_equal(s->stencil.front.pass, GP_STENCIL_INCR_SAT);
    assert_int_equal(s->stencil.back.depth_fail, GP_STENCIL_DECR);
    assert_true(s->stencil.reference == 3 && s->stencil.ignore == 240);
    assert_true(s->alpha_test.test == GP_GREATER_EQUAL && s->alpha_test.reference == 128);
    for (int i = 0; i < GP_MAX_TARGETS; i++) {
        assert_true(s->blend[i].op == GP_BLEND_ADD && s->blend[i].src == GP_SRC_ALPHA);
        assert_true(s->blend[i].dst == GP_INV_SRC_ALPHA && s->blend[i].keep == 10);
    }
    scene_free(&scene);
}

/* What 0 stands for where nothing is said may be said, too. */
static void depths_and_levels_of_0_can_be_said(void **state)
{
    (void)state;
    for (int said = 0; said < 2; said++) {
        char text[512];
        snprintf(text, sizeof text,
                 "{ \"objects\": [ { \"mesh\": \"builtin:quad\", \"viewport\": { %s },"
                 "\"material\": { \"program\": \"textured\", \"textures\": [ { \"image\": "
                 "\"builtin:dots\"%s } ] } } ] }",
                 said ? "\"depth\": [0, 0]" : "", said ? ", \"max_lod\": 0" : "");
        Scene scene = load(text);
        const GpDraw *draw = &scene.list.passes[0].draws[0];
        const GpViewport v = gp_viewport_resolve(&draw->viewport, 64, 64);
        assert_true(v.min_depth == 0 && v.max_depth == (said ? 0 : 1));
        assert_true(gp_sampler_max_lod(&draw->textures[0].sampler) == (said ? 0 : GP_MAX_LEVELS));
        scene_free(&scene);
    }
}

/* A world-space plane keeps what lies on its positive side. */
static void clip_planes_are_given_in_the_world(void **state)
{
    (void)state;
    Scene scene =
        load("{ \"camera\": {\"eye\": [3, 2, 5]}, \"objects\": [ { \"mesh\": "
             "\"builtin:sphere\", \"state\": { \"clip_planes\": [[0.5, 1, -2, 0.25]] } } ] }");
    const GpDraw *draw = &scene.list.passes[0].draws[0];
    const PhongUniforms *u = draw->uniforms;
    assert_int_equal(draw->state.raster.clip_planes, 1);
    for (uint32_t i = 0; i < draw->geometry.vertex_count; i += 50) {
        const float *p = position(draw, i), *plane = draw->state.raster.clip_plane[0];
        float clip = 0, world = 0.5f * p[0] + p[1] - 2 * p[2] + 0.25f;
        for (int k = 0; k < 4; k++)
            clip += plane[k] * (u->mvp[k][0] * p[0] + u->mvp[k][1] * p[1] + u->mvp[k][2] * p[2] +
                                u->mvp[k][3]);
        assert_true(fabsf(clip - world) < 1e-3f);
    }
    scene_free(&scene);
}

static void passes_share_and_read_targets(void **state)
{
    (void)state;
    Scene scene = load(
        "{ \"passes\": [ { \"name\": \"one\", \"size\": [64, 32], \"targets\": [ {}, { \"format\": "
        "\"r32f\", \"clear\": [2, 0, 0, 0] } ] },"
        "{ \"name\": \"two\", \"size\": [64, 32], \"targets\": [ { \"use\": \"pass:one.1\" } ],"
        "  \"depth\": { \"use\": \"pass:one.depth\" } },"
        "{ \"name\": \"three\", \"depth\": false } ], \"picture\": \"two\" }");
    const GpPass *passes = scene.list.passes;
    assert_int_equal(scene.list.pass_count, 3);
    assert_ptr_equal(passes[1].color[0].surface, passes[0].color[1].surface);
    assert_ptr_equal(passes[1].depth.surface, passes[0].depth.surface);
    assert_true(passes[0].color[1].clear && passes[0].color[1].clear_color[0] == 2);
    assert_false(passes[1].color[0].clear || passes[1].depth.clear_depth);
    assert_null(passes[2].depth.surface);
    assert_ptr_equal(scene.picture, passes[1].color[0].surface);
    scene_free(&scene);
}

static void pictures_from_files_keep_their_bytes(void **state)
{
    (void)state;
    static const char ppm[] = "P6\n2 2\n255\n\x01\x02\x03\x10\x20\x30\xff\x80\x40\x05\x06\x07";
    char path[] = "/tmp/test_scene_XXXXXX.ppm", text[300];
    int handle = mkstemps(path, 4);
    assert_int_equal(write(handle, ppm, sizeof ppm - 1), (ssize_t)(sizeof ppm - 1));
    close(handle);
    for (int srgb = 0; srgb < 2; srgb++) {
        snprintf(text, sizeof text,
                 "{ \"objects\": [ { \"mesh\": \"builtin:quad\", \"material\": { \"program\": "
                 "\"textured\", \"textures\": [ { \"image\": \"%s\", \"srgb\": %s } ] } } ] }",
                 path, srgb ? "true" : "false");
        Scene scene = load(text);
        const GpSurface *surface = scene.list.passes[0].draws[0].textures[0].surface;
        assert_int_equal(surface->format, srgb ? GP_A8R8G8B8_SRGB : GP_A8R8G8B8);
        assert_true(surface->width == 2 && surface->height == 2 && surface->levels == 2);
        /* blue green red alpha */
        assert_memory_equal(surface->level[0].texels, "\x03\x02\x01\xff\x30\x20\x10\xff", 8);
        assert_memory_equal(surface->level[0].texels + surface->level[0].pitch,
                            "\x40\x80\xff\xff\x07\x06\x05\xff", 8);
        scene_free(&scene);
    }
    unlink(path);
}

static void the_size_can_be_overridden(void **state)
{
    (void)state;
    Scene scene = { 0 };
    assert_int_equal(load_scene_text("{\"size\":[30,20]}", 16,
                                     &(SceneOptions){ .width = 7, .height = 5 }, &scene, NULL),
                     GP_OK);
    assert_true(scene.picture->width == 7 && scene.depth->height == 5);
    scene_free(&scene);
}

/* --- what is refused -------------------------------------------------------------------------- */

static void mistakes_are_named_with_path_and_line(void **state)
{
    (void)state;
    refused("{\n\"objects\": [\n{ \"mesh\": \"builtin:cube\" },\n{ \"mesh\": \"builtin:cube\","
            "\"material\": {\n\"shininess\": 20000 } } ] }",
            "5: objects[1].material.shininess: expected a number in [0, 10000]");
    refused("{\n\n\"colour\": 1 }", "3: colour: unknown key");
    refused("{ \"objects\": [ { \"mesh\": \"builtin:cube\", \"state\":\n{ \"culling\": 1 } } ] }",
            "2: objects[0].state.culling: unknown key");
    refused("{ \"size\": \"large\" }", "1: size: expected 2 whole numbers in [1, 8192]");
    refused("{ \"size\": [1000000000, 1] }", "1: size[0]: expected a whole number in [1, 8192]");
    refused("{ \"size\": [0, 1] }", "1: size[0]: expected a whole number in [1, 8192]");
    refused("{ \"size\": [1.5, 1] }", "1: size[0]: expected a whole number in [1, 8192]");
    refused("{ \"camera\": { \"near\": 2,\n\"far\": 1 } }",
            "2: camera.far: far is not beyond near");
    refused("{ \"camera\": { \"up\": [0, 0, 0] } }", "1: camera: eye, at and up give no direction");
    refused("{ \"objects\": [ {} ] }",
            "1: objects[0]: expected a mesh, points, a volume or a depth image");
    refused("{ \"objects\": [ 5 ] }", "1: objects[0]: expected an object");
    refused("{ \"objects\": [ { \"mesh\": \"builtin:cub\" } ] }",
            "1: objects[0].mesh: no builtin mesh 'cub'");
    refused(
        "{ \"objects\": [ { \"mesh\": \"builtin:cube\", \"state\": { \"cull\": \"back\" } } ] }",
        "1: objects[0].state.cull: expected one of none, cw, ccw");
    refused(
        "{ \"objects\": [ { \"mesh\": \"builtin:cube\", \"material\": { \"program\": \"x\" } } ] }",
        "1: objects[0].material.program: expected one of phong");
    refused("{ \"lights\": [ { \"color\": [1, 1, 1] } ] }",
            "1: lights[0]: expected a position or a direction");
    refused("{ \"passes\": [] }", "1: passes: no pass");
    refused("{ \"passes\": [ { } ] }", "1: passes[0].name: missing");
    refused("{ \"passes\": [ { \"name\": \"a\" }, { \"name\": \"a\" } ] }",
            "1: passes[1].name: another pass has this name");
    refused("{ \"passes\": [ { \"name\": \"a\", \"targets\": [ { \"use\": \"pass:b\" } ] } ] }",
            "1: passes[0].targets[0].use: no earlier pass has a target 'pass:b'");
    refused("{ \"targets\": [ { \"format\": \"D16\" } ] }",
            "1: targets[0].format: expected one of a8r8g8b8, ");
    refused("{ \"targets\": [ { \"format\": \"rgb\" } ] }",
            "1: targets[0].format: expected one of a8r8g8b8, ");
    refused("{ \"passes\": [ { \"name\": \"a\" }, { \"name\": \"b\", \"targets\": "
            "[ { \"use\": \"a.depth\" } ] } ] }",
            "1: passes[1].targets[0]: D24S8 is no format for a colour target");
    refused("{ \"picture\": \"x\" }", "1: picture: no pass has this name");
    refused(
        "{ \"objects\": [ { \"mesh\": { \"positions\": [[0,0,0]], \"triangles\": [[0,0,1]] } } ] }",
        "1: objects[0].mesh.triangles[0][2]: expected a whole number in [0, 0]");
    refused("{ \"objects\": [ { \"mesh\": { \"positions\": [[0,0,0]], \"triangles\": [] } } ] }",
            "1: objects[0].mesh: no vertices or no triangles");
    refused("{ \"objects\": [ { \"mesh\": \"no/such/file.ply\" } ] }", "1: objects[0].mesh: ");
}

/* The light's members in "lights": [ { ... } ] must be refused with this message behind the
 * line. */
static void light_refused(const char *members, const char *expected)
{
    char text[400];
    snprintf(text, sizeof text, "{ \"lights\": [ { %s } ] }", members);
    refused(text, expected);
}

static void mistakes_in_lights_are_named(void **state)
{
    (void)state;
#define SPOT "\"position\": [1, 2, 3], \"at\": [0, 0, 0]"
    light_refused("\"position\": [1, 2, 3], \"at\": [0, 0]", "1: lights[0].at: expected 3 numbers");
    light_refused("\"position\": [1, 2, 3], \"at\": [1, 2, 3]",
                  "1: lights[0].at: the light looks at itself");
    light_refused("\"direction\": [0, 0, 0]",
                  "1: lights[0].direction: a direction has some length");
    light_refused(SPOT ", \"cone\": 86", "1: lights[0].cone: expected a number in [0.1, 85]");
    light_refused("\"position\": [1, 2, 3], \"cone\": 20", "1: lights[0].cone: a cone needs");
    light_refused("\"direction\": [1, 2, 3], \"at\": [0, 0, 0], \"cone\": 20",
                  "1: lights[0].cone: a cone needs");
    light_refused(SPOT ", \"size\": -1", "1: lights[0].size: expected a number in [0, 1e+06]");
    light_refused("\"position\": [1, 2, 3], \"size\": 1", "1: lights[0].size: a light with a size");
    light_refused(SPOT ", \"shadow\": true", "1: lights[0].shadow: expected an object");
    light_refused(SPOT ", \"shadow\": { \"bias\": 1 }", "1: lights[0].shadow.bias: unknown key");
    light_refused(SPOT ", \"shadow\": { \"map\": 15 }",
                  "1: lights[0].shadow.map: expected a whole number in [16, 8192]");
    light_refused(SPOT ", \"shadow\": { \"format\": \"r32f\" }",
                  "1: lights[0].shadow.format: expected one of auto, d16, d24, d32f");
    light_refused(SPOT ", \"shadow\": { \"near\": 1 }",
                  "1: lights[0].shadow: expected near < far, or neither");
    light_refused(SPOT ", \"shadow\": { \"near\": 1, \"far\": 1 }",
                  "1: lights[0].shadow: expected near < far, or neither");
    light_refused(SPOT ", \"shadow\": { \"fovy\": 171 }",
                  "1: lights[0].shadow.fovy: expected a number in [1, 170]");
    light_refused("\"position\": [1, 2, 3], \"shadow\": { \"fovy\": 30 }",
                  "1: lights[0].shadow.fovy: the light looks at nothing");
    light_refused(SPOT ", \"shadow\": { \"height\": 2 }",
                  "1: lights[0].shadow.height: only parallel rays have a height");
#undef SPOT
}

static void what_is_not_json_is_refused_with_its_line(void **state)
{
    (void)state;
    refused("", "1: ");
    refused("[]", "1: expected an object");
    refused("{ \"size\": [1, 1],\n\"size\": [2, 2] }", "2: ");
    refused("{\n\"size\": [1, 1],\n}", "3: ");
    refused("{ \"size\": [1e999, 1] }", "1: ");
    static char deep[200001];
    memset(deep, '[', sizeof deep - 1);
    refused(deep, "1: ");
}

/* Gigabytes of targets: refused before anything is allocated. */
static void excess_is_refused(void **state)
{
    (void)state;
    refused("{ \"size\": [8192, 8192], \"targets\": [ { \"format\": \"a32b32g32r32f\" }, {} ] }",
            "1: targets[1]: the targets take over 1024 MB");
    refused("{ \"targets\": [ {}, {}, {}, {}, {} ] }", "1: targets: 5 elements, at most 4");
}

/* Passes, objects and pictures are as many as there is memory for. */
static void hundreds_of_passes_are_read(void **state)
{
    (void)state;
    enum { PASSES = 300 };
    static char text[200 * PASSES] = "{ \"passes\": [";
    char image[20] = "builtin:checker";
    for (int i = 0; i < PASSES; i++) {
        snprintf(text + strlen(text), 200,
                 "%s{ \"name\": \"p%d\", \"size\": [8, 8], \"quad\": { \"material\": {"
                 " \"textures\": [ { \"image\": \"%s\" } ] } } }",
                 i ? "," : "", i, image);
        snprintf(image, sizeof image, "pass:p%d", i);
    }
    strcat(text, "] }");
    Scene scene = load(text);
    assert_int_equal(scene.list.pass_count, PASSES);
    for (uint32_t p = 1; p < PASSES; p++)
        assert_ptr_equal(scene.list.passes[p].draws[0].textures[0].surface,
                         scene.list.passes[p - 1].color[0].surface);
    scene_free(&scene);
}

static void memory_that_runs_short_is_told(void **state)
{
    (void)state;
    static const char text[] =
        "{ \"passes\": ["
        " { \"name\": \"one\", \"size\": [64, 32], \"targets\": [ {}, { \"format\": \"r32f\" } ],"
        "   \"objects\": [ { \"mesh\": \"builtin:cube\" }, { \"points\": \"builtin:grid\","
        "   \"size\": 2 } ] },"
        " { \"name\": \"two\", \"quad\": { \"material\": { \"textures\": ["
        "   { \"image\": \"pass:one\" } ] } } },"
        " { \"name\": \"three\", \"objects\": [ { \"mesh\": \"builtin:plane\", \"material\": {"
        "   \"program\": \"textured\", \"textures\": [ { \"image\": \"builtin:bricks\" } ] } } ] } "
        "],"
        " \"picture\": \"two\" }";
    GpResult result = GP_ERROR_MEMORY;
    for (uint32_t n = 1; result; n++) {
        Scene scene = { 0 };
        GpError error = { "" };
        result = load_scene_text(text, strlen(text), &(SceneOptions){ .fails = n }, &scene, &error);
        if (result && (result != GP_ERROR_MEMORY || !strstr(error.text, ": out of memory")))
            fail_msg("%u pieces of memory: %s", n, error.text);
        assert_true(result ? !scene.frame.arena.chunks : scene.frame.arena.calls < n && n > 20);
        scene_free(&scene);
    }
}

static void a_missing_file_is_an_io_error(void **state)
{
    (void)state;
    Scene scene = { 0 };
    GpError error;
    assert_int_equal(scene_load("/nonexistent/x.json", NULL, &scene, &error), GP_ERROR_IO);
    assert_non_null(strstr(error.text, "x.json"));
}

/* Cutting, or changing one byte of, a good scene gives another scene or an error, never a crash. */
static void damaged_scenes_do_no_harm(void **state)
{
    (void)state;
    static const char good[] = "{ \"objects\": [ { \"mesh\": \"builtin:quad\", \"fit\": [0, 0, 0, "
                               "1], \"state\": { \"blend\": [ "
                               "{ \"op\": \"add\" } ], \"clip_planes\": [[1, 0, 0, 0]] }, "
                               "\"material\": { \"diffuse\": [1, 0, 0] "
                               "} } ], \"camera\": { \"fovy\": 30 }, \"size\": [8, 8] }";
    char text[sizeof good];
    for (size_t i = 0; i < sizeof good - 1; i++)
        for (const char *byte = "\"{],0\x80"; *byte; byte++) {
            memcpy(text, good, sizeof good);
            text[i] = *byte;
            Scene scene = { 0 };
            GpError error = { "" };
            GpResult result =
                load_scene_text(text, *byte == '0' ? i : sizeof good - 1, NULL, &scene, &error);
            assert_true(result == GP_OK || (result == GP_ERROR_FORMAT && error.text[0]));
            scene_free(&scene);
        }
}

/* --- the scenes that come with the program ---------------------------------------------------- */

static bool misses_data(const GpError *error)
{
    return strstr(error->text, "meshes/") != NULL;
}

static void every_scene_of_the_project_is_valid(void **state)
{
    (void)state;
    DIR *folder = opendir("scenes");
    if (!folder)
        fail_msg("run from the root of the repository");
    int count = 0;
    for (struct dirent *entry; (entry = readdir(folder));) {
        char path[300];
        Scene scene = { 0 };
        GpError error = { "" };
        if (!strstr(entry->d_name, ".json"))
            continue;
        snprintf(path, sizeof path, "scenes/%s", entry->d_name);
        GpResult result = scene_load(path, NULL, &scene, &error);
        count++;
        if (result && misses_data(&error))
            continue;
        if (result || gp_list_check(&scene.list, &error))
            fail_msg("%s: %s", entry->d_name, error.text);
        scene_free(&scene);
    }
    closedir(folder);
    assert_true(count > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_path_leads_to_the_line_of_its_value),
        cmocka_unit_test(broken_text_does_not_lead_the_search_outside),
        cmocka_unit_test(one_object_is_enough),
        cmocka_unit_test(fit_puts_the_box_on_its_floor),
        cmocka_unit_test(a_mirrored_mesh_keeps_its_outside),
        cmocka_unit_test(a_ternary_test_has_its_epsilon),
        cmocka_unit_test(state_names_are_those_of_the_tables),
        cmocka_unit_test(depths_and_levels_of_0_can_be_said),
        cmocka_unit_test(clip_planes_are_given_in_the_world),
        cmocka_unit_test(passes_share_and_read_targets),
        cmocka_unit_test(pictures_from_files_keep_their_bytes),
        cmocka_unit_test(the_size_can_be_overridden),
        cmocka_unit_test(mistakes_are_named_with_path_and_line),
        cmocka_unit_test(mistakes_in_lights_are_named),
        cmocka_unit_test(what_is_not_json_is_refused_with_its_line),
        cmocka_unit_test(excess_is_refused),
        cmocka_unit_test(hundreds_of_passes_are_read),
        cmocka_unit_test(memory_that_runs_short_is_told),
        cmocka_unit_test(a_missing_file_is_an_io_error),
        cmocka_unit_test(damaged_scenes_do_no_harm),
        cmocka_unit_test(every_scene_of_the_project_is_valid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
