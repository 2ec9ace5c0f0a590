/* Scissor test: keeps pixels inside a rectangle. */
#ifndef GP_SCISSOR_H
#define GP_SCISSOR_H

#include "pipeline/resources/packet.h"

/* Takes pixels outside [scissor_x0, scissor_x1) x [scissor_y0, scissor_y1) out of the mask.
 * order after the pixel shader, as Direct3D 9 reports it; doing it earlier changes no pixel */
void gp_scissor(const GpRasterState *state, GpQuad *quad);

#endif
