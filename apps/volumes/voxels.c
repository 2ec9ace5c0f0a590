#include "apps/volumes/voxels.h"

#include <math.h>
#include <string.h>

/* --- values and gradients --------------------------------------------------------------------- */

/* Central differences in space; one-sided at the field's sides. */
static double slope(const Field *field, size_t at, uint32_t coordinate, int axis, size_t step)
{
    const bool low = coordinate > 0, high = coordinate + 1 < field->size[axis];
    const int difference =
        (int)field->value[at + (high ? step : 0)] - (int)field->value[at - (low ? step : 0)];
    return low + high != 0 ? difference / (field->scale[axis] * (low + high)) : 0;
}

static void set_attributes(const Field *field, size_t at, const uint32_t place[3],
                           uint8_t attributes[4])
{
    const size_t step[3] = { 1, field->size[0], (size_t)field->size[0] * field->size[1] };
    double gradient[3], square = 0;
    for (int k = 0; k < 3; k++) {
        gradient[k] = slope(field, at, place[k], k, step[k]);
        square += gradient[k] * gradient[k];
    }
    const double scale = square > 0 ? 127 / sqrt(square) : 0;
    attributes[0] = field->value[at];
    for (int k = 0; k < 3; k++)
        attributes[1 + k] = (uint8_t)(128.5 + gradient[k] * scale);
}

static void set_place(const uint32_t place[3], Voxel *voxel)
{
    for (int k = 0; k < 3; k++)
        voxel->place[k] = (uint8_t)place[k];
    voxel->place[3] = (uint8_t)((place[0] >> 8) * 32 + (place[1] >> 8) * 4 + (place[2] >> 8));
}

Voxel voxel_of(const Field *field, const uint32_t place[3])
{
    uint8_t attributes[4];
    Voxel voxel;
    set_attributes(field,
                   ((size_t)place[2] * field->size[1] + place[1]) * field->size[0] + place[0],
                   place, attributes);
    memcpy(&voxel, attributes, sizeof attributes);
    set_place(place, &voxel);
    return voxel;
}

void voxels_attributes(const Field *field, uint8_t *attributes)
{
    uint32_t place[3];
    size_t at = 0;
    for (place[2] = 0; place[2] < field->size[2]; place[2]++)
        for (place[1] = 0; place[1] < field->size[1]; place[1]++)
            for (place[0] = 0; place[0] < field->size[0]; place[0]++, at++)
                set_attributes(field, at, place, attributes + 4 * at);
}

/* --- orders ----------------------------------------------------------------------------------- */

static size_t patch_of(const VoxelOrder *order, const uint32_t place[3])
{
    const uint32_t across = place[order->axis[1]] / VOXEL_PATCH,
                   down = place[order->axis[2]] / VOXEL_PATCH;
    return ((size_t)place[order->axis[0]] * order->patches[1] + down) * order->patches[0] + across;
}

static size_t cell_of(const VoxelOrder *order, const uint32_t place[3])
{
    const uint32_t across = place[order->axis[1]] / VOXEL_CELL,
                   down = place[order->axis[2]] / VOXEL_CELL;
    return ((size_t)place[order->axis[0]] * order->cells[1] + down) * order->cells[0] + across;
}

/* Calls `visit` with all samples but those of the background. */
static void visit_samples(const Field *field, int background, VoxelOrder *order,
                          const uint8_t *attributes,
                          void (*visit)(VoxelOrder *order, const uint32_t place[3],
                                        const uint8_t attributes[4]))
{
    uint32_t place[3];
    for (place[2] = 0; place[2] < field->size[2]; place[2]++)
        for (place[1] = 0; place[1] < field->size[1]; place[1]++)
            for (place[0] = 0; place[0] < field->size[0]; place[0]++, attributes += 4)
                if (attributes[0] != background)
                    visit(order, place, attributes);
}

static void count_voxel(VoxelOrder *order, const uint32_t place[3], const uint8_t attributes[4])
{
    VoxelRange *range = &order->range[cell_of(order, place)];
    order->first[patch_of(order, place) * FIELD_VALUES + attributes[0] + 1]++;
    if (attributes[0] < range->low)
        range->low = attributes[0];
    if (attributes[0] > range->high)
        range->high = attributes[0];
}

static void put_voxel(VoxelOrder *order, const uint32_t place[3], const uint8_t attributes[4])
{
    Voxel *voxel =
        &order->voxels[order->first[patch_of(order, place) * FIELD_VALUES + attributes[0]]++];
    memcpy(voxel, attributes, 4);
    set_place(place, voxel);
}

