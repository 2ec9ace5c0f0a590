/* Volumes as flat 3D textures (the thesis's "worksheets"), which passes draw into and shaders read;
 * shaders_c/voxel/volume/flat_texture.h tells the layout. Every method of voxelization ends in one;
 * CSG, collision and pictures begin with one. */
#ifndef APPS_TECHNIQUES_VOXEL_VOLUME_FLAT_TEXTURE_H
#define APPS_TECHNIQUES_VOXEL_VOLUME_FLAT_TEXTURE_H

#include "apps/frame/frame.h"
#include "shaders_c/voxel/volume/flat_texture.h"

typedef struct FlatTexture {
    GpSurface *texels;       /* A8R8G8B8; belongs to the frame it was made for */
    uint32_t size;           /* voxels a side */
    uint32_t bits;           /* a voxel: 1, 8 or 16; slopes of a scan have 32 */
    uint32_t per_texel;      /* 32 / bits */
    uint32_t slabs, columns; /* patches in all, and in a row */
} FlatTexture;

/* Whether a volume fits a surface: size 8..1024, bits 1, 8 or 16, at most GP_MAX_SIZE texels a
 * side.
 * errors GP_ERROR_INVALID, with what does fit */
GpResult flat_texture_check(uint32_t size, uint32_t bits, GpError *error);

/* Makes an empty one that flat_texture_check lets pass. */
FlatTexture flat_texture_make(Frame *frame, uint32_t size, uint32_t bits);

/* The same with so many slabs, for those that hold some of a volume. */
FlatTexture flat_texture_make_slabs(Frame *frame, uint32_t size, uint32_t bits, uint32_t slabs);

/* The patch of a slab as a viewport, which keeps what is drawn inside it. */
GpViewport flat_texture_patch(const FlatTexture *flat, uint32_t slab);

/* The word of the column (x, y) of a slab. */
uint8_t *flat_texture_texel(const FlatTexture *flat, uint32_t slab, uint32_t x, uint32_t y);

/* A triangle that covers the viewport: shaders_c/common/cover_shared.h. One, so that no tile is cut
 * by a diagonal. */
extern const GpGeometry flat_texture_cover;

/* A draw over a slab's patch; the uniforms are copied. */
GpDraw *flat_texture_draw(Frame *frame, const GpProgram *program, const void *uniforms,
                          const FlatTexture *flat, uint32_t slab);

/* The same with FlatTextureSlab for uniforms. */
GpDraw *flat_texture_draw_slab(Frame *frame, const GpProgram *program, const FlatTexture *flat,
                               uint32_t slab);

/* A draw over all of a flat texture, from texels of its size, by a program of texel_copy.h. */
GpDraw *flat_texture_blend(Frame *frame, const GpProgram *program, const GpSurface *from,
                           GpBlendOp op);

/* What shaders need to know of it. */
FlatTextureLayout flat_texture_layout(const FlatTexture *flat);

/* Appends a pass that draws into it, cleared to 0. The caller adds the draws. */
GpPass *flat_texture_pass(Frame *frame, const char *name, const FlatTexture *flat);

/* Bytes of the volume as voxels in order, x fastest, then y, then z: 1 bit each from the low end of
 * bytes (.bits), or 1 or 2 bytes. */
size_t flat_texture_bytes(const FlatTexture *flat);

/* Copies the voxels out.
 * out  voxels: [flat_texture_bytes(flat)] */
void flat_texture_read(const FlatTexture *flat, uint8_t *voxels);

/* Voxels that are not 0. */
uint64_t flat_texture_count(const FlatTexture *flat);

#endif
