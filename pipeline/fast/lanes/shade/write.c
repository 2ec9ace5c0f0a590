/* Writing of mixes: each lane replaces all that its pixel held. */
#include "pipeline/fast/lanes/shade/mix.h"
#include "pipeline/fast/lanes/shade/patch.h"
#include "pipeline/fast/lanes/output/quantize.h"

#include <string.h>

/* Words of a mix's pixels, and the planes they go to. */
typedef struct Written {
    uint32_t *plane[4];
    itg words[4];
} Written;

GP_INLINE void scatter(const FastMix *mix, const Written *written, int planes)
{
    uint32_t place[GP_LANES], word[4][GP_LANES];
    const itg at = mix->y * FAST_PITCH + mix->x;
    memcpy(place, &at, sizeof place);
    memcpy(word, written->words, sizeof word);
    for (unsigned left = mix->live; left; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        for (int i = 0; i < planes; i++)
            written->plane[i][place[lane]] = word[i][lane];
    }
}

GP_INLINE void write_words(const FastMix *mix, const Written *written, int planes)
{
    if (mix->packed) {
        scatter(mix, written, planes);
        return;
    }
    const FastPatch place = { .x = (uint8_t)mix->x[0],
                              .y = (uint8_t)mix->y[0],
                              .wide = mix->quads ? 0 : GP_LANES };
    for (int i = 0; i < planes; i++)
        store_patch(written->plane[i], &place, mix->live, written->words[i]);
}

/* Color: of the first mix, `stride` vectors before that of the next. */

static void write_packed(FastPlanes *planes, const FastMix *mixes, int count, const flt *color,
                         int stride)
{
    Written written = { .plane = { planes->packed } };
    for (int p = 0; p < count; p++, color += stride) {
        written.words[0] = word_of_any(color);
        write_words(&mixes[p], &written, 1);
    }
}

static void write_channels(FastPlanes *planes, GpFormat format, const FastMix *mixes, int count,
                           const flt *color, int stride)
{
    const int channels = gp_format_info(format)->channels;
    Written written;
    for (int c = 0; c < 4; c++)
        written.plane[c] = (uint32_t *)(void *)planes->channel[c];
    for (int p = 0; p < count; p++, color += stride) {
        for (int c = 0; c < channels; c++)
            written.words[c] = (itg)through(format, color[c]);
        write_words(&mixes[p], &written, channels);
    }
}

void FAST(write_mixes)(Tile *tile, const FastDraw *d, const FastMix *mixes, int count,
                       const flt *color)
{
    const int stride = gp_program_targets(d->draw->program) * 4;
    for (int t = 0; t < tile->targets; t++, color += 4) {
        const GpFormat format = d->pass->color[t].surface->format;
        if (format == GP_A8R8G8B8)
            write_packed(tile->planes[t], mixes, count, color, stride);
        else
            write_channels(tile->planes[t], format, mixes, count, color, stride);
    }
}
