/* How wrong a drawn picture of shadows is, beside the truth. */
#ifndef APPS_TRUTH_SHADOW_ERROR_H
#define APPS_TRUTH_SHADOW_ERROR_H

#include "apps/truth/shadow_truth.h"

/* A visibility under 0.5, or not a number, is dark. */
typedef struct ShadowError {
    uint32_t covered; /* pixels compared */
    uint32_t lit;     /* of those, lit in truth */
    uint32_t acne;    /* lit in truth, measured dark */
    uint32_t leak;    /* dark in truth, measured lit */
    double wrong;     /* acne and leak, as a share of the pixels compared */
    double rmse;      /* of visibility */
} ShadowError;

/* Compares the pixels that truth and measurement cover; shares of no pixel are 0.
 * in     measured: [width * height] visibility, below 0 where nothing was drawn; mask: as many
 *        bytes, 0 leaves a pixel out, NULL leaves out none */
ShadowError shadow_error(const ShadowTruth *truth, const float *measured, const uint8_t *mask);

#endif
