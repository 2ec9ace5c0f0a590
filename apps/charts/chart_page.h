/* All charts of a folder, of accuracy and of scaling, on one page that needs no other file:
 * pictures are in it. */
#ifndef APPS_CHARTS_CHART_PAGE_H
#define APPS_CHARTS_CHART_PAGE_H

#include "apps/charts/chart.h"

/* Writes FOLDER/index.html: all charts found there as JSON, each with the table of its front and
 * the pictures of it, and the scaling of these techniques. A file that is no chart is named on the
 * page, with the reason.
 * errors GP_ERROR_IO, GP_ERROR_MEMORY */
GpResult chart_write_page(const char *folder, const Technique *const *techniques, GpError *error);

#endif
