/* Interpolation: barycentrics, depth and interpolants of a quad (R11, R16, R18). */
#ifndef GP_INTERPOLATE_H
#define GP_INTERPOLATE_H

#include "pipeline/resources/packet.h"
#include "pipeline/shader/program.h"

/* How each varying component of a program is interpolated. */
typedef struct GpVaryingModes {
    int components;
    GpInterpolation mode[GP_MAX_VARYINGS]; /* in triangles; never GP_SPRITE_COORD */
    uint64_t flat, screen;                 /* bit i: component i is flat; linear on the screen */
    int sprite; /* first of the two components that take a point sprite's coordinates, or -1 */
} GpVaryingModes;

GpVaryingModes gp_varying_modes(const GpProgram *program);

/* Perspective-correct barycentrics of all four pixels; corner order of the triangle. */
void gp_interpolate_barycentrics(const GpTriangle *triangle, GpQuad *quad);

/* Takes pixels out of the mask where an interpolated clip distance is negative or NaN (R11).
 * in   planes: bit i, plane i is in use; barycentrics */
void gp_interpolate_clip(const GpTriangle *triangle, unsigned planes, GpQuad *quad);

/* Depth, clamped to [min_depth, max_depth] (R18); helpers get theirs too. */
void gp_interpolate_depth(const GpTriangle *triangle, float min_depth, float max_depth,
                          GpQuad *quad);

/* Interpolants of all four pixels.
 * in   wanted: bit i, component i is needed; others stay as they are; barycentrics */
void gp_interpolate_varyings(const GpTriangle *triangle, const GpVaryingModes *modes,
                             uint64_t wanted, GpQuad *quad);

/* The same, and the barycentrics, as if all were linear on the screen but what is flat: to be
 * looked at beside them. */
void gp_interpolate_on_screen(const GpTriangle *triangle, const GpVaryingModes *modes,
                              GpQuad *quad);

/* The same for a point sprite, whose values are constant but for its coordinates: 0..1 from its
 * left top to its right bottom. Fills depth too. */
void gp_interpolate_sprite(const GpPointSprite *sprite, const GpVaryingModes *modes,
                           float min_depth, float max_depth, GpQuad *quad);

#endif
