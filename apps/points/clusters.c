#include "apps/points/clusters.h"

#include "apps/base/stable_math.h"

enum { BINS = 4096, ROUNDS = 12 };

typedef struct Histogram {
    double low, per_log; /* bin = (log radius - low) * per_log */
    double count[BINS], sum[BINS];
} Histogram;

static void fill(const Surfel *surfels, uint32_t count, Histogram *histogram)
{
    float least = surfels->radius, most = surfels->radius;
    for (uint32_t i = 0; i < count; i++) {
        least = surfels[i].radius < least ? surfels[i].radius : least;
        most = surfels[i].radius > most ? surfels[i].radius : most;
    }
    *histogram = (Histogram){ .low = stable_log((double)least) };
    const double span = stable_log((double)most) - histogram->low;
    histogram->per_log = span > 0 ? (BINS - 1) / span : 0;
    for (uint32_t i = 0; i < count; i++) {
        const double radius = (double)surfels[i].radius;
        const double at = (stable_log(radius) - histogram->low) * histogram->per_log;
        const int bin = at < 0 ? 0 : at > BINS - 1 ? BINS - 1 : (int)at;
        histogram->count[bin] += 1;
        histogram->sum[bin] += radius;
    }
}

/* Clusters that hold about the same number each. */
static void begin(const Histogram *histogram, double total, double centre[CLUSTERS])
{
    double passed = 0, last = 0;
    int made = 0;
    for (int bin = 0; bin < BINS; bin++) {
        if (histogram->count[bin] == 0)
            continue;
        last = histogram->sum[bin] / histogram->count[bin];
        passed += histogram->count[bin];
        while (made < CLUSTERS && passed * CLUSTERS >= total * (made + 0.5))
            centre[made++] = last;
    }
    while (made < CLUSTERS)
        centre[made++] = last;
}

/* Each centre becomes the mean of the bins that are nearest to it; one without stays. */
static void settle(const Histogram *histogram, double centre[CLUSTERS])
{
    double count[CLUSTERS] = { 0 }, sum[CLUSTERS] = { 0 };
    int at = 0;
    for (int bin = 0; bin < BINS; bin++) {
        if (histogram->count[bin] == 0)
            continue;
        const double radius = histogram->sum[bin] / histogram->count[bin];
        while (at + 1 < CLUSTERS && radius > 0.5 * (centre[at] + centre[at + 1]))
            at++;
        count[at] += histogram->count[bin];
        sum[at] += histogram->sum[bin];
    }
    for (int i = 0; i < CLUSTERS; i++)
        if (count[i] > 0)
            centre[i] = sum[i] / count[i];
}

void clusters_find(const Surfel *surfels, uint32_t count, float radii[CLUSTERS])
{
    Histogram histogram;
    double centre[CLUSTERS];
    fill(surfels, count, &histogram);
    begin(&histogram, count, centre);
    for (int i = 0; i < ROUNDS; i++)
        settle(&histogram, centre);
    for (int i = 0; i < CLUSTERS; i++)
        radii[i] = (float)centre[i];
}

uint8_t clusters_nearest(const float radii[CLUSTERS], float radius)
{
    uint32_t low = 0; /* the last that is not above, but for the first */
    for (uint32_t step = CLUSTERS / 2; step > 0; step /= 2)
        low += radii[low + step] <= radius ? step : 0;
    if (low + 1 < CLUSTERS && radii[low + 1] - radius < radius - radii[low])
        low++;
    return (uint8_t)low;
}
