/* A transfer function from a field's histogram.
 *
 * What is around the object, air or fluid, has the values that most samples of the box's sides
 * have: a peak of the histogram, and what is below it. Of what is above, each range of values takes
 * about the same share of the light that goes through the volume, higher ones somewhat more. So
 * what fills much room is thin, and rare values show: borders between two things, vessels, bones.
 * source ours; where the peak ends: Zack, Rogers and Latt 1977, the triangle method */
#include "apps/volumes/transfer.h"

#include "apps/base/stable_math.h"

#include <math.h>

enum { RANGES = 12 };

/* What the whole box takes on average, as an exponent; and a range of values at most. */
#define TAKEN        1.4
#define MOST_OPACITY 0.5

static const double colors[][3] = {
    { .22, .34, .50 }, { .80, .42, .26 }, { .96, .76, .46 }, { .98, .94, .80 }, { .80, .93, 1.0 }
};

static void color_at(double t, double rgba[4])
{
    const int last = (int)GP_COUNT(colors) - 1;
    const int i = (int)fmin(t * last, last - 1);
    for (int c = 0; c < 3; c++)
        rgba[c] = colors[i][c] + (t * last - i) * (colors[i + 1][c] - colors[i][c]);
}

/* Mean over a value and those beside it: scans that were scaled lack every second. */
static double smooth(const double count[FIELD_VALUES], int i)
{
    double sum = 0;
    int values = 0;
    for (int k = i < 2 ? 0 : i - 2; k <= i + 2 && k < FIELD_VALUES; k++, values++)
        sum += count[k];
    return sum / values;
}

/* Neighbours mostly have one value: their counts are apart, for none to wait for the other's. */
static void count_samples(const uint8_t *values, size_t samples, double count[FIELD_VALUES])
{
    enum { PARTS = 4 };
    uint64_t part[PARTS][FIELD_VALUES] = { { 0 } };
    for (size_t i = 0; i < samples; i++)
        part[i % PARTS][values[i]]++;
    for (int p = 0; p < PARTS; p++)
        for (int i = 0; i < FIELD_VALUES; i++)
            count[i] += (double)part[p][i];
}

/* The samples of the box's sides. */
static void count_sides(const Field *field, double count[FIELD_VALUES])
{
    const uint32_t *size = field->size;
    const uint8_t *row = field->value;
    for (uint32_t z = 0; z < size[2]; z++)
        for (uint32_t y = 0; y < size[1]; y++, row += size[0]) {
            const bool whole = y == 0 || z == 0 || y + 1 == size[1] || z + 1 == size[2];
            const uint32_t step = whole || size[0] < 2 ? 1 : size[0] - 1;
            for (uint32_t x = 0; x < size[0]; x += step)
                count[row[x]]++;
        }
}

/* The last value of what is around: where the histogram is farthest below the straight line from
 * the peak to the last value there is; by fourth roots of counts, since few samples matter too. */
static int find_border(const double all[FIELD_VALUES], const double sides[FIELD_VALUES], int last)
{
    double height[FIELD_VALUES], most = 0;
    int peak = 0;
    for (int i = 0; i < FIELD_VALUES; i++) {
        height[i] = sqrt(sqrt(smooth(all, i)));
        peak = smooth(sides, i) > smooth(sides, peak) ? i : peak;
    }
    int border = peak;
    for (int i = peak; i < last; i++) {
        const double line =
            height[peak] + (height[last] - height[peak]) * (i - peak) / (last - peak);
        if (line - height[i] > most) {
            most = line - height[i];
            border = i;
        }
    }
    return border;
}

/* What all samples may take together: the mean area of the box's sides, over a sample's cell. */
static double all_taken(const Field *field)
{
    double side[3], cell = 1;
    for (int k = 0; k < 3; k++) {
        side[k] = field->size[k] * field->scale[k];
        cell *= field->scale[k];
    }
    const double area = (side[0] * side[1] + side[1] * side[2] + side[2] * side[0]) / 3;
    return TAKEN * area / cell;
}

/* Samples of each range of values, each `width` wide from `low` on. returns how many ranges have
 * any */
static int count_ranges(const double count[FIELD_VALUES], double low, double width,
                        double samples[RANGES])
{
    int used = 0;
    for (int r = 0; r < RANGES; r++) {
        const double from = low + r * width, to = from + width + 1e-9;
        samples[r] = 0;
        for (int i = (int)floor(from + 1e-9) + 1; i <= to && i < FIELD_VALUES; i++)
            samples[r] += count[i];
        used += samples[r] > 0;
    }
    return used > 0 ? used : 1;
}

void transfer_choose(const Field *field, Transfer *transfer)
{
    double count[FIELD_VALUES] = { 0 }, sides[FIELD_VALUES] = { 0 }, samples[RANGES];
    count_samples(field->value, (size_t)field->size[0] * field->size[1] * field->size[2], count);
    count_sides(field, sides);
    int last = FIELD_VALUES - 1;
    while (last > 0 && !(count[last] > 0))
        last--;
    const double low = fmin(find_border(count, sides, last), FIELD_VALUES - 2),
                 width = (fmax(last, low + 1) - low) / RANGES;
    const double share = all_taken(field) / count_ranges(count, low, width, samples);
    Transfer made = { .count = 1, .stops = { { .value = low } } };
    color_at(0, made.stops[0].rgba);
    for (int r = 0; r < RANGES; r++) {
        const double t = (r + 0.5) / RANGES;
        TransferStop *stop = &made.stops[made.count++];
        stop->value = low + (r + 0.5) * width;
        color_at(t, stop->rgba);
        stop->rgba[3] =
            fmin(1 - stable_exp(-share * (0.4 + 2 * t) / (samples[r] + 1)), MOST_OPACITY);
    }
    *transfer = made;
}
