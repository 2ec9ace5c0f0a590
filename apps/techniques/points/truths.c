#include "apps/techniques/points/truths.h"

#include <math.h>

/* --- the mesh --------------------------------------------------------------------------------- */

GpResult points_truth_find(const GpMesh *mesh, const uint8_t *color, const SplatView *view,
                           GpPool *pool, MeshPicture *truth)
{
    const SplatLight beside = splat_light(view);
    TruthLight light = { .shininess = beside.shininess };
    double all[3] = { 0 };
    for (int k = 0; k < 3; k++) {
        light.eye[k] = view->camera.eye[k];
        light.source[k] = beside.towards[k];
        light.ambient[k] = beside.ambient;
        light.diffuse[k] = 1 - beside.ambient;
        light.specular[k] = beside.specular;
        all[k] = color ? color[k] / 255.0 : 0;
    }
    light.eye[3] = 1;
    const MeshPaint paint = { .positions = mesh->positions,
                              .normals = mesh->normals,
                              .colors = mesh->colors,
                              .indices = mesh->indices,
                              .color = color ? all : NULL,
                              .waves = view->waves,
                              .light = view->lit ? &light : NULL };
    const MeshPictureScene scene = { .positions = mesh->positions,
                                     .stride = 3 * sizeof *mesh->positions,
                                     .indices = mesh->indices,
                                     .triangle_count = mesh->triangle_count,
                                     .camera = view->camera,
                                     .width = view->width,
                                     .height = view->height,
                                     .samples = 8,
                                     .color = mesh_paint_color,
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
