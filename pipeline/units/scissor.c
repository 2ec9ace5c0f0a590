/* Scissor test: keeps the pixels of a half-open rectangle.
 * in: the state and a quad; out: its mask. */
#include "pipeline/units/scissor.h"

void gp_scissor(const GpRasterState *state, GpQuad *quad)
{
    for (int pixel = 0; pixel < 4; pixel++) {
        int32_t x = quad->x + pixel % 2, y = quad->y + pixel / 2;
        if (x < state->scissor_x0 || x >= state->scissor_x1 || y < state->scissor_y0 ||
            y >= state->scissor_y1)
            quad->mask &= ~(1u << pixel);
    }
}
