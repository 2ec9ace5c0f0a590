/* Interpolants of packets of one triangle or point each. */
#include "pipeline/fast/lanes/shade/interpolate_packets.h"

#include "pipeline/fast/lanes/shade/interpolate_gathered.h"

/* --- edges ------------------------------------------------------------------------------------ */

/* Whether c + a x + b y fits wherever in the tile a lane may be: it is greatest at a corner. */
static bool fits_everywhere(int64_t c, int64_t a, int64_t b)
{
    const int64_t across = a * FAST_PITCH, down = b * (FAST_TILE + 1);
    const int64_t ends[4] = { c, c + across, c + down, c + across + down };
    for (int i = 0; i < 4; i++)
        if (ends[i] < INT32_MIN || ends[i] > INT32_MAX)
            return false;
    return true;
}

/* The edges of a large triangle are often small in one tile, or have zeros at the end: those of
 * rectangles along the pixels have fifteen. */
static bool narrow_edge(const FastEdges64 *edges, int i, FastEdge *edge)
{
    int64_t c = edges->edge.c[i], a = edges->edge.a[i], b = edges->edge.b[i];
    int zeros = c | a | b ? __builtin_ctzll((uint64_t)(c | a | b)) : 0;
    zeros = zeros < 24 ? zeros : 24;
    if (!fits_everywhere(c >> zeros, a >> zeros, b >> zeros))
        return false;
    *edge = (FastEdge){ (int32_t)(c >> zeros), (int32_t)(a >> zeros), (int32_t)(b >> zeros),
                        (float)(1 << zeros) };
    return true;
}

/* Edges 1 and 2; edge 0 is what they leave of the area. */
static void small_edges(const FastTriangleRecord *r, FastEdge edge[3])
{
    edge[1] = (FastEdge){ r->c1, fast_step_right(r->step1), fast_step_down(r->step1), 1 };
    edge[2] = (FastEdge){ r->c2, fast_step_right(r->step2), fast_step_down(r->step2), 1 };
    edge[0].c = (int32_t)((uint32_t)r->area - (uint32_t)edge[1].c - (uint32_t)edge[2].c);
    edge[0].a = -(edge[1].a + edge[2].a);
    edge[0].b = -(edge[1].b + edge[2].b);
    edge[0].unit = 1;
}

GP_INLINE int64_t large_area(const FastEdges64 *edges)
{
    return edges->edge.c[0] + edges->edge.c[1] + edges->edge.c[2];
}

bool fast_narrow_edges(const FastRecords *records, const FastTriangleRecord *r, bool perspective,
                       FastNarrowEdges *narrow)
{
    const FastEdges64 *edges = &records->edges64[r->edges64];
    if (r->kind == FAST_EDGES_64) {
        narrow->inverse_area = 1.0f / (float)large_area(edges);
        narrow->edge[0] = (FastEdge){ 0, 0, 0, 1 };
        return narrow_edge(edges, 1, &narrow->edge[1]) && narrow_edge(edges, 2, &narrow->edge[2]) &&
               (!perspective || narrow_edge(edges, 0, &narrow->edge[0]));
    }
    narrow->inverse_area = 1.0f / (float)r->area;
    small_edges(r, narrow->edge);
    return true;
}

/* --- barycentrics ----------------------------------------------------------------------------- */

/* The units are exact, so the products are those of the whole edges. */
GP_INLINE void weights_32(const FastTriangleRecord *r, const FastNarrowEdges *narrow,
                          bool perspective, bool screen, const FastPacket *packets, int count,
                          FastWeights *weights)
{
    const FastEdge *edge = narrow->edge;
    const itg column = packet_columns(packets->wide), row = packet_rows(packets->wide);
    const flt share0 = flt_set(edge[0].unit), share1 = flt_set(edge[1].unit * r->ratio1);
    const flt share2 = flt_set(edge[2].unit * r->ratio2);
    utg across[3];
    flt scale[3];
    GP_UNROLL
    for (int i = 0; i < 3; i++) {
        across[i] = (utg)(column * edge[i].a + row * edge[i].b) + (uint32_t)edge[i].c;
        scale[i] = flt_set(narrow->inverse_area * edge[i].unit);
    }
    for (int p = 0; p < count; p++) {
        flt value[3];
        GP_UNROLL
        for (int i = 0; i < 3; i++) {
            const uint32_t first =
                (uint32_t)edge[i].a * packets[p].x + (uint32_t)edge[i].b * packets[p].y;
            value[i] = flt_from_itg((itg)(across[i] + first));
        }
        if (screen) {
            weights->screen[0][p] = value[1] * scale[1];
            weights->screen[1][p] = value[2] * scale[2];
        }
        if (perspective)
            set_perspective(weights, p, value[0] * share0, value[1] * share1, value[2] * share2);
    }
}

