/* Alpha test: the alpha of target 0 against reference / 255, as floats.
 * in: the state, and a shaded quad; out: its mask. Rules: CONVENTIONS.md, "Pixels". */
#include "pipeline/units/alpha_test.h"

#include "pipeline/resources/compare.h"

void gp_alpha_test(const GpAlphaTest *state, GpQuad *quad)
{
    float reference = gp_float_from_unorm(state->reference, 8);
    for (int pixel = 0; pixel < 4; pixel++)
        if (!gp_compare_floats(state->test, quad->color[0][3][pixel], reference))
            quad->mask &= ~(1u << pixel);
}
