/* Shader functions, called a block of packets at a time, and the programs that they make. */
#ifndef GP_SHADER_ENTRY_POINTS_H
#define GP_SHADER_ENTRY_POINTS_H

#include "pipeline/shader/types.h"

/* Whoever asks what a shader uses finds values that no shader computes where it writes nothing. */
#define GP_UNSET_BITS 0x7fa5a5a5u

GP_INLINE float gp_unset_size(const GpShaderCall *call)
{
    return call->used ? gp_bits_float(GP_UNSET_BITS) : 1.0f;
}

/* Whether this file was compiled to round a * b + c once. */
GP_INLINE bool gp_fuses(void)
{
    volatile float root =
        1 + 0x1p-12f; /* its square ends in 2^-24, which a float has no room for */
    const flt x = flt_set(root), rest = x * x - (1 + 0x1p-11f);
    return rest[0] != 0;
}

GP_INLINE void gp_tell(const GpShaderCall *call, uint32_t used)
{
    if (call->used)
        *call->used |= used | (gp_fuses() ? GP_USED_FUSED : 0);
}

#define GP_VERTEX_PACKETS(name, U, IN, varyings)                                                   \
    for (int k = 0; k < call->packets; k++) {                                                      \
        GpInvocation invocation = { .call = call, .packet = k };                                   \
        flt size = flt_set(gp_unset_size(call));                                                   \
        name##_body(&invocation, (const U *)call->uniforms,                                        \
                    (const IN *)(const void *)call->in + k, (float4 *)(void *)call->position + k,  \
                    varyings, &size);                                                              \
        if (call->point_size)                                                                      \
            ((flt *)(void *)call->point_size)[k] = size;                                           \
        used |= invocation.used;                                                                   \
    }

/* Floats of a shader's structs, and bytes of its uniforms. */
#define GP_SHADER_SIZES(name, U, IN, OUT)                                                          \
    enum {                                                                                         \
        name##_in = sizeof(IN) / sizeof(flt),                                                      \
        name##_out = sizeof(OUT) / sizeof(flt),                                                    \
        name##_uniforms = sizeof(U)                                                                \
    };

/* The loop over packets and the inlined body live together in the shader's object file: calling a
 * shader costs one indirect call a block. */
#define vertex_shader(name, U, IN, OUT)                                                            \
    GP_SHADER_SIZES(name, U, IN, OUT)                                                              \
    GP_INLINE void name##_body(GpInvocation *gp, const U *c, const IN *in, float4 *position,       \
                               OUT *out, flt *point_size);                                         \
    static void name(const GpShaderCall *call)                                                     \
    {                                                                                              \
        OUT *out = (OUT *)(void *)call->varying;                                                   \
        uint32_t used = 0;                                                                         \
        if (out) {                                                                                 \
            GP_VERTEX_PACKETS(name, U, IN, &out[k])                                                \
        } else { /* positions only: what nobody asks for is left out by the compiler */            \
            OUT unused;                                                                            \
            GP_VERTEX_PACKETS(name, U, IN, &unused)                                                \
        }                                                                                          \
        gp_tell(call, used);                                                                       \
    }                                                                                              \
    GP_INLINE void name##_body(__attribute__((unused)) GpInvocation *gp,                           \
                               __attribute__((unused)) const U *c, const IN *in, float4 *position, \
                               __attribute__((unused)) OUT *out,                                   \
                               __attribute__((unused)) flt *point_size)

GP_INLINE void gp_end_packet(const GpInvocation *gp)
{
    if (gp->call->depth)
        ((flt *)(void *)gp->call->depth)[gp->packet] = gp->depth;
    if (gp->call->killed)
        ((msk *)(void *)gp->call->killed)[gp->packet] = gp->killed;
}

GP_INLINE void gp_interpolate(flt *in, int components, const flt *value, flt weight1, flt weight2)
{
    GP_UNROLL
    for (int i = 0; i < components; i++)
        in[i] = value[3 * i] + (weight1 * value[3 * i + 1] + weight2 * value[3 * i + 2]);
}

