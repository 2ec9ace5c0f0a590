#include "apps/commands/chart/chart_sweep.h"

#include "apps/charts/chart.h"
#include "apps/techniques/registry.h"

#include <stdio.h>
#include <string.h>

/* --- options ---------------------------------------------------------------------------------- */

/* Names and numbers, which a list can hold, of the key. */
static bool can_be_swept(const SettingField *field)
{
    return !field->aside && (field->type == SETTING_NAME || field->type == SETTING_INTEGER ||
                             field->type == SETTING_NUMBER || field->type == SETTING_SIZE);
}

void chart_sweep_prepare(const Technique *const *techniques, int argc, char **argv,
                         ChartSweep *sweep)
{
    size_t count = 0;
    *sweep = (ChartSweep){ .technique = NULL };
    for (int i = 1; i < argc && !sweep->experiment; i++)
        sweep->experiment = experiment_find(techniques, argv[i], &sweep->technique);
    const SettingField *field = sweep->technique ? sweep->technique->settings : NULL;
    for (; field && field->name; field++) {
        if (!can_be_swept(field))
            continue;
        sweep->fields[count] = (SettingField){ .name = field->name,
                                               .argument = "LIST",
                                               .help = field->help,
                                               .type = SETTING_TEXT,
                                               .offset = count * sizeof *sweep->values,
                                               .letter = field->letter };
        count++;
    }
    sweep->options = (CommandOptions){ .fields = sweep->fields, .object = sweep->values };
}

/* --- lists ------------------------------------------------------------------------------------ */

/* Copies the item at the begin of a list; cut where it is too long to be one. returns where the
 * next one begins, behind its comma */
static size_t next_item(const char *at, char item[SETTING_MAX_TEXT])
{
    const size_t length = strcspn(at, ",");
    snprintf(item, SETTING_MAX_TEXT, "%.*s", (int)length, at);
    return length + (at[length] == ',');
}

/* Whether the setting takes all of a list, and how long its longest item is. */
static size_t check_list(struct argp_state *state, const ChartSweep *sweep, size_t number)
{
    const Technique *technique = sweep->technique;
    const char *list = sweep->values[number];
    size_t longest = 0;
    void *scratch = gp_alloc(1, technique->setting_bytes);
    for (const char *at = list; scratch;) {
        char item[SETTING_MAX_TEXT];
        GpError error = { "" };
        const size_t length = next_item(at, item);
        memcpy(scratch, technique->defaults, technique->setting_bytes);
        if (strpbrk(item, "| ") ||
            setting_set(technique->settings, scratch, sweep->fields[number].name, item, &error))
            argp_error(state, "in the list '%s': %s", list,
                       error.text[0] ? error.text : "expected commas between");
        longest = strlen(item) > longest ? strlen(item) : longest;
        at += length;
        if (!*at && at[-1] != ',')
            break;
    }
    gp_free(scratch);
    return longest;
}

/* --- rows ------------------------------------------------------------------------------------- */

static bool is_name(const ChartSweep *sweep, size_t number)
{
    const SettingField *field =
        setting_find(sweep->technique->settings, sweep->fields[number].name);
    return field->type == SETTING_NAME;
}

static size_t items_of(const char *list)
{
    size_t count = 1;
    for (; *list; list++)
        count += *list == ',';
    return count;
}

/* The name of the method that is used where none is named; the experiment's where that is open. */
static const char *usual_method(const ChartSweep *sweep)
{
    const Technique *technique = sweep->technique;
    const SettingField *field = setting_find(technique->settings, "method");
    int number = 0;
    if (!field || field->type != SETTING_NAME)
        return sweep->experiment->name;
    memcpy(&number, (const char *)technique->defaults + field->offset, sizeof number);
    return strcmp(field->names[number], "auto") == 0 ? sweep->experiment->name
                                                     : field->names[number];
}

/* What the experiment is meant by, where none of that was given. */
static const char *meaning_of(const ChartSweep *sweep)
{
    const char *given = sweep->experiment->given;
    for (size_t i = 0; given && sweep->fields[i].name; i++) {
        char option[64];
        snprintf(option, sizeof option, "--%s ", sweep->fields[i].name);
        if (sweep->values[i] && strstr(given, option))
            return "";
    }
    return given ? given : "";
}

/* One combination of names, the first name varying slowest; all numbers. */
static void add_row(const ChartSweep *sweep, size_t row, size_t total, Text *method, Text *options)
{
    size_t period = total;
    text_add(options, "%s", meaning_of(sweep));
    for (size_t i = 0; sweep->fields[i].name; i++) {
        const char *list = sweep->values[i];
        char item[SETTING_MAX_TEXT];
        if (!list)
            continue;
        text_add(options, "%s--%s", options->length ? " " : "", sweep->fields[i].name);
        if (is_name(sweep, i)) {
            period /= items_of(list);
            for (size_t k = row / period % items_of(list) + 1; k > 0; k--)
                list += next_item(list, item);
            text_add(method, "%s%s", method->length ? ", " : "", item);
            text_add(options, " %s", item);
            continue;
        }
        text_add(options, " ");
        for (; *list; list++)
            text_add(options, "%c", *list == ',' ? '|' : *list);
    }
    if (!method->length)
        text_add(method, "%s", usual_method(sweep));
}

void chart_sweep_check(struct argp_state *state, ChartSweep *sweep)
{
    size_t rows = 1, total = 1, length = strlen(meaning_of(sweep)), given = 0;
    for (size_t i = 0; sweep->fields[i].name; i++) {
        if (!sweep->values[i])
            continue;
        const size_t items = items_of(sweep->values[i]);
        given++;
        length += check_list(state, sweep, i) + strlen(sweep->fields[i].name) + 4;
        total = total <= CHART_MAX_POINTS ? total * items : total;
        rows = is_name(sweep, i) && rows <= CHART_MAX_POINTS ? rows * items : rows;
    }
    if (total > CHART_MAX_POINTS || length >= SETTING_MAX_TEXT)
        argp_error(state, "too many settings: expected at most %d", CHART_MAX_POINTS);
    if (!given)
        return;
    sweep->rows = gp_alloc(rows + 1, sizeof *sweep->rows);
    sweep->texts = gp_alloc(2 * rows, sizeof *sweep->texts);
    if (!sweep->rows || !sweep->texts)
        argp_failure(state, EXIT_INTERNAL, 0, "out of memory");
    for (size_t i = 0; i < rows; i++) {
        Text *method = &sweep->texts[2 * i], *options = method + 1;
        add_row(sweep, i, rows, method, options);
        if (method->failed || options->failed)
            argp_failure(state, EXIT_INTERNAL, 0, "out of memory");
        sweep->rows[i] = (TechniqueSweep){ method->data, options->data };
    }
    sweep->own = *sweep->experiment;
    sweep->own.sweep = sweep->rows;
    sweep->own.usual = NULL;
}

void chart_sweep_free(ChartSweep *sweep)
{
    for (size_t i = 0; sweep->rows && sweep->rows[i].method; i++) {
        text_free(&sweep->texts[2 * i]);
        text_free(&sweep->texts[2 * i + 1]);
    }
    gp_free(sweep->rows);
    gp_free(sweep->texts);
}