/* Edges that need more bits: exact in binary64, rounded once. */
static void weights_64(const FastTriangleRecord *r, const FastEdges64 *edges, bool perspective,
                       const FastPacket *packets, int count, FastWeights *weights)
{
    const dbl column = dbl_from_itg(packet_columns(packets->wide));
    const dbl row = dbl_from_itg(packet_rows(packets->wide));
    const float inverse_area = 1.0f / (float)large_area(edges);
    weights->has_perspective = perspective;
    for (int p = 0; p < count; p++) {
        flt value[3];
        GP_UNROLL
        for (int i = 0; i < 3; i++) {
            const double a = (double)edges->edge.a[i], b = (double)edges->edge.b[i];
            const double first = (double)edges->edge.c[i] + (a * packets[p].x + b * packets[p].y);
            const dbl edge = first + (column * a + row * b);
            value[i] = __builtin_convertvector(edge, flt);
        }
        weights->screen[0][p] = value[1] * inverse_area;
        weights->screen[1][p] = value[2] * inverse_area;
        if (perspective)
            set_perspective(weights, p, value[0], value[1] * r->ratio1, value[2] * r->ratio2);
    }
}

void fast_find_weights(const FastDraw *d, const FastTriangleRecord *r, const FastNarrowEdges *edges,
                       bool perspective, const FastPacket *packets, int count, FastWeights *weights)
{
    weights->has_perspective = perspective;
    if (!perspective)
        weights_32(r, edges, false, true, packets, count, weights);
    else if (d->varyings_by[GP_LINEAR_SCREEN])
        weights_32(r, edges, true, true, packets, count, weights);
    else
        weights_32(r, edges, true, false, packets, count, weights);
}

/* --- interpolation ---------------------------------------------------------------------------- */

/* Up to four neighbouring components at once: more of them would leave no registers for weights. */
enum { AT_ONCE = 4 };

GP_INLINE FastComponent component_of(const FastTriangleRecord *r, int c)
{
    const float v0 = r->corner[0][c];
    return (FastComponent){ flt_set(v0), flt_set(r->corner[1][c] - v0),
                            flt_set(r->corner[2][c] - v0) };
}

GP_INLINE void blend_components(const FastComponent from[AT_ONCE], const flt weight[2][FAST_BLOCK],
                                int components, int count, int stride, flt *in)
{
    for (int p = 0; p < count; p++, in += stride) {
        const flt l1 = weight[0][p], l2 = weight[1][p];
        GP_UNROLL
        for (int i = 0; i < components; i++)
            in[i] = from[i].v0 + (l1 * from[i].to1 + l2 * from[i].to2);
    }
}

/* in   prepared: where NULL, the components are found from the triangle */
GP_INLINE void blend_neighbours(const FastTriangleRecord *r, const FastComponent *prepared,
                                const flt weight[2][FAST_BLOCK], int first, int components,
                                int count, int stride, flt *in)
{
    FastComponent from[AT_ONCE];
    GP_UNROLL
    for (int i = 0; i < components; i++)
        from[i] = prepared ? prepared[first + i] : component_of(r, first + i);
    blend_components(from, weight, components, count, stride, in + first);
}

GP_INLINE void blend_run(const FastTriangleRecord *r, const FastComponent *prepared,
                         const flt weight[2][FAST_BLOCK], uint64_t components, int count,
                         int stride, flt *in)
{
    while (components) {
        int first;
        const int found = take_neighbours(&components, AT_ONCE, &first);
        if (found == 4)
            blend_neighbours(r, prepared, weight, first, 4, count, stride, in);
        else if (found == 3)
            blend_neighbours(r, prepared, weight, first, 3, count, stride, in);
        else if (found == 2)
            blend_neighbours(r, prepared, weight, first, 2, count, stride, in);
        else
            blend_neighbours(r, prepared, weight, first, 1, count, stride, in);
    }
}

