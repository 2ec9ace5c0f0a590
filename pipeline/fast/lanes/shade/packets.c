/* Packets: pixels of one triangle or point on their way through the shader, in order. */
#include "pipeline/fast/lanes/memory/packet.h"

#include "pipeline/resources/compare.h"
#include "pipeline/fast/lanes/output/depth.h"
#include "pipeline/fast/lanes/shade/interpolate.h"
#include "pipeline/fast/lanes/shade/gathered.h"
#include "pipeline/fast/lanes/raster/sprite.h"

/* --- edges -------------------------------------------------------------------------------------- */

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
bool fast_narrow_edge(const FastEdges64 *edges, int i, Edge *edge)
{
    int64_t c = edges->edge.c[i], a = edges->edge.a[i], b = edges->edge.b[i];
    int zeros = c | a | b ? __builtin_ctzll((uint64_t)(c | a | b)) : 0;
    zeros = zeros < 24 ? zeros : 24;
    if (!fits_everywhere(c >> zeros, a >> zeros, b >> zeros))
        return false;
    *edge = (Edge){ (int32_t)(c >> zeros), (int32_t)(a >> zeros), (int32_t)(b >> zeros),
                    (float)(1 << zeros) };
    return true;
}

/* Both edges in 32 bits, where they fit. */
static bool narrow_edges(const Tile *tile, const FastTriangleRecord *r, Edge edge[2])
{
    edge[0] = (Edge){ r->c1, fast_step_right(r->step1), fast_step_down(r->step1), 1 };
    edge[1] = (Edge){ r->c2, fast_step_right(r->step2), fast_step_down(r->step2), 1 };
    const FastEdges64 *edges = &tile->edges64[r->edges64];
    return r->kind == FAST_EDGES_32 ||
           (fast_narrow_edge(edges, 0, &edge[0]) && fast_narrow_edge(edges, 1, &edge[1]));
}

/* --- barycentrics -------------------------------------------------------------------------------- */

GP_INLINE void set_weights(const FastTriangleRecord *r, bool perspective, int p,
                           const flt screen[2], BlockWeights *weights)
{
    weights->screen[0][p] = screen[0];
    weights->screen[1][p] = screen[1];
    if (perspective)
        correct_weights(weights, p, flt_set(r->ratio1), flt_set(r->ratio2));
}

/* The scale is exact, so the product is that of the whole edge. */
GP_INLINE void weights_32(const FastTriangleRecord *r, const Edge edge[2], bool perspective,
                          const FastPacket *packets, int count, BlockWeights *weights)
{
    const itg column = packet_columns(packets->wide), row = packet_rows(packets->wide);
    utg across[2];
    flt scale[2];
    GP_UNROLL
    for (int i = 0; i < 2; i++) {
        across[i] = (utg)(column * edge[i].a + row * edge[i].b) + (uint32_t)edge[i].c;
        scale[i] = flt_set(r->inverse_area * edge[i].unit);
    }
    for (int p = 0; p < count; p++) {
        flt screen[2];
        GP_UNROLL
        for (int i = 0; i < 2; i++) {
            const uint32_t first =
                (uint32_t)edge[i].a * packets[p].x + (uint32_t)edge[i].b * packets[p].y;
            screen[i] = flt_from_itg((itg)(across[i] + first)) * scale[i];
        }
        set_weights(r, perspective, p, screen, weights);
    }
}

/* Edges that need more bits: exact in binary64, rounded once. */
GP_INLINE void weights_64(const FastTriangleRecord *r, const FastEdges64 *edges, bool perspective,
                          const FastPacket *packets, int count, BlockWeights *weights)
{
    const dbl column = dbl_from_itg(packet_columns(packets->wide));
    const dbl row = dbl_from_itg(packet_rows(packets->wide));
    for (int p = 0; p < count; p++) {
        flt screen[2];
        GP_UNROLL
        for (int i = 0; i < 2; i++) {
            const double a = (double)edges->edge.a[i], b = (double)edges->edge.b[i];
            const double first = (double)edges->edge.c[i] + (a * packets[p].x + b * packets[p].y);
            const dbl edge = first + (column * a + row * b);
            screen[i] = __builtin_convertvector(edge, flt) * r->inverse_area;
        }
        set_weights(r, perspective, p, screen, weights);
    }
}

static void find_weights(const Tile *tile, const FastTriangleRecord *r, bool perspective,
                         const FastPacket *packets, int count, BlockWeights *weights)
{
    Edge edge[2];
    if (!narrow_edges(tile, r, edge))
        weights_64(r, &tile->edges64[r->edges64], perspective, packets, count, weights);
    else if (perspective)
        weights_32(r, edge, true, packets, count, weights);
    else
        weights_32(r, edge, false, packets, count, weights);
}

/* --- interpolation ------------------------------------------------------------------------------ */

/* Up to four components of a run at once: more of them would leave no registers for weights. */
enum { AT_ONCE = 4 };