/* Packets side by side. A processor sees some 200 operations ahead, which are those of one long
 * chain: two packets of Phong take a quarter less, four another quarter, though sixteen registers
 * do not hold them. Three sines are best by two. */
#ifndef GP_SHADER_AT_ONCE
#define GP_SHADER_AT_ONCE 1
#endif
enum { GP_AT_ONCE = GP_SHADER_AT_ONCE };

/* The packet i places behind packet k, or the last. */
GP_INLINE int gp_beside(int k, int i, int count)
{
    return k + i < count ? k + i : count - 1;
}

/* Packets from k on, of `count` from `first` on. from: inputs of packet `at`, the i-th of them.
 * What a shader leaves unwritten stays as it was: all of it is written, or the program is refused.
 * (One alone writes where it belongs: copies of four targets cost vox_add 5 %.) */
#define GP_PIXEL_STEP(name, U, OUT, first, k, count, from)                                         \
    GpInvocation invocation[GP_AT_ONCE];                                                           \
    OUT shaded[GP_AT_ONCE];                                                                        \
    GP_UNROLL                                                                                      \
    for (int i = 0; i < GP_AT_ONCE; i++) {                                                         \
        const int at = gp_beside(k, i, count);                                                     \
        OUT *to = out + (first) + at;                                                              \
        invocation[i] = (GpInvocation){ .call = call, .packet = (first) + at };                    \
        if (GP_AT_ONCE > 1)                                                                        \
            shaded[i] = *to;                                                                       \
        name##_body(&invocation[i], (const U *)call->uniforms, from,                               \
                    GP_AT_ONCE > 1 ? &shaded[i] : to);                                             \
    }                                                                                              \
    GP_UNROLL                                                                                      \
    for (int i = 0; i < GP_AT_ONCE; i++) {                                                         \
        if (GP_AT_ONCE > 1)                                                                        \
            out[invocation[i].packet] = shaded[i];                                                 \
        gp_end_packet(&invocation[i]);                                                             \
        used |= invocation[i].used;                                                                \
    }

#define GP_PIXEL_PACKETS(name, U, OUT)                                                             \
    for (int k = 0; k < call->packets; k += GP_AT_ONCE) {                                          \
        GP_PIXEL_STEP(name, U, OUT, 0, k, call->packets, in + at)                                  \
    }

/* Of few components: interpolated in the shader's own loop they need not go through memory, which
 * costs short shaders as much again (fill_blend32f takes 14 % less, with AVX-512 20 %). The packets
 * of a layer are those from `first` on; `step` takes packet k and those beside it. */
