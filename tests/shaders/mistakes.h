/* Programs with one mistake of declaration each, and one without any. */
#ifndef TESTS_SHADERS_MISTAKES_H
#define TESTS_SHADERS_MISTAKES_H

#include "pipeline/shader/program.h"

/* Inputs of all: GP_POSITION 2 (clip space), GP_COLOR 3. */
typedef struct MistakesUniforms {
    float scale;
} MistakesUniforms;

/* Declares all that it uses; its fields stand in no order. */
extern const GpProgram mistake_none;

/* Use what they do not declare. */
extern const GpProgram mistake_samplers, mistake_vertex_samplers, mistake_local_reads,
    mistake_may_discard, mistake_texkill, mistake_writes_depth, mistake_writes_point_size,
    mistake_uses_pixel, mistake_uses_face, mistake_uses_derivatives, mistake_slot,
    mistake_negative_slot, mistake_far_slot;

/* Read a texture in a loop that no vertex or pixel of all zeros enters. */
extern const GpProgram mistake_samplers_in_loop;

/* Declare what they do not write. */
extern const GpProgram mistake_no_depth, mistake_no_point_size;

/* Inputs in another order than the struct's, of other and of equal widths; other sums. */
extern const GpProgram mistake_inputs_swapped, mistake_inputs_swapped_equal, mistake_inputs_sum,
    mistake_varyings_sum;

/* Inputs of one width in another order: told by the members' names, where they are counted. */
extern const GpProgram mistake_inputs_named;

/* Leave something unwritten, or use in a vertex shader what only pixels have. */
extern const GpProgram mistake_varying_unwritten, mistake_target_unwritten,
    mistake_position_unwritten, mistake_vertex_place;

#endif
