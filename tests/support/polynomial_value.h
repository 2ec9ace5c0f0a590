/* What a polynomial is at a place, in double precision. */
#ifndef TESTS_SUPPORT_POLYNOMIAL_VALUE_H
#define TESTS_SUPPORT_POLYNOMIAL_VALUE_H

#include "apps/base/polynomial.h"

static inline double polynomial_value(const Polynomial *p, const double place[3])
{
    double in_x = 0;
    for (int i = POLYNOMIAL_DEGREE; i >= 0; i--) {
        double in_y = 0;
        for (int j = POLYNOMIAL_DEGREE - i; j >= 0; j--) {
            double in_z = 0;
            for (int k = POLYNOMIAL_DEGREE - i - j; k >= 0; k--)
                in_z = in_z * place[2] + p->c[i][j][k];
            in_y = in_y * place[1] + in_z;
        }
        in_x = in_x * place[0] + in_y;
    }
    return in_x;
}

#endif
