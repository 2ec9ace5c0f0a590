#include "apps/volumes/builtin.h"

#include "apps/base/camera.h"

#include <math.h>
#include <string.h>

enum { MAX_SIDE = 1024 };

/* Fills the samples of a field whose size is set; n: the side that was asked for. */
typedef void FillFn(Field *field, uint32_t n);

/* Where a sample lies from -1 to 1; one alone in the middle. */
static double across(uint32_t i, uint32_t n)
{
    return n > 1 ? 2.0 * i / (n - 1) - 1 : 0;
}

static uint8_t to_byte(double value)
{
    return (uint8_t)(value * 255 + 0.5);
}

/* (1 - sin(pi z / 2) + alpha (1 + cos(2 pi fM cos(pi r / 2)))) / (2 (1 + alpha)) */
static void marschner_lobb(Field *field, uint32_t n)
{
    const double frequency = 6, alpha = 0.25;
    double sine, cosine;
    for (uint32_t i = 0; i < n * n; i++) {
        const double x = across(i % n, n), y = across(i / n, n);
        angle_sincos(90 * sqrt(x * x + y * y), &sine, &cosine);
        angle_sincos(360 * frequency * cosine, &sine, &cosine);
        const double wave = alpha * (1 + cosine);
        for (uint32_t z = 0; z < n; z++) {
            angle_sincos(90 * across(z, n), &sine, &cosine);
            field->value[(size_t)z * n * n + i] = to_byte((1 - sine + wave) / (2 * (1 + alpha)));
        }
    }
}

static void checkerboard(Field *field, uint32_t n)
{
    for (uint32_t i = 0; i < n * n; i++) {
        const uint8_t value = (i % n / 16 + i / n / 16) % 2 ? 170 : 85;
        for (uint32_t z = 0; z < field->size[2]; z++)
            field->value[(size_t)z * n * n + i] = value;
    }
}

static void ball(Field *field, uint32_t n)
{
    const double middle = (n - 1) / 2.0, radius = 0.4 * (n - 1), edge = 4;
    for (size_t i = 0; i < field_samples(field); i++) {
        const double x = (double)(i % n) - middle, y = (double)(i / n % n) - middle,
                     z = (double)(i / n / n) - middle;
        const double inside = (radius - sqrt(x * x + y * y + z * z)) / edge + 0.5;
        field->value[i] = to_byte(inside < 0 ? 0 : inside > 1 ? 1 : inside);
    }
}

static const struct {
    uint32_t side, depth; /* without N; depth 0: as the side */
    FillFn *fill;
} kinds[] = { { 256, 0, marschner_lobb }, { 512, 3, checkerboard }, { 128, 0, ball } };

const char *const builtin_field_names[] = { "marschner-lobb", "checkerboard", "ball", NULL };

/* Digits alone; 0: no such side. */
static uint32_t side_of(const char *text)
{
    uint32_t side = 0;
    for (; *text >= '0' && *text <= '9' && side <= MAX_SIDE; text++)
        side = side * 10 + (uint32_t)(*text - '0');
    return *text == '\0' && side <= MAX_SIDE ? side : 0;
}

GpResult builtin_field(const char *name, Field *field, GpError *error)
{
    const char *colon = strchr(name, ':');
    const size_t length = colon ? (size_t)(colon - name) : strlen(name);
    size_t kind = 0;
    while (builtin_field_names[kind] && (strlen(builtin_field_names[kind]) != length ||
                                         memcmp(builtin_field_names[kind], name, length) != 0))
        kind++;
    if (!builtin_field_names[kind])
        return gp_fail(error, GP_ERROR_INVALID,
                       "no builtin volume '%.40s': expected marschner-lobb, checkerboard or ball",
                       name);
    const uint32_t n = colon ? side_of(colon + 1) : kinds[kind].side;
    if (n == 0)
        return gp_fail(error, GP_ERROR_INVALID,
                       "builtin:%.60s: expected %s:N with N of 1 to %d samples", name,
                       builtin_field_names[kind], MAX_SIDE);
    Field made = { .size = { n, n, kinds[kind].depth ? kinds[kind].depth : n },
                   .scale = { 1, 1, 1 },
                   .most = FIELD_VALUES - 1 };
    made.value = gp_alloc_unset(field_samples(&made));
    if (!made.value)
        return gp_fail(error, GP_ERROR_MEMORY, "builtin:%.60s: no memory", name);
    kinds[kind].fill(&made, n);
    *field = made;
    return GP_OK;
}
