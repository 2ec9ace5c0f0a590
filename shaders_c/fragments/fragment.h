/* Fragments of a mesh whose triangles have a colour each: what all programs that draw them are
 * told. */
#ifndef SHADERS_FRAGMENTS_FRAGMENT_H
#define SHADERS_FRAGMENTS_FRAGMENT_H

#include "pipeline/shader/program.h"

typedef struct FragmentUniforms {
    float mvp[4][4]; /* world to clip */
    /* of glass alone (apps/fragments/drawing/view.h): */
    float eye[3];
    float forward[3]; /* unit length */
    float parallel;   /* 1: all lines of sight go forward; 0: they come from the eye */
    float begin;      /* distance along the view, from which on light is taken */
    float through;    /* share of light that a surface lets through head on */
    float sigma;      /* extinction, as an exponent of 2 */
    /* of lists alone (lists.h): */
    float place; /* the fragment's, among those of its pixel, 0 to 4095 */
} FragmentUniforms;

/* The inputs of all: GP_POSITION, 3, GP_COLOR, 4; of glass also GP_NORMAL, 3. The colour and the
 * normal of a triangle are those of its first corner. */

/* 1: to be added up. */
extern const GpProgram fragment_count_program;

/* Over all pixels, GP_POSITION, 3, without uniforms: slot 0, light and what is let through, in
 * place, as colour multiplied by alpha. */
extern const GpProgram fragment_over_program;

#endif
