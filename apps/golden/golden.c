#include "apps/golden/golden.h"

#include "apps/base/content.h"
#include "apps/base/machine.h"
#include "apps/compare/comparison_page.h"
#include "apps/golden/limits.h"
#include "apps/scene/scene.h"
#include "apps/techniques/shadow/shadowed.h"
#include "pipeline/io/image/image_file.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { MAX_PATH = 4096 };

/* Extensions of stored pictures, the one first that is looked for first. */
static const char *const pictures[] = { "png", "exr", "pfm", "ppm" };

const char *golden_state_name(GoldenState state)
{
    static const char *const names[GOLDEN_STATES] = { "same", "differs", "missing", "broken" };
    return names[state];
}

static void path_of(const char *folder, const char *name, const char *extension,
                    char path[MAX_PATH])
{
    snprintf(path, MAX_PATH, "%s/%s.%s", folder, name, extension);
}

/* Whether there is such a file beside the scene. */
static bool find_stored(const GoldenTask *task, const char *name, const char *extension,
                        char path[MAX_PATH])
{
    path_of(task->folder, name, extension, path);
    return access(path, F_OK) == 0;
}

static bool find_picture(const GoldenTask *task, const char *name, char path[MAX_PATH])
{
    for (size_t i = 0; i < GP_COUNT(pictures); i++)
        if (find_stored(task, name, pictures[i], path))
            return true;
    return false;
}

/* --- drawing ---------------------------------------------------------------------------------- */

/* Loads and draws a scene; there is nothing to free after an error. */
static GpResult draw(const GoldenTask *task, const char *name, GpDevice *device, Scene *scene,
                     GpError *error)
{
    char path[MAX_PATH];
    const SceneOptions options = { .width = task->size[0], .height = task->size[1] };
    path_of(task->folder, name, "json", path);
    GpResult result = shadowed_scene_load(path, &options, scene, error);
    if (result)
        return result;
    result = gp_device_run(device, &scene->list, error);
    if (result)
        scene_free(scene);
    return result;
}

/* --- comparing -------------------------------------------------------------------------------- */

/* A run in hand. */
typedef struct Run {
    const GoldenTask *task;
    const char *name;
    const Scene *scene;
    GpPool *pool;
    GoldenResult *result;
    ComparisonSettings settings;
} Run;

static void break_off(Run *run, const GpError *error)
{
    run->result->state = GOLDEN_BROKEN;
    text_free(&run->result->message);
    text_add(&run->result->message, "%s", error->text);
}

/* A worse state stays. */
static void differ(Run *run, GoldenState state)
{
    Text *message = &run->result->message;
    run->result->state = state > run->result->state ? state : run->result->state;
    text_add(message, "%s", message->length ? "; " : "");
}

/* Reads a small text file without the line's end. errors those of gp_file_read, GP_ERROR_FORMAT */
static GpResult read_line(const char *path, char *line, size_t size, GpError *error)
{
    GpFile file = { .data = NULL };
    GpResult result = gp_file_read(path, &file, error);
    if (!result && (file.size >= size || memchr(file.data, '\0', file.size)))
        result = gp_fail(error, GP_ERROR_FORMAT, "%s: expected one line of text", path);
    if (!result) {
        const size_t length = strcspn(file.data, "\r\n");
        snprintf(line, size, "%.*s", (int)length, file.data);
        if (file.data[length + strspn(file.data + length, "\r\n\t ")] != '\0')
            result = gp_fail(error, GP_ERROR_FORMAT, "%s: expected one line of text", path);
    }
    gp_file_free(&file);
    return result;
}

static GpResult check_hash(Run *run, const char *path, GpError *error)
{
    char stored[256], drawn[PICTURE_HASH_LINE];
    GpResult result = read_line(path, stored, sizeof stored, error);
    if (!result && strncmp(stored, "hash ", 5) != 0)
        result = gp_fail(error, GP_ERROR_FORMAT,
                         "%s: expected a line 'hash FORMAT WxH NUMBER', "
                         "as `render` prints it",
                         path);
    if (result)
        return result;
    picture_hash_line(run->scene->picture, drawn);
    if (strcmp(stored, drawn) != 0) {
        differ(run, GOLDEN_DIFFERS);
        text_add(&run->result->message, "%s, stored is %s", drawn, stored + strlen("hash "));
    }
    return GP_OK;
}

/* Notes that the report could not be written. */
static GpResult written(const Run *run, GpResult result)
{
    run->result->is_unwritten = run->result->is_unwritten || result;
    return result;
}

static GpResult write_page(const Run *run, const char *path, const Picture pair[2],
                           const Comparison *comparison, GpError *error)
{
    char name[MAX_PATH], drawn[256];
    const char *base = strrchr(path, '/') + 1;
    const char *names[2] = { base, drawn };
    Text page = { .data = NULL };
    snprintf(drawn, sizeof drawn, "%s as drawn", run->name);
    path_of(run->task->reports, run->name, "html", name);
    GpResult result = comparison_page(names, pair, comparison, &run->settings, &page, error);
    if (!result)
        result = written(run, text_write(name, &page, error));
    text_free(&page);
    return result;
}

static GpResult check_pair(Run *run, const char *path, const GpImage images[2], GpError *error)
{
    Picture pair[2];
    Comparison comparison;
    Text *message = &run->result->message;
    const bool hash_differs = run->result->state == GOLDEN_DIFFERS;
    GpResult result = comparison_make(images, run->task->reports && hash_differs, &run->settings,
                                      run->pool, pair, &comparison, error);
    if (result)
        return result;
    if (comparison.failed || hash_differs || !comparison.report.same) {
        differ(run, comparison.failed ? GOLDEN_DIFFERS : GOLDEN_SAME);
        text_add(message, "%s: ", strrchr(path, '/') + 1);
        comparison_say(&comparison, &run->settings, message);
        text_add(message, "%s", comparison.warned ? " (more than the warning limits)" : "");
    }
    if (run->task->reports && (comparison.failed || hash_differs))
        result = write_page(run, path, pair, &comparison, error);
    comparison_free(&comparison);
    picture_free(&pair[0]);
    picture_free(&pair[1]);
    return result;
}

