/* Vertices: shaded GP_LANES at a time, put on the screen, and marked where they are outside. */
#include "pipeline/fast/lanes/geometry/vertices.h"

#include "pipeline/base/prefetch.h"
#include "pipeline/fast/lanes/memory/convert.h"
#include "pipeline/fast/lanes/texture/sample.h"

#include "pipeline/units/input_assembly.h"
#include "pipeline/units/texture_read.h"
#include "pipeline/units/viewport.h"

#include <string.h>

enum { PACKETS = 8 };

/* Everything of a run of packets. */
typedef struct Block {
    _Alignas(64) float in[PACKETS * GP_MAX_INPUTS * GP_LANES];
    _Alignas(64) float position[PACKETS * 4 * GP_LANES];
    _Alignas(64) float varying[PACKETS * GP_MAX_VARYINGS * GP_LANES]; /* a multiple of four */
    _Alignas(64) float size[PACKETS * GP_LANES];
} Block;

/* --- inputs ----------------------------------------------------------------------------------- */

/* Four floats of a packet's vertices, whether the stream has as many or not: what lies behind a
 * vertex is read with it, and out of a copy where that is the end of the stream. */
GP_INLINE void load_floats(const GpStream *stream, uint32_t vertex_count,
                           const uint32_t vertex[GP_LANES], itg component[4])
{
    const size_t size = stream->components * sizeof(float), stride = gp_stream_stride(stream);
    const uint8_t *data = stream->data, *end = data + (vertex_count - 1) * stride + size;
    const void *record[GP_LANES];
    GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++)
        record[lane] = data + vertex[lane] * stride;
    float copy[GP_LANES][4];
    const bool at_end = (size_t)(end - (const uint8_t *)record[GP_LANES - 1]) < sizeof copy[0];
    for (int lane = 0; at_end && lane < GP_LANES; lane++) {
        if (lane > 0 && vertex[lane] == vertex[lane - 1])
            record[lane] = record[lane - 1];
        else if ((size_t)(end - (const uint8_t *)record[lane]) < sizeof copy[0])
            record[lane] = memcpy(copy[lane], record[lane], size);
    }
    lanes_load4(record, component);
}

/* Components of 8 or 16 bits of a packet's vertices as they are stored, eight bytes a vertex. */
typedef struct Codes {
    utg word[2];
} Codes;

static Codes load_codes(const GpStream *stream, const uint32_t vertex[GP_LANES])
{
    const size_t stride = gp_stream_stride(stream);
    const size_t size = stream->components * gp_component_bytes(stream->type);
    uint32_t word[2][GP_LANES] = { { 0 } };
    Codes codes = { { { 0 } } };
    const size_t span = (vertex[GP_LANES - 1] - vertex[0]) * stride;
    if (size == sizeof word[0][0] && span <= INT32_MAX) {
        /* colours: one load each, which end where the stream does */
        itg from_first;
        memcpy(&from_first, vertex, sizeof from_first);
        from_first -= (int32_t)vertex[0];
        codes.word[0] = (utg)itg_gather((const uint8_t *)stream->data + vertex[0] * stride,
                                        from_first * (int32_t)stride);
        return codes;
    }
    for (int lane = 0; lane < GP_LANES; lane++) {
        const uint8_t *at = (const uint8_t *)stream->data + vertex[lane] * stride;
        uint32_t both[2] = { 0, 0 };
        memcpy(both, at, size);
        word[0][lane] = both[0];
        word[1][lane] = both[1];
    }
    memcpy(&codes.word, word, sizeof codes.word);
    return codes;
}

/* Codes become numbers by the operations of gp_fetch_input. */
static flt code_value(const GpStream *stream, const Codes *codes, int component)
{
    static const float most[GP_COMPONENT_TYPES] = {
        [GP_UNORM8] = 255,    [GP_D3DCOLOR] = 255,  [GP_SNORM8] = 127,
        [GP_UNORM16] = 65535, [GP_SNORM16] = 32767,
    };
    const GpComponentType type = stream->type;
    const bool is_signed =
        type == GP_INT8 || type == GP_SNORM8 || type == GP_INT16 || type == GP_SNORM16;
    const size_t offset = gp_stream_offset(stream, component);
    const int unused = gp_component_bytes(type) == 2 ? 16 : 24;
    const utg high = codes->word[offset / 4] << (unused - (int)(offset % 4) * 8);
    const itg code = is_signed ? (itg)high >> unused : (itg)(high >> unused);
    if (type == GP_FLOAT16)
        return (flt)float_from_half(code);
    if (most[type] == 0)
        return flt_from_itg(code);
    return flt_greater(flt_from_itg(code) / most[type], flt_set(-1));
}

