#include "pipeline/shader/graph_nodes.h"

#include "pipeline/base/grow.h"

#include <string.h>

bool gp_graph_has_model2(const GpGraph *graph)
{
    const GpProfile p =
        graph->is_vertex ? graph->program->vertex_profile : graph->program->pixel_profile;
    return p == GP_VS_2_0 || p == GP_VS_2_SW || p == GP_PS_2_0 || p == GP_PS_2_A ||
           p == GP_PS_2_B || p == GP_PS_2_SW;
}

_Static_assert(GP_GRAPH_INPUTS >= GP_COUNT(((GpProgram *)0)->inputs) &&
                   GP_GRAPH_INPUTS >= GP_COUNT(((GpProgram *)0)->varyings),
               "all that a program declares");

int gp_graph_input_components(const GpGraph *graph, int i)
{
    const GpProgram *p = graph->program;
    if (graph->is_vertex)
        return i < (int)GP_COUNT(p->inputs) ? p->inputs[i].components : 0;
    return i < (int)GP_COUNT(p->varyings) ? p->varyings[i].components : 0;
}

int32_t gp_graph_add_node(GpGraph *graph, const GpNode *node)
{
    GpNode *list = gp_grown(graph->node, (size_t)graph->nodes, &graph->node_room, sizeof *list,
                            &graph->no_memory);
    if (!list)
        return 0;
    graph->node = list;
    graph->node[graph->nodes] = *node;
    return graph->nodes++;
}

GpPart gp_graph_find_leaf(GpGraph *graph, GpNodeKind kind, int index)
{
    const uint32_t hash = ((uint32_t)index * 0x9e3779b1u >> 26 ^ kind) % GP_GRAPH_HASHES;
    int32_t *newest = &graph->leaf[hash];
    int32_t number = *newest;
    while (number >= 0 &&
           (graph->node[number].op.kind != kind || graph->node[number].index != index))
        number = graph->node[number].next_leaf;
    if (number < 0) {
        const GpNode leaf = { .op.kind = kind, .index = index, .next_leaf = *newest };
        number = gp_graph_add_node(graph, &leaf);
        if (!graph->no_memory)
            *newest = number;
    }
    return (GpPart){ number, 0, false };
}

/* --- what is read ----------------------------------------------------------------------------- */

const GpPart *gp_node_next_read(const GpNode *node, GpReads *at)
{
    for (; at->operand < node->operands; at->operand++, at->component = 0) {
        const GpOperand *operand = &node->operand[at->operand];
        while (at->component < operand->width) {
            const int component = at->component++;
            if (node->op.reads_all || (node->live >> component & 1))
                return &operand->part[component];
        }
    }
    return NULL;
}

/* Operands come before what reads them, so one pass from the end is enough. */
void gp_graph_mark_live(GpGraph *graph)
{
    for (int i = 0; i < graph->outputs; i++)
        for (int k = 0; k < graph->output[i].parts; k++) {
            const GpPart part = graph->output[i].part[k];
            graph->node[part.node].live |= 1u << part.component;
        }
    for (GpNode *node = graph->node + graph->nodes; node-- > graph->node;) {
        if (node->op.kind >= GP_NODE_KILL)
            node->live = 1;
        if (!node->live)
            continue;
        const GpPart *part;
        for (GpReads at = { 0 }; (part = gp_node_next_read(node, &at));)
            graph->node[part->node].live |= 1u << part->component;
    }
}

static bool has_place(const GpGraph *graph, int32_t number)
{
    const GpNode *node = &graph->node[number];
    return !gp_node_is_instruction(node) || node->place >= 0;
}

/* The first instruction that a node reads and that has no place yet, or -1. */
static int32_t awaited(const GpGraph *graph, const GpNode *node)
{
    const GpPart *part;
    for (GpReads at = { 0 }; (part = gp_node_next_read(node, &at));)
        if (!has_place(graph, part->node))
            return part->node;
    return -1;
}

/* Places an instruction after all that it waits for. Those that wait stand at the end of the list,
 * the latest first: chains are as long as shaders' loops make them, too long for calls. */
static void place(GpGraph *graph, int32_t number)
{
    if (has_place(graph, number))
        return;
    int32_t *const end = graph->schedule + graph->nodes, *waiting = end;
    *--waiting = number;
    while (waiting < end) {
        GpNode *node = &graph->node[*waiting];
        const int32_t before = awaited(graph, node);
        if (before >= 0) {
            *--waiting = before;
            continue;
        }
        node->place = graph->scheduled;
        graph->schedule[graph->scheduled++] = *waiting++;
        const GpPart *part;
        for (GpReads at = { 0 }; (part = gp_node_next_read(node, &at));)
            graph->node[part->node].last_use = node->place;
    }
}

bool gp_graph_arrange(GpGraph *graph)
{
    graph->schedule = gp_alloc_unset((size_t)graph->nodes * sizeof *graph->schedule);
    if (!graph->schedule)
        return false;
    for (int32_t i = 0; i < graph->nodes; i++)
        graph->node[i].place = graph->node[i].last_use = -1;
    for (int32_t i = 0; i < graph->nodes; i++)
        if (graph->node[i].op.kind >= GP_NODE_KILL)
            place(graph, i);
    for (int i = 0; i < graph->outputs; i++)
        for (int k = 0; k < graph->output[i].parts; k++)
            place(graph, graph->output[i].part[k].node);
    return true;
}

/* --- values ----------------------------------------------------------------------------------- */

static void repeat(float value, float lanes[4])
{
    for (int lane = 0; lane < 4; lane++)
        lanes[lane] = value;
}

static void positive_values(const GpGraph *graph, GpPart part, float value[4])
{
    const GpNode *node = &graph->node[part.node];
    const GpShaderCall *call = graph->run->call;
    float word;
    switch (node->op.kind) {
    case GP_NODE_NUMBER:
        repeat(gp_bits_float((uint32_t)node->index), value);
        break;
    case GP_NODE_UNIFORM:
        memcpy(&word, (const char *)call->uniforms + 4 * node->index, sizeof word);
        repeat(word, value);
        break;
    case GP_NODE_INPUT:
        memcpy(value, call->in + 4 * node->index, 4 * sizeof *value);
        break;
    case GP_NODE_PIXEL:
        memcpy(value, call->pixel + 4 * node->index, 4 * sizeof *value);
        break;
    case GP_NODE_FACE:
        memcpy(value, call->face, 4 * sizeof *value);
        break;
    case GP_NODE_UNWRITTEN:
        repeat(0, value);
        break;
    default:
        memcpy(value, node->value[part.component], 4 * sizeof *value);
    }
}

void gp_graph_values(const GpGraph *graph, GpPart part, float value[4])
{
    positive_values(graph, part, value);
    for (int lane = 0; lane < 4 && part.negated; lane++)
        value[lane] = gp_bits_float(gp_float_bits(value[lane]) ^ 0x80000000u);
}
