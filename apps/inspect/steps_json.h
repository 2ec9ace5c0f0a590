/* The steps of shaders as JSON: what they are, once, and their values, for every pixel.
 *
 * A listing is {"steps": [...], "watches": [...]}. A step is {"op", "file", "line", "slots", "slot"
 * (of a texture; -1), "width", "operands": [[part, ...], ...]}, a part [source, index, component,
 * negated, value]:
 * source is GpStepSource, and value is there for uniforms and numbers, which are the same for all
 * pixels. A line is the first one of its statement, since compilers differ in where an operator
 * stands. A watch is [name, width, step or -1]. The values of a pixel, or of a vertex, are
 * {"listing", "agrees", "values": [...] of each step's components one after the other, "lanes":
 * {"step": [[value of 4 pixels] of each component of its first operand]} of what looks at the whole
 * quad, "outputs": [part with its value, ...], "watched": [...] of each watch's components}. Of
 * masks 1 is true and 0 is not.
 */
#ifndef APPS_INSPECT_STEPS_JSON_H
#define APPS_INSPECT_STEPS_JSON_H

#include <glasspipe/glasspipe.h>

#include <jansson.h>

/* Steps in all listings of a pass: loops that differ from pixel to pixel make listings of their
 * own. */
enum { STEP_LISTINGS_MOST = 40000 };

/* Listings, each once. A zeroed one is empty. */
typedef struct StepListings {
    json_t *numbers; /* by hash */
    json_t *all;
    int steps; /* in all of them */
} StepListings;

/* The values of one lane; its listing is added where it is new. Where there are too many steps
 * already, {"left_out", "agrees", "watches", "watched"}. The caller owns it. */
json_t *steps_json(StepListings *listings, const GpTraceSteps *steps);

void step_listings_free(StepListings *listings); /* zeroes it */

#endif
