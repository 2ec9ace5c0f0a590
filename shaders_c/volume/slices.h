/* Volumes as planes along one of their axes: each is a picture between two slices of samples, and
 * stands for the slab about it.
 *
 * Values are mixed from the two slices and only then classified, by a table that is read with them.
 * What a pixel's ray finds in the slab follows from its way through it, which is longer the more
 * askew it is.
 * source Rezk-Salama, Engel, Bauer, Greiner and Ertl, "Interactive volume rendering on standard PC
 *        graphics hardware using multi-textures and multi-stage rasterization", Graphics Hardware
 *        2000 */
#ifndef SHADERS_VOLUME_SLICES_H
#define SHADERS_VOLUME_SLICES_H

#include "pipeline/shader/program.h"

/* The axes are u and v, along a slice, and w across. */
typedef struct VolumeSliceUniforms {
    float to_clip[4][4]; /* of (u, v, w) in samples */
    float w;             /* of the plane */
    float share;         /* of the second slice in it */
    float texel[2];      /* 1 / samples along u, v */
    float table[2];      /* place of a value v on the table is v * table[0] + table[1] */
    float scale[3];      /* samples to space, */
    float eye[3];    /* and from it a place's ray goes scale * place - eye; parallel: scale is 0 */
    float thickness; /* of the slab, in space */
    float per_scale[3]; /* of the lit program: 1 / distance of samples along u, v, w */
    float light[3];     /* towards it, unit length */
    float ambient, diffuse;
} VolumeSliceUniforms;

/* GP_POSITION is (u, v). Slots 0 and 1 are the slices before and behind the plane, linear; slot 2
 * is the table, by points: colour, and log2 of the light that a unit of space leaves. Gives colour
 * times alpha, and alpha. */
extern const GpProgram volume_slice_program;

/* The same lit by slopes, from both sides. */
extern const GpProgram volume_slice_lit_program;

#endif
