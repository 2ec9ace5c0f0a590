/* Binning in lanes: GP_LANES triangles at a time are culled and put in the bins of their tiles. */
#include "pipeline/fast/lanes/tile.h"

/* Largest extent, in sub-pixels, at which areas and edges fit into 32 bits. */
enum { FITS = 1 << 15 };

GP_INLINE itg least(itg a, itg b)
{
    return itg_select((itg)(a < b), a, b);
}

GP_INLINE itg most(itg a, itg b)
{
    return itg_select((itg)(a > b), a, b);
}

/* A run of triangles of one draw. Those that are large, or outside some plane, are left to the code
 * that takes one at a time: rare, and not much dearer. */
static void bin_triangles(const FastPass *pass, const FastDraw *d, FastRange *range, uint32_t first,
                          uint32_t count)
{
    const GpGeometry *geometry = &d->draw->geometry;
    uint32_t base = 3 * (first - d->first_primitive);
    const void *record[3][GP_LANES];
    unsigned alone = 0;
    GP_UNROLL
    for (uint32_t lane = 0; lane < GP_LANES; lane++) {
        uint32_t at = base + 3 * (lane < count ? lane : 0);
        unsigned outside = 0;
        for (uint32_t k = 0; k < 3; k++) {
            uint32_t number = geometry->indices ? geometry->indices[at + k] : at + k;
            number -= d->first_vertex;
            record[k][lane] = &d->positions[number];
            outside |= d->outside[number];
        }
        alone |= (unsigned)(outside != 0) << lane;
    }
    itg p[3][4];
    for (int k = 0; k < 3; k++)
        lanes_load4(record[k], p[k]);

    itg low_x = least(p[0][0], least(p[1][0], p[2][0]));
    itg high_x = most(p[0][0], most(p[1][0], p[2][0]));
    itg low_y = least(p[0][1], least(p[1][1], p[2][1]));
    itg high_y = most(p[0][1], most(p[1][1], p[2][1]));
    alone |= msk_bits((itg)(high_x - low_x >= FITS) | (itg)(high_y - low_y >= FITS));

    itg area2 =
        cross_lanes(p[1][0] - p[0][0], p[2][1] - p[0][1], p[2][0] - p[0][0], p[1][1] - p[0][1]);
    GpCull cull = d->draw->state.raster.cull;
    msk drawn = cull == GP_CULL_CW    ? (msk)(area2 < 0)
                : cull == GP_CULL_CCW ? (msk)(area2 > 0)
                                      : (msk)(area2 != 0);
    const int32_t half = GP_SUBPIXELS / 2;
    itg x0 = most((low_x + (half - 1)) >> GP_SUBPIXEL_BITS, itg_set(d->rect.x0));
    itg y0 = most((low_y + (half - 1)) >> GP_SUBPIXEL_BITS, itg_set(d->rect.y0));
    itg x1 = least((high_x - half) >> GP_SUBPIXEL_BITS, itg_set(d->rect.x1 - 1));
    itg y1 = least((high_y - half) >> GP_SUBPIXEL_BITS, itg_set(d->rect.y1 - 1));
    drawn &= (msk)(x0 <= x1) & (msk)(y0 <= y1);

    unsigned left = (msk_bits(drawn) | alone) & (unsigned)((1u << count) - 1);
    while (left) {
        uint32_t lane = (uint32_t)__builtin_ctz(left);
        left &= left - 1;
        if (alone >> lane & 1)
            fast_bin_primitive(pass, d, range, first + lane);
        else
            fast_bin_box(pass, range, first + lane,
                         &(FastBox){ x0[lane], y0[lane], x1[lane], y1[lane] });
    }
}

void FAST(bin_range)(const FastPass *pass, FastRange *range, uint32_t first, uint32_t end)
{
    uint32_t number = fast_find_draw(pass, first);
    while (first < end) {
        const FastDraw *d = &pass->draws[number];
        uint32_t draw_end = d->first_primitive + d->primitive_count;
        uint32_t stop = draw_end < end ? draw_end : end;
        bool triangles = d->draw->geometry.primitive == GP_TRIANGLES;
        while (first < stop) {
            uint32_t count = stop - first < GP_LANES ? stop - first : GP_LANES;
            if (triangles)
                bin_triangles(pass, d, range, first, count);
            for (uint32_t i = 0; !triangles && i < count; i++)
                fast_bin_primitive(pass, d, range, first + i);
            first += count;
        }
        number++;
    }
}
