/* glasspipe test: the scenes of a folder against what is stored beside them. */
#include "apps/base/content.h"
#include "apps/base/folder.h"
#include "apps/base/json.h"
#include "apps/commands/command.h"
#include "apps/commands/commands.h"
#include "apps/commands/output.h"
#include "apps/commands/progress.h"
#include "apps/golden/golden_folder.h"
#include "apps/golden/limits.h"

#include <stdio.h>
#include <string.h>

typedef struct Test {
    Options options;       /* first: see options.h */
    const char *folder[2]; /* and the name of one scene, or NULL */
    const char *bless, *junit, *reports;
} Test;

static const SettingField options[] = {
    { "bless", "NAME", "Store scene NAME as it is drawn now, instead of testing", SETTING_TEXT,
      .offset = offsetof(Test, bless) },
    { "junit", "FILE", "Write the results to FILE as JUnit's XML, for build servers", SETTING_TEXT,
      .offset = offsetof(Test, junit) },
    { "report", "DIR",
      "Write NAME.png of each scene that is not the same to DIR, and NAME.html, a page with both, "
      "where a picture is stored",
      SETTING_TEXT, .offset = offsetof(Test, reports) },
    OPTIONS_ITEMS,
    { .name = NULL },
};

static const CommandSyntax syntax = {
    .shared = OPTIONS_FRAME,
    .options = options,
    .arguments = "DIR [NAME]",
    .help =
        "Examples:\n"
        "  glasspipe test scenes --bless toon\n"
        "  glasspipe test scenes toon\n"
        "  glasspipe test scenes toon --junit results.xml --report differing\n"
        "\n"
        "Renders every scene of a folder, or the one NAME, and compares it with what is stored "
        "beside it: NAME.hash, the line that `render` prints, for every bit; or a picture, "
        "NAME.png, "
        ".exr, .pfm or .ppm, within the limits; or both. NAME.limits has limits for that scene, "
        "such "
        "as '--fail 0.02 --failpercent 1'.\v"
        "A scene for which nothing is stored fails; --bless stores it, as hash and PNG, or in the "
        "files that are there.\n"
        "Exit code 0: all as stored; 1: some differ, or nothing is stored; 3: a scene or a stored "
        "file cannot be read.",
    .offset = offsetof(Test, folder),
    .least = 1,
    .most = 2,
    .expected = "a folder of scenes",
};

/* --- results ---------------------------------------------------------------------------------- */

static void print_results(const Test *test, const GoldenFolder *folder)
{
    int width = 0;
    for (uint32_t i = 0; i < folder->count; i++) {
        const int length = (int)strlen(folder->scenes[i].name);
        width = length > width ? length : width;
    }
    for (uint32_t i = 0; i < folder->count; i++) {
        const GoldenResult *result = &folder->scenes[i].result;
        if (result->state == GOLDEN_SAME && !test->options.verbose)
            continue;
        const char *message = result->message.data ? result->message.data : "";
        printf("%-7s  %-*s%s%s\n", golden_state_name(result->state), message[0] ? width : 0,
               folder->scenes[i].name, message[0] ? "  " : "", message);
    }
    static const char *const words[GOLDEN_STATES] = { "", "differ", "missing", "broken" };
    printf("%u of %u scenes as stored", folder->states[GOLDEN_SAME], folder->count);
    for (int state = GOLDEN_DIFFERS; state < GOLDEN_STATES; state++)
        if (folder->states[state])
            printf(", %u %s", folder->states[state], words[state]);
    printf("; %.3f s\n", folder->seconds);
}

static int print_json(const Test *test, const GoldenFolder *folder)
{
    json_t *object = json_pack("{s:o, s:I}", "folder", json_text(test->folder[0]), "scenes",
                               (json_int_t)folder->count);
    for (int state = 0; state < GOLDEN_STATES; state++)
        json_object_set_new(object, golden_state_name((GoldenState)state),
                            json_integer((json_int_t)folder->states[state]));
    json_object_set_new(object, "seconds", json_real(folder->seconds));
    json_t *results = json_array();
    for (uint32_t i = 0; i < folder->count; i++) {
        const GoldenResult *result = &folder->scenes[i].result;
        json_array_append_new(
            results, json_pack("{s:o, s:s, s:o, s:f}", "name", json_text(folder->scenes[i].name),
                               "state", golden_state_name(result->state), "message",
                               json_text(result->message.data ? result->message.data : ""),
                               "seconds", result->seconds));
    }
    json_object_set_new(object, "results", results);
    return output_json(object);
}

