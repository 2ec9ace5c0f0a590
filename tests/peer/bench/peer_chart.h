/* The chart of a comparison. */
#ifndef PEER_BENCH_PEER_CHART_H
#define PEER_BENCH_PEER_CHART_H

#include "apps/base/text.h"

/* Appends a picture of peers.json, as tests/tools/bench_peers.sh makes it: a bar for each case, how
 * many times faster than llvmpipe, on a logarithmic axis; slower cases reach to the left of 1.
 * errors GP_ERROR_IO (file), GP_ERROR_FORMAT */
GpResult peer_chart_draw(const char *path, Text *svg, GpError *error);

#endif
