#include "apps/base/symmetric.h"

#include "apps/base/vector.h"

/* Where element (row, column) stands. */
static const int place[3][3] = { { 0, 5, 4 }, { 5, 1, 3 }, { 4, 3, 2 } };

/* --- moments ---------------------------------------------------------------------------------- */

Symmetric moments_covariance(const Moments *moments)
{
    Symmetric covariance;
    for (int row = 0; row < 3; row++)
        for (int column = row; column < 3; column++) {
            const double product = moments->sum[row] * moments->sum[column] / moments->count;
            const int at = place[row][column];
            covariance.m[at] = (moments->square.m[at] - product) / moments->count;
        }
    return covariance;
}

/* --- axes ------------------------------------------------------------------------------------- */

static Symmetric square_of(const Symmetric *a)
{
    const double *m = a->m;
    return (Symmetric){
        { m[0] * m[0] + m[5] * m[5] + m[4] * m[4], m[5] * m[5] + m[1] * m[1] + m[3] * m[3],
          m[4] * m[4] + m[3] * m[3] + m[2] * m[2], m[5] * m[4] + m[1] * m[3] + m[3] * m[2],
          m[0] * m[4] + m[5] * m[3] + m[4] * m[2], m[0] * m[5] + m[5] * m[1] + m[4] * m[3] }
    };
}

void symmetric_long_axis(const Symmetric *matrix, double axis[3])
{
    Symmetric power = *matrix;
    for (int i = 0; i < 7; i++) {
        const double trace = power.m[0] + power.m[1] + power.m[2];
        if (!(trace > 0)) {
            vector_set(axis, 1, 0, 0);
            return;
        }
        for (int k = 0; k < 6; k++)
            power.m[k] /= trace;
        if (i < 6)
            power = square_of(&power);
    }
    int longest = 0;
    for (int i = 1; i < 3; i++)
        if (power.m[i] > power.m[longest])
            longest = i;
    for (int i = 0; i < 3; i++)
        axis[i] = power.m[place[i][longest]];
    vector_normalize(axis);
}

/* Rotates rows and columns p and q so that element (p, q) becomes 0. */
static void rotate(double a[3][3], double vectors[3][3], int p, int q)
{
    if (a[p][q] == 0)
        return;
    const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double size = fabs(theta) + sqrt(theta * theta + 1);
    const double tangent = theta < 0 ? -1 / size : 1 / size;
    const double cosine = 1 / sqrt(tangent * tangent + 1), sine = tangent * cosine;
    const int other = 3 - p - q;
    const double shift = tangent * a[p][q];
    a[p][p] -= shift;
    a[q][q] += shift;
    a[p][q] = a[q][p] = 0;
    const double low = a[other][p], high = a[other][q];
    a[other][p] = a[p][other] = cosine * low - sine * high;
    a[other][q] = a[q][other] = sine * low + cosine * high;
    for (int i = 0; i < 3; i++) {
        const double x = vectors[p][i], y = vectors[q][i];
        vectors[p][i] = cosine * x - sine * y;
        vectors[q][i] = sine * x + cosine * y;
    }
}

void symmetric_eigen(const Symmetric *matrix, double values[3], double vectors[3][3])
{
    double a[3][3], rows[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    for (int i = 0; i < 9; i++)
        a[i / 3][i % 3] = matrix->m[place[i / 3][i % 3]];
    for (int sweep = 0; sweep < 16; sweep++) {
        const double off = fabs(a[0][1]) + fabs(a[0][2]) + fabs(a[1][2]);
        const double size = fabs(a[0][0]) + fabs(a[1][1]) + fabs(a[2][2]);
        if (size + off == size)
            break;
        rotate(a, rows, 0, 1);
        rotate(a, rows, 0, 2);
        rotate(a, rows, 1, 2);
    }
    int order[3] = { 0, 1, 2 };
    for (int i = 1; i < 3; i++)
        for (int k = i; k > 0 && a[order[k]][order[k]] > a[order[k - 1]][order[k - 1]]; k--) {
            const int swap = order[k];
            order[k] = order[k - 1];
            order[k - 1] = swap;
        }
    for (int i = 0; i < 3; i++) {
        values[i] = a[order[i]][order[i]];
        for (int k = 0; k < 3; k++)
            vectors[i][k] = rows[order[i]][k];
    }
    vector_cross(vectors[0], vectors[1], vectors[2]);
    vector_normalize(vectors[2]);
}
