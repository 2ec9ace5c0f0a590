/* Shading of gathered packets, of draws that replace all that a pixel held. */
#include "pipeline/fast/lanes/shade/gathered.h"

#include "pipeline/fast/lanes/output/quantize.h"
#include "pipeline/fast/lanes/shade/interpolate_gathered.h"
#include "pipeline/fast/lanes/shade/pixel_shader.h"

#include <string.h>

/* Words of a gathered packet's pixels, and the planes they go to. */
typedef struct Written {
    uint32_t *plane[4];
    itg words[4];
} Written;

GP_INLINE void scatter(const FastGathered *gathered, const Written *written, int planes)
{
    uint32_t place[GP_LANES], word[4][GP_LANES];
    store_lanes(place, false, gathered_at(gathered));
    memcpy(word, written->words, sizeof word);
    for (unsigned left = gathered->live; left; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        for (int i = 0; i < planes; i++)
            written->plane[i][place[lane]] = word[i][lane];
    }
}

GP_INLINE void write_words(const FastGathered *gathered, const Written *written, int planes)
{
    if (!gathered->is_row) {
        scatter(gathered, written, planes);
        return;
    }
    const uint32_t at = (uint32_t)gathered_at(gathered)[0];
    for (int i = 0; i < planes; i++)
        store_lanes(written->plane[i] + at, false, written->words[i]);
}

/* in   color: of the first packet, `stride` vectors before that of the next */
static void write_packed(FastPlanes *planes, GpFormat format, const FastGathered *gathered,
                         int count, const flt *color, int stride)
{
    const int32_t filled = (int32_t)fast_filled_bits(format);
    Written written = { .plane = { planes->packed } };
    for (int p = 0; p < count; p++, color += stride) {
        written.words[0] = word_of_any(color) | filled;
        write_words(&gathered[p], &written, 1);
    }
}

static void write_channels(FastPlanes *planes, GpFormat format, const FastGathered *gathered,
                           int count, const flt *color, int stride)
{
    const int channels = gp_format_info(format)->channels;
    Written written;
    for (int c = 0; c < 4; c++)
        written.plane[c] = (uint32_t *)(void *)planes->channel[c];
    for (int p = 0; p < count; p++, color += stride) {
        for (int c = 0; c < channels; c++)
            written.words[c] = plane_word(format, quantize(format, color[c]));
        write_words(&gathered[p], &written, channels);
    }
}

static void write_gathered(Tile *tile, const FastDraw *d, const FastGathered *gathered, int count,
                           const flt *color)
{
    const int stride = gp_program_targets(d->draw->program) * 4;
    for (int t = 0; t < tile->targets; t++, color += 4) {
        const GpFormat format = d->pass->color[t].surface->format;
        if (fast_is_packed(format))
            write_packed(tile->planes[t], format, gathered, count, color, stride);
        else
            write_channels(tile->planes[t], format, gathered, count, color, stride);
    }
}

void fast_shade_gathered(Tile *tile, const FastDraw *d, const FastGathered *gathered, int count)
{
    fast_interpolate_gathered(tile, d, gathered, count, fast_inputs(tile));
    fast_run_pixel_shader(tile, d, &(FastPacketBlock){ .gathered = gathered, .count = count });
    for (int p = 0; p < count; p++)
        tile->fragments_shaded += (uint64_t)__builtin_popcount(gathered[p].live);
    write_gathered(tile, d, gathered, count, fast_colors(tile));
}
