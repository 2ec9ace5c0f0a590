/* Voxels as EWA splats, added up in sheets.
 *
 * A voxel has a Gaussian kernel of variance S along the volume's axes. At eye position (x, y, z) it
 * is on the picture a Gaussian of variance V = J W S W^T J^T + h I, in square pixels, without J's
 * third row: the kernel's own (reconstruction), made wider by the pixel's filter (low-pass). A ray
 * through a pixel at distance d from the centre meets
 *     strength (f/z)^2 sqrt(1 + (x^2 + y^2)/z^2) / (2 pi sqrt(det V)) exp(-1/2 d^T V^-1 d)
 * of it. Footprints end where the exponent says `cut` standard deviations.
 * source Zwicker, Pfister, van Baar and Gross, "EWA volume splatting", Visualization 2001; Chen et
 *        al., "A uniform hardware-accelerated adaptive EWA splatting algorithm", 2009 (paper 003),
 *        3.1, 3.2
 */
#ifndef SHADERS_VOLUME_SPLAT_H
#define SHADERS_VOLUME_SPLAT_H

#include "pipeline/shader/program.h"

typedef struct VoxelUniforms {
    float eye[3][4];      /* samples to eye: x right, y down, z forward */
    float spread[6];      /* W S W^T: xx, xy, yy, xz, yz, zz */
    float focal;          /* pixels that a unit takes where w is 1 */
    float perspective[2]; /* w = z * perspective[0] + perspective[1] */
    float centre[2];      /* of the viewport, pixels from its top left */
    float ndc[2];         /* 2 / width, 2 / height of the viewport */
    float depth[2];       /* clip z = z * depth[0] + depth[1] */
    float nearest;        /* nearer voxels are left out, and those that the view does not meet: */
    /* where |x| > w * side[0] + reach[0], or y alike: far beside the view J stretches kernels over
     * all of it */
    float side[2];
    float reach[2];
    float low_pass; /* h, square pixels */
    float cut;      /* standard deviations */
    float farthest; /* exponent, base 2, at which footprints end */
    /* (f/w)^2 and what follows times this: volume of a cell / 2 pi, and what the cut takes away
     * given back */
    float strength;
    float normal[3][4];     /* gradients to eye */
    float light[3];         /* towards it, in eye space */
    float ambient, diffuse; /* 1, 0: unlit */
} VoxelUniforms;

/* Points of voxels in 8 bytes: TEXCOORD0 value and gradient, TEXCOORD1 place
 * (apps/volumes/voxels.h). Texture 0: what the 256 values look like, colour and strength. Target:
 * colour times strength, and strength; to be added. One a filter: the three vertex shaders of paper
 * 003's table 1. */
extern const GpProgram voxel_ewa_program, voxel_reconstruction_program, voxel_low_pass_program;

#endif
