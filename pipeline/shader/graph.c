#include "pipeline/base/grow.h"
#include "pipeline/shader/graph_nodes.h"

#include <string.h>

/* Of the shader that runs in this thread. */
static _Thread_local GpGraph *recorded;

/* --- of the vocabulary ------------------------------------------------------------------------ */

/* First component of the declared register that holds a component, or -1. */
static int register_start(const GpGraph *graph, int component)
{
    for (int i = 0, first = 0, components; i < GP_GRAPH_INPUTS; i++, first += components) {
        components = gp_graph_input_components(graph, i);
        if (component < first + components)
            return first;
    }
    return -1;
}

/* Whether a coordinate is an input as it stands. */
static bool is_interpolant(const GpGraph *graph, const GpOperand *coordinate)
{
    const int first = graph->node[coordinate->part[0].node].index;
    if (first != register_start(graph, first))
        return false;
    for (int i = 0; i < coordinate->width; i++) {
        const GpPart part = coordinate->part[i];
        const GpNode *node = &graph->node[part.node];
        if (node->op.kind != GP_NODE_INPUT || part.negated || node->index != first + i)
            return false;
    }
    return true;
}

static int order_of(const GpGraph *graph, const GpNode *node)
{
    int order = 0;
    for (int i = 0; i < node->operands; i++)
        for (int k = 0; k < node->operand[i].width; k++)
            gp_raise(&order, graph->node[node->operand[i].part[k].node].order);
    if (node->op.kind != GP_NODE_TEXTURE || !node->operands)
        return order;
    return is_interpolant(graph, &node->operand[0]) ? 0 : 1 + order;
}

int32_t gp_graph_add(const GpOp *op, GpStepCode code, GpPlace at, const GpOperand *operand,
                     int operands, int index)
{
    GpNode node = { .op = *op, .index = index, .operands = operands, .code = code, .at = at };
    for (int i = 0; i < operands; i++)
        node.operand[i] = operand[i];
    node.order = order_of(recorded, &node);
    const int32_t number = gp_graph_add_node(recorded, &node);
    if (recorded->compute && !recorded->no_memory)
        recorded->compute(recorded, &recorded->node[number]);
    return number;
}

GpPart gp_graph_leaf(GpNodeKind kind, int index)
{
    return gp_graph_find_leaf(recorded, kind, index);
}

/* The sign of a number is a modifier, where nothing is computed. */
GpPart gp_graph_number(const float *value)
{
    const uint32_t bits = gp_float_bits(*value);
    if (recorded->compute) {
        const uintptr_t at = (uintptr_t)value - (uintptr_t)recorded->run->call->uniforms;
        return at < recorded->uniform_bytes ? gp_graph_leaf(GP_NODE_UNIFORM, (int)(at / 4))
                                            : gp_graph_leaf(GP_NODE_NUMBER, (int)bits);
    }
    const uint32_t tag = bits & 0x7fffffff;
    return tag && tag <= recorded->uniform_bytes / 4 ? gp_graph_leaf(GP_NODE_UNIFORM, (int)tag - 1)
                                                     : gp_graph_leaf(GP_NODE_NUMBER, (int)tag);
}

GpNodeKind gp_graph_kind(GpPart part)
{
    return recorded->node[part.node].op.kind;
}

bool gp_graph_may_hold(GpPart mask)
{
    float value[4];
    if (!recorded->compute)
        return true;
    gp_graph_values(recorded, mask, value);
    for (int lane = 0; lane < 4; lane++)
        if (gp_float_bits(value[lane]))
            return true;
    return false;
}

void gp_graph_watch(const char *name, const GpOperand *value)
{
    if (!recorded->compute)
        return;
    GpGraphWatch *list = gp_grown(recorded->watch, (size_t)recorded->watches, &recorded->watch_room,
                                  sizeof *list, &recorded->no_memory);
    if (!list)
        return;
    recorded->watch = list;
    recorded->watch[recorded->watches++] = (GpGraphWatch){ name, *value };
}

bool gp_graph_is_vertex(void)
{
    return recorded->is_vertex;
}

bool gp_graph_is_model2(void)
{
    return gp_graph_has_model2(recorded);
}