static void repeat_run(const FastTriangleRecord *r, uint64_t components, int count, int stride,
                       flt *in)
{
    for (; components; components &= components - 1) {
        const int c = __builtin_ctzll(components);
        for (int p = 0; p < count; p++)
            in[c + p * stride] = flt_set(r->corner[r->flat][c]);
    }
}

bool fast_needs_perspective(const FastDraw *d, const FastTriangleRecord *r)
{
    return d->varyings_by[GP_PERSPECTIVE] && (r->ratio1 != 1.0f || r->ratio2 != 1.0f);
}

GP_INLINE void interpolate_run(const FastDraw *d, const FastTriangleRecord *r,
                               const FastComponent *prepared, const FastWeights *weights, int count,
                               flt *in)
{
    const int stride = d->modes.components;
    const uint64_t all = d->varyings_by[GP_PERSPECTIVE] | d->varyings_by[GP_LINEAR_SCREEN];
    const uint64_t perspective = weights->has_perspective ? d->varyings_by[GP_PERSPECTIVE] : 0;
    if (perspective)
        blend_run(r, prepared, weights->perspective, perspective, count, stride, in);
    if (all != perspective)
        blend_run(r, prepared, weights->screen, all ^ perspective, count, stride, in);
    if (d->varyings_by[GP_FLAT])
        repeat_run(r, d->varyings_by[GP_FLAT], count, stride, in);
}

void fast_prepare_components(const FastDraw *d, const FastTriangleRecord *r,
                             FastComponent prepared[GP_MAX_VARYINGS])
{
    uint64_t left = d->varyings_by[GP_PERSPECTIVE] | d->varyings_by[GP_LINEAR_SCREEN];
    for (; left; left &= left - 1) {
        const int c = __builtin_ctzll(left);
        prepared[c] = component_of(r, c);
    }
}

void fast_interpolate_prepared(const FastDraw *d, const FastTriangleRecord *r,
                               const FastComponent prepared[GP_MAX_VARYINGS],
                               const FastWeights *weights, int count, flt *in)
{
    interpolate_run(d, r, prepared, weights, count, in);
}

static void interpolate_triangle(const Tile *tile, const FastDraw *d, const FastPacket *packets,
                                 int count, flt *in)
{
    const FastTriangleRecord *r = &tile->records->record[packets->record];
    const bool perspective = fast_needs_perspective(d, r);
    FastNarrowEdges edges;
    FastWeights weights;
    if (fast_narrow_edges(tile->records, r, perspective, &edges))
        fast_find_weights(d, r, &edges, perspective, packets, count, &weights);
    else
        weights_64(r, &tile->records->edges64[r->edges64], perspective, packets, count, &weights);
    interpolate_run(d, r, NULL, &weights, count, in);
}

static void interpolate_sprite(const Tile *tile, const FastDraw *d, const FastPacket *packet,
                               flt *in)
{
    const FastTriangleRecord *r = &tile->records->record[packet->record];
    const FastEdges64 *at = &tile->records->edges64[r->edges64];
    const itg x = packet_x(packet) * GP_SUBPIXELS, y = packet_y(packet) * GP_SUBPIXELS;
    for (int c = 0; c < d->modes.components; c++)
        in[c] = flt_set(r->corner[0][c]);
    if (d->modes.sprite < 0)
        return;
    in += d->modes.sprite;
    in[0] = place_in_sprite(x, at->sprite.left, at->sprite.per_step);
    in[1] = place_in_sprite(y, at->sprite.top, at->sprite.per_step);
}

/* Packets from `first` on that share a triangle and a shape. */
static int run_length(const FastPacket *first, int count)
{
    int length = 1;
    while (length < count && first[length].record == first->record &&
           first[length].wide == first->wide && !first[length].gathered)
        length++;
    return length;
}

void fast_interpolate_packets(Tile *tile, const FastDraw *d, const FastPacketBlock *block, flt *in)
{
    const FastPacket *packet = block->packets, *end = packet + block->count;
    for (int length; packet < end; packet += length, in += length * d->modes.components) {
        length = 1;
        if (packet->gathered)
            fast_interpolate_gathered(tile, d, &block->gathered[packet - block->packets], 1, in);
        else if (tile->records->record[packet->record].kind == FAST_SPRITE)
            interpolate_sprite(tile, d, packet, in);
        else {
            length = run_length(packet, (int)(end - packet));
            interpolate_triangle(tile, d, packet, length, in);
        }
    }
}
