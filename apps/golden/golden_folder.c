#include "apps/golden/golden_folder.h"

#include "apps/base/machine.h"
#include "apps/scene/scene.h"
#include "pipeline/io/file.h"

#include <dirent.h>
#include <errno.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- the list --------------------------------------------------------------------------------- */

static bool ends_with(const char *name, const char *end)
{
    const size_t length = strlen(name), most = strlen(end);
    return length > most && strcmp(name + length - most, end) == 0;
}

static int is_case(const struct dirent *entry)
{
    return entry->d_name[0] != '.' &&
           (ends_with(entry->d_name, ".json") || ends_with(entry->d_name, ".hash"));
}

/* Adds a name unless it is the one before; entries are sorted. */
static GpResult add_scene(const char *file, const char *only, GoldenFolder *folder)
{
    const size_t length = (size_t)(strrchr(file, '.') - file);
    const char *last = folder->count ? folder->scenes[folder->count - 1].name : "";
    if ((strncmp(last, file, length) == 0 && last[length] == '\0') ||
        (only && (strlen(only) != length || strncmp(only, file, length) != 0)))
        return GP_OK;
    char *name = gp_alloc(length + 1, 1);
    if (!name)
        return GP_ERROR_MEMORY;
    memcpy(name, file, length);
    folder->scenes[folder->count++].name = name;
    return GP_OK;
}

/* By name, so that the two files of one scene come one after the other: "a.hash" and "a.json", with
 * "a-b.json" elsewhere. */
static int by_name(const struct dirent **a, const struct dirent **b)
{
    const char *names[2] = { (*a)->d_name, (*b)->d_name };
    const size_t lengths[2] = { (size_t)(strrchr(names[0], '.') - names[0]),
                                (size_t)(strrchr(names[1], '.') - names[1]) };
    const size_t least = lengths[0] < lengths[1] ? lengths[0] : lengths[1];
    const int order = memcmp(names[0], names[1], least);
    return order ? order : lengths[0] < lengths[1] ? -1 : lengths[0] > lengths[1];
}

GpResult golden_folder_open(const char *path, const char *only, GoldenFolder *folder,
                            GpError *error)
{
    struct dirent **entries;
    const int count = scandir(path, &entries, is_case, by_name);
    if (count < 0)
        return gp_fail(error, gp_result_of_errno(errno), "%.200s: %s", path, strerror(errno));
    GoldenFolder made = { .scenes = gp_alloc((size_t)count, sizeof(GoldenScene)) };
    GpResult result = made.scenes ? GP_OK : GP_ERROR_MEMORY;
    for (int i = 0; i < count; i++) {
        if (!result)
            result = add_scene(entries[i]->d_name, only, &made);
        free(entries[i]);
    }
    free(entries);
    if (result)
        gp_fail(error, result, "out of memory");
    else if (made.count == 0)
        result = gp_fail(error, GP_ERROR_FORMAT, "%.200s: no scene %.100s.json", path,
                         only ? only : "*");
    if (result)
        golden_folder_free(&made);
    else
        *folder = made;
    return result;
}

void golden_folder_free(GoldenFolder *folder)
{
    for (uint32_t i = 0; i < folder->count; i++) {
        gp_free(folder->scenes[i].name);
        text_free(&folder->scenes[i].result.message);
    }
    gp_free(folder->scenes);
    *folder = (GoldenFolder){ .scenes = NULL };
}

/* --- running ---------------------------------------------------------------------------------- */

enum { UNWRITTEN = 64 }; /* added to a state that comes with it */

typedef struct Runs {
    const GoldenTask *task;
    GoldenFolder *folder;
} Runs;

static void tell(const void *context, uint32_t item, char name[ITEM_NAME])
{
    const Runs *runs = context;
    snprintf(name, ITEM_NAME, "%s", runs->folder->scenes[item].name);
}

static double cost(const void *context, uint32_t item)
{
    const Runs *runs = context;
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.json", runs->task->folder, runs->folder->scenes[item].name);
    return scene_outline(path).cost;
}

