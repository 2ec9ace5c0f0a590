#include "apps/depth_images/drawing/detail.h"

#include "apps/base/stable_math.h"
#include "apps/base/vector.h"
#include "apps/depth_images/drawing/surface_grid.h"

static double repeats_of(const WarpDetail *detail, int axis)
{
    return detail->repeats[axis] > 0 ? detail->repeats[axis] : 1;
}

/* At which there is a texel for a vertex, or less. */
static double level_for(const WarpDetail *detail, const DepthPixels *pixels, uint32_t step)
{
    if (!detail->heights || !detail->is_smooth)
        return 0;
    const double across = detail->heights->width * repeats_of(detail, 0) / pixels->width,
                 down = detail->heights->height * repeats_of(detail, 1) / pixels->height;
    const double level = ceil(stable_log(fmax(across, down) * step) / stable_log(2) - 0.25);
    return fmin(fmax(level, 0), detail->heights->levels - 1.0);
}

WarpDetailUniforms warp_detail_uniforms(const WarpDetail *detail, const DepthPixels *pixels,
                                        uint32_t step)
{
    return (WarpDetailUniforms){
        .repeats = { (float)repeats_of(detail, 0), (float)repeats_of(detail, 1) },
        .height = (float)detail->amplitude,
        .level = (float)level_for(detail, pixels, step),
    };
}

GpTexture warp_detail_texture(const WarpDetail *detail)
{
    const GpFilter filter = detail->is_smooth ? GP_LINEAR : GP_POINT;
    return (GpTexture){
        detail->heights,
        { .min = filter, .mag = filter, .mip = detail->is_smooth ? GP_MIP_POINT : GP_MIP_NONE }
    };
}

/* --- normals ---------------------------------------------------------------------------------- */

/* A row or a column of a level, and the one behind it. */
static void texels_at(double at, uint32_t size, uint32_t texel[2], double *share)
{
    const double place = (at - floor(at)) * size - 0.5, first = floor(place);
    *share = place - first;
    for (int i = 0; i < 2; i++)
        texel[i] = (uint32_t)((int64_t)first + i + size) % size;
}

/* As the vertex shader reads it. in  rgba: [height][width][4] of the level */
static double height_at(const WarpDetail *detail, const GpLevel *level, const float *rgba, double u,
                        double v)
{
    uint32_t x[2], y[2];
    double share[2], row[2];
    texels_at(u * repeats_of(detail, 0), level->width, x, &share[0]);
    texels_at(v * repeats_of(detail, 1), level->height, y, &share[1]);
    for (int i = 0; i < 2; i++) {
        const float *texels = rgba + 4 * (size_t)y[i] * level->width;
        row[i] = (double)texels[4 * (size_t)x[0]] * (1 - share[0]) +
                 (double)texels[4 * (size_t)x[1]] * share[0];
    }
    return row[0] * (1 - share[1]) + row[1] * share[1];
}

/* Depths of a layer under the relief, a copy. */
static GpResult raise(const DepthPixels *pixels, const WarpDetail *detail, float *depth,
                      GpError *error)
{
    const uint32_t number = (uint32_t)level_for(detail, pixels, 1);
    const GpLevel *level = &detail->heights->level[number];
    float *rgba = gp_alloc((size_t)level->width * level->height, 4 * sizeof *rgba);
    if (!rgba)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    const GpResult result = gp_surface_read_floats(detail->heights, number, NULL, rgba, error);
    for (size_t i = 0; i < (size_t)pixels->width * pixels->height && !result; i++) {
        const double u = ((double)(i % pixels->width) + 0.5) / pixels->width,
                     v = ((double)(i / pixels->width) + 0.5) / pixels->height;
        depth[i] = (float)((double)pixels->depth[i] -
                           detail->amplitude * height_at(detail, level, rgba, u, v));
    }
    gp_free(rgba);
    return result;
}

/* in  before, after: normals of points without the relief, and with it */
static void lean(const float *before, const float *after, DepthPixels *pixels)
{
    for (size_t i = 0; i < 3 * (size_t)pixels->width * pixels->height; i += 3) {
        float *own = pixels->normal + i;
        double leaned[3], side = 0;
        for (size_t k = 0; k < 3; k++)
            side += (double)own[k] * (double)before[i + k];
        for (size_t k = 0; k < 3; k++) /* of backs it goes in: points know outsides only */
            leaned[k] = (double)own[k] +
                        (side < 0 ? -1 : 1) * ((double)after[i + k] - (double)before[i + k]);
        vector_normalize(leaned);
        for (size_t k = 0; k < 3; k++)
            own[k] = (float)leaned[k];
    }
}

GpResult warp_detail_lean(const DepthImage *image, DepthPixels *pixels, const WarpDetail *detail,
                          GpError *error)
{
    static const double cut = 4; /* as of surfaces: relief is no jump */
    DepthImage raised = *image;
    float *depth = gp_alloc((size_t)pixels->width * pixels->height, sizeof *depth);
    float *before = NULL, *after = NULL;
    GpResult result = depth ? raise(pixels, detail, depth, error)
                            : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    raised.front = *pixels;
    if (!result)
        result = surface_grid_normals(&raised, cut, &before, error);
    raised.front.depth = depth;
    if (!result)
        result = surface_grid_normals(&raised, cut, &after, error);
    if (!result)
        lean(before, after, pixels);
    gp_free(before);
    gp_free(after);
    gp_free(depth);
    return result;
}
