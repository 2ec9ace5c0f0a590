#include "apps/depth_images/making/height_map.h"

#include "apps/base/vector.h"
#include "apps/depth_images/drawing/surface_grid.h"
#include "apps/frame/picture.h"

/* Those of `count` samples that pixel `at` of `pixels` stands for: at least one. */
static void samples_of(uint32_t at, uint32_t pixels, uint32_t count, uint32_t *first, uint32_t *end)
{
    *first = (uint32_t)((uint64_t)at * count / pixels);
    *end = (uint32_t)((uint64_t)(at + 1) * count / pixels);
    *end = *end > *first ? *end : *first + 1;
}

/* The mean of the colours that lie on each pixel. */
static void take_colors(const Picture *color, DepthPixels *pixels)
{
    for (uint32_t y = 0; y < pixels->height; y++)
        for (uint32_t x = 0; x < pixels->width; x++) {
            uint32_t left, right, top, bottom;
            samples_of(x, pixels->width, color->width, &left, &right);
            samples_of(y, pixels->height, color->height, &top, &bottom);
            double sum[3] = { 0 };
            for (uint32_t j = top; j < bottom; j++)
                for (uint32_t i = left; i < right; i++)
                    for (int k = 0; k < 3; k++)
                        sum[k] +=
                            (double)color->values[3 * ((size_t)j * color->width + i) + (size_t)k];
            for (size_t k = 0; k < 3; k++)
                pixels->color[3 * ((size_t)y * pixels->width + x) + k] =
                    (float)(sum[k] / ((right - left) * (double)(bottom - top)));
        }
}

static void take_normal(const float *coded, float *normal)
{
    double n[3];
    for (int k = 0; k < 3; k++)
        n[k] = 2 * (double)coded[k] - 1;
    vector_normalize(n);
    for (int k = 0; k < 3; k++)
        normal[k] = (float)n[k];
}

static GpResult make_image(const Picture *color, const Picture *map, double width, double relief,
                           DepthImage *image, GpError *error)
{
    const bool has_normals = map->channels == 4;
    DepthPixels *pixels = &image->front;
    if (depth_pixels_make(map->width, map->height, has_normals, pixels))
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    const double height = width * map->height / map->width;
    image->plane = (DepthPlane){ .is_parallel = true,
                                 .eye = { 0, 0, relief },
                                 .right = { 1, 0, 0 },
                                 .up = { 0, 1, 0 },
                                 .forward = { 0, 0, -1 },
                                 .left = -width / 2,
                                 .bottom = -height / 2,
                                 .width = width,
                                 .height = height };
    for (size_t i = 0; i < (size_t)map->width * map->height; i++) {
        const float *value = map->values + i * (size_t)map->channels;
        const double above = (double)value[has_normals ? 3 : 0];
        /* what is no number is at the ground */
        pixels->depth[i] = (float)(relief * (above >= 0 ? above > 1 ? 0 : 1 - above : 1));
        if (has_normals)
            take_normal(value, pixels->normal + 3 * i);
        for (size_t k = 0; k < 3; k++)
            pixels->color[3 * i + k] = 1;
    }
    if (color->values)
        take_colors(color, pixels);
    /* A map has no edges: all that is steep is a slope. */
    return has_normals ? GP_OK : surface_grid_normals(image, -1, &pixels->normal, error);
}

GpResult height_map_read(const char *color_path, const char *map_path, double width, double relief,
                         DepthImage *image, GpError *error)
{
    GP_ASSERT(width > 0 && relief > 0);
    Picture color = { .values = NULL }, map = { .values = NULL };
    DepthImage made = { .is_cylinder = false };
    GpResult result = color_path ? picture_read(color_path, &color, error) : GP_OK;
    if (!result && color_path)
        result = picture_set_channels(&color, 3, error);
    if (!result)
        result = picture_read(map_path, &map, error);
    if (!result)
        result = make_image(&color, &map, width, relief, &made, error);
    picture_free(&color);
    picture_free(&map);
    if (result)
        depth_pixels_free(&made.front);
    else
        *image = made;
    return result;
}
