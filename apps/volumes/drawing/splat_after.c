#include "apps/volumes/drawing/splat_after.h"

#include "apps/base/stable_math.h"
#include "apps/volumes/drawing/splat_filter.h"
#include "shaders_c/volume/splat_after.h"

#include <math.h>
#include <string.h>

enum {
    CELL = 8,   /* samples */
    MARGIN = 3, /* so far from what can be seen a slice is whole */
    FINE = 8,   /* steps from value to value */
};

/* --- which voxels matter ---------------------------------------------------------------------- */

/* Values of one row of a slice between two samples across. */
static void add_row(const Field *field, const VoxelOrder *order, uint32_t place[3], uint32_t end,
                    VoxelRange *range)
{
    const size_t step[3] = { 1, field->size[0], (size_t)field->size[0] * field->size[1] };
    const uint32_t across = order->axis[1];
    const uint8_t *value =
        field->value + place[0] * step[0] + place[1] * step[1] + place[2] * step[2];
    for (uint32_t i = place[across]; i < end; i++, value += step[across]) {
        range->low = *value < range->low ? *value : range->low;
        range->high = *value > range->high ? *value : range->high;
    }
}

static uint32_t below(uint32_t at, uint32_t margin)
{
    return at > margin ? at - margin : 0;
}

static uint32_t least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

/* Whether values between those around a cell are shown. */
static bool cell_matters(const Sheets *sheets, uint32_t slice, const uint32_t first[2])
{
    const VoxelOrder *order = sheets->order;
    const Field *field = sheets->splats->field;
    VoxelRange range = { 255, 0 };
    uint32_t place[3];
    for (uint32_t s = below(slice, 1); s < least(slice + 2, order->slices); s++)
        for (uint32_t down = below(first[1], MARGIN);
             down < least(first[1] + CELL + MARGIN, field->size[order->axis[2]]); down++) {
            place[order->axis[0]] = s;
            place[order->axis[1]] = below(first[0], MARGIN);
            place[order->axis[2]] = down;
            add_row(field, order, place,
                    least(first[0] + CELL + MARGIN, field->size[order->axis[1]]), &range);
        }
    return sheets->shown[range.high + 1] > sheets->shown[range.low];
}

/* --- slices ----------------------------------------------------------------------------------- */

typedef struct After {
    Sheets *sheets;
    SplatCover cover[2]; /* of the slice and of the one before */
    Voxel *voxels;       /* of a slice */
    uint32_t count;
    GpSurface *table;
    AfterUniforms uniforms;
} After;

static void take_cell(After *after, uint32_t slice, const uint32_t first[2])
{
    const VoxelOrder *order = after->sheets->order;
    const Field *field = after->sheets->splats->field;
    uint32_t place[3], end[2];
    double low[3], high[3];
    for (int k = 0; k < 2; k++) {
        end[k] = least(first[k] + CELL, field->size[order->axis[1 + k]]);
        low[order->axis[1 + k]] = first[k];
        high[order->axis[1 + k]] = end[k]; /* the next cell's first, up to which this one goes */
    }
    place[order->axis[0]] = slice;
    low[order->axis[0]] = high[order->axis[0]] = slice;
    for (uint32_t down = first[1]; down < end[1]; down++)
        for (uint32_t across = first[0]; across < end[0]; across++) {
            place[order->axis[1]] = across;
            place[order->axis[2]] = down;
            after->voxels[after->count++] = voxel_of(field, place);
        }
    splat_cover_rectangle(&after->sheets->eye, order, low, high, &after->cover[0]);
}

static void take_slice(After *after, uint32_t slice)
{
    const VoxelOrder *order = after->sheets->order;
    const uint32_t *size = after->sheets->splats->field->size;
    uint32_t first[2];
    after->count = 0;
    splat_cover_clear(&after->cover[0]);
    for (first[1] = 0; first[1] < size[order->axis[2]]; first[1] += CELL)
        for (first[0] = 0; first[0] < size[order->axis[1]]; first[0] += CELL)
            if (cell_matters(after->sheets, slice, first))
                take_cell(after, slice, first);
}

static void draw_slice(After *after, uint32_t slice, uint32_t number)
{
    static const GpProgram *const programs[] = {
        [VOXEL_EWA] = &voxel_after_ewa_program,
        [VOXEL_RECONSTRUCTION] = &voxel_after_reconstruction_program,
        [VOXEL_LOW_PASS] = &voxel_after_low_pass_program,
    };
    Sheets *sheets = after->sheets;
    const uint32_t patches = sheets->order->patches[0] * sheets->order->patches[1];
    VoxelFilter filter = splat_filter_of_patch(&sheets->eye, sheets->order, sheets->splats->field,
                                               sheets->setting, slice, 0);
    for (uint32_t patch = 1; patch < patches; patch++) /* a slice is drawn whole */
        if (splat_filter_of_patch(&sheets->eye, sheets->order, sheets->splats->field,
                                  sheets->setting, slice, patch) != filter)
            filter = VOXEL_EWA;
    sheets_begin_in(sheets, number % 2);
    if (!after->count)
        return;
    const Voxel *voxels =
        frame_copy(sheets->frame, after->voxels, after->count * sizeof *after->voxels);
    if (!voxels)
        return;
    const GpGeometry geometry = {
        .primitive = GP_POINTS,
        .vertex_count = after->count,
        .streams = { [GP_TEXCOORD0] = { &voxels->value, sizeof *voxels, 4, GP_UINT8 },
                     [GP_TEXCOORD1] = { voxels->place, sizeof *voxels, 4, GP_UINT8 } },
    };
    sheets_set_state(sheets,
                     frame_draw(sheets->frame, programs[filter], sheets->uniforms, &geometry));
}

