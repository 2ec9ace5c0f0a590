/* Blending that only adds, of sprites, into targets of floats: what splats and glows do. Their rows
 * are short and begin anywhere, and memory takes most of the time: each row is read and written
 * once, in pieces that seldom meet the end of a cache line. */
#include "pipeline/fast/lanes/output/blend_add.h"

static bool adds(const GpBlend *blend, GpFormat format)
{
    return gp_format_info(format)->is_float && blend->op == GP_BLEND_ADD && blend->src == GP_ONE &&
           blend->dst == GP_ONE && blend->alpha_op == GP_BLEND_OFF && !(blend->keep & 15);
}

bool fast_only_adds(const Tile *tile, const FastDraw *d)
{
    int written = gp_program_targets(d->draw->program);
    if (d->draw->geometry.primitive != GP_POINTS || d->needs.quads || !d->needs.color)
        return false;
    for (int t = 0; t < written && t < tile->targets; t++)
        if (!adds(&d->draw->state.blend[t], d->pass->color[t].surface->format))
            return false;
    return true;
}

GP_INLINE void add_piece(FastPlanes *planes, int channels, bool halves, uint32_t at,
                         const float *color, unsigned live)
{
    GP_UNROLL
    for (int c = 0; c < channels; c++)
        piece_add(planes->channel[c] + at, color + c * GP_LANES, live, halves);
}

/* A row, or packed rows. Lanes that follow those of a row are read with it, but never live. */
GP_INLINE void add_packet(FastPlanes *planes, int channels, bool halves, const FastPacket *packet,
                          unsigned live, const float *color)
{
    const int wide = packet->wide;
    const unsigned row = (1u << wide) - 1;
    uint32_t at = fast_at(packet->x, packet->y);
    for (; live; live >>= wide, color += wide, at += FAST_PITCH) {
        add_piece(planes, channels, halves, at, color, live & row);
        if (wide > GP_PIECE)
            add_piece(planes, channels, halves, at + GP_PIECE, color + GP_PIECE,
                      (live & row) >> GP_PIECE);
    }
}

GP_INLINE void add_all(FastPlanes *planes, int channels, bool halves, const FastShaded *shaded,
                       const flt *color)
{
    for (int p = 0; p < shaded->block.count; p++, color += shaded->stride)
        add_packet(planes, channels, halves, &shaded->block.packets[p], shaded->live[p],
                   (const float *)(const void *)color);
}

void fast_add_packets(Tile *tile, const FastDraw *d, const FastShaded *shaded)
{
    const int written = gp_program_targets(d->draw->program);
    const flt *color = shaded->color;
    for (int t = 0; t < written && t < tile->targets; t++, color += 4) {
        FastPlanes *planes = tile->planes[t];
        switch (d->pass->color[t].surface->format) {
        case GP_R32F:
            add_all(planes, 1, false, shaded, color);
            break;
        case GP_G16R16F:
            add_all(planes, 2, true, shaded, color);
            break;
        case GP_A16B16G16R16F:
            add_all(planes, 4, true, shaded, color);
            break;
        default:
            add_all(planes, 4, false, shaded, color);
        }
    }
}
