/* The counting vocabulary: what <glasspipe/shader.h> is when a shader is compiled as C++20.
 *
 * Here flt, float2.. are names of nodes, and every instruction, infix operators included, records
 * itself into an instruction graph instead of computing: the very source that draws also reports
 * what it costs. pipeline/shader/counting_graph.hpp says what is counted and how. The types and names are
 * those of the C vocabulary, widening included; `program(id, ...)` emits
 *
 *   extern "C" bool id_count(const GpProgram *id, GpShaderCounts *vertex, GpShaderCounts *pixel)
 *
 * which the C build of the same file refers to, weakly, as .count; and id_step likewise, which runs a
 * shader step by step. What a program declares is in the C build alone. C++ asks one thing of a shader that C does not: no C++ keyword as a name.
 */
#ifndef GP_COUNTING_HPP
#define GP_COUNTING_HPP

#include "pipeline/shader/counting_instructions.hpp"
#include "pipeline/shader/counting_steps.hpp"

/* A struct is given the fields that matter and zeros in the rest, as C's warnings understand and
 * g++'s do not. */
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

#ifndef main /* as shader.h refuses it where lanes are named */
#define main(...)                                                                                  \
    gp_no_main;                                                                                    \
    static_assert(false, "a shader file has no main: put it into a file of its own");              \
    int gp_no_main_either(__VA_ARGS__)
#endif

