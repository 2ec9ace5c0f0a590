/* Measuring the scaling of a technique. */
#ifndef APPS_CHARTS_SCALING_RUN_H
#define APPS_CHARTS_SCALING_RUN_H

#include "apps/charts/listener.h"
#include "apps/charts/scaling.h"

/* Measures all lines. Scenes whose file is not there are left out, and the listener told.
 * in     seconds: for each setting, after its first frame
 * out    scaling: untouched on failure
 * errors those of scenes that are there, and of settings; GP_ERROR_IO: none is there;
 *        GP_ERROR_MEMORY
 * owns   the caller, until scaling_free */
GpResult scaling_run(const Technique *technique, GpDevice *device, const ChartListener *listener,
                     double seconds, Scaling *scaling, GpError *error);

#endif
