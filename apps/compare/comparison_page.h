/* A comparison as a page to look at: both pictures under a slider, their difference, FLIP's map,
 * and the worst tile enlarged. */
#ifndef APPS_COMPARE_COMPARISON_PAGE_H
#define APPS_COMPARE_COMPARISON_PAGE_H

#include "apps/compare/comparison.h"

/* Adds the whole page: one file without others, the same bytes for the same pictures.
 * in     names: of the pictures, as the reader knows them; pictures, comparison, settings: as
 *        comparison_make took and left them
 * errors GP_ERROR_MEMORY, also left in page */
GpResult comparison_page(const char *const names[2], const Picture pictures[2],
                         const Comparison *comparison, const ComparisonSettings *settings,
                         Text *page, GpError *error);

#endif
