/* Blending and write masks of GP_LANES pixels inside the tile. */
#include "pipeline/fast/lanes/patch.h"

/* --- what a target makes of a value ------------------------------------------------------------------- */

/* The code of an 8-bit channel (R24): in binary64, where the product and the sum are exact enough. */
GP_INLINE itg unorm8_code(flt v)
{
    v = flt_select(v > 0.0f, v, flt_set(0)); /* NaN to 0 */
    v = flt_select(v < 1.0f, v, flt_set(1));
    return __builtin_convertvector(__builtin_convertvector(v, dbl) * 255.0 + 0.5, itg);
}

/* The value that a store and a load of an 8-bit channel leave. */
static flt through_unorm8(flt v)
{
    return flt_from_itg(unorm8_code(v)) / 255.0f;
}

/* The same for a half: gp_half_from_float and back, without leaving the float's bits. */
static flt through_half(flt v)
{
    itg bits = (itg)v, sign = bits & INT32_MIN, size = bits & 0x7fffffff;
    itg normal = (size + 0xfff + (size >> 13 & 1)) & ~0x1fff;
    itg small = (itg)(((flt)size + 0.5f) - 0.5f);
    itg rounded = itg_select((itg)(size < 0x38800000), small, normal);
    rounded = itg_select((itg)(size >= 0x477ff000), itg_set(0x7f800000), rounded);
    rounded |= sign;
    return (flt)itg_select((itg)(size > 0x7f800000), itg_set(0x7fc00000), rounded);
}

static flt through(GpFormat format, flt v)
{
    switch (format) {
    case GP_A8R8G8B8:
    case GP_R8:
        return through_unorm8(v);
    case GP_G16R16F:
    case GP_A16B16G16R16F:
        return through_half(v);
    default:
        return v;
    }
}

/* --- blending ------------------------------------------------------------------------------------------- */

typedef struct Operands {
    flt source[4], target[4];
    float constant[4];
} Operands;

static flt factor(GpBlendFactor name, int c, const Operands *o)
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

static flt logic(GpBlendOp op, flt s, flt d)
{
    itg source = unorm8_code(s), target = unorm8_code(d);
    itg code = op == GP_BLEND_LOGIC_AND  ? source & target
               : op == GP_BLEND_LOGIC_OR ? source | target
                                         : source ^ target;
    return flt_from_itg(code) / 255.0f;
}

static flt operate(GpBlendOp op, flt s, flt d, flt source_factor, flt target_factor)
{
    switch (op) {
    case GP_BLEND_ADD:
        return s * source_factor + d * target_factor;
    case GP_BLEND_SUBTRACT:
        return s * source_factor - d * target_factor;
    case GP_BLEND_REV_SUBTRACT:
        return d * target_factor - s * source_factor;
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

static void blend_lanes(const GpBlend *blend, bool clamps, const float constant[4], Operands *o,
                        flt result[4])
{
    for (int c = 0; c < 4; c++) {
        o->constant[c] = constant[c];
        if (!clamps)
            continue;
        o->constant[c] = constant[c] > 0 ? (constant[c] < 1 ? constant[c] : 1.0f) : 0.0f;
        flt positive = flt_select(o->source[c] > 0.0f, o->source[c], flt_set(0));
        o->source[c] = flt_select(positive < 1.0f, positive, flt_set(1));
    }
    for (int c = 0; c < 4; c++) {
        bool separate = c == 3 && blend->alpha_op != GP_BLEND_OFF;
        GpBlendOp op = separate ? blend->alpha_op : blend->op;
        result[c] = operate(op, o->source[c], o->target[c],
                            factor(separate ? blend->alpha_src : blend->src, c, o),
                            factor(separate ? blend->alpha_dst : blend->dst, c, o));
    }
}

/* --- targets ------------------------------------------------------------------------------------- */

static const uint8_t packed_shift[4] = { 16, 8, 0, 24 }; /* of r g b a in A8R8G8B8's word */

static void merge_packed(const GpBlend *blend, const float constant[4], const FastPatch *patch,
                         unsigned live, const flt source[4], uint32_t *plane)
{
    flt result[4] = { source[0], source[1], source[2], source[3] };
    itg before = itg_set(0);
    if (blend->op != GP_BLEND_OFF || (blend->keep & 15))
        before = load_patch(plane, patch);
    if (blend->op != GP_BLEND_OFF) {
        Operands o;
        for (int c = 0; c < 4; c++) {
            o.source[c] = source[c];
            o.target[c] = flt_from_itg(before >> packed_shift[c] & 255) / 255.0f;
        }
        blend_lanes(blend, true, constant, &o, result);
    }
    itg word = itg_set(0);
    uint32_t kept = 0;
    for (int c = 0; c < 4; c++) {
        if (blend->keep >> c & 1)
            kept |= 255u << packed_shift[c];
        else
            word |= unorm8_code(result[c]) << packed_shift[c];
    }
    store_patch(plane, patch, live, word | (before & (int32_t)kept));
}

static void merge_planes(const GpBlend *blend, const float constant[4], GpFormat format,
                         const FastPatch *patch, unsigned live, const flt source[4],
                         FastPlanes *planes)
{
    flt result[4] = { source[0], source[1], source[2], source[3] };
    const int channels = gp_format_info(format)->channels;
    if (blend->op != GP_BLEND_OFF) {
        Operands o;
        for (int c = 0; c < 4; c++) {
            o.source[c] = source[c];
            o.target[c] = c < channels ? (flt)load_patch(planes->channel[c], patch) : flt_set(1);
        }
        blend_lanes(blend, !gp_format_info(format)->is_float, constant, &o, result);
    }
    for (int c = 0; c < channels; c++)
        if (!(blend->keep >> c & 1))
            store_patch(planes->channel[c], patch, live, (itg)through(format, result[c]));
}

void FAST(merge_patch)(Tile *tile, const FastDraw *d, const FastPatch *patch, unsigned live,
                       const flt *color)
{
    const GpState *state = &d->draw->state;
    int written = gp_program_targets(d->draw->program);
    for (int t = 0; t < written && t < tile->targets; t++) {
        GpFormat format = d->pass->color[t].surface->format;
        if (format == GP_A8R8G8B8)
            merge_packed(&state->blend[t], state->blend_constant, patch, live, color + 4 * t,
                         tile->planes[t].packed);
        else
            merge_planes(&state->blend[t], state->blend_constant, format, patch, live,
                         color + 4 * t, &tile->planes[t]);
    }
}

/* --- mixes -------------------------------------------------------------------------------------- */

static void scatter(void *plane, const uint32_t at[GP_LANES], unsigned live, itg words)
{
    for (; live; live &= live - 1) {
        int lane = __builtin_ctz(live);
        ((int32_t *)plane)[at[lane]] = words[lane];
    }
}

void FAST(write_mix)(Tile *tile, const FastDraw *d, const FastMix *mix, const flt *color)
{
    uint32_t at[GP_LANES];
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        at[lane] = fast_at(mix->x[lane], mix->y[lane]);
    for (int t = 0; t < tile->targets; t++, color += 4) {
        const GpFormat format = d->pass->color[t].surface->format;
        FastPlanes *planes = &tile->planes[t];
        if (format == GP_A8R8G8B8) {
            itg word = itg_set(0);
            for (int c = 0; c < 4; c++)
                word |= unorm8_code(color[c]) << packed_shift[c];
            scatter(planes->packed, at, mix->live, word);
            continue;
        }
        for (int c = 0; c < gp_format_info(format)->channels; c++)
            scatter(planes->channel[c], at, mix->live, (itg)through(format, color[c]));
    }
}
