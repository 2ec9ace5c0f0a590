/* Vertices: shaded GP_LANES at a time, put on the screen, and marked where they are outside. */
#include "pipeline/fast/lanes/tile.h"

#include "pipeline/input_assembly.h"
#include "pipeline/fast/sampler.h"
#include "pipeline/texture_read.h"
#include "pipeline/viewport.h"

#include <math.h>

enum { PACKETS = 8, MAX_STRIDE = GP_MAX_VARYINGS + GP_MAX_CLIP_PLANES };

/* Everything of a run of packets. */
typedef struct Block {
    _Alignas(64) float in[PACKETS * GP_MAX_INPUTS * GP_LANES];
    _Alignas(64) float position[PACKETS * 4 * GP_LANES];
    _Alignas(64) float varying[PACKETS * GP_MAX_VARYINGS * GP_LANES];
    _Alignas(64) float size[PACKETS * GP_LANES];
} Block;

/* Inputs of the block's vertices, by component and lane; the last vertex fills the last packet. */
static void fetch(const FastDraw *d, uint32_t first, uint32_t count, Block *block)
{
    const GpProgram *program = d->draw->program;
    const int components = program->input_components;
    for (uint32_t i = 0; i < (count + GP_LANES - 1) / GP_LANES * GP_LANES; i++) {
        uint32_t vertex = d->first_vertex + first + (i < count ? i : count - 1);
        float inputs[GP_MAX_INPUTS];
        gp_fetch_vertex(&d->draw->geometry, program, vertex, inputs);
        float *to = block->in + (i / GP_LANES) * (uint32_t)components * GP_LANES + i % GP_LANES;
        for (int c = 0; c < components; c++)
            to[c * GP_LANES] = inputs[c];
    }
}

/* Bits of the planes that a vertex is outside of, as gp_clip_triangle decides. */
static itg outside_planes(const GpGuardBand *band, flt x, flt y, flt z, flt w)
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
    for (int i = 0; i < GP_CLIP_PLANES; i++)
        bits |= ~(itg)(distance[i] >= 0.0f) & itg_set(1 << i);
    return bits;
}

/* To 24.8 fixed point, to nearest even: adding 2^23 leaves no place for a fraction. */
static itg snap(flt pixels)
{
    flt steps = pixels * (float)GP_SUBPIXELS;
    itg sign = (itg)steps & INT32_MIN;
    flt size = (flt)((itg)steps ^ sign);
    flt rounded = (size + 0x1p23f) - 0x1p23f;
    return itg_from_flt((flt)((itg)rounded | sign));
}

static void place(const FastDraw *d, uint32_t first, uint32_t count, const flt *position)
{
    const GpViewport *v = &d->viewport;
    flt x = position[0], y = position[1], z = position[2], w = position[3];
    itg outside = outside_planes(&d->band, x, y, z, w);
    flt rw = 1.0f / w;
    flt screen_x = (x * rw + 1.0f) * v->width * 0.5f + v->x;
    flt screen_y = (1.0f - y * rw) * v->height * 0.5f + v->y;
    flt screen_z = v->min_depth + z * rw * (v->max_depth - v->min_depth);
    msk number = (msk)(x == x) & (msk)(y == y) & (msk)(z == z) & (msk)(w == w);
    msk in_range =
        (msk)(flt_abs(screen_x) < 32768.0f) & (msk)(flt_abs(screen_y) < 32768.0f) & (msk)(w > 0.0f);
    itg bad = ~number | (~in_range & (itg)(outside == 0));
    outside = itg_select(bad, itg_set(0xff), outside);
    msk placed = (msk)(outside == 0);
    itg fixed_x = snap(flt_select(placed, screen_x, flt_set(0)));
    itg fixed_y = snap(flt_select(placed, screen_y, flt_set(0)));
    for (uint32_t lane = 0; lane < GP_LANES && lane < count; lane++) {
        d->positions[first + lane] =
            (FastPosition){ fixed_x[lane], fixed_y[lane], screen_z[lane], rw[lane] };
        d->outside[first + lane] = (uint8_t)outside[lane];
    }
}

static void keep_varyings(const FastDraw *d, uint32_t first, uint32_t count, const flt *position,
                          const float *varying, const float *size)
{
    const GpRasterState *raster = &d->draw->state.raster;
    for (uint32_t lane = 0; lane < GP_LANES && lane < count; lane++) {
        float *to = d->varyings + (size_t)(first + lane) * d->stride;
        for (int c = 0; c < d->modes.components; c++)
            *to++ = varying[c * GP_LANES + (int)lane];
        for (int i = 0; i < GP_MAX_CLIP_PLANES; i++) {
            const float *plane = raster->clip_plane[i];
            if (d->needs.clip_planes >> i & 1)
                *to++ = position[0][lane] * plane[0] + position[1][lane] * plane[1] +
                        position[2][lane] * plane[2] + position[3][lane] * plane[3];
        }
        if (d->point_sizes)
            d->point_sizes[first + lane] = d->draw->program->writes_point_size ? size[lane] : 1.0f;
    }
}

void FAST(shade_vertices)(const FastDraw *d, uint32_t first, uint32_t count)
{
    const GpProgram *program = d->draw->program;
    Block block;
    for (uint32_t done = 0; done < count; done += PACKETS * GP_LANES) {
        uint32_t now = count - done < PACKETS * GP_LANES ? count - done : PACKETS * GP_LANES;
        uint32_t packets = (now + GP_LANES - 1) / GP_LANES;
        fetch(d, first + done, now, &block);
        GpShaderCall call = {
            .uniforms = d->draw->uniforms,
            .packets = (int)packets,
            .in = block.in,
            .textures = d->draw->textures,
            .read_texture = FAST(read_texture),
            .executor = d->samplers,
            .position = block.position,
            .varying = block.varying,
            .point_size = program->writes_point_size ? block.size : NULL,
        };
        d->code->vertex(&call);
        for (uint32_t p = 0; p < packets; p++) {
            const flt *position = (const flt *)(const void *)(block.position + p * 4 * GP_LANES);
            uint32_t at = first + done + p * GP_LANES, left = now - p * GP_LANES;
            place(d, at, left, position);
            keep_varyings(d, at, left, position,
                          block.varying + p * (uint32_t)d->modes.components * GP_LANES,
                          block.size + p * GP_LANES);
        }
    }
}
