/* Binning: which tiles each triangle or point touches, in submission order. */
#include "pipeline/fast/draws/draw.h"

#include "pipeline/base/search.h"
#include "pipeline/units/input_assembly.h"
#include "pipeline/units/texture_read.h"

#include <stdlib.h>
#include <string.h>

/* --- finding draws ---------------------------------------------------------------------------------- */

uint32_t fast_find_draw(const FastPass *pass, uint32_t primitive)
{
    return gp_last_at_most(&pass->draws->first_primitive, sizeof *pass->draws, pass->draw_count,
                           primitive);
}

uint32_t fast_find_block(const FastPass *pass, uint32_t block)
{
    return gp_last_at_most(&pass->draws->first_block, sizeof *pass->draws, pass->draw_count, block);
}

/* --- bins ---------------------------------------------------------------------------------------- */

static void *grown(FastRange *range, void *array, uint32_t needed, uint32_t *room, size_t size)
{
    if (needed <= *room)
        return array;
    uint32_t larger = needed + needed / 2 + 64;
    void *memory = realloc(array, larger * size);
    if (!memory)
        return NULL;
    atomic_fetch_add(&range->budget->used, (larger - *room) * size);
    *room = larger;
    return memory;
}

bool fast_range_begin(FastRange *range, uint32_t tiles)
{
    uint32_t *head = grown(range, range->head, tiles, &range->tile_room, 2 * sizeof *head);
    if (!head)
        return false;
    memset(head, 0, 2 * tiles * sizeof *head);
    range->head = head;
    FastChunk *chunks = grown(range, range->chunks, 1, &range->chunk_room, sizeof *chunks);
    if (!chunks)
        return false;
    chunks[0].count = FAST_CHUNK; /* full: it gives way to a real one */
    chunks[0].group[FAST_CHUNK - 1].first = UINT32_MAX;
    range->chunks = chunks;
    range->tail = range->head + tiles;
    range->chunk_count = 1;
    range->polygon_count = range->corner_count = 0;
    range->clipped = 0;
    range->failed = false;
    return true;
}

void fast_range_free(FastRange *range)
{
    if (range->budget)
        atomic_fetch_sub(&range->budget->used,
                         range->tile_room * 2 * sizeof *range->head +
                             range->chunk_room * sizeof *range->chunks +
                             range->polygon_room * sizeof *range->polygons +
                             range->corner_room * sizeof *range->corners +
                             range->varying_room * sizeof(float[GP_MAX_VARYINGS]));
    free(range->head);
    free(range->chunks);
    free(range->polygons);
    free(range->corners);
    free(range->corner_varyings);
    *range = (FastRange){
        .first = range->first, .end = range->end, .reached = range->reached, .budget = range->budget
    };
}

FastChunk *fast_add_chunk(FastRange *range, uint32_t tile)
{
    FastChunk *chunks =
        grown(range, range->chunks, range->chunk_count + 1, &range->chunk_room, sizeof *chunks);
    if (!chunks) {
        range->failed = true;
        return NULL;
    }
    range->chunks = chunks;
    uint32_t number = range->chunk_count++;
    if (range->tail[tile])
        chunks[range->tail[tile]].next = number;
    else
        range->head[tile] = number;
    range->tail[tile] = number;
    chunks[number].count = chunks[number].next = 0;
    return &chunks[number];
}

void fast_bin_box(const FastPass *pass, FastRange *range, uint32_t primitive, const FastBox *box)
{
    for (int32_t y = box->y0 / FAST_TILE; y <= box->y1 / FAST_TILE; y++)
        for (int32_t x = box->x0 / FAST_TILE; x <= box->x1 / FAST_TILE; x++)
            fast_add_to_tile(range, (uint32_t)y * pass->tiles_x + (uint32_t)x,
                             (FastPrimitiveMask){ primitive, 1 });
}

const FastClipPolygon *fast_find_polygon(const FastRange *range, uint32_t primitive)
{
    return &range->polygons[gp_last_at_most(&range->polygons->primitive, sizeof *range->polygons,
                                            range->polygon_count, primitive)];
}

/* --- boxes ---------------------------------------------------------------------------------------- */

