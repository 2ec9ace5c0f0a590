/* The vocabulary of the shader language in counting lanes: each instruction records itself. The types
 * and names are those of the C vocabulary (types.h, instructions.h, textures.h, pixels.h). */
#ifndef GP_COUNTING_INSTRUCTIONS_HPP
#define GP_COUNTING_INSTRUCTIONS_HPP

#include "pipeline/shader/counting_graph.hpp"

#include <type_traits>

#define GP_INLINE static inline __attribute__((always_inline, unused))

namespace
{

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

/* The recorder of the shader that runs in this thread. */
inline thread_local Recorder *recording = nullptr;

struct GpInvocation {
    flt depth;
};

template <class T>
concept Number = std::is_arithmetic_v<T>;
template <class T>
concept Scalar = Number<T> || std::is_same_v<T, flt>;
template <class A, class B>
concept Infix = Scalar<A> && Scalar<B> && !(Number<A> && Number<B>);

/* --- constants, widening and recording -------------------------------------------------------- */

inline flt bcast(float value)
{
    return recording->number(value);
}

template <Scalar A> flt lane(A a)
{
    if constexpr (Number<A>)
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

template <class V> V from_parts(const std::array<flt, 4> &parts)
{
    V value;
    std::memcpy(&value, parts.data(), sizeof value);
    return value;
}

template <class V>
concept Value = std::is_same_v<V, flt> || std::is_same_v<V, float2> || std::is_same_v<V, float3> ||
    std::is_same_v<V, float4>;

/* b as a V: itself, or one scalar in all components. */
template <class V, class B> V widen(B b)
{
    static_assert(Value<V>, "a must be a flt or a vector");
    static_assert(std::is_same_v<V, B> || Scalar<B>,
                  "what goes with a must be as wide as a, or a flt, or a number");
    if constexpr (std::is_same_v<V, B>) {
        return b;
    } else {
        flt a = lane(b);
        return from_parts<V>({ a, a, a, a });
    }
}

template <class V, class... Operands> V emit(const Op &op, Operands... operands)
{
    int32_t node = recording->record(op, { Operand(operands)... });
    return from_parts<V>(
        { flt{ node, 0, false }, { node, 1, false }, { node, 2, false }, { node, 3, false } });
}

constexpr Op EACH_1 = { 1, 1, Op::each }, EACH_2 = { 2, 2, Op::each };
constexpr Op ALL_1 = { 1, 1, Op::all }, ALL_2 = { 2, 2, Op::all }, ALL_3 = { 3, 3, Op::all };
constexpr Op SINCOS = { 8, 8, Op::all };
constexpr Op DERIVATIVE = { 2, 2, Op::each, Kind::arithmetic, true };
constexpr Op TEXKILL = { 1, 2, Op::all, Kind::kill };

/* --- arithmetic ------------------------------------------------------------------------------- */

#define GP_TWO_OPERANDS(name)                                                                      \
    template <class V, class B> V name(V a, B b)                                                   \
    {                                                                                              \
        return emit<V>(EACH_1, a, widen<V>(b));                                                    \
    }
GP_TWO_OPERANDS(add)
GP_TWO_OPERANDS(sub)
GP_TWO_OPERANDS(mul)
GP_TWO_OPERANDS(min)
GP_TWO_OPERANDS(max)
GP_TWO_OPERANDS(slt)
GP_TWO_OPERANDS(sge)

template <class V, class B, class C> V mad(V a, B b, C c)
{
    return emit<V>(EACH_1, a, widen<V>(b), widen<V>(c));
}
template <class T, class V, class B> V lrp(T t, V a, B b)
{
    return emit<V>(EACH_2, widen<V>(t), a, widen<V>(b));
}
template <class S, class V, class B> V cmp(S s, V a, B b)
{
    return emit<V>(EACH_1, widen<V>(s), a, widen<V>(b));
}
template <class V, class B> V sel(msk m, V a, B b)
{
    return emit<V>(EACH_1, widen<V>(m.value), a, widen<V>(b));
}

/* A loop that may be left early is counted in full. */
inline bool any(msk)
{
    return true;
}

/* rep, break_comp and endrep. */
inline void gp_begin_loop(msk goes_on)
{
    recording->record({ 8, 8, Op::all, Kind::loop }, { Operand(goes_on.value) });
}
#define loop_while(turns, m) if (gp_begin_loop(m); true)

template <class V> V neg(V a)
{
    Operand parts(a);
    for (flt &part : parts.part)
        part.negated = !part.negated;
    return from_parts<V>(parts.part);
}
template <class V> V abs_(V a)
{
    return emit<V>(EACH_1, a);
}
template <class V> V frc(V a)
{
    return emit<V>(EACH_1, a);
}
template <class V> V floor_(V a)
{
    return emit<V>(EACH_2, a);
}
template <class V> V sat(V a)
{
    static constexpr Op SAT = { 1, 1, Op::each }, MIN_MAX = { 2, 1, Op::each };
    if (recording->is_vertex())
        return recording->model2() ? emit<V>(MIN_MAX, a) : emit<V>(SAT, a);
    bool computed = true;
    Operand parts(a);
    for (int i = 0; i < parts.width; i++) {
        const flt &part = parts.part[size_t(i)];
        computed = computed && recording->kind_of(part) == Kind::arithmetic && !part.negated;
    }
    return computed ? a : emit<V>(SAT, a);
}

inline flt dp2(float2 a, float2 b)
{
    return emit<flt>(ALL_2, a, b);
}
inline flt dp2add(float2 a, float2 b, flt c)
{
    return emit<flt>(ALL_2, a, b, c);
}
inline flt dp3(float3 a, float3 b)
{
    return emit<flt>(ALL_1, a, b);
}
inline flt dp4(float4 a, float4 b)
{
    return emit<flt>(ALL_1, a, b);
}
inline float3 crs(float3 a, float3 b)
{
    return emit<float3>(ALL_2, a, b);
}

/* --- infix, on flt and numbers ---------------------------------------------------------------- */

inline flt operator-(flt a)
{
    return neg(a);
}
#define GP_INFIX(op, name)                                                                         \
    template <class A, class B>                                                                    \
    requires Infix<A, B> flt operator op(A a, B b)                                                 \
    {                                                                                              \
        return name(lane(a), b);                                                                   \
    }
GP_INFIX(+, add)
GP_INFIX(-, sub)
GP_INFIX(*, mul)
template <class A, class B>
requires Infix<A, B> flt operator/(A a, B b)
{
    flt reciprocal = emit<flt>(ALL_1, lane(b));
    if constexpr (Number<A>)
        if (a == A(1))
            return reciprocal;
    return mul(lane(a), reciprocal);
}

#define GP_ASSIGNMENT(op)                                                                          \
    template <Scalar B> flt &operator op##=(flt &a, B b)                                           \
    {                                                                                              \
        return a = a op b;                                                                         \
    }
GP_ASSIGNMENT(+)
GP_ASSIGNMENT(-)
GP_ASSIGNMENT(*)
GP_ASSIGNMENT(/)

/* A comparison is the difference of its sides; against 0 that is the side itself. */
template <class A, class B> flt difference(A a, B b)
{
    if constexpr (Number<B>)
        if (b == B(0))
            return a;
    if constexpr (Number<A>)
        if (a == A(0))
            return b;
    return sub(lane(a), b);
}
#define GP_COMPARISON(op, tested)                                                                  \
    template <class A, class B>                                                                    \
    requires Infix<A, B> msk operator op(A a, B b)                                                 \
    {                                                                                              \
        flt d = difference(a, b);                                                                  \
        return { tested };                                                                         \
    }
GP_COMPARISON(<, d)
GP_COMPARISON(<=, d)
GP_COMPARISON(>, d)
GP_COMPARISON(>=, d)
GP_COMPARISON(==, mul(d, d))
GP_COMPARISON(!=, mul(d, d))

#define GP_MASK_OPERATOR(op)                                                                       \
    inline msk operator op(msk a, msk b)                                                           \
    {                                                                                              \
        return { emit<flt>(EACH_1, a.value, b.value) };                                            \
    }
GP_MASK_OPERATOR(&)
GP_MASK_OPERATOR(|)
GP_MASK_OPERATOR(^)
inline msk operator~(msk a)
{
    return { emit<flt>(EACH_1, a.value) };
}

/* --- one-argument functions ------------------------------------------------------------------- */

#define GP_FUNCTION(name, op)                                                                      \
    inline flt name(flt a)                                                                         \
    {                                                                                              \
        return emit<flt>(op, a);                                                                   \
    }
GP_FUNCTION(rcp, ALL_1)
GP_FUNCTION(rsq, ALL_1)
GP_FUNCTION(exp_, ALL_1)
GP_FUNCTION(log_, ALL_1)
GP_FUNCTION(sqrt_, ALL_2)
GP_FUNCTION(sgn, ALL_3)
GP_FUNCTION(sin_, SINCOS)
GP_FUNCTION(cos_, SINCOS)

inline float2 sincos_(flt a)
{
    return emit<float2>(SINCOS, a);
}
inline flt pow_(flt a, flt b)
{
    return emit<flt>(ALL_3, a, b);
}
template <class V> V nrm(V v)
{
    static_assert(width_of<V> > 1, "nrm takes a vector");
    return emit<V>(ALL_3, v);
}
inline float4 lit(flt n_l, flt n_h, flt power)
{
    return emit<float4>(ALL_3, n_l, n_h, power);
}
inline float4 dst(float4 a, float4 b)
{
    return emit<float4>(EACH_1, a, b);
}

/* --- matrices: one dot product a row; the w of a point is 1 ----------------------------------- */

template <class V> flt row4(V v, const float row[4])
{
    static_assert(width_of<V> >= 3, "a point of three or four components");
    return emit<flt>(ALL_1, v, u4(row));
}
template <class V> float4 m4x4(V v, const float m[4][4])
{
    return { row4(v, m[0]), row4(v, m[1]), row4(v, m[2]), row4(v, m[3]) };
}
template <class V> float3 m4x3(V v, const float m[4][4])
{
    return { row4(v, m[0]), row4(v, m[1]), row4(v, m[2]) };
}
inline float3 m3x3(float3 v, const float m[4][4])
{
    return { dp3(v, u3(m[0])), dp3(v, u3(m[1])), dp3(v, u3(m[2])) };
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
template <Scalar A> float4 rgba(float3 color, A alpha)
{
    return { color.x, color.y, color.z, lane(alpha) };
}
template <Scalar A, Scalar B> float2 vec2(A a, B b)
{
    return { lane(a), lane(b) };
}
template <Scalar A, Scalar B, Scalar C> float3 vec3(A a, B b, C c)
{
    return { lane(a), lane(b), lane(c) };
}
template <Scalar A, Scalar B, Scalar C, Scalar D> float4 vec4(A a, B b, C c, D d)
{
    return { lane(a), lane(b), lane(c), lane(d) };
}

template <class V> V slope_x(V a)
{
    return emit<V>(DERIVATIVE, a);
}
template <class V> V slope_y(V a)
{
    return emit<V>(DERIVATIVE, a);
}

/* --- textures and pixels: gp, the invocation, is asked for because C needs it ----------------- */

inline float4 gp_read(GpInvocation *, int slot, const Op &op, std::vector<Operand> operands)
{
    int32_t node = recording->record(op, std::move(operands), slot);
    return { { node, 0, false }, { node, 1, false }, { node, 2, false }, { node, 3, false } };
}

constexpr Op TEXLD = { 1, 1, Op::all, Kind::texture, false, GP_LOD_IMPLICIT };
constexpr Op TEXLDP = { 1, 3, Op::all, Kind::texture, false, GP_LOD_IMPLICIT };
constexpr Op TEXLDB = { 1, 6, Op::all, Kind::texture, false, GP_LOD_BIAS };
constexpr Op TEXLDL = { 2, 2, Op::all, Kind::texture, false, GP_LOD_EXPLICIT };
constexpr Op TEXLDD = { 3, 3, Op::all, Kind::texture, true, GP_LOD_GRADIENT };

#define texld(slot, a)          gp_read(gp, slot, TEXLD, { Operand(a) })
#define texldp(slot, a)         gp_read(gp, slot, TEXLDP, { Operand(a) })
#define texldb(slot, a)         gp_read(gp, slot, TEXLDB, { Operand(a) })
#define texldl(slot, a)         gp_read(gp, slot, TEXLDL, { Operand(a) })
#define texldd(slot, a, dx, dy) gp_read(gp, slot, TEXLDD, { Operand(a), Operand(dx), Operand(dy) })
#define gp_load_local(slot)     gp_read(gp, slot, TEXLD, {})

template <class V> void gp_kill(GpInvocation *, V a)
{
    emit<flt>(TEXKILL, a);
}
inline void gp_kill(GpInvocation *, msk a)
{
    emit<flt>(TEXKILL, a.value);
}
#define discard(mask) gp_kill(gp, msk(mask))
#define texkill(a)    gp_kill(gp, a)
#define odepth(value) ((void)(gp->depth = (value)))

inline float2 gp_vpos(const GpInvocation *)
{
    return { recording->leaf(Kind::pixel, 0), recording->leaf(Kind::pixel, 1) };
}
inline flt gp_vface(const GpInvocation *)
{
    return recording->leaf(Kind::face, 0);
}
#define dsx(a)  ((void)gp, slope_x(a))
#define dsy(a)  ((void)gp, slope_y(a))
#define vpos()  gp_vpos(gp)
#define vface() gp_vface(gp)

} // namespace

#endif
