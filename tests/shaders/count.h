/* Programs whose cost is known by hand, for test_counting. */
#ifndef TESTS_SHADERS_COUNT_H
#define TESTS_SHADERS_COUNT_H

#include "pipeline/shader/program.h"

typedef struct CountUniforms {
    float matrix[4][4];
    float one;
    float many[36][4];
} CountUniforms;

/* One instruction each, in model 3, where a result reaches its target without a mov unless it is a
 * texel, negated, or not computed: name, arithmetic slots, texture slots, what is returned.
 * Interpolants are the float4 a and b and the float2 uv; s and t are flt, p and q float3. */
/* clang-format off */
#define COUNT_INSTRUCTIONS(X)                                                                      \
    X(add, 1, 0, add(in->a, in->b))                                                                \
    X(sub, 1, 0, sub(in->a, in->b))                                                                \
    X(mul, 1, 0, mul(in->a, in->b))                                                                \
    X(mad, 1, 0, mad(in->a, in->b, in->a))                                                         \
    X(min, 1, 0, min(in->a, in->b))                                                                \
    X(max, 1, 0, max(in->a, in->b))                                                                \
    X(slt, 1, 0, slt(in->a, in->b))                                                                \
    X(sge, 1, 0, sge(in->a, in->b))                                                                \
    X(cmp, 1, 0, cmp(in->a, in->b, in->a))                                                         \
    X(lrp, 2, 0, lrp(in->a, in->b, in->a))                                                         \
    X(abs, 1, 0, abs_(in->a))                                                                      \
    X(frc, 1, 0, frc(in->a))                                                                       \
    X(floor, 2, 0, floor_(in->a))                                                                  \
    X(neg_moved, 1, 0, neg(in->a))                                                                 \
    X(neg_operand, 1, 0, add(neg(in->a), in->b))                                                   \
    X(sat_computed, 1, 0, sat(add(in->a, in->b)))                                                  \
    X(sat_input, 1, 0, sat(in->a))                                                                 \
    X(dp2, 2, 0, sp4(dp2(in->uv, in->uv)))                                                         \
    X(dp2add, 2, 0, sp4(dp2add(in->uv, in->uv, s)))                                                \
    X(dp3, 1, 0, sp4(dp3(p, q)))                                                                   \
    X(dp4, 1, 0, sp4(dp4(in->a, in->b)))                                                           \
    X(crs, 2, 0, four(crs(p, q)))                                                                  \
    X(rcp, 1, 0, sp4(rcp(s)))                                                                      \
    X(rsq, 1, 0, sp4(rsq(s)))                                                                      \
    X(exp, 1, 0, sp4(exp_(s)))                                                                     \
    X(log, 1, 0, sp4(log_(s)))                                                                     \
    X(pow, 3, 0, sp4(pow_(s, t)))                                                                  \
    X(sin, 8, 0, sp4(sin_(s)))                                                                     \
    X(cos, 8, 0, sp4(cos_(s)))                                                                     \
    X(sincos, 8, 0, sp4(sincos_(s).y))                                                             \
    X(sqrt, 2, 0, sp4(sqrt_(s)))                                                                   \
    X(sgn, 3, 0, sp4(sgn(s)))                                                                      \
    X(nrm2, 3, 0, sp4(nrm(in->uv).x))                                                              \
    X(nrm3, 3, 0, four(nrm(p)))                                                                    \
    X(nrm4, 3, 0, nrm(in->a))                                                                      \
    X(lit, 3, 0, lit(s, t, s))                                                                     \
    X(dst, 1, 0, dst(in->a, in->b))                                                                \
    X(m4x4_point, 4, 0, m4x4(p, c->matrix))                                                        \
    X(m4x4, 4, 0, m4x4(in->a, c->matrix))                                                          \
    X(m4x3, 3, 0, four(m4x3(p, c->matrix)))                                                        \
    X(m4x3_vector, 3, 0, four(m4x3(in->a, c->matrix)))                                             \
    X(m3x3, 3, 0, four(m3x3(p, c->matrix)))                                                        \
    X(m4x4_one_row, 1, 0, sp4(m4x4(in->a, c->matrix).z))                                           \
    X(dsx, 2, 0, dsx(in->a))                                                                       \
    X(dsy, 2, 0, dsy(in->a))                                                                       \
    X(infix_add, 1, 0, sp4(s + t))                                                                 \
    X(infix_sub, 1, 0, sp4(1.0f - t))                                                              \
    X(infix_mul, 1, 0, sp4(s * c->one))                                                            \
    X(infix_div, 2, 0, sp4(s / t))                                                                 \
    X(infix_reciprocal, 1, 0, sp4(1.0f / t))                                                       \
    X(infix_unary, 1, 0, sp4(s * -t))                                                              \
    X(infix_mixed, 3, 0, sp4(2.0f * s + t * t))                                                    \
    X(sel_zero, 1, 0, sel(s < 0.0f, in->a, in->b))                                                 \
    X(sel_less, 2, 0, sel(s < t, in->a, in->b))                                                    \
    X(sel_equal, 3, 0, sel(s == t, in->a, 1))                                                      \
    X(sel_and, 2, 0, sel((s > 0.0f) & (t <= 0.0f), in->a, in->b))                                  \
    X(swizzles, 1, 0, add(vec4(in->a.w, in->b.x, in->uv.x, 3), sp4(in->a.y)))                      \
    X(take_apart, 1, 0, four(xyz(add(in->a, in->b))))                                              \
    X(constant_alpha, 2, 0, rgba(xyz(add(in->a, in->b)), 1))                                       \
    X(copied, 1, 0, in->a)                                                                         \
    X(widened, 1, 0, mad(in->a, s, 0.5f))                                                          \
    X(texld, 1, 1, texld(0, in->uv))                                                               \
    X(texldp, 1, 3, texldp(0, in->a))                                                              \
    X(texldb, 1, 6, texldb(0, in->a))                                                              \
    X(texldl, 1, 2, texldl(0, in->a))                                                              \
    X(texldd, 1, 3, texldd(0, in->uv, in->uv, in->uv))                                             \
    X(load_local, 1, 1, gp_load_local(1))

