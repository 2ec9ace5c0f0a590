/* Depth and stencil of GP_LANES pixels inside the tile, in any state. */
#include "pipeline/fast/lanes/output/depth.h"

/* --- the stencil plane ------------------------------------------------------------------------ */

static itg load_stencil(const uint8_t *from, bool quads)
{
    const itg x = lane_columns(quads), y = lane_rows(quads);
    itg words;
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        words[lane] = from[fast_at(x[lane], y[lane])];
    return words;
}

static void store_stencil(uint8_t *to, bool quads, itg words)
{
    const itg x = lane_columns(quads), y = lane_rows(quads);
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        to[fast_at(x[lane], y[lane])] = (uint8_t)words[lane];
}

/* --- stencil operations ----------------------------------------------------------------------- */

/* As gp_stencil_apply; the bits above a byte are cut off later. */
static itg apply(GpStencilOp op, itg stored, uint8_t reference)
{
    switch (op) {
    case GP_STENCIL_ZERO:
        return itg_set(0);
    case GP_STENCIL_REPLACE:
        return itg_set(reference);
    case GP_STENCIL_INCR_SAT:
        return itg_lesser(stored + 1, itg_set(255));
    case GP_STENCIL_DECR_SAT:
        return itg_greater(stored - 1, itg_set(0));
    case GP_STENCIL_INVERT:
        return ~stored;
    case GP_STENCIL_INCR:
        return stored + 1;
    case GP_STENCIL_DECR:
        return stored - 1;
    default:
        return stored;
    }
}

/* Updates the stencils of live lanes; returns those whose stencil test passes. */
static msk test_stencil(const GpStencilState *s, bool front, uint8_t *stencil, bool quads, msk live,
                        msk nearer)
{
    const GpStencilFace *face = s->two_sided && !front ? &s->back : &s->front;
    const uint8_t looked_at = (uint8_t)~s->ignore;
    itg stored = load_stencil(stencil, quads);
    msk passed =
        compare_codes(face->test, itg_set(s->reference & looked_at), stored & (int32_t)looked_at);
    itg result = itg_select(nearer, apply(face->pass, stored, s->reference),
                            apply(face->depth_fail, stored, s->reference));
    result = itg_select(passed, result, apply(face->fail, stored, s->reference));
    result = itg_select(itg_set(s->keep), stored, result);
    store_stencil(stencil, quads, itg_select(live, result, stored));
    return passed;
}

msk fast_test_depth_stencil(Tile *tile, const FastDraw *d, uint32_t at, bool quads, msk live, flt z,
                            bool front, msk *replaced)
{
    const GpState *state = &d->draw->state;
    itg stored = load_lanes(tile->depth + at, quads);
    itg incoming = coming_codes(tile, d, z);
    itg written = incoming;
    msk passed, nearer = itg_set(0);
    if (d->needs.ternary) {
        passed = (msk)(incoming <= put_back(tile, d, stored));
        nearer = (msk)(put_back(tile, d, incoming) < stored);
        written = itg_lesser(incoming, stored);
    } else
        passed = compare_codes(state->depth.test, incoming, stored);
    if (d->needs.stencil)
        passed &= test_stencil(&state->stencil, front, tile->stencil + at, quads, live, passed);
    passed &= live;
    *replaced = nearer & passed;
    if (state->depth.write)
        store_lanes(tile->depth + at, quads, itg_select(passed, written, stored));
    return passed;
}

unsigned fast_test_packet(Tile *tile, const FastDraw *d, const FastPacket *packet, bool front,
                          unsigned live, flt z, unsigned *replaced)
{
    uint32_t at = fast_at(packet->x, packet->y);
    const bool rows = packet->wide && packet->wide != GP_LANES;
    const itg row = lane_row(rows ? packet->wide : GP_LANES);
    msk passed = itg_set(0), all_nearer = itg_set(0), nearer;
    for (int r = 0; rows ? has_row(packet, r) : r == 0; r++, at += FAST_PITCH - packet->wide) {
        passed |= fast_test_depth_stencil(tile, d, at, !packet->wide,
                                          (msk)(row == r) & mask_of(live), z, front, &nearer);
        all_nearer |= nearer;
    }
    *replaced = msk_bits(all_nearer);
    return msk_bits(passed);
}