GP_INLINE void blend_components(const FastTriangleRecord *r, const flt weight[2][FAST_BLOCK],
                                const uint8_t *component, int components, int count, int stride,
                                flt *in)
{
    flt v0[AT_ONCE], to1[AT_ONCE], to2[AT_ONCE];
    GP_UNROLL
    for (int i = 0; i < components; i++) {
        v0[i] = flt_set(r->corner[0][component[i]]);
        to1[i] = flt_set(r->corner[1][component[i]]) - v0[i];
        to2[i] = flt_set(r->corner[2][component[i]]) - v0[i];
    }
    for (int p = 0; p < count; p++, in += stride) {
        const flt l1 = weight[0][p], l2 = weight[1][p];
        GP_UNROLL
        for (int i = 0; i < components; i++)
            in[component[i]] = v0[i] + (l1 * to1[i] + l2 * to2[i]);
    }
}

static void blend_run(const FastTriangleRecord *r, const flt weight[2][FAST_BLOCK],
                      uint64_t components, int count, int stride, flt *in)
{
    while (components) {
        uint8_t component[AT_ONCE];
        int found = 0;
        for (; components && found < AT_ONCE; components &= components - 1)
            component[found++] = (uint8_t)__builtin_ctzll(components);
        if (found == 1)
            blend_components(r, weight, component, 1, count, stride, in);
        else if (found == 2)
            blend_components(r, weight, component, 2, count, stride, in);
        else if (found == 3)
            blend_components(r, weight, component, 3, count, stride, in);
        else
            blend_components(r, weight, component, AT_ONCE, count, stride, in);
    }
}

static void repeat_run(const FastTriangleRecord *r, uint64_t components, int count, int stride,
                       flt *in)
{
    for (; components; components &= components - 1) {
        const int c = __builtin_ctzll(components);
        for (int p = 0; p < count; p++)
            in[c + p * stride] = flt_set(r->corner[0][c]);
    }
}

