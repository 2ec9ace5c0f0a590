/* Scenes, and what stands in files beside them: cameras of views and of depth pictures. */
#include "apps/base/content.h"
#include "apps/depth_images/making/rgbd.h"
#include "apps/scene/camera_file.h"
#include "apps/scene/scene.h"
#include "pipeline/io/file.h"
#include "tests/fuzz/targets.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>

/* --- scenes ----------------------------------------------------------------------------------- */

/* Draws a scene on an executor; the hash of its picture. 0: it could not be drawn. */
static uint64_t draw(const char *path, const SceneOptions *options, GpExecutor executor)
{
    Scene scene = { .light_count = 0 };
    GpError error = { "" };
    uint64_t hash = 0;
    if (scene_load(path, options, &scene, &error))
        return 0;
    if (fuzz_accepted(gp_device_run(fuzz_device(executor), &scene.list, &error), &error))
        hash = gp_surface_hash(scene.picture);
    scene_free(&scene);
    return hash;
}

/* Pixels of all passes: what clearing alone takes, and a pass may have targets of its own. */
static uint64_t pixels_of(const Scene *scene)
{
    uint64_t pixels = 0;
    for (uint32_t p = 0; p < scene->list.pass_count; p++) {
        uint32_t width, height;
        gp_pass_size(&scene->list.passes[p], &width, &height);
        pixels += (uint64_t)width * height;
    }
    return pixels;
}

static uint64_t vertices_of(const Scene *scene)
{
    uint64_t vertices = 0;
    for (uint32_t p = 0; p < scene->list.pass_count; p++)
        for (uint32_t d = 0; d < scene->list.passes[p].draw_count; d++)
            vertices += scene->list.passes[p].draws[d].geometry.vertex_count;
    return vertices;
}

/* Small ones are drawn by both executors, one of sixteen: that takes fifty times as long as
 * reading. */
static bool run_scene(const uint8_t *data, size_t size)
{
    const SceneOptions options = { .width = 24, .height = 16 };
    Scene scene = { .light_count = 0 };
    GpError error = { "" };
    const char *path = fuzz_file(".json", data, size);
    content_hash(path, 0); /* which follows the names in it */
    if (!fuzz_accepted(scene_load(path, &options, &scene, &error), &error))
        return false;
    uint8_t sum = 0;
    for (size_t i = 0; i < size; i++)
        sum = (uint8_t)(sum * 31 + data[i]);
    const bool is_small = sum % 16 == 0 && vertices_of(&scene) < 3000 &&
                          scene.list.pass_count < 20 && pixels_of(&scene) < 20000;
    scene_free(&scene);
    if (is_small)
        fuzz_claim(draw(path, &options, GP_EXECUTOR_FAST) ==
                       draw(path, &options, GP_EXECUTOR_REFERENCE),
                   "executors draw the same bits");
    return true;
}

/* Whether a scene names files, which are looked for beside it. */
static bool names_files(const char *text)
{
    static const char *const ends[] = {
        ".off\"", ".ply\"", ".exr\"", ".nrrd\"", ".png\"", ".json\""
    };
    for (size_t i = 0; i < GP_COUNT(ends); i++)
        if (strstr(text, ends[i]))
            return true;
    return false;
}

/* The project's own scenes. */
static void seeds_scene(const FuzzSeeds *to)
{
    struct dirent **entries;
    const int count = scandir("scenes", &entries, NULL, alphasort);
    for (int i = 0; i < count; i++) {
        const char *name = entries[i]->d_name, *dot = strrchr(name, '.');
        char path[512];
        GpFile file;
        GpError error;
        snprintf(path, sizeof path, "scenes/%s", name);
        if (dot && strcmp(dot, ".json") == 0 && gp_file_read(path, &file, &error) == GP_OK) {
            if (!names_files(file.data))
                to->take(to->user, name, file.data, file.size);
            gp_file_free(&file);
        }
        free(entries[i]);
    }
    free(entries);
    fuzz_seed_text(to, "cube", "{ \"objects\": [ { \"mesh\": \"builtin:cube\" } ] }");
}

/* --- cameras ---------------------------------------------------------------------------------- */

static bool run_camera(const uint8_t *data, size_t size)
{
    Camera camera = { .up = { 0, 1, 0 }, .fovy = 40, .near = 0.1, .far = 100 };
    GpError error = { "" };
    return fuzz_accepted(camera_read_file(fuzz_file(".json", data, size), &camera, &error), &error);
}

static void seeds_camera(const FuzzSeeds *to)
{
    fuzz_seed_text(to, "all",
                   "{ \"eye\": [1, 2, 3], \"at\": [0, 0, 0], \"up\": [0, 1, 0], \"fovy\": 40,\n"
                   "  \"near\": 0.1, \"far\": 20 }");
    fuzz_seed_text(to, "eye", "{ \"eye\": [1, 2, 3], \"at\": [1, 2, 2] }");
}

static bool run_rgbd(const uint8_t *data, size_t size)
{
    RgbdCamera camera;
    GpError error = { "" };
    return fuzz_accepted(rgbd_camera_read(fuzz_file(".json", data, size), NULL, &camera, &error),
                         &error);
}

static void seeds_rgbd(const FuzzSeeds *to)
{
    fuzz_seed_text(to, "one",
                   "{ \"intrinsics\": { \"fx\": 500, \"fy\": 500, \"cx\": 320, \"cy\": 240 },\n"
                   "  \"depth_unit_m\": 0.001, \"camera_axes\": \"x right, y down, z forward\",\n"
                   "  \"frames\": { \"a\": { \"camera_to_world\": [ [1, 0, 0, 0], [0, 1, 0, 0],\n"
                   "  [0, 0, 1, 0], [0, 0, 0, 1] ] } } }");
}

const FuzzTarget fuzz_scene = { "scene", 16384, run_scene, seeds_scene, fuzz_mutate_json };
const FuzzTarget fuzz_camera = { "camera", 1024, run_camera, seeds_camera, fuzz_mutate_json };
const FuzzTarget fuzz_rgbd = { "rgbd", 1024, run_rgbd, seeds_rgbd, fuzz_mutate_json };
