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
