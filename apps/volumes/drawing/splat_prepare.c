#include "apps/volumes/drawing/splat.h"

static void forget_runs(VolumeSplats *splats)
{
    for (int axis = 0; axis < 3; axis++) {
        gp_free(splats->runs[axis]);
        gp_free(splats->run_of[axis]);
        splats->runs[axis] = NULL;
        splats->run_of[axis] = NULL;
    }
}

GpResult volume_splats_classify(VolumeSplats *splats, const Transfer *transfer, GpError *error)
{
    VolumeSplats made = { .field = splats->field, .voxels = splats->voxels };
    const int background = splats->voxels.background;
    GpResult result = GP_OK;
    voxels_shown(transfer, made.shown);
    transfer_table(transfer, made.table);
    const bool anew = !splats->voxels.along[0].first || (background >= 0 && made.shown[background]);
    if (anew)
        result = voxels_make(splats->field, made.shown, &made.voxels, error);
    for (int axis = 0; axis < 3 && !result; axis++)
        result = voxels_gather(&made.voxels.along[axis], made.shown, &made.runs[axis],
                               &made.run_of[axis], error);
    if (result) {
        forget_runs(&made);
        if (anew)
            voxels_free(&made.voxels);
        return result;
    }
    forget_runs(splats);
    if (anew)
        voxels_free(&splats->voxels);
    *splats = made;
    return GP_OK;
}

GpResult volume_splats_make(const Field *field, const Transfer *transfer, VolumeSplats *splats,
                            GpError *error)
{
    VolumeSplats made = { .field = field };
    GpResult result = volume_splats_classify(&made, transfer, error);
    if (!result)
        *splats = made;
    return result;
}

void volume_splats_free(VolumeSplats *splats)
{
    forget_runs(splats);
    voxels_free(&splats->voxels);
    *splats = (VolumeSplats){ 0 };
}

uint64_t volume_splats_count(const VolumeSplats *splats)
{
    const uint32_t runs = splats->run_of[0] ? splats->run_of[0][splats->voxels.along[0].slices] : 0;
    uint64_t count = 0;
    for (uint32_t i = 0; i < runs; i++)
        count += splats->runs[0][i].count;
    return count;
}
