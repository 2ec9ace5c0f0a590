/* Pictures of voxelized models: of one or of what two make, alone or inside a scanned volume. */
#ifndef APPS_TECHNIQUES_VOXEL_PICTURES_PICTURE_H
#define APPS_TECHNIQUES_VOXEL_PICTURES_PICTURE_H

#include "apps/base/orbit.h"
#include "apps/techniques/voxel/inputs/pair.h"
#include "apps/techniques/voxel/pictures/view.h"
#include "pipeline/io/volume/volume.h"

typedef struct VoxelPicture {
    uint32_t width, height;
    VoxelViewMode look;
    VoxelShading shading;
    Orbit orbit;
    bool shows_both; /* both models, and where they touch; else their result */
    bool is_solid;
} VoxelPicture;

/* Appends the passes of a picture behind those that make its volumes.
 * in     made: of one bit a voxel
 *        scan: NULL: none; else of any type, whose longest side fills the volume and whose values
 *        from the least to the greatest are seen from not at all to as bone
 * out    frame->color: A8R8G8B8
 * errors those of voxel_view_build; GP_ERROR_INVALID: a scan in a volume that is too large, or more
 *        than one bit a voxel; GP_ERROR_MEMORY */
GpResult voxel_picture_build(const VoxelPicture *picture, const VoxelPairMade *made,
                             const GpVolume *scan, Frame *frame, GpError *error);

#endif
