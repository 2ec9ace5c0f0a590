/* The instructions of the shader language, component by component; CONVENTIONS.md has their
 * semantics. */
#ifndef GP_SHADER_INSTRUCTIONS_H
#define GP_SHADER_INSTRUCTIONS_H

#include "pipeline/base/detmath.h"
#include "pipeline/shader/types.h"

/* --- arithmetic ------------------------------------------------------------------------------- */

GP_INLINE flt gp_add_lanes(flt a, flt b)
{
    return a + b;
}
GP_INLINE flt gp_sub_lanes(flt a, flt b)
{
    return a - b;
}
GP_INLINE flt gp_mul_lanes(flt a, flt b)
{
    return a * b;
}
GP_INLINE flt gp_mad_lanes(flt a, flt b, flt c)
{
    return a * b + c; /* two roundings: nothing is fused (R50) */
}
GP_INLINE flt gp_lrp_lanes(flt t, flt a, flt b)
{
    return t * (a - b) + b;
}
/* R30: where one operand is NaN the other is the result. */
GP_INLINE flt gp_min_lanes(flt a, flt b)
{
    return flt_min_num(a, b);
}
GP_INLINE flt gp_max_lanes(flt a, flt b)
{
    return flt_max_num(a, b);
}
GP_INLINE flt gp_slt_lanes(flt a, flt b)
{
    return flt_select(a < b, flt_set(1), flt_set(0));
}
GP_INLINE flt gp_sge_lanes(flt a, flt b)
{
    return flt_select(a >= b, flt_set(1), flt_set(0));
}
GP_INLINE flt gp_cmp_lanes(flt s0, flt s1, flt s2)
{
    return flt_select(s0 >= 0.0f, s1, s2);
}
GP_INLINE flt gp_saturate_lanes(flt a)
{
    return flt_lesser(flt_greater(a, flt_set(0)), flt_set(1)); /* NaN to 0 */
}
/* Of the bits, so that choosing between a and -a becomes choosing a sign. */
GP_INLINE flt gp_negate_lanes(flt a)
{
    return (flt)((itg)a ^ INT32_MIN);
}

GP_MAP2(gp_add, gp_add_lanes)
GP_MAP2(gp_sub, gp_sub_lanes)
GP_MAP2(gp_mul, gp_mul_lanes)
GP_MAP2(gp_min, gp_min_lanes)
GP_MAP2(gp_max, gp_max_lanes)
GP_MAP2(gp_slt, gp_slt_lanes)
GP_MAP2(gp_sge, gp_sge_lanes)
GP_MAP3(gp_mad, gp_mad_lanes)
GP_MAP3(gp_lrp, gp_lrp_lanes)
GP_MAP3(gp_cmp, gp_cmp_lanes)
GP_MAP1(gp_sat, gp_saturate_lanes)
GP_MAP1(gp_neg, gp_negate_lanes)
GP_MAP1(gp_abs, flt_abs)
GP_MAP1(gp_frc, math_frc)
GP_MAP1(gp_floor, math_floor)

#define GP_ONE(name, f, a)    (GP_WANT(#name "(a)", a), GP_BY_WIDTH(f, a)(a))
#define GP_TWO(name, f, a, b) (GP_WANT2(#name "(a, b)", a, b), GP_BY_WIDTH(f, a)(a, gp_as(a, b)))

/* Component by component, of the width of a; slt, sge: 1 where a < b, a >= b, else 0. */
#define add(a, b) GP_TWO(add, gp_add, a, b)
#define sub(a, b) GP_TWO(sub, gp_sub, a, b)
#define mul(a, b) GP_TWO(mul, gp_mul, a, b)
#define min(a, b) GP_TWO(min, gp_min, a, b)
#define max(a, b) GP_TWO(max, gp_max, a, b)
#define slt(a, b) GP_TWO(slt, gp_slt, a, b)
#define sge(a, b) GP_TWO(sge, gp_sge, a, b)
/* mad(a, b, c) = a*b + c, rounded twice */
#define mad(a, b, c)                                                                               \
    (GP_WANT2("mad(a, b, c)", a, b), GP_WANT2("mad(a, b, c)", a, c),                               \
     GP_BY_WIDTH(gp_mad, a)(a, gp_as(a, b), gp_as(a, c)))
