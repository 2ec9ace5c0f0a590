#include "apps/commands/pixel_text.h"

#include "apps/inspect/uniforms.h"

#include <stdarg.h>
#include <string.h>

static const char *const compare_signs[GP_COMPARES] = {
    "(always)", "(never)", "<", "=", "<=", ">", "!=", ">=",
};

/* --- lines ------------------------------------------------------------------------------------ */

/* A piece of a line, to be used within the call that makes it. */
typedef struct Piece {
    char text[96];
} Piece;

static Piece vector(const float *values, int count)
{
    Piece piece;
    int used = 0;
    for (int i = 0; i < count; i++)
        used += snprintf(piece.text + used, sizeof piece.text - (size_t)used, "%s%.6g",
                         i ? ", " : "(", (double)values[i]);
    snprintf(piece.text + used, sizeof piece.text - (size_t)used, ")");
    return piece;
}

static Piece verdict(const PixelText *history, bool passed)
{
    Piece piece;
    const char *word = passed ? "passed" : "failed";
    if (history->color)
        snprintf(piece.text, sizeof piece.text, "\033[%sm%s\033[0m", passed ? "32" : "31", word);
    else
        snprintf(piece.text, sizeof piece.text, "%s", word);
    return piece;
}

/* Starts a line of a fragment's block with its label, or with an empty one to go on with the
 * last. */
static void begin_line(const PixelText *history, const char *label)
{
    fprintf(history->file, "    %-13s", label);
}

