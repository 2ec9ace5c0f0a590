/* The vocabulary of the shader language in counting lanes: each instruction records itself. The
 * types and names are those of the C vocabulary (types.h, instructions.h). */
#ifndef GP_COUNTING_INSTRUCTIONS_HPP
#define GP_COUNTING_INSTRUCTIONS_HPP

#include "pipeline/shader/graph.h"

#include <cstring>
#include <type_traits>

#define GP_INLINE static inline __attribute__((always_inline, unused))

/* Shader files name their structs as they like, each its own `Varying`; internal linkage keeps what
 * is instantiated for one file from being merged with another file's. */
namespace
{

using flt = GpPart;

struct float2 {
    flt x, y;
};
struct float3 {
    flt x, y, z;
};
struct float4 {
    flt x, y, z, w;
};

/* A mask stands for the value whose sign a cmp would test. */
struct msk {
    flt value;
};

struct GpInvocation {
    flt depth;
};

/* Where a call stands. */
constexpr GpPlace gp_here(const char *of = __builtin_FILE(), int at = __builtin_LINE())
{
    return { of, at };
}

template <class T>
concept Number = std::is_arithmetic_v<T>;
template <class T>
concept Scalar = Number<T> || std::is_same_v<T, flt>;

/* --- constants, widening and recording -------------------------------------------------------- */

/* By reference: where a number stands tells that it is a uniform. */
inline flt bcast(const float &value)
{
    return gp_graph_number(&value);
}

template <Scalar A> flt lane(const A &a)
{
    if constexpr (std::is_same_v<A, float>)
        return bcast(a);
    else if constexpr (Number<A>)
        return bcast(static_cast<float>(a));
    else
        return a;
}

inline float2 u2(const float *v)
{
    return { bcast(v[0]), bcast(v[1]) };
}
inline float3 u3(const float *v)
{
    return { bcast(v[0]), bcast(v[1]), bcast(v[2]) };
}
inline float4 u4(const float *v)
{
    return { bcast(v[0]), bcast(v[1]), bcast(v[2]), bcast(v[3]) };
}

inline float2 sp2(flt a)
{
    return { a, a };
}
inline float3 sp3(flt a)
{
    return { a, a, a };
}
inline float4 sp4(flt a)
{
    return { a, a, a, a };
}

template <class V>
concept Value = std::is_same_v<V, flt> || std::is_same_v<V, float2> || std::is_same_v<V, float3> ||
    std::is_same_v<V, float4>;

template <class V> constexpr int width_of = int(sizeof(V) / sizeof(flt));

template <Value V> GpOperand gp_operand(const V &value)
{
    GpOperand whole = { width_of<V>, {} };
    std::memcpy(whole.part, &value, sizeof value);
    return whole;
}

template <Value V> V gp_first(const GpOperand &whole)
{
    V value;
    std::memcpy(&value, whole.part, sizeof value);
    return value;
}

/* The components of a result. */
template <Value V> V gp_result(int32_t node)
{
    return gp_first<V>(
        { 4, { { node, 0, false }, { node, 1, false }, { node, 2, false }, { node, 3, false } } });
}

/* b as a V: itself, or one scalar in all components. */
template <class V, class B> V widen(const B &b)
{
    static_assert(Value<V>, "a must be a flt or a vector");
    static_assert(std::is_same_v<V, B> || Scalar<B>,
                  "what goes with a must be as wide as a, or a flt, or a number");
    if constexpr (std::is_same_v<V, B>) {
        return b;
    } else {
        flt a = lane(b);
        return gp_first<V>({ 4, { a, a, a, a } });
    }
}

template <class V, class... Operands>
V emit(const GpOp &op, GpStepCode code, GpPlace at, const Operands &...operands)
{
    const GpOperand list[] = { gp_operand(operands)... };
    return gp_result<V>(gp_graph_add(&op, code, at, list, int(sizeof...(operands)), 0));
}

constexpr GpOp gp_each(int slots)
{
    return { slots, slots, false, GP_NODE_ARITHMETIC, false, GP_LOD_IMPLICIT };
}
constexpr GpOp gp_all(int slots)
{
    return { slots, slots, true, GP_NODE_ARITHMETIC, false, GP_LOD_IMPLICIT };
}

constexpr GpOp GP_OP_FREE = gp_each(0), GP_OP_EACH_1 = gp_each(1), GP_OP_EACH_2 = gp_each(2);
constexpr GpOp GP_OP_ALL_1 = gp_all(1), GP_OP_ALL_2 = gp_all(2), GP_OP_ALL_3 = gp_all(3),
               GP_OP_SINCOS = gp_all(8);
constexpr GpOp GP_OP_MIN_MAX = { 2, 1, false, GP_NODE_ARITHMETIC, false, GP_LOD_IMPLICIT };
constexpr GpOp GP_OP_DERIVATIVE = { 2, 2, false, GP_NODE_ARITHMETIC, true, GP_LOD_IMPLICIT };
constexpr GpOp GP_OP_TEXKILL = { 1, 2, true, GP_NODE_KILL, false, GP_LOD_IMPLICIT };
constexpr GpOp GP_OP_LOOP = { 8, 8, true, GP_NODE_LOOP, false, GP_LOD_IMPLICIT };

/* --- arithmetic ------------------------------------------------------------------------------- */

#define GP_TWO_OPERANDS(name, code)                                                                \
    template <class V, class B> V name(V a, const B &b, GpPlace at = gp_here())                    \
    {                                                                                              \
        return emit<V>(GP_OP_EACH_1, code, at, a, widen<V>(b));                                    \
    }
GP_TWO_OPERANDS(add, GP_STEP_ADD)
GP_TWO_OPERANDS(sub, GP_STEP_SUB)
GP_TWO_OPERANDS(mul, GP_STEP_MUL)
GP_TWO_OPERANDS(min, GP_STEP_MIN)
GP_TWO_OPERANDS(max, GP_STEP_MAX)
GP_TWO_OPERANDS(slt, GP_STEP_SLT)
GP_TWO_OPERANDS(sge, GP_STEP_SGE)

template <class V, class B, class C> V mad(V a, const B &b, const C &c, GpPlace at = gp_here())
{
    return emit<V>(GP_OP_EACH_1, GP_STEP_MAD, at, a, widen<V>(b), widen<V>(c));
}
template <class T, class V, class B> V lrp(const T &t, V a, const B &b, GpPlace at = gp_here())
{
    return emit<V>(GP_OP_EACH_2, GP_STEP_LRP, at, widen<V>(t), a, widen<V>(b));
}
template <class S, class V, class B> V cmp(const S &s, V a, const B &b, GpPlace at = gp_here())
{
    return emit<V>(GP_OP_EACH_1, GP_STEP_CMP, at, widen<V>(s), a, widen<V>(b));
}
template <class V, class B> V sel(msk m, V a, const B &b, GpPlace at = gp_here())
{
    return emit<V>(GP_OP_EACH_1, GP_STEP_SEL, at, widen<V>(m.value), a, widen<V>(b));
}

/* A loop that may be left early is counted in full. */
inline bool any(msk m)
{
    return gp_graph_may_hold(m.value);
}

/* rep, break_comp and endrep: counted once. */
inline int gp_turns(int turns)
{
    return gp_graph_is_stepping() ? turns : 1;
}
inline bool gp_goes_on(msk m, GpPlace at = gp_here())
{
    emit<flt>(GP_OP_LOOP, GP_STEP_LOOP, at, m.value);
    return gp_graph_may_hold(m.value);
}
#define loop_while(turns, m)                                                                       \
    for (int GP_UNIQUE(gp_turn) = 0; GP_UNIQUE(gp_turn) < gp_turns(turns) && gp_goes_on(m);        \
         GP_UNIQUE(gp_turn)++)
#define GP_UNIQUE(name)            GP_UNIQUE_LINE(name, __LINE__)
#define GP_UNIQUE_LINE(name, line) GP_UNIQUE_PASTE(name, line)
#define GP_UNIQUE_PASTE(a, b)      a##_##b

template <class V> V neg(V a)
{
    GpOperand whole = gp_operand(a);
    for (flt &part : whole.part)
        part.negated = !part.negated;
    return gp_first<V>(whole);
}
template <class V> V abs_(V a, GpPlace at = gp_here())
{
    return emit<V>(GP_OP_EACH_1, GP_STEP_ABS, at, a);
}
template <class V> V frc(V a, GpPlace at = gp_here())
{
    return emit<V>(GP_OP_EACH_1, GP_STEP_FRC, at, a);
}
template <class V> V floor_(V a, GpPlace at = gp_here())
{
    return emit<V>(GP_OP_EACH_2, GP_STEP_FLOOR, at, a);
}
template <class V> V sat(V a, GpPlace at = gp_here())
{
    if (gp_graph_is_vertex())
        return emit<V>(gp_graph_is_model2() ? GP_OP_MIN_MAX : GP_OP_EACH_1, GP_STEP_SAT, at, a);
    bool computed = true;
    const GpOperand whole = gp_operand(a);
    for (int i = 0; i < whole.width; i++)
        computed = computed && gp_graph_kind(whole.part[i]) == GP_NODE_ARITHMETIC &&
                   !whole.part[i].negated;
    if (computed && !gp_graph_is_stepping())
        return a;
    return emit<V>(computed ? GP_OP_FREE : GP_OP_EACH_1, GP_STEP_SAT, at, a);
}

inline flt dp2(float2 a, float2 b, GpPlace at = gp_here())
{
    return emit<flt>(GP_OP_ALL_2, GP_STEP_DP2, at, a, b);
}
inline flt dp2add(float2 a, float2 b, flt c, GpPlace at = gp_here())
{
    return emit<flt>(GP_OP_ALL_2, GP_STEP_DP2ADD, at, a, b, c);
}
inline flt dp3(float3 a, float3 b, GpPlace at = gp_here())
{
    return emit<flt>(GP_OP_ALL_1, GP_STEP_DP3, at, a, b);
}
inline flt dp4(float4 a, float4 b, GpPlace at = gp_here())
{
    return emit<flt>(GP_OP_ALL_1, GP_STEP_DP4, at, a, b);
}
inline float3 crs(float3 a, float3 b, GpPlace at = gp_here())
{
    return emit<float3>(GP_OP_ALL_2, GP_STEP_CRS, at, a, b);
}

/* --- infix, on flt and numbers ---------------------------------------------------------------- */

/* A side of an infix operator, with the place of the operator, which has no arguments of its
 * own. */
struct GpSide {
    flt value;
    bool is_number;
    float number;
    GpPlace at;

