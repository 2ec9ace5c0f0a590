/* What the words of a page of charts mean, for one who was not there. */
#ifndef APPS_CHARTS_CHART_WORDS_H
#define APPS_CHARTS_CHART_WORDS_H

#include "apps/base/text.h"
#include "apps/charts/chart.h"

/* Appends a list of the words that all charts share, as HTML. */
void chart_add_common_words(Text *page);

/* Appends those of one chart: how its exact result was found, its error, its metrics, its methods
 * and the options of its settings. A chart that none of the techniques has made tells less. */
void chart_add_words(const Chart *chart, const Technique *const *techniques, Text *page);

/* Appends those of a technique's scaling: its axes and its lines. */
void chart_add_scaling_words(const TechniqueScaling *scaling, Text *page);

#endif
