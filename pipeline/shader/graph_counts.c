/* The figures of a shader, read off its instruction graph.
 *
 * What reaches no output and kills no pixel is dead and is not counted: Direct3D's compilers
 * removed it. The rest is priced and read as follows.
 *
 * Slots: the table of CONVENTIONS.md, "Profiles". What no single instruction does costs what its
 * shortest sequence does: a / b is rcp and mul, 1 / b rcp, sqrt_ rsq and rcp, floor_ frc and sub,
 * dp2 a dp2add. Every instruction has its price in both kinds of shader, though Direct3D gave lit,
 * dst, sgn, slt and sge to vertex shaders only and dp2add to pixel shaders only. Swizzles, packing
 * (rgba, vec3, xyz) and negation are free. sat is free as _sat of an instruction that computes its
 * operand, 1 on an input, a uniform or a texel, and 2 (min, max) in a vertex shader below model 3,
 * which has no _sat. abs_ costs 1. mul and add are two slots unless written as mad: nothing is
 * fused, folded or merged. A comparison is free against the number 0 and 1 otherwise (sub); == and
 * != take 1 more (mul), and so does each & | ^ ~ of masks; sel is the cmp that follows; discard is
 * a texkill.
 *
 * Moves: an output register takes a mov where some component of it is an input, a constant, a
 * texel, negated, or computed by an instruction that something else reads too. In ps_2_x every
 * target and oDepth takes one: nothing but mov may write them.
 *
 * Temporaries: an estimate. The live instructions are put in an order that depends on the graph
 * alone (texkills, then outputs, each after its operands from left to right), since the order in
 * which C++ evaluates arguments is the compiler's choice. A result lives from its instruction to
 * the last one that reads it, where its register may be written again; a texel takes a whole
 * register, other results as many components as are read. At each instruction the living results
 * are packed four components a register without splitting any; the largest number of registers is
 * reported. Registers that a macro instruction needs inside are not included.
 *
 * Constants: the floats of the uniform struct that are read, four a register, plus the distinct
 * numbers (apart from sign, which is a free modifier), four a register. A loader that may pack
 * registers as it likes needs that many. Uniforms are recognised by value: the struct is filled
 * with distinct denormals. Arithmetic on them in plain C is done before the draw, as effect files
 * did it, and counts as a number.
 *
 * Dependent reads: a read whose coordinate is an interpolant as it stands (its components in order
 * from the first) has order 0. Any other coordinate is computed: order 1 if no texel went into it,
 * else 1 + the highest order of those that did. Reads of the pixel's own position (gp_load_local)
 * have order 0: a texld by an interpolant made for them, which counts as one input.
 */
#include "pipeline/shader/graph_nodes.h"

/* --- moves ------------------------------------------------------------------------------------ */

/* Each instruction, and each output register, is one reader. */
static void count_reader(GpNode *node, int32_t reader)
{
    node->readers += node->reader != reader;
    node->reader = reader;
}

static void count_readers(GpGraph *graph)
{
    int32_t reader = 0;
    for (int32_t i = 0; i < graph->nodes; i++) {
        const GpPart *part;
        reader++;
        for (GpReads at = { 0 };
             graph->node[i].live && (part = gp_node_next_read(&graph->node[i], &at));)
            count_reader(&graph->node[part->node], reader);
    }
    for (int i = 0; i < graph->outputs; i++) {
        reader++;
        for (int k = 0; k < graph->output[i].parts; k++)
            count_reader(&graph->node[graph->output[i].part[k].node], reader);
    }
}

static bool is_moved(const GpGraph *graph, const GpGraphRegister *output)
{
    bool moved = output->parts && gp_graph_has_model2(graph) && !graph->is_vertex;
    for (int k = 0; k < output->parts; k++) {
        const GpNode *node = &graph->node[output->part[k].node];
        moved = moved || node->op.kind != GP_NODE_ARITHMETIC || output->part[k].negated ||
                node->readers > 1;
    }
    return moved;
}