namespace
{

/* --- running a shader ------------------------------------------------------------------------- */

/* Makes a recorder the thread's own until it goes out of scope. */
struct Recording {
    Recorder *const before = recording;
    explicit Recording(Recorder *recorder)
    {
        recording = recorder;
    }
    ~Recording()
    {
        recording = before;
    }
    Recording(const Recording &) = delete;
};

template <class S> void fill(S *whole, const std::vector<flt> &parts)
{
    if (!parts.empty()) /* a program may have no varyings */
        std::memcpy(whole, parts.data(), parts.size() * sizeof(flt));
}
template <class S> std::vector<flt> parts_of(const S &whole)
{
    std::vector<flt> parts(sizeof whole / sizeof(flt));
    if (!parts.empty())
        std::memcpy(parts.data(), &whole, parts.size() * sizeof(flt));
    return parts;
}
template <class S> void fill_inputs(Recorder *recorder, S *in)
{
    std::vector<flt> parts;
    for (size_t i = 0; i < sizeof *in / sizeof(flt); i++)
        parts.push_back(recorder->leaf(Kind::input, int(i)));
    fill(in, parts);
}

/* GpShaderCounts.named_inputs of a vertex struct. */
template <class In> void find_named_inputs(uint8_t *first)
{
    static const In in = {};
    auto place = [](const auto &member) {
        return uint8_t(
            1 + (reinterpret_cast<const char *>(&member) - reinterpret_cast<const char *>(&in)) /
                    int(sizeof(flt)));
    };
    if constexpr (requires { in.position; })
        first[GP_POSITION] = place(in.position);
    if constexpr (requires { in.normal; })
        first[GP_NORMAL] = place(in.normal);
    if constexpr (requires { in.color; })
        first[GP_COLOR] = place(in.color);
    if constexpr (requires { in.tangent; })
        first[GP_TANGENT] = place(in.tangent);
}

template <class U, class In, class Out>
GpShaderCounts gp_count_vertex(const GpProgram &declared,
                               void (*body)(GpInvocation *, const U *, const In *, float4 *, Out *,
                                            flt *))
{
    Recorder recorder(declared, Recorder::vertex, sizeof(U));
    Recording scope(&recorder);
    flt unwritten = recorder.leaf(Kind::unwritten, 0), point_size = unwritten;
    float4 position = sp4(unwritten);
    U uniforms;
    In in;
    Out out;
    Recorder::tag_uniforms(&uniforms, sizeof uniforms);
    fill_inputs(&recorder, &in);
    fill(&out, std::vector<flt>(sizeof out / sizeof(flt), unwritten));

    GpInvocation invocation = { unwritten };
    body(&invocation, &uniforms, &in, &position, &out, &point_size);

    std::vector<Register> outputs = Recorder::split(parts_of(out), declared.varyings);
    outputs.insert(outputs.begin(), { parts_of(position), -1 });
    outputs.push_back({ { point_size }, -1 });
    GpShaderCounts counts = recorder.finish(outputs);
    find_named_inputs<In>(counts.named_inputs);
    counts.writes_point_size = recorder.kind_of(point_size) != Kind::unwritten;
    return counts;
}

template <class U, class In, class Out>
GpShaderCounts gp_count_pixel(const GpProgram &declared,
                              void (*body)(GpInvocation *, const U *, const In *, Out *))
{
    Recorder recorder(declared, Recorder::pixel, sizeof(U));
    Recording scope(&recorder);
    flt unwritten = recorder.leaf(Kind::unwritten, 0);
    U uniforms;
    In in;
    Out out;
    Recorder::tag_uniforms(&uniforms, sizeof uniforms);
    fill_inputs(&recorder, &in);
    fill(&out, std::vector<flt>(sizeof out / sizeof(flt), unwritten));

    GpInvocation invocation = { unwritten };
    body(&invocation, &uniforms, &in, &out);

    GpVaryingDecl targets[GP_MAX_TARGETS] = {};
    for (GpVaryingDecl &target : targets)
        target.components = 4;
    std::vector<Register> outputs = Recorder::split(parts_of(out), targets);
    outputs.push_back({ { invocation.depth }, -1 });
    GpShaderCounts counts = recorder.finish(outputs);
    counts.writes_depth = recorder.kind_of(invocation.depth) != Kind::unwritten;
    if (!counts.writes_depth && !counts.discards)
        counts.copied_slot = recorder.copied_slot(parts_of(out));
    return counts;
}

/* The same two bodies, run with values. */
template <class U, class In, class Out>
void gp_step_vertex(const GpProgram &declared, const GpStepRun &run,
                    void (*body)(GpInvocation *, const U *, const In *, float4 *, Out *, flt *))
{
    StepRecorder recorder(declared, Recorder::vertex, sizeof(U), run);
    Recording scope(&recorder);
    flt unwritten = recorder.leaf(Kind::unwritten, 0), point_size = bcast(1.0f);
    float4 position = sp4(unwritten);
    In in;
    Out out;
    fill_inputs(&recorder, &in);
    fill(&out, std::vector<flt>(sizeof out / sizeof(flt), unwritten));

    GpInvocation invocation = { unwritten };
    body(&invocation, static_cast<const U *>(run.call->uniforms), &in, &position, &out,
         &point_size);

    recorder.give(parts_of(position), run.call->position);
    recorder.give(parts_of(out), run.call->varying);
    recorder.give({ point_size }, run.call->point_size);
    recorder.tell();
}

template <class U, class In, class Out>
void gp_step_pixel(const GpProgram &declared, const GpStepRun &run,
                   void (*body)(GpInvocation *, const U *, const In *, Out *))
{
    StepRecorder recorder(declared, Recorder::pixel, sizeof(U), run);
    Recording scope(&recorder);
    flt unwritten = recorder.leaf(Kind::unwritten, 0);
    In in;
    Out out;
    fill_inputs(&recorder, &in);
    fill(&out, std::vector<flt>(sizeof out / sizeof(flt), unwritten));

    GpInvocation invocation = { unwritten };
    body(&invocation, static_cast<const U *>(run.call->uniforms), &in, &out);

    recorder.give(parts_of(out), run.call->color);
    recorder.give({ invocation.depth }, run.call->depth);
    recorder.give_killed();
    recorder.tell();
}

} // namespace

/* --- shader functions and programs ------------------------------------------------------------ */

#define GP_UNUSED __attribute__((unused))

