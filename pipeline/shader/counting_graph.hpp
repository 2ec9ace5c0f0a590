/* The instruction graph that the counting build of a shader records, and the figures read off it.
 *
 * Every operation of the vocabulary (pipeline/shader/counting.hpp) adds one node: an instruction with its
 * operands, or a leaf: a number, a uniform, an input. Nothing is computed, unless the shader is run step by
 * step (counting_steps.hpp). What reaches no output
 * and kills no pixel is dead and is not counted: Direct3D's compilers removed it. The rest is
 * priced and read as follows.
 *
 * Slots: the table of CONVENTIONS.md, "Profiles". What no single instruction does costs what its shortest sequence
 * does: a / b is rcp and mul, 1 / b rcp, sqrt_ rsq and rcp, floor_ frc and sub, dp2 a dp2add. Every
 * instruction has its price in both kinds of shader, though Direct3D gave lit, dst, sgn, slt and
 * sge to vertex shaders only and dp2add to pixel shaders only. Swizzles, packing (rgba, vec3, xyz)
 * and negation are free. sat is free as _sat of an instruction that computes its operand, 1 on an
 * input, a uniform or a texel, and 2 (min, max) in a vertex shader below model 3, which has no _sat.
 * abs_ costs 1. mul and add are two slots unless written as mad: nothing is fused, folded or merged.
 * A comparison is free against the number 0 and 1 otherwise (sub); == and != take 1 more (mul), and
 * so does each & | ^ ~ of masks; sel is the cmp that follows; discard is a texkill.
 *
 * Moves: an output register takes a mov where some component of it is an input, a constant, a texel,
 * negated, or computed by an instruction that something else reads too. In ps_2_x every target and
 * oDepth takes one: nothing but mov may write them.
 *
 * Temporaries: an estimate. The live instructions are put in an order that depends on the graph
 * alone (texkills, then outputs, each after its operands from left to right), since the order in
 * which C++ evaluates arguments is the compiler's choice. A result lives from its instruction to the
 * last one that reads it, where its register may be written again; a texel takes a whole register,
 * other results as many components as are read. At each instruction the living results are packed
 * four components a register without splitting any; the largest number of registers is reported.
 * Registers that a macro instruction needs inside are not included.
 *
 * Constants: the floats of the uniform struct that are read, four a register, plus the distinct
 * numbers (apart from sign, which is a free modifier), four a register. A loader that may pack
 * registers as it likes needs that many. Uniforms are recognised by value: the struct is filled with
 * distinct denormals. Arithmetic on them in plain C is done before the draw, as effect files did it,
 * and counts as a number.
 *
 * Dependent reads: a read whose coordinate is an interpolant as it stands (its components in order
 * from the first) has order 0. Any other coordinate is computed: order 1 if no texel went into it,
 * else 1 + the highest order of those that did. Reads of the pixel's own position (gp_load_local)
 * have order 0: a texld by an interpolant made for them, which counts as one input.
 */
#ifndef GP_COUNTING_GRAPH_HPP
#define GP_COUNTING_GRAPH_HPP

#include "pipeline/shader/counts.h"
#include "pipeline/shader/steps.h"

#include <array>
#include <cstring>
#include <map>
#include <set>
#include <utility>
#include <vector>

/* Shader files name their structs as they like, each its own `Varying`; internal linkage keeps what
 * is instantiated for one file from being merged with another file's. */
namespace
{

/* One component of a node. Trivial, and all zero the number 0, as `float3 sum = { 0 }` is in C. */
struct flt {
    int32_t node;
    uint8_t component;
    bool negated;
};

template <class Value> constexpr int width_of = int(sizeof(Value) / sizeof(flt));

/* A value of one to four components, as an operand. */
struct Operand {
    std::array<flt, 4> part;
    int width;

    template <class Value> Operand(const Value &value) : part{}, width(width_of<Value>)
    {
        static_assert(sizeof(Value) % sizeof(flt) == 0 && sizeof(Value) <= sizeof part);
        std::memcpy(part.data(), &value, sizeof value);
    }
};

enum class Kind : uint8_t {
    number,
    unwritten,
    uniform,
    input,
    pixel,
    face,
    arithmetic,
    texture,
    kill,
    loop
};

/* What an instruction is: its slots in shader models 2 and 3, and whether component i of the result
 * needs component i of each operand or all of them. */
struct Op {
    int model2, model3;
    enum Reads : uint8_t { each, all } reads;
    Kind kind = Kind::arithmetic;
    bool gradient = false; /* dsx, dsy, texldd */
    GpLodMode mode = GP_LOD_IMPLICIT;
};

/* Where an instruction stands in the shader's text. */
struct GpPlace {
    const char *file;
    int line;

