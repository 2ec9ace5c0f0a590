/* Planar depth images as the paper warps them: within a plane, by a table of depths in a vertex
 * texture.
 *
 * Let a point be at depth z before the image's plane of places, and the eye, (x, y, z, w) in the
 * image's axes, w = 0 where it is a direction. The line from the eye e to the point P = (X, Y, z)
 * meets the plane at depth D where P + k (e - e.w P) does, k = (D - z) / (e.z - e.w z): at
 *     (1 - e.w k) (X, Y) + k (e.x, e.y).
 * With w = 1, D = 0 and the eye Dt before the plane, k = z / (z + Dt) = 1 / (1 + Dt / z) is the
 * table of the paper, du = (ue - us) k; where the image's rays meet in its own eye, X = z tan, and
 * the rest is the same. In clip space of the view the point is where (clip of the place) - k (clip
 * of e) is, and the latter has w = 0: from k follows the view's depth.
 * source Liu, Liu, Wu, Journal of Software 18(6), 2007, section 2; perspective images and parallel
 *        views: ours */
#ifndef SHADERS_WARP_PLANAR_H
#define SHADERS_WARP_PLANAR_H

#include "shaders_c/warp/detail.h"
#include "shaders_c/warp/light.h"

enum { PLANAR_TABLE_SLOT = 3 };

typedef struct PlanarUniforms {
    float window[2][4],
        /* x and y of the picture by (s x, s y, s, k): x and y in the image's pixels, s = (1 - e.w
         * k) z or 1 - e.w k; and what is added */
        shift[2];
    float spread[2]; /* s without k: spread[0] z + spread[1], as shaders_c/warp/direct.h has it */
    float table[2];  /* where a depth is in the table: table[0] z + table[1] */
    float eye_w;     /* e.w */
    float per_k;     /* of k in the second target */
    float to_world[3][4]; /* of (spread x, spread y, z, 1): of the lit programs */
    WarpDetailUniforms detail;
    WarpLightUniforms light;
} PlanarUniforms;

/* Vertices: as of shaders_c/warp/direct.h. Slot PLANAR_TABLE_SLOT: k. Target 0: colour; target 1: 1
 * - per_k k, which is (depth of the plane) / (depth of the point) from an eye where per_k is 1:
 * nearness, as shaders_c/warp/cylinder.h has it. */
extern const GpProgram planar_program, planar_lit_program;
extern const GpProgram planar_detail_program, planar_detail_lit_program;

#endif
