/* The shader language: include this in a shader file, after all other headers.
 *
 * It takes short names (add min max any select lane float3 ...) that other code is likely to have:
 * keep shaders in files of their own. (A file that has main too may be compiled once, at four
 * lanes.)
 *
 * A shader is a C function over lanes. Its vocabulary is the instruction set of 2005 (add mul mad
 * dp3 dp4 rcp rsq nrm lrp cmp ... texld texkill dsx), generic over flt, float2, float3 and float4;
 * infix + - * / and comparisons work on flt. Names that C owns carry a trailing underscore (abs_
 * exp_ log_ pow_ sin_ cos_). Operands of another width are widened to the first operand's: a flt is
 * repeated, and so is a C number. Semantics and CHOOSE decisions: CONVENTIONS.md, "Instructions".
 *
 * In every shader function `gp` is the invocation, `c` the uniforms and `in` the inputs:
 *
 *   vertex_shader(name, Uniforms, Vertex, Varying)   writes *position, out->..., *point_size
 *   pixel_shader(name, Uniforms, Varying)            returns the colour of target 0
 *   pixel_shader_targets(name, Uniforms, Varying, Targets)   writes out->..., a struct of float4
 *   program(name, vs, ps, declarations...)           ends the file; defines GpProgram name: its
 *                                                    fields by their names, in any order
 *   depth_program(name, vs, declarations...)         the same without a pixel shader
 *
 * Helpers that read textures or derivatives take `GpInvocation *gp`. What a shader uses must be
 * declared: where it is not, a draw is refused with the program's and the field's name. Shaders are
 * pure: no statics, no libm, no allocation, no branches on lane values (select instead). Loops have
 * constant bounds, and may be left where no lane changes any more: while (.. && any(mask)).
 *
 * A pixel shader may have two parts, which see the same c and in:
 *
 *   pixel_shader_begin(name, Uniforms, Varying, Begun)   returns a Begun, a type of its own
 *   pixel_shader_end(name, Uniforms, Varying, Begun)     finds it in *begun; returns as ever
 *
 * and a loop between them, which begins with pixel_shader_begin_turns(name, Uniforms, Varying,
 * Begun, most):
 *
 *   pixel_shader_turn(name, Uniforms, Varying, Begun)    changes *begun; returns the mask of lanes
 *                                                        that another turn would change: it runs
 *                                                        until there are none, `most` times at
 *                                                        most, and more must change nothing
 *
 * #define GP_SHADER_AT_ONCE 4 (or 2) before the include where pixel shaders are long chains of
 * arithmetic, each step waiting for the one before: so many packets then go through side by side.
 * It changes no bit, and costs registers: measure. It gains nothing across texture reads; a shader
 * of both reads textures in its first part, and only what its turns and its last part do goes side
 * by side. Nor does it across turns of C's loops: each packet makes all of its own.
 *
 * #define GP_SHADER_SW before the include for the software profiles, in which rcp(0) and rsq(0) are
 * infinite instead of the largest float.
 */
#ifndef GP_SHADER_H
#define GP_SHADER_H

#ifdef GP_LANES /* compiled for several widths: a main would stand in each */
#define main(...)                                                                                  \
    gp_no_main(void);                                                                              \
    _Static_assert(0, "a shader file has no main: put it into a file of its own");                 \
    int gp_no_main_either(void)
#endif

#include "pipeline/shader/program.h"

/* One picture, whoever compiles (R50). Fused multiplications are seen when a program is first
 * drawn, and refused there; clang leaves them out when asked here. */
#if defined __FAST_MATH__ || defined __ASSOCIATIVE_MATH__ || defined __RECIPROCAL_MATH__ ||        \
    (defined __FINITE_MATH_ONLY__ && __FINITE_MATH_ONLY__)
#error glasspipe: with -ffast-math, or a part of it, shaders draw other pictures
#endif
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#elif defined GP_SHADER_AT_ONCE && defined __OPTIMIZE__ && !defined __cplusplus
/* Without it gcc has one packet after the other, and both wait as one alone would: Phong takes a
 * third less. */
#pragma GCC optimize("schedule-insns", "sched-pressure")
#endif

#if defined __cplusplus && __cplusplus < 202002L
#define vertex_shader(...)                                                                         \
    static_assert(0, "as C++, a shader file is compiled to count what it costs, with -std=c++20")
#elif defined __cplusplus
#include "pipeline/shader/counting.hpp"
#else
#include "pipeline/shader/entry_points.h"
#include "pipeline/shader/instructions.h"
#include "pipeline/shader/pixels.h"
#include "pipeline/shader/textures.h"
#endif

#endif
