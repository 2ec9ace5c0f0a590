/* Names of trace events. */
#include "pipeline/list/trace.h"

const char *const gp_trace_kind_names[GP_TRACE_KINDS] = {
    "clear",       "vertex",  "clip",  "setup", "raster",
    "interpolate", "texture", "pixel", "test",  "output",
};
