/* Light on the voxels that slices have found (view.h). */
#ifndef SHADERS_VOXEL_PICTURES_LIGHT_H
#define SHADERS_VOXEL_PICTURES_LIGHT_H

#include "shaders_c/voxel/pictures/view.h"

typedef struct VoxelLightUniforms {
    FlatTextureLayout flat;
    float slabs;              /* of the flat texture */
    float across[4], down[4]; /* to the next texel, in texture coordinates: u, v, u, v */
    float eye[3], at[3];      /* of the ray in the picture's centre: origin, direction */
    float right[3], up[3];    /* from there to the picture's edges */
    float perspective;        /* 1: they turn rays; 0: they move them */
    float kind;               /* of the voxels that are lit */
    float color[3];
    float light[3]; /* towards it, unit length */
} VoxelLightUniforms;

/* One triangle around the target, in clip space; slot 0: what voxel_first drew, in place. */
extern const GpProgram voxel_light_faces_program; /* faces of cubes */
/* Normals by the slope of a smoothed volume: slot 1: the flat texture, 2: the table of runs. */
extern const GpProgram voxel_light_smooth_program;

/* The table: column b, row f hold the smoothed density of six voxels in a row, of which bit k of b
 * says whether the k-th is there, at a place f / VOXEL_RUN_ROWS past the third one's centre: red
 * and green; and its slope: blue. */
enum { VOXEL_RUN = 6, VOXEL_RUN_PATTERNS = 64, VOXEL_RUN_ROWS = 64 };

#endif
