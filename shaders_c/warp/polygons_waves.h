/* The mesh itself, coloured by its places. */
#ifndef SHADERS_WARP_POLYGONS_WAVES_H
#define SHADERS_WARP_POLYGONS_WAVES_H

#include "shaders_c/warp/polygons.h"

extern const GpProgram polygons_waves_program; /* of PolygonsUniforms */

#endif
