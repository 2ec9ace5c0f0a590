/* The shader language: include this, and nothing else, in a shader file.
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
 *   program(name, vs, ps, declarations...)           ends the file; defines GpProgram name
 *   depth_program(name, vs, declarations...)         the same without a pixel shader
 *
 * Helpers that read textures take `GpInvocation *gp`. Shaders are pure: no statics, no libm, no
 * allocation, no branches on lane values (select instead). Loops have constant bounds, and may be left
 * where no lane changes any more: while (.. && any(mask)).
 *
 * #define GP_SHADER_PAIRS before the include where pixel shaders are long chains of arithmetic, each
 * step waiting for the one before: two packets then go through side by side. It changes no bit, costs
 * registers, and gains nothing across texture reads.
 *
 * #define GP_SHADER_SW before the include for the software profiles, in which rcp(0) and rsq(0) are
 * infinite instead of the largest float.
 */
#ifndef GP_SHADER_H
#define GP_SHADER_H

#include "pipeline/shader/program.h"

#ifdef __cplusplus
#include "pipeline/shader/counting.hpp"
#else

#include "pipeline/base/detmath.h"

typedef struct float2 {
    flt x, y;
} float2;
typedef struct float3 {
    flt x, y, z;
} float3;
typedef struct float4 {
    flt x, y, z, w;
} float4;

/* One packet of one call: what the vocabulary needs beside its operands. */
typedef struct GpInvocation {
    const GpShaderCall *call;
    int packet;
    msk killed;
    flt depth;
} GpInvocation;

/* --- constants into lanes ----------------------------------------------------------------------- */

GP_INLINE flt bcast(float value)
{
    return flt_set(value);
}

GP_INLINE float2 u2(const float *value)
{
    return (float2){ flt_set(value[0]), flt_set(value[1]) };
}

GP_INLINE float3 u3(const float *value)
{
    return (float3){ flt_set(value[0]), flt_set(value[1]), flt_set(value[2]) };
}

GP_INLINE float4 u4(const float *value)
{
    return (float4){ flt_set(value[0]), flt_set(value[1]), flt_set(value[2]), flt_set(value[3]) };
}

/* --- widening: `gp_as(a, b)` is b with the type of a --------------------------------------------- */

GP_INLINE float2 sp2(flt a)
{
    return (float2){ a, a };
}

GP_INLINE float3 sp3(flt a)
{
    return (float3){ a, a, a };
}

GP_INLINE float4 sp4(flt a)
{
    return (float4){ a, a, a, a };
}

GP_INLINE flt gp_same1(flt a)
{
    return a;
}
GP_INLINE float2 gp_same2(float2 a)
{
    return a;
}
GP_INLINE float3 gp_same3(float3 a)
{
    return a;
}
GP_INLINE float4 gp_same4(float4 a)
{
    return a;
}
GP_INLINE float2 gp_number2(float a)
{
    return sp2(flt_set(a));
}
GP_INLINE float3 gp_number3(float a)
{
    return sp3(flt_set(a));
}
GP_INLINE float4 gp_number4(float a)
{
    return sp4(flt_set(a));
}

#define gp_as(a, b)                                                                                \
    _Generic((a), flt                                                                              \
             : _Generic((b), flt                                                                   \
                        : gp_same1, default                                                        \
                        : bcast),                                                                  \
               float2                                                                              \
             : _Generic((b), float2                                                                \
                        : gp_same2, flt                                                            \
                        : sp2, default                                                             \
                        : gp_number2),                                                             \
               float3                                                                              \
             : _Generic((b), float3                                                                \
                        : gp_same3, flt                                                            \
                        : sp3, default                                                             \
                        : gp_number3),                                                             \
               float4                                                                              \
             : _Generic((b), float4                                                                \
                        : gp_same4, flt                                                            \
                        : sp4, default                                                             \
                        : gp_number4))(b)

