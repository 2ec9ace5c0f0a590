#include "apps/charts/chart_page.h"

#include "apps/base/page.h"
#include "apps/charts/chart_draw.h"
#include "apps/charts/chart_file.h"

#include "pipeline/io/file.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char style[] =
    "nav a { margin-right: 18px }\n"
    "svg { display: block; width: 100%; height: auto; border-radius: 8px }\n"
    ".pictures { display: grid; gap: 16px;\n"
    "            grid-template-columns: repeat(auto-fill, minmax(340px, 1fr)) }\n"
    "figure img { width: 100%; border-radius: 6px }\n";

/* --- tables ----------------------------------------------------------------------------------- */

static void add_head(const Chart *chart, Text *page)
{
    page_add_cell(page, "th", "", "method");
    page_add_cell(page, "th", "", "options");
    page_add_cell(page, "th", " class=\"n\"", "ms");
    page_add_cell(page, "th", " class=\"n\"", chart->error_name);
    for (int i = 0; i < chart->metric_count; i++)
        page_add_cell(page, "th", " class=\"n\"", chart->metrics[i]);
}

static void add_number(Text *page, double value, int digits)
{
    char number[32];
    text_for_people(value, digits, number);
    page_add_cell(page, "td", " class=\"n\"", number);
}

static void add_row(const Chart *chart, const ChartPoint *point, Text *page)
{
    page_add_cell(page, "td", "", point->method);
    text_add_escaped(page, "<td><code>%s</code></td>", point->options);
    add_number(page, point->time.ms, 3);
    add_number(page, point->measured.error, 6);
    for (int i = 0; i < chart->metric_count; i++)
        add_number(page, point->measured.metrics[i], 6);
}

static void add_table(const Chart *chart, const ChartPoint *const *points, uint32_t count,
                      Text *page)
{
    text_add(page, "<div class=\"wide\"><table>\n<thead><tr>");
    add_head(chart, page);
    text_add(page, "</tr></thead>\n<tbody>\n");
    for (uint32_t i = 0; i < count; i++) {
        text_add(page, "<tr>");
        add_row(chart, points[i], page);
        text_add(page, "</tr>\n");
    }
    text_add(page, "</tbody></table></div>\n");
}

/* --- pictures --------------------------------------------------------------------------------- */

/* A picture that is not there any more is left out: the chart is right without it. */
static void add_picture(const char *folder, const ChartPoint *point, Text *page)
{
    char path[CHART_MAX_PATH];
    GpFile file = { .data = NULL };
    snprintf(path, sizeof path, "%s/%s", folder, point->picture);
    if (!point->picture[0] || strchr(point->picture, '/') || gp_file_read(path, &file, NULL))
        return;
    text_add(page, "<figure>");
    page_add_png(page, &file, " alt=\"\"");
    char ms[32], error[32];
    text_for_people(point->time.ms, 3, ms);
    text_for_people(point->measured.error, 6, error);
    text_add_escaped(page,
                     "<figcaption>%s: <code>%s</code>, %s ms, error %s</figcaption></figure>\n",
                     point->method, point->options, ms, error);
    gp_file_free(&file);
}

/* --- sections --------------------------------------------------------------------------------- */

static void add_chart(const char *folder, const Chart *chart, const char *name, Text *page)
{
    const ChartPoint **points = gp_alloc(chart->count, sizeof(const ChartPoint *));
    if (!points) {
        page->failed = true;
        return;
    }
    uint32_t best = chart_list_best(chart, points);
    text_add_escaped(page, "<section id=\"%s\">\n<h2>%s</h2>\n", name, chart->title);
    chart_draw(chart, page);
    text_add(page, "<p>The best settings, the fastest first: for each, nothing else measured is "
                   "both faster and more exact.</p>\n");
    add_table(chart, points, best, page);
    text_add(page, "<div class=\"pictures\">\n");
    for (uint32_t i = 0; i < best; i++)
        add_picture(folder, points[i], page);
    text_add(page, "</div>\n<details><summary>All %u settings</summary>\n", chart->count);
    for (uint32_t i = 0; i < chart->count; i++)
        points[i] = &chart->points[i];
    add_table(chart, points, chart->count, page);
    text_add(page, "</details>\n</section>\n");
    gp_free(points);
}

