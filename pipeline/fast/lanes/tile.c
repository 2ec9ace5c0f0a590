/* One tile: its primitives in submission order, from clear to store. */
#include "pipeline/fast/lanes/tile.h"

#include "pipeline/input_assembly.h"

#include <string.h>

void FAST(corner_of)(const FastDraw *d, uint32_t number, GpScreenVertex *corner)
{
    uint32_t at = number - d->first_vertex;
    const FastPosition *p = &d->positions[at];
    corner->x = p->x;
    corner->y = p->y;
    corner->z = p->z;
    corner->rw = p->rw;
    corner->varying = d->varyings + (size_t)at * d->stride;
    const float *distance = corner->varying + d->modes.components;
    for (int i = 0; i < GP_MAX_CLIP_PLANES; i++)
        if (d->needs.clip_planes >> i & 1)
            corner->clip_distance[i] = *distance++;
}

GpRect FAST(tile_rect)(const Tile *tile, const FastDraw *d)
{
    GpRect r = d->rect;
    r.x0 = r.x0 > tile->x0 ? r.x0 : tile->x0;
    r.y0 = r.y0 > tile->y0 ? r.y0 : tile->y0;
    r.x1 = r.x1 < tile->x0 + tile->width ? r.x1 : tile->x0 + tile->width;
    r.y1 = r.y1 < tile->y0 + tile->height ? r.y1 : tile->y0 + tile->height;
    return r;
}

static void draw_corners(Tile *tile, const GpScreenVertex corner[3])
{
    GpTriangle triangle;
    GpRect rect = FAST(tile_rect)(tile, tile->draw);
    if (gp_setup_triangle(corner, &tile->draw->draw->state.raster, &rect, &triangle) ==
        GP_SETUP_DRAWN)
        FAST(fill_triangle)(tile, &triangle);
}

static void draw_cut(Tile *tile, const FastRange *range, uint32_t primitive)
{
    const FastCut *fan = fast_find_cut(range, primitive);
    const GpScreenVertex *corners = range->corners + fan->first;
    for (uint32_t i = 2; i < fan->corners; i++) {
        GpScreenVertex corner[3] = { corners[0], corners[i - 1], corners[i] };
        for (int k = 0; k < 3; k++) { /* found by number: the arrays may have moved */
            uint32_t at = fan->first + (k == 0 ? 0 : i - 2 + (uint32_t)k);
            corner[k].varying = range->corner_varyings + (size_t)at * GP_MAX_VARYINGS;
        }
        draw_corners(tile, corner);
    }
}

static bool inside_clip_planes(const FastDraw *d, const GpScreenVertex *center)
{
    for (int i = 0; i < GP_MAX_CLIP_PLANES; i++)
        if ((d->needs.clip_planes >> i & 1) && !(center->clip_distance[i] >= 0))
            return false;
    return true;
}

static void draw_point(Tile *tile, uint32_t primitive)
{
    const FastDraw *d = tile->draw;
    uint32_t number[3];
    GpScreenVertex center;
    GpPointSprite sprite;
    GpRect rect = FAST(tile_rect)(tile, d);
    gp_assemble(&d->draw->geometry, primitive - d->first_primitive, number);
    FAST(corner_of)(d, number[0], &center);
    if (inside_clip_planes(d, &center) &&
        gp_setup_point(&center, d->point_sizes[number[0] - d->first_vertex], &rect, &sprite) ==
            GP_SETUP_DRAWN)
        FAST(fill_sprite)(tile, &sprite, center.varying);
}

/* Between draws: packets wait for one draw only, and what is seen must be shaded before a draw that
 * looks at the targets. */
static void begin_draw(Tile *tile, uint32_t number)
{
    FAST(flush_patches)(tile);
    tile->draw = &tile->pass->draws[number];
    tile->draw_number = number;
    if (tile->draw->route == FAST_ORDERED)
        FAST(flush_seen)(tile);
}

