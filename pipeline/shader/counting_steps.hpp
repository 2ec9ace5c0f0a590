/* A recorder that computes: every node of the graph has its values in four lanes as soon as it is there,
 * by the instructions' own code (GpStepRun.evaluate). */
#ifndef GP_COUNTING_STEPS_HPP
#define GP_COUNTING_STEPS_HPP

#include "pipeline/shader/counting_graph.hpp"

namespace
{

class StepRecorder : public Recorder
{
  public:
#ifdef GP_SHADER_SW
    static constexpr bool software = true;
#else
    static constexpr bool software = false;
#endif

    StepRecorder(const GpProgram &declaration, Stage which, size_t bytes, const GpStepRun &what)
        : Recorder(declaration, which, bytes), run(what), uniform_bytes(bytes)
    {
    }

    bool is_stepping() const override
    {
        return true;
    }
    bool holds_anywhere(flt mask) const override
    {
        const Lane lane = value_of(mask);
        for (float one : lane)
            if (gp_float_bits(one))
                return true;
        return false;
    }

    void watch_value(const char *name, const Operand &value) override
    {
        watches.emplace_back(name, value);
    }

    /* A member of the uniforms is known by where it stands. */
    flt number(const float &value) override
    {
        const char *at = reinterpret_cast<const char *>(&value);
        const char *first = static_cast<const char *>(run.call->uniforms);
        if (first && at >= first && at < first + uniform_bytes)
            return leaf(Kind::uniform, int((at - first) / 4));
        return leaf(Kind::number, int(gp_float_bits(value)));
    }

    /* Outputs of the shader, which go to memory [component][lane]; NULL: nobody wants them. */
    void give(const std::vector<flt> &parts, float *memory)
    {
        for (size_t i = 0; i < parts.size(); i++) {
            outputs.push_back({ { parts[i] }, -1 });
            if (!memory || kind_of(parts[i]) == Kind::unwritten)
                continue;
            const Lane lane = value_of(parts[i]);
            std::memcpy(memory + 4 * i, lane.data(), sizeof lane);
        }
    }
    void give_killed()
    {
        for (size_t lane = 0; lane < 4 && run.call->killed; lane++)
            run.call->killed[lane] = killed[lane] ? -1 : 0;
    }

    /* Says all that was done. */
    void tell()
    {
        mark_live(outputs);
        arrange(outputs);
        for (int32_t number : schedule)
            tell_step(number);
        for (size_t i = 0; i < outputs.size(); i++) {
            const GpStepOutput output = { int(i), part_of(outputs[i].parts[0]) };
            run.listener->output(run.listener->user, &output);
        }
        for (const auto &[name, value] : watches)
            if (run.listener->watched)
                tell_watch(name, value);
    }

  protected:
    void compute(const Node &node) override
    {
        values.resize(nodes.size());
        float operand[GP_STEP_OPERANDS][4][4] = {};
        for (size_t i = 0; i < node.operands.size(); i++)
            for (int c = 0; c < node.operands[i].width; c++) {
                const Lane lane = value_of(node.operands[i].part[size_t(c)]);
                std::memcpy(operand[i][c], lane.data(), sizeof lane);
            }
        Value &value = values.back();
        if (node.kind == Kind::texture)
            read(node, operand, &value);
        else if (node.kind == Kind::kill)
            kill(node, operand[0]);
        else if (node.kind == Kind::arithmetic)
            run.evaluate(node.code, software, node.operands[0].width, operand, value.component);
    }

  private:
    using Lane = std::array<float, 4>;
    struct Value {
        float component[4][4];
    };

    Lane all(float value) const
    {
        return { value, value, value, value };
    }
    Lane lane_at(const float *memory) const
    {
        return { memory[0], memory[1], memory[2], memory[3] };
    }

    Lane value_of(flt part) const
    {
        Lane lane = plain_value_of(part);
        if (part.negated)
            for (float &one : lane)
                one = gp_bits_float(gp_float_bits(one) ^ 0x80000000u);
        return lane;
    }
    Lane plain_value_of(flt part) const
    {
        const Node &node = nodes[size_t(part.node)];
        switch (node.kind) {
        case Kind::number:
            return all(gp_bits_float(uint32_t(node.index)));
        case Kind::uniform: {
            float word;
            std::memcpy(&word, static_cast<const char *>(run.call->uniforms) + 4 * node.index, 4);
            return all(word);
        }
        case Kind::input:
            return lane_at(run.call->in + 4 * node.index);
        case Kind::pixel:
            return lane_at(run.call->pixel + 4 * node.index);
        case Kind::face:
            return lane_at(run.call->face);
        case Kind::unwritten:
            return all(0);
        default:
            return lane_at(values[size_t(part.node)].component[part.component]);
        }
    }

