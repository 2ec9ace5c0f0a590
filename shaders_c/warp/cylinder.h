/* Cylindrical depth images as the paper warps them: within the plane that touches the cylinder
 * where the eye is nearest, then that plane as a picture.
 *
 * Places of the cylinder: x towards the eye's azimuth, y along the axis, z to its right as the eye
 * sees it; the middle of the axis is the origin.
 * source Liu, Liu, Wu, Journal of Software 18(6), 2007, section 3.2 */
#ifndef SHADERS_WARP_CYLINDER_H
#define SHADERS_WARP_CYLINDER_H

#include "shaders_c/warp/detail.h"
#include "shaders_c/warp/light.h"

typedef struct CylinderUniforms {
    float turn[2]; /* cosine and sine of the eye's azimuth */
    float radius;
    float eye[2]; /* its distance from the axis, and its height */
    float window
        [4]; /* of the picture: places are x * window[0] + window[1], y * window[2] + window[3] */
    float to_world[4][4];      /* from places before the turn */
    float to_clip[4][4];       /* likewise, of the view */
    WarpDetailUniforms detail; /* of the programs with detail */
    WarpLightUniforms light;
} CylinderUniforms;

/* GP_POSITION: cosine and sine of the azimuth, height; GP_TEXCOORD0: place on the textures, depth.
 * Slot 0: colours; slot 1 of lit ones: normals, (n + 1) / 2. Target 0: colour; target 1: (distance
 * of the plane from the eye) / (that of the point), along the plane's normal. */
extern const GpProgram cylinder_program, cylinder_lit_program;
extern const GpProgram cylinder_detail_program, cylinder_detail_lit_program;

/* The same points straight to the view, for eyes that no plane suits. */
extern const GpProgram cylinder_straight_program, cylinder_straight_lit_program;
extern const GpProgram cylinder_straight_detail_program, cylinder_straight_detail_lit_program;

typedef struct CylinderPlaneUniforms {
    float mvp[4][4];
    float eye_depth; /* clip z of the view's eye, whose w is 0 */
} CylinderPlaneUniforms;

/* The picture on its rectangle: GP_POSITION, world; GP_TEXCOORD0. Slot 0: colours, filtered; slot
 * 1: the second target, not filtered. Depth is that of the points. */
extern const GpProgram cylinder_plane_program;

#endif
