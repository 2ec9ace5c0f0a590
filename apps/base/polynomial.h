/* Polynomials in x, y and z, from text. */
#ifndef APPS_BASE_POLYNOMIAL_H
#define APPS_BASE_POLYNOMIAL_H

#include "pipeline/base/base.h"

enum { POLYNOMIAL_DEGREE = 8, POLYNOMIAL_SIDE = POLYNOMIAL_DEGREE + 1 };

/* The sum of c[i][j][k] x^i y^j z^k; i + j + k is at most POLYNOMIAL_DEGREE. */
typedef struct Polynomial {
    double c[POLYNOMIAL_SIDE][POLYNOMIAL_SIDE][POLYNOMIAL_SIDE];
} Polynomial;

/* Reads text such as "x^4 - 5x^2 + 11.8", "(x^2 + 9/4 y^2 - 1)^3 = x^2 z^3": sums, products (with
 * or without *), quotients by numbers, whole powers, brackets. What stands right of = is taken
 * away.
 * errors GP_ERROR_INVALID, with the column, what was expected and what is there */
GpResult polynomial_parse(const char *text, Polynomial *polynomial, GpError *error);

#endif
