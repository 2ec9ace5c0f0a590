#include "apps/depth_images/drawing/cylinder_strips.h"

#include "apps/base/camera.h"
#include "apps/depth_images/drawing/surface_grid.h"

#include <math.h>
#include <string.h>

enum { PART = 32 }; /* cells of a part */

/* --- making ----------------------------------------------------------------------------------- */

static void make_vertices(const SurfaceGrid *grid, CylinderStrips *strips)
{
    const DepthImage *image = grid->image;
    const DepthPixels *pixels = &image->front;
    for (uint32_t x = 0; x <= strips->strips; x++)
        for (uint32_t y = 0; y < strips->rows; y++) {
            CylinderVertex *vertex = &strips->vertices[(size_t)x * strips->rows + y];
            double sine, cosine;
            surface_grid_texcoord(grid, y * grid->columns + x, vertex->texel);
            const uint32_t column = (uint32_t)((double)vertex->texel[0] * pixels->width);
            const uint32_t row = (uint32_t)((double)vertex->texel[1] * pixels->height);
            angle_sincos(360 * ((column % pixels->width + 0.5) / pixels->width), &sine, &cosine);
            const float depth = pixels->depth[(size_t)row * pixels->width + column % pixels->width];
            vertex->turn[0] = (float)cosine;
            vertex->turn[1] = (float)sine;
            vertex->turn[2] =
                (float)((0.5 - (row + 0.5) / pixels->height) * image->cylinder.height);
            vertex->texel[2] = isfinite(depth) ? depth : 0;
        }
}

static void make_cells(const SurfaceGrid *grid, CylinderStrips *strips)
{
    const uint32_t rows = strips->rows;
    uint32_t count = 0;
    for (uint32_t x = 0; x < strips->strips; x++) {
        const uint32_t begin = count;
        for (uint32_t y = 0; y < rows; y++) {
            const uint32_t at = x * rows + y,
                           cell[6] = { at, at + 1, at + rows, at + rows, at + 1, at + rows + 1 };
            const float(*above)[3] = &grid->position[(size_t)y * grid->columns + x];
            const float(*below)[3] = above + grid->columns;
            strips->first[at] = count;
            if (y + 1 == rows || !isfinite(above[0][0] + above[1][0] + below[0][0] + below[1][0]))
                continue;
            memcpy(&strips->falling[count], cell, sizeof cell);
            count += 6;
        }
        for (uint32_t i = begin; i < count; i += 6)
            memcpy(&strips->rising[begin + count - i - 6], &strips->falling[i],
                   6 * sizeof(uint32_t));
    }
}

static uint32_t row_of_part(const CylinderStrips *strips, uint32_t part)
{
    return part * PART < strips->rows - 1 ? part * PART : strips->rows - 1;
}

/* position: of the vertices */
static void find_bounds(CylinderStrips *strips, const float (*position)[3])
{
    for (uint32_t i = 0; i < strips->strips * strips->parts; i++) {
        const uint32_t *first = strips->first + i / strips->parts * strips->rows;
        MergedPatch *patch = &strips->bounds[i];
        patch->first_index = first[row_of_part(strips, i % strips->parts)];
        patch->index_count = first[row_of_part(strips, i % strips->parts + 1)] - patch->first_index;
        if (patch->index_count)
            merged_patch_bound(position, NULL, strips->falling, patch);
    }
}

static GpResult make(const SurfaceGrid *grid, CylinderStrips *strips)
{
    const uint32_t rows = grid->rows, count = grid->columns * rows;
    strips->step = grid->step;
    strips->strips = grid->columns - 1;
    strips->rows = rows;
    strips->parts = (rows + PART - 2) / PART;
    strips->vertices = gp_alloc(count, sizeof *strips->vertices);
    strips->first = gp_alloc(count, sizeof *strips->first);
    strips->falling = gp_alloc(count, 6 * sizeof *strips->falling);
    strips->rising = gp_alloc(count, 6 * sizeof *strips->rising);
    strips->bounds = gp_alloc((size_t)strips->strips * strips->parts, sizeof *strips->bounds);
    float(*position)[3] = gp_alloc(count, sizeof *position);
    const bool has_memory = strips->vertices && strips->first && strips->falling &&
                            strips->rising && strips->bounds && position;
    for (uint32_t i = 0; i < count && has_memory; i++)
        memcpy(position[i], grid->position[i % rows * grid->columns + i / rows],
               sizeof position[i]);
    if (has_memory) {
        make_vertices(grid, strips);
        make_cells(grid, strips);
        find_bounds(strips, (const float(*)[3])position);
    }
    gp_free(position);
    return has_memory ? GP_OK : GP_ERROR_MEMORY;
}

