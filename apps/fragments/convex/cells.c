#include "apps/fragments/convex/cells.h"

#include <string.h>

enum { PER_TILE = CELL_TILE / CELL_SIDE };

static uint32_t parts_of(uint32_t pixels, uint32_t side)
{
    return (pixels + side - 1) / side;
}

static uint32_t at_most(uint32_t value, uint32_t limit)
{
    return value < limit ? value : limit;
}

Cells cells_make(Frame *frame, uint32_t width, uint32_t height)
{
    Cells cells = { .across = parts_of(width, CELL_SIDE),
                    .down = parts_of(height, CELL_SIDE),
                    .tiles_across = parts_of(width, CELL_TILE),
                    .tiles_down = parts_of(height, CELL_TILE),
                    .width = width,
                    .height = height };
    const uint32_t columns = cells.across + 1, count = columns * (cells.down + 1);
    float(*corner)[3] = frame_alloc(frame, count, sizeof *corner);
    cells.is_used = frame_alloc(frame, (size_t)cells.across * cells.down, 1);
    for (uint32_t i = 0; i < count && corner; i++) {
        const uint32_t x = at_most(i % columns * CELL_SIDE, width);
        const uint32_t y = at_most(i / columns * CELL_SIDE, height);
        corner[i][0] = (float)(2.0 * x / width - 1);
        corner[i][1] = (float)(1 - 2.0 * y / height);
    }
    cells.corners =
        (GpGeometry){ .vertex_count = count,
                      .streams = { [GP_POSITION] = { .data = corner, .components = 3 } } };
    return cells;
}

void cells_clear(Cells *cells)
{
    memset(cells->is_used, 0, (size_t)cells->across * cells->down);
}

static int32_t between(int32_t value, int32_t most)
{
    return value < 0 ? 0 : value > most ? most : value;
}

void cells_use(Cells *cells, const ScreenBox *box)
{
    const int32_t side = CELL_SIDE * 256;
    const int32_t right = (int32_t)cells->across - 1, bottom = (int32_t)cells->down - 1;
    const int32_t x0 = between(box->x0 / side, right), x1 = between(box->x1 / side, right);
    const int32_t y0 = between(box->y0 / side, bottom), y1 = between(box->y1 / side, bottom);
    for (int32_t y = y0; y <= y1; y++)
        memset(cells->is_used + (size_t)y * cells->across + x0, 1, (size_t)(x1 - x0 + 1));
}

GpGeometry cells_geometry(const Cells *cells, Frame *frame)
{
    GpGeometry geometry = cells->corners;
    const uint32_t most = (cells->across + 1) / 2 * cells->down, columns = cells->across + 1;
    uint32_t *index = frame_alloc(frame, most, 6 * sizeof *index), count = 0;
    for (uint32_t y = 0; y < cells->down && index; y++) {
        const uint8_t *row = cells->is_used + (size_t)y * cells->across;
        for (uint32_t x = 0, end; x < cells->across; x = end) {
            for (end = x + 1; end < cells->across && row[end] == row[x]; end++)
                ;
            if (!row[x])
                continue;
            const uint32_t left = y * columns + x, right = y * columns + end;
            const uint32_t quad[6] = { left,  right,           left + columns,
                                       right, right + columns, left + columns };
            memcpy(index + count, quad, sizeof quad);
            count += 6;
        }
    }
    geometry.indices = index;
    geometry.index_count = count;
    return geometry;
}

static bool tile_is_used(const Cells *cells, uint32_t tile_x, uint32_t tile_y)
{
    const uint32_t right = at_most((tile_x + 1) * PER_TILE, cells->across);
    const uint32_t bottom = at_most((tile_y + 1) * PER_TILE, cells->down);
    for (uint32_t y = tile_y * PER_TILE; y < bottom; y++)
        for (uint32_t x = tile_x * PER_TILE; x < right; x++)
            if (cells->is_used[(size_t)y * cells->across + x])
                return true;
    return false;
}

const GpRect *cells_rects(const Cells *cells, Frame *frame, uint32_t *count)
{
    GpRect *rects = frame_alloc(frame, (size_t)(cells->tiles_across + 1) / 2 * cells->tiles_down,
                                sizeof *rects);
    *count = 0;
    for (uint32_t y = 0; y < cells->tiles_down && rects; y++)
        for (uint32_t x = 0, end; x < cells->tiles_across; x = end + 1) {
            for (end = x; end < cells->tiles_across && tile_is_used(cells, end, y); end++)
                ;
            if (end > x)
                rects[(*count)++] =
                    (GpRect){ (int32_t)x * CELL_TILE, (int32_t)y * CELL_TILE,
                              (int32_t)end * CELL_TILE, (int32_t)(y + 1) * CELL_TILE };
        }
    return rects;
}
