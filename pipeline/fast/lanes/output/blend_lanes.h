/* Blending of numbers in lanes. */
#ifndef GP_FAST_BLEND_LANES_H
#define GP_FAST_BLEND_LANES_H

#include "pipeline/fast/lanes/output/quantize.h"

/* All of this is written out where it is used, so that a blend known to the compiler leaves only
 * the operations that it asks for. */

typedef struct Operands {
    flt source[4], target[4];
    float constant[4];
    bool halves; /* the target's */
} Operands;

GP_INLINE flt factor(GpBlendFactor name, int c, const Operands *o)
{
    const flt one = flt_set(1);
    flt headroom = 1.0f - o->target[3];
    switch (name) {
    case GP_ONE:
        return one;
    case GP_SRC_COLOR:
        return o->source[c];
    case GP_INV_SRC_COLOR:
        return 1.0f - o->source[c];
    case GP_SRC_ALPHA:
        return o->source[3];
    case GP_INV_SRC_ALPHA:
        return 1.0f - o->source[3];
    case GP_DEST_ALPHA:
        return o->target[3];
    case GP_INV_DEST_ALPHA:
        return headroom;
    case GP_DEST_COLOR:
        return o->target[c];
    case GP_INV_DEST_COLOR:
        return 1.0f - o->target[c];
    case GP_SRC_ALPHA_SAT:
        return c == 3 ? one : flt_select(o->source[3] < headroom, o->source[3], headroom);
    case GP_BLEND_CONSTANT:
        return flt_set(o->constant[c]);
    case GP_INV_BLEND_CONSTANT:
        return flt_set(1.0f - o->constant[c]);
    default:
        return flt_set(0);
    }
}

GP_INLINE flt logic(GpBlendOp op, flt s, flt d)
{
    itg source = itg_unorm8(s), target = itg_unorm8(d);
    itg code = op == GP_BLEND_LOGIC_AND  ? source & target
               : op == GP_BLEND_LOGIC_OR ? source | target
                                         : source ^ target;
    return flt_unpack_unorm8(code, 0);
}

GP_INLINE flt scaled(flt v, GpBlendFactor name, int c, const Operands *o)
{
    return name == GP_ONE ? v : v * factor(name, c, o); /* v * 1 is v */
}

GP_INLINE flt operate(GpBlendOp op, GpBlendFactor by_source, GpBlendFactor by_target, int c,
                      const Operands *o)
{
    flt s = o->source[c], d = o->target[c];
    switch (op) {
    case GP_BLEND_ADD:
        s = scaled(s, by_source, c, o), d = scaled(d, by_target, c, o);
        return o->halves ? flt_sum_between_halves(s, d) : s + d;
    case GP_BLEND_SUBTRACT:
        return scaled(s, by_source, c, o) - scaled(d, by_target, c, o);
    case GP_BLEND_REV_SUBTRACT:
        return scaled(d, by_target, c, o) - scaled(s, by_source, c, o);
    case GP_BLEND_MIN:
        return flt_select((msk)(s < d) | (msk)(d != d), s, d);
    case GP_BLEND_MAX:
        return flt_select((msk)(s > d) | (msk)(d != d), s, d);
    case GP_BLEND_LOGIC_AND:
    case GP_BLEND_LOGIC_OR:
    case GP_BLEND_LOGIC_XOR:
        return logic(op, s, d);
    default:
        return s;
    }
}

GP_INLINE flt blend_channel(const GpBlend *blend, int c, const Operands *o)
{
    const bool separate = c == 3 && blend->alpha_op != GP_BLEND_OFF;
    return operate(separate ? blend->alpha_op : blend->op, separate ? blend->alpha_src : blend->src,
                   separate ? blend->alpha_dst : blend->dst, c, o);
}

GP_INLINE int channels_of(GpFormat format)
{
    return format == GP_R8 || format == GP_R32F ? 1 : format == GP_G16R16F ? 2 : 4;
}

/* Both factors are weights of one whole, and so is what they leave of numbers from 0 to 1: of the
 * operations none rounds past 1. */
GP_INLINE bool is_average(const GpBlend *blend)
{
    return blend->op == GP_BLEND_ADD && blend->src == GP_SRC_ALPHA &&
           blend->dst == GP_INV_SRC_ALPHA && blend->alpha_op == GP_BLEND_OFF;
}

/* One packet's colours, as the format clamps them, blended with what its pixels hold of a target,
 * and as they are stored. Channel by channel, alpha, which the others ask for, first and last: so
 * the targets of several packets stay in registers.
 * in   clamps: false where the colours are known to be what clamping leaves */
GP_INLINE void blend_clamped(const GpBlend *blend, GpFormat format, bool clamps,
                             const float constant[4], const flt color[4], flt target[4])
{
    Operands o;
    __builtin_memcpy(o.constant, constant, sizeof o.constant);
    o.source[3] = clamps ? clamped(color[3]) : color[3];
    o.target[3] = target[3];
    o.halves = fast_is_half(format);
    GP_UNROLL
    for (int c = 0; c < 4; c++) {
        o.source[c] = clamps ? clamped(color[c]) : color[c];
        o.target[c] = target[c];
        const flt result = blend->op == GP_BLEND_OFF ? color[c] : blend_channel(blend, c, &o);
        if (c < channels_of(format) && !(blend->keep >> c & 1))
            target[c] = fast_is_unorm8(format) && is_average(blend) ? flt_quantize_unorm8(result)
                                                                    : quantize(format, result);
    }
}

GP_INLINE void blend_stored(const GpBlend *blend, GpFormat format, const float constant[4],
                            const flt color[4], flt target[4])
{
    blend_clamped(blend, format, fast_is_unorm8(format), constant, color, target);
}

/* Blend factors, as the target clamps them. */
GP_INLINE void set_constant(const GpState *state, GpFormat format, float constant[4])
{
    const bool is_float = gp_format_info(format)->is_float;
    for (int c = 0; c < 4; c++) {
        const float k = state->blend_constant[c];
        constant[c] = is_float ? k : k > 0 ? (k < 1 ? k : 1.0f) : 0;
    }
}

/* Blends that are known where pixels are blended as they come, and where they were sorted
 * before. */
static const GpBlend over = { .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA, .dst = GP_INV_SRC_ALPHA };
static const GpBlend in_front = { .op = GP_BLEND_ADD,
                                  .src = GP_ONE,
                                  .dst = GP_SRC_ALPHA,
                                  .alpha_op = GP_BLEND_ADD,
                                  .alpha_src = GP_ZERO,
                                  .alpha_dst = GP_SRC_ALPHA };

static const GpBlend over_multiplied = { .op = GP_BLEND_ADD, /* colours are multiplied by alpha */
                                         .src = GP_ONE,
                                         .dst = GP_INV_SRC_ALPHA };

/* Whether a blend does what a known one does; what it leaves alone does not count. */
GP_INLINE bool is_blend(const GpBlend *blend, const GpBlend *known)
{
    const bool weighs = blend->op != GP_BLEND_OFF && blend->op != GP_BLEND_MAX;
    return blend->op == known->op && blend->alpha_op == known->alpha_op && !(blend->keep & 15) &&
           (!weighs || (blend->src == known->src && blend->dst == known->dst)) &&
           (blend->alpha_op == GP_BLEND_OFF ||
            (blend->alpha_src == known->alpha_src && blend->alpha_dst == known->alpha_dst));
}

#endif
