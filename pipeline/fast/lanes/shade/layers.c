#include "pipeline/fast/lanes/shade/layers.h"

#include "pipeline/fast/lanes/output/blend.h"
#include "pipeline/fast/lanes/output/blend_bits.h"
#include "pipeline/fast/lanes/shade/framebuffer_fetch.h"
#include "pipeline/fast/lanes/shade/interpolate_packets.h"
#include "pipeline/fast/lanes/shade/packets.h"
#include "pipeline/fast/lanes/shade/pixel_shader.h"

/* What the interpolants of a layer need, found once for all its pixels. Layers mostly have one
 * shape. */
typedef struct Layer {
    const FastTriangleRecord *record;
    FastNarrowEdges edges;
    bool perspective;
    bool as_last; /* the weights are those of the layer before it */
    FastComponent component[GP_MAX_VARYINGS];
} Layer;

static bool same_weights(const Layer *a, const Layer *b)
{
    const FastEdge *one = a->edges.edge, *other = b->edges.edge;
    bool same = a->record->ratio1 == b->record->ratio1 && a->record->ratio2 == b->record->ratio2 &&
                a->edges.inverse_area == b->edges.inverse_area;
    for (int i = 0; i < 3; i++)
        same &= one[i].c == other[i].c && one[i].a == other[i].a && one[i].b == other[i].b &&
                one[i].unit == other[i].unit;
    return same;
}

/* False where an edge does not fit into 32 bits. */
static bool find_layers(const Tile *tile, const FastLayers *layers, Layer *layer)
{
    for (uint32_t k = 0; k < layers->count; k++, layer++) {
        layer->record = &tile->records->record[layers->record[k]];
        layer->perspective = fast_needs_perspective(tile->draw, layer->record);
        if (!fast_narrow_edges(tile->records, layer->record, layer->perspective, &layer->edges))
            return false;
        layer->as_last = k > 0 && same_weights(layer, layer - 1);
        fast_prepare_components(tile->draw, layer->record, layer->component);
    }
    return true;
}

/* Whether the shader can interpolate: what varies varies in one way, and all layers have one
 * shape. */
static bool leaves_interpolation(const FastDraw *d, const FastLayers *layers, const Layer *layer)
{
    const uint64_t perspective = d->varyings_by[GP_PERSPECTIVE],
                   screen = d->varyings_by[GP_LINEAR_SCREEN];
    bool leaves = d->modes.components <= GP_FEW_COMPONENTS && !d->varyings_by[GP_FLAT] &&
                  !perspective != !screen;
    for (uint32_t k = 1; k < layers->count; k++)
        leaves &= layer[k].as_last;
    return leaves;
}

/* Gives a block, whose packets are [layer][pixels], interpolants from weights that all layers
 * share.
 * out  weights, interpolants: what the block then points at */
static void set_interpolants(const Tile *tile, const Layer *layer, FastPacketBlock *block,
                             FastWeights *weights, GpInterpolants *interpolants)
{
    fast_find_weights(tile->draw, layer->record, &layer->edges, layer->perspective, block->packets,
                      block->count / block->layers, weights);
    const flt(*weight)[FAST_BLOCK] =
        weights->has_perspective ? weights->perspective : weights->screen;
    for (int k = 0; k < block->layers; k++)
        interpolants[k] =
            (GpInterpolants){ .value = (const float *)(const void *)layer[k].component,
                              .weight = { (const float *)(const void *)weight[0],
                                          (const float *)(const void *)weight[1] } };
    block->interpolants = interpolants;
}

/* The inputs of such a block. */
static void interpolate_layers(const Tile *tile, const Layer *layer, const FastPacketBlock *block)
{
    const FastDraw *d = tile->draw;
    const int count = block->count / block->layers;
    const bool varies = d->varyings_by[GP_PERSPECTIVE] | d->varyings_by[GP_LINEAR_SCREEN];
    FastWeights weights;
    weights.has_perspective = false;
    flt *in = fast_inputs(tile);
    for (int k = 0; k < block->layers; k++, layer++, in += count * d->modes.components) {
        if (varies && !layer->as_last)
            fast_find_weights(d, layer->record, &layer->edges, layer->perspective, block->packets,
                              count, &weights);
        fast_interpolate_prepared(d, layer->record, layer->component, &weights, count, in);
    }
}

/* What blocks of `count` packets a layer have in common. */
static void begin_packets(const FastLayers *layers, uint32_t count, FastPacket *packets)
{
    for (uint32_t k = 0; k < layers->count; k++)
        for (uint32_t i = 0; i < count; i++)
            set_packet(&packets[k * count + i], layers->record[k], 0, 0, ALL_LANES, GP_LANES);
}

/* Packets of some layers on the next `count` packets of the box, whose first is at (x, y). Those of
 * a box without an edge to the right live whole, as they began. */
static void place_packets(const FastLayers *layers, uint32_t placed, bool whole, uint32_t count,
                          int32_t *x, int32_t *y, FastPacket *packets)
{
    const FastBox *box = &layers->box;
    const FastPacket *const end = packets + placed * count;
    for (uint32_t i = 0; i < count; i++) {
        const uint8_t left = (uint8_t)*x, top = (uint8_t)*y;
        const int32_t pixels = box->x1 - *x + 1;
        for (FastPacket *packet = packets + i; packet < end; packet += count) {
            packet->x = left;
            packet->y = top;
            if (!whole)
                packet->live = pixels < GP_LANES ? (1u << pixels) - 1 : ALL_LANES;
        }
        *x += GP_LANES;
        if (*x > box->x1) {
            *x = box->x0;
            ++*y;
        }
    }
}

