/* A volume before the eye: what all voxels of a frame share, and where they come to lie. */
#ifndef APPS_VOLUMES_DRAWING_SPLAT_EYE_H
#define APPS_VOLUMES_DRAWING_SPLAT_EYE_H

#include "apps/volumes/drawing/splat_setting.h"
#include "apps/volumes/drawing/view.h"
#include "shaders_c/volume/splat.h"

typedef struct VoxelEye {
    double axis[3][3]; /* right, down, forward, in space */
    double row[3][4];  /* samples to eye */
    double focal;      /* pixels that a unit takes at distance 1, or anywhere */
    bool parallel;
    double position[3];             /* of the eye in space */
    double half_width, half_height; /* tangents of half the field of view */
    double centre[2];               /* pixels */
    double near;
    double least; /* standard deviation of kernels along the axis of the closest samples */
    double reach,
        low_pass;   /* where kernels and the pixel's filter are cut: units of space, pixels */
    uint32_t along; /* the volume's axis that is nearest to the view, */
    bool falling;   /* and whether its far end is in front */
} VoxelEye;

VoxelEye voxel_eye(const Field *field, const VolumeView *view, const VolumeSplatSetting *setting);

VoxelUniforms voxel_uniforms(const VoxelEye *eye, const Field *field, const VolumeView *view,
                             const VolumeSplatSetting *setting);

/* Where a place in samples is before the eye. */
void voxel_eye_place(const VoxelEye *eye, const double place[3], double at[3]);

/* Where a place in samples is on the picture, and how far a footprint round it may reach.
 * out  pixel: x, y, from the top left corner
 * returns the reach in pixels; below 0: it lies before the near plane */
double voxel_eye_pixel(const VoxelEye *eye, const double place[3], double pixel[2]);

/* The same of a place before the eye, not before the near plane. */
double voxel_eye_project(const VoxelEye *eye, const double at[3], double pixel[2]);

#endif