    /* As textures.h reads. */
    void read(const Node &node, float operand[GP_STEP_OPERANDS][4][4], Value *value) const
    {
        alignas(64) float coord[4][4], gradient[4][4], texel[4][4];
        if (node.code == GP_STEP_LOCAL) {
            run.call->read_local(run.call, node.index, 0, 4, texel[0]);
        } else {
            std::memcpy(coord, operand[0], sizeof coord);
            if (node.code == GP_STEP_TEXLDP)
                for (size_t lane = 0; lane < 4; lane++) {
                    for (size_t c = 0; c < 3; c++)
                        coord[c][lane] = coord[c][lane] / operand[0][3][lane];
                    coord[3][lane] = 0;
                }
            for (size_t c = 0; c < 4; c++)
                std::memcpy(gradient[c], operand[1 + c / 2][c % 2], sizeof gradient[c]);
            const bool given = node.code == GP_STEP_TEXLDD;
            const GpTextureRead read = {
                node.index, 4, node.op.mode, coord[0], given ? gradient[0] : nullptr, texel[0]
            };
            run.call->read_texture(run.call, &read);
        }
        std::memcpy(value->component, texel, sizeof texel);
    }

    void kill(const Node &node, const float operand[4][4])
    {
        const int components = node.operands[0].width < 3 ? node.operands[0].width : 3;
        for (size_t lane = 0; lane < 4; lane++) {
            if (node.code == GP_STEP_DISCARD)
                killed[lane] = killed[lane] || gp_float_bits(operand[0][lane]);
            for (int c = 0; c < components && node.code == GP_STEP_TEXKILL; c++)
                killed[lane] = killed[lane] || operand[c][lane] < 0.0f;
        }
    }

    GpStepPart part_of(flt of) const
    {
        const Node &node = nodes[size_t(of.node)];
        GpStepPart part = { source_of(node.kind), node.index, 0, of.negated, {} };
        if (part.source == GP_STEP_RESULT) {
            part.index = node.place;
            part.component = of.component;
        }
        const Lane lane = value_of(of);
        std::memcpy(part.value, lane.data(), sizeof part.value);
        return part;
    }
    static GpStepSource source_of(Kind kind)
    {
        switch (kind) {
        case Kind::number:
            return GP_STEP_NUMBER;
        case Kind::uniform:
            return GP_STEP_UNIFORM;
        case Kind::input:
            return GP_STEP_INPUT;
        case Kind::pixel:
            return GP_STEP_PIXEL;
        case Kind::face:
            return GP_STEP_FACE;
        case Kind::unwritten:
            return GP_STEP_UNSET;
        default:
            return GP_STEP_RESULT;
        }
    }

    void tell_step(int32_t number) const
    {
        const Node &node = nodes[size_t(number)];
        GpShaderStep step = {};
        step.number = node.place;
        step.code = node.code;
        step.slots = model2() ? node.op.model2 : node.op.model3;
        step.slot = node.kind == Kind::texture ? node.index : -1;
        step.file = node.written.file;
        step.line = node.written.line;
        step.operands = int(node.operands.size());
        for (size_t i = 0; i < node.operands.size(); i++) {
            step.operand[i].width = node.operands[i].width;
            for (int c = 0; c < node.operands[i].width; c++)
                step.operand[i].part[c] = part_of(node.operands[i].part[size_t(c)]);
        }
        for (int c = 0; c < 4; c++)
            step.width = node.live >> c & 1 ? c + 1 : step.width;
        std::memcpy(step.value, values[size_t(number)].component, sizeof step.value);
        run.listener->step(run.listener->user, &step);
    }

    void tell_watch(const char *name, const Operand &value) const
    {
        GpStepWatch told = { name, { value.width, {} } };
        for (int c = 0; c < value.width; c++)
            told.value.part[c] = part_of(value.part[size_t(c)]);
        run.listener->watched(run.listener->user, &told);
    }

    const GpStepRun &run;
    const size_t uniform_bytes;
    std::vector<Value> values; /* by node; of leaves nothing */
    std::vector<Register> outputs;
    std::vector<std::pair<const char *, Operand>> watches;
    bool killed[4] = {};
};

} // namespace

#endif
