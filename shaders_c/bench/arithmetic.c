/* Arithmetic alone: what a shader costs that reads no texture. */
#define GP_SHADER_SW /* a Mandelbrot set of 64 steps is too long for hardware's profiles */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/bench/arithmetic.h"

textured_quad_vertex_shader(arithmetic_vs, ArithmeticUniforms);

/* --- chains of multiply-adds ------------------------------------------------------------------ */

/* Two components at a time: with the constants they fit into sixteen registers, four do not. */
typedef struct Chains {
    float2 v0, v1, v2, v3;
} Chains;

GP_INLINE Chains chains_start(float2 v)
{
    return (Chains){ v, mul(v, 0.5f), add(v, 0.25f), mul(v, v) };
}

GP_INLINE Chains step(Chains chains, float2 a, float2 b)
{
    return (Chains){ mad(chains.v0, a, b), mad(chains.v1, a, b), mad(chains.v2, a, b),
                     mad(chains.v3, a, b) };
}

GP_INLINE float2 chains_end(Chains chains)
{
    return mul(add(add(add(chains.v0, chains.v1), chains.v2), chains.v3), 0.25f);
}

typedef struct Halves {
    Chains rg, ba;
} Halves;

GP_INLINE Halves halves_start(float2 uv)
{
    return (Halves){ chains_start(uv), chains_start(vec2(1.0f - uv.x, 1.0f - uv.y)) };
}

/* As a loop, which gcc leaves one: alu_flat takes 6 % less with AVX2 than in a line, alu_mad 2
 * %. */
GP_INLINE Chains step4(Chains chains, float2 a, float2 b)
{
    for (int i = 0; i < 4; i++)
        chains = step(chains, a, b);
    return chains;
}

/* Four steps of one half, then of the other: a processor that looks ahead so far has both to do,
 * where one waits for itself (a sixth less time with AVX2, a quarter with AVX-512). */
GP_INLINE Halves halves_step4(Halves at, const ArithmeticUniforms *c)
{
    return (Halves){ step4(at.rg, u2(c->factor), u2(c->addend)),
                     step4(at.ba, u2(c->factor + 2), u2(c->addend + 2)) };
}

GP_INLINE float4 halves_end(Halves at)
{
    float2 rg = chains_end(at.rg), ba = chains_end(at.ba);
    return vec4(rg.x, rg.y, ba.x, ba.y);
}

pixel_shader(mad_loop_ps, ArithmeticUniforms, UvVarying)
{
    Halves at = halves_start(in->uv);
    for (int i = 0; i < 64; i += 4)
        at = halves_step4(at, c);
    return halves_end(at);
}

GP_INLINE Halves halves_step16(Halves at, const ArithmeticUniforms *c)
{
    return halves_step4(halves_step4(halves_step4(halves_step4(at, c), c), c), c);
}

pixel_shader(mad_flat_ps, ArithmeticUniforms, UvVarying)
{
    Halves at = halves_start(in->uv);
    at = halves_step16(halves_step16(halves_step16(halves_step16(at, c), c), c), c);
    return halves_end(at);
}

/* clang-format off */
#define ARITHMETIC_DECLARATIONS                                                                    \
    .vertex_profile = GP_VS_3_SW, .pixel_profile = GP_PS_3_SW, TEXTURED_QUAD_DECLARATIONS
/* clang-format on */

program(mad_loop_program, arithmetic_vs, mad_loop_ps, ARITHMETIC_DECLARATIONS)
program(mad_flat_program, arithmetic_vs, mad_flat_ps, ARITHMETIC_DECLARATIONS)