#define GP_BY_WIDTH(name, a)                                                                       \
    _Generic((a), flt : name##1, float2 : name##2, float3 : name##3, float4 : name##4)

/* Defines name1..name4 from a function of one, two or three flt, component by component. */
#define GP_MAP1(name, f)                                                                           \
    GP_INLINE flt name##1(flt a)                                                                   \
    {                                                                                              \
        return f(a);                                                                               \
    }                                                                                              \
    GP_INLINE float2 name##2(float2 a)                                                             \
    {                                                                                              \
        return (float2){ f(a.x), f(a.y) };                                                         \
    }                                                                                              \
    GP_INLINE float3 name##3(float3 a)                                                             \
    {                                                                                              \
        return (float3){ f(a.x), f(a.y), f(a.z) };                                                 \
    }                                                                                              \
    GP_INLINE float4 name##4(float4 a)                                                             \
    {                                                                                              \
        return (float4){ f(a.x), f(a.y), f(a.z), f(a.w) };                                         \
    }

#define GP_MAP2(name, f)                                                                           \
    GP_INLINE flt name##1(flt a, flt b)                                                            \
    {                                                                                              \
        return f(a, b);                                                                            \
    }                                                                                              \
    GP_INLINE float2 name##2(float2 a, float2 b)                                                   \
    {                                                                                              \
        return (float2){ f(a.x, b.x), f(a.y, b.y) };                                               \
    }                                                                                              \
    GP_INLINE float3 name##3(float3 a, float3 b)                                                   \
    {                                                                                              \
        return (float3){ f(a.x, b.x), f(a.y, b.y), f(a.z, b.z) };                                  \
    }                                                                                              \
    GP_INLINE float4 name##4(float4 a, float4 b)                                                   \
    {                                                                                              \
        return (float4){ f(a.x, b.x), f(a.y, b.y), f(a.z, b.z), f(a.w, b.w) };                     \
    }

#define GP_MAP3(name, f)                                                                           \
    GP_INLINE flt name##1(flt a, flt b, flt c)                                                     \
    {                                                                                              \
        return f(a, b, c);                                                                         \
    }                                                                                              \
    GP_INLINE float2 name##2(float2 a, float2 b, float2 c)                                         \
    {                                                                                              \
        return (float2){ f(a.x, b.x, c.x), f(a.y, b.y, c.y) };                                     \
    }                                                                                              \
    GP_INLINE float3 name##3(float3 a, float3 b, float3 c)                                         \
    {                                                                                              \
        return (float3){ f(a.x, b.x, c.x), f(a.y, b.y, c.y), f(a.z, b.z, c.z) };                   \
    }                                                                                              \
    GP_INLINE float4 name##4(float4 a, float4 b, float4 c)                                         \
    {                                                                                              \
        return (float4){ f(a.x, b.x, c.x), f(a.y, b.y, c.y), f(a.z, b.z, c.z), f(a.w, b.w, c.w) }; \
    }

/* --- arithmetic ------------------------------------------------------------------------------------ */

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
    return flt_lesser_number(a, b);
}
GP_INLINE flt gp_max_lanes(flt a, flt b)
{
    return flt_greater_number(a, b);
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

#define add(a, b)    GP_BY_WIDTH(gp_add, a)(a, gp_as(a, b))
#define sub(a, b)    GP_BY_WIDTH(gp_sub, a)(a, gp_as(a, b))
#define mul(a, b)    GP_BY_WIDTH(gp_mul, a)(a, gp_as(a, b))
#define min(a, b)    GP_BY_WIDTH(gp_min, a)(a, gp_as(a, b))
#define max(a, b)    GP_BY_WIDTH(gp_max, a)(a, gp_as(a, b))
#define slt(a, b)    GP_BY_WIDTH(gp_slt, a)(a, gp_as(a, b))
#define sge(a, b)    GP_BY_WIDTH(gp_sge, a)(a, gp_as(a, b))
#define mad(a, b, c) GP_BY_WIDTH(gp_mad, a)(a, gp_as(a, b), gp_as(a, c))
/* lrp(t, a, b) = t*(a-b) + b, of the width of a */
#define lrp(t, a, b) GP_BY_WIDTH(gp_lrp, a)(gp_as(a, t), a, gp_as(a, b))
/* cmp(s, a, b) = s >= 0 ? a : b, of the width of a */
#define cmp(s, a, b) GP_BY_WIDTH(gp_cmp, a)(gp_as(a, s), a, gp_as(a, b))
#define sat(a)       GP_BY_WIDTH(gp_sat, a)(a)
#define neg(a)       GP_BY_WIDTH(gp_neg, a)(a)
#define abs_(a)      GP_BY_WIDTH(gp_abs, a)(a)
#define frc(a)       GP_BY_WIDTH(gp_frc, a)(a)
#define floor_(a)    GP_BY_WIDTH(gp_floor, a)(a)

/* condition ? a : b, lane by lane; condition is a comparison of flt */
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
#define sel(m, a, b) GP_BY_WIDTH(gp_sel, a)(m, a, gp_as(a, b))

/* any(mask): whether a lane is true. To leave a loop whose further turns would change nothing, and
 * for nothing else: which pixels share a packet is the executor's business. */
#define any(m)       msk_any(m)

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

/* --- one-argument functions ----------------------------------------------------------------------- */

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
GP_INLINE flt rcp(flt a)
{
    return math_between(math_rcp(a), -GP_LARGEST, GP_LARGEST);
}
GP_INLINE flt gp_rsq_lanes(flt a)
{
    return flt_lesser(flt_set(GP_LARGEST), math_rsq(a)); /* NaN passes */
}
#endif
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
GP_INLINE flt sin_(flt a)
{
    return math_sin(a);
}
GP_INLINE flt cos_(flt a)
{
    return math_cos(a);
}
GP_INLINE float2 sincos_(flt a) /* (cos, sin), as Direct3D's register order */
{
    return (float2){ math_cos(a), math_sin(a) };
}
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
#define nrm(v)             _Generic((v), float2 : gp_nrm2, float3 : gp_nrm3, float4 : gp_nrm4)(v)

/* lit and dst, component by component as Direct3D's table A4 gives them. */
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

/* --- matrices: rows of float, columns are vectors, result = M v ------------------------------------ */

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
#define m4x4(v, m)         _Generic((v), float3 : gp_m4x4_3, float4 : gp_m4x4_4)(v, m)

GP_INLINE float3 gp_m4x3_3(float3 v, const float m[4][4])
{
    return (float3){ gp_row3(v, m[0]), gp_row3(v, m[1]), gp_row3(v, m[2]) };
}
GP_INLINE float3 gp_m4x3_4(float4 v, const float m[4][4])
{
    return (float3){ gp_row4(v, m[0]), gp_row4(v, m[1]), gp_row4(v, m[2]) };
}
/* m4x3(v, m): the upper three rows */
#define m4x3(v, m)         _Generic((v), float3 : gp_m4x3_3, float4 : gp_m4x3_4)(v, m)

/* m3x3(v, m): the upper left 3x3, for directions */
GP_INLINE float3 m3x3(float3 v, const float m[4][4])
{
    return (float3){ v.x * m[0][0] + v.y * m[0][1] + v.z * m[0][2],
                     v.x * m[1][0] + v.y * m[1][1] + v.z * m[1][2],
                     v.x * m[2][0] + v.y * m[2][1] + v.z * m[2][2] };
}

/* --- building and taking apart ---------------------------------------------------------------------- */

GP_INLINE float2 xy(float4 a)
{
    return (float2){ a.x, a.y };
}
GP_INLINE float3 xyz(float4 a)
{
    return (float3){ a.x, a.y, a.z };
}
#define gp_lane(a)         _Generic((a), flt : gp_same1, default : bcast)(a)
/* rgba(color, alpha), and vec2..vec4 from flt or C numbers */
#define rgba(color, alpha) gp_rgba(color, gp_lane(alpha))
#define vec2(a, b)         ((float2){ gp_lane(a), gp_lane(b) })
#define vec3(a, b, c)      ((float3){ gp_lane(a), gp_lane(b), gp_lane(c) })
#define vec4(a, b, c, d)   ((float4){ gp_lane(a), gp_lane(b), gp_lane(c), gp_lane(d) })
GP_INLINE float4 gp_rgba(float3 color, flt alpha)
{
    return (float4){ color.x, color.y, color.z, alpha };
}

/* --- derivatives: differences inside the 2x2 quad -------------------------------------------------- */

GP_MAP1(gp_dsx, flt_quad_dx)
GP_MAP1(gp_dsy, flt_quad_dy)
#define dsx(a)             GP_BY_WIDTH(gp_dsx, a)(a)
#define dsy(a)             GP_BY_WIDTH(gp_dsy, a)(a)

/* --- textures --------------------------------------------------------------------------------------- */

GP_INLINE float4 gp_read_texture(GpInvocation *gp, int slot, GpLodMode mode, float4 coord,
                                 float4 gradient)
{
    float4 texel;
    GpTextureRead read = { slot,
                           GP_LANES,
                           mode,
                           (const float *)&coord,
                           mode == GP_LOD_GRADIENT ? (const float *)&gradient : 0,
                           (float *)&texel };
    gp->call->read_texture(gp->call, &read);
    return texel;
}

GP_INLINE float4 gp_coord2(float2 a)
{
    return (float4){ a.x, a.y, flt_set(0), flt_set(0) };
}
GP_INLINE float4 gp_coord3(float3 a)
{
    return (float4){ a.x, a.y, a.z, flt_set(0) };
}
#define gp_coord(a)        _Generic((a), float2 : gp_coord2, float3 : gp_coord3, float4 : gp_same4)(a)

GP_INLINE float4 gp_project(float4 a)
{
    return (float4){ a.x / a.w, a.y / a.w, a.z / a.w, flt_set(0) };
}

/* texld(slot, uv)        level from the quad; a float3's z is the reference of a depth compare
 * texldp(slot, uvrw)     u, v, r divided by w first
 * texldb(slot, uvrw)     level + w
 * texldl(slot, uvrw)     level w; the only read a vertex shader may do
 * texldd(slot, uv, dx, dy)   level from the float2 derivatives of u and v */
#define texld(slot, a)     gp_read_texture(gp, slot, GP_LOD_IMPLICIT, gp_coord(a), sp4(bcast(0)))
#define texldp(slot, a)    gp_read_texture(gp, slot, GP_LOD_IMPLICIT, gp_project(a), sp4(bcast(0)))
#define texldb(slot, a)    gp_read_texture(gp, slot, GP_LOD_BIAS, a, sp4(bcast(0)))
#define texldl(slot, a)    gp_read_texture(gp, slot, GP_LOD_EXPLICIT, a, sp4(bcast(0)))
#define texldd(slot, a, dx, dy)                                                                    \
    gp_read_texture(gp, slot, GP_LOD_GRADIENT, gp_coord(a),                                        \
                    (float4){ (dx).x, (dx).y, (dy).x, (dy).y })

/* gp_load_local(slot): the texel at the pixel's own position in a surface that an earlier pass of
 * the same size rendered. */
GP_INLINE float4 gp_read_local(GpInvocation *gp, int slot)
{
    float4 texel;
    gp->call->read_local(gp->call, slot, gp->packet, GP_LANES, (float *)&texel);
    return texel;
}
#define gp_load_local(slot) gp_read_local(gp, slot)

/* --- pixels ----------------------------------------------------------------------------------------- */

/* Kills the lanes of a mask; texkill: those in which any of x, y, z is below 0 (CHOOSE). */
#define discard(mask)       ((void)(gp->killed |= (msk)(mask)))
GP_INLINE msk gp_kill1(flt a)
{
    return a < 0.0f;
}
GP_INLINE msk gp_kill2(float2 a)
{
    return (msk)(a.x < 0.0f) | (msk)(a.y < 0.0f);
}
GP_INLINE msk gp_kill3(float3 a)
{
    return (msk)(a.x < 0.0f) | (msk)(a.y < 0.0f) | (msk)(a.z < 0.0f);
}
GP_INLINE msk gp_kill4(float4 a)
{
    return gp_kill3(xyz(a));
}
#define texkill(a)          discard(GP_BY_WIDTH(gp_kill, a)(a))
#define odepth(value)       ((void)(gp->depth = (value)))

/* vpos: the pixel's x and y as integers (vPos); vface: +1 clockwise (front), -1 (vFace). */
GP_INLINE float2 gp_vpos(const GpInvocation *gp)
{
    return ((const float2 *)(const void *)gp->call->pixel)[gp->packet];
}
GP_INLINE flt gp_vface(const GpInvocation *gp)
{
    return ((const flt *)(const void *)gp->call->face)[gp->packet];
}
#define vpos()              gp_vpos(gp)
#define vface()             gp_vface(gp)

/* --- shader functions and programs ----------------------------------------------------------------- */

#define GP_VERTEX_PACKETS(name, U, IN, varyings)                                                   \
    for (int k = 0; k < call->packets; k++) {                                                      \
        GpInvocation invocation = { .call = call, .packet = k };                                   \
        flt size = flt_set(1);                                                                     \
        name##_body(&invocation, (const U *)call->uniforms,                                        \
                    (const IN *)(const void *)call->in + k, (float4 *)(void *)call->position + k,  \
                    varyings, &size);                                                              \
        if (call->point_size)                                                                      \
            ((flt *)(void *)call->point_size)[k] = size;                                           \
    }

