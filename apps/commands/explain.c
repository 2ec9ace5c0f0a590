/* glasspipe explain: which units every draw needs, and what its shaders cost. */
#include "apps/base/json.h"
#include "apps/commands/command.h"
#include "apps/commands/commands.h"
#include "apps/commands/output.h"
#include "apps/commands/shader_limits.h"
#include "apps/commands/pass_list.h"
#include "pipeline/shader/counts.h"

#include <stdio.h>

typedef struct Explain {
    Options options; /* first: see options.h */
    const char *scene;
} Explain;

static const CommandSyntax syntax = {
    .shared = OPTIONS_COMMON,
    .arguments = "SCENE.json",
    .help = "Examples:\n"
            "  glasspipe explain scenes/default.json\n"
            "  glasspipe explain scenes/default.json --json\n"
            "\n"
            "Tells for every draw of a scene which units of the pipeline run and which are "
            "skipped, and "
            "what its shaders use of their profiles' limits.\v"
            "Exit code 1: some shader exceeds its profile.",
    .offset = offsetof(Explain, scene),
    .least = 1,
    .most = 1,
    .expected = "a scene file",
};

/* Where depth and stencil stand: before the pixel shader, or behind it; null where neither is. */
static json_t *depth_json(const GpNeeds *needs)
{
    if (!needs->depth_test && !needs->depth_write && !needs->stencil)
        return json_null();
    return json_pack("{s:s, s:s}", "when", needs->late_depth ? "late" : "early", "why",
                     needs->late_depth ? "the shader may still kill the fragment or move it"
                                       : "nothing after them changes their verdict");
}

static json_t *units_json(const GpNeeds *needs)
{
    GpUnitNeed rows[GP_UNIT_NEEDS];
    gp_needs_explain(needs, rows);
    json_t *units = json_array();
    for (size_t i = 0; i < GP_UNIT_NEEDS; i++)
        json_array_append_new(units, json_pack("{s:s, s:b, s:s}", "unit", rows[i].unit, "runs",
                                               rows[i].runs, "why", rows[i].why));
    return units;
}

static json_t *draw_json(const GpPass *pass, const GpDraw *draw, uint32_t number)
{
    GpError error = { "" };
    const GpProgram *program = draw->program;
    bool fits = gp_program_check(program, &error) == GP_OK;
    const GpNeeds needs = gp_draw_needs(pass, draw, gp_pixel_facts(program).varyings_read);
    json_t *object =
        json_pack("{s:I, s:s, s:s, s:s, s:I, s:o, s:o}", "draw", (json_int_t)number, "name",
                  draw->name ? draw->name : "", "program", program->name, "geometry",
                  gp_primitive_names[draw->geometry.primitive], "primitives",
                  (json_int_t)gp_geometry_primitives(&draw->geometry), "units", units_json(&needs),
                  "depth_and_stencil", depth_json(&needs));
    json_object_set_new(object, "fits", json_boolean(fits));
    json_object_set_new(object, "problem", fits ? json_null() : json_string(error.text));
    shader_limits_add(object, program);
    return object;
}

static void print_unit(const char *name, const char *state, const json_t *object)
{
    printf("    %-21s %-8s %s\n", name, state, json_text_of(object, "why"));
}

static void print_draw(const json_t *draw)
{
    printf("\n  Draw %lld", json_whole_of(draw, "draw"));
    const char *name = json_text_of(draw, "name");
    if (name[0])
        printf(" \"%s\"", name);
    printf(": %lld %s, program %s\n", json_whole_of(draw, "primitives"),
           json_text_of(draw, "geometry"), json_text_of(draw, "program"));
    size_t i;
    const json_t *unit, *depth = json_object_get(draw, "depth_and_stencil");
    json_array_foreach(json_object_get(draw, "units"), i, unit)
        print_unit(json_text_of(unit, "unit"),
                   json_is_true(json_object_get(unit, "runs")) ? "runs" : "skipped", unit);
    if (json_is_object(depth))
        print_unit("depth and stencil", json_text_of(depth, "when"), depth);

    shader_limits_print(json_object_get(draw, "vertex_shader"),
                        json_object_get(draw, "pixel_shader"));
    const json_t *problem = json_object_get(draw, "problem");
    if (json_is_string(problem))
        printf("    exceeds its profile: %s\n", json_string_value(problem));
}

static void print_pass(const json_t *pass)
{
    printf("Pass %lld", json_whole_of(pass, "pass"));
    const char *name = json_text_of(pass, "name");
    if (name[0])
        printf(" \"%s\"", name);
    printf(": %lldx%lld,", json_whole_of(pass, "width"), json_whole_of(pass, "height"));
    size_t i;
    const json_t *item;
    json_array_foreach(json_object_get(pass, "targets"), i, item)
        printf(" %s", json_string_value(item));
    printf(", group %lld\n", json_whole_of(pass, "group"));
    json_array_foreach(json_object_get(pass, "draws"), i, item) print_draw(item);
    putchar('\n');
}

/* The list is not checked first: gp_list_check refuses a program that exceeds its profile, and here
 * that is the answer, not an error. */
static int explain_list(const Explain *explain, const GpList *list)
{
    json_t *passes = pass_list_json(list);
    if (!passes)
        return report(EXIT_INTERNAL, "out of memory");
    int code = EXIT_DONE;
    for (uint32_t p = 0; p < list->pass_count; p++) {
        const GpPass *pass = &list->passes[p];
        json_t *draws = json_array(), *object = json_array_get(passes, p);
        for (uint32_t i = 0; i < pass->draw_count; i++) {
            json_t *draw = draw_json(pass, &pass->draws[i], i);
            if (json_is_false(json_object_get(draw, "fits")))
                code = EXIT_DIFFERS;
            json_array_append_new(draws, draw);
        }
        json_object_set_new(object, "draws", draws);
        if (!explain->options.json)
            print_pass(object);
    }
    if (explain->options.json)
        output_json(json_pack("{s:O}", "passes", passes));
    json_decref(passes);
    return code;
}

int cmd_explain(int argc, char **argv)
{
    Explain explain = { .scene = NULL };
    command_parse(&syntax, NULL, argc, argv, &explain);
    Scene scene = { .picture = NULL };
    int code = options_scene(&explain.options, explain.scene, &scene);
    if (!code)
        code = explain_list(&explain, &scene.list);
    scene_free(&scene);
    return code;
}