/* A whole line. */
static void line(const PixelText *history, const char *label, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void line(const PixelText *history, const char *label, const char *format, ...)
{
    va_list args;
    begin_line(history, label);
    va_start(args, format);
    vfprintf(history->file, format, args);
    va_end(args);
    fputc('\n', history->file);
}

/* "vertex 3" */
static Piece numbered(const char *name, unsigned number)
{
    Piece piece;
    snprintf(piece.text, sizeof piece.text, "%s %u", name, number);
    return piece;
}

static void print_name(FILE *file, const char *name)
{
    if (name && name[0])
        fprintf(file, " \"%s\"", name);
}

static const GpDraw *draw_of(const PixelText *history, const GpTraceEvent *event)
{
    return &history->list->passes[event->pass].draws[event->draw];
}

/* One of a vertex's inputs or varyings on the present line. returns the values behind it */
static const float *print_value(const PixelText *history, bool first, const char *name,
                                const float *values, int components)
{
    fprintf(history->file, "%s%s %s", first ? "" : "  ", name, vector(values, components).text);
    return values + components;
}

static void print_varyings(const PixelText *history, const GpTraceEvent *event, const float *values,
                           int count)
{
    const GpProgram *program = draw_of(history, event)->program;
    const float *end = values + count;
    if (!count)
        return;
    begin_line(history, "");
    for (size_t i = 0; i < GP_COUNT(program->varyings) && values < end; i++)
        values = print_value(history, i == 0, program->varyings[i].name, values,
                             program->varyings[i].components);
    fputc('\n', history->file);
}

/* --- blocks ----------------------------------------------------------------------------------- */

static void close_fragment(PixelText *history)
{
    if (!history->in_fragment)
        return;
    history->in_fragment = false;
    if (history->alive && history->waits)
        return;
    if (history->alive)
        history->stored++;
    else
        history->rejected++;
}

static void open_pass(PixelText *history, const GpTraceEvent *event)
{
    if (history->any_pass && history->pass == event->pass)
        return;
    close_fragment(history);
    history->any_pass = true;
    history->pass = event->pass;
    fprintf(history->file, "\nPass %u", event->pass);
    print_name(history->file, event->pass_name);
    fputc('\n', history->file);
}

/* The numbers of a vector, or of a matrix's row, at the end of a line. */
static void print_numbers(FILE *file, const json_t *row)
{
    size_t i;
    const json_t *value;
    json_array_foreach(row, i, value)
        fprintf(file, "%s%.6g", i ? ", " : "(", json_number_value(value));
    fputs(")\n", file);
}

static void print_uniforms(const PixelText *history, const GpDraw *draw)
{
    json_t *uniforms = uniforms_tell(draw);
    size_t i, row;
    const json_t *one, *values;
    json_array_foreach(uniforms, i, one)
    {
        const json_t *value = json_object_get(one, "value");
        const char *name = json_string_value(json_object_get(one, "name"));
        const bool matrix = json_is_array(json_array_get(value, 0));
        for (row = 0; row < (matrix ? json_array_size(value) : 1); row++) {
            values = matrix ? json_array_get(value, row) : value;
            begin_line(history, i || row ? "" : "uniforms");
            fprintf(history->file, "%s ", row ? "" : name);
            print_numbers(history->file, values);
        }
    }
    json_decref(uniforms);
}

static void open_fragment(PixelText *history, const GpTraceEvent *event)
{
    close_fragment(history);
    history->in_fragment = history->alive = true;
    history->waits = history->list->passes[event->pass].order != GP_ORDER_SUBMITTED;
    bool points = draw_of(history, event)->geometry.primitive == GP_POINTS;
    fprintf(history->file, "\n  Fragment %u: draw %u", ++history->fragments, event->draw);
    print_name(history->file, event->draw_name);
    fprintf(history->file, ", %s %u, program %s\n", points ? "point" : "triangle", event->primitive,
            event->program_name);
    print_uniforms(history, draw_of(history, event));
}

/* A triangle that is not here: its own block. */
static void print_missed(PixelText *history, const GpTraceEvent *event)
{
    const GpTraceMissed *missed = &event->missed;
    const bool facing = strcmp(missed->reason, "facing") == 0;
    close_fragment(history);
    history->missed++;
    fprintf(history->file, "\n  Not here: draw %u", event->draw);
    print_name(history->file, event->draw_name);
    fprintf(history->file, ", triangle %u, program %s\n", event->primitive, event->program_name);
    if (facing)
        line(history, "culled", "it shows its %s; its depth would be %.9g",
             missed->front ? "front (clockwise)" : "back (counter-clockwise)",
             (double)missed->depth);
    else
        line(history, "clipped", "only the %s cuts it away here", missed->reason);
}

/* --- one function a kind ---------------------------------------------------------------------- */

static void print_clear(PixelText *history, const GpTraceEvent *event)
{
    const GpPass *pass = event->clear.pass;
    for (int i = 0; i < GP_MAX_TARGETS; i++) {
        const GpColorTarget *target = &pass->color[i];
        if (target->surface && target->clear)
            fprintf(history->file, "  cleared        target %d, %s, to %s\n", i,
                    gp_format_info(target->surface->format)->name,
                    vector(target->clear_color, 4).text);
    }
    const GpDepthTarget *depth = &pass->depth;
    if (!depth->surface)
        return;
    const char *format = gp_format_info(depth->surface->format)->name;
    if (depth->clear_depth)
        fprintf(history->file, "  cleared        depth, %s, to %.6g\n", format,
                (double)depth->depth_value);
    if (depth->clear_stencil && gp_format_info(depth->surface->format)->has_stencil)
        fprintf(history->file, "  cleared        stencil, %s, to %u\n", format,
                depth->stencil_value);
}

static void print_vertex(PixelText *history, const GpTraceEvent *event)
{
    const GpTraceVertex *vertex = &event->vertex;
    const GpProgram *program = draw_of(history, event)->program;
    const float *inputs = vertex->inputs;
    begin_line(history, numbered("vertex", vertex->vertex).text);
    for (size_t i = 0; i < GP_COUNT(program->inputs) && program->inputs[i].components; i++)
        inputs = print_value(history, i == 0, gp_semantic_names[program->inputs[i].semantic],
                             inputs, program->inputs[i].components);
    fputc('\n', history->file);
    line(history, "  shaded", "clip position %s", vector(vertex->clip, 4).text);
    print_varyings(history, event, vertex->varyings, vertex->varying_components);
}

static void print_clip(PixelText *history, const GpTraceEvent *event)
{
    static const char *const planes[] = { "left", "right", "bottom", "top", "near", "far" };
    const GpTraceClip *clip = &event->clip;
    if (!clip->planes) {
        line(history, "clip", "inside all planes");
        return;
    }
    begin_line(history, "clip");
    fputs("crosses", history->file);
    for (size_t i = 0; i < GP_COUNT(planes); i++)
        if (clip->planes >> i & 1)
            fprintf(history->file, " %s", planes[i]);
    fprintf(history->file, "; %d corners are left\n", clip->corners);
}

static void print_setup(PixelText *history, const GpTraceEvent *event)
{
    const GpTraceSetup *setup = &event->setup;
    begin_line(history, "setup");
    fputs("corners", history->file);
    for (int i = 0; i < 3; i++)
        fprintf(history->file, " (%.8g, %.8g)", setup->x[i] / 256.0, setup->y[i] / 256.0);
    fputs(" in pixels\n", history->file);
    double area = (double)(setup->area2 < 0 ? -setup->area2 : setup->area2) / 131072;
    line(history, "", "depth %s  1/w %s  area %.6g pixels, %s", vector(setup->z, 3).text,
         vector(setup->rw, 3).text, area, setup->area2 > 0 ? "clockwise" : "counter-clockwise");
    if (setup->culled)
        line(history, "", "not drawn: %s", setup->reason);
}

static void print_raster(PixelText *history, const GpTraceEvent *event)
{
    const int64_t *edge = event->raster.edge;
    if (draw_of(history, event)->geometry.primitive == GP_POINTS)
        line(history, "raster", "centre inside the sprite's square");
    else
        line(history, "raster", "centre inside: edge functions %lld %lld %lld, sum %lld, %s",
             (long long)edge[0], (long long)edge[1], (long long)edge[2],
             (long long)(edge[0] + edge[1] + edge[2]),
             event->raster.front ? "front (clockwise)" : "back");
}

static void print_interpolate(PixelText *history, const GpTraceEvent *event)
{
    const GpTraceInterpolate *interpolate = &event->interpolate;
    double depth = (double)interpolate->depth;
    if (draw_of(history, event)->geometry.primitive != GP_POINTS)
        line(history, "interpolate", "shares of the corners %s  depth %.9g",
             vector(interpolate->barycentric, 3).text, depth);
    else
        line(history, "interpolate", "depth %.9g", depth);
    print_varyings(history, event, interpolate->varyings, interpolate->components);
}

static void print_texture(PixelText *history, const GpTraceEvent *event)
{
    const GpTraceTexture *texture = &event->texture;
    const GpSurface *surface = texture->surface;
    const GpSampleReport *report = &texture->report;
    Piece label = numbered("texture", (unsigned)texture->slot);
    if (!surface) {
        line(history, label.text, "no surface is bound: reads (0, 0, 0, 1)");
        return;
    }
    line(history, label.text, "%s %s %ux%u at %s  level of detail %.6g, %s", surface->name,
         gp_format_info(surface->format)->name, surface->width, surface->height,
         vector(texture->coord, 4).text, (double)report->lod,
         report->magnified ? "magnified" : "minified");
    for (int i = 0; i < report->count; i++) {
        const GpTexelUse *texel = &report->texel[i];
        Piece place = { "border" };
        if (texel->x >= 0)
            snprintf(place.text, sizeof place.text, "level %u texel (%d, %d)", texel->level,
                     texel->x, texel->y);
        line(history, "", "%s  weight %.6g  %s", place.text, (double)texel->weight,
             vector(texel->value, 4).text);
    }
    line(history, "  result", "%s", vector(texture->texel, 4).text);
}

/* Every instruction with its result; of masks all bits of a lane are set, or none. */
static void print_steps(PixelText *history, const GpTraceEvent *event)
{
    const GpTraceSteps *steps = &event->steps;
    for (int i = 0; i < steps->steps; i++) {
        const GpShaderStep *step = &steps->step[i];
        const bool is_mask = step->code >= GP_STEP_LESS && step->code <= GP_STEP_NOT;
        const char *said = "";
        Piece numbers;
        if (step->width && is_mask) {
            said = gp_float_bits(step->value[0][steps->lane]) ? "true" : "false";
        } else if (step->width) {
            float value[4];
            for (int c = 0; c < step->width; c++)
                value[c] = step->value[c][steps->lane];
            numbers = vector(value, step->width);
            said = numbers.text;
        }
        line(history,
             i                  ? ""
             : steps->of_vertex ? "vertex steps"
                                : "steps",
             "%3d %-10s %s", i, gp_step_names[step->code], said);
    }
}

static void print_pixel(PixelText *history, const GpTraceEvent *event)
{
    const GpTracePixel *pixel = &event->pixel;
    for (int i = 0; i < pixel->targets; i++)
        line(history, i ? "" : "shader", "target %d %s", i, vector(pixel->color[i], 4).text);
    if (draw_of(history, event)->program->writes_depth)
        line(history, pixel->targets ? "" : "shader", "depth %.9g", (double)pixel->depth);
    if (pixel->killed) {
        history->alive = false;
        line(history, "", "kills the fragment: %s", verdict(history, false).text);
    }
}

/* A fragment's second block: what it waited for. */
static void print_sort(PixelText *history, const GpTraceEvent *event)
{
    const GpTraceSort *sort = &event->sort;
    close_fragment(history);
    history->in_fragment = history->alive = true;
    history->waits = false;
    fprintf(history->file, "\n  Sorted %u of %u, %s: draw %u", sort->place + 1, sort->count,
            gp_order_names[sort->order], event->draw);
    print_name(history->file, event->draw_name);
    fprintf(history->file, ", primitive %u, depth %.9g\n", event->primitive, (double)sort->depth);
}

static void print_test(PixelText *history, const GpTraceEvent *event)
{
    const GpTraceTest *test = &event->test;
    history->alive = history->alive && test->passed;
    begin_line(history, test->unit);
    if (strcmp(test->unit, "depth") == 0)
        fprintf(history->file, "%.9g %s %.9g as codes %u and %u: ", test->incoming,
                compare_signs[test->compare], test->stored, test->incoming_code, test->stored_code);
    else if (strcmp(test->unit, "scissor") != 0 && strcmp(test->unit, "clip plane") != 0)
        fprintf(history->file, "%.6g %s %.6g: ", test->incoming, compare_signs[test->compare],
                test->stored);
    fputs(verdict(history, test->passed).text, history->file);
    if (test->ternary)
        fprintf(history->file, ": %s by epsilon %.9g", gp_trace_ternary(test), test->epsilon);
    if (test->stencil_before >= 0)
        fprintf(history->file, "; stencil %d becomes %d", test->stencil_before,
                test->stencil_after);
    fputc('\n', history->file);
}

static void print_output(PixelText *history, const GpTraceEvent *event)
{
    const GpTraceOutput *output = &event->output;
    const GpBlend *blend = &output->blend;
    bool factors = blend->op >= GP_BLEND_ADD && blend->op <= GP_BLEND_REV_SUBTRACT;
    Piece label = numbered("output", (unsigned)output->target);
    Piece source = vector(output->source, 4), destination = vector(output->destination, 4);
    if (blend->op == GP_BLEND_OFF)
        line(history, label.text, "%s replaces %s", source.text, destination.text);
    else if (factors)
        line(history, label.text, "%s of %s * %s and %s * %s", gp_blend_op_names[blend->op],
             source.text, gp_blend_factor_names[blend->src], destination.text,
             gp_blend_factor_names[blend->dst]);
    else
        line(history, label.text, "%s of %s and %s", gp_blend_op_names[blend->op], source.text,
             destination.text);
    if (blend->alpha_op != GP_BLEND_OFF)
        line(history, "", "alpha by itself: %s, factors %s and %s",
             gp_blend_op_names[blend->alpha_op], gp_blend_factor_names[blend->alpha_src],
             gp_blend_factor_names[blend->alpha_dst]);
    line(history, "  stored", "%s in %s", vector(output->result, 4).text,
         gp_format_info(output->surface->format)->name);
}

void pixel_text_event(PixelText *history, const GpTraceEvent *event)
{
    static void (*const print[GP_TRACE_KINDS])(PixelText *, const GpTraceEvent *) = {
        [GP_TRACE_CLEAR] = print_clear,     [GP_TRACE_VERTEX] = print_vertex,
        [GP_TRACE_CLIP] = print_clip,       [GP_TRACE_SETUP] = print_setup,
        [GP_TRACE_RASTER] = print_raster,   [GP_TRACE_INTERPOLATE] = print_interpolate,
        [GP_TRACE_TEXTURE] = print_texture, [GP_TRACE_PIXEL] = print_pixel,
        [GP_TRACE_SORT] = print_sort,       [GP_TRACE_TEST] = print_test,
        [GP_TRACE_OUTPUT] = print_output,   [GP_TRACE_MISSED] = print_missed,
        [GP_TRACE_STEPS] = print_steps,
    };
    if (!print[event->kind])
        return;
    open_pass(history, event);
    /* A fragment's events begin with the vertices of its primitive. */
    bool first_vertex = event->kind == GP_TRACE_VERTEX && history->last != GP_TRACE_MISSED &&
                        (!history->in_fragment || history->last != GP_TRACE_VERTEX);
    if (first_vertex)
        open_fragment(history, event);
    print[event->kind](history, event);
    if (history->last != GP_TRACE_MISSED || event->kind != GP_TRACE_VERTEX)
        history->last = event->kind;
}

void pixel_text_end(PixelText *history)
{
    close_fragment(history);
    if (!history->any_pass)
        fputs("\nNothing touches this pixel.\n", history->file);
    else
        fprintf(history->file, "\n%u fragment%s: %u stored, %u rejected.\n", history->fragments,
                history->fragments == 1 ? "" : "s", history->stored, history->rejected);
    if (history->missed)
        fprintf(history->file, "%u triangle%s culled or clipped here.\n", history->missed,
                history->missed == 1 ? " was" : "s were");
}
