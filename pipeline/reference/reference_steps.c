/* A pixel shader's instructions, one by one: the quad is shaded once more by the counting build, which
 * computes, and what comes out is held against what was drawn with. */
#include "pipeline/reference/reference_draw.h"

#include <stdlib.h>
#include <string.h>

/* What the run told. */
typedef struct Steps {
    GpShaderStep *step;
    int steps, room;
    GpStepOutput output[4 * GP_MAX_TARGETS + 1];
    int outputs;
    bool failed;
} Steps;

static void take_step(void *user, const GpShaderStep *step)
{
    Steps *all = user;
    if (all->steps == all->room) {
        const int room = all->room ? 2 * all->room : 64;
        GpShaderStep *larger = realloc(all->step, (size_t)room * sizeof *larger);
        if (!larger) {
            all->failed = true;
            return;
        }
        all->step = larger;
        all->room = room;
    }
    all->step[all->steps++] = *step;
}

static void take_output(void *user, const GpStepOutput *output)
{
    Steps *all = user;
    if (all->outputs < (int)GP_COUNT(all->output))
        all->output[all->outputs++] = *output;
}

static bool same_float(float a, float b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* Whether pixel i of both quads has the same bits. */
static bool agree(const GpProgram *program, const GpQuad *a, const GpQuad *b, int i)
{
    bool same = (a->killed >> i & 1) == (b->killed >> i & 1);
    for (int t = 0; t < gp_program_targets(program); t++)
        for (int c = 0; c < 4; c++)
            same = same && same_float(a->color[t][c][i], b->color[t][c][i]);
    return same && (!program->writes_depth || same_float(a->depth[i], b->depth[i]));
}

void gp_trace_steps(GpReferenceDraw *d, const GpQuad *before, const GpQuad *shaded)
{
    const GpTrace *trace = d->reference->trace;
    unsigned wanted = 0;
    for (int i = 0; i < 4 && trace && trace->steps; i++)
        if ((before->mask >> i & 1) && gp_trace_wants(d, before->x + i % 2, before->y + i / 2))
            wanted |= 1u << i;
    if (!wanted)
        return;
    Steps all = { .step = NULL };
    GpQuad again = *before;
    const GpStepListener listener = { take_step, take_output, &all };
    again.killed = 0;
    if (gp_step_quad(&d->pixel_stage, &listener, &again) && !all.failed)
        for (int i = 0; i < 4; i++)
            if (wanted >> i & 1)
                gp_trace_send_steps(d, before->x + i % 2, before->y + i / 2,
                                    &(GpTraceSteps){ i, all.step, all.steps, all.output,
                                                     all.outputs,
                                                     agree(d->draw->program, &again, shaded, i) });
    free(all.step);
}
