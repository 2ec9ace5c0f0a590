/* The values of steps (internal): one instruction, at four lanes. */
#ifndef GP_STEP_VALUES_H
#define GP_STEP_VALUES_H

#include "pipeline/shader/steps.h"

/* Of the profiles with limits and of the others, which differ in rcp and rsq. Reads
 * of textures, discards and loops are not for them. */
void gp_step_value(GpStepCode code, int width, const float operand[GP_STEP_OPERANDS][4][4],
                   float value[4][4]);
void gp_step_value_software(GpStepCode code, int width, const float operand[GP_STEP_OPERANDS][4][4],
                            float value[4][4]);

#endif
