#include "apps/volumes/drawing/splat_cover.h"

#include <math.h>
#include <string.h>

SplatCover splat_cover_make(const VolumeView *view, Frame *frame)
{
    SplatCover cover = { .width = (view->width + COVER_CELL - 1) / COVER_CELL,
                         .height = (view->height + COVER_CELL - 1) / COVER_CELL };
    cover.covered = frame_alloc(frame, (size_t)cover.width * cover.height, 1);
    return cover;
}

static uint32_t cell_at(double pixel, uint32_t cells)
{
    const double cell = floor(pixel / COVER_CELL);
    return cell < 0 ? 0 : cell >= cells ? cells - 1 : (uint32_t)cell;
}

/* Low and high corners in pixels; nothing where they lie outside. */
static void cover_box(const double low[2], const double high[2], SplatCover *cover)
{
    if (!cover->covered || high[0] < 0 || high[1] < 0 || low[0] >= cover->width * COVER_CELL ||
        low[1] >= cover->height * COVER_CELL)
        return;
    const uint32_t x0 = cell_at(low[0], cover->width), x1 = cell_at(high[0], cover->width);
    const uint32_t y0 = cell_at(low[1], cover->height), y1 = cell_at(high[1], cover->height);
    for (uint32_t y = y0; y <= y1; y++)
        memset(cover->covered + (size_t)y * cover->width + x0, 1, x1 - x0 + 1);
}

void splat_cover_pixel(const double pixel[2], double reach, SplatCover *cover)
{
    const double low[2] = { pixel[0] - reach, pixel[1] - reach },
                 high[2] = { pixel[0] + reach, pixel[1] + reach };
    cover_box(low, high, cover);
}

void splat_cover_add(const SplatCover *more, SplatCover *cover)
{
    for (size_t i = 0; more->covered && cover->covered && i < (size_t)cover->width * cover->height;
         i++)
        cover->covered[i] |= more->covered[i];
}

void splat_cover_rectangle(const VoxelEye *eye, const VoxelOrder *order, const double low[3],
                           const double high[3], SplatCover *cover)
{
    double least[2] = { HUGE_VAL, HUGE_VAL }, most[2] = { -HUGE_VAL, -HUGE_VAL };
    for (int corner = 0; corner < 4; corner++) {
        double place[3] = { low[0], low[1], low[2] }, pixel[2];
        for (int k = 0; k < 2; k++)
            if (corner >> k & 1)
                place[order->axis[1 + k]] = high[order->axis[1 + k]];
        const double reach = voxel_eye_pixel(eye, place, pixel);
        for (int k = 0; k < 2; k++) {
            least[k] = reach < 0 ? -HUGE_VAL : fmin(least[k], pixel[k] - reach);
            most[k] = reach < 0 ? HUGE_VAL : fmax(most[k], pixel[k] + reach);
        }
        if (reach < 0)
            break;
    }
    cover_box(least, most, cover);
}

void splat_cover_slice(const VoxelEye *eye, const VoxelOrder *order, uint32_t slice,
                       const uint16_t shown[FIELD_VALUES + 1], const Field *field,
                       SplatCover *cover)
{
    const VoxelRange *range = order->range + (size_t)slice * order->cells[0] * order->cells[1];
    for (uint32_t down = 0; down < order->cells[1]; down++)
        for (uint32_t across = 0; across < order->cells[0]; across++, range++) {
            if (range->low > range->high || shown[range->high + 1] == shown[range->low])
                continue;
            const uint32_t first[2] = { across * VOXEL_CELL, down * VOXEL_CELL };
            double low[3], high[3];
            low[order->axis[0]] = high[order->axis[0]] = slice;
            for (int k = 0; k < 2; k++) {
                const uint32_t last = first[k] + VOXEL_CELL - 1,
                               end = field->size[order->axis[1 + k]] - 1;
                low[order->axis[1 + k]] = first[k];
                high[order->axis[1 + k]] = last < end ? last : end;
            }
            splat_cover_rectangle(eye, order, low, high, cover);
        }
}

static bool is_row_left(const uint8_t *row, uint32_t wide)
{
    uint32_t x = 0;
    while (x < wide && row[x] == 1)
        x++;
    return x == wide;
}

/* A rectangle of covered cells, from (x, y) to the right and then down; marks them as drawn. */
static GpRect take_rectangle(const SplatCover *cover, uint32_t x, uint32_t y)
{
    uint8_t *row = cover->covered + (size_t)y * cover->width + x;
    uint32_t wide = 0, high = 0;
    while (x + wide < cover->width && row[wide] == 1)
        wide++;
    for (; y + high < cover->height && is_row_left(row, wide); high++, row += cover->width)
        memset(row, 2, wide);
    return (GpRect){ (int32_t)(x * COVER_CELL), (int32_t)(y * COVER_CELL),
                     (int32_t)((x + wide) * COVER_CELL), (int32_t)((y + high) * COVER_CELL) };
}

static void draw_rectangle(const GpRect *rect, const GpProgram *program, const void *uniforms,
                           const GpTexture *textures, uint32_t texture_count, const GpState *state,
                           Frame *frame)
{
    static const float corners[] = { -1, -1, 0, -1, 3, 0, 3, -1, 0 };
    const GpGeometry whole = {
        .vertex_count = 3, .streams = { [GP_POSITION] = { .data = corners, .components = 3 } }
    };
    GpDraw *draw = frame_draw(frame, program, uniforms, &whole);
    draw->state = *state;
    draw->state.raster.scissor = true;
    draw->state.raster.scissor_x0 = rect->x0;
    draw->state.raster.scissor_y0 = rect->y0;
    draw->state.raster.scissor_x1 = rect->x1;
    draw->state.raster.scissor_y1 = rect->y1;
    memcpy(draw->textures, textures, texture_count * sizeof *textures);
}

void splat_cover_draw(const SplatCover *cover, const VolumeView *view, const GpProgram *program,
                      const void *uniforms, const GpTexture *textures, uint32_t texture_count,
                      const GpState *state, Frame *frame)
{
    for (uint32_t y = 0; cover->covered && y < cover->height; y++)
        for (uint32_t x = 0; x < cover->width; x++)
            if (cover->covered[(size_t)y * cover->width + x] == 1) {
                GpRect rect = take_rectangle(cover, x, y);
                rect.x1 = rect.x1 < (int32_t)view->width ? rect.x1 : (int32_t)view->width;
                rect.y1 = rect.y1 < (int32_t)view->height ? rect.y1 : (int32_t)view->height;
                draw_rectangle(&rect, program, uniforms, textures, texture_count, state, frame);
            }
    for (size_t i = 0; cover->covered && i < (size_t)cover->width * cover->height; i++)
        cover->covered[i] = cover->covered[i] > 0;
}

void splat_cover_clear(SplatCover *cover)
{
    if (cover->covered)
        memset(cover->covered, 0, (size_t)cover->width * cover->height);
}