/* State and message are the same each time; the seconds behind them are not. */
static GpResult draw(const void *context, uint32_t item, const ItemTools *tools, GpBytes *bytes,
                     size_t *same, GpError *error)
{
    const Runs *runs = context;
    GoldenResult result;
    if (golden_run(runs->task, runs->folder->scenes[item].name, tools->device, tools->pool, &result,
                   error))
        return GP_ERROR_MEMORY;
    const uint32_t state = result.state + (result.is_unwritten ? UNWRITTEN : 0u);
    gp_bytes_append(bytes, &state, sizeof state);
    if (result.message.data)
        gp_bytes_append(bytes, result.message.data, result.message.length);
    *same = bytes->size;
    gp_bytes_append(bytes, &result.seconds, sizeof result.seconds);
    text_free(&result.message);
    return GP_OK;
}

static GpResult take(void *context, uint32_t item, const void *bytes, size_t size, GpError *error)
{
    GoldenResult *result = &((Runs *)context)->folder->scenes[item].result;
    uint32_t state = GOLDEN_STATES;
    const size_t rest = sizeof state + sizeof result->seconds;
    if (size >= rest)
        memcpy(&state, bytes, sizeof state);
    const bool is_unwritten = state >= UNWRITTEN;
    state -= is_unwritten ? UNWRITTEN : 0u;
    if (state >= GOLDEN_STATES)
        return gp_fail(error, GP_ERROR_FORMAT, "the result of a scene came damaged");
    const char *message = (const char *)bytes + sizeof state;
    *result = (GoldenResult){ .state = (GoldenState)state, .is_unwritten = is_unwritten };
    if (size > rest)
        text_add(&result->message, "%.*s", (int)(size - rest), message);
    memcpy(&result->seconds, message + (size - rest), sizeof result->seconds);
    return result->message.failed ? gp_fail(error, GP_ERROR_MEMORY, "out of memory") : GP_OK;
}

int golden_folder_run(const GoldenTask *task, const ItemRun *run, GoldenFolder *folder,
                      GpError *error)
{
    const double begin = machine_clock_ms(CLOCK_MONOTONIC);
    Runs runs = { task, folder };
    const ItemWork work = { .count = folder->count,
                            .context = &runs,
                            .tell = tell,
                            .cost = cost,
                            .draw = draw,
                            .take = take };
    const ItemsCode code = items_run(&work, run, error);
    for (uint32_t i = 0; i < folder->count && !code; i++) {
        folder->states[folder->scenes[i].result.state]++;
        folder->unwritten += folder->scenes[i].result.is_unwritten;
    }
    folder->seconds = (machine_clock_ms(CLOCK_MONOTONIC) - begin) / 1e3;
    return (int)code;
}

/* --- JUnit ------------------------------------------------------------------------------------ */

static void add_case(const GoldenScene *scene, const char *path, Text *xml)
{
    const GoldenResult *result = &scene->result;
    const char *message = result->message.data ? result->message.data : "";
    text_add_escaped(xml, "    <testcase classname=\"%s\" name=\"%s\" time=\"%.6f\"", path,
                     scene->name, result->seconds);
    if (result->state == GOLDEN_SAME) {
        text_add(xml, "/>\n");
        return;
    }
    const char *element = result->state == GOLDEN_BROKEN ? "error" : "failure";
    text_add_escaped(xml, ">\n      <%s type=\"%s\" message=\"%s\"/>\n    </testcase>\n", element,
                     golden_state_name(result->state), message);
}

void golden_folder_junit(const GoldenFolder *folder, const char *path, Text *xml)
{
    const unsigned failures = folder->states[GOLDEN_DIFFERS] + folder->states[GOLDEN_MISSING];
    const unsigned errors = folder->states[GOLDEN_BROKEN];
    text_add(xml, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    text_add(xml, "<testsuites tests=\"%u\" failures=\"%u\" errors=\"%u\" time=\"%.6f\">\n",
             folder->count, failures, errors, folder->seconds);
    text_add_escaped(xml,
                     "  <testsuite name=\"%s\" tests=\"%u\" failures=\"%u\" errors=\"%u\" "
                     "time=\"%.6f\">\n",
                     path, folder->count, failures, errors, folder->seconds);
    for (uint32_t i = 0; i < folder->count; i++)
        add_case(&folder->scenes[i], path, xml);
    text_add(xml, "  </testsuite>\n</testsuites>\n");
}
