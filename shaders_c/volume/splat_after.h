/* Voxels that are splatted as they are, and classified and lit in the sheet.
 *
 * A sheet holds the sums of weighted densities and normals of a slice, and of weights. Between two
 * of them a ray goes from one density to the other in a straight line: a table has, for both, the
 * mean extinction and the light that is sent out. Normals look at the eye, so that two components
 * tell the third.
 * source Mueller, Moeller and Crawfis, "Splatting without the blur", Visualization 1999; the table:
 *        Engel, Kraus and Ertl, "High-quality pre-integrated volume rendering using
 *        hardware-accelerated pixel shading", Graphics Hardware 2001
 */
#ifndef SHADERS_VOLUME_SPLAT_AFTER_H
#define SHADERS_VOLUME_SPLAT_AFTER_H

#include "shaders_c/volume/splat.h"

/* Inputs of voxel_ewa_program, no textures. Target, to be added: value / 256, normal x, normal y
 * and 1, each times the weight. */
extern const GpProgram voxel_after_ewa_program, voxel_after_reconstruction_program,
    voxel_after_low_pass_program;

typedef struct AfterUniforms {
    float per_focal; /* slope of a ray a pixel beside the centre; 0: rays are parallel */
    float centre[2];
    float axis[3]; /* of the slices, in eye space: x right, y down, z forward */
    float between; /* distance of slices */
    float light[3];
    float ambient, diffuse;
} AfterUniforms;

/* Textures 0 and 1: a pixel's own place in a sheet and in the one behind it; 2: by the two
 * densities, colour times extinction, and extinction, filtered. To be blended under what is
 * there. */
extern const GpProgram sheets_after_program;

#endif
