/* What there is to say of a warped picture. */
#ifndef APPS_TECHNIQUES_WARP_REPORT_H
#define APPS_TECHNIQUES_WARP_REPORT_H

#include "apps/techniques/warp/model.h"

/* As a technique's report. */
GpResult warp_report(void *model, const void *options, const Frame *frame, GpDevice *device,
                     TechniqueReport *report, GpError *error);

/* Triangles of a frame, and pixels of its images that show something, for JSON. */
void warp_tell_size(const WarpModel *model, const Frame *frame, json_t *members);

/* How far off it is, for JSON. */
void warp_tell_error(const WarpError *off, json_t *members);

#endif
