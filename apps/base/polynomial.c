#include "apps/base/polynomial.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_DEPTH = 32, MAX_POWER = 99 };

/* --- arithmetic ------------------------------------------------------------------------------- */

static Polynomial number(double value)
{
    return (Polynomial){ .c[0][0][0] = value };
}

static void add(Polynomial *a, const Polynomial *b, double times)
{
    for (int i = 0; i < POLYNOMIAL_SIDE; i++)
        for (int j = 0; j + i < POLYNOMIAL_SIDE; j++)
            for (int k = 0; k + j + i < POLYNOMIAL_SIDE; k++)
                a->c[i][j][k] += times * b->c[i][j][k];
}

/* a += value x^i y^j z^k * b; false where the degree grows too high. */
static bool add_shifted(Polynomial *a, const Polynomial *b, double value, int i, int j, int k)
{
    for (int u = 0; u < POLYNOMIAL_SIDE; u++)
        for (int v = 0; v + u < POLYNOMIAL_SIDE; v++)
            for (int w = 0; w + v + u < POLYNOMIAL_SIDE; w++) {
                if (b->c[u][v][w] == 0)
                    continue;
                if (i + j + k + u + v + w > POLYNOMIAL_DEGREE)
                    return false;
                a->c[i + u][j + v][k + w] += value * b->c[u][v][w];
            }
    return true;
}

static bool multiply(Polynomial *a, const Polynomial *b)
{
    Polynomial product = number(0);
    for (int i = 0; i < POLYNOMIAL_SIDE; i++)
        for (int j = 0; j + i < POLYNOMIAL_SIDE; j++)
            for (int k = 0; k + j + i < POLYNOMIAL_SIDE; k++)
                if (a->c[i][j][k] != 0 && !add_shifted(&product, b, a->c[i][j][k], i, j, k))
                    return false;
    *a = product;
    return true;
}

static bool is_number(const Polynomial *p)
{
    Polynomial other = *p;
    other.c[0][0][0] = 0;
    for (const double *c = &other.c[0][0][0]; c < &other.c[0][0][0] + sizeof other / sizeof *c; c++)
        if (*c != 0)
            return false;
    return true;
}

/* --- text ------------------------------------------------------------------------------------- */

typedef struct Reader {
    const char *text, *at;
    int depth; /* brackets that are open */
    GpError *error;
} Reader;

static char next(Reader *r)
{
    while (isspace((unsigned char)*r->at))
        r->at++;
    return *r->at;
}

static bool take(Reader *r, char c)
{
    const bool there = next(r) == c;
    r->at += there;
    return there;
}

static GpResult refuse_at(const Reader *r, const char *at, const char *what)
{
    return gp_fail(r->error, GP_ERROR_INVALID, "column %d: %s", (int)(at - r->text) + 1, what);
}

static GpResult expected(Reader *r, const char *what)
{
    const char c = next(r);
    const int column = (int)(r->at - r->text) + 1;
    if (!c)
        return gp_fail(r->error, GP_ERROR_INVALID, "column %d: expected %s, but the text ends",
                       column, what);
    return gp_fail(r->error, GP_ERROR_INVALID, "column %d: expected %s, found '%c'", column, what,
                   isprint((unsigned char)c) ? c : '?');
}

static GpResult too_high(const Reader *r, const char *at)
{
    return gp_fail(r->error, GP_ERROR_INVALID, "column %d: the degree is above %d",
                   (int)(at - r->text) + 1, POLYNOMIAL_DEGREE);
}

static bool begins_factor(char c)
{
    return isdigit((unsigned char)c) || c == '.' || (c >= 'x' && c <= 'z') || c == '(';
}

/* 0x is 0 times x, where strtod would read a hexadecimal number. */
static GpResult read_number(Reader *r, Polynomial *p)
{
    const char *begin = r->at;
    char *end = NULL;
    double value = begin[0] == '0' && begin[1] == 'x' ? 0 : strtod(begin, &end);
    r->at = end ? end : begin + 1;
    if (r->at == begin)
        return expected(r, "a digit");
    if (!isfinite((float)value))
        return refuse_at(r, begin, "a number that is too large");
    *p = number(value);
    return GP_OK;
}

