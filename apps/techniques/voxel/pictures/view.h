/* Pictures of volumes of bits: flat textures drawn by slices. */
#ifndef APPS_TECHNIQUES_VOXEL_PICTURES_VIEW_H
#define APPS_TECHNIQUES_VOXEL_PICTURES_VIEW_H

#include "apps/base/camera.h"
#include "apps/base/voxel_box.h"
#include "apps/base/voxel_range.h"
#include "apps/techniques/voxel/volume/flat_texture.h"

typedef enum VoxelViewMode { VOXEL_OPAQUE, VOXEL_TRANSPARENT } VoxelViewMode;
typedef enum VoxelShading { VOXEL_SMOOTH, VOXEL_FACES_OF_CUBES } VoxelShading;

typedef struct VoxelPaint {
    float color[3];
    float opacity; /* transparent: share of light that is lost on a way of one voxel */
} VoxelPaint;

typedef struct VoxelView {
    Camera camera; /* in voxels */
    VoxelViewMode mode;
    VoxelShading shading;
    VoxelRange range;          /* where voxels may be, which is faster; empty: anywhere */
    VoxelPaint paint;          /* of the volume */
    const FlatTexture *second; /* NULL: none; else of the same layout */
    VoxelPaint second_paint;   /* of the second alone */
    VoxelPaint hit_paint;      /* of voxels that both have */
    const FlatTexture *scan;   /* NULL: none; else what voxel_scan_slopes made, of the same size */
    const uint8_t *transfer;   /* of a scan: [256][4] red, green, blue, opacity of a voxel */
    float light[3];            /* towards it: right, up, towards the eye; any length but 0 */
    float background[3];
} VoxelView;

extern const VoxelView voxel_view_defaults;

/* Appends the passes of a picture. Opaque voxels are lit as Phong did; each pixel shows the first
 * voxel on its ray. Transparent ones are laid over each other, the farthest first, and fade light
 * by the way in them. A scan fades it too, by samples linear between voxels; opaque voxels stand in
 * it, and transparent ones are mixed with it. The eye may be inside the volume; of the slab that it
 * is in, nothing is drawn.
 * in     flat: 1 bit a voxel; borrowed, as are the view's, until the list has run
 * out    frame->color: A8R8G8B8
 * errors GP_ERROR_INVALID: more bits, a view too wide for slices across one axis, volumes of
 *        different sizes, a scan with two transparent volumes in it */
GpResult voxel_view_build(const FlatTexture *flat, const VoxelView *view, uint32_t width,
                          uint32_t height, Frame *frame, GpError *error);

#endif