/* Puts a mov in front of each output register that needs one. */
static void add_moves(GpGraph *graph)
{
    static const GpOp mov = {
        .slots2 = 1, .slots3 = 1, .reads_all = true, .kind = GP_NODE_ARITHMETIC
    };
    count_readers(graph);
    for (int i = 0; i < graph->outputs; i++) {
        GpGraphRegister *output = &graph->output[i];
        if (!is_moved(graph, output))
            continue;
        GpNode node = { .op = mov, .operands = 1, .live = 1 };
        node.operand[0].width = output->parts;
        for (int k = 0; k < output->parts; k++)
            node.operand[0].part[k] = output->part[k];
        output->part[0] = (GpPart){ gp_graph_add_node(graph, &node), 0, false };
        output->parts = 1;
    }
}

/* --- temporaries ------------------------------------------------------------------------------ */

/* Four components a register: ones fill up threes, and share registers with twos. */
static int registers_for(const int of_width[5])
{
    const int ones = of_width[1] > of_width[3] ? of_width[1] - of_width[3] : 0;
    return of_width[4] + of_width[3] + (2 * of_width[2] + ones + 3) / 4;
}

static int most_registers(const GpGraph *graph)
{
    int most = 0;
    for (int now = 0; now < graph->scheduled; now++) {
        int of_width[5] = { 0 };
        for (int earlier = 0; earlier <= now; earlier++) {
            const GpNode *node = &graph->node[graph->schedule[earlier]];
            if (node->last_use > now)
                of_width[node->op.kind == GP_NODE_TEXTURE ? 4 : __builtin_popcount(node->live)]++;
        }
        gp_raise(&most, registers_for(of_width));
    }
    return most;
}

/* --- figures ---------------------------------------------------------------------------------- */

static void drop_unwritten(GpGraph *graph, GpShaderCounts *counts)
{
    for (int i = 0; i < graph->outputs; i++) {
        GpGraphRegister *output = &graph->output[i];
        int written = 0;
        for (int k = 0; k < output->parts; k++) {
            if (graph->node[output->part[k].node].op.kind == GP_NODE_UNWRITTEN)
                continue;
            output->part[written++] = output->part[k];
            if (output->first >= 0)
                counts->outputs_written |= (uint64_t)1 << (output->first + k);
        }
        output->parts = written;
        counts->outputs += output->first >= 0 && written;
    }
}

/* Slots that do not exist are left to the trial, which refuses them. */
static void read_instruction(const GpGraph *graph, const GpNode *node, GpShaderCounts *counts)
{
    const bool reads = node->op.kind == GP_NODE_TEXTURE || node->op.kind == GP_NODE_KILL;
    *(reads ? &counts->texture_slots : &counts->arithmetic_slots) +=
        gp_graph_has_model2(graph) ? node->op.slots2 : node->op.slots3;
    counts->loops |= node->op.kind == GP_NODE_LOOP;
    counts->gradients |= node->op.gradient;
    counts->needs_quads |= node->op.gradient && node->op.kind == GP_NODE_ARITHMETIC;
    counts->discards |= node->op.kind == GP_NODE_KILL;
    if (node->op.kind != GP_NODE_TEXTURE)
        return;
    if (!node->operands) {
        counts->local_slots |= gp_slot_bit(node->index);
        return;
    }
    counts->sampler_slots |= gp_slot_bit(node->index);
    counts->implicit_lod |= node->op.mode == GP_LOD_IMPLICIT || node->op.mode == GP_LOD_BIAS;
    counts->explicit_lod |= node->op.mode == GP_LOD_EXPLICIT;
    gp_raise(&counts->dependent_reads, node->order);
}

/* Whether a declared register of so many components from `first` on is read, by one of them. */
static bool is_register_read(uint64_t read, int first, int components)
{
    return first < 64 && (read >> first & (((uint64_t)1 << components) - 1)) != 0;
}

