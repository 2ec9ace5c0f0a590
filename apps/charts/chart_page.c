#include "apps/charts/chart_page.h"

#include "apps/base/page.h"
#include "apps/charts/chart_draw.h"
#include "apps/charts/chart_file.h"
#include "apps/charts/chart_pictures.h"
#include "apps/charts/chart_words.h"
#include "apps/charts/svg.h"
#include "apps/techniques/registry.h"

#include "pipeline/io/file.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Pictures of charts are as wide as can be read; on a narrow page they scroll. Their own titles are
 * the section's. */
static const char style[] =
    "nav a { display: inline-block; margin-right: 18px }\n"
    "svg { display: block; width: 100%; min-width: 940px; height: auto; border-radius: 8px }\n"
    "svg { margin-top: -36px } svg .title { display: none }\n"
    "th, td { white-space: nowrap } figure { margin: 0 0 28px }\n"
    ".beside { display: grid; gap: 8px; grid-template-columns: 1fr 2fr; align-items: start }\n"
    ".alone { max-width: 400px }\n"
    ".beside img, .alone img { width: 100%; border-radius: 6px; display: block }\n"
    "@media (max-width: 700px) { .beside { grid-template-columns: 1fr } }\n"
    "dl { display: grid; grid-template-columns: minmax(110px, 220px) 1fr; gap: 4px 18px;\n"
    "     margin: 12px 0; max-width: 1000px }\n"
    "dt { font-weight: 600 } dd { margin: 0 }\n"
    "@media (max-width: 700px) { dl { grid-template-columns: 1fr } dd { margin-bottom: 8px } }\n"
    "p { max-width: 900px } summary { cursor: pointer; padding: 4px 0 }\n"
    "a:focus-visible, summary:focus-visible, .wide:focus-visible\n"
    "  { outline: 3px solid var(--soft); outline-offset: 2px }\n";

/* What scrolls can be reached and scrolled by keys. */
static void begin_wide(const char *label, Text *page)
{
    text_add_escaped(
        page, "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"%s\">\n", label);
}

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
    begin_wide("table of settings", page);
    text_add(page, "<table>\n<thead><tr>");
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

/* Reads a file of the folder. returns false where there is none, or its name is no file's */
static bool read_beside(const char *folder, const char *name, GpFile *file)
{
    char path[CHART_MAX_PATH];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return name[0] && !strchr(name, '/') && gp_file_read(path, file, NULL) == GP_OK;
}

/* A picture that is not there any more is left out: the chart is right without it. */
static void add_picture(const char *folder, const Chart *chart, const ChartPoint *point, Text *page)
{
    GpFile file = { .data = NULL }, difference = { .data = NULL };
    char name[128], ms[32], error[32];
    if (!read_beside(folder, point->picture, &file))
        return;
    chart_difference_name(point->picture, name, sizeof name);
    const bool both = read_beside(folder, name, &difference);
    text_add(page, "<figure><div class=\"%s\">", both ? "beside" : "alone");
    page_add_png(page, &file, " alt=\"the picture of this setting\"");
    if (both)
        page_add_png(page, &difference, " alt=\"its difference from the truth\"");
    text_for_people(point->time.ms, 3, ms);
    text_for_people(point->measured.error, 6, error);
    text_add_escaped(
        page, "</div>\n<figcaption>%s: <code>%s</code>, %s ms, %s: %s</figcaption></figure>\n",
        point->method, point->options, ms, chart->error_name, error);
    gp_file_free(&file);
    gp_file_free(&difference);
}

