/* Volumes as splats: sheets of them, put one under the other. */
#ifndef APPS_VOLUMES_DRAWING_SPLAT_H
#define APPS_VOLUMES_DRAWING_SPLAT_H

#include "apps/volumes/drawing/splat_setting.h"
#include "apps/volumes/drawing/view.h"
#include "apps/volumes/voxels.h"

/* A field as it is splatted, and what a transfer function shows of it. A zeroed one is empty. */
typedef struct VolumeSplats {
    const Field *field; /* borrowed */
    Voxels voxels;

    /* of the transfer function */
    bool shown[FIELD_VALUES];
    float table[FIELD_VALUES][4];
    VoxelRun *runs[3];
    uint32_t *run_of[3];
} VolumeSplats;

/* Packs a field's voxels, and classifies them.
 * errors GP_ERROR_MEMORY
 * owns   the caller, until volume_splats_free; the field must stay */
GpResult volume_splats_make(const Field *field, const Transfer *transfer, VolumeSplats *splats,
                            GpError *error);

/* Another transfer function: gathers runs, and looks at no voxel unless it shows the value that
 * most samples have for the first time.
 * errors GP_ERROR_MEMORY, with all as it was */
GpResult volume_splats_classify(VolumeSplats *splats, const Transfer *transfer, GpError *error);

void volume_splats_free(VolumeSplats *splats);

/* Voxels that a transfer function shows. */
uint64_t volume_splats_count(const VolumeSplats *splats);

/* Bytes that each of these takes in a mode, in vertex buffers of all three directions and in
 * textures; of quads without the indices and corners, which all runs share, and of VOXELS_IM
 * without its draws.
 * source paper 003, table 4 */
double volume_splats_bytes(const VolumeSplats *splats, VoxelMode mode);

/* Appends the passes that draw a volume over its target.
 * in     prepared, and what it borrows: until the frame has run
 * errors GP_ERROR_UNSUPPORTED: what the mode, or the sheets, cannot do together */
GpResult volume_splats_add(const VolumeSplats *prepared, const VolumeView *view,
                           const VolumeSplatSetting *setting, const VolumeTarget *target,
                           Frame *frame, GpError *error);

#endif
