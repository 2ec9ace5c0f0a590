#include "apps/scene/path.h"

#include "apps/base/json_reader.h"
#include "pipeline/io/file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- reading ---------------------------------------------------------------------------------- */

static const char *const interpolations[] = { "smooth", "linear" };
static const char *const parts[] = { "camera", "lights", "objects" };

static void read_key(Node key, ScenePath *path, size_t number)
{
    Node time = node_member(&key, "time");
    node_require(&time);
    path->times[number] = node_double(time, 0, -1e6, 1e6);
    if (number > 0 && !(path->times[number] > path->times[number - 1]))
        node_fail(&time, GP_ERROR_FORMAT, "expected a time after that of the key before");
    for (size_t i = 0; i < GP_COUNT(parts); i++) {
        Node part = node_member(&key, parts[i]);
        if (node_exists(&part) && !json_is_object(part.value))
            node_fail(&part, GP_ERROR_FORMAT, "expected an object");
    }
    node_close(&key);
    path->keys[number] = key.value;
}

static void read_path(Reader *reader, ScenePath *path)
{
    Node root = node_root(reader), keys = node_member(&root, "keys");
    node_string(node_member(&root, "about"), ""); /* for people */
    path->rate = node_double(node_member(&root, "rate"), 25, 1e-3, 1e6);
    path->smooth = node_name(node_member(&root, "interpolation"), 0, interpolations,
                             GP_COUNT(interpolations)) == 0;
    node_require(&keys);
    path->count = node_length(keys, 100000);
    if (path->count == 0)
        node_fail(&keys, GP_ERROR_FORMAT, "expected at least one key");
    path->times = gp_alloc(path->count + 1, sizeof *path->times);
    path->keys = gp_alloc(path->count + 1, sizeof(json_t *));
    if (!path->times || !path->keys)
        node_fail(&keys, GP_ERROR_MEMORY, "out of memory");
    for (size_t i = 0; i < path->count && !reader->result; i++)
        read_key(node_element(&keys, i), path, i);
    node_close(&root);
}

GpResult path_open(const char *file, ScenePath *path, GpError *error)
{
    Reader reader;
    GpError unused;
    char found[4096];
    GpResult result = gp_data_find(file, found, sizeof found, error);
    if (!result)
        result = reader_open(&reader, found, error ? error : &unused);
    if (result)
        return result;
    ScenePath made = { .count = 0 };
    read_path(&reader, &made);
    made.root = json_incref(reader.root);
    result = reader.result;
    reader_close(&reader);
    if (result)
        path_close(&made);
    else
        *path = made;
    return result;
}

void path_close(ScenePath *path)
{
    gp_free(path->times);
    gp_free(path->keys);
    json_decref(path->root);
    *path = (ScenePath){ .count = 0 };
}

/* --- a moment --------------------------------------------------------------------------------- */

/* A value at those keys that have it. */
typedef struct Track {
    const double *times;
    json_t *const *values;
    size_t count;
    bool smooth;
    bool *failed; /* without memory */
} Track;

/* The last key that is not after a time, or the first. */
static size_t key_before(const Track *track, double time)
{
    size_t at = 0;
    while (at + 1 < track->count && track->times[at + 1] <= time)
        at++;
    return at;
}

static double number_of(const Track *track, size_t key)
{
    return json_number_value(track->values[key]);
}

/* At a key, a second; at the first and the last that of the way beside it. */
static double slope_at(const Track *track, size_t key)
{
    const size_t from = key > 0 ? key - 1 : key, to = key + 1 < track->count ? key + 1 : key;
    return (number_of(track, to) - number_of(track, from)) /
           (track->times[to] - track->times[from]);
}

static double interpolate(const Track *track, double time)
{
    const size_t at = key_before(track, time), next = at + 1;
    const double a = number_of(track, at);
    if (next == track->count || time <= track->times[at])
        return a;
    const double span = track->times[next] - track->times[at];
    const double s = (time - track->times[at]) / span, b = number_of(track, next);
    if (!track->smooth)
        return a + s * (b - a);
    const double da = slope_at(track, at) * span, db = slope_at(track, next) * span;
    const double rest = b - a; /* Horner's form of the Hermite cubic */
    return a + s * (da + s * ((3 * rest - 2 * da - db) + s * (da + db - 2 * rest)));
}

static json_t *value_at(const Track *track, double time);

/* A member, or an element, of the values that have it; its track is in times and values. */
static json_t *child_at(const Track *track, const char *name, size_t index, double time)
{
    double *times = gp_alloc(track->count, sizeof *times);
    json_t **values = gp_alloc(track->count, sizeof(json_t *));
    Track child = { times, values, 0, track->smooth, track->failed };
    *track->failed |= !times || !values;
    for (size_t i = 0; times && values && i < track->count; i++) {
        json_t *value = name ? json_object_get(track->values[i], name)
                             : json_array_get(track->values[i], index);
        if (!value)
            continue;
        times[child.count] = track->times[i];
        values[child.count++] = value;
    }
    json_t *value = child.count ? value_at(&child, time) : NULL;
    gp_free(times);
    gp_free(values);
    return value;
}

