#include "apps/depth_images/drawing/surface_grid.h"

#include "apps/base/vector.h"
#include "apps/depth_images/drawing/merge.h"

#include <math.h>
#include <string.h>

static const double two_pi = 0x1.921fb54442d18p+2;
static const double jump = 3;    /* as large beside its neighbours' is none of a slope */
static const double along = 0.5; /* cosine to a normal, of ways within the surface */

/* --- where columns and rows are --------------------------------------------------------------- */

static uint32_t column_of(const SurfaceGrid *grid, uint32_t x)
{
    const uint32_t column = x * grid->step, width = grid->image->front.width;
    return column < width ? column : grid->image->is_cylinder ? 0 : width - 1;
}

static uint32_t row_of(const SurfaceGrid *grid, uint32_t y)
{
    const uint32_t row = y * grid->step, height = grid->image->front.height;
    return row < height ? row : height - 1;
}

static size_t pixel_of(const SurfaceGrid *grid, uint32_t x, uint32_t y)
{
    return (size_t)row_of(grid, y) * grid->image->front.width + column_of(grid, x);
}

void surface_grid_texcoord(const SurfaceGrid *grid, uint32_t point, float texcoord[2])
{
    const DepthPixels *pixels = &grid->image->front;
    const uint32_t x = point % grid->columns, y = point / grid->columns;
    const double around = x > 0 && column_of(grid, x) == 0 ? pixels->width : 0;
    texcoord[0] = (float)((column_of(grid, x) + around + 0.5) / pixels->width);
    texcoord[1] = (float)((row_of(grid, y) + 0.5) / pixels->height);
}

/* --- cuts ------------------------------------------------------------------------------------- */

/* From pixel to pixel at a depth, across and down. */
static void spacing_at(const DepthImage *image, double depth, double spacing[2])
{
    const DepthPixels *pixels = &image->front;
    if (image->is_cylinder) {
        spacing[0] = fabs(image->cylinder.radius - depth) * two_pi / pixels->width;
        spacing[1] = image->cylinder.height / pixels->height;
        return;
    }
    const double spread = image->plane.is_parallel ? 1 : depth;
    spacing[0] = spread * image->plane.width / pixels->width;
    spacing[1] = spread * image->plane.height / pixels->height;
}

/* How much deeper one pixel is than another; 0 where one shows nothing. */
static double step_between(const DepthPixels *pixels, size_t from, size_t to)
{
    const double step = (double)pixels->depth[to] - (double)pixels->depth[from];
    return isfinite(step) ? fabs(step) : 0;
}

/* Whether the way between two points may lie in one surface: it goes along it at both ends. */
static bool lies_along(const SurfaceGrid *grid, size_t from, size_t to)
{
    double way[3], off[2];
    for (int k = 0; k < 3; k++)
        way[k] = (double)grid->position[to][k] - (double)grid->position[from][k];
    vector_normalize(way);
    for (int i = 0; i < 2; i++) {
        const float *normal = grid->normal[i ? to : from];
        off[i] = fabs((double)normal[0] * way[0] + (double)normal[1] * way[1] +
                      (double)normal[2] * way[2]);
    }
    return off[0] < along && off[1] < along;
}

/* Whether the side from a point to the next, across or down, is cut. */
static bool is_cut(const SurfaceGrid *grid, uint32_t x, uint32_t y, bool across, double cut)
{
    const DepthPixels *pixels = &grid->image->front;
    const uint32_t at = across ? x : y, count = across ? grid->columns : grid->rows;
    const bool wraps = across && grid->image->is_cylinder;
    if (at + 1 >= count)
        return false;
    size_t pixel[4]; /* before, from, to, behind */
    double spacing[2];
    for (int i = 0; i < 4; i++) {
        int64_t place = (int64_t)at + i - 1;
        if (wraps)
            place = (place + count - 1) % (count - 1);
        place = place < 0 ? 0 : place >= count ? count - 1 : place;
        pixel[i] = across ? pixel_of(grid, (uint32_t)place, y) : pixel_of(grid, x, (uint32_t)place);
    }
    const double step = step_between(pixels, pixel[1], pixel[2]);
    const double beside =
        fmax(step_between(pixels, pixel[0], pixel[1]), step_between(pixels, pixel[2], pixel[3]));
    spacing_at(grid->image, (double)pixels->depth[pixel[1]], spacing);
    if (!(step > cut * grid->step * spacing[!across]))
        return false;
    const size_t point = (size_t)y * grid->columns + x;
    return step > jump * beside ||
           (grid->has_normals && !lies_along(grid, point, point + (across ? 1 : grid->columns)));
}

static void find_cuts(SurfaceGrid *grid, double cut)
{
    for (uint32_t y = 0; y < grid->rows && cut >= 0; y++)
        for (uint32_t x = 0; x < grid->columns; x++)
            grid->cut[(size_t)y * grid->columns + x] =
                (uint8_t)((is_cut(grid, x, y, true, cut) ? MERGE_CUT_RIGHT : 0) |
                          (is_cut(grid, x, y, false, cut) ? MERGE_CUT_DOWN : 0));
}

/* --- points ----------------------------------------------------------------------------------- */

static void find_point(const DepthImage *image, uint32_t column, uint32_t row, float position[3])
{
    const DepthPixels *pixels = &image->front;
    const double depth = (double)pixels->depth[(size_t)row * pixels->width + column];
    double point[3];
    if (!isfinite(depth)) {
        position[0] = INFINITY;
        return;
    }
    if (image->is_cylinder)
        depth_cylinder_point(&image->cylinder, pixels, column + 0.5, row + 0.5, depth, point);
    else
        depth_plane_point(&image->plane, pixels, column + 0.5, row + 0.5, depth, point);
    for (int k = 0; k < 3; k++)
        position[k] = (float)point[k];
}

