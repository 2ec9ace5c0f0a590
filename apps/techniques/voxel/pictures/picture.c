/* What a picture shows: which volumes in which paint, around which scan, from where. */
#include "apps/techniques/voxel/pictures/picture.h"

#include "apps/techniques/voxel/pictures/scan.h"
#include "apps/volumes/transfer.h"

#include <math.h>
#include <string.h>

/* --- scans ------------------------------------------------------------------------------------ */

enum { WIDE = 128 }; /* voxels a side of the volume whose voxels have these densities */

/* Nothing, skin, flesh, bone: as bytes of a scan by X-rays have them, and other scans roughly. In
 * the place of opacity a density, which adds up along a ray. */
static const Transfer densities = { 6,
                                    { { 0, { 0.9, 0.6, 0.4, 0 } },
                                      { 48, { 0.9, 0.6, 0.4, 0 } },
                                      { 70, { 0.9, 0.6, 0.45, 0.03 } },
                                      { 110, { 0.85, 0.5, 0.4, 0.02 } },
                                      { 140, { 0.95, 0.9, 0.8, 0.12 } },
                                      { 255, { 1, 0.98, 0.92, 0.3 } } } };

/* How much light a voxel takes, as a share of what it lets through: twice as many voxels on the
 * same way take half of it each, nearly. */
static double opacity_of(double density)
{
    return density / (1 + density);
}

static void make_table(uint32_t size, uint8_t table[FIELD_VALUES][4])
{
    for (int i = 0; i < FIELD_VALUES; i++) {
        double rgba[4];
        transfer_at(&densities, i, rgba);
        rgba[3] = opacity_of(rgba[3] * WIDE / size);
        for (int c = 0; c < 4; c++)
            table[i][c] = (uint8_t)(rgba[c] * 255 + 0.5);
    }
}

static GpResult add_scan(const GpVolume *scan, uint32_t size, Frame *frame, VoxelView *view,
                         GpError *error)
{
    if (size > VOXEL_SCAN_MAX_SIZE)
        return gp_fail(error, GP_ERROR_INVALID, "--scan: a volume of at most %d voxels a side",
                       VOXEL_SCAN_MAX_SIZE);
    GpResult result = flat_texture_check(size, 8, error);
    if (result)
        return result;
    uint8_t *bytes = field_bytes(scan, NULL);
    if (!bytes)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    double spacing[3], longest = 0;
    for (int k = 0; k < 3; k++)
        longest = fmax(longest, scan->dims[k] * scan->spacing[k]);
    for (int k = 0; k < 3; k++)
        spacing[k] = scan->spacing[k] * size / longest;
    const FlatTexture flat = voxel_scan(frame, bytes, scan->dims, spacing, size);
    gp_free(bytes);
    const FlatTexture slopes = voxel_scan_slopes(frame, &flat);
    uint8_t transfer[FIELD_VALUES][4];
    make_table(size, transfer);
    view->scan = frame_copy(frame, &slopes, sizeof slopes);
    view->transfer = frame_copy(frame, transfer, sizeof transfer);
    return frame_result(frame, error);
}

/* --- the picture ------------------------------------------------------------------------------ */

/* Of a solid that fills its volume, at any size. */
#define SOLID_DENSITY 3.0

/* Opacity of a model in a scan: what is around it lights up too. */
#define IN_SCAN 0.35f

/* From around the voxels of a range. */
static Camera place_camera(const VoxelPicture *picture, const VoxelRange *range)
{
    Bounds seen;
    for (int k = 0; k < 3; k++) {
        seen.low[k] = range->low[k];
        seen.high[k] = range->end[k];
    }
    return orbit_camera(&picture->orbit, &seen, (double)picture->width / picture->height, 1);
}

GpResult voxel_picture_build(const VoxelPicture *picture, const VoxelPairMade *made,
                             const GpVolume *scan, Frame *frame, GpError *error)
{
    const uint32_t size = made->result.size;
    if (made->result.bits != 1)
        return gp_fail(error, GP_ERROR_INVALID, "a picture is of one bit a voxel, not %u",
                       made->result.bits);
    VoxelView view = voxel_view_defaults;
    view.mode = picture->look;
    view.shading = picture->shading;
    view.range = made->range;
    if (picture->is_solid)
        view.paint.opacity = view.second_paint.opacity = (float)opacity_of(SOLID_DENSITY / size);
    if (picture->shows_both) {
        view.second = &made->volumes[1];
        view.range = made->around;
    }
    if (scan) {
        GpResult result = add_scan(scan, size, frame, &view, error);
        if (result)
            return result;
        view.paint = view.second_paint; /* not the colour of bones */
        view.paint.opacity = IN_SCAN;
    }
    const bool anywhere = scan || voxel_range_is_empty(&view.range);
    const VoxelRange seen = anywhere ? voxel_range_whole(size) : view.range;
    view.camera = place_camera(picture, &seen);
    return voxel_view_build(picture->shows_both ? &made->volumes[0] : &made->result, &view,
                            picture->width, picture->height, frame, error);
}
