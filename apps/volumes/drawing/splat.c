#include "apps/volumes/drawing/splat.h"

#include "apps/volumes/drawing/splat_filter.h"
#include "apps/volumes/drawing/splat_sheets.h"

/* --- slices ----------------------------------------------------------------------------------- */

static GpGeometry run_geometry(const VoxelOrder *order, const VoxelRun *run)
{
    const Voxel *first = order->voxels + run->first;
    return (GpGeometry){
        .primitive = GP_POINTS,
        .vertex_count = run->count,
        .streams = { [GP_TEXCOORD0] = { &first->value, sizeof *first, 4, GP_UINT8 },
                     [GP_TEXCOORD1] = { first->place, sizeof *first, 4, GP_UINT8 } },
    };
}

static void draw_run(const Sheets *sheets, uint32_t slice, const VoxelRun *run)
{
    static const GpProgram *const programs[] = {
        [VOXEL_EWA] = &voxel_ewa_program,
        [VOXEL_RECONSTRUCTION] = &voxel_reconstruction_program,
        [VOXEL_LOW_PASS] = &voxel_low_pass_program,
    };
    const GpGeometry geometry = run_geometry(sheets->order, run);
    const VoxelFilter filter = splat_filter_of_patch(
        &sheets->eye, sheets->order, sheets->splats->field, sheets->setting, slice, run->patch);
    GpDraw *draw = frame_draw(sheets->frame, programs[filter], sheets->uniforms, &geometry);
    draw->textures[0].surface = sheets->look;
    sheets_set_state(sheets, draw);
}

/* Sheets of `thickness` slices that have something. */
static void add_slices(Sheets *sheets)
{
    const uint32_t *run_of = sheets->splats->run_of[sheets->eye.along];
    const VoxelRun *runs = sheets->splats->runs[sheets->eye.along];
    const double thickness = sheets->setting->thickness;
    const uint32_t most = thickness >= 1 ? (uint32_t)thickness : 2;
    uint32_t held = 0;
    for (uint32_t i = 0; i < sheets->order->slices; i++) {
        const uint32_t slice = sheets_slice(sheets, i);
        if (run_of[slice] == run_of[slice + 1])
            continue;
        if (held == 0)
            sheets_begin(sheets);
        for (uint32_t run = run_of[slice]; run < run_of[slice + 1]; run++)
            draw_run(sheets, slice, &runs[run]);
        sheets_cover_slice(sheets, slice);
        held = (held + 1) % most;
        if (held == 0)
            sheets_end(sheets);
    }
}

/* --- a frame ---------------------------------------------------------------------------------- */

GpResult volume_splats_add(const VolumeSplats *prepared, const VolumeView *view,
                           const VolumeSplatSetting *setting, const VolumeTarget *target,
                           Frame *frame, GpError *error)
{
    Sheets sheets = sheets_make(prepared, view, setting, target, frame);
    add_slices(&sheets);
    sheets_finish(&sheets);
    return frame_result(frame, error);
}
