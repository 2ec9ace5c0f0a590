/* Scenes given as text, loaded by way of a file of their own. */
#ifndef TESTS_SCENE_TEXT_H
#define TESTS_SCENE_TEXT_H

#include "apps/scene/scene.h"
#include "tests/support/unit.h"

#include <unistd.h>

enum { TEMPORARY_PATH = 32 };

/* Writes bytes to a new file; the caller unlinks it. */
static inline void put_temporary(const char *bytes, size_t size, char path[TEMPORARY_PATH])
{
    strcpy(path, "/tmp/glasspipe-test-XXXXXX");
    const int handle = mkstemp(path);
    assert_true(handle >= 0);
    assert_int_equal(write(handle, bytes, size), (ssize_t)size);
    close(handle);
}

static inline GpResult load_scene_text(const char *text, size_t length, const SceneOptions *options,
                                       Scene *scene, GpError *error)
{
    char path[TEMPORARY_PATH];
    put_temporary(text, length, path);
    const GpResult result = scene_load(path, options, scene, error);
    unlink(path);
    return result;
}

/* A scene whose only object has these members, and what its refusal says, in part. */
typedef struct RefusedObject {
    const char *members, *reason;
} RefusedObject;

static inline void check_refused(const char *text, const char *reason)
{
    Scene scene = { 0 };
    GpError error = { "" };
    assert_int_equal(load_scene_text(text, strlen(text), NULL, &scene, &error), GP_ERROR_FORMAT);
    if (!strstr(error.text, reason))
        fail_msg("%s: '%s' instead of '%s'", text, error.text, reason);
}

static inline void check_refused_objects(const RefusedObject *rows, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        char text[400];
        snprintf(text, sizeof text, "{ \"objects\": [ { %s } ] }", rows[i].members);
        check_refused(text, rows[i].reason);
    }
}

/* Memory fails at the first request, then at the second, and so on until the scene loads.
 * in     least: requests that there are at least */
static inline void check_short_memory(const char *text, uint32_t least)
{
    GpResult result = GP_ERROR_MEMORY;
    for (uint32_t fails = 1; result; fails++) {
        Scene scene = { 0 };
        GpError error = { "" };
        result =
            load_scene_text(text, strlen(text), &(SceneOptions){ .fails = fails }, &scene, &error);
        if (result && (result != GP_ERROR_MEMORY || !strstr(error.text, "out of memory")))
            fail_msg("request %u: %s", fails, error.text);
        assert_true(result || fails > least);
        scene_free(&scene);
    }
}

/* A scene that must load; the caller frees it. */
static inline Scene load_scene(const char *text)
{
    Scene scene = { 0 };
    GpError error = { "" };
    if (load_scene_text(text, strlen(text), NULL, &scene, &error))
        fail_msg("%s", error.text);
    return scene;
}

#endif
