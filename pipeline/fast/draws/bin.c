/* Bins, and triangles that lanes leave to be binned one at a time. */
#include "pipeline/fast/draws/bin.h"

#include "pipeline/base/search.h"
#include "pipeline/units/input_assembly.h"
#include "pipeline/units/setup.h"
#include "pipeline/units/texture_read.h"
#include "pipeline/units/vertex_stage.h"

#include <stdlib.h>
#include <string.h>

/* --- bins ------------------------------------------------------------------------------------- */

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

void fast_bin_box(const FastPass *pass, FastRange *range, FastPrimitiveMask group,
                  const FastBox *box)
{
    for (int32_t y = box->y0 / FAST_TILE; y <= box->y1 / FAST_TILE; y++)
        for (int32_t x = box->x0 / FAST_TILE; x <= box->x1 / FAST_TILE; x++)
            fast_add_to_group(range, (uint32_t)y * pass->tiles_x + (uint32_t)x - pass->first_tile,
                              group);
}

const FastClipPolygon *fast_find_polygon(const FastRange *range, uint32_t primitive)
{
    const FastClipPolygon *first = range->polygons;
    return first +
           gp_last_at_most(&first->primitive, sizeof *first, range->polygon_count, primitive);
}

/* --- triangles that the clipper must see ------------------------------------------------------ */

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

/* Stores a clip polygon's corners; their varyings are found by number until the arrays rest. */
static bool store_polygon(const FastDraw *d, FastRange *range, uint32_t primitive,
                          const GpClipPolygon *polygon, const GpScreenVertex *screen)
{
    uint32_t corners = (uint32_t)polygon->corners, stride = (uint32_t)d->modes.components;
    FastClipPolygon *polygons = grown(range, range->polygons, range->polygon_count + 1,
                                      &range->polygon_room, sizeof *polygons);
    if (!polygons)
        return false;
    range->polygons = polygons;
    GpScreenVertex *corner = grown(range, range->corners, range->corner_count + corners,
                                   &range->corner_room, sizeof *corner);
    if (!corner)
        return false;
    range->corners = corner;
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
        corner[at] = screen[i];
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
                     &(GpClipVaryings){ d->modes.components, d->modes.flat, d->modes.screen },
                     &polygon);
    range->clipped += polygon.cut;
    GpScreenVertex screen[GP_MAX_CLIPPED];
    for (int i = 0; i < polygon.corners; i++)
        if (!gp_viewport_transform(&d->viewport, &d->draw->state.raster, &polygon.corner[i],
                                   &screen[i]))
            return;
    FastBox whole = { INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN };
    for (int i = 2; i < polygon.corners; i++) {
        const GpScreenVertex corner[3] = { screen[0], screen[i - 1], screen[i] };
        GpTriangle t;
        if (gp_setup_triangle(corner, &d->draw->state.raster, &d->rect, &t) != GP_SETUP_DRAWN)
            continue;
        whole.x0 = t.x0 < whole.x0 ? t.x0 : whole.x0;
        whole.y0 = t.y0 < whole.y0 ? t.y0 : whole.y0;
        whole.x1 = t.x1 > whole.x1 ? t.x1 : whole.x1;
        whole.y1 = t.y1 > whole.y1 ? t.y1 : whole.y1;
    }
    if (whole.x0 > whole.x1)
        return;
    if (store_polygon(d, range, primitive, &polygon, screen))
        fast_bin_box(pass, range, (FastPrimitiveMask){ primitive | FAST_CLIPPED_FLAG, 1 }, &whole);
    else
        range->failed = true;
}

/* --- triangles -------------------------------------------------------------------------------- */

/* Neighbours of one box, such as the halves of a rectangle: they go into its tiles together, and
 * fills by two threads take 6 to 7 % less. */
typedef struct Alike {
    FastPrimitiveMask group;
    FastBox box;
} Alike;

static void bin_alike(const FastPass *pass, FastRange *range, Alike *alike)
{
    if (alike->group.lanes)
        fast_bin_box(pass, range, alike->group, &alike->box);
    alike->group.lanes = 0;
}

static void add_alike(const FastPass *pass, FastRange *range, Alike *alike, unsigned lane,
                      const FastBox *box)
{
    if (memcmp(&alike->box, box, sizeof *box) != 0)
        bin_alike(pass, range, alike);
    alike->group.lanes |= lane;
    alike->box = *box;
}

static void bin_triangle(const FastPass *pass, const FastDraw *d, FastRange *range, unsigned lane,
                         Alike *alike)
{
    const uint32_t primitive = alike->group.first + (uint32_t)__builtin_ctz(lane);
    uint32_t number[3];
    GpScreenVertex corner[3];
    GpTriangle t;
    unsigned any = 0, all = FAST_OUTSIDE_ALL;
    gp_assemble(&d->draw->geometry, primitive - d->first_primitive, number);
    for (int i = 0; i < 3; i++) {
        const FastPosition *at = &d->positions[number[i] - d->first_vertex];
        const unsigned outside = fast_outside(at);
        corner[i] = (GpScreenVertex){ .x = at->x, .y = at->y, .z = at->z, .rw = at->rw };
        if (outside == FAST_OUTSIDE_ALL)
            return;
        any |= outside;
        all &= outside;
    }
    if (all)
        return;
    if (any) {
        bin_alike(pass, range, alike);
        bin_clipped(pass, d, range, primitive, number);
    } else if (gp_setup_triangle(corner, &d->draw->state.raster, &d->rect, &t) == GP_SETUP_DRAWN)
        add_alike(pass, range, alike, lane, &(FastBox){ t.x0, t.y0, t.x1, t.y1 });
}

void fast_bin_triangles(const FastPass *pass, const FastDraw *d, FastRange *range,
                        FastPrimitiveMask group)
{
    Alike alike = { .group = { group.first, 0 } };
    for (unsigned left = group.lanes; left; left &= left - 1)
        bin_triangle(pass, d, range, left & -left, &alike);
    bin_alike(pass, range, &alike);
}
