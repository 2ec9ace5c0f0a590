/* Cameras and the matrices of a scene, in double, the same on every machine.
 *
 * Matrices are row-major [row][column] and act on column vectors: clip = projection * view * world.
 */
#ifndef APPS_BASE_CAMERA_H
#define APPS_BASE_CAMERA_H

#include "apps/base/vector.h"

typedef struct Camera {
    double eye[3], at[3], up[3]; /* world; up need not be square to the view, only not along it */
    double fovy;                 /* degrees, vertical; 0: parallel rays */
    double height;               /* of the picture's plane in world units, parallel rays only */
    double near, far;            /* distances along the view, 0 < near < far */
} Camera;

/* Sine and cosine of an angle in degrees, within 1e-15 and exact at multiples of 90.
 * source the Taylor series after exact reduction to +-45 degrees: only + - * /, so that the bits do
 *        not depend on the C library, which computes differently where it finds FMA */
void angle_sincos(double degrees, double *sine, double *cosine);

/* World to eye space: x right, y up, the camera looks along -z (gluLookAt). */
void camera_view(const Camera *camera, double view[4][4]);

/* Eye to clip space: gluPerspective with Direct3D's 0 <= z <= w; aspect: width / height. */
void camera_projection(const Camera *camera, double aspect, double projection[4][4]);

/* World to clip space, rounded to float once, at the end. */
void camera_matrix(const Camera *camera, double aspect, float world_to_clip[4][4]);

/* Directions of a camera, unit length, with the picture's half sides: perspective, as tangents of
 * angles; parallel, in world units. */
typedef struct CameraAxes {
    double right[3], up[3], forward[3];
    double half_width, half_height;
} CameraAxes;

CameraAxes camera_axes(const Camera *camera, double aspect);

/* Moves the eye round `at`, about the direction `up`: seen from above, degrees against the clock's
 * turn. */
void camera_turn(Camera *camera, double degrees);

void matrix_identity(double m[4][4]);

/* As programs take it. */
void matrix_round(double from[4][4], float to[4][4]);

/* out = a * b; out is neither of them. */
void matrix_multiply(double a[4][4], double b[4][4], double out[4][4]);

/* Rotation about an axis of any length but 0, right-handed. */
void matrix_rotation(const double axis[3], double degrees, double m[4][4]);

/* Inverse of the upper left 3x3, transposed and times the determinant: what normals are multiplied
 * by. Works for singular matrices too. */
void matrix_normals(double m[4][4], double normals[3][3]);

/* Inverse by cofactors. Returns the determinant; 0 leaves inverse untouched. */
double matrix_inverse(double m[4][4], double inverse[4][4]);

#endif