static GpResult make_order(const Field *field, int background, const uint8_t *attributes,
                           uint32_t axis, VoxelOrder *order)
{
    *order =
        (VoxelOrder){ .axis = { axis, axis == 0, axis == 2 ? 1 : 2 }, .slices = field->size[axis] };
    for (int k = 0; k < 2; k++) {
        const uint32_t side = field->size[order->axis[1 + k]];
        order->patches[k] = (side + VOXEL_PATCH - 1) / VOXEL_PATCH;
        order->cells[k] = (side + VOXEL_CELL - 1) / VOXEL_CELL;
    }
    const size_t lists =
        (size_t)order->slices * order->patches[0] * order->patches[1] * FIELD_VALUES;
    const size_t cells = (size_t)order->slices * order->cells[0] * order->cells[1];
    order->first = gp_alloc(lists + 1, sizeof *order->first);
    order->range = gp_alloc(cells, sizeof *order->range);
    if (!order->first || !order->range)
        return GP_ERROR_MEMORY;
    for (size_t i = 0; i < cells; i++)
        order->range[i].low = 255;
    visit_samples(field, background, order, attributes, count_voxel);
    for (size_t i = 0; i < lists; i++)
        order->first[i + 1] += order->first[i];
    order->voxels = gp_alloc_unset(((size_t)order->first[lists] + 1) * sizeof *order->voxels);
    if (!order->voxels)
        return GP_ERROR_MEMORY;
    visit_samples(field, background, order, attributes, put_voxel);
    memmove(order->first + 1, order->first, lists * sizeof *order->first); /* ends became firsts */
    order->first[0] = 0;
    return GP_OK;
}

/* The value that more than half of all samples have, if it need not be there. */
static int find_background(const Field *field, const bool shown[FIELD_VALUES])
{
    size_t count[FIELD_VALUES] = { 0 };
    for (size_t i = 0; i < field_samples(field); i++)
        count[field->value[i]]++;
    for (int v = 0; v < FIELD_VALUES; v++)
        if (!shown[v] && count[v] > field_samples(field) / 2)
            return v;
    return -1;
}

GpResult voxels_make(const Field *field, const bool shown[FIELD_VALUES], Voxels *voxels,
                     GpError *error)
{
    uint8_t *attributes = gp_alloc_unset(4 * field_samples(field));
    Voxels made = { .background = find_background(field, shown) };
    GpResult result = attributes ? GP_OK : GP_ERROR_MEMORY;
    if (!result)
        voxels_attributes(field, attributes);
    for (uint32_t axis = 0; axis < 3 && !result; axis++)
        result = make_order(field, made.background, attributes, axis, &made.along[axis]);
    gp_free(attributes);
    if (result) {
        voxels_free(&made);
        return gp_fail(error, result, "no memory for the voxels");
    }
    *voxels = made;
    return GP_OK;
}

void voxels_free(Voxels *voxels)
{
    for (int axis = 0; axis < 3; axis++) {
        gp_free(voxels->along[axis].voxels);
        gp_free(voxels->along[axis].first);
        gp_free(voxels->along[axis].range);
    }
    *voxels = (Voxels){ 0 };
}

/* --- transfer functions ----------------------------------------------------------------------- */

uint32_t voxels_shown(const Transfer *transfer, bool shown[FIELD_VALUES])
{
    uint32_t count = 0;
    for (int v = 0; v < FIELD_VALUES; v++) {
        double rgba[4];
        transfer_at(transfer, v, rgba);
        shown[v] = rgba[3] > 0;
        count += shown[v];
    }
    return count;
}

/* Appends the runs of a patch to `runs`, or counts them where that is NULL. */
static uint32_t patch_runs(const uint32_t *first, uint32_t patch, const bool shown[FIELD_VALUES],
                           VoxelRun *runs)
{
    uint32_t count = 0;
    for (int v = 0; v < FIELD_VALUES; v++) {
        if (!shown[v])
            continue;
        const uint32_t begin = first[v];
        while (v < FIELD_VALUES && shown[v])
            v++;
        if (first[v] == begin)
            continue;
        if (runs)
            runs[count] = (VoxelRun){ begin, first[v] - begin, patch };
        count++;
    }
    return count;
}

static uint32_t order_runs(const VoxelOrder *order, const bool shown[FIELD_VALUES], VoxelRun *runs,
                           uint32_t *run_of)
{
    const uint32_t patches = order->patches[0] * order->patches[1];
    uint32_t count = 0;
    for (uint32_t slice = 0; slice < order->slices; slice++) {
        run_of[slice] = count;
        for (uint32_t patch = 0; patch < patches; patch++) {
            const uint32_t *first = order->first + ((size_t)slice * patches + patch) * FIELD_VALUES;
            count += patch_runs(first, patch, shown, runs ? runs + count : NULL);
        }
    }
    run_of[order->slices] = count;
    return count;
}

GpResult voxels_gather(const VoxelOrder *order, const bool shown[FIELD_VALUES], VoxelRun **runs,
                       uint32_t **run_of, GpError *error)
{
    uint32_t *of = gp_alloc(order->slices + 1, sizeof *of);
    VoxelRun *found = of ? gp_alloc(order_runs(order, shown, NULL, of) + 1, sizeof *found) : NULL;
    if (!found) {
        gp_free(of);
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for what a transfer function shows");
    }
    order_runs(order, shown, found, of);
    *runs = found;
    *run_of = of;
    return GP_OK;
}
