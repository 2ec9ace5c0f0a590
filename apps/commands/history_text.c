#include "apps/commands/history.h"

#include <stdarg.h>
#include <string.h>

static const char *const compare_signs[GP_COMPARES] = {
    "(always)", "(never)", "<", "=", "<=", ">", "!=", ">=",
};

/* --- pieces of a line
 * ------------------------------------------------------------------------------ */

/* Starts a line of a fragment's block with its label, or without one to go on with the last. */
static void begin_line(const HistoryText *history, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void begin_line(const HistoryText *history, const char *format, ...)
{
    char label[32];
    va_list args;
    va_start(args, format);
    vsnprintf(label, sizeof label, format, args);
    va_end(args);
    fprintf(history->file, "    %-13s", label);
}

static void print_vector(FILE *file, const float *values, int count)
{
    fputc('(', file);
    for (int i = 0; i < count; i++)
        fprintf(file, "%s%.6g", i ? ", " : "", (double)values[i]);
    fputc(')', file);
}

static void print_verdict(const HistoryText *history, bool passed)
{
    const char *word = passed ? "passed" : "failed";
    if (history->color)
        fprintf(history->file, "\033[%sm%s\033[0m", passed ? "32" : "31", word);
    else
        fputs(word, history->file);
}

static void print_name(FILE *file, const char *name)
{
    if (name && name[0])
        fprintf(file, " \"%s\"", name);
}

static const GpDraw *draw_of(const HistoryText *history, const GpTraceEvent *event)
{
    return &history->list->passes[event->pass].draws[event->draw];
}

static void print_varyings(const HistoryText *history, const GpTraceEvent *event,
                           const float *values, int count)
{
    const GpProgram *program = draw_of(history, event)->program;
    for (size_t i = 0; i < GP_COUNT(program->varyings) && count > 0; i++) {
        const GpVaryingDecl *varying = &program->varyings[i];
        if (!varying->components)
            break;
        fprintf(history->file, "%s%s ", i ? "  " : "", varying->name);
        print_vector(history->file, values, varying->components);
        values += varying->components;
        count -= varying->components;
    }
    fputc('\n', history->file);
}

/* --- blocks
 * --------------------------------------------------------------------------------------- */

static void close_fragment(HistoryText *history)
{
    if (!history->in_fragment)
        return;
    history->in_fragment = false;
    if (history->alive)
        history->stored++;
    else
        history->rejected++;
}

static void open_pass(HistoryText *history, const GpTraceEvent *event)
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

static void open_fragment(HistoryText *history, const GpTraceEvent *event)
{
    close_fragment(history);
    history->in_fragment = history->alive = true;
    bool points = draw_of(history, event)->geometry.primitive == GP_POINTS;
    fprintf(history->file, "\n  Fragment %u: draw %u", ++history->fragments, event->draw);
    print_name(history->file, event->draw_name);
    fprintf(history->file, ", %s %u, program %s\n", points ? "point" : "triangle", event->primitive,
            event->program_name);
}

/* --- one function a kind
 * ----------------------------------------------------------------------------- */

static void print_clear(HistoryText *history, const GpTraceEvent *event)
{
    const GpPass *pass = event->clear.pass;
    for (int i = 0; i < GP_MAX_TARGETS; i++) {
        const GpColorTarget *target = &pass->color[i];
        if (!target->surface || !target->clear)
            continue;
        fprintf(history->file, "  cleared        target %d, %s, to ", i,
                gp_format_info(target->surface->format)->name);
        print_vector(history->file, target->clear_color, 4);
        fputc('\n', history->file);
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

static void print_vertex(HistoryText *history, const GpTraceEvent *event)
{
    const GpTraceVertex *vertex = &event->vertex;
    const GpProgram *program = draw_of(history, event)->program;
    const float *inputs = vertex->inputs;
    begin_line(history, "vertex %u", vertex->vertex);
    for (size_t i = 0; i < GP_COUNT(program->inputs) && program->inputs[i].components; i++) {
        fprintf(history->file, "%s%s ", i ? "  " : "",
                gp_semantic_names[program->inputs[i].semantic]);
        print_vector(history->file, inputs, program->inputs[i].components);
        inputs += program->inputs[i].components;
    }
    fputc('\n', history->file);
    begin_line(history, "  shaded");
    fputs("clip position ", history->file);
    print_vector(history->file, vertex->clip, 4);
    fputc('\n', history->file);
    if (vertex->varying_components) {
        begin_line(history, "%s", "");
        print_varyings(history, event, vertex->varyings, vertex->varying_components);
    }
}

static void print_clip(HistoryText *history, const GpTraceEvent *event)
{
    static const char *const planes[] = { "left", "right", "bottom", "top", "near", "far" };
    const GpTraceClip *clip = &event->clip;
    begin_line(history, "clip");
    if (!clip->planes) {
        fputs("inside all planes\n", history->file);
        return;
    }
    fputs("crosses", history->file);
    for (size_t i = 0; i < GP_COUNT(planes); i++)
        if (clip->planes >> i & 1)
            fprintf(history->file, " %s", planes[i]);
    fprintf(history->file, "; %d corners are left\n", clip->corners);
}

static void print_setup(HistoryText *history, const GpTraceEvent *event)
{
    const GpTraceSetup *setup = &event->setup;
    begin_line(history, "setup");
    fputs("corners", history->file);
    for (int i = 0; i < 3; i++)
        fprintf(history->file, " (%.8g, %.8g)", setup->x[i] / 256.0, setup->y[i] / 256.0);
    fprintf(history->file, " in pixels\n");
    begin_line(history, "%s", "");
    fputs("depth ", history->file);
    print_vector(history->file, setup->z, 3);
    fputs("  1/w ", history->file);
    print_vector(history->file, setup->rw, 3);
    double area = (double)(setup->area2 < 0 ? -setup->area2 : setup->area2) / 131072;
    fprintf(history->file, "  area %.6g pixels, %s\n", area,
            setup->area2 > 0 ? "clockwise" : "counter-clockwise");
    if (setup->culled) {
        begin_line(history, "%s", "");
        fprintf(history->file, "not drawn: %s\n", setup->reason);
    }
}

static void print_raster(HistoryText *history, const GpTraceEvent *event)
{
    const int64_t *edge = event->raster.edge;
    begin_line(history, "raster");
    if (draw_of(history, event)->geometry.primitive == GP_POINTS)
        fputs("centre inside the sprite's square\n", history->file);
    else
        fprintf(history->file, "centre inside: edge functions %lld %lld %lld, sum %lld, %s\n",
                (long long)edge[0], (long long)edge[1], (long long)edge[2],
                (long long)(edge[0] + edge[1] + edge[2]),
                event->raster.front ? "front (clockwise)" : "back");
}

static void print_interpolate(HistoryText *history, const GpTraceEvent *event)
{
    const GpTraceInterpolate *interpolate = &event->interpolate;
    begin_line(history, "interpolate");
    if (draw_of(history, event)->geometry.primitive == GP_TRIANGLES) {
        fputs("shares of the corners ", history->file);
        print_vector(history->file, interpolate->barycentric, 3);
        fputs("  ", history->file);
    }
    fprintf(history->file, "depth %.9g\n", (double)interpolate->depth);
    if (interpolate->components) {
        begin_line(history, "%s", "");
        print_varyings(history, event, interpolate->varyings, interpolate->components);
    }
}

static void print_texture(HistoryText *history, const GpTraceEvent *event)
{
    const GpTraceTexture *texture = &event->texture;
    const GpSampleReport *report = &texture->report;
    begin_line(history, "texture %d", texture->slot);
    if (!texture->surface) {
        fputs("no surface is bound: reads (0, 0, 0, 1)\n", history->file);
        return;
    }
    fprintf(history->file, "%s %s %ux%u at ", texture->surface->name,
            gp_format_info(texture->surface->format)->name, texture->surface->width,
            texture->surface->height);
    print_vector(history->file, texture->coord, 4);
    fprintf(history->file, "  level of detail %.6g, %s\n", (double)report->lod,
            report->magnified ? "magnified" : "minified");
    for (int i = 0; i < report->count; i++) {
        const GpTexelUse *texel = &report->texel[i];
        begin_line(history, "%s", "");
        if (texel->x < 0)
            fputs("border", history->file);
        else
            fprintf(history->file, "level %u texel (%d, %d)", texel->level, texel->x, texel->y);
        fprintf(history->file, "  weight %.6g  ", (double)texel->weight);
        print_vector(history->file, texel->value, 4);
        fputc('\n', history->file);
    }
    begin_line(history, "  result");
    print_vector(history->file, texture->texel, 4);
    fputc('\n', history->file);
}

static void print_pixel(HistoryText *history, const GpTraceEvent *event)
{
    const GpTracePixel *pixel = &event->pixel;
    for (int i = 0; i < pixel->targets; i++) {
        begin_line(history, "%s", i ? "" : "shader");
        fprintf(history->file, "target %d ", i);
        print_vector(history->file, pixel->color[i], 4);
        fputc('\n', history->file);
    }
    if (draw_of(history, event)->program->writes_depth) {
        begin_line(history, "%s", pixel->targets ? "" : "shader");
        fprintf(history->file, "depth %.9g\n", (double)pixel->depth);
    }
    if (pixel->killed) {
        history->alive = false;
        begin_line(history, "%s", "");
        fputs("kills the fragment: ", history->file);
        print_verdict(history, false);
        fputc('\n', history->file);
    }
}

static void print_test(HistoryText *history, const GpTraceEvent *event)
{
    const GpTraceTest *test = &event->test;
    history->alive = history->alive && test->passed;
    begin_line(history, "%s", test->unit);
    if (strcmp(test->unit, "depth") == 0)
        fprintf(history->file, "%.9g %s %.9g as codes %u and %u: ", test->incoming,
                compare_signs[test->compare], test->stored, test->incoming_code, test->stored_code);
    else if (strcmp(test->unit, "scissor") != 0 && strcmp(test->unit, "clip plane") != 0)
        fprintf(history->file, "%.6g %s %.6g: ", test->incoming, compare_signs[test->compare],
                test->stored);
    print_verdict(history, test->passed);
    if (test->stencil_before >= 0)
        fprintf(history->file, "; stencil %d becomes %d", test->stencil_before,
                test->stencil_after);
    fputc('\n', history->file);
}

static void print_term(FILE *file, const float *value, GpBlendFactor factor)
{
    print_vector(file, value, 4);
    fprintf(file, " * %s", gp_blend_factor_names[factor]);
}

static void print_output(HistoryText *history, const GpTraceEvent *event)
{
    const GpTraceOutput *output = &event->output;
    const GpBlend *blend = &output->blend;
    bool factors = blend->op >= GP_BLEND_ADD && blend->op <= GP_BLEND_REV_SUBTRACT;
    begin_line(history, "output %d", output->target);
    if (blend->op == GP_BLEND_OFF) {
        print_vector(history->file, output->source, 4);
        fputs(" replaces ", history->file);
        print_vector(history->file, output->destination, 4);
    } else {
        fprintf(history->file, "%s of ", gp_blend_op_names[blend->op]);
        if (factors)
            print_term(history->file, output->source, blend->src);
        else
            print_vector(history->file, output->source, 4);
        fputs(" and ", history->file);
        if (factors)
            print_term(history->file, output->destination, blend->dst);
        else
            print_vector(history->file, output->destination, 4);
    }
    fputc('\n', history->file);
    if (blend->alpha_op != GP_BLEND_OFF) {
        begin_line(history, "%s", "");
        fprintf(history->file, "alpha by itself: %s, factors %s and %s\n",
                gp_blend_op_names[blend->alpha_op], gp_blend_factor_names[blend->alpha_src],
                gp_blend_factor_names[blend->alpha_dst]);
    }
    begin_line(history, "  stored");
    print_vector(history->file, output->result, 4);
    fprintf(history->file, " in %s\n", gp_format_info(output->surface->format)->name);
}

void history_text_event(HistoryText *history, const GpTraceEvent *event)
{
    static void (*const print[GP_TRACE_KINDS])(HistoryText *, const GpTraceEvent *) = {
        [GP_TRACE_CLEAR] = print_clear,     [GP_TRACE_VERTEX] = print_vertex,
        [GP_TRACE_CLIP] = print_clip,       [GP_TRACE_SETUP] = print_setup,
        [GP_TRACE_RASTER] = print_raster,   [GP_TRACE_INTERPOLATE] = print_interpolate,
        [GP_TRACE_TEXTURE] = print_texture, [GP_TRACE_PIXEL] = print_pixel,
        [GP_TRACE_TEST] = print_test,       [GP_TRACE_OUTPUT] = print_output,
    };
    open_pass(history, event);
    /* A fragment's events begin with the vertices of its primitive. */
    bool first_vertex = event->kind == GP_TRACE_VERTEX &&
                        (!history->in_fragment || history->last != GP_TRACE_VERTEX);
    if (first_vertex)
        open_fragment(history, event);
    print[event->kind](history, event);
    history->last = event->kind;
}

void history_text_end(HistoryText *history)
{
    close_fragment(history);
    if (!history->any_pass)
        fputs("\nNothing touches this pixel.\n", history->file);
    else
        fprintf(history->file, "\n%u fragment%s: %u stored, %u rejected.\n", history->fragments,
                history->fragments == 1 ? "" : "s", history->stored, history->rejected);
}
