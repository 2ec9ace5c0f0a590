/* glasspipe pixel: the history of one pixel, from the clear to the stored value. */
#include "apps/commands/command.h"
#include "apps/commands/commands.h"
#include "apps/commands/output.h"
#include "apps/inspect/frame_tell.h"
#include "apps/inspect/steps_json.h"
#include "apps/inspect/trace_json.h"
#include "apps/inspect/uniforms.h"
#include "apps/commands/pixel_text.h"
#include "apps/frame/passes.h"

#include <stdio.h>
#include <string.h>

typedef struct Pixel {
    Options options;          /* first: see options.h */
    const char *arguments[3]; /* scene, x, y */
    const char *pass;         /* --pass, or NULL */
    bool steps;
    uint32_t x, y;
} Pixel;

static const SettingField options[] = {
    { "pass", "PASS",
      "Follow the pixel through pass PASS (name or number) only "
      "(default: through all passes of the picture's size)",
      SETTING_TEXT, .offset = offsetof(Pixel, pass) },
    { "steps", NULL, "Tell every instruction of the vertex and pixel shaders too, with its result",
      SETTING_FLAG, .offset = offsetof(Pixel, steps) },
    { .name = NULL },
};

static void read_place(struct argp_state *state, void *args)
{
    Pixel *pixel = args;
    pixel->x = (uint32_t)command_number(state, "X", pixel->arguments[1], 0, INT32_MAX);
    pixel->y = (uint32_t)command_number(state, "Y", pixel->arguments[2], 0, INT32_MAX);
}

static const CommandSyntax syntax = {
    .shared = OPTIONS_FRAME,
    .options = options,
    .arguments = "SCENE.json X Y",
    .help =
        "Examples:\n"
        "  glasspipe pixel scenes/default.json 256 200\n"
        "  glasspipe pixel scenes/default.json 256 200 --json\n"
        "  glasspipe pixel scenes/mrt.json 10 20 --pass 0\n"
        "  glasspipe pixel scenes/mrt.json 10 20 --steps\n"
        "\n"
        "Tells the history of one pixel: the clear, then every fragment that covers it, in "
        "order, with "
        "what each unit of the pipeline saw and decided, and triangles that would cover it, but "
        "were culled or clipped. X counts from the left, Y from the "
        "top, both "
        "from 0.\v"
        "Text shows six digits; --json shows the same, all floats exactly.",
    .offset = offsetof(Pixel, arguments),
    .least = 3,
    .most = 3,
    .expected = "a scene file, X and Y",
    .check = read_place,
};

/* What the trace's callback writes to. */
typedef struct Watch {
    const GpList *list;
    uint32_t width, height; /* of the passes to follow */
    PixelText *text;        /* one of these two */
    json_t *events, *draws; /* draws: of these events, by "pass/draw" */
    StepListings *listings;
} Watch;

/* A draw's uniforms and textures, by name, once. */
static void add_draw(const Watch *watch, const GpTraceEvent *event)
{
    char key[32];
    snprintf(key, sizeof key, "%u/%u", event->pass, event->draw);
    if (event->kind == GP_TRACE_CLEAR || json_object_get(watch->draws, key))
        return;
    const GpDraw *draw = &watch->list->passes[event->pass].draws[event->draw];
    json_object_set_new(watch->draws, key,
                        json_pack("{s:I, s:I, s:o, s:o}", "pass", (json_int_t)event->pass, "draw",
                                  (json_int_t)event->draw, "uniforms", uniforms_tell(draw),
                                  "textures", frame_tell_textures(draw)));
}

/* A pass of another size has no pixel of the same place: a shadow map's (10, 20) is elsewhere. */
static void watch_event(void *user, const GpTraceEvent *event)
{
    const Watch *watch = user;
    uint32_t width, height;
    gp_pass_size(&watch->list->passes[event->pass], &width, &height);
    if (width != watch->width || height != watch->height)
        return;
    if (watch->text)
        pixel_text_event(watch->text, event);
    else {
        json_t *told = trace_json(event);
        if (event->kind == GP_TRACE_STEPS) {
            json_t *steps = steps_json(watch->listings, &event->steps);
            json_object_update(told, steps);
            json_decref(steps);
        }
        json_array_append_new(watch->events, told);
        add_draw(watch, event);
    }
}

/* Runs the list under the trace, and prints. */
static int tell(const Pixel *pixel, const Watch *watch, GpTrace trace)
{
    trace.event = watch_event;
    trace.user = (void *)watch;
    GpDevice *device = NULL;
    int code = options_device(&pixel->options, &trace, &device);
    if (code)
        return code;

    GpError error = { "" };
    if (watch->text)
        printf("Pixel (%u, %u) of %ux%u\n", pixel->x, pixel->y, watch->width, watch->height);
    GpResult result = gp_device_run(device, watch->list, &error);
    if (result)
        code = report(exit_of_run(result), "%s: %s", pixel->arguments[0], error.text);
    else if (watch->text)
        pixel_text_end(watch->text);
    else
        output_json(json_pack("{s:I, s:I, s:I, s:I, s:O, s:O, s:O*}", "x", (json_int_t)pixel->x,
                              "y", (json_int_t)pixel->y, "width", (json_int_t)watch->width,
                              "height", (json_int_t)watch->height, "events", watch->events, "draws",
                              watch->draws, "listings", watch->listings->all));
    gp_device_destroy(&device);
    return code;
}

static int follow(const Pixel *pixel, const Scene *scene)
{
    const GpList *list = &scene->list;
    PixelText text = { .file = stdout, .color = stdout_wants_color(), .list = list };
    StepListings listings = { .all = NULL };
    Watch watch = { .list = list,
                    .listings = &listings,
                    .width = scene->picture->width,
                    .height = scene->picture->height,
                    .text = pixel->options.json ? NULL : &text };
    GpTrace trace = { .one_pixel = true,
                      .only_wanted = true,
                      .missed = true,
                      .steps = pixel->steps,
                      .x = (int32_t)pixel->x,
                      .y = (int32_t)pixel->y };
    if (pixel->pass) {
        trace.one_pass = true;
        trace.pass = passes_find(list, pixel->pass);
        if (trace.pass == list->pass_count)
            return report(EXIT_USAGE,
                          "--pass %s: the scene has no such pass; see glasspipe render "
                          "--list-passes",
                          pixel->pass);
        gp_pass_size(&list->passes[trace.pass], &watch.width, &watch.height);
    }
    if (pixel->x >= watch.width || pixel->y >= watch.height)
        return report(EXIT_USAGE, "pixel (%u, %u) is outside: X is 0 to %u, Y is 0 to %u", pixel->x,
                      pixel->y, watch.width - 1, watch.height - 1);
    watch.events = json_array();
    watch.draws = json_object();
    int code = tell(pixel, &watch, trace);
    step_listings_free(&listings);
    json_decref(watch.events);
    json_decref(watch.draws);
    return code;
}

int cmd_pixel(int argc, char **argv)
{
    Pixel pixel = { .pass = NULL };
    command_parse(&syntax, NULL, argc, argv, &pixel);
    Scene scene = { .picture = NULL };
    int code = options_scene(&pixel.options, pixel.arguments[0], &scene);
    if (!code)
        code = follow(&pixel, &scene);
    scene_free(&scene);
    return code;
}