static int inputs_read(const GpGraph *graph, uint64_t read)
{
    int inputs = 0;
    for (int i = 0, first = 0, components; i < GP_GRAPH_INPUTS; i++, first += components) {
        components = gp_graph_input_components(graph, i);
        inputs += is_register_read(read, first, components);
    }
    return inputs;
}

static void read_graph(const GpGraph *graph, GpShaderCounts *counts)
{
    int uniforms = 0, numbers = 0;
    for (const GpNode *node = graph->node; node < graph->node + graph->nodes; node++) {
        if (!node->live)
            continue;
        uniforms += node->op.kind == GP_NODE_UNIFORM;
        numbers += node->op.kind == GP_NODE_NUMBER;
        counts->reads_pixel |= node->op.kind == GP_NODE_PIXEL;
        counts->reads_face |= node->op.kind == GP_NODE_FACE;
        if (node->op.kind == GP_NODE_INPUT && node->index < 64)
            counts->inputs_read |= (uint64_t)1 << node->index;
        if (gp_node_is_instruction(node))
            read_instruction(graph, node, counts);
    }
    counts->slots = counts->arithmetic_slots + counts->texture_slots;
    counts->constants = (uniforms + 3) / 4 + (numbers + 3) / 4;
    counts->samplers = __builtin_popcount(counts->sampler_slots | counts->local_slots);
    counts->inputs = inputs_read(graph, counts->inputs_read) + (counts->local_slots != 0);
    for (int i = 0; i < GP_SEMANTICS; i++)
        counts->named_inputs[i] = graph->named_inputs[i];
}

/* The slot, from 1 on, whose texel is what a pixel shader's one target holds; or 0. */
static int copied_slot(const GpGraph *graph)
{
    const GpGraphRegister *color = &graph->output[0];
    if (graph->outputs != 2 || color->parts != 4)
        return 0;
    const GpNode *texel = &graph->node[color->part[0].node];
    bool is_copy = texel->op.kind == GP_NODE_TEXTURE && !texel->operands;
    for (int k = 0; k < 4; k++)
        is_copy = is_copy && color->part[k].node == color->part[0].node &&
                  color->part[k].component == k && !color->part[k].negated;
    return is_copy ? 1 + texel->index : 0;
}

static bool count_graph(GpGraph *graph, GpShaderCounts *counts)
{
    const int copied = graph->is_vertex ? 0 : copied_slot(graph);
    drop_unwritten(graph, counts);
    const bool writes_single = graph->output[graph->outputs - 1].parts;
    gp_graph_mark_live(graph);
    add_moves(graph);
    if (graph->no_memory || !gp_graph_arrange(graph))
        return false;
    counts->temporaries = most_registers(graph);
    read_graph(graph, counts);
    counts->writes_point_size = graph->is_vertex && writes_single;
    counts->writes_depth = !graph->is_vertex && writes_single;
    counts->copied_slot = counts->writes_depth || counts->discards ? 0 : copied;
    return true;
}

/* Counts nothing where there is no shader. */
static bool count_shader(const GpProgram *program, bool is_vertex, void (*shader)(void),
                         GpShaderCounts *counts)
{
    GpGraph graph = { .program = program, .is_vertex = is_vertex };
    *counts = (GpShaderCounts){ 0 };
    const bool counted =
        !shader || (gp_graph_record(&graph, shader) && count_graph(&graph, counts));
    gp_graph_free(&graph);
    return counted || gp_graph_missed();
}

bool gp_graph_count(const GpProgram *program, const GpGraphShaders *shaders, GpShaderCounts *vertex,
                    GpShaderCounts *pixel)
{
    return (!vertex || count_shader(program, true, shaders->vertex, vertex)) &&
           (!pixel || count_shader(program, false, shaders->pixel, pixel));
}
