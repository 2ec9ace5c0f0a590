/* Texture sampling: finds the texels under a filter, and blends or compares them.
 * in: a bound texture, coordinates, a level of detail; out: one colour, and a report of the texels
 * used. Rules R40 to R44 by texture_address.c, R46, R48, R49. */
#include "pipeline/units/texture.h"

#include <float.h>
#include <string.h>

#include "pipeline/base/detmath.h"
#include "pipeline/units/texture_address.h"

enum { ONE = 256 }; /* the whole that shares are parts of */

/* One texel under the filter. */
typedef struct Tap {
    const uint8_t *texel; /* in the surface, or the border */
    int32_t x, y;         /* -1, -1: the border */
    uint32_t weight;      /* of ONE * ONE */
} Tap;

/* The 2x2 texels that a sample lies between: top left, top right, bottom left, bottom right. A
 * point sample is one whose shares are 0. */
typedef struct Footprint {
    Tap tap[4];
    uint32_t share_x, share_y; /* of the right and of the lower texels, in 256ths */
} Footprint;

/* --- level of detail -------------------------------------------------------------------------- */

float gp_texture_lod(const float ddx[2], const float ddy[2], uint32_t width, uint32_t height)
{
    float ux = ddx[0] * (float)width, vx = ddx[1] * (float)height;
    float uy = ddy[0] * (float)width, vy = ddy[1] * (float)height;
    float along_x = ux * ux + vx * vx;
    float along_y = uy * uy + vy * vy;

    if (along_x != along_x || along_y != along_y)
        return 0.0f;
    float longer = along_x > along_y ? along_x : along_y;
    if (longer > FLT_MAX)
        longer = FLT_MAX;
    return 0.5f * gp_log2(longer); /* of the square: half of it is the root's */
}

/* --- texels ----------------------------------------------------------------------------------- */

/* What the sampler asks for is rounded and clamped as if it had been drawn into the surface, so
 * that from here on it is a texel like any other. */
void gp_texture_border(const GpTexture *texture, uint8_t border[16])
{
    const GpFormat format = texture->surface->format;
    const float *rgba = texture->sampler.border;

    memset(border, 0, 16);
    if (gp_format_info(format)->is_depth) {
        float depth = rgba[0] < 0.0f ? 0.0f : rgba[0] > 1.0f ? 1.0f : rgba[0];
        gp_depth_store(format, border, gp_depth_code(format, depth), 0);
    } else {
        gp_texel_store(format, border, rgba, 0);
    }
}

static Footprint find_texels(const GpTexture *texture, const GpLevel *level, GpFilter filter,
                             const float uv[2], const uint8_t *border)
{
    const GpSampler *s = &texture->sampler;
    const size_t bytes = gp_format_info(texture->surface->format)->bytes;
    const GpTexelPair u = gp_texel_pair(s->address_u, filter, uv[0], level->width);
    const GpTexelPair v = gp_texel_pair(s->address_v, filter, uv[1], level->height);
    Footprint f = { .share_x = u.share, .share_y = v.share };

    for (int i = 0; i < 4; i++) {
        int right = i & 1, lower = i >> 1;
        int32_t x = gp_texel_address(s->address_u, u.first + right, level->width);
        int32_t y = gp_texel_address(s->address_v, v.first + lower, level->height);
        Tap *tap = &f.tap[i];
        tap->weight = (right ? u.share : ONE - u.share) * (lower ? v.share : ONE - v.share);
        if (x < 0 || y < 0) { /* the border wins if any axis is out */
            tap->x = tap->y = -1;
            tap->texel = border;
        } else {
            tap->x = x;
            tap->y = y;
            tap->texel = gp_surface_texel(level, bytes, (uint32_t)x, (uint32_t)y);
        }
    }
    return f;
}

/* --- filters ---------------------------------------------------------------------------------- */

/* Between a and b, share 256ths of the way, share < 256: a (256 - share) + b share, over 256.
 *
 * Both products have 24 + 9 bits and are exact in binary64, and dividing by 256 is exact: there is
 * one rounding of the exact value to binary64 and one to binary32. Rounding is monotone, hence
 *   - equal ends give that value: the exact value is a float, which rounding leaves alone;
 *   - the result lies within [a, b], since these are floats and the exact value lies within;
 *   - it is monotone in share, because the exact value is;
 *   - it is monotone in a and in b, because the exact value is.
 * So bilinear filtering, mix(mix, mix), is bounded and monotone in u and in v, and trilinear
 * filtering between levels too. a + (b - a) f in binary32 is not monotone in a, and overflows;
 * a (1 - f) + b f does not keep constants.
 *
 * Share 0 does not touch b: 0 * infinity would make a NaN of a texel that has no part in this. */
static float mix(float a, float b, uint32_t share)
{
    if (share == 0)
        return a;
    double sum = (double)a * (double)(ONE - share) + (double)b * (double)share;
    return (float)(sum * (1.0 / ONE));
}

