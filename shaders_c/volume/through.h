/* Surfaces that let light through, as they are seen through a volume before them.
 *
 * A picture P that holds a volume already shows what lies behind any place d of it as P - F: F is
 * the light that the volume sends from before d, and T the share that it lets through. A surface at
 * d of colour g and opacity a leaves (1 - a) (P - F) + a T g + F of it, which is (1 - a) P + a (F +
 * T g): it is blended as ever, in the colour F + T g. So volumes are drawn first, and then surfaces
 * in any number, each pixel's by depth, without the volume ever being cut between them. Exact for
 * blends whose factors add up to 1.
 * source ours, from the operator over (Porter and Duff, SIGGRAPH 1984) being linear in what is
 *      behind */
#ifndef SHADERS_VOLUME_THROUGH_H
#define SHADERS_VOLUME_THROUGH_H

#include "shaders_c/materials/phong.h"
#include "shaders_c/volume/raycast.h"

/* A ray through the centre of pixel (x, y) is [0] + [1] x + [2] y. */
typedef struct ThroughUniforms {
    PhongUniforms phong;
    RaycastUniforms rays;         /* depth and texel count for nothing */
    float start[3][3], way[3][3]; /* as raycast.h's GP_TEXCOORD0 and 1 */
    float share[4];               /* of its way at which a place (x, y, z, 1) of the world is */
} ThroughUniforms;

/* phong_program's surface; slots 0 to 2 as raycast.h's. The volume without light, and lit. */
extern const GpProgram phong_through_program;
extern const GpProgram phong_through_lit_program;

#endif
