/* Slices across a range of voxels, for a camera: their axis, how many, and their quads. */
#ifndef APPS_FRAME_VIEW_SLICES_H
#define APPS_FRAME_VIEW_SLICES_H

#include "apps/base/camera.h"
#include "apps/base/voxel_range.h"
#include "apps/frame/frame.h"
#include "shaders_c/common/slices.h"

/* Slices in their order from the eye. */
typedef struct ViewSlices {
    VoxelRange range; /* where voxels may be; not empty */
    uint32_t parts;   /* slabs that a layer of voxels is cut into */
    int axes[3];      /* that are u, v, and w, which goes across the slices */
    double toward;    /* 1: from the eye w grows; -1 */
    const Camera *camera;
} ViewSlices;

/* The axis nearest to the view's; parts so many that in a slab no ray of the picture that meets the
 * range moves by more than one voxel along u or v.
 * errors GP_ERROR_INVALID: some ray goes along the slices, or nearly */
GpResult view_slices_find(const VoxelRange *range, const Camera *camera, double aspect,
                          ViewSlices *slices, GpError *error);

/* How many slices there are. */
uint32_t view_slices_count(const ViewSlices *slices);

/* Quads at the near sides of slabs, wider by a voxel than the range, since rays that enter it
 * through other sides pass there; nearest first, or last. Those behind the eye are left out. */
GpGeometry view_slices_quads(Frame *frame, const ViewSlices *slices, bool nearest_first);

SliceUniforms view_slices_uniforms(const ViewSlices *slices, double aspect);

#endif
