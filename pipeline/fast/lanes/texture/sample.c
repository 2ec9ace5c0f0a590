/* Texture units side by side: each step of pipeline/units/texture_address.c and
 * pipeline/units/texture.c on all lanes of a packet. Why the results are those of the definition
 * stands where they part. */
#include "pipeline/fast/lanes/texture/sample.h"

#include "pipeline/fast/lanes/texture/filter.h"

#include <float.h>

/* --- one level -------------------------------------------------------------------------------- */

/* The packet to the right mostly reads as far behind this one's last texel as that lies behind its
 * first: discard_tex, which waits for little else, takes 12 % less. */
GP_INLINE void prefetch_next(const Footprint *f)
{
    const itg offset = f->offset[0];
    const int64_t next = 2 * (int64_t)offset[GP_LANES - 1] - offset[0] + 64;
    __builtin_prefetch((const void *)((uintptr_t)f->texels + (uintptr_t)next));
}

/* Of a shadow map, which is seen from elsewhere, each lane mostly reads another row, as far behind
 * this packet's. Every other lane's row is as good as all of them: shadow_hw takes 4 to 5 %
 * less. */
GP_INLINE void prefetch_next_rows(const Footprint *f)
{
    const itg offset = f->offset[0];
    const utg at = (utg)offset; /* which no overflow matters to: nothing is read there */
    const utg next = at + (2 * at[GP_LANES - 1] - at[GP_LANES - 2] - at[0]);
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane += 2)
        __builtin_prefetch(
            (const void *)((uintptr_t)f->texels + (uintptr_t)(intptr_t)(int32_t)next[lane]));
}

GP_INLINE void sample(const FastSampler *s, const FastLevel *level, Variant variant,
                      const float *coord, float *texel)
{
    const int taps = variant.filter == GP_LINEAR ? 4 : 1;
    flt rgba[4];
    Footprint f;
    find_texels(s, level, variant, coord, &f);
    if (variant.sampling == FAST_COMPARE)
        prefetch_next_rows(&f);
    else
        prefetch_next(&f);
    if (variant.sampling == FAST_CODES)
        filter_codes(s, &f, taps, rgba);
    else if (variant.sampling == FAST_FLOATS)
        filter_floats(s, &f, taps, rgba);
    else
        filter_compare(s, &f, taps, flt_load(coord + 2 * GP_LANES), rgba);
    for (int c = 0; c < 4; c++)
        flt_store(texel + c * GP_LANES, rgba[c]);
}

/* in   coord: as in GpTextureRead
 * out  texel: likewise */
static void sample_level(const FastSampler *s, const FastLevel *level, GpFilter filter,
                         const float *coord, float *texel)
{
    const GpAddress mode = s->address_u == s->address_v ? s->address_u : ANY_MODE;
    /* clang-format off */
#define SAMPLE(sampling, filter, mode)                                                             \
    sample(s, level, (Variant){ sampling, filter, mode }, coord, texel)
    if (s->sampling == FAST_CODES && filter == GP_LINEAR) {
        if (mode == GP_WRAP)
            SAMPLE(FAST_CODES, GP_LINEAR, GP_WRAP);
        else if (mode == GP_CLAMP)
            SAMPLE(FAST_CODES, GP_LINEAR, GP_CLAMP);
        else
            SAMPLE(FAST_CODES, GP_LINEAR, ANY_MODE);
    } else if (s->sampling == FAST_CODES) {
        SAMPLE(FAST_CODES, GP_POINT, ANY_MODE);
    } else if (s->sampling == FAST_FLOATS) {
        if (filter == GP_LINEAR)
            SAMPLE(FAST_FLOATS, GP_LINEAR, ANY_MODE);
        else
            SAMPLE(FAST_FLOATS, GP_POINT, ANY_MODE);
    } else if (filter == GP_LINEAR) {
        SAMPLE(FAST_COMPARE, GP_LINEAR, ANY_MODE);
    } else {
        SAMPLE(FAST_COMPARE, GP_POINT, ANY_MODE);
    }
#undef SAMPLE
    /* clang-format on */
}

/* --- level of detail -------------------------------------------------------------------------- */

/* gp_texture_lod, from du/dx dv/dx du/dy dv/dy. */
GP_INLINE flt lod_of_gradient(const GpSurface *surface, const flt gradient[4])
{
    const float width = (float)surface->width, height = (float)surface->height;
    flt ux = gradient[0] * width, vx = gradient[1] * height;
    flt uy = gradient[2] * width, vy = gradient[3] * height;
    flt along_x = ux * ux + vx * vx;
    flt along_y = uy * uy + vy * vy;
    flt longer = flt_lesser(flt_greater(along_x, along_y), flt_set(FLT_MAX));
    msk numbers = (along_x == along_x) & (along_y == along_y);
    return flt_select(numbers, 0.5f * math_log2_of_size(longer, -__builtin_inff()), flt_set(0));
}