/* One input of a packet's vertices, which rise; what gp_fetch_input gives. */
static void fetch_input(const GpGeometry *geometry, const GpInputDecl *input,
                        const uint32_t vertex[GP_LANES], float *to)
{
    const GpStream *stream = &geometry->streams[input->semantic];
    if (stream->type != GP_FLOAT32) {
        const Codes codes = load_codes(stream, vertex);
        for (int c = 0; c < input->components; c++)
            flt_store(to + c * GP_LANES, c < stream->components ? code_value(stream, &codes, c)
                                                                : flt_set(c == 3 ? 1.0f : 0.0f));
        return;
    }
    itg component[4];
    load_floats(stream, geometry->vertex_count, vertex, component);
    GP_UNROLL
    for (int c = 0; c < 4; c++) {
        if (c == input->components)
            break;
        flt value = (flt)component[c];
        value = flt_select(value == value, value, (flt)itg_set(GP_QUIET_NAN));
        flt_store(to + c * GP_LANES,
                  c < stream->components ? value : flt_set(c == 3 ? 1.0f : 0.0f));
    }
}

/* A packet's records are wanted soon: blocks of them are read at once, between which memory would
 * rest. */
GP_PREFETCHES void prefetch_records(const GpStream *stream, uint32_t vertex)
{
    const size_t stride = gp_stream_stride(stream), step = stride < 64 ? 64 : stride;
    const uint8_t *from = (const uint8_t *)stream->data + vertex * stride;
    for (size_t i = 0; i < GP_LANES * stride; i += step)
        __builtin_prefetch(from + i);
}

/* All inputs of a packet's vertices, by component and lane; returns where the next packet's go. */
GP_INLINE float *fetch_packet(const FastDraw *d, const uint32_t vertex[GP_LANES], float *to)
{
    const GpInputDecl *input = d->draw->program->inputs;
    for (size_t i = 0; i < GP_COUNT(d->draw->program->inputs) && input[i].components; i++) {
        fetch_input(&d->draw->geometry, &input[i], vertex, to);
        to += input[i].components * GP_LANES;
    }
    return to;
}

GP_PREFETCHES void prefetch_inputs(const FastDraw *d, uint32_t vertex)
{
    const GpInputDecl *input = d->draw->program->inputs;
    for (size_t i = 0; i < GP_COUNT(d->draw->program->inputs) && input[i].components; i++)
        prefetch_records(&d->draw->geometry.streams[input[i].semantic], vertex);
}

/* Inputs of the block's vertices, by component and lane; the last vertex fills the last packet. */
static void fetch(const FastDraw *d, uint32_t first, uint32_t count, Block *block)
{
    float *to = block->in;
    for (uint32_t done = 0; done < count; done += GP_LANES) {
        uint32_t vertex[GP_LANES];
        for (uint32_t lane = 0; lane < GP_LANES; lane++)
            vertex[lane] =
                d->first_vertex + first + (done + lane < count ? done + lane : count - 1);
        to = fetch_packet(d, vertex, to);
        prefetch_inputs(d, vertex[0] + PACKETS * GP_LANES);
    }
}

/* --- places ----------------------------------------------------------------------------------- */

/* Bits of the planes that a vertex is outside of, as gp_clip_triangle decides; of a point, as
 * gp_clip_point does, where z and w may both be infinite: their difference is no number. */
static itg outside_planes(const GpGuardBand *band, bool is_point, flt x, flt y, flt z, flt w)
{
    const flt distance[GP_CLIP_PLANES] = {
        [GP_CLIP_LEFT] = x - band->left * w,
        [GP_CLIP_RIGHT] = band->right * w - x,
        [GP_CLIP_BOTTOM] = y - band->bottom * w,
        [GP_CLIP_TOP] = band->top * w - y,
        [GP_CLIP_NEAR] = z,
        [GP_CLIP_FAR] = w - z,
    };
    itg bits = itg_set(0);
    GP_UNROLL
    for (int i = 0; i < GP_CLIP_PLANES; i++)
        bits |= ~(itg)(distance[i] >= 0.0f) & itg_set(1 << i);
    if (is_point)
        bits &= ~((itg)(z <= w) & itg_set(1 << GP_CLIP_FAR));
    return bits;
}

/* To 24.8 fixed point, to nearest even: adding 2^23 leaves no place for a fraction, which numbers
 * from there on have not. */
static itg snap(flt pixels)
{
    flt steps = pixels * (float)GP_SUBPIXELS;
    itg sign = (itg)steps & INT32_MIN;
    flt size = (flt)((itg)steps ^ sign);
    flt rounded = flt_select((msk)(size < 0x1p23f), (size + 0x1p23f) - 0x1p23f, size);
    return itg_from_flt((flt)((itg)rounded | sign));
}

