/* How volumes may be splatted.
 *
 * Each voxel that can be seen has a kernel, exp(-r^2 / (2 deviation^2)) of the distance r in
 * samples along the volume's own axes, cut where r is KERNEL_CUT deviations, and as high as makes
 * its integral 1
 * in units of a sample's cell: a volume of one value sums to this value, within a ripple of 6
 * exp(-2 pi^2 deviation^2). A voxel of opacity a adds extinction -ln(1 - a) times its kernel, in
 * its colour. The picture is then filtered by a Gaussian of low_pass pixels.
 *
 * That is what is meant (apps/truth); drawn footprints end sooner, at `cut`.
 */
#ifndef APPS_VOLUMES_DRAWING_SPLAT_SETTING_H
#define APPS_VOLUMES_DRAWING_SPLAT_SETTING_H

#include "pipeline/base/base.h"

#define KERNEL_CUT 3.0

/* What a voxel's footprint is on the picture. */
typedef enum VoxelFilter {
    VOXEL_EWA,            /* kernel and pixel's filter */
    VOXEL_RECONSTRUCTION, /* the kernel alone */
    VOXEL_LOW_PASS,       /* the pixel's filter alone */
    VOXEL_ADAPTIVE,       /* as paper 003 prints it: by distances of the corners of patches */
    VOXEL_BOUNDED,        /* the cheapest whose error has a bound */
    VOXEL_FILTERS
} VoxelFilter;

/* What is added up before it is composited. */
typedef enum VoxelSheets {
    SHEETS_AXIS, /* slices of the volume, square to the axis nearest to the view */
    SHEETS_IMAGE /* slabs of equal depth, which cut kernels (Mueller and Crawfis 1998) */
} VoxelSheets;

/* Where voxels are kept, and how they come to the pipeline (paper 003, 4.1.2 and table 4). */
typedef enum VoxelMode {
    VOXELS_VB, /* all in vertex buffers, 8 bytes each */
    VOXELS_VT, /* places in vertex buffers, values in a texture that the vertex shader reads */
    VOXELS_PT, /* the same, read by the pixel shader */
    VOXELS_IM, /* as VB, a draw for each */
    VOXELS_QD, /* four vertices each */
    VOXEL_MODES
} VoxelMode;

/* What sums are kept in. */
typedef enum VoxelSums {
    VOXEL_HALVES,
    VOXEL_FLOATS,
    VOXEL_BYTES,
    VOXEL_BYTES_NEAR /* bytes where the volume is near, halves where single voxels would be lost */
} VoxelSums;

typedef struct VolumeSplatSetting {
    VoxelFilter filter;
    VoxelSheets sheets;
    VoxelMode mode;
    VoxelSums sums;
    bool after;  /* densities are splatted, and classified and lit in the sheet */
    bool alphas; /* opacities are added, as printed, not extinctions */
    bool flat; /* kernels of voxels that are opaque, by half at least, lie in their iso-surfaces */
    double deviation; /* of the kernel, samples along each axis */
    double cut;       /* footprints end at so many standard deviations */
    double low_pass;  /* standard deviation of the pixel's filter, pixels */
    double tolerance; /* of VOXEL_BOUNDED: share of what voxels add that may lie elsewhere */
    double thickness; /* of sheets: slices, or distances of close samples; 0: 2, of alphas 1 */
    uint32_t cull;    /* opaque pixels are marked every so many sheets; 0: never */
} VolumeSplatSetting;

static inline double splat_thickness(const VolumeSplatSetting *setting)
{
    return setting->thickness > 0 ? setting->thickness : setting->alphas ? 1 : 2;
}

#define VOLUME_SPLAT_DEFAULTS                                                                      \
    {                                                                                              \
        .deviation = 0.5, .cut = 2, .low_pass = 0.4, .tolerance = 0.05                             \
    }

#endif
