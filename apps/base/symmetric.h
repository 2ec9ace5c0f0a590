/* Symmetric 3x3 matrices: spreads of points, and their axes. In double, + - * / and square roots
 * only, so that the bits are the same everywhere. */
#ifndef APPS_BASE_SYMMETRIC_H
#define APPS_BASE_SYMMETRIC_H

#include <stddef.h>
#include <stdint.h>

/* xx, yy, zz, yz, xz, xy */
typedef struct Symmetric {
    double m[6];
} Symmetric;

/* Sums over points, from which their mean and spread follow; of two sets: those of all. */
typedef struct Moments {
    double count, sum[3];
    double origin[3]; /* which points are taken from, so that nothing cancels far from 0 */
    Symmetric square;
} Moments;

static inline void moments_add(Moments *moments, const float point[3])
{
    double d[3];
    for (int i = 0; i < 3; i++) {
        d[i] = (double)point[i] - moments->origin[i];
        moments->sum[i] += d[i];
        moments->square.m[i] += d[i] * d[i];
    }
    moments->count += 1;
    moments->square.m[3] += d[1] * d[2];
    moments->square.m[4] += d[0] * d[2];
    moments->square.m[5] += d[0] * d[1];
}

/* Of at least one point. */
Symmetric moments_covariance(const Moments *moments);

/* A direction of about the largest spread, unit length; x where there is none. Much quicker than
 * all eigenvectors: the matrix to its 64th power, whose largest column is one but for the 64th
 * power of the ratio of the two largest eigenvalues. */
void symmetric_long_axis(const Symmetric *matrix, double axis[3]);

/* Eigenvalues, largest first, and their vectors: orthonormal, right-handed.
 * source cyclic Jacobi rotations (Golub and Van Loan, "Matrix computations", 8.5), until what is
 *        off the diagonal is 0 in double, or 16 sweeps */
void symmetric_eigen(const Symmetric *matrix, double values[3], double vectors[3][3]);

#endif
