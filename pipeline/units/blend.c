/* Blending: the shader's colour and what the target holds make what is stored.
 * in: blend state and constant, the target's format, source and destination as linear floats; out:
 * one colour, not yet rounded to the format. Rules R30, R32 to R36; factors and operations are
 * Direct3D 9's. */
#include "pipeline/units/blend.h"

#include <string.h>

/* Channel `c` of a factor (3 = alpha). */
static float factor(GpBlendFactor name, int c, const float s[4], const float d[4],
                    const float constant[4])
{
    float headroom = 1.0f - d[3];
    switch (name) {
    case GP_ONE:
        return 1.0f;
    case GP_SRC_COLOR:
        return s[c];
    case GP_INV_SRC_COLOR:
        return 1.0f - s[c];
    case GP_SRC_ALPHA:
        return s[3];
    case GP_INV_SRC_ALPHA:
        return 1.0f - s[3];
    case GP_DEST_ALPHA:
        return d[3];
    case GP_INV_DEST_ALPHA:
        return headroom;
    case GP_DEST_COLOR:
        return d[c];
    case GP_INV_DEST_COLOR:
        return 1.0f - d[c];
    case GP_SRC_ALPHA_SAT:
        return c == 3 ? 1.0f : s[3] < headroom ? s[3] : headroom;
    case GP_BLEND_CONSTANT:
        return constant[c];
    case GP_INV_BLEND_CONSTANT:
        return 1.0f - constant[c];
    default:
        return 0.0f;
    }
}

static float operate(GpBlendOp op, float s, float d, float source_factor, float target_factor)
{
    switch (op) {
    case GP_BLEND_ADD:
        return s * source_factor + d * target_factor;
    case GP_BLEND_SUBTRACT:
        return s * source_factor - d * target_factor;
    case GP_BLEND_REV_SUBTRACT:
        return d * target_factor - s * source_factor;
    case GP_BLEND_MIN: /* a NaN loses (R30) */
        return s < d || d != d ? s : d;
    case GP_BLEND_MAX:
        return s > d || d != d ? s : d;
    default:
        return s;
    }
}

static float logic(GpBlendOp op, float s, float d)
{
    uint32_t source = gp_unorm_from_float(s, 8), target = gp_unorm_from_float(d, 8);
    uint32_t code = op == GP_BLEND_LOGIC_AND  ? source & target
                    : op == GP_BLEND_LOGIC_OR ? source | target
                                              : source ^ target;
    return gp_float_from_unorm(code, 8);
}

static void clamp_to_unorm(const float in[4], float out[4])
{
    for (int c = 0; c < 4; c++)
        out[c] = in[c] > 0 ? (in[c] < 1 ? in[c] : 1.0f) : 0.0f; /* NaN to 0 */
}

bool gp_blend_reads_target(const GpBlend *blend)
{
    return blend->op != GP_BLEND_OFF;
}

/* How channel c is blended. */
static GpBlend of_channel(const GpBlend *blend, int c)
{
    GpBlend own = *blend;
    if (c == 3 && blend->alpha_op != GP_BLEND_OFF) {
        own.op = blend->alpha_op;
        own.src = blend->alpha_src;
        own.dst = blend->alpha_dst;
    }
    return own;
}

void gp_blend_factors(const GpBlend *blend, const float constant[4], GpFormat format,
                      const float source[4], const float destination[4], float factors[2][4])
{
    float s[4], k[4];
    const bool is_float = gp_format_info(format)->is_float;
    memcpy(s, source, sizeof s);
    memcpy(k, constant, sizeof k);
    if (!is_float) {
        clamp_to_unorm(source, s);
        clamp_to_unorm(constant, k);
    }
    for (int c = 0; c < 4; c++) {
        const GpBlend own = of_channel(blend, c);
        const bool has = own.op >= GP_BLEND_ADD && own.op <= GP_BLEND_REV_SUBTRACT;
        factors[0][c] = has ? factor(own.src, c, s, destination, k) : 0;
        factors[1][c] = has ? factor(own.dst, c, s, destination, k) : 0;
    }
}

void gp_blend(const GpBlend *blend, const float constant[4], GpFormat format, const float source[4],
              const float destination[4], float result[4])
{
    float s[4], k[4], blended[4];
    memcpy(s, source, sizeof s);
    memcpy(k, constant, sizeof k);
    if (!gp_format_info(format)->is_float) {
        clamp_to_unorm(source, s);
        clamp_to_unorm(constant, k);
    }
    for (int c = 0; c < 4; c++) {
        const GpBlend own = of_channel(blend, c);
        if (gp_blend_is_logic(own.op))
            blended[c] = logic(own.op, s[c], destination[c]);
        else
            blended[c] =
                operate(own.op, s[c], destination[c], factor(own.src, c, s, destination, k),
                        factor(own.dst, c, s, destination, k));
    }
    memcpy(result, blended, sizeof blended);
}
