/* Growth as files, and as JSON. */
#include "apps/charts/scaling.h"

#include "apps/base/json.h"

void growth_free(Growth *growth)
{
    gp_free(growth->points);
    *growth = (Growth){ .points = NULL };
}

static const TechniquePanel *panel_of(const Growth *growth, const GrowthPoint *point)
{
    return &growth->technique->growth->panels[point->panel];
}

const char *growth_name(const Growth *growth, const GrowthPoint *point)
{
    return panel_of(growth, point)->lines[point->line].name;
}

static void write_csv(const Growth *growth, Text *csv)
{
    text_add(csv, "grows,amount,method,scene,options,ms,min_ms,cpu_ms,frames\n");
    for (uint32_t i = 0; i < growth->count; i++) {
        const GrowthPoint *point = &growth->points[i];
        text_add_csv(csv, panel_of(growth, point)->axis, ",");
        text_add_csv_number(csv, point->amount);
        text_add_csv(csv, growth_name(growth, point), ",");
        text_add_csv(csv, point->scene, ",");
        text_add_csv(csv, point->options, ",");
        text_add_csv_number(csv, point->ms);
        text_add_csv_number(csv, point->min_ms);
        text_add_csv_number(csv, point->cpu_ms);
        text_add(csv, "%u\n", point->frames);
    }
}

json_t *growth_json(const Growth *growth)
{
    json_t *points = json_array();
    for (uint32_t i = 0; i < growth->count; i++) {
        const GrowthPoint *point = &growth->points[i];
        json_array_append_new(
            points,
            json_pack("{s:s, s:o, s:s, s:s, s:s, s:o, s:o, s:o, s:I}", "grows",
                      panel_of(growth, point)->axis, "amount", json_number(point->amount), "method",
                      growth_name(growth, point), "scene", point->scene, "options", point->options,
                      "ms", json_number(point->ms), "min_ms", json_number(point->min_ms), "cpu_ms",
                      json_number(point->cpu_ms), "frames", (json_int_t)point->frames));
    }
    return json_pack("{s:s, s:s, s:s, s:s, s:i, s:o}", "technique", growth->technique->name,
                     "title", growth->technique->growth->title, "machine", growth->machine, "isa",
                     growth->isa, "threads", growth->threads, "points", points);
}

GpResult growth_write(const char *path, const Growth *growth, GpError *error)
{
    static const struct {
        const char *extension;
        void (*write)(const Growth *growth, Text *text);
    } files[] = { { "csv", write_csv }, { "svg", growth_draw } };
    GpResult result = GP_OK;
    for (size_t i = 0; i < GP_COUNT(files) && !result; i++) {
        Text text = { .data = NULL };
        files[i].write(growth, &text);
        result = text_write_as(path, files[i].extension, &text, error);
        text_free(&text);
    }
    return result;
}
