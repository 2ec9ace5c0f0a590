/* Cameras that look at a box from around it. */
#ifndef APPS_BASE_ORBIT_H
#define APPS_BASE_ORBIT_H

#include "apps/base/bounds.h"
#include "apps/base/camera.h"

/* The axis that points up in the picture. */
typedef enum OrbitUp {
    ORBIT_UP_Y,
    ORBIT_UP_Z,
    ORBIT_UP_X,
    ORBIT_DOWN_Y,
    ORBIT_DOWN_Z,
} OrbitUp;

typedef struct Orbit {
    double azimuth, elevation; /* of the eye, in degrees: to the right, upwards */
    OrbitUp up;
    double zoom; /* larger by so much than what fills the picture */
} Orbit;

/* Unit vectors to the right, up and to the front, where azimuths are counted from: right-handed. */
const double (*orbit_axes(OrbitUp up))[3];

/* Looks at the centre of a box, from just so far that every corner is in the picture.
 * in   aspect: width / height; nearest: the near plane is at least so far from the eye */
Camera orbit_camera(const Orbit *orbit, const Bounds *seen, double aspect, double nearest);

#endif
