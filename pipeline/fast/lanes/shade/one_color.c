#include "pipeline/fast/lanes/shade/one_color.h"

#include "pipeline/fast/lanes/shade/interpolate_gathered.h"
#include "pipeline/fast/lanes/shade/pixel_shader.h"

uint32_t fast_begin_color(Tile *tile, uint32_t record, bool front)
{
    FastQueue *q = tile->queue;
    FastFragments *f = tile->fragments;
    const bool has_layer = fast_has_layer(f);
    if (q->colors == FAST_COLORS || !has_layer)
        fast_find_colors(tile);
    if (!has_layer)
        fast_make_layer(tile);
    f->deepest++;
    q->color_record[q->colors++] = record;
    f->source[f->shaded_count] = fast_source(tile, tile->draw, front);
    return f->shaded_count++;
}

/* Gathered packets of a fragment a triangle, wherever it is. */
static int gather(FastQueue *q)
{
    const int count = ((int)q->colors + GP_LANES - 1) / GP_LANES;
    for (int i = (int)q->colors; i < count * GP_LANES; i++)
        q->color_record[i] = q->color_record[0];
    for (int p = 0; p < count; p++) {
        FastGathered *gathered = &q->gathered[p];
        gathered->record = load_lanes(q->color_record + p * GP_LANES, false);
        gathered->place = itg_set(0);
        gathered->live = ALL_LANES;
    }
    return count;
}

void fast_find_colors(Tile *tile)
{
    FastQueue *q = tile->queue;
    const FastFragments *f = tile->fragments;
    const FastDraw *d = tile->draw;
    if (!q->colors)
        return;
    const FastPhase before = fast_turn_to(tile, FAST_SHADING);
    const int count = gather(q), written = gp_program_targets(d->draw->program);
    const size_t words = 4 * (size_t)f->targets;
    fast_interpolate_gathered(tile, d, q->gathered, count, fast_inputs(tile));
    fast_run_pixel_shader(tile, d, &(FastPacketBlock){ .gathered = q->gathered, .count = count });
    float *to = f->color + (f->shaded_count - q->colors) * words;
    const flt *color = fast_colors(tile);
    for (int p = 0; p < count; p++, to += GP_LANES * words, color += 4 * written)
        for (int t = 0; t < written && t < tile->targets; t++)
            lanes_store4(to + 4 * t, words * sizeof(float), (const itg *)(color + 4 * t));
    tile->fragments_shaded += q->colors;
    q->colors = 0;
    fast_turn_to(tile, before);
}
