#include "apps/techniques/points/truths.h"

#include <math.h>

/* --- the mesh --------------------------------------------------------------------------------- */

typedef struct Paint {
    const GpMesh *mesh;
    const SplatView *view;
    const uint8_t *color; /* of all points; NULL: the vertices' own */
    SplatLight light;
} Paint;

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

/* As the program that shades does it (shaders_c/points/normalize.c), in double. */
static void shade(const Paint *paint, const double place[3], double normal[3], double color[3])
{
    const SplatLight *light = &paint->light;
    double towards[3], half[3];
    vector_normalize(normal);
    vector_subtract(paint->view->camera.eye, place, towards);
    vector_normalize(towards);
    if (vector_dot(normal, towards) < 0)
        for (int k = 0; k < 3; k++)
            normal[k] = -normal[k];
    for (int k = 0; k < 3; k++)
        half[k] = light->towards[k] + towards[k];
    vector_normalize(half);
    const double lambert = fmax(vector_dot(normal, light->towards), 0);
    const double highlight = pow(fmax(vector_dot(normal, half), 0), light->shininess);
    for (int k = 0; k < 3; k++)
        color[k] = fmin(color[k] * (light->ambient + (1 - light->ambient) * lambert) +
                            light->specular * highlight,
                        1);
}

static void color_of(const void *context, uint32_t triangle, const double share[3], double color[3])
{
    const Paint *paint = context;
    const GpMesh *mesh = paint->mesh;
    const uint32_t *corner = mesh->indices + 3 * (size_t)triangle;
    double place[3], normal[3];
    mix(mesh->positions, 3, corner, share, place);
    if (paint->view->waves > 0)
        for (int k = 0; k < 3; k++)
            color[k] = 0.5 + 0.5 * sin(paint->view->waves * place[k]);
    else if (paint->color)
        for (int k = 0; k < 3; k++)
            color[k] = paint->color[k] / 255.0;
    else
        mix(mesh->colors, 4, corner, share, color);
    if (!paint->view->lit)
        return;
    mix(mesh->normals, 3, corner, share, normal);
    shade(paint, place, normal, color);
}

GpResult points_truth_find(const GpMesh *mesh, const uint8_t *color, const SplatView *view,
                           GpPool *pool, MeshPicture *truth)
{
    const Paint paint = { mesh, view, color, splat_light(view) };
    const MeshPictureScene scene = { .positions = mesh->positions,
                                     .stride = 3 * sizeof *mesh->positions,
                                     .indices = mesh->indices,
                                     .triangle_count = mesh->triangle_count,
                                     .camera = view->camera,
                                     .width = view->width,
                                     .height = view->height,
                                     .samples = 8,
                                     .color = color_of,
                                     .context = &paint };
    return mesh_picture_make(&scene, pool, truth);
}

/* --- errors ----------------------------------------------------------------------------------- */

/* How far a texel of A8R8G8B8 is above the truth: red, green, blue. */
static void texel_off(const MeshPicture *truth, size_t at, const uint8_t *texel, double off[3])
{
    for (int k = 0; k < 3; k++)
        off[k] = texel[2 - k] / 255.0 - truth->color[3 * at + (size_t)k];
}

/* The value that all but a thousandth of the errors are below. */
static double find_largest(const uint64_t histogram[256], double count)
{
    double above = 0;
    int code = 255;
    while (code > 0 && (above += (double)histogram[code]) <= count / 1000)
        code--;
    return (code + 1) / 255.0;
}

PointsError points_error(const MeshPicture *truth, const GpSurface *picture)
{
    const uint32_t full = truth->samples * truth->samples;
    PointsError error = { .holes = 0 };
    double square = 0, count = 0, alphas = 0, off[3];
    uint64_t histogram[256] = { 0 };
    for (uint32_t y = 0; y < truth->height; y++)
        for (uint32_t x = 0; x < truth->width; x++) {
            const size_t at = (size_t)y * truth->width + x;
            const uint8_t *texel = picture->level[0].texels + 4 * at;
            error.covered += (double)truth->covered[at] / full;
            alphas += texel[3] / 255.0;
            if (!mesh_picture_is_interior(truth, x, y))
                continue;
            error.holes += texel[3] == 0;
            texel_off(truth, at, texel, off);
            for (int k = 0; k < 3; k++) {
                square += off[k] * off[k];
                histogram[(int)(fmin(fabs(off[k]), 1) * 255)]++;
            }
            count += 3;
        }
    error.rmse = sqrt(square / fmax(count, 1));
    error.interior_psnr = -20 * log10(fmax(error.rmse, 1e-9));
    error.area_error = error.covered > 0 ? alphas / error.covered - 1 : 0;
    error.largest = find_largest(histogram, count);
    return error;
}

void points_difference(const MeshPicture *truth, const GpSurface *picture, float *off)
{
    for (uint32_t y = 0; y < truth->height; y++)
        for (uint32_t x = 0; x < truth->width; x++) {
            const size_t at = (size_t)y * truth->width + x;
            double each[3] = { 0, 0, 0 };
            if (mesh_picture_is_interior(truth, x, y))
                texel_off(truth, at, picture->level[0].texels + 4 * at, each);
            off[at] = (float)((each[0] + each[1] + each[2]) / 3);
        }
}