/* A run: packets of one triangle and one shape. What does not change in it is found once. */
static void interpolate_run(const Tile *tile, const FastDraw *d, const FastPacket *packets,
                            int count, flt *in)
{
    const FastTriangleRecord *r = &tile->records[packets->record];
    const int stride = d->modes.components;
    /* where both ratios are 1, so is w, and the weights are the same */
    const bool flat_on = r->ratio1 == 1.0f && r->ratio2 == 1.0f;
    const uint64_t perspective = flat_on ? 0 : d->varyings_by[GP_PERSPECTIVE];
    const uint64_t screen =
        (d->varyings_by[GP_PERSPECTIVE] ^ perspective) | d->varyings_by[GP_LINEAR_SCREEN];
    BlockWeights weights;
    find_weights(tile, r, perspective != 0, packets, count, &weights);
    blend_run(r, (const flt(*)[FAST_BLOCK])weights.perspective, perspective, count, stride, in);
    blend_run(r, (const flt(*)[FAST_BLOCK])weights.screen, screen, count, stride, in);
    repeat_run(r, d->varyings_by[GP_FLAT], count, stride, in);
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

static void interpolate_sprite(const Tile *tile, const FastDraw *d, const FastPacket *packet,
                               flt *in)
{
    const FastTriangleRecord *record = &tile->records[packet->record];
    fast_interpolate_sprite(tile, d, record, packet_x(packet), packet_y(packet), in);
}

static void interpolate_packets(Tile *tile, const FastDraw *d, const FastPacket *packets, int count)
{
    const int stride = d->modes.components;
    flt *in = (flt *)(void *)tile->in;
    for (int p = 0, length; p < count; p += length) {
        length = 1;
        if (packets[p].gathered)
            fast_interpolate_gathered(tile, d, &tile->gathered[p], 1, in + p * stride);
        else if (tile->records[packets[p].record].kind == FAST_SPRITE)
            interpolate_sprite(tile, d, &packets[p], in + p * stride);
        else {
            length = run_length(&packets[p], count - p);
            interpolate_run(tile, d, &packets[p], length, in + p * stride);
        }
    }
}

/* What the program asks of the pixels besides interpolants. */
static void place_packets(Tile *tile, const GpProgram *program, const FastPacket *packets,
                          int count)
{
    flt *pixel = (flt *)(void *)tile->pixel;
    if (program->uses_pixel)
        for (int p = 0; p < count; p++) {
            const FastGathered *gathered = &tile->gathered[p];
            itg x = packets[p].gathered ? gathered->x : packet_x(&packets[p]);
            itg y = packets[p].gathered ? gathered->y : packet_y(&packets[p]);
            pixel[2 * p] = flt_from_itg(x + tile->x0);
            pixel[2 * p + 1] = flt_from_itg(y + tile->y0);
        }
    if (program->uses_face)
        for (int p = 0; p < count; p++)
            flt_store(tile->face + p * GP_LANES, flt_set(tile->records[packets[p].record].face));
}

/* --- after the shader --------------------------------------------------------------------------- */

static msk compare_lanes(GpCompare test, flt a, float b)
{
    msk less = (msk)(a < b), equal = (msk)(a == b), greater = (msk)(a > b);
    msk accepted = accepted_lanes(test, less, equal, greater);
    if (gp_compare_accepts(test, GP_IS_UNORDERED))
        accepted |= ~(less | equal | greater);
    return accepted;
}

unsigned fast_test_packet(Tile *tile, const FastDraw *d, const FastPacket *packet, unsigned live,
                          flt z)
{
    uint32_t at = fast_at(packet->x, packet->y);
    const bool front = tile->records[packet->record].face > 0;
    if (!packet->wide || packet->wide == GP_LANES)
        return msk_bits(
            fast_test_depth_stencil(tile, d, at, !packet->wide, mask_of(live), z, front));
    const itg row = lane_row(packet->wide);
    msk passed = itg_set(0);
    for (int r = 0; has_row(packet, r); r++, at += FAST_PITCH - packet->wide)
        passed |=
            fast_test_depth_stencil(tile, d, at, false, (msk)(row == r) & mask_of(live), z, front);
    return msk_bits(passed);
}

/* Lanes of shaded packet p that pass the tests which had to wait. */
static unsigned late_tests(Tile *tile, const FastDraw *d, const FastPacket *packet, int p,
                           const float *depth)
{
    const GpAlphaTest *alpha = &d->draw->state.alpha_test;
    const int targets = gp_program_targets(d->draw->program);
    unsigned live = packet->live;
    if (d->draw->program->may_discard)
        live &= ~msk_bits((msk)flt_load((const float *)(const void *)tile->killed + p * GP_LANES));
    if (d->needs.alpha_test)
        live &= msk_bits(compare_lanes(alpha->test,
                                       flt_load(tile->color + (p * targets * 4 + 3) * GP_LANES),
                                       gp_float_from_unorm(alpha->reference, 8)));
    if (d->late_depth && live) {
        bool replaced = d->draw->program->writes_depth;
        flt z = flt_load((replaced ? tile->shader_depth : depth) + p * GP_LANES);
        live = fast_test_packet(tile, d, packet, live, z);
    }
    return live;
}

void fast_shade_inputs(Tile *tile, const FastDraw *d, const FastPacket *packets, int count,
                       const float *depths)
{
    unsigned live[FAST_BLOCK];
    place_packets(tile, d->draw->program, packets, count);
    fast_run_pixel_shader(tile, d, packets, count);
    const bool late = d->draw->program->may_discard || d->needs.alpha_test || d->late_depth;
    uint32_t fragments = 0;
    for (int p = 0; p < count; p++) {
        fragments += (uint32_t)__builtin_popcount(packets[p].live);
        live[p] = late ? late_tests(tile, d, &packets[p], p, depths) : packets[p].live;
    }
    tile->fragments_shaded += fragments;
    if (fast_only_adds(tile, d))
        fast_add_packets(tile, d, packets, live, count, (const flt *)(const void *)tile->color);
    else if (d->needs.color)
        fast_blend_packets(tile, d, packets, live, count, (const flt *)(const void *)tile->color);
}

void fast_shade_packets(Tile *tile, const FastDraw *d, const FastPacket *packets, int count,
                        const float *depths)
{
    interpolate_packets(tile, d, packets, count);
    fast_shade_inputs(tile, d, packets, count, depths);
}

/* --- the queue ---------------------------------------------------------------------------------- */

FastPacket *fast_new_packet(Tile *tile)
{
    if (tile->packet_count == FAST_BLOCK || tile->layer_count)
        fast_flush_packets(tile);
    return &tile->packets[tile->packet_count++];
}

static void queue(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live, int32_t wide,
                  flt depth)
{
    FastPacket *packet = fast_new_packet(tile);
    set_packet(packet, record, x, y, live, wide);
    if (tile->draw->late_depth)
        flt_store(tile->packet_depth + (packet - tile->packets) * GP_LANES, depth);
}

void fast_queue_row(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live, flt depth)
{
    queue(tile, record, x, y, live, GP_LANES, depth);
}

void fast_queue_quads(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live, flt depth)
{
    queue(tile, record, x, y, live, 0, depth);
}

void fast_flush_packets(Tile *tile)
{
    const int count = (int)tile->packet_count;
    if (!count && !tile->layer_count)
        return;
    FastPhase before = fast_turn_to(tile, FAST_SHADING);
    if (tile->layer_count)
        fast_shade_layers(tile);
    else if (tile->draw->draw->geometry.primitive == GP_POINTS) /* come with their inputs */
        fast_shade_inputs(tile, tile->draw, tile->packets, count, tile->packet_depth);
    else
        fast_shade_packets(tile, tile->draw, tile->packets, count, tile->packet_depth);
    tile->packet_count = 0;
    fast_turn_to(tile, before);
}