    GpSide(flt a, const char *file = __builtin_FILE(), int line = __builtin_LINE())
        : value(a), is_number(false), number(0), at{ file, line }
    {
    }
    template <Number A>
    GpSide(const A &a, const char *file = __builtin_FILE(), int line = __builtin_LINE())
        : value(lane(a)), is_number(true), number(static_cast<float>(a)), at{ file, line }
    {
    }
    bool is(float other) const
    {
        return is_number && number == other;
    }
};

inline flt operator-(flt a)
{
    return neg(a);
}
#define GP_INFIX(op, name)                                                                         \
    inline flt operator op(const GpSide &a, const GpSide &b)                                       \
    {                                                                                              \
        return name(a.value, b.value, a.at);                                                       \
    }                                                                                              \
    inline flt &operator op##=(flt &a, const GpSide &b)                                            \
    {                                                                                              \
        return a = name(a, b.value, b.at);                                                         \
    }
inline flt gp_divide(flt a, flt b, GpPlace at)
{
    if (gp_graph_is_stepping())
        return emit<flt>(GP_OP_ALL_2, GP_STEP_DIV, at, a, b);
    return mul(a, emit<flt>(GP_OP_ALL_1, GP_STEP_RCP, at, b));
}
GP_INFIX(+, add)
GP_INFIX(-, sub)
GP_INFIX(*, mul)
inline flt operator/(const GpSide &a, const GpSide &b)
{
    if (a.is(1) && !gp_graph_is_stepping())
        return emit<flt>(GP_OP_ALL_1, GP_STEP_RCP, a.at, b.value);
    return gp_divide(a.value, b.value, a.at);
}
inline flt &operator/=(flt &a, const GpSide &b)
{
    return a = gp_divide(a, b.value, b.at);
}

/* A comparison is the difference of its sides; against 0 that is the side itself. */
inline flt gp_difference(const GpSide &a, const GpSide &b)
{
    return b.is(0) ? a.value : a.is(0) ? b.value : sub(a.value, b.value);
}
#define GP_COMPARISON(op, code, tested)                                                            \
    inline msk operator op(const GpSide &a, const GpSide &b)                                       \
    {                                                                                              \
        if (gp_graph_is_stepping())                                                                \
            return { emit<flt>(a.is(0) || b.is(0) ? GP_OP_FREE : GP_OP_EACH_1, code, a.at,         \
                               a.value, b.value) };                                                \
        flt d = gp_difference(a, b);                                                               \
        return { tested };                                                                         \
    }
GP_COMPARISON(<, GP_STEP_LESS, d)
GP_COMPARISON(<=, GP_STEP_LESS_EQUAL, d)
GP_COMPARISON(>, GP_STEP_GREATER, d)
GP_COMPARISON(>=, GP_STEP_GREATER_EQUAL, d)
GP_COMPARISON(==, GP_STEP_EQUAL, mul(d, d))
GP_COMPARISON(!=, GP_STEP_NOT_EQUAL, mul(d, d))

/* A side of an operator of masks, likewise. */
struct GpMaskSide {
    flt value;
    GpPlace at;

