#include "apps/charts/chart_file.h"

#include "apps/base/json.h"
#include "apps/base/json_reader.h"
#include "apps/charts/chart_draw.h"
#include "pipeline/io/file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- names ------------------------------------------------------------------------------------ */

const char *chart_folder(void)
{
    return gp_path_is_folder("out") ? "out/charts" : "charts";
}

void chart_name(const Experiment *experiment, const char *scene, char *name, size_t size)
{
    char stem[128], own[256];
    text_stem(scene, stem, sizeof stem);
    snprintf(own, sizeof own, "%s_%s", experiment->name, stem);
    text_copy(name, size, strcmp(scene, experiment->scene) == 0 ? experiment->name : own);
}

/* --- CSV -------------------------------------------------------------------------------------- */

enum { MOST_OPTIONS = 32 };

/* The options that any point has, each once: "--map", "--bias". returns how many */
static size_t list_options(const Chart *chart, char names[MOST_OPTIONS][64])
{
    size_t count = 0;
    for (uint32_t k = 0; k < chart->count; k++)
        for (const char *at = chart->points[k].options; (at = strstr(at, "--")); at += 2) {
            char name[64];
            snprintf(name, sizeof name, "%.*s", (int)(2 + strcspn(at + 2, " =")), at);
            size_t i = 0;
            while (i < count && strcmp(names[i], name) != 0)
                i++;
            if (i == count && count < MOST_OPTIONS)
                strcpy(names[count++], name);
        }
    return count;
}

/* What an option is in a point: "2048"; "1" of one without a value; empty where it is not there. */
static void add_option(Text *csv, const char *options, const char *name)
{
    char value[SETTING_MAX_TEXT] = "";
    const size_t length = strlen(name);
    for (const char *at = options; (at = strstr(at, "--")); at += 2) {
        const char *end = at + length;
        if (strncmp(at, name, length) != 0 || !strchr(" =", *end))
            continue;
        end += *end != '\0';
        const char *next = strstr(end, " --");
        snprintf(value, sizeof value, "%.*s", next ? (int)(next - end) : (int)strlen(end), end);
        if (!value[0] || strncmp(end, "--", 2) == 0)
            strcpy(value, "1");
    }
    text_add_csv(csv, value, ",");
}

/* A column for everything that a figure may be drawn of. */
static void write_csv(const Chart *chart, Text *csv)
{
    char names[MOST_OPTIONS][64];
    const size_t count = list_options(chart, names);
    text_add(csv, "method,options,");
    for (size_t i = 0; i < count; i++)
        text_add_csv(csv, names[i], ",");
    text_add(csv, "ms,min_ms,low_ms,high_ms,max_ms,cpu_ms,frames,");
    text_add_csv(csv, chart->error_name, ",");
    for (int i = 0; i < chart->metric_count; i++)
        text_add_csv(csv, chart->metrics[i], ",");
    text_add(csv, "best\n");
    for (uint32_t k = 0; k < chart->count; k++) {
        const ChartPoint *point = &chart->points[k];
        const Timing *time = &point->time;
        const double times[] = { time->ms,     time->min_ms, time->low_ms, time->high_ms,
                                 time->max_ms, time->cpu_ms, time->frames, point->measured.error };
        text_add_csv(csv, point->method, ",");
        text_add_csv(csv, point->options, ",");
        for (size_t i = 0; i < count; i++)
            add_option(csv, point->options, names[i]);
        for (size_t i = 0; i < GP_COUNT(times); i++)
            text_add_csv_number(csv, times[i]);
        for (int i = 0; i < chart->metric_count; i++)
            text_add_csv_number(csv, point->measured.metrics[i]);
        text_add(csv, "%d\n", point->best);
    }
}

/* --- JSON ------------------------------------------------------------------------------------- */

static json_t *point_json(const ChartPoint *point, int metric_count)
{
    json_t *metrics = json_array();
    for (int i = 0; i < metric_count; i++)
        json_array_append_new(metrics, json_number(point->measured.metrics[i]));
    return json_pack(
        "{s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:I, s:o, s:o, s:o, s:b, s:s}", "method",
        point->method, "options", point->options, "ms", json_number(point->time.ms), "min_ms",
        json_number(point->time.min_ms), "low_ms", json_number(point->time.low_ms), "high_ms",
        json_number(point->time.high_ms), "max_ms", json_number(point->time.max_ms), "cpu_ms",
        json_number(point->time.cpu_ms), "frames", (json_int_t)point->time.frames, "error",
        json_number(point->measured.error), "whole", json_number(point->measured.whole), "metrics",
        metrics, "best", point->best, "picture", point->picture);
}

json_t *chart_json(const Chart *chart)
{
    json_t *metrics = json_array(), *points = json_array();
    for (int i = 0; i < chart->metric_count; i++)
        json_array_append_new(metrics, json_string(chart->metrics[i]));
    for (uint32_t k = 0; k < chart->count; k++)
        json_array_append_new(points, point_json(&chart->points[k], chart->metric_count));
    return json_pack("{s:s, s:s, s:s, s:s, s:o, s:s, s:s, s:i, s:o, s:I, s:I, s:o}", "technique",
                     chart->technique, "title", chart->title, "scene", chart->scene, "error_name",
                     chart->error_name, "metrics", metrics, "machine", chart->machine, "isa",
                     chart->isa, "threads", chart->threads, "others", json_number(chart->others),
                     "width", (json_int_t)chart->width, "height", (json_int_t)chart->height,
                     "points", points);
}