#define GP_PIXEL_LAYERS(name, step, beside)                                                        \
    const int packets = call->packets / call->layers;                                              \
    for (int layer = 0, first = 0; layer < call->layers; layer++, first += packets) {              \
        const GpInterpolants *from = &call->interpolants[layer];                                   \
        const flt *weight1 = (const flt *)(const void *)from->weight[0];                           \
        const flt *weight2 = (const flt *)(const void *)from->weight[1];                           \
        flt value[3 * GP_FEW_COMPONENTS]; /* which no store can change */                          \
        GP_UNROLL                                                                                  \
        for (int i = 0; i < 3 * name##_in; i++)                                                    \
            value[i] = ((const flt *)(const void *)from->value)[i];                                \
        for (int k = 0; k < packets; k += beside) {                                                \
            step                                                                                   \
        }                                                                                          \
    }

#define GP_LAYER_STEP(name, U, IN, OUT)                                                            \
    IN inputs[GP_AT_ONCE];                                                                         \
    GP_UNROLL                                                                                      \
    for (int i = 0; i < GP_AT_ONCE; i++) {                                                         \
        const int at = gp_beside(k, i, packets);                                                   \
        gp_interpolate((flt *)(void *)&inputs[i], name##_in, value, weight1[at], weight2[at]);     \
    }                                                                                              \
    GP_PIXEL_STEP(name, U, OUT, first, k, packets, &inputs[i])

/* Whether a call leaves interpolation to the shader. */
#define GP_INTERPOLATES(name)                                                                      \
    (name##_in > 0 && (int)name##_in <= GP_FEW_COMPONENTS && call->interpolants)

/* A pixel shader that writes a struct of float4, one a target. */
#define pixel_shader_targets(name, U, IN, OUT)                                                     \
    GP_SHADER_SIZES(name, U, IN, OUT)                                                              \
    GP_INLINE void name##_body(GpInvocation *gp, const U *c, const IN *in, OUT *out);              \
    static void name(const GpShaderCall *call)                                                     \
    {                                                                                              \
        const IN *in = (const IN *)(const void *)call->in;                                         \
        OUT *out = (OUT *)(void *)call->color;                                                     \
        uint32_t used = 0;                                                                         \
        if (GP_INTERPOLATES(name)) {                                                               \
            GP_PIXEL_LAYERS(name, GP_LAYER_STEP(name, U, IN, OUT), GP_AT_ONCE)                     \
        } else {                                                                                   \
            GP_PIXEL_PACKETS(name, U, OUT)                                                         \
        }                                                                                          \
        gp_tell(call, used);                                                                       \
    }                                                                                              \
    GP_INLINE void name##_body(__attribute__((unused)) GpInvocation *gp,                           \
                               __attribute__((unused)) const U *c,                                 \
                               __attribute__((unused)) const IN *in, OUT *out)

/* Packets that go through one part of a shader before they go through the next. */
enum { GP_BEGUN = 32 };

/* How many of `count` packets go from packet k on. */
GP_INLINE int gp_begun(int k, int count)
{
    return count - k < GP_BEGUN ? count - k : GP_BEGUN;
}

/* Packets first..first + count - 1, of inputs `from`, through all parts. (Invocations field by
 * field, or gcc clears each by one slow instruction.) */
#define GP_PIXEL_PARTS(name, U, BEGUN, first, count, from)                                         \
    GpInvocation invocation[GP_BEGUN];                                                             \
    BEGUN begun[GP_BEGUN];                                                                         \
    for (int i = 0; i < (count); i++) {                                                            \
        GpInvocation *gp = &invocation[i];                                                         \
        gp->call = call;                                                                           \
        gp->packet = (first) + i;                                                                  \
        gp->used = 0;                                                                              \
        gp->killed = flt_set(0) != 0.0f;                                                           \
        gp->depth = flt_set(0);                                                                    \
        begun[i] = name##_begin(gp, (const U *)call->uniforms, (from) + i);                        \
    }                                                                                              \
    for (int i = 0; (int)name##_turns > 0 && i < (count); i += GP_AT_ONCE) {                       \
        BEGUN own[GP_AT_ONCE];                                                                     \
        GP_UNROLL                                                                                  \
        for (int n = 0; n < GP_AT_ONCE; n++)                                                       \
            own[n] = begun[gp_beside(i, n, count)];                                                \
        msk changes = flt_set(0) == 0.0f;                                                          \
        for (int turn = 0; turn < (int)name##_turns && msk_any(changes); turn++) {                 \
            changes = flt_set(0) != 0.0f;                                                          \
            GP_UNROLL                                                                              \
            for (int n = 0; n < GP_AT_ONCE; n++) {                                                 \
                const int at = gp_beside(i, n, count);                                             \
                changes |=                                                                         \
                    name##_turn(&invocation[at], (const U *)call->uniforms, (from) + at, &own[n]); \
            }                                                                                      \
        }                                                                                          \
        GP_UNROLL                                                                                  \
        for (int n = 0; n < GP_AT_ONCE; n++)                                                       \
            begun[gp_beside(i, n, count)] = own[n];                                                \
    }                                                                                              \
    for (int i = 0; i < (count); i += GP_AT_ONCE) {                                                \
        float4 color[GP_AT_ONCE];                                                                  \
        GP_UNROLL                                                                                  \
        for (int n = 0; n < GP_AT_ONCE; n++) {                                                     \
            const int at = gp_beside(i, n, count);                                                 \
            color[n] =                                                                             \
                name##_end(&invocation[at], (const U *)call->uniforms, (from) + at, &begun[at]);   \
        }                                                                                          \
        GP_UNROLL                                                                                  \
        for (int n = 0; n < GP_AT_ONCE; n++)                                                       \
            out[(first) + gp_beside(i, n, count)] = color[n];                                      \
    }                                                                                              \
    for (int i = 0; i < (count); i++) {                                                            \
        gp_end_packet(&invocation[i]);                                                             \
        used |= invocation[i].used;                                                                \
    }

#define GP_LAYER_PARTS(name, U, IN, BEGUN)                                                         \
    IN inputs[GP_BEGUN];                                                                           \
    const int count = gp_begun(k, packets);                                                        \
    for (int i = 0; i < count; i++)                                                                \
        gp_interpolate((flt *)(void *)&inputs[i], name##_in, value, weight1[k + i],                \
                       weight2[k + i]);                                                            \
    GP_PIXEL_PARTS(name, U, BEGUN, first + k, count, inputs)

/* A pixel shader in two parts with a loop of at most so many turns between them. Packets that are
 * side by side turn until none of them changes any more, and none waits for its own chain alone: a
 * Mandelbrot set takes a third less with AVX2, a tenth with AVX-512. */
#define pixel_shader_begin_turns(name, U, IN, BEGUN, most)                                         \
    enum { name##_turns = (most) };                                                                \
    GP_SHADER_SIZES(name, U, IN, float4)                                                           \
    GP_INLINE BEGUN name##_begin(GpInvocation *gp, const U *c, const IN *in);                      \
    GP_INLINE msk name##_turn(GpInvocation *gp, const U *c, const IN *in, BEGUN *begun);           \
    GP_INLINE float4 name##_end(GpInvocation *gp, const U *c, const IN *in, const BEGUN *begun);   \
    static void name(const GpShaderCall *call)                                                     \
    {                                                                                              \
        const IN *in = (const IN *)(const void *)call->in;                                         \
        float4 *out = (float4 *)(void *)call->color;                                               \
        uint32_t used = 0;                                                                         \
        if (GP_INTERPOLATES(name)) {                                                               \
            GP_PIXEL_LAYERS(name, GP_LAYER_PARTS(name, U, IN, BEGUN), GP_BEGUN)                    \
        } else {                                                                                   \
            for (int k = 0; k < call->packets; k += GP_BEGUN) {                                    \
                const int count = gp_begun(k, call->packets);                                      \
                GP_PIXEL_PARTS(name, U, BEGUN, k, count, in + k)                                   \
            }                                                                                      \
        }                                                                                          \
        gp_tell(call, used);                                                                       \
    }                                                                                              \
    GP_INLINE BEGUN name##_begin(__attribute__((unused)) GpInvocation *gp,                         \
                                 __attribute__((unused)) const U *c,                               \
                                 __attribute__((unused)) const IN *in)

/* A turn: changes *begun, and returns the lanes that another would change. */
#define pixel_shader_turn(name, U, IN, BEGUN)                                                      \
    GP_INLINE msk name##_turn(                                                                     \
        __attribute__((unused)) GpInvocation *gp, __attribute__((unused)) const U *c,              \
        __attribute__((unused)) const IN *in, __attribute__((unused)) BEGUN *begun)

/* One without turns: what the first part returns is `begun` for the second. Packets go through the
 * first, which may call for textures, before any goes through the second, where some are side by
 * side: light behind a shadow map takes 4 to 6 % less of a frame than in one part. */
#define pixel_shader_begin(name, U, IN, BEGUN)                                                     \
    pixel_shader_turn(name, U, IN, BEGUN)                                                          \
    {                                                                                              \
        return flt_set(0) != 0.0f;                                                                 \
    }                                                                                              \
    pixel_shader_begin_turns(name, U, IN, BEGUN, 0)

/* The last part, which returns the colour. */
#define pixel_shader_end(name, U, IN, BEGUN)                                                       \
    GP_INLINE float4 name##_end(__attribute__((unused)) GpInvocation *gp,                          \
                                __attribute__((unused)) const U *c,                                \
                                __attribute__((unused)) const IN *in, const BEGUN *begun)

