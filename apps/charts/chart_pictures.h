/* Pictures of a chart's best settings, each with its difference from the truth. */
#ifndef APPS_CHARTS_CHART_PICTURES_H
#define APPS_CHARTS_CHART_PICTURES_H

#include "apps/charts/chart.h"

typedef struct ChartPictures {
    const Technique *technique;
    const Experiment *experiment; /* of it, whose truth has been found */
    void *scene;
    const char *folder, *stem;
    GpDevice *device;
} ChartPictures;

/* What the difference of a picture's file is called: "shadow_1_difference.png" of
 * "shadow_1.png". */
void chart_difference_name(const char *picture, char *name, size_t size);

/* Writes STEM_1.png and so on, of at most CHART_MAX_PICTURES points spread over the front, its ends
 * among them, and, where the experiment shows failures, of each method that is beaten the one
 * farthest from the truth; and names them in the chart. Of volumes, pictures as the technique shows
 * them. Beside each, where the experiment can tell, is its difference: left, all of the picture in
 * grey, with what is above the truth in orange and what is below in blue; right, four times as
 * large, the part that has most of it, which a frame marks on the left. Full colour is the
 * picture's largest difference. Files that an earlier chart had more of are removed. What cannot be
 * shown has none.
 * errors GP_ERROR_IO, GP_ERROR_MEMORY, those of a frame */
GpResult chart_write_pictures(const ChartPictures *job, Chart *chart, GpError *error);

#endif
