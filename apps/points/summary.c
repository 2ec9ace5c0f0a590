#include "apps/points/summary.h"

#include "apps/base/vector.h"

#include <float.h>

/* Rounds, and gives what was rounded to. Not inlined: gcc 12 at -O2 turns pairs of doubles into
 * floats and back into the doubles that they were, which is another number. */
__attribute__((noinline)) static void round_to_float(double values[3], float rounded[3])
{
    volatile float *through = rounded;
    for (int i = 0; i < 3; i++) {
        through[i] = (float)values[i];
        values[i] = (double)through[i];
    }
}

/* The least float that is not below. */
static float round_up(double value)
{
    const float rounded = (float)value;
    return (double)rounded < value ? nextafterf(rounded, FLT_MAX) : rounded;
}

SurfelSummary surfels_summary(const Surfel *surfels, const uint32_t *order, uint32_t count,
                              const double origin[3])
{
    SurfelSummary summary = { .moments.origin = { origin[0], origin[1], origin[2] } };
    for (uint32_t i = 0; i < count; i++) {
        const Surfel *surfel = &surfels[order[i]];
        const double area = surfel_area(surfel);
        double normal[3];
        vector_widen(surfel->normal, normal);
        moments_add(&summary.moments, surfel->position);
        vector_add_scaled(summary.normal_sum, area, normal, summary.normal_sum);
        summary.area += area;
    }
    return summary;
}

void summary_axis(const SurfelSummary *summary, float axis[3])
{
    double mean[3] = { summary->normal_sum[0], summary->normal_sum[1], summary->normal_sum[2] };
    vector_normalize(mean);
    round_to_float(mean, axis);
}

void surfels_cone(const Surfel *surfels, uint32_t count, const float axis[3], float *cosine,
                  float *sine)
{
    double middle[3], least = 1;
    vector_widen(axis, middle);
    for (uint32_t i = 0; i < count; i++) {
        double normal[3];
        vector_widen(surfels[i].normal, normal);
        const double c = vector_dot(middle, normal);
        least = c < least ? c : least;
    }
    /* Axis and normals have unit length but for roundings of 1e-7. */
    *cosine = (float)(least - 1e-6);
    if (*cosine > 0) {
        *sine = round_up(sqrt(1 - (double)*cosine * (double)*cosine));
    } else {
        *cosine = -1;
        *sine = 0;
    }
}

double surfels_mean_width(const Surfel *surfels, uint32_t count)
{
    double sum = 0, area = 0;
    for (uint32_t i = 0; i < count; i++) {
        const double own = surfel_area(&surfels[i]);
        sum += own * (double)surfel_width(&surfels[i]);
        area += own;
    }
    return sum / area;
}

void summary_axes(const SurfelSummary *summary, float axes[3][3], float *curvature)
{
    const Symmetric covariance = moments_covariance(&summary->moments);
    double values[3], vectors[3][3];
    symmetric_eigen(&covariance, values, vectors);
    const double sum = values[0] + values[1] + values[2];
    *curvature = sum > 0 && values[2] > 0 ? (float)(values[2] / sum) : 0;
    for (int i = 0; i < 9; i++)
        axes[i / 3][i % 3] = (float)vectors[i / 3][i % 3];
}

void box_around(const Surfel *surfels, uint32_t count, PatchBox *box)
{
    double low[3], high[3], axes[3][3], origin[3], centre[3];
    vector_widen(surfels->position, origin);
    for (int i = 0; i < 3; i++) {
        vector_widen(box->axes[i], axes[i]);
        low[i] = high[i] = 0;
    }
    for (uint32_t k = 0; k < count; k++) {
        double from[3];
        vector_widen(surfels[k].position, from);
        vector_subtract(from, origin, from);
        for (int i = 0; i < 3; i++) {
            const double along = vector_dot(axes[i], from);
            low[i] = along < low[i] ? along : low[i];
            high[i] = along > high[i] ? along : high[i];
        }
    }
    vector_set(centre, origin[0], origin[1], origin[2]);
    for (int i = 0; i < 3; i++)
        vector_add_scaled(centre, 0.5 * (low[i] + high[i]), axes[i], centre);
    round_to_float(centre, box->centre);
    double shift[3], size = 0; /* axes are orthonormal but for roundings */
    vector_subtract(centre, origin, shift);
    for (int i = 0; i < 3; i++)
        size += high[i] - low[i];
    for (int i = 0; i < 3; i++) {
        const double at = vector_dot(axes[i], shift);
        const double half = at - low[i] > high[i] - at ? at - low[i] : high[i] - at;
        box->half[i] = round_up(half + 1e-6 * size);
    }
}

/* The sum of what a surfel has, by its area. */
typedef struct Mixture {
    double area, position[3], normal[3], color[3];
} Mixture;

static Mixture mix(const Surfel *leaves, uint32_t count)
{
    Mixture sum = { .area = 0 };
    double origin[3];
    vector_widen(leaves->position, origin);
    for (uint32_t i = 0; i < count; i++) {
        const Surfel *leaf = &leaves[i];
        const double area = surfel_area(leaf);
        sum.area += area;
        for (int k = 0; k < 3; k++) {
            sum.position[k] += area * ((double)leaf->position[k] - origin[k]);
            sum.normal[k] += area * (double)leaf->normal[k];
            sum.color[k] += area * leaf->color[k];
        }
    }
    for (int k = 0; k < 3; k++)
        sum.position[k] = origin[k] + sum.position[k] / sum.area;
    return sum;
}

/* A ball about all leaves is much wider than the piece of surface that they are, and discs as wide
 * hide what stands beside it; those of this share still close a lattice of squares. */
#define LEAST_SHARE 0.45

Surfel surfel_parent(const Surfel *leaves, uint32_t count)
{
    Mixture sum = mix(leaves, count);
    Surfel parent = leaves[0];
    const double flat = sqrt(vector_dot(sum.normal, sum.normal)); /* area along the mean normal */
    /* Where normals take each other away, the first one's stays. */
    if (vector_dot(sum.normal, sum.normal) > 1e-12 * sum.area * sum.area) {
        vector_normalize(sum.normal);
        round_to_float(sum.normal, parent.normal);
    }
    double radius = 0;
    for (int k = 0; k < 3; k++)
        parent.color[k] = (uint8_t)(sum.color[k] / sum.area + 0.5);
    round_to_float(sum.position, parent.position);
    for (uint32_t i = 0; i < count; i++) {
        double from[3];
        vector_widen(leaves[i].position, from);
        vector_subtract(from, sum.position, from);
        const double reach = sqrt(vector_dot(from, from)) + (double)leaves[i].radius;
        radius = reach > radius ? reach : radius;
    }
    /* what is bent, or has two sides, shows less than its area to those whom the disc faces */
    sum.area = fmax(flat, sum.area / 4);
    const double full = sqrt(sum.area / surfel_area(&(Surfel){ .radius = 1, .share = 255 }));
    /* surfels on top of each other: a disc that has room for their areas */
    radius = fmin(fmax(radius, full), full / LEAST_SHARE);
    parent.radius = round_up(radius);
    parent.share = surfel_share(sum.area, (double)parent.radius);
    return parent;
}
