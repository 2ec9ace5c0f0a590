/* Boxes that lie one on the other, as what covers the screen again and again: shaded a few pixels at a
 * time, all layers of these before the next, so that what is blended stays in the nearest cache. */
#include "pipeline/fast/lanes/shade/interpolate.h"
#include "pipeline/fast/lanes/memory/packet.h"

/* Components that take their values alike: four in a row, or one. */
typedef struct Span {
    uint8_t first;
    bool four;
    GpInterpolation mode;
} Span;

/* The draw's components. */
typedef struct Layout {
    Span span[GP_MAX_VARYINGS];
    int spans, stride;
    bool varies, perspective; /* any component does, on the screen or in perspective */
} Layout;

/* What the interpolants of a layer need, found once for all its pixels. Layers mostly have one shape. */
typedef struct Layer {
    const FastTriangleRecord *record;
    Edge edge[2];
    float scale[2];
    bool flat_on; /* both ratios are 1, and so is w: the weights are the same with perspective */
    bool as_last; /* the weights are those of the layer before it */
} Layer;

/* --- set-up --------------------------------------------------------------------------------------- */

static Layout find_layout(const FastDraw *d)
{
    Layout layout = { .stride = d->modes.components };
    const GpInterpolation *mode = d->modes.mode;
    for (uint64_t left = d->needs.varyings; left;) {
        const int c = __builtin_ctzll(left);
        const bool four = (left >> c & 15) == 15 && mode[c + 1] == mode[c] &&
                          mode[c + 2] == mode[c] && mode[c + 3] == mode[c];
        layout.span[layout.spans++] = (Span){ (uint8_t)c, four, mode[c] };
        layout.varies |= mode[c] != GP_FLAT;
        layout.perspective |= mode[c] == GP_PERSPECTIVE;
        left &= ~((four ? UINT64_C(15) : 1) << c);
    }
    return layout;
}

static bool same_weights(const Layer *a, const Layer *b)
{
    bool same = a->record->ratio1 == b->record->ratio1 && a->record->ratio2 == b->record->ratio2;
    for (int i = 0; i < 2; i++)
        same &= a->edge[i].c == b->edge[i].c && a->edge[i].a == b->edge[i].a &&
                a->edge[i].b == b->edge[i].b && a->scale[i] == b->scale[i];
    return same;
}

/* False where an edge does not fit into 32 bits. */
static bool find_layers(const Tile *tile, Layer *layer)
{
    for (uint32_t k = 0; k < tile->layer_count; k++, layer++) {
        const FastTriangleRecord *r = &tile->records[tile->layer_record[k]];
        *layer = (Layer){ .record = r, .flat_on = r->ratio1 == 1.0f && r->ratio2 == 1.0f };
        for (int i = 0; i < 2; i++) {
            if (!fast_narrow_edge(&tile->edges64[r->edges64], i, &layer->edge[i]))
                return false;
            layer->scale[i] = r->inverse_area * layer->edge[i].unit; /* exact */
        }
        layer->as_last = k > 0 && same_weights(layer, layer - 1);
    }
    return true;
}

/* --- interpolation -------------------------------------------------------------------------------- */

static void find_weights(const Layer *layer, const FastPacket *packets, int count,
                         BlockWeights *weights)
{
    for (int i = 0; i < 2; i++) {
        const Edge e = layer->edge[i];
        const utg across = (utg)(lane_numbers() * e.a);
        const float scale = layer->scale[i];
        for (int p = 0; p < count; p++) {
            const uint32_t first =
                (uint32_t)e.c + (uint32_t)e.a * packets[p].x + (uint32_t)e.b * packets[p].y;
            weights->screen[i][p] = flt_from_itg((itg)(across + first)) * scale;
        }
    }
}

static void correct_all(const FastTriangleRecord *r, int count, BlockWeights *weights)
{
    const flt ratio1 = flt_set(r->ratio1), ratio2 = flt_set(r->ratio2);
    for (int p = 0; p < count; p++)
        correct_weights(weights, p, ratio1, ratio2);
}

GP_INLINE void blend_span(const FastTriangleRecord *r, int first, int components,
                          const flt weight[2][FAST_BLOCK], int count, int stride, flt *in)
{
    flt v0[4], to1[4], to2[4];
    GP_UNROLL
    for (int i = 0; i < components; i++) {
        v0[i] = flt_set(r->corner[0][first + i]);
        to1[i] = flt_set(r->corner[1][first + i]) - v0[i];
        to2[i] = flt_set(r->corner[2][first + i]) - v0[i];
    }
    in += first;
    for (int p = 0; p < count; p++, in += stride) {
        const flt l1 = weight[0][p], l2 = weight[1][p];
        GP_UNROLL
        for (int i = 0; i < components; i++)
            in[i] = v0[i] + (l1 * to1[i] + l2 * to2[i]);
    }
}

static void repeat_span(const FastTriangleRecord *r, const Span *span, int count, int stride,
                        flt *in)
{
    const int end = span->first + (span->four ? 4 : 1);
    for (int p = 0; p < count; p++, in += stride)
        for (int c = span->first; c < end; c++)
            in[c] = flt_set(r->corner[0][c]);
}