/* --- scaling ----------------------------------------------------------------------------------- */

/* The picture as scaling_write left it, and the technique's words on it, if there is one. */
static void add_scaling(const char *folder, const Technique *technique, Text *contents,
                        Text *sections)
{
    char name[64], path[CHART_MAX_PATH];
    GpFile file = { .data = NULL };
    snprintf(name, sizeof name, "%s_scaling", technique->name);
    snprintf(path, sizeof path, "%s/%s.svg", folder, name);
    if (!technique->scaling || gp_file_read(path, &file, NULL))
        return;
    const char *title = technique->scaling->title;
    text_add_escaped(contents, "<a href=\"#%s\">%s</a>\n", name, title);
    text_add_escaped(sections, "<section id=\"%s\">\n<h2>%s</h2>\n", name, title);
    text_add(sections, "%.*s", (int)file.size, file.data);
    for (const char *const *text = technique->scaling->text; *text; text++)
        text_add_escaped(sections, "<p>%s</p>\n", *text);
    text_add(sections, "</section>\n");
    gp_file_free(&file);
}

/* --- the page --------------------------------------------------------------------------------- */

static int is_json(const struct dirent *entry)
{
    const char *dot = strrchr(entry->d_name, '.');
    return dot && dot != entry->d_name && strcmp(dot, ".json") == 0;
}

/* Adds a chart's section and its line of the contents, or why there is none. */
static void add_file(const char *folder, const char *file, Text *contents, Text *sections)
{
    char path[CHART_MAX_PATH], name[256];
    Chart chart = { .points = NULL };
    GpError error = { "" };
    snprintf(path, sizeof path, "%s/%s", folder, file);
    snprintf(name, sizeof name, "%.*s", (int)(strlen(file) - strlen(".json")), file);
    GpResult result = chart_read(path, &chart, &error);
    sections->failed |= result == GP_ERROR_MEMORY;
    if (result) {
        text_add_escaped(sections, "<p class=\"note\">%s</p>\n", error.text);
        return;
    }
    text_add_escaped(contents, "<a href=\"#%s\">%s (%s)</a>\n", name, chart.title, chart.scene);
    add_chart(folder, &chart, name, sections);
    chart_free(&chart);
}

static void join(const Text *contents, const Text *sections, Text *page)
{
    page_begin(page, "glasspipe: speed against accuracy", style);
    text_add(page,
             "<h1>Speed against accuracy</h1>\n"
             "<p>Each chart holds every setting of a technique against its exact result. "
             "Tooltips tell all numbers of a point.</p>\n<nav>\n%s</nav>\n%s",
             contents->data ? contents->data : "", sections->data ? sections->data : "");
    page_end(page);
    page->failed |= contents->failed || sections->failed;
}

GpResult chart_write_page(const char *folder, const Technique *const *techniques, GpError *error)
{
    struct dirent **entries;
    int count = scandir(folder, &entries, is_json, alphasort);
    if (count < 0)
        return gp_fail(error, GP_ERROR_IO, "%.200s: %s", folder, strerror(errno));
    Text contents = { .data = NULL }, sections = { .data = NULL }, page = { .data = NULL };
    for (int i = 0; i < count; i++) {
        add_file(folder, entries[i]->d_name, &contents, &sections);
        free(entries[i]);
    }
    free(entries);
    for (; *techniques; techniques++)
        add_scaling(folder, *techniques, &contents, &sections);
    join(&contents, &sections, &page);
    char path[CHART_MAX_PATH];
    snprintf(path, sizeof path, "%s/index.html", folder);
    GpResult result = text_write(path, &page, error);
    text_free(&contents);
    text_free(&sections);
    text_free(&page);
    return result;
}
