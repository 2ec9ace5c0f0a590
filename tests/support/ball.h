/* A convex ball of triangles in double, for rays. */
#ifndef TESTS_BALL_H
#define TESTS_BALL_H

#include "apps/truth/ray_scene.h"

#include <string.h>

enum { BALL_AROUND = 48, BALL_ACROSS = 24, BALL = BALL_AROUND * BALL_ACROSS * 2 };

/* Its poles lie on an axis that fits none of the space's; there, triangles have no area, which must
 * do no harm. Corners are on the sphere. */
static inline void make_ball(const double centre[3], double radius, TruthTriangle ball[BALL])
{
    static const double axes[3][3] = { { 0.36, 0.48, -0.8 },
                                       { -0.8, 0.6, 0 },
                                       { 0.48, 0.64, 0.6 } };
    static const double pi = 3.14159265358979323846;
    double corner[BALL_ACROSS + 1][BALL_AROUND][3];
    for (int j = 0; j <= BALL_ACROSS; j++)
        for (int i = 0; i < BALL_AROUND; i++) {
            double phi = i * 2 * pi / BALL_AROUND, theta = j * pi / BALL_ACROSS;
            double ring = j % BALL_ACROSS ? radius * sin(theta) : 0;
            vector_add_scaled(centre, radius * cos(theta), axes[2], corner[j][i]);
            vector_add_scaled(corner[j][i], ring * cos(phi), axes[0], corner[j][i]);
            vector_add_scaled(corner[j][i], ring * sin(phi), axes[1], corner[j][i]);
        }
    for (int n = 0; n < BALL; n++) {
        int j = n / 2 / BALL_AROUND, i = n / 2 % BALL_AROUND, next = (i + 1) % BALL_AROUND;
        const double *quad[4] = { corner[j][i], corner[j + 1][i], corner[j + 1][next],
                                  corner[j][next] };
        for (int k = 0; k < 3; k++)
            memcpy(ball[n].corner[k], quad[(n % 2 * 2 + k) % 4], sizeof ball[n].corner[k]);
    }
}

#endif