/* The loop over packets and the inlined body live together in the shader's object file: calling a
 * shader costs one indirect call a block. */
#define vertex_shader(name, U, IN, OUT)                                                            \
    enum {                                                                                         \
        name##_in = sizeof(IN) / sizeof(flt),                                                      \
        name##_out = sizeof(OUT) / sizeof(flt),                                                    \
        name##_uniforms = sizeof(U)                                                                \
    };                                                                                             \
    GP_INLINE void name##_body(GpInvocation *gp, const U *c, const IN *in, float4 *position,       \
                               OUT *out, flt *point_size);                                         \
    static void name(const GpShaderCall *call)                                                     \
    {                                                                                              \
        OUT *out = (OUT *)(void *)call->varying;                                                   \
        if (out) {                                                                                 \
            GP_VERTEX_PACKETS(name, U, IN, &out[k])                                                \
        } else { /* positions only: what nobody asks for is left out by the compiler */            \
            OUT unused;                                                                            \
            GP_VERTEX_PACKETS(name, U, IN, &unused)                                                \
        }                                                                                          \
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

#ifndef GP_SHADER_PAIRS
#define GP_PIXEL_PACKETS(name, U, OUT)                                                             \
    for (int k = 0; k < call->packets; k++) {                                                      \
        GpInvocation invocation = { .call = call, .packet = k };                                   \
        name##_body(&invocation, (const U *)call->uniforms, in + k, out + k);                      \
        gp_end_packet(&invocation);                                                                \
    }
#else
#define GP_PIXEL_PACKETS(name, U, OUT)                                                             \
    for (int k = 0; k < call->packets; k += 2) {                                                   \
        const int l = k + 1 < call->packets ? k + 1 : k; /* the odd last one, once more */         \
        GpInvocation left = { .call = call, .packet = k }, right = { .call = call, .packet = l };  \
        OUT left_out, right_out;                                                                   \
        name##_body(&left, (const U *)call->uniforms, in + k, &left_out);                          \
        name##_body(&right, (const U *)call->uniforms, in + l, &right_out);                        \
        out[k] = left_out;                                                                         \
        out[l] = right_out;                                                                        \
        gp_end_packet(&left);                                                                      \
        gp_end_packet(&right);                                                                     \
    }
#endif

#define pixel_shader_targets(name, U, IN, OUT)                                                     \
    enum {                                                                                         \
        name##_in = sizeof(IN) / sizeof(flt),                                                      \
        name##_out = sizeof(OUT) / sizeof(flt),                                                    \
        name##_uniforms = sizeof(U)                                                                \
    };                                                                                             \
    GP_INLINE void name##_body(GpInvocation *gp, const U *c, const IN *in, OUT *out);              \
    static void name(const GpShaderCall *call)                                                     \
    {                                                                                              \
        const IN *in = (const IN *)(const void *)call->in;                                         \
        OUT *out = (OUT *)(void *)call->color;                                                     \
        GP_PIXEL_PACKETS(name, U, OUT)                                                             \
    }                                                                                              \
    GP_INLINE void name##_body(__attribute__((unused)) GpInvocation *gp,                           \
                               __attribute__((unused)) const U *c,                                 \
                               __attribute__((unused)) const IN *in, OUT *out)

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

