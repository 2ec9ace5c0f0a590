/* The history of one pixel as JSON, for programs. */
#ifndef APPS_COMMANDS_PIXEL_JSON_H
#define APPS_COMMANDS_PIXEL_JSON_H

#include <glasspipe/glasspipe.h>

#include <jansson.h>

/* An event as an object: kind, pass, draw, primitive, names, and the members of the event's struct
 * in pipeline/list/trace.h under their own names. The caller owns it. */
json_t *pixel_json_event(const GpTraceEvent *event);

#endif
