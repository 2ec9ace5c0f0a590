/* The voxels that triangles touch, or that lines through the centres of voxels meet, by columns:
 * each triangle looks at the columns of voxels under its box, and sets a run of bits in each. */
#ifndef SHADERS_VOXEL_METHODS_COLUMNS_H
#define SHADERS_VOXEL_METHODS_COLUMNS_H

#include "pipeline/shader/program.h"
#include "shaders_c/voxel/methods/motion.h"
#include "shaders_c/voxel/volume/flat_texture.h"

typedef struct VoxelColumnsUniforms {
    FlatTextureLayout flat;
    VoxelMotion motion;
    float step; /* a triangle is drawn into the slab so many above its lowest */
} VoxelColumnsUniforms;

/* Columns are wider by this to each side, in voxels, than they are: more than positions are rounded
 * by in 1024 voxels, so that what lies between two voxels is in both. */
#define VOXEL_MARGIN        (1.0f / 4096)
#define VOXEL_TOUCHED_REACH (0.5f + VOXEL_MARGIN)

/* Voxels that share a point with the triangle; and those that a line through their centre along x,
 * y or z meets it in. To be drawn as points, one a triangle, whose streams GP_TEXCOORD0 to 2 are
 * its corners; blended with GP_BLEND_LOGIC_OR. */
extern const GpProgram voxel_touched_program, voxel_sampled_program;

/* The first for triangles whose box is within one column: no edge or plane matters. */
extern const GpProgram voxel_touched_column_program;

/* The two for triangles over many columns, of which a square would be a waste: drawn as two
 * triangles 0 1 2 and 0 2 3 of four vertices, with the same streams, and in GP_TEXCOORD3 its number
 * 0 to 3. */
extern const GpProgram voxel_touched_rectangle_program, voxel_sampled_rectangle_program;

#endif
