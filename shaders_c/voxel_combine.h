/* Two worksheets made one: the pixel shader brings the second, the blend unit puts it together with
 * the first. */
#ifndef SHADERS_VOXEL_COMBINE_H
#define SHADERS_VOXEL_COMBINE_H

#include "pipeline/program.h"

/* To be drawn as one triangle around the whole target, in clip space. Slot 0 is a surface of the
 * target's size, read in place. */
extern const GpProgram voxel_copy_program;       /* its texels */
extern const GpProgram voxel_complement_program; /* their bytes' complements: all bits inverted */

#endif
