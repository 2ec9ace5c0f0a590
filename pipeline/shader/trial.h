/* Trials: a few packets of made-up vertices and pixels, which show what a shader reads and
 * writes. */
#ifndef GP_SHADER_TRIAL_H
#define GP_SHADER_TRIAL_H

#include "pipeline/shader/counts.h"

typedef struct GpTrial {
    /* What was seen, in the words of counting; costs are 0. Of inputs_read only those are told that
     * the vertex shader does not write. */
    GpShaderCounts vertex, pixel;
    int wrong_slot;         /* a texture slot that does not exist was read; 0, which does: none */
    bool fused;             /* the code rounds a * b + c once */
    bool writes_position;   /* all of it */
    bool position_moves;    /* the clip-space position follows the input GP_POSITION */
    bool other_input_moves; /* it follows another input */
} GpTrial;

/* Runs both shaders of a program's code.
 * in   program: passed gp_program_check; code: one of its own, which this processor runs; uniforms:
 *      program->uniform_bytes bytes
 * note values are seen, not instructions: a branch that depends on uniforms is seen as these have
 * it */
GpTrial gp_program_trial(const GpProgram *program, const GpProgramCode *code, const void *uniforms);

#endif
