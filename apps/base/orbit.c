#include "apps/base/orbit.h"

#include <math.h>

static const double turns[][3][3] = {
    [ORBIT_UP_Y] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    [ORBIT_UP_Z] = { { 1, 0, 0 }, { 0, 0, 1 }, { 0, -1, 0 } },
    [ORBIT_UP_X] = { { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, -1 } },
    [ORBIT_DOWN_Y] = { { 1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 } },
    [ORBIT_DOWN_Z] = { { 1, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 } },
};

const double (*orbit_axes(OrbitUp up))[3]
{
    return turns[up];
}

/* Of the way between a box and the picture's border. */
#define BORDER 1.05
#define ANGLE  30.0 /* of view, before it is zoomed */

/* The camera's own axes: to the right, up, and towards the eye. */
static void find_axes(const Orbit *orbit, double axes[3][3])
{
    const double(*turn)[3] = orbit_axes(orbit->up);
    double sine[2], cosine[2];
    angle_sincos(orbit->azimuth, &sine[0], &cosine[0]);
    angle_sincos(orbit->elevation, &sine[1], &cosine[1]);
    const double own[3][3] = { { cosine[0], 0, -sine[0] },
                               { -sine[0] * sine[1], cosine[1], -cosine[0] * sine[1] },
                               { sine[0] * cosine[1], sine[1], cosine[0] * cosine[1] } };
    for (int a = 0; a < 3; a++)
        for (int k = 0; k < 3; k++)
            axes[a][k] = own[a][0] * turn[0][k] + own[a][1] * turn[1][k] + own[a][2] * turn[2][k];
}

/* The angle of view at which a picture is larger by a factor, by bisection: the C library's arc
 * tangent has other bits elsewhere. */
static double zoom_angle(double angle, double zoom)
{
    double sine, cosine, low = 0, high = 180;
    angle_sincos(angle / 2, &sine, &cosine);
    const double tangent = sine / cosine / zoom;
    while (high - low > 1e-9) {
        const double centre = (low + high) / 2;
        angle_sincos(centre / 2, &sine, &cosine);
        *(sine < tangent * cosine ? &low : &high) = centre;
    }
    return low;
}

/* Half the size of what is seen. A point has one too, so that it has a place between near and far:
 * a thousandth of where it lies. */
static double find_half(const Bounds *seen, double half[3])
{
    double sum = 0, at = 0;
    for (int k = 0; k < 3; k++) {
        half[k] = (seen->high[k] - seen->low[k]) / 2;
        sum += half[k];
        at = fmax(at, fabs(seen->low[k]));
    }
    if (sum > 0)
        return sum;
    at = at > 0 ? at * 1e-3 : 1;
    vector_set(half, at, at, at);
    return 3 * at;
}

Camera orbit_camera(const Orbit *orbit, const Bounds *seen, double aspect, double nearest)
{
    double axes[3][3], half[3], sine, cosine, distance = 0;
    find_axes(orbit, axes);
    angle_sincos(ANGLE / 2, &sine, &cosine);
    const double wide = BORDER * cosine / sine / aspect, high = BORDER * cosine / sine;
    const double radius = find_half(seen, half);
    for (int corner = 0; corner < 8; corner++) {
        double at[3];
        for (int k = 0; k < 3; k++)
            at[k] = corner >> k & 1 ? half[k] : -half[k];
        const double toward = vector_dot(at, axes[2]);
        distance = fmax(distance, toward + wide * fabs(vector_dot(at, axes[0])));
        distance = fmax(distance, toward + high * fabs(vector_dot(at, axes[1])));
    }
    Camera camera = { .fovy = zoom_angle(ANGLE, orbit->zoom),
                      .near = fmax(distance - radius, nearest),
                      .far = distance + radius };
    for (int k = 0; k < 3; k++) {
        camera.at[k] = seen->low[k] + (seen->high[k] - seen->low[k]) / 2;
        camera.eye[k] = camera.at[k] + distance * axes[2][k];
        camera.up[k] = axes[1][k];
    }
    return camera;
}
