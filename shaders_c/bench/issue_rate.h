/* As many operations at once as a processor has room for: what its arithmetic is measured with. */
#ifndef SHADERS_ISSUE_RATE_H
#define SHADERS_ISSUE_RATE_H

#include "pipeline/shader/program.h"

typedef struct IssueRateUniforms {
    float factor, addend;
} IssueRateUniforms;

/* Twelve chains of 64 steps v = v * factor + addend, none of which waits for another; on quads in
 * clip space. */
extern const GpProgram issue_rate_program;

#endif
