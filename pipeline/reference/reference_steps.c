/* A shader's instructions, one by one: a quad, or a primitive's vertices, are shaded once more by
 * the counting build, which computes, and what comes out is held against what was drawn with. */
#include "pipeline/base/grow.h"
#include "pipeline/reference/reference_draw.h"
#include "pipeline/units/input_assembly.h"

#include <string.h>

/* What the run told. */
typedef struct Steps {
    GpShaderStep *step;
    GpStepWatch *watch;
    int steps, watches;
    size_t step_room, watch_room;
    GpStepOutput output[GP_STEP_OUTPUTS];
    int outputs;
    bool failed;
} Steps;

static void take_step(void *user, const GpShaderStep *step)
{
    Steps *all = user;
    GpShaderStep *list =
        gp_grown(all->step, (size_t)all->steps, &all->step_room, sizeof *list, &all->failed);
    if (list) {
        all->step = list;
        all->step[all->steps++] = *step;
    }
}

static void take_watch(void *user, const GpStepWatch *watch)
{
    Steps *all = user;
    GpStepWatch *list =
        gp_grown(all->watch, (size_t)all->watches, &all->watch_room, sizeof *list, &all->failed);
    if (list) {
        all->watch = list;
        all->watch[all->watches++] = *watch;
    }
}

static void take_output(void *user, const GpStepOutput *output)
{
    Steps *all = user;
    if (all->outputs < (int)GP_COUNT(all->output))
        all->output[all->outputs++] = *output;
}

static GpStepListener listener_of(Steps *all)
{
    return (GpStepListener){
        .step = take_step, .output = take_output, .watched = take_watch, .user = all
    };
}

static void free_steps(Steps *all)
{
    gp_free(all->step);
    gp_free(all->watch);
}

static GpTraceSteps told(const Steps *all, bool of_vertex, int lane, bool agrees)
{
    return (GpTraceSteps){ .of_vertex = of_vertex,
                           .lane = lane,
                           .step = all->step,
                           .steps = all->steps,
                           .output = all->output,
                           .outputs = all->outputs,
                           .watch = all->watch,
                           .watches = all->watches,
                           .agrees = agrees };
}

static bool same_floats(const float *a, const float *b, int count)
{
    return memcmp(a, b, (size_t)count * sizeof *a) == 0;
}

static bool is_asked(const GpTrace *trace)
{
    return trace && trace->steps && (!trace->wants_steps || trace->wants_steps(trace->user));
}

/* --- pixels ----------------------------------------------------------------------------------- */

/* Whether pixel i of both quads has the same bits. */
static bool agree(const GpProgram *program, const GpQuad *a, const GpQuad *b, int i)
{
    bool same = (a->killed >> i & 1) == (b->killed >> i & 1);
    for (int t = 0; t < gp_program_targets(program); t++)
        for (int c = 0; c < 4; c++)
            same = same && same_floats(&a->color[t][c][i], &b->color[t][c][i], 1);
    return same && (!program->writes_depth || same_floats(&a->depth[i], &b->depth[i], 1));
}

/* Pixels of a quad whose steps are asked for. */
static unsigned wanted_pixels(const GpReferenceDraw *d, const GpQuad *quad)
{
    unsigned wanted = 0;
    for (int i = 0; i < 4 && is_asked(d->reference->trace); i++)
        if ((quad->mask >> i & 1) && gp_trace_wants(d, quad->x + i % 2, quad->y + i / 2))
            wanted |= 1u << i;
    return wanted;
}

void gp_trace_steps(GpReferenceDraw *d, const GpQuad *before, const GpQuad *shaded)
{
    const unsigned wanted = wanted_pixels(d, before);
    if (!wanted)
        return;
    Steps all = { .step = NULL };
    GpQuad again = *before;
    const GpStepListener listener = listener_of(&all);
    again.killed = 0;
    if (gp_step_quad(&d->pixel_stage, &listener, &again) && !all.failed)
        for (int i = 0; i < 4; i++)
            if (wanted >> i & 1) {
                const GpTraceSteps steps =
                    told(&all, false, i, agree(d->draw->program, &again, shaded, i));
                gp_trace_send_steps(d, before->x + i % 2, before->y + i / 2, &steps);
            }
    d->untold = d->untold || all.failed;
    free_steps(&all);
}

/* --- vertices --------------------------------------------------------------------------------- */

static bool same_vertex(const GpProgram *program, const GpVertex *a, const GpVertex *b)
{
    return same_floats(a->clip, b->clip, 4) &&
           same_floats(a->varying, b->varying, program->varying_components) &&
           same_floats(&a->point_size, &b->point_size, 1);
}

void gp_trace_vertex_steps(GpReferenceDraw *d, const GpQuad *quad)
{
    const GpDraw *draw = d->draw;
    const GpProgram *program = draw->program;
    const int corners = (int)gp_primitive_corners(draw->geometry.primitive);
    const bool wanted = quad ? wanted_pixels(d, quad) != 0 : is_asked(d->reference->trace);
    if (d->stepped == d->primitive + 1 || !wanted)
        return;
    d->stepped = d->primitive + 1;
    Steps all = { .step = NULL };
    GpVertex again[3];
    float inputs[3 * GP_MAX_INPUTS];
    for (int i = 0; i < corners; i++)
        gp_fetch_vertex(&draw->geometry, program, d->corner_numbers[i],
                        inputs + i * program->input_components);
    const GpStepListener listener = listener_of(&all);
    if (gp_step_vertices(&d->vertex_stage, inputs, corners, &listener, again) && !all.failed)
        for (int i = 0; i < corners; i++) {
            const GpVertex *drawn = &d->vertices[d->corner_numbers[i] - d->first_vertex];
            const GpTraceSteps steps = told(&all, true, i, same_vertex(program, &again[i], drawn));
            gp_trace_send_steps(d, -1, -1, &steps);
        }
    d->untold = d->untold || all.failed;
    free_steps(&all);
}
