#include "apps/fragments/pieces/side.h"

#include <math.h>
#include <stdbool.h>

/* A sum of doubles that do not overlap, the least first. Differences of two floats have 2 terms,
 * the products of three such 2 * 4 * 4, and six of these make the determinant. */
enum { MAX_TERMS = 192 };

typedef struct Expansion {
    int count;
    double term[MAX_TERMS];
} Expansion;

/* high + low = a + b, exactly (Knuth). */
static void two_sum(double a, double b, double *high, double *low)
{
    const double sum = a + b, of_b = sum - a;
    *low = (a - (sum - of_b)) + (b - of_b);
    *high = sum;
}

/* high + low = a * b, exactly (Veltkamp, Dekker). */
static void two_product(double a, double b, double *high, double *low)
{
    const double splitter = 0x1p27 + 1, a_far = splitter * a, b_far = splitter * b;
    const double a_high = a_far - (a_far - a), a_low = a - a_high;
    const double b_high = b_far - (b_far - b), b_low = b - b_high;
    *high = a * b;
    *low = a_low * b_low - (((*high - a_high * b_high) - a_low * b_high) - a_high * b_low);
}

static void add_term(Expansion *e, double term)
{
    int count = 0;
    for (int i = 0; i < e->count; i++) {
        double low;
        two_sum(term, e->term[i], &term, &low);
        if (low != 0)
            e->term[count++] = low;
    }
    if (term != 0)
        e->term[count++] = term;
    e->count = count;
}

static Expansion difference(float a, float b)
{
    Expansion e = { 0, { 0 } };
    add_term(&e, (double)a);
    add_term(&e, -(double)b);
    return e;
}

static Expansion product(const Expansion *a, const Expansion *b)
{
    Expansion e = { 0, { 0 } };
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count; j++) {
            double high, low;
            two_product(a->term[i], b->term[j], &high, &low);
            add_term(&e, low);
            add_term(&e, high);
        }
    return e;
}

static int exact_side(const float a[3], const float b[3], const float c[3], const float p[3])
{
    Expansion u[3], v[3], w[3], sum = { 0, { 0 } };
    for (int k = 0; k < 3; k++) {
        u[k] = difference(b[k], a[k]);
        v[k] = difference(c[k], a[k]);
        w[k] = difference(p[k], a[k]);
    }
    for (int k = 0; k < 6; k++) {
        const int i = k % 3, other = k < 3 ? 1 : 2;
        const Expansion uv = product(&u[(i + other) % 3], &v[(i + 3 - other) % 3]);
        const Expansion term = product(&uv, &w[i]);
        for (int n = 0; n < term.count; n++)
            add_term(&sum, k < 3 ? term.term[n] : -term.term[n]);
    }
    const double last = sum.count ? sum.term[sum.count - 1] : 0;
    return (last > 0) - (last < 0);
}

static bool is_same(const float a[3], const float b[3])
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

int side_of_plane(const float a[3], const float b[3], const float c[3], const float p[3])
{
    if (is_same(p, a) || is_same(p, b) || is_same(p, c))
        return 0;
    const double error = 16 * 0x1p-53; /* more than the roundings below, of the terms' sum */
    double u[3], v[3], w[3], sum = 0, terms = 0;
    for (int k = 0; k < 3; k++) {
        u[k] = (double)b[k] - (double)a[k];
        v[k] = (double)c[k] - (double)a[k];
        w[k] = (double)p[k] - (double)a[k];
    }
    for (int i = 0; i < 3; i++) {
        const double one = u[(i + 1) % 3] * v[(i + 2) % 3], other = u[(i + 2) % 3] * v[(i + 1) % 3];
        sum += (one - other) * w[i];
        terms += (fabs(one) + fabs(other)) * fabs(w[i]);
    }
    /* Products of floats' differences do not get below what a double holds. */
    if (terms == 0 || fabs(sum) > error * terms)
        return (sum > 0) - (sum < 0);
    return exact_side(a, b, c, p);
}