static void interpolate_layer(const Layout *layout, const Layer *layer, const BlockWeights *weights,
                              int count, flt *in)
{
    const FastTriangleRecord *r = layer->record;
    for (int i = 0; i < layout->spans; i++) {
        const Span *span = &layout->span[i];
        const flt(*weight)[FAST_BLOCK] = span->mode == GP_PERSPECTIVE && !layer->flat_on
                                             ? (const flt(*)[FAST_BLOCK])weights->perspective
                                             : (const flt(*)[FAST_BLOCK])weights->screen;
        if (span->mode == GP_FLAT)
            repeat_span(r, span, count, layout->stride, in);
        else if (span->four)
            blend_span(r, span->first, 4, weight, count, layout->stride, in);
        else
            blend_span(r, span->first, 1, weight, count, layout->stride, in);
    }
}

/* The inputs of a block: packets are [layer][pixels]. */
static void interpolate_layers(Tile *tile, const Layout *layout, const Layer *layer, int layers,
                               int count)
{
    BlockWeights weights;
    flt *in = (flt *)(void *)tile->in;
    for (int k = 0; k < layers; k++, layer++, in += count * layout->stride) {
        if (layout->varies && !layer->as_last)
            find_weights(layer, tile->packets, count, &weights);
        if (!layer->as_last && layout->perspective && !layer->flat_on)
            correct_all(layer->record, count, &weights);
        interpolate_layer(layout, layer, &weights, count, in);
    }
}

/* --- the queue ------------------------------------------------------------------------------------ */

static bool is_same_box(const FastBox *a, const FastBox *b)
{
    return a->x0 == b->x0 && a->y0 == b->y0 && a->x1 == b->x1 && a->y1 == b->y1;
}

void fast_queue_box(Tile *tile, uint32_t record, const FastBox *box)
{
    const bool fits = tile->layer_count < FAST_LAYERS && is_same_box(&tile->layer_box, box);
    if (tile->packet_count || (tile->layer_count && !fits))
        fast_flush_packets(tile);
    tile->layer_box = *box;
    tile->layer_record[tile->layer_count++] = record;
}

/* Packets of all layers on the next `count` packets of the box, whose first is at (x, y). */
static void set_packets(Tile *tile, int count, int32_t *x, int32_t *y)
{
    const FastBox *box = &tile->layer_box;
    for (int i = 0; i < count; i++) {
        const int32_t pixels = box->x1 - *x + 1;
        const unsigned live = pixels < GP_LANES ? (1u << pixels) - 1 : ALL_LANES;
        for (uint32_t k = 0; k < tile->layer_count; k++)
            set_packet(&tile->packets[k * (uint32_t)count + (uint32_t)i], tile->layer_record[k], *x,
                       *y, live, GP_LANES);
        *x += GP_LANES;
        if (*x > box->x1) {
            *x = box->x0;
            ++*y;
        }
    }
}

/* Whether the shader gives all pixels the same: it looks at nothing that differs. */
static bool are_alike(Tile *tile, const FastDraw *d)
{
    const GpProgram *program = d->draw->program;
    if (d->needs.varyings || program->samplers || program->uses_pixel || program->uses_face ||
        program->may_discard || d->needs.alpha_test || !d->needs.color)
        return false;
    for (unsigned left = program->local_reads; left; left &= left - 1) {
        const int slot = __builtin_ctz(left);
        const FastFetch *fetch = &tile->fetch[slot];
        fast_begin_fetch(tile, d->draw->textures, slot);
        if (fetch->format == GP_FORMAT_NONE || fetch->plane[0])
            return false;
    }
    return true;
}

/* Blends a block for which one packet was shaded. */
static void blend_alike(Tile *tile, int count)
{
    const FastDraw *d = tile->draw;
    unsigned live[FAST_BLOCK];
    for (int p = 0; p < count; p++) {
        live[p] = tile->packets[p].live;
        tile->fragments_shaded += (uint64_t)__builtin_popcount(live[p]);
    }
    fast_blend_packets(tile, d, tile->packets, live, count, (const flt *)(const void *)tile->color);
}

static void shade_blocks(Tile *tile)
{
    const FastDraw *d = tile->draw;
    const FastBox *box = &tile->layer_box;
    const int layers = (int)tile->layer_count, room = FAST_BLOCK / layers;
    const Layout layout = find_layout(d);
    Layer layer[FAST_LAYERS];
    const bool narrow = find_layers(tile, layer);
    tile->layers_alike = are_alike(tile, d);

    int32_t x = box->x0, y = box->y0;
    const int packets = ((box->x1 - x) / GP_LANES + 1) * (box->y1 - y + 1);
    for (int done = 0, count; done < packets; done += count) {
        count = packets - done < room ? packets - done : room;
        set_packets(tile, count, &x, &y);
        if (tile->layers_alike) {
            if (done == 0)
                fast_run_pixel_shader(tile, d, tile->packets, 1);
            blend_alike(tile, layers * count);
        } else if (narrow) {
            interpolate_layers(tile, &layout, layer, layers, count);
            fast_shade_inputs(tile, d, tile->packets, layers * count, NULL);
        } else
            fast_shade_packets(tile, d, tile->packets, layers * count, NULL);
    }
    tile->layers_alike = false;
}

void fast_shade_layers(Tile *tile)
{
    if (!tile->draw->copied_slot || !fast_copy_layers(tile, tile->draw))
        shade_blocks(tile);
    tile->layer_count = 0;
}
