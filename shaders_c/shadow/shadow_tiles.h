/* Adaptive shadow maps: which tiles of a map to draw again, finer, and lighting with them.
 *
 * request    the eye's view: each pixel whose shadow the map leaves open says in which tile it lies
 * mark       a point for each pixel of that picture, on the tile's texel of a small surface
 * light      as shadow_hardware, from the finer tile where there is one
 *
 * Texture 0 is the surface's colour, texture 1 the light's map; light has in 2 the table of tiles
 * (red and green: column and row in the atlas, in steps of 1/255; alpha 1: there is one) and in 3
 * the atlas. mark reads the request's picture, by its vertices, as texture 0.
 */
#ifndef SHADERS_SHADOW_TILES_H
#define SHADERS_SHADOW_TILES_H

#include "shaders_c/shadow/shadow.h"

typedef struct ShadowTilesUniforms {
    ShadowUniforms shadow;
    float tiles;          /* of the map, a side */
    float inset;          /* half a texel of a tile, where the tile is 1 wide */
    float atlas_tiles[2]; /* 1 / columns, 1 / rows of the atlas */
} ShadowTilesUniforms;

typedef struct ShadowMarkUniforms {
    float tiles; /* a side */
} ShadowMarkUniforms;

/* One target, red: 1 + the number of the tile, row by row; 0 where the map will do. */
extern const GpProgram shadow_request_program;

/* GP_TEXCOORD0: the centre of a pixel of the request's picture. White. */
extern const GpProgram shadow_mark_program;

SHADOW_PROGRAMS(tiles);

#endif