#if GP_LANES == 4
#define GP_PROGRAM_OF(id, vs, pixel_in, pixel_out, ...)                                            \
    extern const GpProgramCode id##_code8 __attribute__((weak)),                                   \
        id##_code16 __attribute__((weak));                                                         \
    extern void id##_count(GpShaderCounts *, GpShaderCounts *) __attribute__((weak));              \
    extern const GpProgram id;                                                                     \
    const GpProgram id = { .name = #id,                                                            \
                           __VA_ARGS__,                                                            \
                           .uniform_bytes = vs##_uniforms,                                         \
                           .input_components = vs##_in,                                            \
                           .varying_components = vs##_out,                                         \
                           .pixel_input_components = pixel_in,                                     \
                           .color_components = pixel_out,                                          \
                           .code = { &id##_code4, &id##_code8, &id##_code16 },                     \
                           .count = id##_count };
#else
#define GP_PROGRAM_OF(id, vs, pixel_in, pixel_out, ...)
#endif

#define program(id, vs, ps, ...)                                                                   \
    _Static_assert((int)vs##_uniforms == (int)ps##_uniforms,                                       \
                   "both shaders share one uniform struct");                                       \
    _Static_assert((int)vs##_out == (int)ps##_in, "both shaders share one varying struct");        \
    GP_CODE_OF(id, vs, ps)                                                                         \
    GP_PROGRAM_OF(id, vs, ps##_in, ps##_out, __VA_ARGS__)

#define depth_program(id, vs, ...)                                                                 \
    GP_CODE_OF(id, vs, 0)                                                                          \
    GP_PROGRAM_OF(id, vs, 0, 0, __VA_ARGS__)

#endif /* __cplusplus */
#endif
