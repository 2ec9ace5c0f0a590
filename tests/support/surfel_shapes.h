/* Surfels of shapes whose truth is known, for tests. */
#ifndef TESTS_SURFEL_SHAPES_H
#define TESTS_SURFEL_SHAPES_H

#include "apps/base/camera.h"
#include "apps/points/surfels.h"
#include "tests/support/random.h"

/* One surfel, colours by place. */
static inline Surfel shape_surfel(const double position[3], const double normal[3], double radius,
                                  double area)
{
    Surfel surfel = { .radius = (float)radius, .share = surfel_share(area, radius) };
    for (int i = 0; i < 3; i++) {
        surfel.position[i] = (float)position[i];
        surfel.normal[i] = (float)normal[i];
        surfel.color[i] = (uint8_t)(int)(127.5 + 127 * (position[i] < -1  ? -1
                                                        : position[i] > 1 ? 1
                                                                          : position[i]));
    }
    return surfel;
}

/* A spiral around a ball of radius 1 that gives each surfel the same area, in a shuffled order. */
static inline void shape_sphere(Surfels *sphere, uint32_t count)
{
    Random random = { count };
    if (surfels_alloc(sphere, count))
        return;
    const double area = 12.566370614359172 / count, radius = 0.8 * sqrt(area);
    for (uint32_t i = 0; i < count; i++) {
        double sine, cosine, z = 1 - (2 * i + 1.0) / count, across = sqrt(1 - z * z);
        angle_sincos(137.50776405003785 * (i % 100000) + 2.0 * (i / 100000), &sine, &cosine);
        const double at[3] = { across * cosine, across * sine, z };
        const uint32_t place = (uint32_t)random_int(&random, 0, (int32_t)i);
        sphere->surfels[i] = sphere->surfels[place];
        sphere->surfels[place] = shape_surfel(at, at, radius, area);
    }
    sphere->had_normals = sphere->had_radii = sphere->had_colors = true;
}

/* A ring of radius 1 whose tube has radius `tube`, by random places. */
static inline void shape_torus(Surfels *torus, uint32_t count, double tube)
{
    Random random = { count };
    if (surfels_alloc(torus, count))
        return;
    const double area = 39.47841760435743 * tube / count, radius = 1.5 * sqrt(area);
    for (uint32_t i = 0; i < count; i++) {
        double s[2], c[2];
        angle_sincos((double)random_float(&random, 0, 360), &s[0], &c[0]);
        angle_sincos((double)random_float(&random, 0, 360), &s[1], &c[1]);
        const double out = 1 + tube * c[1];
        torus->surfels[i] =
            shape_surfel((double[3]){ out * c[0], out * s[0], tube * s[1] },
                         (double[3]){ c[1] * c[0], c[1] * s[0], s[1] }, radius, area);
    }
    torus->had_normals = torus->had_radii = torus->had_colors = true;
}

/* Places, normals, radii and colours by chance: nothing holds together. */
static inline void shape_dust(Surfels *dust, uint32_t count, uint64_t seed)
{
    Random random = { seed };
    if (surfels_alloc(dust, count))
        return;
    for (uint32_t i = 0; i < count; i++) {
        double at[3], normal[3], length;
        do {
            for (int k = 0; k < 3; k++) {
                at[k] = (double)random_float(&random, -1, 1);
                normal[k] = (double)random_float(&random, -1, 1);
            }
            length = sqrt(vector_dot(normal, normal));
        } while (length < 0.1);
        vector_normalize(normal);
        const double radius = (double)random_float(&random, 0.001f, 0.1f);
        dust->surfels[i] = shape_surfel(at, normal, radius, radius * radius);
    }
    dust->had_normals = dust->had_radii = dust->had_colors = true;
}

#endif
