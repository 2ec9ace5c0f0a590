/* Points as soft round spots of one size in pixels. */
#ifndef SHADERS_SOFT_SPRITE_H
#define SHADERS_SOFT_SPRITE_H

#include "pipeline/shader/program.h"

typedef struct SoftSpriteUniforms {
    float mvp[4][4]; /* world to clip */
    float light[3];  /* towards the light, world, unit length */
    float color[3];  /* linear colour in full light */
    float ambient;   /* share of the colour without light */
    float size;      /* pixels */
    float opacity;   /* in the centre */
} SoftSpriteUniforms;

/* The normal of a point is its position, as on the unit sphere. */
extern const GpProgram soft_sprite_program;

typedef struct SheetSpriteUniforms {
    float size; /* pixels */
    float opacity;
} SheetSpriteUniforms;

/* Positions are (x, y) in clip space and z a value, which is shown as a colour. The spots fill
 * their squares. */
extern const GpProgram sheet_sprite_program;

#endif
