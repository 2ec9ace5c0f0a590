/* A pass's targets in a row: the colours, then depth. */
#ifndef GP_PASS_TARGET_H
#define GP_PASS_TARGET_H

#include "pipeline/list/list.h"

/* in: number: 0 to GP_MAX_TARGETS. returns NULL where there is none */
static inline GpSurface *gp_pass_target(const GpPass *pass, int number)
{
    return number < GP_MAX_TARGETS ? pass->color[number].surface : pass->depth.surface;
}

#endif
