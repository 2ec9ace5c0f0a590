/* A surface as bits of a volume: target t of a draw holds the 32 voxels of slab first_slab + t
 * along the view, one bit each. */
#ifndef SHADERS_SLAB_BITS_H
#define SHADERS_SLAB_BITS_H

#include "pipeline/shader/program.h"

typedef struct SlabBitsUniforms {
    float mvp[4][4]; /* model to clip; parallel rays */
    float first_slab;
} SlabBitsUniforms;

extern const GpProgram slab_bits_program;

#endif