    static constexpr GpPlace here(const char *of = __builtin_FILE(), int at = __builtin_LINE())
    {
        return { of, at };
    }
};

struct Node {
    Kind kind;
    Op op;
    int index; /* bits of a number, word of a uniform, component, texture slot */
    std::vector<Operand> operands; /* of instructions */
    GpStepCode code = GP_STEP_CODES;
    GpPlace written = {};
    int order = 0;                 /* the highest order of the texture reads that went into it */
    unsigned live = 0;             /* bit i: component i reaches an output */
    int place = -1, last_use = -1; /* in the schedule */
};

/* An output register: up to four components and their place in the output struct. */
struct Register {
    std::vector<flt> parts;
    int first; /* -1: not part of the struct (position, point size, depth) */
};

class Recorder
{
  public:
    enum Stage { vertex, pixel };

    Recorder(const GpProgram &declaration, Stage which, size_t uniform_bytes)
        : declared(declaration), stage(which), uniform_words(uint32_t(uniform_bytes / 4))
    {
        leaf(Kind::number, 0); /* node 0, which zeroed values name */
    }

    virtual ~Recorder() = default;

    bool is_vertex() const
    {
        return stage == vertex;
    }
    /* Whether values are computed too, and a mask is true in any lane: unknown, so that it may be. */
    virtual bool is_stepping() const
    {
        return false;
    }
    virtual bool holds_anywhere(flt) const
    {
        return true;
    }
    /* The shader names a value. */
    virtual void watch_value(const char *, const Operand &)
    {
    }
    bool model2() const
    {
        GpProfile p = is_vertex() ? declared.vertex_profile : declared.pixel_profile;
        return p == GP_VS_2_0 || p == GP_VS_2_SW || p == GP_PS_2_0 || p == GP_PS_2_A ||
               p == GP_PS_2_B || p == GP_PS_2_SW;
    }
    Kind kind_of(flt a) const
    {
        return nodes[size_t(a.node)].kind;
    }

    /* The one node of a leaf. */
    flt leaf(Kind kind, int index)
    {
        auto [found, added] = leaves.try_emplace({ kind, index }, int32_t(nodes.size()));
        if (added)
            nodes.push_back({ kind, {}, index, {} });
        return { found->second, 0, false };
    }

    /* A C number: the tag of a uniform, or a number proper; the sign is a modifier. */
    virtual flt number(const float &value)
    {
        uint32_t bits = gp_float_bits(value) & 0x7fffffff;
        bool tagged = bits >= 1 && bits <= uniform_words;
        return tagged ? leaf(Kind::uniform, int(bits - 1)) : leaf(Kind::number, int(bits));
    }

    static void tag_uniforms(void *uniforms, size_t bytes)
    {
        for (uint32_t word = 0; word < bytes / 4; word++) {
            uint32_t tag = 0x80000001 + word;
            std::memcpy(static_cast<char *>(uniforms) + 4 * word, &tag, 4);
        }
    }

    int32_t record(const Op &op, GpStepCode code, GpPlace at, std::vector<Operand> operands,
                   int index = 0)
    {
        Node node = { op.kind, op, index, std::move(operands), code, at };
        for (const Operand &operand : node.operands)
            for (int i = 0; i < operand.width; i++)
                raise(node.order, nodes[size_t(operand.part[size_t(i)].node)].order);
        if (op.kind == Kind::texture && !node.operands.empty()) /* the first is the coordinate */
            node.order = is_interpolant(node.operands[0]) ? 0 : 1 + node.order;
        nodes.push_back(std::move(node));
        compute(nodes.back());
        return int32_t(nodes.size()) - 1;
    }

    /* Ends the recording. in: what each output register holds; nodes of Kind::unwritten are not
     * written. */
    GpShaderCounts finish(std::vector<Register> outputs)
    {
        GpShaderCounts counts = {};
        drop_unwritten(outputs, &counts);
        mark_live(outputs);
        add_moves(outputs);
        arrange(outputs);
        counts.temporaries = most_registers();
        read_graph(&counts);
        return counts;
    }

    /* GpShaderCounts.copied_slot of a pixel shader whose targets hold this. */
    int copied_slot(const std::vector<flt> &targets) const
    {
        if (targets.size() != 4)
            return 0;
        const Node &texel = nodes[size_t(targets[0].node)];
        bool is_copy = texel.kind == Kind::texture && texel.operands.empty();
        for (size_t i = 0; i < targets.size(); i++)
            is_copy = is_copy && targets[i].node == targets[0].node && targets[i].component == i &&
                      !targets[i].negated;
        return is_copy ? 1 + texel.index : 0;
    }

