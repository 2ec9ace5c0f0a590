#include "apps/base/camera.h"

#include <string.h>

void angle_sincos(double degrees, double *sine, double *cosine)
{
    double quarters = floor(degrees / 90.0 + 0.5);
    double x = (degrees - 90.0 * quarters) * (3.14159265358979323846 / 180.0);
    /* |x| <= pi/4, where the next term of either series is below 1e-17. */
    double s = 0.0, c = 0.0, x2 = x * x;
    for (int n = 19; n > 1; n -= 2) {
        s = (1.0 + s) * (-x2 / (n * (n - 1)));
        c = (1.0 + c) * (-x2 / ((n - 1) * (n - 2)));
    }
    s = x + x * s;
    c = 1.0 + c;
    const double turned[4] = { s, c, -s, -c };
    const int quarter = (int)(quarters - 4.0 * floor(quarters / 4.0));
    *sine = turned[quarter & 3];
    *cosine = turned[(quarter + 1) & 3];
}

void matrix_round(double from[4][4], float to[4][4])
{
    for (int i = 0; i < 16; i++)
        to[i / 4][i % 4] = (float)from[i / 4][i % 4];
}

void matrix_identity(double m[4][4])
{
    memset(m, 0, 16 * sizeof(double));
    for (int i = 0; i < 4; i++)
        m[i][i] = 1.0;
}

void matrix_multiply(double a[4][4], double b[4][4], double out[4][4])
{
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            out[i][j] =
                a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j] + a[i][3] * b[3][j];
}

void matrix_rotation(const double axis[3], double degrees, double m[4][4])
{
    double sine, cosine, a[3] = { axis[0], axis[1], axis[2] };
    angle_sincos(degrees, &sine, &cosine);
    vector_normalize(a);
    matrix_identity(m);
    /* Rodrigues: R = cos I + sin [a]x + (1 - cos) a a^T */
    const double cross[3][3] = { { 0, -a[2], a[1] }, { a[2], 0, -a[0] }, { -a[1], a[0], 0 } };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m[i][j] = (i == j ? cosine : 0.0) + sine * cross[i][j] + (1.0 - cosine) * a[i] * a[j];
}

void matrix_normals(double m[4][4], double normals[3][3])
{
    for (int i = 0; i < 3; i++) {
        /* Row i of the cofactors is the cross product of the two other rows. */
        vector_cross(m[(i + 1) % 3], m[(i + 2) % 3], normals[i]);
    }
}

/* Determinant of m without one row and one column. */
static double minor(double m[4][4], int row, int column)
{
    int r[3], c[3];
    for (int i = 0; i < 3; i++) {
        r[i] = i + (i >= row);
        c[i] = i + (i >= column);
    }
    return m[r[0]][c[0]] * (m[r[1]][c[1]] * m[r[2]][c[2]] - m[r[1]][c[2]] * m[r[2]][c[1]]) -
           m[r[0]][c[1]] * (m[r[1]][c[0]] * m[r[2]][c[2]] - m[r[1]][c[2]] * m[r[2]][c[0]]) +
           m[r[0]][c[2]] * (m[r[1]][c[0]] * m[r[2]][c[1]] - m[r[1]][c[1]] * m[r[2]][c[0]]);
}

double matrix_inverse(double m[4][4], double inverse[4][4])
{
    double determinant = 0.0;
    for (int j = 0; j < 4; j++)
        determinant += (j & 1 ? -1.0 : 1.0) * m[0][j] * minor(m, 0, j);
    if (determinant == 0.0)
        return 0.0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            inverse[j][i] = ((i + j) & 1 ? -1.0 : 1.0) * minor(m, i, j) / determinant;
    return determinant;
}

void camera_turn(Camera *camera, double degrees)
{
    double turn[4][4], from[3];
    if (degrees == 0.0)
        return;
    matrix_rotation(camera->up, degrees, turn);
    for (int i = 0; i < 3; i++)
        from[i] = camera->eye[i] - camera->at[i];
    for (int i = 0; i < 3; i++)
        camera->eye[i] = camera->at[i] + vector_dot(turn[i], from);
}

void camera_view(const Camera *camera, double view[4][4])
{
    double forward[3], right[3], up[3];
    vector_subtract(camera->at, camera->eye, forward);
    vector_normalize(forward);
    vector_cross(forward, camera->up, right);
    vector_normalize(right);
    vector_cross(right, forward, up);
    matrix_identity(view);
    for (int i = 0; i < 3; i++) {
        view[0][i] = right[i];
        view[1][i] = up[i];
        view[2][i] = -forward[i];
    }
    for (int i = 0; i < 3; i++)
        view[i][3] = -vector_dot(view[i], camera->eye);
}

void camera_projection(const Camera *camera, double aspect, double projection[4][4])
{
    double near = camera->near, far = camera->far;
    memset(projection, 0, 16 * sizeof(double));
    if (camera->fovy > 0.0) {
        double sine, cosine;
        angle_sincos(camera->fovy * 0.5, &sine, &cosine);
        projection[1][1] = cosine / sine;
        projection[2][2] = far / (near - far);
        projection[2][3] = near * far / (near - far);
        projection[3][2] = -1.0;
    } else {
        projection[1][1] = 2.0 / camera->height;
        projection[2][2] = 1.0 / (near - far);
        projection[2][3] = near / (near - far);
        projection[3][3] = 1.0;
    }
    projection[0][0] = projection[1][1] / aspect;
}

void camera_matrix(const Camera *camera, double aspect, float world_to_clip[4][4])
{
    double view[4][4], projection[4][4], product[4][4];
    camera_view(camera, view);
    camera_projection(camera, aspect, projection);
    matrix_multiply(projection, view, product);
    matrix_round(product, world_to_clip);
}

CameraAxes camera_axes(const Camera *camera, double aspect)
{
    double view[4][4], sine, cosine;
    CameraAxes axes;
    camera_view(camera, view);
    for (int k = 0; k < 3; k++) {
        axes.right[k] = view[0][k];
        axes.up[k] = view[1][k];
        axes.forward[k] = -view[2][k];
    }
    angle_sincos(camera->fovy / 2, &sine, &cosine);
    axes.half_height = camera->fovy > 0 ? sine / cosine : camera->height / 2;
    axes.half_width = axes.half_height * aspect;
    return axes;
}