bool gp_graph_is_stepping(void)
{
    return recorded->compute != NULL;
}

/* --- of a shader's body ----------------------------------------------------------------------- */

/* Numbers that no shader holds: negative denormals, which count the words from 1 on. */
static const void *tagged_uniforms(GpGraph *graph, size_t bytes)
{
    uint32_t *word = graph->tagged = gp_alloc_unset(bytes + sizeof *word);
    for (uint32_t i = 0; word && i <= bytes / sizeof *word; i++)
        word[i] = 0x80000001u + i;
    return word;
}

/* A program may have none. */
static const void *given_uniforms(const GpGraph *graph)
{
    static const float none;
    return graph->run->call->uniforms ? graph->run->call->uniforms : &none;
}

static void fill(GpPart *part, int parts, GpPart with)
{
    for (int i = 0; i < parts; i++)
        part[i] = with;
}

const void *gp_graph_begin(const GpGraphBody *body)
{
    GpGraph *graph = recorded;
    const GpPart unwritten = gp_graph_leaf(GP_NODE_UNWRITTEN, 0);
    const float one = 1.0f;
    for (int i = 0; i < body->ins; i++)
        body->in[i] = gp_graph_leaf(GP_NODE_INPUT, i);
    fill(body->out, body->outs, unwritten);
    fill(body->position, body->position ? 4 : 0, unwritten);
    *body->single = graph->is_vertex && graph->compute ? gp_graph_number(&one) : unwritten;

    graph->uniform_bytes = body->uniform_bytes;
    const void *uniforms =
        graph->compute ? given_uniforms(graph) : tagged_uniforms(graph, body->uniform_bytes);
    graph->no_memory = graph->no_memory || !uniforms;
    return graph->no_memory ? NULL : uniforms;
}

void gp_graph_name_input(GpSemantic semantic, int first)
{
    recorded->named_inputs[semantic] = (uint8_t)(1 + first);
}

static void add_output(GpGraph *graph, const GpPart *part, int parts, int first)
{
    if (graph->outputs == GP_STEP_OUTPUTS)
        return;
    GpGraphRegister *output = &graph->output[graph->outputs++];
    output->parts = parts;
    output->first = first;
    memcpy(output->part, part, (size_t)parts * sizeof *part);
}

/* Components of the register of the struct that begins at component `first`; 0: none is
 * declared. */
static int register_components(const GpGraph *graph, int first)
{
    const GpVaryingDecl *varying = graph->program->varyings;
    if (!graph->is_vertex)
        return 4;
    for (size_t i = 0; i < GP_COUNT(graph->program->varyings); first -= varying[i++].components)
        if (first == 0)
            return varying[i].components;
    return 0;
}

/* Registers are counted, components stepped. */
void gp_graph_end(const GpGraphBody *body)
{
    GpGraph *graph = recorded;
    const bool single = graph->compute != NULL;
    for (int i = 0; body->position && i < 4; i += single ? 1 : 4)
        add_output(graph, body->position + i, single ? 1 : 4, -1);
    for (int first = 0, parts; first < body->outs; first += parts) {
        parts = single ? 1 : register_components(graph, first);
        if (!parts || first + parts > body->outs)
            break;
        add_output(graph, body->out + first, parts, first);
    }
    add_output(graph, body->single, 1, -1);
}

/* --- of a program ----------------------------------------------------------------------------- */

bool gp_graph_record(GpGraph *graph, void (*shader)(void))
{
    GpGraph *const before = recorded;
    for (int i = 0; i < GP_GRAPH_HASHES; i++)
        graph->leaf[i] = -1;
    recorded = graph;
    gp_graph_leaf(GP_NODE_NUMBER, 0); /* node 0, which zeroed values name */
    if (!graph->no_memory)
        shader();
    recorded = before;
    return !graph->no_memory;
}

void gp_graph_free(GpGraph *graph)
{
    gp_free(graph->tagged);
    gp_free(graph->node);
    gp_free(graph->schedule);
    gp_free(graph->watch);
}

bool gp_graph_missed(void)
{
    const GpEndFn end = gp_called_without_memory();
    if (end)
        end();
    return false;
}