static void write_json(const Chart *chart, Text *text)
{
    json_t *object = chart_json(chart);
    char *dumped = object ? json_dumps(object, JSON_INDENT(1)) : NULL;
    text->failed |= !dumped;
    if (dumped)
        text_add(text, "%s\n", dumped);
    free(dumped);
    json_decref(object);
}

GpResult chart_write(const char *path, const Chart *chart, GpError *error)
{
    Text csv = { .data = NULL }, json = { .data = NULL }, svg = { .data = NULL };
    write_csv(chart, &csv);
    GpResult result = text_write_as(path, "csv", &csv, error);
    if (result)
        return result;
    write_json(chart, &json);
    result = text_write_as(path, "json", &json, error);
    if (result)
        return result;
    chart_draw(chart, &svg);
    return text_write_as(path, "svg", &svg, error);
}

/* --- reading ---------------------------------------------------------------------------------- */

static void read_text(Node node, char *text, size_t size)
{
    node_require(&node);
    const char *found = node_string(node, "");
    if (strlen(found) >= size)
        node_fail(&node, GP_ERROR_FORMAT, "expected at most %zu bytes", size - 1);
    else
        strcpy(text, found);
}

static long read_integer(Node node, long high)
{
    node_require(&node);
    return node_integer(node, 0, 0, high);
}

/* A number, or one of the words that json_number writes; 0 where it is not there. */
static double read_later_number(Node node)
{
    static const char *const words[] = { "nan", "inf", "-inf" };
    static const double values[] = { (double)NAN, HUGE_VAL, -HUGE_VAL };
    if (!json_is_string(node.value))
        return node_double(node, 0, -HUGE_VAL, HUGE_VAL);
    return values[node_name(node, 0, words, GP_COUNT(words))];
}

static double read_number(Node node)
{
    node_require(&node);
    return read_later_number(node);
}

/* What charts did not always have. */
static void read_spread(Node *node, ChartPoint *point)
{
    point->time.low_ms = read_later_number(node_member(node, "low_ms"));
    point->time.high_ms = read_later_number(node_member(node, "high_ms"));
    point->time.max_ms = read_later_number(node_member(node, "max_ms"));
    point->measured.whole = read_later_number(node_member(node, "whole"));
}

static void read_point(Node node, ChartPoint *point, int metric_count)
{
    read_text(node_member(&node, "method"), point->method, sizeof point->method);
    read_text(node_member(&node, "options"), point->options, sizeof point->options);
    read_text(node_member(&node, "picture"), point->picture, sizeof point->picture);
    point->time.ms = read_number(node_member(&node, "ms"));
    point->time.min_ms = read_number(node_member(&node, "min_ms"));
    point->time.cpu_ms = read_number(node_member(&node, "cpu_ms"));
    read_spread(&node, point);
    point->time.frames = (uint32_t)read_integer(node_member(&node, "frames"), UINT32_MAX);
    point->measured.error = read_number(node_member(&node, "error"));
    Node metrics = node_member(&node, "metrics"), best = node_member(&node, "best");
    node_require(&best);
    point->best = node_bool(best, false);
    if (node_length(metrics, TECHNIQUE_MAX_METRICS) != (size_t)metric_count)
        node_fail(&metrics, GP_ERROR_FORMAT, "expected %d numbers", metric_count);
    for (int i = 0; i < metric_count; i++)
        point->measured.metrics[i] = read_number(node_element(&metrics, (size_t)i));
    node_close(&node);
}

static void read_points(const Node *points, Chart *chart)
{
    node_require(points);
    chart->count = (uint32_t)node_length(*points, CHART_MAX_POINTS);
    chart->points = gp_alloc(chart->count, sizeof *chart->points);
    if (!chart->points) {
        node_fail(points, GP_ERROR_MEMORY, "out of memory");
        return;
    }
    for (uint32_t i = 0; i < chart->count; i++)
        read_point(node_element(points, i), &chart->points[i], chart->metric_count);
}

static void read_chart(Node root, Chart *chart)
{
    read_text(node_member(&root, "technique"), chart->technique, sizeof chart->technique);
    read_text(node_member(&root, "title"), chart->title, sizeof chart->title);
    read_text(node_member(&root, "scene"), chart->scene, sizeof chart->scene);
    read_text(node_member(&root, "error_name"), chart->error_name, sizeof chart->error_name);
    read_text(node_member(&root, "machine"), chart->machine, sizeof chart->machine);
    read_text(node_member(&root, "isa"), chart->isa, sizeof chart->isa);
    chart->threads = (int)read_integer(node_member(&root, "threads"), INT32_MAX);
    const Node others = node_member(&root, "others"); /* charts did not always have it */
    chart->others = others.value ? read_later_number(others) : -1;
    chart->width = (uint32_t)read_integer(node_member(&root, "width"), UINT32_MAX);
    chart->height = (uint32_t)read_integer(node_member(&root, "height"), UINT32_MAX);
    Node metrics = node_member(&root, "metrics"), points = node_member(&root, "points");
    node_require(&metrics);
    chart->metric_count = (int)node_length(metrics, TECHNIQUE_MAX_METRICS);
    for (int i = 0; i < chart->metric_count; i++)
        read_text(node_element(&metrics, (size_t)i), chart->metrics[i], sizeof chart->metrics[i]);
    read_points(&points, chart);
    node_close(&root);
}

GpResult chart_read(const char *path, Chart *chart, GpError *error)
{
    Reader reader;
    Chart read = { .points = NULL };
    GpResult result = reader_open(&reader, path, error);
    if (result)
        return result;
    read_chart(node_root(&reader), &read);
    result = reader.result;
    reader_close(&reader);
    if (result)
        chart_free(&read);
    else
        *chart = read;
    return result;
}
