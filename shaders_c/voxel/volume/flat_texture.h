/* A volume as a flat 3D texture, which the thesis calls a worksheet.
 *
 * A volume of size^3 voxels is cut into slabs of per_texel voxels along z. A slab is a patch of
 * size x size texels; patches lie in rows of `columns`, slab 0 at the top left. Texel (x, y) of a
 * slab holds the voxels (x, y, slab * per_texel + k): with one bit a voxel, k is bit k of the
 * texel's 32-bit word, blue first (A8R8G8B8 in memory, little-endian); with 8 or 16 bits, k counts
 * bytes or pairs of them in that order.
 * source Dong, Chen, Bao, Zhang and Peng, "Real-time voxelization for complex polygonal models",
 *        Pacific Graphics 2004 */
#ifndef SHADERS_VOXEL_VOLUME_FLAT_TEXTURE_H
#define SHADERS_VOXEL_VOLUME_FLAT_TEXTURE_H

/* As shaders see it: numbers that are whole. */
typedef struct FlatTextureLayout {
    float size;          /* voxels a side of the volume, texels a side of a patch */
    float per_texel;     /* voxels: 32, 4 or 2 */
    float columns;       /* patches in a row */
    float width, height; /* texels of the whole flat texture */
} FlatTextureLayout;

/* One slab of it, for programs that cover a patch. */
typedef struct FlatTextureSlab {
    float size; /* voxels a side of the volume */
    float base; /* the slab's first voxel along z */
} FlatTextureSlab;

#endif