/* lrp(t, a, b) = t*(a-b) + b, of the width of a */
#define lrp(t, a, b)                                                                               \
    (GP_WANT2("lrp(t, a, b)", a, t), GP_WANT2("lrp(t, a, b)", a, b),                               \
     GP_BY_WIDTH(gp_lrp, a)(gp_as(a, t), a, gp_as(a, b)))
/* cmp(s, a, b) = s >= 0 ? a : b, of the width of a */
#define cmp(s, a, b)                                                                               \
    (GP_WANT2("cmp(s, a, b)", a, s), GP_WANT2("cmp(s, a, b)", a, b),                               \
     GP_BY_WIDTH(gp_cmp, a)(gp_as(a, s), a, gp_as(a, b)))
#define sat(a)    GP_ONE(sat, gp_sat, a)
#define neg(a)    GP_ONE(neg, gp_neg, a)
#define abs_(a)   GP_ONE(abs_, gp_abs, a)
#define frc(a)    GP_ONE(frc, gp_frc, a)
#define floor_(a) GP_ONE(floor_, gp_floor, a)

GP_INLINE flt gp_sel1(msk m, flt a, flt b)
{
    return flt_select(m, a, b);
}
GP_INLINE float2 gp_sel2(msk m, float2 a, float2 b)
{
    return (float2){ flt_select(m, a.x, b.x), flt_select(m, a.y, b.y) };
}
GP_INLINE float3 gp_sel3(msk m, float3 a, float3 b)
{
    return (float3){ flt_select(m, a.x, b.x), flt_select(m, a.y, b.y), flt_select(m, a.z, b.z) };
}
GP_INLINE float4 gp_sel4(msk m, float4 a, float4 b)
{
    return (float4){ flt_select(m, a.x, b.x), flt_select(m, a.y, b.y), flt_select(m, a.z, b.z),
                     flt_select(m, a.w, b.w) };
}
/* sel(mask, a, b) = mask ? a : b, lane by lane, of the width of a; mask is a comparison of flt */
#define sel(m, a, b)                                                                               \
    (GP_SAY(GP_WIDTH(m) == 5, "sel(mask, a, b): mask must be a comparison of flt"),                \
     GP_WANT2("sel(mask, a, b)", a, b), GP_BY_WIDTH(gp_sel, a)(m, a, gp_as(a, b)))

/* any(mask): whether a lane is true. To leave a loop whose further turns would change nothing, and
 * for nothing else: which pixels share a packet is the executor's business. */
#define any(m) msk_any(m)

/* loop_while(turns, mask): a loop of the machine (rep and break_comp of model 3), which is left
 * where the mask is false in all lanes, and after so many turns, at most 255, in any case. What
 * `any` asks for holds. Its slots are counted once, and not for every turn as those of C's loops
 * are. */
#define loop_while(turns, m)                                                                       \
    for (int GP_UNIQUE(gp_turn) = 0; GP_UNIQUE(gp_turn) < (turns) && msk_any(m);                   \
         GP_UNIQUE(gp_turn)++)
#define GP_UNIQUE(name)            GP_UNIQUE_LINE(name, __LINE__)
#define GP_UNIQUE_LINE(name, line) GP_UNIQUE_PASTE(name, line)
#define GP_UNIQUE_PASTE(a, b)      a##_##b