static GpResult check_picture(Run *run, const char *path, GpError *error)
{
    GpImage images[2] = { { .data = NULL }, { .data = NULL } };
    const GpSurface *drawn = run->scene->picture;
    GpResult result = gp_image_read(path, &images[0], error);
    if (!result)
        result = picture_samples(path, drawn, &drawn->window, &images[1], error);
    if (!result)
        result = check_pair(run, path, images, error);
    gp_image_free(&images[0]);
    gp_image_free(&images[1]);
    return result;
}

/* SCENE.limits over those of the folder. */
static GpResult read_limits(Run *run, GpError *error)
{
    char path[MAX_PATH];
    SettingText text;
    if (!find_stored(run->task, run->name, "limits", path))
        return GP_OK;
    GpError reason = { "" };
    GpResult result = read_line(path, text, sizeof text, error);
    if (!result && setting_parse(comparison_fields, &run->settings, text, &reason))
        result = gp_fail(error, GP_ERROR_FORMAT, "%.200s: %.250s", path, reason.text);
    return result;
}

/* Its picture where somebody looks for it, since a build server keeps none. */
static GpResult write_drawn(const Run *run, GpError *error)
{
    char path[MAX_PATH];
    if (!run->task->reports || run->result->state == GOLDEN_SAME)
        return GP_OK;
    path_of(run->task->reports, run->name, "png", path);
    return written(run, picture_write_surface(path, run->scene->picture, false, run->pool, error));
}

static GpResult check(Run *run, GpError *error)
{
    char hash[MAX_PATH], picture[MAX_PATH];
    const bool has_hash = find_stored(run->task, run->name, "hash", hash);
    const bool has_picture = find_picture(run->task, run->name, picture);
    GpResult result = read_limits(run, error);
    if (!result && has_hash)
        result = check_hash(run, hash, error);
    if (!result && has_picture)
        result = check_picture(run, picture, error);
    if (!result && !has_hash && !has_picture) {
        differ(run, GOLDEN_MISSING);
        text_add(&run->result->message, "nothing is stored; --bless %s stores it", run->name);
    }
    return result ? result : write_drawn(run, error);
}

uint64_t golden_stored_hash(const GoldenTask *task, const char *name, uint64_t seed)
{
    static const char *const others[] = { "hash", "limits" };
    for (size_t i = 0; i < GP_COUNT(others) + GP_COUNT(pictures); i++) {
        const bool is_other = i < GP_COUNT(others);
        const char *extension = is_other ? others[i] : pictures[i - GP_COUNT(others)];
        char path[MAX_PATH];
        GpFile file = { .data = NULL };
        GpError unused;
        seed = content_hash_bytes(extension, strlen(extension), seed);
        if (find_stored(task, name, extension, path) && !gp_file_read(path, &file, &unused))
            seed = content_hash_bytes(file.data, file.size, seed);
        gp_file_free(&file);
    }
    return seed;
}

GpResult golden_run(const GoldenTask *task, const char *name, GpDevice *device, GpPool *pool,
                    GoldenResult *result, GpError *error)
{
    const double begin = machine_clock_ms(CLOCK_MONOTONIC);
    Scene scene;
    *result = (GoldenResult){ .state = GOLDEN_SAME };
    Run run = { task, name, &scene, pool, result, task->settings };
    GpResult failure = draw(task, name, device, &scene, error);
    if (!failure) {
        failure = check(&run, error);
        scene_free(&scene);
    }
    if (failure && failure != GP_ERROR_MEMORY)
        break_off(&run, error);
    if (result->message.failed)
        failure = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    if (failure == GP_ERROR_MEMORY)
        text_free(&result->message);
    result->seconds = (machine_clock_ms(CLOCK_MONOTONIC) - begin) / 1e3;
    return failure == GP_ERROR_MEMORY ? failure : GP_OK;
}

/* --- blessing --------------------------------------------------------------------------------- */

static GpResult write_hash(const char *path, const GpSurface *surface, Text *wrote, GpError *error)
{
    char line[PICTURE_HASH_LINE];
    Text text = { .data = NULL };
    picture_hash_line(surface, line);
    text_add(&text, "%s\n", line);
    GpResult result = text_write(path, &text, error);
    text_free(&text);
    if (!result)
        text_add(wrote, "%s\n", path);
    return result;
}

GpResult golden_bless(const GoldenTask *task, const char *name, GpDevice *device, Text *wrote,
                      bool *is_unwritten, GpError *error)
{
    char hash[MAX_PATH], picture[MAX_PATH];
    Scene scene;
    const bool has_hash = find_stored(task, name, "hash", hash);
    const bool has_picture = find_picture(task, name, picture);
    GpResult result = draw(task, name, device, &scene, error);
    if (result)
        return result;
    if (!has_picture)
        path_of(task->folder, name, "png", picture);
    if (has_picture || !has_hash)
        result = picture_write_surface(picture, scene.picture, false, NULL, error);
    if (!result && (has_picture || !has_hash))
        text_add(wrote, "%s\n", picture);
    if (!result && (has_hash || !has_picture))
        result = write_hash(hash, scene.picture, wrote, error);
    *is_unwritten = result != GP_OK;
    if (!result && wrote->failed)
        result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    scene_free(&scene);
    return result;
}
