/* Surfels as screen-space EWA splats: a visibility pass, and passes that add weighted attributes.
 *
 * A surfel projects to a Gaussian of variance V = J r^2 J^T + h I, in square pixels: the disc's own
 * (reconstruction), made wider by the pixel's filter (low-pass). Its weight at a pixel is
 *     share r^2 |det J| / sqrt(det V) * exp(-1/2 d^T V^-1 d)
 * so that the weights of a surface that covers a pixel add up to 1, and at its border to the share
 * of the pixel that it covers.
 * source Zwicker, Pfister, van Baar and Gross, "Surface splatting", SIGGRAPH 2001, eq. 10 and
 *        "EWA splatting", IEEE TVCG 8(3), 2002; the passes: paper 004.
 * DEVIATES: J r^2 J^T comes without tangents: with P = f/z (I | -(x, y)/z) it is r^2 P (I - n n^T)
 * P^T.
 */
#ifndef SHADERS_POINTS_SPLAT_H
#define SHADERS_POINTS_SPLAT_H

#include "pipeline/shader/program.h"

typedef struct SplatUniforms {
    float eye[3][4]; /* world to eye: x right, y down, z forward; rows of a rigid motion */
    float focal;     /* pixels that a unit at distance 1 takes */
    float centre[2]; /* of the viewport, pixels from its top left */
    float ndc[2];    /* 2 / width, 2 / height of the viewport */
    float depth[2];  /* depth of a distance z: depth[0] + depth[1] / z */
    float nearest;   /* nearer points are left out, > 0 */
    /* surfels whose normal looks at the eye by less than this cosine, about, are left out; below
     * -1: none is */
    float facing;
    float low_pass; /* h, square pixels */
    /* standard deviation of a surfel's Gaussian, in its radii; 0: the pixel's filter alone */
    float spread;
    float cut; /* splats end at so many standard deviations */
    /* visibility lies so many footprints behind the surface: a footprint is the surfel's radius and
     * the pixel filter's at its distance */
    float epsilon;
    /* above 0: the colour is 0.5 + 0.5 sin(waves * position), channel by channel, instead of the
     * surfel's */
    float waves;
} SplatUniforms;

/* Where the share of a surfel is below 1 over this, its area says how wide its Gaussian is: discs
 * that just close a lattice of squares have a share of 0.56, of triangles 0.64. */
#define SPLAT_PER_SHARE 1.9f

/* Points of a depth-only pass: discs of the surfels' own radii, behind the surface by epsilon. Not
 * wider, so that what a surface hides ends where the surface does. */
extern const GpProgram splat_visibility_program;

/* Points that are added up: target 0 gets colour x weight and the weight. */
extern const GpProgram splat_color_program;

/* The same, and in target 1 normal (world) x weight and distance x weight, for shading and
 * depth. */
extern const GpProgram splat_surface_program;

#endif