    /* Registers of the declared varyings (or inputs), cut out of all their components. */
    template <class Declaration>
    static std::vector<Register> split(const std::vector<flt> &parts, const Declaration &list)
    {
        std::vector<Register> registers;
        size_t first = 0;
        for (const auto &entry : list) {
            size_t end = first + entry.components;
            if (end == first || end > parts.size())
                break;
            registers.push_back(
                { { parts.begin() + long(first), parts.begin() + long(end) }, int(first) });
            first = end;
        }
        return registers;
    }

  protected:
    /* A node has been added. */
    virtual void compute(const Node &)
    {
    }

    static void raise(int &most, int value)
    {
        most = value > most ? value : most;
    }

    static bool is_instruction(const Node &node)
    {
        return node.kind >= Kind::arithmetic;
    }

    /* First component of the declared register that holds a component, or -1. */
    template <class Declaration> static int register_start(const Declaration &list, int component)
    {
        int first = 0;
        for (const auto &entry : list) {
            if (component < first + entry.components)
                return first;
            first += entry.components;
        }
        return -1;
    }

    bool is_interpolant(const Operand &coordinate) const
    {
        int first = nodes[size_t(coordinate.part[0].node)].index;
        int start = is_vertex() ? register_start(declared.inputs, first)
                                : register_start(declared.varyings, first);
        if (first != start)
            return false;
        for (int i = 0; i < coordinate.width; i++) {
            const flt &part = coordinate.part[size_t(i)];
            const Node &node = nodes[size_t(part.node)];
            if (node.kind != Kind::input || part.negated || node.index != first + i)
                return false;
        }
        return true;
    }

    /* Calls visit(part) for each operand component that the live components of a node read. */
    template <class Visit> void each_read(const Node &node, Visit visit)
    {
        for (const Operand &operand : node.operands)
            for (int i = 0; i < operand.width; i++)
                if (node.op.reads == Op::all || (node.live >> i & 1))
                    visit(operand.part[size_t(i)]);
    }

    void drop_unwritten(std::vector<Register> &outputs, GpShaderCounts *counts)
    {
        for (Register &output : outputs) {
            std::vector<flt> written;
            for (size_t i = 0; i < output.parts.size(); i++) {
                if (kind_of(output.parts[i]) == Kind::unwritten)
                    continue;
                written.push_back(output.parts[i]);
                if (output.first >= 0)
                    counts->outputs_written |= uint64_t(1) << (output.first + int(i));
            }
            output.parts = written;
            counts->outputs += output.first >= 0 && !written.empty();
        }
    }

    /* Operands come before what reads them, so one pass from the end is enough. */
    void mark_live(const std::vector<Register> &outputs)
    {
        for (const Register &output : outputs)
            for (const flt &part : output.parts)
                nodes[size_t(part.node)].live |= 1u << part.component;
        for (size_t i = nodes.size(); i-- > 0;) {
            if (nodes[i].kind >= Kind::kill)
                nodes[i].live = 1;
            if (nodes[i].live)
                each_read(nodes[i], [this](const flt &part) {
                    nodes[size_t(part.node)].live |= 1u << part.component;
                });
        }
    }

    /* Instructions and output registers that read each node. */
    std::vector<int> count_readers(const std::vector<Register> &outputs)
    {
        std::vector<int> readers(nodes.size());
        auto count = [&readers](const std::set<int32_t> &read) {
            for (int32_t node : read)
                readers[size_t(node)]++;
        };
        for (const Node &node : nodes) {
            std::set<int32_t> read;
            if (node.live)
                each_read(node, [&read](const flt &part) { read.insert(part.node); });
            count(read);
        }
        for (const Register &output : outputs) {
            std::set<int32_t> read;
            for (const flt &part : output.parts)
                read.insert(part.node);
            count(read);
        }
        return readers;
    }

    /* Puts a mov in front of each output register that needs one. */
    void add_moves(std::vector<Register> &outputs)
    {
        static constexpr Op mov = { 1, 1, Op::all };
        std::vector<int> readers = count_readers(outputs);
        for (Register &output : outputs) {
            if (output.parts.empty())
                continue;
            bool moved = model2() && !is_vertex();
            for (const flt &part : output.parts)
                moved = moved || kind_of(part) != Kind::arithmetic || part.negated ||
                        readers[size_t(part.node)] > 1;
            if (!moved)
                continue;
            Operand whole(flt{});
            whole.width = int(output.parts.size());
            std::copy(output.parts.begin(), output.parts.end(), whole.part.begin());
            output.parts = { flt{ record(mov, GP_STEP_CODES, {}, { whole }), 0, false } };
            nodes.back().live = 1;
        }
    }

