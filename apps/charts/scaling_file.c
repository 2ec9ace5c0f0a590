#include "apps/charts/scaling_file.h"

#include "apps/base/json.h"
#include "apps/charts/scaling_draw.h"

static const TechniquePanel *panel_of(const Scaling *scaling, const ScalingPoint *point)
{
    return &scaling->technique->scaling->panels[point->panel];
}

static void write_csv(const Scaling *scaling, Text *csv)
{
    text_add(csv, "grows,amount,method,scene,options,ms,min_ms,cpu_ms,frames\n");
    for (uint32_t i = 0; i < scaling->count; i++) {
        const ScalingPoint *point = &scaling->points[i];
        text_add_csv(csv, panel_of(scaling, point)->axis, ",");
        text_add_csv_number(csv, point->amount);
        text_add_csv(csv, scaling_name(scaling, point), ",");
        text_add_csv(csv, point->scene, ",");
        text_add_csv(csv, point->options, ",");
        text_add_csv_number(csv, point->time.ms);
        text_add_csv_number(csv, point->time.min_ms);
        text_add_csv_number(csv, point->time.cpu_ms);
        text_add(csv, "%u\n", point->time.frames);
    }
}

/* An object for each line that a power can be measured of. */
static json_t *powers_json(const Scaling *scaling)
{
    json_t *powers = json_array();
    for (int p = 0; p < TECHNIQUE_PANELS; p++) {
        const TechniquePanel *panel = &scaling->technique->scaling->panels[p];
        for (int line = 0; panel->lines[line].name; line++) {
            ScalingPower power;
            if (scaling_power(scaling, p, line, &power))
                json_array_append_new(
                    powers, json_pack("{s:s, s:s, s:f, s:f, s:f}", "grows", panel->axis, "method",
                                      panel->lines[line].name, "power", power.power, "least",
                                      power.least, "most", power.most));
        }
    }
    return powers;
}

json_t *scaling_json(const Scaling *scaling)
{
    json_t *points = json_array();
    for (uint32_t i = 0; i < scaling->count; i++) {
        const ScalingPoint *point = &scaling->points[i];
        json_array_append_new(
            points,
            json_pack("{s:s, s:o, s:s, s:s, s:s, s:o, s:o, s:o, s:I}", "grows",
                      panel_of(scaling, point)->axis, "amount", json_number(point->amount),
                      "method", scaling_name(scaling, point), "scene", point->scene, "options",
                      point->options, "ms", json_number(point->time.ms), "min_ms",
                      json_number(point->time.min_ms), "cpu_ms", json_number(point->time.cpu_ms),
                      "frames", (json_int_t)point->time.frames));
    }
    return json_pack("{s:s, s:s, s:s, s:s, s:i, s:o, s:o, s:o}", "technique",
                     scaling->technique->name, "title", scaling->technique->scaling->title,
                     "machine", scaling->machine, "isa", scaling->isa, "threads", scaling->threads,
                     "others", json_number(scaling->others), "powers", powers_json(scaling),
                     "points", points);
}

GpResult scaling_write(const char *path, const Scaling *scaling, GpError *error)
{
    Text csv = { .data = NULL }, svg = { .data = NULL };
    write_csv(scaling, &csv);
    GpResult result = text_write_as(path, "csv", &csv, error);
    if (result)
        return result;
    scaling_draw(scaling, &svg);
    return text_write_as(path, "svg", &svg, error);
}