/* A pixel shader that returns the colour of target 0. */
#define pixel_shader(name, U, IN)                                                                  \
    GP_INLINE float4 name##_color(GpInvocation *gp, const U *c, const IN *in);                     \
    pixel_shader_targets(name, U, IN, float4)                                                      \
    {                                                                                              \
        *out = name##_color(gp, c, in);                                                            \
    }                                                                                              \
    GP_INLINE float4 name##_color(__attribute__((unused)) GpInvocation *gp,                        \
                                  __attribute__((unused)) const U *c,                              \
                                  __attribute__((unused)) const IN *in)

#define GP_PASTE_(a, b) a##b
#define GP_PASTE(a, b)  GP_PASTE_(a, b)
#define GP_CODE(name)   GP_PASTE(name##_code, GP_LANES)

#ifndef GP_ISA_NAME
#define GP_ISA_NAME "generic"
#endif

#define GP_CODE_OF(name, vs, ps)                                                                   \
    extern const GpProgramCode GP_CODE(name);                                                      \
    const GpProgramCode GP_CODE(name) = { GP_LANES, GP_ISA_NAME, vs, ps };

/* The other variants may be missing; a build that has them all defines GP_WEAK as nothing, so that
 * they are found in archives too. */
#ifndef GP_WEAK
#define GP_WEAK __attribute__((weak))
#endif

