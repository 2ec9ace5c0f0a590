/* Volumes without a file. The same samples everywhere. */
#ifndef APPS_VOLUMES_BUILTIN_H
#define APPS_VOLUMES_BUILTIN_H

#include "apps/volumes/field.h"

/* Names, NULL at the end:
 *   marschner-lobb  the test signal with fM = 6 and alpha = 0.25 on [-1, 1]^3; N samples a side,
 *                   256 where it is not said
 *   checkerboard    N x N x 3 samples, 512 where it is not said, in squares of 16: values 85 and
 *                   170
 *   ball            255 inside, 0 outside, and straight between over an edge 4 samples wide in
 *                   whose middle the radius, 0.4 (N - 1), is; N samples a side, 128 where it is not
 *                   said
 * source Marschner and Lobb 1994, "An Evaluation of Reconstruction Filters for Volume Rendering",
 *        equation 3; the checkerboard of Chen et al. 2009, figure 8, whose squares are not
 *        stated */
extern const char *const builtin_field_names[];

/* in     name: NAME or NAME:N, N 1..1024
 * errors GP_ERROR_INVALID: no such name, or no such N; GP_ERROR_MEMORY
 * owns   the caller, until field_free */
GpResult builtin_field(const char *name, Field *field, GpError *error);

#endif