static json_t *object_at(const Track *track, double time)
{
    json_t *made = json_object(), *value;
    const char *name;
    for (size_t i = 0; i < track->count; i++)
        json_object_foreach(track->values[i], name, value) if (!json_object_get(made, name))
            json_object_set_new(made, name, child_at(track, name, 0, time));
    return made;
}

static bool all_numbers(const Track *track)
{
    for (size_t i = 0; i < track->count; i++)
        if (!json_is_number(track->values[i]))
            return false;
    return true;
}

static bool all_objects(const Track *track)
{
    for (size_t i = 0; i < track->count; i++)
        if (!json_is_object(track->values[i]))
            return false;
    return true;
}

static bool all_arrays(const Track *track)
{
    for (size_t i = 0; i < track->count; i++)
        if (!json_is_array(track->values[i]) ||
            json_array_size(track->values[i]) != json_array_size(track->values[0]))
            return false;
    return true;
}

/* Where the way between two keys leads beyond all numbers, the value changes at the keys. */
static json_t *number_at(const Track *track, double time)
{
    const double number = interpolate(track, time);
    return json_real(isfinite(number) ? number : number_of(track, key_before(track, time)));
}

static json_t *value_at(const Track *track, double time)
{
    if (all_numbers(track))
        return number_at(track, time);
    if (all_objects(track))
        return object_at(track, time);
    if (!all_arrays(track))
        return json_deep_copy(track->values[key_before(track, time)]);
    json_t *made = json_array();
    for (size_t i = 0; i < json_array_size(track->values[0]); i++)
        json_array_append_new(made, child_at(track, NULL, i, time));
    return made;
}

json_t *path_at(const ScenePath *path, double time)
{
    bool failed = false;
    const Track all = { path->times, path->keys, path->count, path->smooth, &failed };
    json_t *made = object_at(&all, time);
    json_object_del(made, "time");
    if (!failed)
        return made;
    json_decref(made);
    return NULL;
}

/* --- into a scene ----------------------------------------------------------------------------- */

static void merge(json_t *into, json_t *changes)
{
    const char *name;
    json_t *value;
    json_object_foreach(changes, name, value)
    {
        json_t *old = json_object_get(into, name);
        if (json_is_object(old) && json_is_object(value))
            merge(old, value);
        else
            json_object_set(into, name, value);
    }
}

/* Those of an array; returns how many. */
static size_t change_named(json_t *objects, const char *name, json_t *changes)
{
    size_t count = 0;
    for (size_t i = 0; i < json_array_size(objects); i++) {
        json_t *object = json_array_get(objects, i);
        const char *own = json_string_value(json_object_get(object, "name"));
        if (!own || strcmp(own, name) != 0)
            continue;
        merge(object, changes);
        count++;
    }
    return count;
}

static GpResult change_object(json_t *scene, const char *name, json_t *changes, GpError *error)
{
    json_t *passes = json_object_get(scene, "passes");
    size_t count = change_named(json_object_get(scene, "objects"), name, changes);
    for (size_t p = 0; p < json_array_size(passes); p++)
        count += change_named(json_object_get(json_array_get(passes, p), "objects"), name, changes);
    return count
               ? GP_OK
               : gp_fail(error, GP_ERROR_FORMAT, "the scene has no object of the name '%s'", name);
}

static GpResult change_light(json_t *scene, const char *name, json_t *changes, GpError *error)
{
    char *end;
    const unsigned long number = strtoul(name, &end, 10);
    json_t *light = json_array_get(json_object_get(scene, "lights"), number);
    if (name[0] < '0' || name[0] > '9' || *end || !json_is_object(light))
        return gp_fail(error, GP_ERROR_FORMAT, "the scene has no light '%s'", name);
    merge(light, changes);
    return GP_OK;
}

GpResult path_change(json_t *scene, const json_t *changes, GpError *error)
{
    const char *name;
    json_t *value, *camera = json_object_get(changes, "camera");
    if (camera && !json_object_get(scene, "camera"))
        json_object_set_new(scene, "camera", json_object());
    if (camera)
        merge(json_object_get(scene, "camera"), camera);
    GpResult result = GP_OK;
    json_object_foreach(json_object_get(changes, "lights"), name, value) if (!result) result =
        change_light(scene, name, value, error);
    json_object_foreach(json_object_get(changes, "objects"), name, value) if (!result) result =
        change_object(scene, name, value, error);
    return result;
}
