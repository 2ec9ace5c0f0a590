#include "apps/volumes/drawing/splat.h"

#include "apps/volumes/drawing/splat_after.h"
#include "apps/volumes/drawing/splat_filter.h"
#include "apps/volumes/drawing/splat_modes.h"
#include "apps/volumes/drawing/splat_slabs.h"

/* --- slices ----------------------------------------------------------------------------------- */

static void draw_run(const VoxelFeed *feed, uint32_t slice, const VoxelRun *run)
{
    const Sheets *sheets = feed->sheets;
    voxel_feed_run(feed, slice, run,
                   splat_filter_of_patch(&sheets->eye, sheets->order, sheets->splats->field,
                                         sheets->setting, slice, run->patch));
}

/* Sheets of `thickness` slices that have something. */
static GpResult add_slices(Sheets *sheets, GpError *error)
{
    VoxelFeed feed;
    GpResult result = voxel_feed_begin(sheets, &feed, error);
    if (result)
        return result;
    const uint32_t *run_of = sheets->splats->run_of[sheets->eye.along];
    const VoxelRun *runs = sheets->splats->runs[sheets->eye.along];
    const double thickness = splat_thickness(sheets->setting);
    const uint32_t most = thickness >= 1 ? (uint32_t)thickness : 1;
    uint32_t held = 0;
    for (uint32_t i = 0; i < sheets->order->slices; i++) {
        const uint32_t slice = sheets_slice(sheets, i);
        if (run_of[slice] == run_of[slice + 1])
            continue;
        if (held == 0)
            sheets_begin(sheets);
        for (uint32_t run = run_of[slice]; run < run_of[slice + 1]; run++)
            draw_run(&feed, slice, &runs[run]);
        sheets_cover_slice(sheets, slice);
        held = (held + 1) % most;
        if (held == 0)
            sheets_end(sheets);
    }
    return GP_OK;
}

/* --- a frame ---------------------------------------------------------------------------------- */

/* What the shaders have no program for. */
static GpResult check(const VolumeSplatSetting *setting, GpError *error)
{
    const bool vertices = setting->mode == VOXELS_VB || setting->mode == VOXELS_IM;
    const bool image = setting->sheets == SHEETS_IMAGE;
    if ((setting->after || image) && setting->mode != VOXELS_VB)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%s: voxels are sorted anew for each picture: expected mode vb",
                       setting->after ? "classification after splatting" : "image-aligned sheets");
    if (setting->after && (image || setting->alphas))
        return gp_fail(
            error, GP_ERROR_UNSUPPORTED,
            "classification after splatting: expected sheets along the volume's axes, of "
            "extinctions");
    if (setting->flat && (setting->after || image || !vertices))
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "flat kernels: expected modes vb or im, sheets along the volume's axes, and "
                       "classification before splatting");
    return GP_OK;
}

GpResult volume_splats_add(const VolumeSplats *prepared, const VolumeView *view,
                           const VolumeSplatSetting *setting, const VolumeTarget *target,
                           Frame *frame, GpError *error)
{
    const GpResult possible = check(setting, error);
    if (possible)
        return possible;
    Sheets sheets = sheets_make(prepared, view, setting, target, frame);
    const GpResult result = setting->after                    ? splat_after_add(&sheets, error)
                            : setting->sheets == SHEETS_IMAGE ? splat_slabs_add(&sheets, error)
                                                              : add_slices(&sheets, error);
    sheets_finish(&sheets);
    return result ? result : frame_result(frame, error);
}
