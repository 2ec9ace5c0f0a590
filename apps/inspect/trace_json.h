/* Trace events as JSON, for programs and for pages. */
#ifndef APPS_INSPECT_TRACE_JSON_H
#define APPS_INSPECT_TRACE_JSON_H

#include <glasspipe/glasspipe.h>

#include <jansson.h>

/* An event as an object: kind, pass, draw, primitive, names, and the members of the event's struct
 * in pipeline/list/trace.h under their own names. The caller owns it. */
json_t *trace_json(const GpTraceEvent *event);

#endif
