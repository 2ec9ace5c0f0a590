#include "apps/truth/shadow_error.h"

static bool is_lit(float visibility)
{
    return visibility >= 0.5f;
}

ShadowError shadow_error(const ShadowTruth *truth, const float *measured, const uint8_t *mask)
{
    ShadowError error = { 0 };
    size_t pixels = (size_t)truth->width * truth->height;
    double squares = 0;
    for (size_t i = 0; i < pixels; i++) {
        if (truth->visibility[i] < 0 || measured[i] < 0 || (mask && !mask[i]))
            continue;
        bool lit = is_lit(truth->visibility[i]), seen_lit = is_lit(measured[i]);
        double difference = (double)measured[i] - (double)truth->visibility[i];
        error.covered++;
        error.lit += lit;
        error.acne += lit && !seen_lit;
        error.leak += !lit && seen_lit;
        squares += difference * difference;
    }
    if (error.covered > 0) {
        error.wrong = (error.acne + error.leak) / (double)error.covered;
        error.rmse = sqrt(squares / error.covered);
    }
    return error;
}