static int32_t least(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static int32_t most(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

/* Pixels whose centres a triangle may hold, cut to the draw's; false where there are none, or where
 * the triangle faces the culled way. */
static bool triangle_box(const FastDraw *d, const int32_t x[3], const int32_t y[3], FastBox *box)
{
    int64_t area2 = (int64_t)(x[1] - x[0]) * (y[2] - y[0]) - (int64_t)(x[2] - x[0]) * (y[1] - y[0]);
    if (area2 == 0 || d->draw->state.raster.cull == (area2 > 0 ? GP_CULL_CW : GP_CULL_CCW))
        return false;
    const int32_t half = GP_SUBPIXELS / 2;
    int32_t low_x = least(x[0], least(x[1], x[2])), high_x = most(x[0], most(x[1], x[2]));
    int32_t low_y = least(y[0], least(y[1], y[2])), high_y = most(y[0], most(y[1], y[2]));
    box->x0 = most((low_x + half - 1) >> GP_SUBPIXEL_BITS, d->rect.x0);
    box->y0 = most((low_y + half - 1) >> GP_SUBPIXEL_BITS, d->rect.y0);
    box->x1 = least((high_x - half) >> GP_SUBPIXEL_BITS, d->rect.x1 - 1);
    box->y1 = least((high_y - half) >> GP_SUBPIXEL_BITS, d->rect.y1 - 1);
    return box->x0 <= box->x1 && box->y0 <= box->y1;
}

/* --- triangles that the clipper must see -------------------------------------------------------------------- */

static void shade_again(const FastDraw *d, uint32_t number, GpVertex *vertex)
{
    GpVertexStage stage = { .program = d->draw->program,
                            .code = d->code,
                            .uniforms = d->draw->uniforms,
                            .textures = d->draw->textures,
                            .read_texture = gp_read_texture_plain };
    float inputs[GP_MAX_INPUTS];
    gp_fetch_vertex(&d->draw->geometry, d->draw->program, number, inputs);
    gp_shade_vertices(&stage, inputs, 1, vertex);
}

/* Keeps a cut polygon's corners; their varyings are found by number until the arrays rest. */
static bool keep_polygon(const FastDraw *d, FastRange *range, uint32_t primitive,
                         const GpClipPolygon *polygon, const GpScreenVertex *screen)
{
    uint32_t corners = (uint32_t)polygon->corners, stride = (uint32_t)d->modes.components;
    FastClipPolygon *polygons = grown(range, range->polygons, range->polygon_count + 1,
                                      &range->polygon_room, sizeof *polygons);
    if (!polygons)
        return false;
    range->polygons = polygons;
    GpScreenVertex *kept = grown(range, range->corners, range->corner_count + corners,
                                 &range->corner_room, sizeof *kept);
    if (!kept)
        return false;
    range->corners = kept;
    float *varyings = grown(range, range->corner_varyings, range->corner_count + corners,
                            &range->varying_room, sizeof(float[GP_MAX_VARYINGS]));
    if (!varyings)
        return false;
    range->corner_varyings = varyings;

    range->polygons[range->polygon_count++] = (FastClipPolygon){ .primitive = primitive,
                                                                 .first = range->corner_count,
                                                                 .corners = corners };
    for (uint32_t i = 0; i < corners; i++) {
        uint32_t at = range->corner_count + i;
        kept[at] = screen[i];
        memcpy(varyings + (size_t)at * GP_MAX_VARYINGS, polygon->corner[i].varying,
               stride * sizeof(float));
    }
    range->corner_count += corners;
    return true;
}

static void bin_clipped(const FastPass *pass, const FastDraw *d, FastRange *range,
                        uint32_t primitive, const uint32_t numbers[3])
{
    GpVertex vertex[3];
    for (int i = 0; i < 3; i++)
        shade_again(d, numbers[i], &vertex[i]);
    GpClipPolygon polygon;
    gp_clip_triangle(&d->band, (const GpVertex *const[3]){ &vertex[0], &vertex[1], &vertex[2] },
                     d->modes.components, d->modes.flat, &polygon);
    range->clipped += polygon.cut;
    GpScreenVertex screen[GP_MAX_CLIPPED];
    for (int i = 0; i < polygon.corners; i++)
        if (!gp_place_vertex(&d->viewport, &d->draw->state.raster, &polygon.corner[i], &screen[i]))
            return;
    FastBox whole = { INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN };
    for (int i = 2; i < polygon.corners; i++) {
        FastBox box;
        int32_t x[3] = { screen[0].x, screen[i - 1].x, screen[i].x };
        int32_t y[3] = { screen[0].y, screen[i - 1].y, screen[i].y };
        if (!triangle_box(d, x, y, &box))
            continue;
        whole.x0 = least(whole.x0, box.x0);
        whole.y0 = least(whole.y0, box.y0);
        whole.x1 = most(whole.x1, box.x1);
        whole.y1 = most(whole.y1, box.y1);
    }
    if (whole.x0 > whole.x1)
        return;
    if (keep_polygon(d, range, primitive, &polygon, screen))
        fast_bin_box(pass, range, primitive | FAST_CLIPPED_FLAG, &whole);
    else
        range->failed = true;
}

/* --- triangles ------------------------------------------------------------------------------------- */

void fast_bin_triangle(const FastPass *pass, const FastDraw *d, FastRange *range,
                       uint32_t primitive)
{
    uint32_t number[3];
    gp_assemble(&d->draw->geometry, primitive - d->first_primitive, number);
    int32_t x[3], y[3];
    unsigned any = 0, all = 0xff;
    for (int i = 0; i < 3; i++) {
        const FastPosition *position = &d->positions[number[i] - d->first_vertex];
        unsigned outside = fast_outside(position);
        x[i] = position->x;
        y[i] = position->y;
        if (outside == FAST_OUTSIDE_ALL)
            return;
        any |= outside;
        all &= outside;
    }
    FastBox box;
    if (all)
        return;
    if (any)
        bin_clipped(pass, d, range, primitive, number);
    else if (triangle_box(d, x, y, &box))
        fast_bin_box(pass, range, primitive, &box);
}
