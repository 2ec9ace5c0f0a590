/* What there is to say of a picture of points. */
#ifndef APPS_TECHNIQUES_POINTS_REPORT_H
#define APPS_TECHNIQUES_POINTS_REPORT_H

#include "apps/techniques/technique.h"

/* As a technique's report. */
GpResult points_report(void *model, const void *options, const Frame *frame, GpDevice *device,
                       TechniqueReport *report, GpError *error);

#endif