/* Puts a packet of vertices on the screen; returns those that have a place there, and a size. */
static msk viewport_transform(const FastDraw *d, const flt position[4], flt size, FastPosition *to)
{
    const GpViewport *v = &d->viewport;
    flt x = position[0], y = position[1], z = position[2], w = position[3];
    const bool is_point = d->draw->geometry.primitive == GP_POINTS;
    itg outside = outside_planes(&d->band, is_point, x, y, z, w);
    flt rw = 1.0f / w;
    flt screen_x = (x * rw + 1.0f) * v->width * 0.5f + v->x;
    flt screen_y = (1.0f - y * rw) * v->height * 0.5f + v->y;
    flt screen_z = v->min_depth + z * rw * (v->max_depth - v->min_depth);
    msk number = (msk)(x == x) & (msk)(y == y) & (msk)(z == z) & (msk)(w == w);
    const float range = gp_viewport_range(v);
    msk in_range =
        (msk)(flt_abs(screen_x) < range) & (msk)(flt_abs(screen_y) < range) & (msk)(w > 0.0f);
    itg bad = ~number | (~in_range & (itg)(outside == 0));
    outside = itg_select(bad, itg_set(FAST_OUTSIDE_ALL), outside);
    msk placed = (msk)(outside == 0);
    itg fixed_x = snap(flt_select(placed, screen_x, flt_set(0)));
    itg fixed_y = snap(flt_select(placed, screen_y, flt_set(0)));
    flt last = is_point ? size : rw;
    const itg words[4] = { itg_select(placed, fixed_x, FAST_NOWHERE + outside), fixed_y,
                           (itg)screen_z, (itg)last };
    lanes_store4(to, sizeof *to, words);
    return placed & (msk)(size > 0.0f);
}

/* Varyings, with what follows them up to a multiple of four; then the distances from planes in
 * use. */
static void keep_varyings(const FastDraw *d, const flt position[4], const float *varying, float *to)
{
    for (int c = 0; c < d->modes.components; c += 4)
        lanes_store4(to + c, d->stride * sizeof *to,
                     (const itg *)(const void *)(varying + c * GP_LANES));
    float *distance = to + d->modes.components;
    for (int i = 0; i < GP_MAX_CLIP_PLANES; i++) {
        if (!(d->needs.clip_planes >> i & 1))
            continue;
        const float *plane = d->draw->state.raster.clip_plane[i];
        flt all = position[0] * plane[0] + position[1] * plane[1] + position[2] * plane[2] +
                  position[3] * plane[3];
        for (uint32_t lane = 0; lane < GP_LANES; lane++)
            distance[lane * d->stride] = all[lane];
        distance++;
    }
}

/* Runs the vertex shader over packets of the block; without varyings, it finds places only. */
static void shade(const FastDraw *d, uint32_t packets, Block *block, float *varying)
{
    d->code->vertex(&(GpShaderCall){
        .uniforms = d->draw->uniforms,
        .packets = (int)packets,
        .in = block->in,
        .textures = d->draw->textures,
        .read_texture = fast_read_texture,
        .executor = (void *)d->samplers, /* only read */
        .position = block->position,
        .varying = varying,
        .point_size = d->draw->program->writes_point_size ? block->size : NULL,
    });
}

void fast_shade_vertices(const FastDraw *d, uint32_t first, uint32_t count)
{
    const GpProgram *program = d->draw->program;
    const bool is_points = d->draw->geometry.primitive == GP_POINTS;
    Block block;
    for (uint32_t done = 0; done < count; done += PACKETS * GP_LANES) {
        uint32_t now = count - done < PACKETS * GP_LANES ? count - done : PACKETS * GP_LANES;
        uint32_t packets = (now + GP_LANES - 1) / GP_LANES;
        fetch(d, first + done, now, &block);
        shade(d, packets, &block, d->shades_again ? NULL : block.varying);
        for (uint32_t p = 0; p < packets; p++) {
            const flt *position = (const flt *)(const void *)(block.position + p * 4 * GP_LANES);
            const uint32_t at = first + done + p * GP_LANES;
            const msk on_screen = viewport_transform(
                d, position,
                program->writes_point_size ? flt_load(block.size + p * GP_LANES) : flt_set(1),
                d->positions + at);
            if (!d->shades_again &&
                (!is_points || msk_any(on_screen))) /* of others nothing is read */
                keep_varyings(d, position,
                              block.varying + p * (uint32_t)d->modes.components * GP_LANES,
                              d->varyings + (size_t)at * d->stride);
        }
    }
}

void fast_shade_varyings(const FastDraw *d, const uint32_t (*vertex)[GP_LANES], uint32_t packets,
                         float *varying)
{
    Block block;
    float *to = block.in;
    for (uint32_t p = 0; p < packets; p++) {
        uint32_t number[GP_LANES];
        for (uint32_t lane = 0; lane < GP_LANES; lane++)
            number[lane] = d->first_vertex + vertex[p][lane];
        to = fetch_packet(d, number, to);
    }
    shade(d, packets, &block, varying);
}
