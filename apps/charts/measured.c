#include "apps/charts/measured.h"

#include "apps/base/content.h"
#include "apps/base/json.h"
#include "pipeline/io/file.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* --- the key ---------------------------------------------------------------------------------- */

static uint64_t hash_field(const SettingField *field, const void *setting, uint64_t seed)
{
    const char *member = (const char *)setting + field->offset;
    const char *text = NULL;
    if (field->type != SETTING_TEXT)
        return content_hash_bytes(member, setting_bytes(field), seed);
    memcpy(&text, member, sizeof text);
    return content_hash(text ? text : "", seed);
}

uint64_t measured_key(const Technique *technique, const Experiment *experiment,
                      const TechniqueInput *input)
{
    const uint32_t size[2] = { input->width, input->height };
    uint64_t key = content_hash_program();
    key = content_hash_bytes(experiment->name, strlen(experiment->name), key);
    key = content_hash(input->path, key);
    key = content_hash_bytes(size, sizeof size, key);
    for (const SettingField *field = technique->settings; field->name; field++)
        if (field->aside && !field->for_pictures)
            key = hash_field(field, input->setting, key);
    return key;
}

/* --- the file --------------------------------------------------------------------------------- */

void measured_open(const char *folder, const char *name, uint64_t key, Measured *measured)
{
    *measured = (Measured){ .settings = NULL };
    const int length = snprintf(measured->path, sizeof measured->path, "%s/%s-%016" PRIx64 ".json",
                                folder, name, key);
    if (length < 0 || length >= (int)sizeof measured->path)
        measured->path[0] = '\0';
    measured->settings = json_load_file(measured->path, 0, NULL);
    if (json_is_object(measured->settings))
        return;
    json_decref(measured->settings);
    measured->settings = json_object();
}

void measured_close(Measured *measured)
{
    json_decref(measured->settings);
    *measured = (Measured){ .settings = NULL };
}

/* "scene/measured/shadow-0123.json" -> "scene/measured" */
static void make_folder(const char *path)
{
    char folder[sizeof((Measured *)NULL)->path];
    const char *slash = strrchr(path, '/');
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - path) : 0, path);
    for (char *at = folder + 1; folder[0] && *at; at++) {
        if (*at != '/')
            continue;
        *at = '\0';
        mkdir(folder, 0777);
        *at = '/';
    }
    if (folder[0])
        mkdir(folder, 0777); /* a failure shows when the file is written */
}

GpResult measured_write(const Measured *measured, GpError *error)
{
    if (!measured->added || !measured->path[0])
        return GP_OK;
    make_folder(measured->path);
    char *text = json_dumps(measured->settings, JSON_INDENT(1));
    GpResult result = text ? gp_file_write(measured->path, text, strlen(text), error)
                           : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    free(text);
    return result;
}

/* --- settings --------------------------------------------------------------------------------- */

/* A number, or "inf"; not a number where there is none. */
static double number_of(const json_t *pair, size_t index)
{
    const json_t *value = json_array_get(pair, index);
    if (json_is_string(value))
        return strcmp(json_string_value(value), "inf") == 0 ? HUGE_VAL : (double)NAN;
    return json_is_number(value) ? json_number_value(value) : (double)NAN;
}

bool measured_find(const Measured *measured, const char *setting, TechniqueError *error)
{
    const json_t *pair = json_object_get(measured->settings, setting);
    *error = (TechniqueError){ .error = number_of(pair, 0), .whole = number_of(pair, 1) };
    return !isnan(error->error) && !isnan(error->whole);
}

void measured_add(Measured *measured, const char *setting, const TechniqueError *error)
{
    json_t *pair = json_array();
    json_array_append_new(pair, json_number(error->error));
    json_array_append_new(pair, json_number(error->whole));
    json_object_set_new(measured->settings, setting, pair);
    measured->added++;
}
