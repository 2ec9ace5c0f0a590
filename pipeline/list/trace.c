/* Names of trace events and verdicts. */
#include "pipeline/list/trace.h"

const char *gp_trace_ternary(const GpTraceTest *test)
{
    return test->replaced ? "replaced" : test->passed ? "added" : "dropped";
}

const char *const gp_trace_kind_names[GP_TRACE_KINDS] = {
    "clear", "vertex", "clip", "setup", "raster", "interpolate", "texture",
    "steps", "pixel",  "sort", "test",  "output", "missed",
};