static int write_junit(const Test *test, const GoldenFolder *folder)
{
    GpError error = { "" };
    Text xml = { .data = NULL };
    golden_folder_junit(folder, test->folder[0], &xml);
    const GpResult result = text_write(test->junit, &xml, &error);
    text_free(&xml);
    if (result)
        return report(EXIT_INTERNAL, "%s", error.text);
    notice(&test->options, "wrote %s", test->junit);
    return EXIT_DONE;
}

static int tell(const Test *test, const GoldenFolder *folder)
{
    int code = EXIT_DONE;
    if (test->options.json)
        code = print_json(test, folder);
    else
        print_results(test, folder);
    if (!code && test->junit)
        code = write_junit(test, folder);
    if (code)
        return code;
    if (folder->unwritten)
        return EXIT_INTERNAL;
    if (folder->states[GOLDEN_BROKEN])
        return EXIT_INPUT;
    return folder->states[GOLDEN_SAME] == folder->count ? EXIT_DONE : EXIT_DIFFERS;
}

/* --- testing ---------------------------------------------------------------------------------- */

/* Of what is asked: a journal of other scenes, or of what was held against others, is none of
 * this. */
static uint64_t key_of(const GoldenTask *task, const GoldenFolder *folder)
{
    const char *texts[] = { GP_VERSION, task->folder, task->reports ? task->reports : "" };
    uint64_t key = content_hash_bytes(task->size, sizeof task->size, 0);
    for (size_t i = 0; i < GP_COUNT(texts); i++)
        key = content_hash_bytes(texts[i], strlen(texts[i]) + 1, key);
    for (const SettingField *field = comparison_fields; field->name; field++)
        key = content_hash_bytes((const char *)&task->settings + field->offset,
                                 setting_bytes(field), key);
    for (uint32_t i = 0; i < folder->count; i++) {
        const char *name = folder->scenes[i].name;
        key = golden_stored_hash(task, name, content_hash_bytes(name, strlen(name) + 1, key));
    }
    return key;
}

static int run(const Test *test, const GoldenTask *task, GoldenFolder *folder)
{
    GpError error = { "" };
    const Progress progress = progress_begin(&test->options);
    ItemRun items = options_items(&test->options);
    items.journal = "glasspipe-test.journal";
    items.key = items.resume || items_are_shared() ? key_of(task, folder) : 0; /* as it is read */
    items.progress = progress_tell;
    items.user = &progress;
    const int code = golden_folder_run(task, &items, folder, &error);
    return code ? report(code, "%s", error.text) : tell(test, folder);
}

static int test_folder(const Test *test, const GoldenTask *task)
{
    GpError error = { "" };
    GoldenFolder folder = { .count = 0 };
    const GpResult result = golden_folder_open(task->folder, test->folder[1], &folder, &error);
    if (result)
        return report(exit_of_input(result), "%s", error.text);
    const bool is_made = !task->reports || !folder_make(task->reports, &error);
    const int code = is_made ? run(test, task, &folder) : report(EXIT_INTERNAL, "%s", error.text);
    golden_folder_free(&folder);
    return code;
}

static int bless(const Test *test, const GoldenTask *task)
{
    GpError error = { "" };
    Text wrote = { .data = NULL };
    GpDevice *device = NULL;
    int code = options_device(&test->options, NULL, &device);
    if (code)
        return code;
    bool is_unwritten = false;
    const GpResult result = golden_bless(task, test->bless, device, &wrote, &is_unwritten, &error);
    if (result)
        code = report(is_unwritten ? EXIT_INTERNAL : exit_of_run(result), "%s", error.text);
    else
        printf("%s", wrote.data ? wrote.data : "");
    text_free(&wrote);
    gp_device_destroy(&device);
    return code;
}

int cmd_test(int argc, char **argv)
{
    Test test = { .bless = NULL };
    GoldenTask task = { .settings = comparison_defaults };
    CommandOptions limits = { .fields = comparison_fields, .object = &task.settings };
    command_parse(&syntax, &limits, argc, argv, &test);
    task.folder = test.folder[0];
    task.reports = test.reports;
    memcpy(task.size, test.options.size, sizeof task.size);
    const Options *of = &test.options;
    if (test.bless && (test.folder[1] || test.junit || test.reports || limits.given))
        return report(EXIT_USAGE, "--bless stores one scene, and tests none");
    if (test.bless && (of->json || of->resume || of->verify > 0 || of->timeout > 0))
        return report(EXIT_USAGE,
                      "--json, --resume, --verify and --timeout are of tests: --bless stores one "
                      "scene");
    return test.bless ? bless(&test, &task) : test_folder(&test, &task);
}
