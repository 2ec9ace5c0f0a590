/* A transfer function from a field's histogram.
 *
 * Most of a scan is what is around the object: air, or fluid, which has the values of its border.
 * Light is to be taken by what is not, more by higher values, which are rarer and lie deeper.
 * source ours; Otsu 1979 for the value that parts two kinds of samples best */
#include "apps/volumes/transfer.h"

#include <math.h>

typedef struct Histogram {
    double count[FIELD_VALUES]; /* of samples */
} Histogram;

/* The value that leaves least variance on its two sides, among those from `first` on. */
static int part(const Histogram *histogram, int first)
{
    double total = 0, sum = 0, below = 0, sum_below = 0, most = -1;
    int best = first;
    for (int i = first; i < FIELD_VALUES; i++) {
        total += histogram->count[i];
        sum += i * histogram->count[i];
    }
    for (int i = first; i < FIELD_VALUES; i++) {
        below += histogram->count[i];
        sum_below += i * histogram->count[i];
        const double above = total - below;
        if (!(below > 0) || !(above > 0))
            continue;
        const double apart = sum_below / below - (sum - sum_below) / above;
        const double between = below * above * apart * apart;
        if (between > most) {
            most = between;
            best = i;
        }
    }
    return best;
}

void transfer_choose(const Field *field, Transfer *transfer)
{
    Histogram histogram = { { 0 } };
    for (size_t i = 0; i < field_samples(field); i++)
        histogram.count[field->value[i]]++;
    const double low = fmin(fmax(part(&histogram, 0), 1), 252);
    const double high = fmin(fmax(part(&histogram, (int)low + 1), low + 2), 254);
    *transfer = (Transfer){ 4,
                            { { fmax(low * 0.8 - 1, 0), { .4, .2, .1, 0 } },
                              { low, { .8, .5, .3, .02 } },
                              { high, { .9, .8, .6, .1 } },
                              { 255, { 1, 1, .95, .3 } } } };
}