/* The same in model 2, where every target takes a mov and some reads are cheaper. */
#define COUNT_INSTRUCTIONS_2(X)                                                                    \
    X(two_add, 2, 0, add(in->a, in->b))                                                            \
    X(two_copied, 1, 0, in->a)                                                                     \
    X(two_packed, 2, 0, rgba(xyz(add(in->a, in->b)), 1))                                           \
    X(two_texld, 1, 1, texld(0, in->uv))                                                           \
    X(two_texldp, 1, 1, texldp(0, in->a))                                                          \
    X(two_texldb, 1, 1, texldb(0, in->a))
/* clang-format on */

#define COUNT_DECLARE(id, arithmetic, texture, value) extern const GpProgram count_##id;
COUNT_INSTRUCTIONS(COUNT_DECLARE)
COUNT_INSTRUCTIONS_2(COUNT_DECLARE)
#undef COUNT_DECLARE

/* Kills. */
extern const GpProgram count_kills, count_kills_2;
/* A shader, and the same with code that reaches nothing. */
extern const GpProgram count_lean, count_with_dead_code;
/* One component of a float4 sum. */
extern const GpProgram count_one_component;
/* Coordinates that are interpolants, or almost, and chains of 1 to 4 computed ones. */
extern const GpProgram count_order0, count_swizzled, count_order1, count_order2, count_order3,
    count_order4;
/* 101 slots; 64 and 65 arithmetic slots; 33 reads. */
extern const GpProgram count_over_slots, count_full_arithmetic, count_over_arithmetic,
    count_over_reads;
/* 33 float4 constants; 3 uniform floats and the numbers 0.5, -0.5, 2, 3, 4. */
extern const GpProgram count_over_constants, count_numbers;
/* Living registers: three float4; a float3 with a flt; two float3; 13 float4. */
extern const GpProgram count_three, count_shared, count_two, count_over_temporaries;
/* What profiles lack. */
extern const GpProgram count_gradients, count_explicit_level, count_looping, count_place,
    count_facing;
/* A loop of 100 turns in model 3. */
extern const GpProgram count_looping_3;
/* So many instructions, each of which waits for the one before; of no profile. */
enum { COUNT_CHAIN = 10000 };
extern const GpProgram count_chain;
/* Vertex shaders: 257 slots; a saturated input; a texture; an implicit level; a written point size
 * and depth. */
extern const GpProgram count_long_vertex, count_vertex_sat, count_vertex_texture,
    count_vertex_texld, count_extras;
/* A varying, and a target, that are not written whole. */
extern const GpProgram count_unwritten_varying, count_unwritten_target;

#endif