GP_INLINE flt find_lod(const GpSurface *surface, const GpTextureRead *read)
{
    flt gradient[4], u = flt_load(read->coord), v = flt_load(read->coord + GP_LANES);
    flt w = flt_load(read->coord + 3 * GP_LANES);
    if (read->mode == GP_LOD_EXPLICIT)
        return w;
    if (read->mode == GP_LOD_GRADIENT) {
        for (int i = 0; i < 4; i++)
            gradient[i] = flt_load(read->gradient + i * GP_LANES);
    } else {
        gradient[0] = flt_quad_dx(u);
        gradient[1] = flt_quad_dx(v);
        gradient[2] = flt_quad_dy(u);
        gradient[3] = flt_quad_dy(v);
    }
    flt lod = lod_of_gradient(surface, gradient);
    return read->mode == GP_LOD_BIAS ? lod + w : lod;
}

/* Bias and bounds of R44. */
GP_INLINE flt bias_lod(const FastSampler *s, flt lod)
{
    flt biased = lod + s->lod_bias;
    biased = flt_select(biased == biased, biased, flt_set(0));
    biased = flt_select(biased > s->max_lod, flt_set(s->max_lod), biased);
    return flt_select(biased < s->min_lod, flt_set(s->min_lod), biased);
}

/* One level after the other: each is sampled once, for the lanes that use it as their finer level
 * and for those that use it as their coarser one. What is sampled for the other lanes is lost. */
static void sample_mixed_levels(const FastSampler *s, itg first, itg weight, GpFilter filter,
                                const float *coord, flt fine[4], flt coarse[4])
{
    uint32_t used = 0; /* bit i: level i */
    for (int lane = 0; lane < GP_LANES; lane++)
        used |= (weight[lane] ? 3u : 1u) << first[lane];

    for (int c = 0; c < 4; c++)
        fine[c] = coarse[c] = flt_set(0);
    for (int32_t number = 0; used >> number; number++) {
        flt texel[4];
        if (!(used >> number & 1u))
            continue;
        sample_level(s, &s->levels[number], filter, coord, (float *)texel);
        for (int c = 0; c < 4; c++) {
            fine[c] = flt_select(first == number, texel[c], fine[c]);
            coarse[c] = flt_select(first + 1 == number, texel[c], coarse[c]);
        }
    }
}

static void sample_levels(const FastSampler *s, flt lod, GpFilter filter, const float *coord,
                          float *texel)
{
    const int32_t last = (int32_t)(s->surface->levels - 1) * ONE;
    const bool blend = s->mip == GP_MIP_LINEAR;
    itg detail = nearest_integer(math_between(lod, -128.0f, 128.0f - 1.0f / ONE) * (float)ONE);
    detail = itg_greater(itg_lesser(detail, itg_set(last)), itg_set(0));
    itg first = (blend ? detail : detail + ONE / 2) >> 8;
    itg weight = blend ? detail & (ONE - 1) : itg_set(0);

    /* Mostly the same levels serve all lanes. Counting up to the finest lets the processor guess
     * it and go on, where taking it from `first` would wait for the logarithm. */
    flt fine[4], coarse[4];
    int32_t number = 0;
    while (!msk_bits(first == number))
        number++;
    if (!msk_bits(first != number)) {
        if (!msk_bits(weight != 0)) {
            sample_level(s, &s->levels[number], filter, coord, texel);
            return;
        }
        sample_level(s, &s->levels[number], filter, coord, (float *)fine);
        sample_level(s, &s->levels[number + 1], filter, coord, (float *)coarse);
    } else {
        sample_mixed_levels(s, first, weight, filter, coord, fine, coarse);
    }
    for (int c = 0; c < 4; c++)
        flt_store(texel + c * GP_LANES, lerp(fine[c], coarse[c], weight));
}

static void sample_filtered(const FastSampler *s, flt lod, GpFilter filter, const float *coord,
                            float *texel)
{
    if (s->mip == GP_MIP_NONE)
        sample_level(s, &s->levels[s->level], filter, coord, texel);
    else
        sample_levels(s, lod, filter, coord, texel);
}

/* Where filters differ, and some lanes magnify while others do not, all are sampled both ways. */
static void sample_by_lod(const FastSampler *s, const GpTextureRead *read)
{
    flt lod = bias_lod(s, find_lod(s->surface, read));
    msk minified = lod > 0.0f;

    if (s->min == s->mag || !msk_bits(~minified)) {
        sample_filtered(s, lod, s->min, read->coord, read->texel);
        return;
    }
    flt texel[4];
    sample_filtered(s, lod, s->mag, read->coord, read->texel);
    if (!msk_bits(minified))
        return;
    sample_filtered(s, lod, s->min, read->coord, (float *)texel);
    for (int c = 0; c < 4; c++) {
        float *to = read->texel + c * GP_LANES;
        flt_store(to, flt_select(minified, texel[c], flt_load(to)));
    }
}

void fast_read_texture(const GpShaderCall *call, const GpTextureRead *read)
{
    const FastSampler *s = (const FastSampler *)call->executor + read->slot;

    GP_ASSERT(read->lanes == GP_LANES);
    if (s->sampling == FAST_UNBOUND)
        for (int c = 0; c < 4; c++)
            flt_store(read->texel + c * GP_LANES, flt_set(c == 3));
    else if (s->one_level)
        sample_level(s, &s->levels[s->level], s->min, read->coord, read->texel);
    else
        sample_by_lod(s, read);
}
