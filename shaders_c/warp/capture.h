/* What planar depth images are made of: surfaces with their colour, normal and depth, in two float
 * targets: 0 colour, and in alpha the depth along the image's forward; 1 normal, world, unit
 * length. */
#ifndef SHADERS_WARP_CAPTURE_H
#define SHADERS_WARP_CAPTURE_H

#include "pipeline/shader/program.h"

typedef struct CaptureUniforms {
    float eye[2][3];         /* the image's eye, and what rounding took from it */
    float axes[4][4];        /* of which 3x3: right, up, forward */
    float eye_to_clip[4][4]; /* of (right, up, forward, 1) */
    float waves; /* of the programs that have them: colours 0.5 + 0.5 sin(waves * position) */
} CaptureUniforms;

/* The surface in front, and what is behind the depths in slot 0's alpha (read by gp_load_local). */
extern const GpProgram capture_program;
extern const GpProgram capture_behind_program;

/* The same without colours of the vertices. */
extern const GpProgram capture_waves_program;
extern const GpProgram capture_waves_behind_program;

#endif