GpResult surface_grid_open(const DepthImage *image, const float *normals, uint32_t step, double cut,
                           SurfaceGrid *grid, GpError *error)
{
    const DepthPixels *pixels = &image->front;
    SurfaceGrid made = { .image = image, .step = step, .has_normals = normals != NULL };
    made.columns = (pixels->width + step - 1) / step + image->is_cylinder;
    if (!image->is_cylinder && (pixels->width - 1) % step)
        made.columns++; /* the last one */
    made.rows = (pixels->height + step - 1) / step + ((pixels->height - 1) % step != 0);
    const size_t count = (size_t)made.columns * made.rows;
    made.position = gp_alloc(count, sizeof *made.position);
    made.normal = gp_alloc(count, sizeof *made.normal);
    made.cut = gp_alloc(count, 1);
    if (!made.position || !made.normal || !made.cut) {
        surface_grid_close(&made);
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    }
    for (uint32_t y = 0; y < made.rows; y++)
        for (uint32_t x = 0; x < made.columns; x++) {
            const size_t point = (size_t)y * made.columns + x;
            find_point(image, column_of(&made, x), row_of(&made, y), made.position[point]);
            if (normals)
                memcpy(made.normal[point], normals + 3 * pixel_of(&made, x, y),
                       sizeof made.normal[point]);
        }
    find_cuts(&made, cut);
    *grid = made;
    return GP_OK;
}

void surface_grid_close(SurfaceGrid *grid)
{
    gp_free(grid->position);
    gp_free(grid->normal);
    gp_free(grid->cut);
    *grid = (SurfaceGrid){ .image = NULL };
}

double surface_grid_pixel(const DepthImage *image)
{
    const DepthPixels *pixels = &image->front;
    double spacing[2], low = HUGE_VAL, high = 0;
    for (size_t i = 0; i < (size_t)pixels->width * pixels->height; i++) {
        const double depth = (double)pixels->depth[i];
        low = depth < low ? depth : low;
        high = isfinite(depth) && depth > high ? depth : high;
    }
    spacing_at(image, image->is_cylinder || low > high ? 0 : (low + high) / 2, spacing);
    return sqrt(spacing[0] * spacing[1]);
}

/* --- normals ---------------------------------------------------------------------------------- */

/* The way between the neighbours of a point, or from it to one of them, that are of its surface. */
static void way_along(const SurfaceGrid *grid, uint32_t x, uint32_t y, bool across, double way[3])
{
    const size_t at = (size_t)y * grid->columns + x, next = across ? 1 : grid->columns;
    const uint32_t place = across ? x : y, last = (across ? grid->columns : grid->rows) - 1;
    const uint8_t side = across ? MERGE_CUT_RIGHT : MERGE_CUT_DOWN;
    const bool wraps = across && grid->image->is_cylinder;
    const size_t before = place > 0 ? at - next : wraps ? at + last - 1 : at;
    const size_t behind = place < last ? at + next : at;
    const bool has_before = !(grid->cut[before] & side) && isfinite(grid->position[before][0]);
    const bool has_behind = !(grid->cut[at] & side) && isfinite(grid->position[behind][0]);
    for (int k = 0; k < 3; k++)
        way[k] = (double)grid->position[has_behind ? behind : at][k] -
                 (double)grid->position[has_before ? before : at][k];
}

/* Where there is no plane to be seen: towards who took the image. */
static void towards_source(const DepthImage *image, const float position[3], double normal[3])
{
    const double *from = image->is_cylinder ? image->cylinder.center : image->plane.eye;
    for (int k = 0; k < 3; k++) {
        const double away = (double)position[k] - from[k];
        normal[k] = image->is_cylinder         ? away
                    : image->plane.is_parallel ? -image->plane.forward[k]
                                               : -away;
    }
    if (image->is_cylinder)
        vector_add_scaled(normal, -vector_dot(normal, image->cylinder.axis), image->cylinder.axis,
                          normal);
}

GpResult surface_grid_normals(const DepthImage *image, double cut, float **normals, GpError *error)
{
    const DepthPixels *pixels = &image->front;
    SurfaceGrid grid;
    float *found = gp_alloc((size_t)pixels->width * pixels->height, 3 * sizeof *found);
    GpResult result = surface_grid_open(image, NULL, 1, cut, &grid, error);
    if (!result && !found) {
        surface_grid_close(&grid);
        result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    }
    if (result) {
        gp_free(found);
        return result;
    }
    for (uint32_t y = 0; y < pixels->height; y++)
        for (uint32_t x = 0; x < pixels->width; x++) {
            const float *position = grid.position[(size_t)y * grid.columns + x];
            double right[3], down[3], normal[3];
            if (isinf(position[0]))
                continue;
            way_along(&grid, x, y, true, right);
            way_along(&grid, x, y, false, down);
            vector_cross(down, right, normal);
            if (!(vector_dot(normal, normal) > 0))
                towards_source(image, position, normal);
            vector_normalize(normal);
            for (int k = 0; k < 3; k++)
                found[3 * ((size_t)y * pixels->width + x) + (size_t)k] = (float)normal[k];
        }
    surface_grid_close(&grid);
    *normals = found;
    return GP_OK;
}
