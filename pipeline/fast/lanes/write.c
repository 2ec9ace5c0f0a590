/* Writing of mixes: each lane replaces all that its pixel held. */
#include "pipeline/fast/lanes/patch.h"
#include "pipeline/fast/lanes/through.h"

static void scatter(uint32_t *plane, const FastMix *mix, itg words)
{
    for (unsigned left = mix->live; left; left &= left - 1) {
        int lane = __builtin_ctz(left);
        plane[fast_at(mix->x[lane], mix->y[lane])] = (uint32_t)words[lane];
    }
}

static void write_plane(void *plane, const FastMix *mix, itg words)
{
    const FastPatch place = { .x = (uint8_t)mix->x[0],
                              .y = (uint8_t)mix->y[0],
                              .wide = mix->quads ? 0 : GP_LANES };
    if (mix->packed)
        scatter(plane, mix, words);
    else
        store_patch(plane, &place, mix->live, words);
}

void FAST(write_mix)(Tile *tile, const FastDraw *d, const FastMix *mix, const flt *color)
{
    for (int t = 0; t < tile->targets; t++, color += 4) {
        const GpFormat format = d->pass->color[t].surface->format;
        FastPlanes *planes = tile->planes[t];
        if (format == GP_A8R8G8B8) {
            write_plane(planes->packed, mix, word_of_any(color));
            continue;
        }
        for (int c = 0; c < gp_format_info(format)->channels; c++)
            write_plane(planes->channel[c], mix, (itg)through(format, color[c]));
    }
}
