#include "apps/truth/mesh_paint.h"

static void find_direction(const double towards[4], const double place[3], double direction[3])
{
    for (int k = 0; k < 3; k++)
        direction[k] = towards[k] - towards[3] * place[k];
    vector_normalize(direction);
}

/* A colour, lit, at most 1. in/out color; normal: of any length but 0; comes back facing the eye */
static void shade(const TruthLight *light, const double place[3], double normal[3], double color[3])
{
    double towards[3], source[3], half[3];
    vector_normalize(normal);
    find_direction(light->eye, place, towards);
    find_direction(light->source, place, source);
    if (vector_dot(normal, towards) < 0)
        for (int k = 0; k < 3; k++)
            normal[k] = -normal[k];
    for (int k = 0; k < 3; k++)
        half[k] = source[k] + towards[k];
    vector_normalize(half);
    const double lambert = fmax(vector_dot(normal, source), 0);
    const double highlight = pow(fmax(vector_dot(normal, half), 0), light->shininess);
    for (int k = 0; k < 3; k++)
        color[k] = fmin(color[k] * (light->ambient[k] + light->diffuse[k] * lambert) +
                            light->specular[k] * highlight,
                        1);
}

/* A vector of the vertices at a place of a triangle. */
static void mix(const float *vertices, size_t width, const uint32_t *corner, const double share[3],
                double mixed[3])
{
    for (size_t k = 0; k < 3; k++) {
        mixed[k] = 0;
        for (int i = 0; i < 3; i++)
            mixed[k] += share[i] * (double)vertices[width * corner[i] + k];
    }
}

void mesh_paint_color(const void *context, uint32_t triangle, const double share[3],
                      double color[3])
{
    const MeshPaint *paint = context;
    const uint32_t *corner = paint->indices + 3 * (size_t)triangle;
    double place[3], normal[3];
    mix(paint->positions, 3, corner, share, place);
    if (paint->waves > 0)
        for (int k = 0; k < 3; k++)
            color[k] = 0.5 + 0.5 * sin(paint->waves * place[k]);
    else if (paint->color)
        for (int k = 0; k < 3; k++)
            color[k] = paint->color[k];
    else
        mix(paint->colors, 4, corner, share, color);
    if (!paint->light)
        return;
    mix(paint->normals, 3, corner, share, normal);
    shade(paint->light, place, normal, color);
}
