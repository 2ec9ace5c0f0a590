/* Alpha test: compares the alpha of target 0 with a reference. */
#ifndef GP_ALPHA_TEST_H
#define GP_ALPHA_TEST_H

#include "pipeline/resources/packet.h"

/* Takes pixels whose alpha (of color[0]) fails against reference/255 out of the mask; that kills
 * all targets. Compared as floats (CHOOSE in CONVENTIONS.md, "Pixels"). */
void gp_alpha_test(const GpAlphaTest *state, GpQuad *quad);

#endif
