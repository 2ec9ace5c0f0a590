/* Flat textures of lines along x or y into the places of volumes: slabs along z. */
#ifndef SHADERS_VOXEL_METHODS_TURN_H
#define SHADERS_VOXEL_METHODS_TURN_H

#include "pipeline/shader/program.h"
#include "shaders_c/voxel/volume/flat_texture.h"

/* A flat texture along an axis holds at texel (u, v) of a slab the voxels of depth w: u, v, w are
 * y, z, x for x and z, x, y for y, so that z is v for the one and u for the other. */
typedef struct VoxelTurnUniforms {
    FlatTextureLayout flat;    /* of both */
    float depth[2], across[2]; /* of x and y, the one that is depth, and the one that is not */
    float aside[2];            /* (u, v) for that which is not */
    float down[2];             /* and for z */
    float octets, slabs;       /* of the flat texture of what is found */
} VoxelTurnUniforms;

/* To be drawn over the whole of a flat texture. Slot 0: the other one. Slot 1: by depth w, of size
 * x 1, the patch's origin in texels; the row of slot 2 (bits) or the voxel's place in its texel;
 * its byte. Slot 2 (bits): 256 x 8, at (s, t) bit t of s. Slot 3 (bits): the flat texture of what
 * is found. */
extern const GpProgram voxel_turn_bits_program;  /* 1 bit a voxel */
extern const GpProgram voxel_turn_bytes_program; /* 8 bits */
extern const GpProgram voxel_turn_pairs_program; /* 16 bits */

/* To be drawn over the flat texture of what is found, with the same slots, before bits are turned:
 * for every slab `octets` texels in a row, of eight depths each, and a row for each place that is
 * not depth. Its four channels are 0 where eight voxels along z, times those eight depths, are
 * empty. */
extern const GpProgram voxel_found_program;

#endif