#define vertex_shader(name, U, IN, OUT)                                                            \
    enum { name##_out = sizeof(OUT) / sizeof(flt), name##_uniforms = sizeof(U) };                  \
    static void name(GP_UNUSED GpInvocation *gp, GP_UNUSED const U *c, const IN *in,               \
                     float4 *position, GP_UNUSED OUT *out, GP_UNUSED flt *point_size)

#define pixel_shader_targets(name, U, IN, OUT)                                                     \
    enum { name##_in = sizeof(IN) / sizeof(flt), name##_uniforms = sizeof(U) };                    \
    static void name(GP_UNUSED GpInvocation *gp, GP_UNUSED const U *c, GP_UNUSED const IN *in,     \
                     OUT *out)

#define pixel_shader(name, U, IN)                                                                  \
    static float4 name##_color(GpInvocation *gp, const U *c, const IN *in);                        \
    pixel_shader_targets(name, U, IN, float4)                                                      \
    {                                                                                              \
        *out = name##_color(gp, c, in);                                                            \
    }                                                                                              \
    static float4 name##_color(GP_UNUSED GpInvocation *gp, GP_UNUSED const U *c,                   \
                               GP_UNUSED const IN *in)

#define pixel_shader_begin_turns(name, U, IN, BEGUN, most)                                         \
    static BEGUN name##_begin(GpInvocation *gp, const U *c, const IN *in);                         \
    static msk name##_turn(GpInvocation *gp, const U *c, const IN *in, BEGUN *begun);              \
    static float4 name##_end(GpInvocation *gp, const U *c, const IN *in, const BEGUN *begun);      \
    pixel_shader_targets(name, U, IN, float4)                                                      \
    {                                                                                              \
        BEGUN begun = name##_begin(gp, c, in);                                                     \
        for (int i = 0; i < (most) && any(name##_turn(gp, c, in, &begun)); i++) {                  \
        }                                                                                          \
        *out = name##_end(gp, c, in, &begun);                                                      \
    }                                                                                              \
    static BEGUN name##_begin(GP_UNUSED GpInvocation *gp, GP_UNUSED const U *c,                    \
                              GP_UNUSED const IN *in)

#define pixel_shader_turn(name, U, IN, BEGUN)                                                      \
    static msk name##_turn(GP_UNUSED GpInvocation *gp, GP_UNUSED const U *c,                       \
                           GP_UNUSED const IN *in, GP_UNUSED BEGUN *begun)

#define pixel_shader_begin(name, U, IN, BEGUN)                                                     \
    pixel_shader_turn(name, U, IN, BEGUN)                                                          \
    {                                                                                              \
        return msk();                                                                              \
    }                                                                                              \
    pixel_shader_begin_turns(name, U, IN, BEGUN, 0)

#define pixel_shader_end(name, U, IN, BEGUN)                                                       \
    static float4 name##_end(GP_UNUSED GpInvocation *gp, GP_UNUSED const U *c,                     \
                             GP_UNUSED const IN *in, const BEGUN *begun)

#define GP_STEP_OF(id, vertex_steps, pixel_steps)                                                  \
    extern "C" void id##_step(const GpProgram *declared, bool vertex, const GpStepRun *run);       \
    extern "C" void id##_step(const GpProgram *declared, bool vertex, const GpStepRun *run)        \
    {                                                                                              \
        if (vertex)                                                                                \
            vertex_steps;                                                                          \
        else                                                                                       \
            pixel_steps;                                                                           \
    }

/* The callers are C, which no exception may reach. */
#define GP_COUNT_OF(id, vertex_counts, pixel_counts)                                               \
    extern "C" bool id##_count(const GpProgram *declared, GpShaderCounts *vertex,                  \
                               GpShaderCounts *pixel);                                             \
    extern "C" bool id##_count(GP_UNUSED const GpProgram *declared, GpShaderCounts *vertex,        \
                               GpShaderCounts *pixel)                                              \
    try {                                                                                          \
        if (vertex)                                                                                \
            *vertex = vertex_counts;                                                               \
        if (pixel)                                                                                 \
            *pixel = pixel_counts;                                                                 \
        return true;                                                                               \
    } catch (const std::bad_alloc &) {                                                             \
        return false;                                                                              \
    }

#define program(id, vs, ps, ...)                                                                   \
    static_assert(int(vs##_uniforms) == int(ps##_uniforms),                                        \
                  "both shaders share one uniform struct");                                        \
    static_assert(int(vs##_out) == int(ps##_in), "both shaders share one varying struct");         \
    GP_COUNT_OF(id, gp_count_vertex(*declared, vs), gp_count_pixel(*declared, ps))                 \
    GP_STEP_OF(id, gp_step_vertex(*declared, *run, vs), gp_step_pixel(*declared, *run, ps))

#define depth_program(id, vs, ...)                                                                 \
    GP_COUNT_OF(id, gp_count_vertex(*declared, vs), GpShaderCounts{})                              \
    GP_STEP_OF(id, gp_step_vertex(*declared, *run, vs), (void)0)

#endif