/* The same so many rows further down: fills take 6 % less with AVX2, 2 % with AVX-512. */
static void move_packets(uint32_t count, int32_t rows, FastPacket *packets)
{
    for (uint32_t i = 0; i < count; i++)
        packets[i].y = (uint8_t)(packets[i].y + rows);
}

/* Of how many layers someone asks where packets are: plain ones, which share their weights' places
 * and are blended as layers, say it for all by their first. */
static uint32_t layers_to_place(const FastDraw *d, bool plain, uint32_t layers)
{
    const GpProgram *program = d->draw->program;
    bool first = plain && !program->uses_pixel && !program->local_reads;
    for (int t = 0; t < gp_program_targets(program); t++)
        first &= fast_blends_layers(&d->blend[t]);
    return first ? 1 : layers;
}

/* Whether the shader gives all pixels the same colour, which layers are drawn for: it looks at
 * nothing that differs. */
static bool are_alike(Tile *tile)
{
    const FastDraw *d = tile->draw;
    const GpProgram *program = d->draw->program;
    if (d->needs.varyings || program->samplers || program->uses_pixel || program->uses_face ||
        program->may_discard || d->needs.alpha_test)
        return false;
    for (unsigned left = program->local_reads; left; left &= left - 1) {
        const int slot = __builtin_ctz(left);
        const FastFetch *fetch = &tile->block->fetch[slot];
        fast_begin_fetch(tile, d->draw->textures, slot);
        if (fetch->format == GP_FORMAT_NONE || fetch->sums || fetch->plane[0])
            return false;
    }
    return true;
}

/* Blends a block for which one packet was shaded. */
static void blend_alike(Tile *tile, const FastPacketBlock *block)
{
    unsigned live[FAST_BLOCK];
    for (int p = 0; p < block->count; p++) {
        live[p] = block->packets[p].live;
        tile->fragments_shaded += (uint64_t)__builtin_popcount(live[p]);
    }
    fast_blend_packets(tile, tile->draw,
                       &(FastShaded){ .block = *block, .live = live, .color = fast_colors(tile) });
}

static void shade_blocks(Tile *tile, const FastLayers *layers, FastPacket *packets)
{
    const FastDraw *d = tile->draw;
    const FastBox *box = &layers->box;
    Layer layer[FAST_LAYERS];
    FastWeights weights;
    GpInterpolants interpolants[FAST_LAYERS];
    const bool narrow = find_layers(tile, layers, layer), alike = are_alike(tile);
    const bool leaves = narrow && leaves_interpolation(d, layers, layer);
    const int room = (leaves && layers->count > 1 ? FAST_MOST : FAST_BLOCK) / (int)layers->count;
    const bool even = (box->x1 - box->x0 + 1) % GP_LANES == 0;
    const bool whole = even && !d->draw->program->may_discard && !d->needs.alpha_test;
    const uint32_t placed = layers_to_place(d, whole && narrow, layers->count);
    const int across = (box->x1 - box->x0) / GP_LANES + 1, most = across * (box->y1 - box->y0 + 1);
    const bool whole_rows = even && room % across == 0; /* of a block */

    int32_t x = box->x0, y = box->y0;
    for (int done = 0, count; done < most; done += count) {
        count = most - done < room ? most - done : room;
        FastPacketBlock block = {
            .packets = packets, .count = 1, .layers = (int)layers->count, .whole = whole
        };
        if (done == 0 || count < room)
            begin_packets(layers, (uint32_t)count, packets);
        if (whole_rows && done > 0 && count == room) {
            move_packets(placed * (uint32_t)count, room / across, packets);
            y += room / across;
        } else
            place_packets(layers, placed, even, (uint32_t)count, &x, &y, packets);
        if (alike && done == 0)
            fast_run_pixel_shader(tile, d, &block);
        block.count = block.layers * count;
        if (alike)
            blend_alike(tile, &block);
        else if (!narrow)
            fast_shade_packets(tile, d, &block);
        else {
            if (leaves)
                set_interpolants(tile, layer, &block, &weights, interpolants);
            else
                interpolate_layers(tile, layer, &block);
            fast_shade_inputs(tile, d, &block);
        }
    }
}

/* Of a draw that copies words; false, and nothing done, where the tile does not hold them. */
static bool copy_layers(Tile *tile, const FastLayers *layers)
{
    const GpDraw *draw = tile->draw->draw;
    const int slot = tile->draw->shown_slot - 1;
    const FastBox *box = &layers->box;
    if (!tile->draw->copies_words)
        return false;
    fast_begin_fetch(tile, draw->textures, slot);
    const FastFetch *fetch = &tile->block->fetch[slot];
    if (fetch->format == GP_FORMAT_NONE || !fetch->plane[0])
        return false;
    for (uint32_t layer = 0; layer < layers->count; layer++)
        fast_copy_words(&draw->state.blend[0], box, fetch->plane[0], tile->planes[0]->packed);
    tile->fragments_shaded +=
        (uint64_t)(box->x1 - box->x0 + 1) * (uint64_t)(box->y1 - box->y0 + 1) * layers->count;
    return true;
}

void fast_shade_layers(Tile *tile, const FastLayers *layers, FastPacket *room)
{
    if (!copy_layers(tile, layers))
        shade_blocks(tile, layers, room);
}
