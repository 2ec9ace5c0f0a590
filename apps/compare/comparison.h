/* Two pictures as they come, made comparable, compared in every way there is, and judged. */
#ifndef APPS_COMPARE_COMPARISON_H
#define APPS_COMPARE_COMPARISON_H

#include "apps/base/text.h"
#include "apps/compare/compare.h"
#include "apps/compare/flip.h"

typedef struct ComparisonSettings {
    CompareLimits limits;
    /* fails if the mean FLIP is over this; negative: no such limit. Where there is no other limit,
     * this one alone judges */
    double flip_fail;
    double pixels_per_degree; /* 0: FLIP_PIXELS_PER_DEGREE */
    bool no_alpha;            /* alpha is not compared */
} ComparisonSettings;

/* Without limits. */
extern const ComparisonSettings comparison_defaults;

/* Which pictures have alpha, and whether it was compared. */
typedef enum ComparedAlpha {
    ALPHA_NONE,     /* neither has */
    ALPHA_COMPARED, /* both have */
    ALPHA_LEFT_OUT, /* both have; not compared because of no_alpha */
    ALPHA_FIRST,    /* the first alone has: not compared */
    ALPHA_SECOND,   /* the second alone has: not compared */
    ALPHAS
} ComparedAlpha;

/* A zeroed one is empty. */
typedef struct Comparison {
    uint32_t sizes[2][2]; /* width and height of each */
    bool other_sizes;     /* these differ, which is all there is to say: the rest is zero */
    ComparedAlpha alpha;
    CompareReport report;
    FlipReport flip;
    float *flip_map;          /* as flip_compare makes it; NULL where the bits are the same */
    double pixels_per_degree; /* of FLIP */
    bool failed, warned;
} Comparison;

/* Compares two pictures as their files hold them. Where all samples are the same, nothing is left
 * to look at as floats.
 * in     views: the pictures are wanted even then
 * out    pictures: as floats, of the same channels where they have one size (grey is repeated;
 *        alpha is left out unless both have it and it is wanted); empty where they are not wanted,
 *        and on errors;
 *        owns: the caller, until picture_free
 * errors GP_ERROR_MEMORY; owns: the caller, until comparison_free */
GpResult comparison_make(const GpImage images[2], bool views, const ComparisonSettings *settings,
                         GpPool *pool, Picture pictures[2], Comparison *comparison, GpError *error);

void comparison_free(Comparison *comparison); /* zeroes it */

/* Adds the verdict in words, one line without its end: "different: 3 of 4096 pixels (0.0732 %)
 * differ by more than 0.004". */
void comparison_say(const Comparison *comparison, const ComparisonSettings *settings, Text *text);

/* The same of alpha: "only the first has alpha, which was not compared"; "" where there is
 * nothing. */
const char *comparison_alpha(const Comparison *comparison);

/* A name of what was done with alpha, for programs: "none", "compared", "left out", "only first"
 * .. */
const char *comparison_alpha_name(ComparedAlpha alpha);

#endif
