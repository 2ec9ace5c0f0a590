/* What may be chosen of a voxelization. */
#ifndef APPS_TECHNIQUES_VOXEL_METHODS_SETTING_H
#define APPS_TECHNIQUES_VOXEL_METHODS_SETTING_H

#include <stdint.h>

typedef enum VoxelKind { VOXEL_SURFACE, VOXEL_SOLID } VoxelKind;

typedef enum VoxelMethod {
    VOXEL_AUTO,         /* conservative for surfaces, xor for solids */
    VOXEL_CONSERVATIVE, /* surface: every voxel that a triangle touches */
    VOXEL_THIN,         /* surface: voxels met by lines through centres, along three axes */
    VOXEL_XOR,          /* solid: each fragment turns over what is below it */
    VOXEL_WINDING,      /* solid: each adds to what is below it, or subtracts, as it faces */
    VOXEL_SHEETS, /* as printed: three directional flat textures, synthesized; solid: row scans */
    VOXEL_SLICES, /* baseline: one pass a slice, between clip planes (Fang and Chen 2000) */
    VOXEL_LDI,    /* baseline: layered depth images by peeling (Heidelberger et al. 2003) */
    VOXEL_FACES,  /* baseline: depth buffers of the box's six faces (Karabassi et al. 1999) */
} VoxelMethod;

typedef enum VoxelBlend { VOXEL_ADD, VOXEL_OR } VoxelBlend;

/* What winding numbers are counted in, while they are: half floats, exact up to 2048 triangles that
 * face one way, above a voxel and in its group of 16; or bytes, up to 127. Beyond that a count
 * stays, and what is then subtracted makes it wrong. */
typedef enum VoxelCounters { VOXEL_HALF, VOXEL_BYTE } VoxelCounters;

/* What a voxel of 8 or 16 bits holds. */
typedef enum VoxelValue { VOXEL_DENSITY, VOXEL_NORMAL, VOXEL_COLOR } VoxelValue;

typedef struct VoxelSetting {
    VoxelKind kind;
    VoxelMethod method;
    uint32_t size;          /* voxels a side */
    uint32_t bits;          /* a voxel: 1, 8, 16 */
    VoxelBlend blend;       /* of the printed method */
    uint32_t axes;          /* of the printed method: 3, or 1: along z only */
    VoxelValue value;       /* of 8 and 16 bits */
    VoxelCounters counters; /* of winding numbers */
} VoxelSetting;

#endif
