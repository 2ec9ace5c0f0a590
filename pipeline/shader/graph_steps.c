/* A graph that is computed: every node has its values in four lanes as soon as it is there, by the
 * instructions' own code (step_values.c). */
#include "pipeline/shader/graph_nodes.h"
#include "pipeline/shader/step_values.h"

#include <string.h>

/* --- values ----------------------------------------------------------------------------------- */

/* As textures.h reads. */
static void read_texture(const GpGraph *graph, GpNode *node, float operand[GP_STEP_OPERANDS][4][4])
{
    const GpShaderCall *call = graph->run->call;
    _Alignas(64) float coord[4][4], gradient[4][4], texel[4][4];
    if (node->code == GP_STEP_LOCAL) {
        call->read_local(call, node->index, 0, 4, texel[0]);
    } else {
        memcpy(coord, operand[0], sizeof coord);
        for (int lane = 0; lane < 4 && node->code == GP_STEP_TEXLDP; lane++) {
            for (int c = 0; c < 3; c++)
                coord[c][lane] = coord[c][lane] / operand[0][3][lane];
            coord[3][lane] = 0;
        }
        for (int c = 0; c < 4; c++)
            memcpy(gradient[c], operand[1 + c / 2][c % 2], sizeof gradient[c]);
        const bool given = node->code == GP_STEP_TEXLDD;
        const GpTextureRead read = {
            node->index, 4, node->op.mode, coord[0], given ? gradient[0] : NULL, texel[0]
        };
        call->read_texture(call, &read);
    }
    memcpy(node->value, texel, sizeof texel);
}

static void kill_lanes(GpGraph *graph, const GpNode *node, float operand[4][4])
{
    const int components = node->operand[0].width < 3 ? node->operand[0].width : 3;
    for (int lane = 0; lane < 4; lane++) {
        if (node->code == GP_STEP_DISCARD)
            graph->killed[lane] |= gp_float_bits(operand[0][lane]) != 0;
        for (int c = 0; c < components && node->code == GP_STEP_TEXKILL; c++)
            graph->killed[lane] |= operand[c][lane] < 0.0f;
    }
}

static void compute(GpGraph *graph, GpNode *node)
{
    float operand[GP_STEP_OPERANDS][4][4] = { { { 0 } } };
    for (int i = 0; i < node->operands; i++)
        for (int c = 0; c < node->operand[i].width; c++)
            gp_graph_values(graph, node->operand[i].part[c], operand[i][c]);
    if (node->op.kind == GP_NODE_TEXTURE)
        read_texture(graph, node, operand);
    else if (node->op.kind == GP_NODE_KILL)
        kill_lanes(graph, node, operand[0]);
    else if (node->op.kind == GP_NODE_ARITHMETIC && graph->software)
        gp_step_value_software(node->code, node->operand[0].width, operand, node->value);
    else if (node->op.kind == GP_NODE_ARITHMETIC)
        gp_step_value(node->code, node->operand[0].width, operand, node->value);
}

/* --- what the shader gives -------------------------------------------------------------------- */

/* Outputs from `first` on go to memory [component][lane]; NULL: nobody wants them. */
static void give(const GpGraph *graph, int first, int outputs, float *memory)
{
    for (int i = 0; memory && i < outputs; i++) {
        const GpPart part = graph->output[first + i].part[0];
        if (graph->node[part.node].op.kind != GP_NODE_UNWRITTEN)
            gp_graph_values(graph, part, memory + 4 * i);
    }
}

static void give_outputs(const GpGraph *graph)
{
    const GpShaderCall *call = graph->run->call;
    const int single = graph->outputs - 1, first = graph->is_vertex ? 4 : 0;
    if (graph->is_vertex)
        give(graph, 0, 4, call->position);
    give(graph, first, single - first, graph->is_vertex ? call->varying : call->color);
    give(graph, single, 1, graph->is_vertex ? call->point_size : call->depth);
    for (int lane = 0; lane < 4 && !graph->is_vertex && call->killed; lane++)
        call->killed[lane] = graph->killed[lane] ? -1 : 0;
}

/* --- what it did ------------------------------------------------------------------------------ */

static GpStepSource source_of(GpNodeKind kind)
{
    switch (kind) {
    case GP_NODE_NUMBER:
        return GP_STEP_NUMBER;
    case GP_NODE_UNIFORM:
        return GP_STEP_UNIFORM;
    case GP_NODE_INPUT:
        return GP_STEP_INPUT;
    case GP_NODE_PIXEL:
        return GP_STEP_PIXEL;
    case GP_NODE_FACE:
        return GP_STEP_FACE;
    case GP_NODE_UNWRITTEN:
        return GP_STEP_UNSET;
    default:
        return GP_STEP_RESULT;
    }
}

static GpStepPart told_part(const GpGraph *graph, GpPart part)
{
    const GpNode *node = &graph->node[part.node];
    GpStepPart told = { .source = source_of(node->op.kind),
                        .index = node->index,
                        .negated = part.negated };
    if (told.source == GP_STEP_RESULT) {
        told.index = node->place;
        told.component = part.component;
    }
    gp_graph_values(graph, part, told.value);
    return told;
}

static GpStepOperand told_operand(const GpGraph *graph, const GpOperand *operand)
{
    GpStepOperand told = { .width = operand->width };
    for (int c = 0; c < operand->width; c++)
        told.part[c] = told_part(graph, operand->part[c]);
    return told;
}

static void tell_step(const GpGraph *graph, const GpNode *node)
{
    GpShaderStep step = { .number = node->place,
                          .code = node->code,
                          .slots = gp_graph_has_model2(graph) ? node->op.slots2 : node->op.slots3,
                          .slot = node->op.kind == GP_NODE_TEXTURE ? node->index : -1,
                          .file = node->at.file,
                          .line = node->at.line,
                          .operands = node->operands };
    for (int i = 0; i < node->operands; i++)
        step.operand[i] = told_operand(graph, &node->operand[i]);
    for (int c = 0; c < 4; c++)
        step.width = node->live >> c & 1 ? c + 1 : step.width;
    memcpy(step.value, node->value, sizeof step.value);
    graph->run->listener->step(graph->run->listener->user, &step);
}

static void tell(const GpGraph *graph)
{
    const GpStepListener *listener = graph->run->listener;
    for (int i = 0; i < graph->scheduled; i++)
        tell_step(graph, &graph->node[graph->schedule[i]]);
    for (int i = 0; i < graph->outputs; i++) {
        const GpStepOutput output = { i, told_part(graph, graph->output[i].part[0]) };
        listener->output(listener->user, &output);
    }
    for (int i = 0; i < graph->watches && listener->watched; i++) {
        const GpStepWatch watch = { graph->watch[i].name,
                                    told_operand(graph, &graph->watch[i].value) };
        listener->watched(listener->user, &watch);
    }
}

bool gp_graph_step(const GpProgram *program, const GpGraphShaders *shaders, bool vertex,
                   const GpStepRun *run)
{
    void (*const shader)(void) = vertex ? shaders->vertex : shaders->pixel;
    GpGraph graph = { .program = program,
                      .is_vertex = vertex,
                      .compute = compute,
                      .run = run,
                      .software = shaders->software };
    bool stepped = !shader || gp_graph_record(&graph, shader);
    if (shader && stepped) {
        give_outputs(&graph);
        gp_graph_mark_live(&graph);
        stepped = gp_graph_arrange(&graph);
        if (stepped)
            tell(&graph);
    }
    gp_graph_free(&graph);
    return stepped || gp_graph_missed();
}