    GpMaskSide(msk a, const char *file = __builtin_FILE(), int line = __builtin_LINE())
        : value(a.value), at{ file, line }
    {
    }
};
#define GP_MASK_OPERATOR(op, code)                                                                 \
    inline msk operator op(const GpMaskSide &a, const GpMaskSide &b)                               \
    {                                                                                              \
        return { emit<flt>(GP_OP_EACH_1, code, a.at, a.value, b.value) };                          \
    }
GP_MASK_OPERATOR(&, GP_STEP_AND)
GP_MASK_OPERATOR(|, GP_STEP_OR)
GP_MASK_OPERATOR(^, GP_STEP_XOR)
inline msk operator~(const GpMaskSide &a)
{
    return { emit<flt>(GP_OP_EACH_1, GP_STEP_NOT, a.at, a.value) };
}

/* --- one-argument functions ------------------------------------------------------------------- */

#define GP_FUNCTION(name, op, code)                                                                \
    inline flt name(flt a, GpPlace at = gp_here())                                                 \
    {                                                                                              \
        return emit<flt>(op, code, at, a);                                                         \
    }
GP_FUNCTION(rcp, GP_OP_ALL_1, GP_STEP_RCP)
GP_FUNCTION(rsq, GP_OP_ALL_1, GP_STEP_RSQ)
GP_FUNCTION(exp_, GP_OP_ALL_1, GP_STEP_EXP)
GP_FUNCTION(log_, GP_OP_ALL_1, GP_STEP_LOG)
GP_FUNCTION(sqrt_, GP_OP_ALL_2, GP_STEP_SQRT)
GP_FUNCTION(sgn, GP_OP_ALL_3, GP_STEP_SGN)
GP_FUNCTION(sin_, GP_OP_SINCOS, GP_STEP_SIN)
GP_FUNCTION(cos_, GP_OP_SINCOS, GP_STEP_COS)

inline float2 sincos_(flt a, GpPlace at = gp_here())
{
    return emit<float2>(GP_OP_SINCOS, GP_STEP_SINCOS, at, a);
}
inline flt pow_(flt a, flt b, GpPlace at = gp_here())
{
    return emit<flt>(GP_OP_ALL_3, GP_STEP_POW, at, a, b);
}
template <class V> V nrm(V v, GpPlace at = gp_here())
{
    static_assert(width_of<V> > 1, "nrm takes a vector");
    return emit<V>(GP_OP_ALL_3, GP_STEP_NRM, at, v);
}
inline float4 lit(flt n_l, flt n_h, flt power, GpPlace at = gp_here())
{
    return emit<float4>(GP_OP_ALL_3, GP_STEP_LIT, at, n_l, n_h, power);
}
inline float4 dst(float4 a, float4 b, GpPlace at = gp_here())
{
    return emit<float4>(GP_OP_EACH_1, GP_STEP_DST, at, a, b);
}

/* --- matrices: one dot product a row; the w of a point is 1 ----------------------------------- */

template <class V> flt row4(V v, const float row[4], GpPlace at)
{
    static_assert(width_of<V> >= 3, "a point of three or four components");
    return emit<flt>(GP_OP_ALL_1, GP_STEP_ROW, at, v, u4(row));
}
template <class V> float4 m4x4(V v, const float m[4][4], GpPlace at = gp_here())
{
    return { row4(v, m[0], at), row4(v, m[1], at), row4(v, m[2], at), row4(v, m[3], at) };
}
template <class V> float3 m4x3(V v, const float m[4][4], GpPlace at = gp_here())
{
    return { row4(v, m[0], at), row4(v, m[1], at), row4(v, m[2], at) };
}
inline float3 m3x3(float3 v, const float m[4][4], GpPlace at = gp_here())
{
    return { dp3(v, u3(m[0]), at), dp3(v, u3(m[1]), at), dp3(v, u3(m[2]), at) };
}

/* --- building and taking apart ---------------------------------------------------------------- */

inline float2 xy(float4 a)
{
    return { a.x, a.y };
}
inline float3 xyz(float4 a)
{
    return { a.x, a.y, a.z };
}
template <Scalar A> float4 rgba(float3 color, const A &alpha)
{
    return { color.x, color.y, color.z, lane(alpha) };
}
template <Scalar A, Scalar B> float2 vec2(const A &a, const B &b)
{
    return { lane(a), lane(b) };
}
template <Scalar A, Scalar B, Scalar C> float3 vec3(const A &a, const B &b, const C &c)
{
    return { lane(a), lane(b), lane(c) };
}
template <Scalar A, Scalar B, Scalar C, Scalar D>
float4 vec4(const A &a, const B &b, const C &c, const D &d)
{
    return { lane(a), lane(b), lane(c), lane(d) };
}

template <class V> V slope_x(V a, GpPlace at = gp_here())
{
    return emit<V>(GP_OP_DERIVATIVE, GP_STEP_DSX, at, a);
}
template <class V> V slope_y(V a, GpPlace at = gp_here())
{
    return emit<V>(GP_OP_DERIVATIVE, GP_STEP_DSY, at, a);
}

} // namespace

#endif
