/* The reference executor: the units one after the other, a quad at a time, in submission order. */
#ifndef GP_REFERENCE_H
#define GP_REFERENCE_H

#include "pipeline/list/counters.h"
#include "pipeline/list/trace.h"
#include "pipeline/reference/held_quads.h"

typedef struct GpReference {
    int lanes;            /* width of the shader code to run: 4, 8 or 16 */
    const GpTrace *trace; /* NULL: nobody watches */
    GpCounters *counters;
    uint32_t first_pass; /* what the trace calls the list's first */
    /* only quads with a pixel that is told of are drawn, and held first; NULL: all are */
    GpHeldQuads *held;
} GpReference;

/* Runs a checked list.
 * order passes, draws, primitives, then rows of quads from the top
 *      where a pass has an order by depth, pixels and their fragments at its end
 * errors GP_ERROR_MEMORY before anything is drawn, for fragments that wait for the end of a pass,
 *      or, after all is drawn, for steps that were to be told */
GpResult gp_reference_run(const GpReference *reference, const GpList *list, GpError *error);

#endif