#if GP_LANES == 4
#define GP_PROGRAM_OF(id, vs, pixel_in, pixel_out, ...)                                            \
    extern const GpProgramCode id##_code8 GP_WEAK, id##_code16 GP_WEAK;                            \
    extern bool id##_count(const GpProgram *, GpShaderCounts *, GpShaderCounts *) GP_WEAK;         \
    extern bool id##_step(const GpProgram *, bool, const struct GpStepRun *) GP_WEAK;              \
    extern const GpProgram id;                                                                     \
    const GpProgram id = { .name = #id,                                                            \
                           __VA_ARGS__,                                                            \
                           .uniform_bytes = vs##_uniforms,                                         \
                           .input_components = vs##_in,                                            \
                           .varying_components = vs##_out,                                         \
                           .pixel_input_components = pixel_in,                                     \
                           .color_components = pixel_out,                                          \
                           .code = { &id##_code4, &id##_code8, &id##_code16 },                     \
                           .count = id##_count,                                                    \
                           .step = id##_step };
#else
#define GP_PROGRAM_OF(id, vs, pixel_in, pixel_out, ...)
#endif

/* Defines the GpProgram `id` of two shaders; what follows them are fields of GpProgram, by their
 * names,
 * in any order. */
#define program(id, vs, ps, ...)                                                                   \
    _Static_assert((int)vs##_uniforms == (int)ps##_uniforms,                                       \
                   "both shaders share one uniform struct");                                       \
    _Static_assert((int)vs##_out == (int)ps##_in, "both shaders share one varying struct");        \
    GP_CODE_OF(id, vs, ps)                                                                         \
    GP_PROGRAM_OF(id, vs, ps##_in, ps##_out, __VA_ARGS__)

/* The same without a pixel shader. */
#define depth_program(id, vs, ...)                                                                 \
    GP_CODE_OF(id, vs, 0)                                                                          \
    GP_PROGRAM_OF(id, vs, 0, 0, __VA_ARGS__)

#endif
