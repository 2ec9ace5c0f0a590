/* The mesh itself, as what depth images of it are held against. */
#ifndef SHADERS_WARP_POLYGONS_H
#define SHADERS_WARP_POLYGONS_H

#include "shaders_c/warp/light.h"

typedef struct PolygonsUniforms {
    float mvp[4][4]; /* world to clip */
    float waves; /* of polygons_waves: its colour is 0.5 + 0.5 sin(waves * place), by channels */
    WarpLightUniforms light; /* of polygons_lit */
} PolygonsUniforms;

extern const GpProgram polygons_program;     /* the vertices' colours, as they are */
extern const GpProgram polygons_lit_program; /* the vertices' colours, lit at each pixel */

#endif
