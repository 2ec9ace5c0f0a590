/* Fragments that the machine sorts. */
#ifndef SHADERS_FRAGMENTS_SORTED_H
#define SHADERS_FRAGMENTS_SORTED_H

#include "shaders_c/fragments/fragment.h"

/* Colour multiplied by what the fragment hides, and what it hides: to be blended over those behind
 * it. */
extern const GpProgram sorted_program;

/* Light, and what the fragment lets through. */
extern const GpProgram sorted_glass_program;

#endif
