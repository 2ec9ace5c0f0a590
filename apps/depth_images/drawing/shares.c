#include "apps/depth_images/drawing/shares.h"

#include "apps/base/vector.h"

#include <string.h>

static const double two_pi = 0x1.921fb54442d18p+2;
static const double clearly = 1.05; /* times as many pixels, so that two images do not take turns */
static const double steepest = 3;   /* pixels that one pixel aside may be deeper, on one surface */

enum {
    SIDE = 2, /* squares of pixels that are asked for together */
    AROUND =
        8 /* pixels about a place that another image must have too: its cells there are whole */
};

static bool is_able(const DepthImage *image)
{
    return image->front.normal && (image->is_cylinder || image->plane.is_parallel);
}

/* From pixel to pixel, across and down, at a distance from the axis. */
static void spacing_of(const DepthImage *image, double radius, double spacing[2])
{
    const DepthPixels *pixels = &image->front;
    spacing[0] = (image->is_cylinder ? two_pi * radius : image->plane.width) / pixels->width;
    spacing[1] =
        (image->is_cylinder ? image->cylinder.height : image->plane.height) / pixels->height;
}

static void point_of(const DepthImage *image, double x, double y, double depth, double point[3])
{
    if (image->is_cylinder)
        depth_cylinder_point(&image->cylinder, &image->front, x, y, depth, point);
    else
        depth_plane_point(&image->plane, &image->front, x, y, depth, point);
}

/* Pixels for a unit of surface with a normal, as it is seen from outside. */
static double pixels_on(const DepthImage *image, const double point[3], const double normal[3])
{
    double out[3], spacing[2], radius = 1;
    for (int k = 0; k < 3; k++)
        out[k] = image->is_cylinder ? 0 : -image->plane.forward[k];
    if (image->is_cylinder) {
        const double *axis = image->cylinder.axis;
        vector_subtract(point, image->cylinder.center, out);
        vector_add_scaled(out, -vector_dot(out, axis), axis, out);
        radius = sqrt(vector_dot(out, out));
        vector_normalize(out);
    }
    spacing_of(image, radius, spacing);
    const double towards = vector_dot(out, normal);
    return towards > 0 && radius > 0 ? towards / (spacing[0] * spacing[1]) : 0;
}

static bool place_in(const DepthImage *image, const double point[3], double place[2], double *depth)
{
    return image->is_cylinder
               ? depth_cylinder_place(&image->cylinder, &image->front, point, place, depth)
               : depth_plane_place(&image->plane, &image->front, point, place, depth);
}

/* The depth of a pixel, columns of a cylinder counted around; what is outside shows nothing. */
static double depth_at(const DepthImage *image, int64_t x, int64_t y)
{
    const DepthPixels *pixels = &image->front;
    const int64_t width = pixels->width;
    if (image->is_cylinder)
        x = (x + width) % width;
    return x >= 0 && x < width && y >= 0 && y < pixels->height
               ? (double)pixels->depth[y * width + x]
               : (double)DEPTH_NOTHING;
}

/* Whether another image has a point, and all about it, on one surface. */
static bool is_shown(const DepthImage *image, const double point[3])
{
    double place[2], depth, spacing[2];
    if (!place_in(image, point, place, &depth))
        return false;
    const int64_t x = (int64_t)floor(place[0]), y = (int64_t)floor(place[1]);
    spacing_of(image, image->is_cylinder ? image->cylinder.radius - depth : 1, spacing);
    const double wide = steepest * fmax(spacing[0], spacing[1]);
    for (int i = 0; i < 9; i++) {
        const int64_t across = (i % 3 - 1) * AROUND, down = (i / 3 - 1) * AROUND;
        const double found = depth_at(image, x + across, y + down);
        if (!(fabs(found - depth) <= (across || down ? wide * AROUND : wide)))
            return false;
    }
    return true;
}

static bool is_others(const DepthModel *model, uint32_t image, const double point[3],
                      const double normal[3])
{
    const double own = pixels_on(&model->images[image], point, normal);
    for (uint32_t i = 0; i < model->count; i++) {
        const DepthImage *other = &model->images[i];
        if (i != image && is_able(other) && pixels_on(other, point, normal) > clearly * own &&
            is_shown(other, point))
            return true;
    }
    return false;
}

GpResult shares_find(const DepthModel *model, uint32_t image, uint8_t **own)
{
    const DepthImage *from = &model->images[image];
    const DepthPixels *pixels = &from->front;
    uint8_t *made = gp_alloc((size_t)pixels->width * pixels->height, 1);
    if (!made)
        return GP_ERROR_MEMORY;
    for (uint32_t y = 0; y < pixels->height; y++)
        for (uint32_t x = 0; x < pixels->width; x++) {
            const size_t at = (size_t)y * pixels->width + x;
            const uint8_t *first = &made[at - y % SIDE * pixels->width - x % SIDE];
            const double depth = (double)pixels->depth[at];
            double point[3], normal[3];
            if (!isfinite(depth))
                continue;
            made[at] = 1;
            if (!is_able(from))
                continue;
            if (first != &made[at] && isfinite(pixels->depth[first - made])) {
                made[at] = *first;
                continue;
            }
            point_of(from, x + 0.5, y + 0.5, depth, point);
            for (int k = 0; k < 3; k++)
                normal[k] = (double)pixels->normal[3 * at + (size_t)k];
            made[at] = !is_others(model, image, point, normal);
        }
    *own = made;
    return GP_OK;
}

/* --- sums ------------------------------------------------------------------------------------- */

/* Whether an image has something of its own within a step of a point. */
static bool has_own(const DepthImage *image, const uint8_t *own, int64_t x, int64_t y, int64_t step)
{
    const int64_t width = image->front.width, height = image->front.height;
    for (int64_t v = y - step < 0 ? 0 : y - step; v <= y + step && v < height; v++)
        for (int64_t u = x - step; u <= x + step; u++) {
            const int64_t column = image->is_cylinder ? (u + width) % width : u;
            if (column >= 0 && column < width && own[v * width + column])
                return true;
        }
    return false;
}

GpResult shares_sum(const DepthImage *image, const uint8_t *own, uint32_t step, uint32_t columns,
                    uint32_t rows, uint32_t **sums)
{
    const size_t stride = columns + 1;
    uint32_t *made = gp_alloc(stride * (rows + 1), sizeof *made);
    if (!made)
        return GP_ERROR_MEMORY;
    for (uint32_t y = 0; y < rows; y++)
        for (uint32_t x = 0; x < columns; x++) {
            const size_t at = (y + 1) * stride + x + 1;
            made[at] = made[at - 1] + made[at - stride] - made[at - stride - 1] +
                       has_own(image, own, (int64_t)x * step, (int64_t)y * step, step);
        }
    *sums = made;
    return GP_OK;
}
