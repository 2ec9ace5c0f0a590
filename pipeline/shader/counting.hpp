/* The counting vocabulary: what <glasspipe/shader.h> is when a shader is compiled as C++20.
 *
 * Here flt, float2.. are names of nodes, and every instruction, infix operators included, records
 * itself into an instruction graph instead of computing: the very source that draws also reports
 * what it costs. pipeline/shader/graph_counts.c says what is counted and how. The types and names
 * are those of the C vocabulary, widening included; `program(id, ...)` emits
 *
 *   extern "C" bool id_count(const GpProgram *id, GpShaderCounts *vertex, GpShaderCounts *pixel)
 *
 * which the C build of the same file refers to, weakly, as .count; and id_step likewise, which runs
 * a shader step by step. What a program declares is in the C build alone. C++ asks one thing of a
 * shader that C does not: no C++ keyword as a name.
 */
#ifndef GP_COUNTING_HPP
#define GP_COUNTING_HPP

#include "pipeline/shader/counting_instructions.hpp"
#include "pipeline/shader/counting_textures.hpp"

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

/* Tells which members of a vertex struct are called as semantics. */
template <class In> void gp_name_inputs(const In &in)
{
    [[maybe_unused]] auto name = [&in](GpSemantic semantic, const auto &member) {
        const auto at = reinterpret_cast<const char *>(&member);
        gp_graph_name_input(semantic,
                            int(at - reinterpret_cast<const char *>(&in)) / int(sizeof(flt)));
    };
    if constexpr (requires { in.position; })
        name(GP_POSITION, in.position);
    if constexpr (requires { in.normal; })
        name(GP_NORMAL, in.normal);
    if constexpr (requires { in.color; })
        name(GP_COLOR, in.color);
    if constexpr (requires { in.tangent; })
        name(GP_TANGENT, in.tangent);
}

template <class S> flt *gp_parts(S *whole)
{
    return reinterpret_cast<flt *>(whole);
}

template <class U, class In, class Out>
void gp_run_vertex(void (*body)(GpInvocation *, const U *, const In *, float4 *, Out *, flt *))
{
    In in;
    Out out;
    float4 position;
    flt point_size;
    const GpGraphBody run = { sizeof(U),     gp_parts(&in),       gp_parts(&out), width_of<In>,
                              width_of<Out>, gp_parts(&position), &point_size };
    const void *uniforms = gp_graph_begin(&run);
    if (!uniforms)
        return;
    gp_name_inputs(in);
    GpInvocation invocation = {};
    body(&invocation, static_cast<const U *>(uniforms), &in, &position, &out, &point_size);
    gp_graph_end(&run);
}

template <class U, class In, class Out>
void gp_run_pixel(void (*body)(GpInvocation *, const U *, const In *, Out *))
{
    In in;
    Out out;
    GpInvocation invocation;
    const GpGraphBody run = { sizeof(U),     gp_parts(&in), gp_parts(&out),   width_of<In>,
                              width_of<Out>, nullptr,       &invocation.depth };
    const void *uniforms = gp_graph_begin(&run);
    if (!uniforms)
        return;
    body(&invocation, static_cast<const U *>(uniforms), &in, &out);
    gp_graph_end(&run);
}

#ifdef GP_SHADER_SW
constexpr bool GP_IS_SOFTWARE = true;
#else
constexpr bool GP_IS_SOFTWARE = false;
#endif

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

/* What is compiled here, with -fno-exceptions, needs no library of C++. */
#define GP_RECORDED(id, vertex_run, pixel_run)                                                     \
    extern "C" bool id##_count(const GpProgram *declared, GpShaderCounts *vertex,                  \
                               GpShaderCounts *pixel);                                             \
    extern "C" bool id##_step(const GpProgram *declared, bool vertex, const GpStepRun *run);       \
    static constexpr GpGraphShaders id##_shaders = { vertex_run, pixel_run, GP_IS_SOFTWARE };      \
    extern "C" bool id##_count(const GpProgram *declared, GpShaderCounts *vertex,                  \
                               GpShaderCounts *pixel)                                              \
    {                                                                                              \
        return gp_graph_count(declared, &id##_shaders, vertex, pixel);                             \
    }                                                                                              \
    extern "C" bool id##_step(const GpProgram *declared, bool vertex, const GpStepRun *run)        \
    {                                                                                              \
        return gp_graph_step(declared, &id##_shaders, vertex, run);                                \
    }

#define program(id, vs, ps, ...)                                                                   \
    static_assert(int(vs##_uniforms) == int(ps##_uniforms),                                        \
                  "both shaders share one uniform struct");                                        \
    static_assert(int(vs##_out) == int(ps##_in), "both shaders share one varying struct");         \
    GP_RECORDED(                                                                                   \
        id, [] { gp_run_vertex(vs); }, [] { gp_run_pixel(ps); })

#define depth_program(id, vs, ...)                                                                 \
    GP_RECORDED(                                                                                   \
        id, [] { gp_run_vertex(vs); }, nullptr)

#endif
