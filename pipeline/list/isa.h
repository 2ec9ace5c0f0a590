/* Instruction sets: which shader code this processor can run. */
#ifndef GP_ISA_H
#define GP_ISA_H

#include "pipeline/list/list.h"

/* Lanes of a name: "sse2" "neon" "lanes4" 4, "avx2" "lanes8" 8, "avx512" "lanes16" 16; 0 for "auto"
 * and NULL; -1 where there is no such name. The laneN names take whatever code of that width was
 * compiled, on any machine. */
int gp_isa_lanes(const char *name);

/* Whether this processor runs code compiled for a named instruction set. */
bool gp_isa_runs(const char *name);

/* The instruction set that this build's own code of a width (4, 8, 16) was compiled for; NULL where
 * the build has none, or the processor does not run it. */
const char *gp_isa_of_lanes(int lanes);

/* Whether every program of a list has code of a width that this processor runs.
 * out  missing: the first program that has not, or NULL */
bool gp_isa_serves(const GpList *list, int lanes, const GpProgram **missing);

#endif
