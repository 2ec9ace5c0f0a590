/* Pictures of volumes of bits by slices (slices.h): in a slab a ray meets at most three voxels. */
#ifndef SHADERS_VOXEL_PICTURES_VIEW_H
#define SHADERS_VOXEL_PICTURES_VIEW_H

#include "pipeline/shader/program.h"
#include "shaders_c/common/slices.h"
#include "shaders_c/voxel/volume/flat_texture.h"

/* A voxel's kind: which volumes have it. */
enum { VOXEL_KIND_FIRST = 1, VOXEL_KIND_SECOND, VOXEL_KIND_BOTH, VOXEL_KINDS };

typedef struct VoxelViewUniforms {
    FlatTextureLayout flat;
    float block_columns, blocks_width, blocks_height; /* of voxel_blocks */
    SliceUniforms slices;
    /* of the kinds from VOXEL_KIND_FIRST on, and how much of what is behind one voxel is lost:
     * voxel_haze only */
    float colors[3][4];
} VoxelViewUniforms;

/* Triangles of quads at a slab's near side: GP_POSITION is (u, v, w), GP_TEXCOORD0 the layer. Slots
 * 0 and, of the programs of two, 1 are flat textures, slot 3 is the blocks of their voxels; all are
 * read by points. */
extern const GpProgram voxel_first_program; /* the voxel met first: (x, y, z, kind); else nothing */
extern const GpProgram voxel_first_two_program;
extern const GpProgram voxel_haze_program; /* what the slab adds: colour times alpha, and alpha */
extern const GpProgram voxel_haze_two_program;

#endif
