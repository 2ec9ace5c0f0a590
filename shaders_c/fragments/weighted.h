/* Weighted blended transparency: sums instead of order.
 * source McGuire and Bavoil, "Weighted blended order-independent transparency", Journal of Computer
 *        Graphics Techniques 2(2), 2013; its weight (10) */
#ifndef SHADERS_FRAGMENTS_WEIGHTED_H
#define SHADERS_FRAGMENTS_WEIGHTED_H

#include "shaders_c/fragments/fragment.h"

/* Target 0: colour and alpha times weight, to be added up; target 1: what the fragment lets
 * through, to be multiplied up. */
extern const GpProgram weighted_program;

/* Over all pixels: slots 0 and 1, both sums: the layers' mean, and what all of them hide. */
extern const GpProgram weighted_layers_program;

#endif
