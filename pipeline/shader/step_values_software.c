/* The same for the software profiles, in which rcp and rsq of 0 are infinite. */
#define GP_SHADER_SW
#define GP_STEP_VALUE gp_step_value_software
#include "pipeline/shader/step_values.c"