/* Floats, sRGB (after decoding) and depth read as a colour. */
static void filter_floats(GpFormat format, const Footprint *f, float rgba[4])
{
    float texel[4][4];
    for (int i = 0; i < 4; i++)
        gp_texel_load(format, f->tap[i].texel, texel[i]);
    for (int c = 0; c < 4; c++) {
        float upper = mix(texel[0][c], texel[1][c], f->share_x);
        float lower = mix(texel[2][c], texel[3][c], f->share_x);
        rgba[c] = mix(upper, lower, f->share_y);
    }
}

/* 8-bit codes: the weighted sum is at most 255 * 2^16 < 2^24, an exact float, and the division
 * rounds once. The result is the exact bilinear value, correctly rounded; with one texel it is
 * that texel's code / 255 (R23). Lanes need only 16-bit products for the rows. */
static void filter_codes(GpFormat format, const Footprint *f, float rgba[4])
{
    uint32_t sum[4] = { 0 };
    for (int i = 0; i < 4; i++) {
        uint8_t code[4];
        gp_texel_codes(format, f->tap[i].texel, code);
        for (int c = 0; c < 4; c++)
            sum[c] += code[c] * f->tap[i].weight;
    }
    for (int c = 0; c < 4; c++)
        rgba[c] = (float)sum[c] / (float)(255 * ONE * ONE);
}

/* Whether a texel is not in front of the reference depth (R49). Both sides are converted: the
 * reference is clamped and rounded to the stored format before it is compared, or a surface could
 * not pass the test against its own depth. D32F codes are floats and compared as such. */
static bool passes(GpFormat format, float reference, const void *texel)
{
    float clamped = reference < 0.0f ? 0.0f : reference > 1.0f ? 1.0f : reference;
    uint32_t code = gp_depth_code(format, clamped), stored;
    uint8_t stencil;
    gp_depth_load(format, texel, &stored, &stencil);
    return gp_format_info(format)->depth_bits == 32 ? gp_bits_float(code) <= gp_bits_float(stored)
                                                    : code <= stored;
}

/* The share of the texels that pass. */
static void filter_compare(GpFormat format, const Footprint *f, float reference, float rgba[4])
{
    uint32_t passed = 0;
    for (int i = 0; i < 4; i++)
        if (passes(format, reference, f->tap[i].texel))
            passed += f->tap[i].weight;
    for (int c = 0; c < 4; c++)
        rgba[c] = (float)passed / (float)(ONE * ONE);
}

/* --- sampling --------------------------------------------------------------------------------- */

/* Appends the texels that have a part in the result; part: of this level, in 256ths; reference: of
 * samplers that compare. */
static void report_texels(GpFormat format, uint32_t level, uint32_t part, const Footprint *f,
                          float reference, GpSampleReport *report)
{
    for (int i = 0; i < 4; i++) {
        const Tap *tap = &f->tap[i];
        if (tap->weight == 0)
            continue;
        GpTexelUse *use = &report->texel[report->count++];
        use->x = tap->x;
        use->y = tap->y;
        use->level = (uint8_t)level;
        use->weight = (float)(tap->weight * part) * 0x1p-24f; /* at most 2^24: exact */
        gp_texel_load(format, tap->texel, use->value);
        use->passes = report->compares && passes(format, reference, tap->texel);
    }
}

static void sample_level(const GpTexture *texture, uint32_t number, uint32_t part, GpFilter filter,
                         const float uvr[3], float rgba[4], GpSampleReport *report)
{
    const GpSurface *surface = texture->surface;
    const GpFormat format = surface->format;
    uint8_t border[16];

    gp_texture_border(texture, border);
    Footprint f = find_texels(texture, &surface->level[number], filter, uvr, border);
    if (texture->sampler.compare)
        filter_compare(format, &f, uvr[2], rgba);
    else if (gp_format_info(format)->is_unorm8)
        filter_codes(format, &f, rgba);
    else
        filter_floats(format, &f, rgba);
    if (report)
        report_texels(format, number, part, &f, uvr[2], report);
}

void gp_texture_sample(const GpTexture *texture, const float uvr[3], float lod, float rgba[4],
                       GpSampleReport *report)
{
    if (report)
        *report = (GpSampleReport){ 0 };
    if (!texture->surface) {
        rgba[0] = rgba[1] = rgba[2] = 0.0f;
        rgba[3] = 1.0f;
        return;
    }

    const GpSampler *sampler = &texture->sampler;
    const GpLevelPair levels = gp_level_pair(sampler, texture->surface->levels, lod);
    const GpFilter filter = levels.magnified ? sampler->mag : sampler->min;
    if (report) {
        report->lod = levels.lod;
        report->magnified = levels.magnified;
        report->compares = sampler->compare;
    }

    sample_level(texture, levels.first, ONE - levels.share, filter, uvr, rgba, report);
    if (levels.share) {
        float coarse[4];
        sample_level(texture, levels.first + 1, levels.share, filter, uvr, coarse, report);
        for (int c = 0; c < 4; c++)
            rgba[c] = mix(rgba[c], coarse[c], levels.share);
    }
}
