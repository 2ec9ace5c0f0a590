/* Depth and stencil of GP_LANES pixels inside the tile. */
#include "pipeline/fast/lanes/tile.h"

#include "pipeline/compare.h"
#include "pipeline/depth_stencil.h"

#include <string.h>

/* Depth to the code that is stored, as gp_depth_code: unorm by binary64, floats by their bits. */
static itg depth_codes(GpFormat format, flt z)
{
    if (format == GP_D32F) {
        itg bits = (itg)(z + 0.0f); /* -0 becomes 0 */
        return itg_select((itg)(z == z), bits, itg_set(0x7fc00000));
    }
    double scale = format == GP_D16 ? 65535.0 : 16777215.0;
    flt safe = flt_select(z > 0.0f, z, flt_set(0)); /* NaN to 0 */
    return __builtin_convertvector(__builtin_convertvector(safe, dbl) * scale + 0.5, itg);
}

/* Codes are below 2^31, so signed comparison is right. */
static msk compare_codes(GpCompare test, itg a, itg b)
{
    msk less = (msk)(a < b), equal = (msk)(a == b);
    msk accepted = itg_set(0);
    if (gp_compare_accepts(test, GP_IS_LESS))
        accepted |= less;
    if (gp_compare_accepts(test, GP_IS_EQUAL))
        accepted |= equal;
    if (gp_compare_accepts(test, GP_IS_GREATER))
        accepted |= ~(less | equal);
    return accepted;
}

static uint8_t stencil_after(const GpStencilState *s, const GpStencilFace *face, uint8_t stored,
                             bool depth_passed, bool *passed)
{
    uint8_t seen = (uint8_t)~s->ignore;
    *passed = gp_compare_codes(face->test, s->reference & seen, stored & seen);
    GpStencilOp op = !*passed ? face->fail : !depth_passed ? face->depth_fail : face->pass;
    uint8_t result = gp_stencil_apply(op, stored, s->reference);
    return (uint8_t)((stored & s->keep) | (result & ~s->keep));
}

unsigned FAST(depth_stencil)(Tile *tile, const FastDraw *d, uint32_t at, unsigned live, flt z,
                             bool front)
{
    const GpState *state = &d->draw->state;
    itg stored, incoming = depth_codes(tile->depth_format, z);
    memcpy(&stored, tile->depth + at, sizeof stored);
    unsigned passed = live & msk_bits(compare_codes(state->depth.test, incoming, stored));
    if (d->needs.stencil) {
        const GpStencilFace *face =
            state->stencil.two_sided && !front ? &state->stencil.back : &state->stencil.front;
        GP_UNROLL
        for (int lane = 0; lane < GP_LANES; lane++) {
            if (!(live >> lane & 1))
                continue;
            bool stencil_passed;
            uint8_t *stencil = &tile->stencil[at + (uint32_t)lane];
            *stencil =
                stencil_after(&state->stencil, face, *stencil, passed >> lane & 1, &stencil_passed);
            if (!stencil_passed)
                passed &= ~(1u << lane);
        }
    }
    if (state->depth.write && passed) {
        stored = itg_select(mask_of(passed), incoming, stored);
        memcpy(tile->depth + at, &stored, sizeof stored);
    }
    return passed;
}