static GpResult read_sum(Reader *r, Polynomial *p);

static GpResult read_factor(Reader *r, Polynomial *p)
{
    const char c = next(r), *begin = r->at;
    if (isdigit((unsigned char)c) || c == '.')
        return read_number(r, p);
    if (c >= 'x' && c <= 'z') {
        r->at++;
        *p = number(0);
        p->c[c == 'x'][c == 'y'][c == 'z'] = 1;
        return GP_OK;
    }
    if (!take(r, '('))
        return expected(r, "a number, x, y, z or (");
    if (++r->depth > MAX_DEPTH)
        return refuse_at(r, begin, "too many brackets in brackets");
    GpResult result = read_sum(r, p);
    r->depth--;
    if (result == GP_OK && !take(r, ')'))
        return expected(r, "+, - or )");
    return result;
}

static GpResult read_power(Reader *r, Polynomial *p)
{
    next(r);
    const char *begin = r->at;
    GpResult result = read_factor(r, p);
    if (result || !take(r, '^'))
        return result;
    if (!isdigit((unsigned char)next(r)))
        return expected(r, "a whole number");
    const Polynomial base = *p;
    int power = 0;
    for (; isdigit((unsigned char)*r->at) && power <= MAX_POWER; r->at++)
        power = 10 * power + (*r->at - '0');
    if (power > MAX_POWER)
        return refuse_at(r, begin, "a power that is too high");
    *p = number(1);
    for (; power; power--)
        if (!multiply(p, &base))
            return too_high(r, begin);
    return GP_OK;
}

static GpResult read_product(Reader *r, Polynomial *p)
{
    GpResult result = read_power(r, p);
    while (result == GP_OK) {
        const bool divide = take(r, '/');
        if (!divide && !take(r, '*') && !begins_factor(next(r)))
            break;
        Polynomial factor;
        next(r);
        const char *begin = r->at;
        result = read_power(r, &factor);
        if (result)
            break;
        if (divide && !is_number(&factor))
            return refuse_at(r, begin, "only numbers can divide");
        if (divide && factor.c[0][0][0] == 0)
            return refuse_at(r, begin, "division by 0");
        if (divide)
            factor = number(1 / factor.c[0][0][0]);
        if (!multiply(p, &factor))
            return too_high(r, begin);
    }
    return result;
}

static GpResult read_sum(Reader *r, Polynomial *p)
{
    *p = number(0);
    bool minus = take(r, '-');
    if (!minus)
        take(r, '+');
    for (;;) {
        Polynomial term;
        GpResult result = read_product(r, &term);
        if (result)
            return result;
        add(p, &term, minus ? -1 : 1);
        minus = take(r, '-');
        if (!minus && !take(r, '+'))
            return GP_OK;
    }
}

static GpResult check_range(const Reader *r, const Polynomial *p)
{
    if (is_number(p))
        return gp_fail(r->error, GP_ERROR_INVALID, "'%.60s': no x, y or z is left", r->text);
    for (const double *c = &p->c[0][0][0]; c < &p->c[0][0][0] + sizeof *p / sizeof *c; c++)
        if (!isfinite((float)*c))
            return gp_fail(r->error, GP_ERROR_INVALID, "'%.60s': a factor is too large", r->text);
    return GP_OK;
}

GpResult polynomial_parse(const char *text, Polynomial *polynomial, GpError *error)
{
    Reader r = { .text = text, .at = text, .error = error };
    Polynomial left, right = number(0);
    GpResult result = read_sum(&r, &left);
    if (result == GP_OK && take(&r, '='))
        result = read_sum(&r, &right);
    if (result == GP_OK && next(&r))
        result = expected(&r, "+, -, *, /, ^ or =");
    if (result)
        return result;
    add(&left, &right, -1);
    result = check_range(&r, &left);
    if (result == GP_OK)
        *polynomial = left;
    return result;
}