GpResult cylinder_strips_open(const DepthImage *image, uint32_t step, CylinderStrips *strips,
                              GpError *error)
{
    CylinderStrips made = { .step = 0 };
    SurfaceGrid grid;
    GpResult result = surface_grid_open(image, NULL, step, -1, &grid, error);
    if (result)
        return result;
    result = make(&grid, &made);
    surface_grid_close(&grid);
    if (result) {
        cylinder_strips_close(&made);
        return gp_fail(error, result, "out of memory");
    }
    *strips = made;
    return GP_OK;
}

void cylinder_strips_close(CylinderStrips *strips)
{
    gp_free(strips->vertices);
    gp_free(strips->first);
    gp_free(strips->falling);
    gp_free(strips->rising);
    gp_free(strips->bounds);
    *strips = (CylinderStrips){ .step = 0 };
}

/* --- drawing ---------------------------------------------------------------------------------- */

typedef struct Drawing {
    const CylinderStrips *strips;
    const GpDraw *draw;
    const double *eye; /* NULL: all may be seen */
    uint32_t eye_row;  /* the cell at the eye's height */
    Frame *frame;
    uint32_t triangles;
} Drawing;

static void add_cells(Drawing *drawing, const uint32_t *indices, uint32_t count)
{
    GpGeometry geometry = drawing->draw->geometry;
    if (!count)
        return;
    geometry.indices = indices;
    geometry.index_count = count;
    GpDraw *draw =
        frame_draw(drawing->frame, drawing->draw->program, drawing->draw->uniforms, &geometry);
    draw->state = drawing->draw->state;
    memcpy(draw->textures, drawing->draw->textures, sizeof draw->textures);
    drawing->triangles += count / 3;
}

/* From the first part that may show its outside to the last. */
static void seen_rows(const Drawing *drawing, uint32_t strip, uint32_t rows[2])
{
    const CylinderStrips *strips = drawing->strips;
    rows[0] = strips->rows - 1;
    rows[1] = 0;
    for (uint32_t i = 0; i < strips->parts; i++) {
        const MergedPatch *patch = &strips->bounds[strip * strips->parts + i];
        if (!patch->index_count || (drawing->eye && !merged_may_face(patch, drawing->eye, false)))
            continue;
        const uint32_t from = row_of_part(strips, i);
        rows[0] = from < rows[0] ? from : rows[0];
        rows[1] = row_of_part(strips, i + 1);
    }
}

/* From the foot to the eye's height, then from the top to it; the cell at that height last. */
static void add_strip(Drawing *drawing, uint32_t strip)
{
    const CylinderStrips *strips = drawing->strips;
    const uint32_t *first = strips->first + (size_t)strip * strips->rows;
    const uint32_t begin = first[0], end = first[strips->rows - 1];
    uint32_t rows[2];
    seen_rows(drawing, strip, rows);
    if (rows[0] >= rows[1])
        return;
    uint32_t turn = drawing->eye_row + 1;
    turn = turn < rows[0] ? rows[0] : turn > rows[1] ? rows[1] : turn;
    add_cells(drawing, strips->rising + begin + (end - first[rows[1]]),
              first[rows[1]] - first[turn]);
    add_cells(drawing, strips->falling + first[rows[0]], first[turn] - first[rows[0]]);
}

/* The cell of `count` that a place is in, or the nearest. */
static uint32_t cell_at(double place, uint32_t step, uint32_t count)
{
    const double cell = floor((place - 0.5) / step);
    return cell < 0 ? 0 : cell >= count ? count - 1 : (uint32_t)cell;
}

uint32_t cylinder_strips_draw(const CylinderStrips *strips, const GpDraw *draw, const double eye[3],
                              const double place[2], Frame *frame)
{
    const uint32_t count = strips->strips, step = strips->step;
    Drawing drawing = { .strips = strips, .draw = draw, .eye = eye, .frame = frame };
    if (!count || strips->rows < 2)
        return 0;
    drawing.eye_row = cell_at(place[1], step, strips->rows - 1);
    const uint32_t at = place[0] < 0.5 ? count - 1 : cell_at(place[0], step, count);
    for (uint32_t away = count / 2; away > 0; away--) {
        add_strip(&drawing, (at + away) % count);
        if (2 * away != count)
            add_strip(&drawing, (at + count - away) % count);
    }
    add_strip(&drawing, at);
    return drawing.triangles;
}