    void place(int32_t number)
    {
        if (!is_instruction(nodes[size_t(number)]) || nodes[size_t(number)].place >= 0)
            return;
        each_read(nodes[size_t(number)], [this](const flt &part) { place(part.node); });
        Node &node = nodes[size_t(number)];
        node.place = int(schedule.size());
        schedule.push_back(number);
        each_read(node, [this, &node](const flt &part) {
            nodes[size_t(part.node)].last_use = node.place;
        });
    }

    void arrange(const std::vector<Register> &outputs)
    {
        for (size_t i = 0; i < nodes.size(); i++)
            if (nodes[i].kind >= Kind::kill)
                place(int32_t(i));
        for (const Register &output : outputs)
            for (const flt &part : output.parts)
                place(part.node);
    }

    /* Four components a register: ones fill up threes, and share registers with twos. */
    static int registers_for(const std::array<int, 5> &of_width)
    {
        int ones = of_width[1] > of_width[3] ? of_width[1] - of_width[3] : 0;
        return of_width[4] + of_width[3] + (2 * of_width[2] + ones + 3) / 4;
    }

    int most_registers()
    {
        int most = 0;
        for (int now = 0; now < int(schedule.size()); now++) {
            std::array<int, 5> of_width = {};
            for (int earlier = 0; earlier <= now; earlier++) {
                const Node &node = nodes[size_t(schedule[size_t(earlier)])];
                bool texel = node.kind == Kind::texture;
                if (node.last_use > now)
                    of_width[size_t(texel ? 4 : __builtin_popcount(node.live))]++;
            }
            raise(most, registers_for(of_width));
        }
        return most;
    }

    void read_instruction(const Node &node, GpShaderCounts *counts)
    {
        int slots = model2() ? node.op.model2 : node.op.model3;
        const bool reads = node.kind == Kind::texture || node.kind == Kind::kill;
        (reads ? counts->texture_slots : counts->arithmetic_slots) += slots;
        counts->loops |= node.kind == Kind::loop;
        counts->gradients |= node.op.gradient;
        counts->needs_quads |= node.op.gradient && node.kind == Kind::arithmetic;
        counts->discards |= node.kind == Kind::kill;
        if (node.kind != Kind::texture)
            return;
        if (node.operands.empty()) {
            counts->local_slots = uint16_t(counts->local_slots | 1u << node.index);
            return;
        }
        counts->sampler_slots = uint16_t(counts->sampler_slots | 1u << node.index);
        bool from_quad = node.op.mode == GP_LOD_IMPLICIT || node.op.mode == GP_LOD_BIAS;
        counts->implicit_lod |= from_quad;
        counts->explicit_lod |= node.op.mode == GP_LOD_EXPLICIT;
        raise(counts->dependent_reads, node.order);
    }

    /* Declared registers with a component that is read. */
    template <class Declaration> static int registers_read(const Declaration &list, uint64_t read)
    {
        int registers = 0, first = 0;
        for (const auto &entry : list) {
            uint64_t own = (uint64_t(1) << entry.components) - 1;
            registers += first < 64 && (read >> first & own) != 0;
            first += entry.components;
        }
        return registers;
    }

    void read_graph(GpShaderCounts *counts)
    {
        int uniforms = 0, numbers = 0;
        for (const Node &node : nodes) {
            if (!node.live)
                continue;
            uniforms += node.kind == Kind::uniform;
            numbers += node.kind == Kind::number;
            counts->reads_pixel |= node.kind == Kind::pixel;
            counts->reads_face |= node.kind == Kind::face;
            if (node.kind == Kind::input && node.index < 64)
                counts->inputs_read |= uint64_t(1) << node.index;
            if (is_instruction(node))
                read_instruction(node, counts);
        }
        counts->slots = counts->arithmetic_slots + counts->texture_slots;
        counts->constants = (uniforms + 3) / 4 + (numbers + 3) / 4;
        counts->samplers = __builtin_popcount(counts->sampler_slots | counts->local_slots);
        counts->inputs = (is_vertex() ? registers_read(declared.inputs, counts->inputs_read)
                                      : registers_read(declared.varyings, counts->inputs_read)) +
                         (counts->local_slots != 0);
    }

    const GpProgram &declared;
    Stage stage;
    uint32_t uniform_words;
    std::vector<Node> nodes;
    std::vector<int32_t> schedule;
    std::map<std::pair<Kind, int>, int32_t> leaves;
};

} // namespace

#endif
