/* Volumes by rays: each pixel walks through the volume from the eye on, and adds what it meets.
 *
 * A ray is cut into steps of one length, from where it enters the volume; each is as its middle is:
 * linear between eight samples, then classified. The last one is as short as what is left. Bricks
 * of samples that show nothing are passed over; the ray ends at opaque things, and where next to
 * nothing is seen through what it has met.
 * source Levoy, "Efficient ray tracing of volume data", ACM TOG 9(3), 1990; as a shader: Krüger
 *        and Westermann, "Acceleration techniques for GPU-based volume rendering", Visualization
 *        2003;
 *        empty bricks with distances: Cohen and Sheffer, "Proximity clouds", Visual Computer 11,
 *        1994 */
#ifndef SHADERS_VOLUME_RAYCAST_H
#define SHADERS_VOLUME_RAYCAST_H

#include "pipeline/shader/program.h"
#include "shaders_c/volume/atlas.h"

enum { VOLUME_BRICK = 4 }; /* steps between samples that a brick is long */

typedef struct RaycastUniforms {
    VolumePatches atlas; /* slot 0, linear */
    /* slot 1, points: n / 255 of each brick: the cube of n bricks that begins with it on the ray's
     * way is to be walked through, up to 127; or of n - 127, which show nothing, to be passed
     * over */
    VolumePatches bricks;
    float way; /* places on slot 1 from ways to the next: bit i, the ray falls along axis i */
    /* slot 2, points: place of a value v is v * table[0] + table[1]; colour times alpha, and alpha,
     * of one step */
    float table[2];
    float last[3];  /* of the samples along x, y, z: N - 1 */
    float scale[3]; /* from samples to space */
    float per_step; /* 1 / length of a step in space */
    float least;    /* share of light that is nothing */
    /* slot 3, points: an opaque thing of depth z ends the ray at the share (depth[0] + depth[1] z)
     * / (depth[2] + depth[3] z) of its way */
    float depth[4];
    float texel[2]; /* 1 / width, 1 / height of slot 3 */
    float light[3]; /* towards it, in space, unit length: of the lit program */
    float ambient, diffuse;
} RaycastUniforms;

/* GP_POSITION is a place in clip space (x, y); GP_TEXCOORD0 and GP_TEXCOORD1 are where its ray
 * begins,
 * in samples, and the way that it goes: both are linear on the screen, whatever the camera. Gives
 * colour times alpha, and alpha. */
extern const GpProgram raycast_program;

/* The same with each step lit by its slope, from both sides. */
extern const GpProgram raycast_lit_program;

#endif