/* Triangles that wait for a batch to be full. */
typedef struct Waiting {
    uint32_t primitive[GP_LANES];
    uint32_t count;
} Waiting;

static void draw_waiting(Tile *tile, Waiting *waiting)
{
    if (waiting->count)
        FAST(fill_batch)(tile, waiting->primitive, waiting->count);
    waiting->count = 0;
}

static void draw_primitive(Tile *tile, const FastRange *range, uint32_t entry, Waiting *waiting)
{
    uint32_t primitive = entry & ~FAST_CUT_FLAG;
    const FastDraw *d = tile->draw;
    if (!d || primitive < d->first_primitive ||
        primitive >= d->first_primitive + d->primitive_count) {
        draw_waiting(tile, waiting);
        begin_draw(tile, fast_find_draw(tile->pass, primitive));
    }
    if (tile->draw->draw->geometry.primitive == GP_POINTS)
        draw_point(tile, primitive);
    else if (entry & FAST_CUT_FLAG) {
        draw_waiting(tile, waiting);
        draw_cut(tile, range, primitive);
    } else {
        waiting->primitive[waiting->count++] = primitive;
        if (waiting->count == GP_LANES)
            draw_waiting(tile, waiting);
    }
}

static void draw_range(Tile *tile, const FastRange *range, uint32_t number)
{
    Waiting waiting = { .count = 0 };
    for (uint32_t at = range->head[number]; at; at = range->chunks[at].next) {
        const FastChunk *chunk = &range->chunks[at];
        for (uint32_t i = 0; i < chunk->count; i++)
            draw_primitive(tile, range, chunk->primitive[i], &waiting);
    }
    draw_waiting(tile, &waiting);
}

/* Whether any primitive touches the tile. */
static bool is_touched(const FastPass *pass, uint32_t number)
{
    for (uint32_t r = 0; r < pass->range_count; r++)
        if (pass->ranges[r].head[number])
            return true;
    return false;
}

static void draw_tile(const FastPass *pass, uint32_t number, FastTileMemory *tile)
{
    tile->pass = pass;
    tile->x0 = (int32_t)(number % pass->tiles_x) * FAST_TILE;
    tile->y0 = (int32_t)(number / pass->tiles_x) * FAST_TILE;
    int32_t width = (int32_t)pass->width - tile->x0, height = (int32_t)pass->height - tile->y0;
    tile->width = width < FAST_TILE ? width : FAST_TILE;
    tile->height = height < FAST_TILE ? height : FAST_TILE;
    tile->targets = 0;
    while (tile->targets < GP_MAX_TARGETS && pass->pass->color[tile->targets].surface)
        tile->targets++;
    tile->depth_format =
        pass->pass->depth.surface ? pass->pass->depth.surface->format : GP_FORMAT_NONE;
    tile->draw = NULL;
    tile->patch_count = 0;
    tile->record_count = FAST_NO_RECORD + 1;
    tile->wide_count = tile->run_count = 0;

    if (!is_touched(pass, number)) {
        FAST(clear_untouched)(tile);
        return;
    }
    FAST(load_tile)(tile);
    for (uint32_t r = 0; r < pass->range_count; r++)
        draw_range(tile, &pass->ranges[r], number);
    FAST(flush_patches)(tile);
    FAST(flush_seen)(tile);
    FAST(store_tile)(tile);
}

static size_t tile_bytes(void)
{
    return sizeof(FastTileMemory);
}

void FAST(shade_vertices)(const FastDraw *draw, uint32_t first, uint32_t count);
void FAST(bin_range)(const FastPass *pass, FastRange *range, uint32_t first, uint32_t end);

#define STAGES_PASTE_(lanes) fast_stages##lanes
#define STAGES_PASTE(lanes)  STAGES_PASTE_(lanes)

const FastStages STAGES_PASTE(GP_LANES) = {
    .lanes = GP_LANES,
    .shade_vertices = FAST(shade_vertices),
    .bin_range = FAST(bin_range),
    .draw_tile = draw_tile,
    .tile_bytes = tile_bytes,
};