/* --- between slices --------------------------------------------------------------------------- */

/* Sums from value 0 to each: of light sent out, and of extinction. */
static void sum_looks(const Sheets *sheets, double sum[FIELD_VALUES][4])
{
    memset(sum[0], 0, sizeof sum[0]);
    for (int v = 0; v + 1 < FIELD_VALUES; v++) {
        const float *a = sheets->splats->table[v], *b = sheets->splats->table[v + 1];
        memcpy(sum[v + 1], sum[v], sizeof sum[0]);
        for (int i = 0; i < FINE; i++) {
            const double t = (i + 0.5) / FINE;
            const double opacity = (double)a[3] + t * ((double)b[3] - (double)a[3]);
            const double extinction = (double)sheets_extinction(opacity);
            for (int c = 0; c < 3; c++)
                sum[v + 1][c] +=
                    ((double)a[c] + t * ((double)b[c] - (double)a[c])) * extinction / FINE;
            sum[v + 1][3] += extinction / FINE;
        }
    }
}

/* Means from a value in front to one behind: a row of the table for the one behind. */
static GpSurface *make_table(const Sheets *sheets)
{
    GpSurface *table =
        frame_surface(sheets->frame, GP_A32B32G32R32F, FIELD_VALUES, FIELD_VALUES, 1);
    double sum[FIELD_VALUES][4];
    sum_looks(sheets, sum);
    for (int behind = 0; behind < FIELD_VALUES && table->level[0].texels; behind++) {
        float *texel =
            (float *)(void *)(table->level[0].texels + (size_t)behind * table->level[0].pitch);
        for (int front = 0; front < FIELD_VALUES; front++, texel += 4) {
            const float *look = sheets->splats->table[front];
            const double extinction = (double)sheets_extinction((double)look[3]);
            for (int c = 0; c < 4; c++)
                texel[c] = front == behind
                               ? (float)((c < 3 ? (double)look[c] : 1) * extinction)
                               : (float)((sum[behind][c] - sum[front][c]) / (behind - front));
        }
    }
    return table;
}

static AfterUniforms after_uniforms(const Sheets *sheets)
{
    const VoxelEye *eye = &sheets->eye;
    AfterUniforms uniforms = {
        .per_focal = eye->parallel ? 0 : (float)(1 / eye->focal),
        .centre = { (float)(eye->centre[0] - 0.5), (float)(eye->centre[1] - 0.5) },
        .between = (float)sheets->splats->field->scale[eye->along],
        .ambient = sheets->uniforms->ambient,
        .diffuse = sheets->uniforms->diffuse,
    };
    for (int k = 0; k < 3; k++) {
        uniforms.axis[k] = (float)eye->axis[k][eye->along];
        uniforms.light[k] = sheets->uniforms->light[k];
    }
    return uniforms;
}

/* Puts what lies between the last slice and the one before under the sum. */
static void put_between(After *after, uint32_t number)
{
    Sheets *sheets = after->sheets;
    const GpTexture textures[3] = {
        { .surface = sheets->sheet[(number + 1) % 2] },
        { .surface = sheets->sheet[number % 2] },
        { after->table,
          { .min = GP_LINEAR, .mag = GP_LINEAR, .address_u = GP_CLAMP, .address_v = GP_CLAMP } },
    };
    sheets_cover(sheets, &after->cover[0]);
    sheets_under(sheets, &sheets_after_program,
                 frame_copy(sheets->frame, &after->uniforms, sizeof after->uniforms), textures, 3);
}

GpResult splat_after_add(Sheets *sheets, GpError *error)
{
    const Field *field = sheets->splats->field;
    const VoxelOrder *order = sheets->order;
    After after = { .sheets = sheets,
                    .cover = { splat_cover_make(sheets->view, sheets->frame),
                               splat_cover_make(sheets->view, sheets->frame) },
                    .table = make_table(sheets) };
    after.voxels = frame_alloc(sheets->frame,
                               (size_t)field->size[order->axis[1]] * field->size[order->axis[2]],
                               sizeof *after.voxels);
    if (frame_result(sheets->frame, error))
        return GP_ERROR_MEMORY;
    after.uniforms = after_uniforms(sheets);
    for (uint32_t i = 0; i < order->slices; i++) {
        const SplatCover before = after.cover[0];
        after.cover[0] = after.cover[1];
        after.cover[1] = before;
        take_slice(&after, sheets_slice(sheets, i));
        draw_slice(&after, sheets_slice(sheets, i), i);
        if (i > 0)
            put_between(&after, i);
    }
    return GP_OK;
}
