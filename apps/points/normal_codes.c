#include "apps/points/normal_codes.h"

#include "apps/base/camera.h"

#include <stdbool.h>

/* --- the octahedron --------------------------------------------------------------------------- */

void normal_decode(const uint32_t code[2], double normal[3])
{
    for (int i = 0; i < 2; i++)
        normal[i] = code[i] * (2.0 / NORMAL_STEPS) - 1;
    normal[2] = 1 - fabs(normal[0]) - fabs(normal[1]);
    const double fold = normal[2] < 0 ? -normal[2] : 0;
    for (int i = 0; i < 2; i++)
        normal[i] -= normal[i] >= 0 ? fold : -fold;
    vector_normalize(normal);
}

void normal_encode(const double normal[3], uint32_t code[2])
{
    const double sum = fabs(normal[0]) + fabs(normal[1]) + fabs(normal[2]);
    double place[2] = { 0 }, best = -2;
    uint32_t low[2];
    for (int i = 0; i < 2 && sum > 0; i++)
        place[i] = normal[i] / sum;
    if (normal[2] < 0) {
        const double x = place[0], y = place[1];
        place[0] = x >= 0 ? 1 - fabs(y) : fabs(y) - 1;
        place[1] = y >= 0 ? 1 - fabs(x) : fabs(x) - 1;
    }
    for (int i = 0; i < 2; i++) {
        const double at = (place[i] + 1) * (0.5 * NORMAL_STEPS);
        low[i] = at < 0 ? 0 : at > NORMAL_STEPS - 1 ? NORMAL_STEPS - 1 : (uint32_t)at;
    }
    for (uint32_t i = 0; i < 4; i++) {
        const uint32_t tried[2] = { low[0] + i % 2, low[1] + i / 2 };
        double decoded[3];
        normal_decode(tried, decoded);
        const double cosine = vector_dot(decoded, normal);
        if (cosine > best) {
            best = cosine;
            code[0] = tried[0];
            code[1] = tried[1];
        }
    }
}

/* --- angles ----------------------------------------------------------------------------------- */

void angles_decode(const uint8_t code[2], double normal[3])
{
    double theta[2], phi[2];
    angle_sincos((code[0] + 0.5) * (180.0 / 256), &theta[0], &theta[1]);
    angle_sincos((code[1] + 0.5) * (360.0 / 256), &phi[0], &phi[1]);
    vector_set(normal, theta[0] * phi[1], theta[0] * phi[0], theta[1]);
}

void angle_borders(AngleBorders *borders)
{
    double sine;
    for (int i = 0; i < 256; i++)
        angle_sincos(i * (180.0 / 256), &sine, &borders->theta[i]);
    for (int i = 0; i < 128; i++)
        angle_sincos(i * (360.0 / 256), &borders->phi[i][1], &borders->phi[i][0]);
}

/* By bisection. */
void angles_encode(const AngleBorders *borders, const double normal[3], uint8_t code[2])
{
    const bool is_below = normal[1] < 0;
    uint32_t theta = 0, phi = 0; /* borders that are passed */
    for (uint32_t step = 128; step > 0; step /= 2)
        theta += normal[2] <= borders->theta[theta + step] ? step : 0;
    /* phi in the upper half plane, or, turned half around, in the lower one */
    const double x = is_below ? -normal[0] : normal[0], y = is_below ? -normal[1] : normal[1];
    for (uint32_t step = 64; step > 0; step /= 2) {
        const double *border = borders->phi[phi + step];
        phi += border[0] * y >= border[1] * x ? step : 0;
    }
    code[0] = (uint8_t)theta;
    code[1] = (uint8_t)(phi + (is_below ? 128 : 0));
}
