/* Depth and stencil of GP_LANES pixels inside the tile. */
#include "pipeline/fast/lanes/depth.h"

#include "pipeline/depth_stencil.h"

#include <string.h>

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