static void add_pictures(const char *folder, const Chart *chart, const Experiment *experiment,
                         const ChartPoint *const *best, uint32_t count, Text *page)
{
    text_add(page, "<div class=\"pictures\">\n");
    if (experiment && experiment->difference)
        text_add_escaped(
            page,
            "<p>Pictures of some of them, the fastest first. Beside each is its difference from "
            "the "
            "truth: the picture in pale grey, in colour where it is wrong, and right of that, four "
            "times as large, the part in the black frame, which has most of it. Orange: %s; blue: "
            "%s. The colour is full where this picture is furthest from the truth; where nothing "
            "is "
            "coloured, nothing differs.</p>\n",
            experiment->over, experiment->under);
    for (uint32_t i = 0; i < count; i++)
        add_picture(folder, chart, best[i], page);
    if (experiment && experiment->shows_failures)
        text_add(page,
                 "<p>Of each method that is beaten, and is not as exact as the best, the setting "
                 "farthest from the truth.</p>\n");
    for (uint32_t i = 0; i < chart->count; i++)
        if (!chart->points[i].best)
            add_picture(folder, chart, &chart->points[i], page);
    text_add(page, "</div>\n");
}

/* --- sections --------------------------------------------------------------------------------- */

static void add_chart(const char *folder, const Chart *chart, const char *name,
                      const Technique *const *techniques, Text *page)
{
    char scene[320];
    const ChartPoint **points = gp_alloc(chart->count, sizeof(const ChartPoint *));
    if (!points) {
        page->failed = true;
        return;
    }
    chart_print_scene(chart, scene, sizeof scene);
    uint32_t best = chart_list_best(chart, points);
    text_add_escaped(page, "<section id=\"%s\">\n<h2>%s</h2>\n<p>%s</p>\n", name, chart->title,
                     scene);
    begin_wide("chart", page);
    chart_draw(chart, page);
    text_add(page, "</div>\n");
    chart_add_words(chart, techniques, page);
    text_add(page, "<p>The best settings, the fastest first: for each, nothing else measured is "
                   "both faster and more exact.</p>\n");
    add_table(chart, points, best, page);
    add_pictures(folder, chart, experiment_find(techniques, chart->technique, NULL), points, best,
                 page);
    text_add(page, "<details><summary>All %u settings</summary>\n", chart->count);
    for (uint32_t i = 0; i < chart->count; i++)
        points[i] = &chart->points[i];
    add_table(chart, points, chart->count, page);
    text_add(page, "</details>\n</section>\n");
    gp_free(points);
}

/* --- scaling ---------------------------------------------------------------------------------- */

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
    begin_wide("chart", sections);
    text_add(sections, "%.*s</div>\n", (int)file.size, file.data);
    for (const char *const *text = technique->scaling->text; *text; text++)
        text_add_escaped(sections, "<p>%s</p>\n", *text);
    chart_add_scaling_words(technique->scaling, sections);
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
static void add_file(const char *folder, const char *file, const Technique *const *techniques,
                     Text *contents, Text *sections)
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
    add_chart(folder, &chart, name, techniques, sections);
    chart_free(&chart);
}

static void join(const Text *contents, const Text *sections, Text *page)
{
    Text all = { .data = NULL };
    text_add(&all, "%s", style);
    svg_add_dark_style(&all);
    page_begin(page, "glasspipe: speed against accuracy", all.data ? all.data : "");
    text_add(
        page,
        "<h1>Speed against accuracy</h1>\n"
        "<p>What the same picture or volume costs when it is made in different ways, and how "
        "near each of them comes to the exact result, which is calculated by other means. Each "
        "point of a chart is one setting; the pointer on it, or the tab key, shows all of its "
        "numbers.</p>\n<nav>\n%s</nav>\n",
        contents->data ? contents->data : "");
    chart_add_common_words(page);
    text_add(page, "%s", sections->data ? sections->data : "");
    page_end(page);
    page->failed |= all.failed || contents->failed || sections->failed;
    text_free(&all);
}

GpResult chart_write_page(const char *folder, const Technique *const *techniques, GpError *error)
{
    struct dirent **entries;
    int count = scandir(folder, &entries, is_json, alphasort);
    if (count < 0)
        return gp_fail(error, gp_result_of_errno(errno), "%.200s: %s", folder, strerror(errno));
    Text contents = { .data = NULL }, sections = { .data = NULL }, page = { .data = NULL };
    for (int i = 0; i < count; i++) {
        add_file(folder, entries[i]->d_name, techniques, &contents, &sections);
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