/* Dot products: summed left to right. */
GP_INLINE flt dp2(float2 a, float2 b)
{
    return a.x * b.x + a.y * b.y;
}
GP_INLINE flt dp2add(float2 a, float2 b, flt c)
{
    return a.x * b.x + a.y * b.y + c;
}
GP_INLINE flt dp3(float3 a, float3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
GP_INLINE flt dp4(float4 a, float4 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
GP_INLINE float3 crs(float3 a, float3 b)
{
    return (float3){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

/* --- one-argument functions ------------------------------------------------------------------- */

#ifdef GP_SHADER_SW
GP_INLINE flt rcp(flt a)
{
    return math_rcp(a);
}
GP_INLINE flt gp_rsq_lanes(flt a)
{
    return math_rsq(a);
}
#else
#define GP_LARGEST 3.40282346638528859812e+38f
/* 1 / a; never infinite, but in software profiles. */
GP_INLINE flt rcp(flt a)
{
    return math_between(math_rcp(a), -GP_LARGEST, GP_LARGEST);
}
GP_INLINE flt gp_rsq_lanes(flt a)
{
    return flt_lesser(flt_set(GP_LARGEST), math_rsq(a)); /* NaN passes */
}
#endif
/* 1 / sqrt |a|, with the same bound. */
GP_INLINE flt rsq(flt a)
{
    return gp_rsq_lanes(flt_abs(a));
}

GP_INLINE flt exp_(flt a) /* 2^a */
{
    return math_exp2_mostly_normal(a);
}
GP_INLINE flt log_(flt a) /* log2 |a|; log of 0 is -FLT_MAX */
{
    return math_log2_d3d(a);
}
GP_INLINE flt pow_(flt a, flt b) /* |a|^b */
{
    return math_pow(flt_abs(a), b);
}
/* Of radians. */
GP_INLINE flt sin_(flt a)
{
    return math_sin(a);
}
/* Of radians. */
GP_INLINE flt cos_(flt a)
{
    return math_cos(a);
}
GP_INLINE float2 sincos_(flt a) /* (cos, sin), as Direct3D's register order */
{
    return (float2){ math_cos(a), math_sin(a) };
}
/* Correctly rounded. */
GP_INLINE flt sqrt_(flt a)
{
    return flt_sqrt(a);
}
GP_INLINE flt sgn(flt a) /* -1, 0, 1; NaN gives 0 */
{
    return flt_select(a > 0.0f, flt_set(1), flt_select(a < 0.0f, flt_set(-1), flt_set(0)));
}

/* A sum of squares has no sign to take away: NaN's means nothing. */
GP_INLINE float2 gp_nrm2(float2 v)
{
    return mul(v, gp_rsq_lanes(dp2(v, v)));
}
GP_INLINE float3 gp_nrm3(float3 v)
{
    return mul(v, gp_rsq_lanes(dp3(v, v)));
}
GP_INLINE float4 gp_nrm4(float4 v) /* by the length of xyz; w is scaled too */
{
    return mul(v, gp_rsq_lanes(v.x * v.x + v.y * v.y + v.z * v.z));
}
/* nrm(v): v over its length, and of a float4 over that of its xyz */
#define nrm(v)                                                                                     \
    (GP_SAY(GP_WIDTH(v) % 5 > 1, "nrm(v): v must be a float2, a float3 or a float4"),              \
     _Generic((v), float2                                                                          \
              : gp_nrm2, float3                                                                    \
              : gp_nrm3, default                                                                   \
              : gp_nrm4)(v))

/* lit and dst: CONVENTIONS.md, "Instructions", has the formulas. */
GP_INLINE float4 lit(flt n_l, flt n_h, flt power)
{
    flt clamped = gp_min_lanes(gp_max_lanes(power, flt_set(-127.9961f)), flt_set(127.9961f));
    flt lobe = flt_select((msk)(n_l > 0.0f) & (msk)(n_h > 0.0f), pow_(n_h, clamped), flt_set(0));
    return (float4){ flt_set(1), gp_max_lanes(n_l, flt_set(0)), lobe, flt_set(1) };
}
GP_INLINE float4 dst(float4 a, float4 b)
{
    return (float4){ flt_set(1), a.y * b.y, a.z, b.w };
}

/* --- matrices: rows of float, columns are vectors, result = M v ------------------------------- */

GP_INLINE flt gp_row3(float3 v, const float row[4])
{
    return v.x * row[0] + v.y * row[1] + v.z * row[2] + row[3];
}
GP_INLINE flt gp_row4(float4 v, const float row[4])
{
    return v.x * row[0] + v.y * row[1] + v.z * row[2] + v.w * row[3];
}
GP_INLINE float4 gp_m4x4_3(float3 v, const float m[4][4])
{
    return (float4){ gp_row3(v, m[0]), gp_row3(v, m[1]), gp_row3(v, m[2]), gp_row3(v, m[3]) };
}
GP_INLINE float4 gp_m4x4_4(float4 v, const float m[4][4])
{
    return (float4){ gp_row4(v, m[0]), gp_row4(v, m[1]), gp_row4(v, m[2]), gp_row4(v, m[3]) };
}
/* m4x4(v, m): a float3 is a point, w = 1 */
#define m4x4(v, m)                                                                                 \
    (GP_SAY(GP_WIDTH(v) % 5 > 2, "m4x4(v, m): v must be a float3 or a float4"),                    \
     _Generic((v), float3                                                                          \
              : gp_m4x4_3, default                                                                 \
              : gp_m4x4_4)(v, m))

GP_INLINE float3 gp_m4x3_3(float3 v, const float m[4][4])
{
    return (float3){ gp_row3(v, m[0]), gp_row3(v, m[1]), gp_row3(v, m[2]) };
}
GP_INLINE float3 gp_m4x3_4(float4 v, const float m[4][4])
{
    return (float3){ gp_row4(v, m[0]), gp_row4(v, m[1]), gp_row4(v, m[2]) };
}
/* m4x3(v, m): the upper three rows */
#define m4x3(v, m)                                                                                 \
    (GP_SAY(GP_WIDTH(v) % 5 > 2, "m4x3(v, m): v must be a float3 or a float4"),                    \
     _Generic((v), float3                                                                          \
              : gp_m4x3_3, default                                                                 \
              : gp_m4x3_4)(v, m))

/* m3x3(v, m): the upper left 3x3, for directions */
GP_INLINE float3 m3x3(float3 v, const float m[4][4])
{
    return (float3){ v.x * m[0][0] + v.y * m[0][1] + v.z * m[0][2],
                     v.x * m[1][0] + v.y * m[1][1] + v.z * m[1][2],
                     v.x * m[2][0] + v.y * m[2][1] + v.z * m[2][2] };
}

/* --- building and taking apart ---------------------------------------------------------------- */

/* The first components. */
GP_INLINE float2 xy(float4 a)
{
    return (float2){ a.x, a.y };
}
/* The first components. */
GP_INLINE float3 xyz(float4 a)
{
    return (float3){ a.x, a.y, a.z };
}
#define gp_lane(a)                                                                                 \
    (GP_SAY(GP_WIDTH(a) < 2, "rgba, vec2, vec3, vec4: each component must be a flt or a number"),  \
     _Generic((a), flt                                                                             \
              : gp_same1, default                                                                  \
              : bcast)(a))
/* rgba(color, alpha), and vec2..vec4 from flt or C numbers */
#define rgba(color, alpha) gp_rgba(color, gp_lane(alpha))
#define vec2(a, b)         ((float2){ gp_lane(a), gp_lane(b) })
#define vec3(a, b, c)      ((float3){ gp_lane(a), gp_lane(b), gp_lane(c) })
#define vec4(a, b, c, d)   ((float4){ gp_lane(a), gp_lane(b), gp_lane(c), gp_lane(d) })
GP_INLINE float4 gp_rgba(float3 color, flt alpha)
{
    return (float4){ color.x, color.y, color.z, alpha };
}

/* --- being looked at -------------------------------------------------------------------------- */

/* Names a value, a flt or a vector, for who looks at a shader's steps (steps.h); in a loop once a
 * turn. Where pixels are drawn it computes nothing. */
#define watch(name, value) ((void)sizeof(value))

#endif
