#include "apps/depth_images/making/capture_cylinder.h"

#include "apps/depth_images/making/columns.h"
#include "apps/depth_images/making/faces_mesh.h"

#include <string.h>

/* The cylinder about a mesh, round the middle of its box along the axis that points up, a hundredth
 * larger than what it holds; azimuth 0 is in front. Thin ones are thick enough to be looked at:
 * neither side is below a thousandth of the other. */
static DepthCylinder cylinder_about(const CaptureSource *source, OrbitUp up)
{
    const GpMesh *mesh = source->mesh;
    const Bounds box = capture_bounds(source);
    const double(*axes)[3] = orbit_axes(up);
    DepthCylinder cylinder = { .radius = 0 };
    double farthest = 0;
    int along = 0;
    for (int k = 0; k < 3; k++) {
        cylinder.center[k] = (box.low[k] + box.high[k]) / 2;
        cylinder.axis[k] = axes[1][k];
        cylinder.zero[k] = axes[2][k];
        along = axes[1][k] != 0 ? k : along;
    }
    for (size_t i = 0; i < 3 * (size_t)mesh->triangle_count; i++) {
        const float *p = mesh->positions + 3 * (size_t)mesh->indices[i];
        double square = 0;
        for (int k = 0; k < 3; k++) {
            const double off = k == along ? 0 : (double)p[k] - cylinder.center[k];
            square += off * off;
        }
        farthest = fmax(farthest, square);
    }
    const double radius = 1.01 * sqrt(farthest), height = 1.01 * (box.high[along] - box.low[along]);
    cylinder.radius = fmax(fmax(radius, 1e-3 * height), 1e-30);
    cylinder.height = fmax(fmax(height, 1e-3 * radius), 1e-30);
    return cylinder;
}

/* --- columns ---------------------------------------------------------------------------------- */

/* The triangles of some columns, corner by corner: [3 * triangles] of each. */
typedef struct Gathered {
    float *position, *normal, *color;
    uint32_t *first; /* [columns + 1] */
} Gathered;

static void gathered_free(Gathered *gathered)
{
    gp_free(gathered->position);
    gp_free(gathered->normal);
    gp_free(gathered->color);
    gp_free(gathered->first);
}

/* Column `n` of a range is (first + n) modulo the image's; those in [begin, end) are gathered. */
static uint32_t column_at(const ColumnRange *range, uint32_t n, uint32_t columns)
{
    return (range->first + n) % columns;
}

static GpResult gather(const GpMesh *mesh, const float *colors, const ColumnRange *ranges,
                       uint32_t columns, uint32_t begin, uint32_t end, Gathered *gathered)
{
    const uint32_t count = end - begin;
    uint32_t *at = gp_alloc(count + 1, sizeof *at);
    gathered->first = gp_alloc(count + 1, sizeof *gathered->first);
    if (!at || !gathered->first) {
        gp_free(at);
        return GP_ERROR_MEMORY;
    }
    for (size_t t = 0; t < mesh->triangle_count; t++)
        for (uint32_t n = 0; n < ranges[t].count; n++) {
            const uint32_t column = column_at(&ranges[t], n, columns);
            if (column >= begin && column < end)
                gathered->first[column - begin + 1]++;
        }
    for (uint32_t c = 0; c < count; c++) {
        gathered->first[c + 1] += gathered->first[c];
        at[c] = gathered->first[c];
    }
    const size_t corners = 3 * (size_t)gathered->first[count];
    gathered->position = gp_alloc(corners, 3 * sizeof(float));
    gathered->normal = gp_alloc(corners, 3 * sizeof(float));
    gathered->color = colors ? gp_alloc(corners, 4 * sizeof(float)) : NULL;
    GpResult result = gathered->position && gathered->normal && (!colors || gathered->color)
                          ? GP_OK
                          : GP_ERROR_MEMORY;
    for (size_t t = 0; result == GP_OK && t < mesh->triangle_count; t++)
        for (uint32_t n = 0; n < ranges[t].count; n++) {
            const uint32_t column = column_at(&ranges[t], n, columns);
            if (column < begin || column >= end)
                continue;
            const size_t to = 3 * (size_t)at[column - begin]++;
            for (size_t k = 0; k < 3; k++) {
                const size_t from = mesh->indices[3 * t + k];
                memcpy(gathered->position + 3 * (to + k), mesh->positions + 3 * from, 12);
                memcpy(gathered->normal + 3 * (to + k), mesh->normals + 3 * from, 12);
                if (colors)
                    memcpy(gathered->color + 4 * (to + k), colors + 4 * from, 16);
            }
        }
    gp_free(at);
    return result;
}

/* What a column's middle sees: rays at all heights, from the wall to the axis. */
static CaptureView view_of(const DepthCylinder *cylinder, uint32_t columns, uint32_t column,
                           uint32_t height)
{
    const DepthPixels picture = { .width = columns, .height = height };
    CaptureView view = { .near = 0, .far = cylinder->radius };
    DepthPlane *plane = &view.plane;
    depth_cylinder_point(cylinder, &picture, column + 0.5, height / 2.0, 0, plane->eye);
    for (int k = 0; k < 3; k++) {
        plane->forward[k] = (cylinder->center[k] - plane->eye[k]) / cylinder->radius;
        plane->up[k] = cylinder->axis[k];
    }
    vector_cross(plane->forward, plane->up, plane->right);
    plane->is_parallel = true;
    plane->width = 2 * 3.14159265358979323846 * cylinder->radius / columns;
    plane->left = -plane->width / 2;
    plane->height = cylinder->height;
    plane->bottom = -cylinder->height / 2;
    return view;
}

/* Pixels of some columns into their place. */
static void put_columns(const DepthPixels *from, uint32_t begin, DepthPixels *to)
{
    for (size_t y = 0; y < from->height; y++) {
        const size_t source = y * from->width, place = y * to->width + begin;
        memcpy(to->depth + place, from->depth + source, from->width * sizeof(float));
        memcpy(to->color + 3 * place, from->color + 3 * source, 3 * from->width * sizeof(float));
        memcpy(to->normal + 3 * place, from->normal + 3 * source, 3 * from->width * sizeof(float));
    }
}

static GpResult draw_columns(GpDevice *device, const CaptureSource *source, const float *colors,
                             const ColumnRange *ranges, const DepthCylinder *cylinder,
                             uint32_t begin, uint32_t end, DepthImage *image, GpError *error)
{
    const uint32_t columns = image->front.width, height = image->front.height, count = end - begin;
    Gathered gathered = { NULL };
    DepthPixels front = { 0 }, behind = { 0 };
    CaptureView *views = gp_alloc(count, sizeof *views);
    GpResult result = views ? gather(source->mesh, colors, ranges, columns, begin, end, &gathered)
                            : GP_ERROR_MEMORY;
    if (result != GP_OK)
        gp_fail(error, result, "no memory for %u columns of a depth image", count);
    for (uint32_t c = 0; result == GP_OK && c < count; c++) {
        const size_t first = 3 * (size_t)gathered.first[c];
        views[c] = view_of(cylinder, columns, begin + c, height);
        views[c].viewport = (GpViewport){ .x = (float)c, .width = 1, .height = (float)height };
        GpGeometry *geometry = &views[c].geometry;
        geometry->vertex_count = 3 * (gathered.first[c + 1] - gathered.first[c]);
        geometry->streams[GP_POSITION] = (GpStream){ gathered.position + 3 * first, 0, 3, 0 };
        geometry->streams[GP_NORMAL] = (GpStream){ gathered.normal + 3 * first, 0, 3, 0 };
        if (colors)
            geometry->streams[GP_COLOR] = (GpStream){ gathered.color + 4 * first, 0, 4, 0 };
    }
    if (result == GP_OK)
        result = capture_views(device, views, count, source->waves, count, height, &front,
                               image->behind.width ? &behind : NULL, error);
    if (result == GP_OK) {
        put_columns(&front, begin, &image->front);
        if (image->behind.width)
            put_columns(&behind, begin, &image->behind);
    }
    depth_pixels_free(&front);
    depth_pixels_free(&behind);
    gathered_free(&gathered);
    gp_free(views);
    return result;
}

/* Columns in turns, so many at a time that what is gathered stays below this. */
enum { TRIANGLES_AT_ONCE = 1 << 19 };

static GpResult draw_all_columns(GpDevice *device, const CaptureSource *source,
                                 const CaptureTurn *turn, DepthImage *image, GpError *error)
{
    const DepthCylinder *cylinder = &turn->cylinder;
    const uint32_t columns = image->front.width;
    float *white = NULL;
    ColumnRange *ranges = NULL;
    GpResult result = capture_colors(source, &white, error);
    if (result == GP_OK && columns_of(cylinder, source->mesh, columns, &ranges) != GP_OK)
        result = gp_fail(error, GP_ERROR_MEMORY, "no memory for %u triangles",
                         source->mesh->triangle_count);
    const float *colors = source->waves > 0 ? NULL : white ? white : source->mesh->colors;
    uint64_t all = 0;
    for (size_t t = 0; result == GP_OK && t < source->mesh->triangle_count; t++)
        all += ranges[t].count;
    const uint64_t turns = all / TRIANGLES_AT_ONCE + 1;
    const uint32_t step = (uint32_t)(columns / turns ? columns / turns : 1);
    for (uint32_t begin = 0; result == GP_OK && begin < columns; begin += step) {
        if (turn->tell)
            turn->tell(turn->listener, begin, columns, "columns");
        result = draw_columns(device, source, colors, ranges, cylinder, begin,
                              begin + step < columns ? begin + step : columns, image, error);
    }
    if (turn->tell)
        turn->tell(turn->listener, columns, columns, "columns");
    gp_free(white);
    gp_free(ranges);
    return result;
}

/* --- the whole -------------------------------------------------------------------------------- */

/* The cap that looks down the axis (from above), or up. */
static CaptureShot cap_shot(const DepthCylinder *cylinder, bool above, uint32_t side)
{
    CaptureShot shot = { .plane.is_parallel = true, .width = side, .height = side };
    DepthPlane *plane = &shot.plane;
    double aside[3];
    vector_cross(cylinder->axis, cylinder->zero, aside);
    for (int k = 0; k < 3; k++) {
        const double out = above ? cylinder->axis[k] : -cylinder->axis[k];
        plane->eye[k] = cylinder->center[k] + cylinder->height / 2 * out;
        plane->forward[k] = -out;
        plane->right[k] = above ? cylinder->zero[k] : aside[k];
        plane->up[k] = above ? aside[k] : cylinder->zero[k];
    }
    plane->left = plane->bottom = -cylinder->radius;
    plane->width = plane->height = 2 * cylinder->radius;
    return shot;
}

static GpResult capture_wall(GpDevice *device, const CaptureSource *source, const CaptureTurn *turn,
                             DepthImage *image, GpError *error)
{
    if (turn->width == 0 || turn->height == 0 || turn->width > GP_MAX_SIZE ||
        turn->height > GP_MAX_SIZE)
        return gp_fail(error, GP_ERROR_INVALID, "a depth image of %ux%u pixels; sides are 1 to %d",
                       turn->width, turn->height, GP_MAX_SIZE);
    DepthImage made = { .is_cylinder = true, .cylinder = turn->cylinder };
    GpResult result = depth_pixels_make(turn->width, turn->height, true, &made.front);
    if (result == GP_OK && turn->behind)
        result = depth_pixels_make(turn->width, turn->height, true, &made.behind);
    GpMesh faces = { NULL };
    CaptureSource seen = *source;
    if (result != GP_OK)
        gp_fail(error, result, "no memory for %ux%u pixels", turn->width, turn->height);
    else if (turn->rays == CAPTURE_FACES) {
        const uint32_t side = turn->width > turn->height ? turn->width : turn->height;
        result = faces_mesh(device, source, side, &faces, error);
        seen = (CaptureSource){ &faces, 0 };
    }
    if (result == GP_OK)
        result = draw_all_columns(device, &seen, turn, &made, error);
    gp_mesh_free(&faces);
    if (result == GP_OK) {
        *image = made;
        return GP_OK;
    }
    depth_pixels_free(&made.front);
    depth_pixels_free(&made.behind);
    return result;
}

GpResult capture_cylinder(GpDevice *device, const CaptureSource *source, const CaptureTurn *turn,
                          DepthModel *model, GpError *error)
{
    CaptureTurn whole = *turn;
    if (!(whole.cylinder.radius > 0))
        whole.cylinder = cylinder_about(source, whole.up);
    whole.cap = whole.cap ? whole.cap : whole.width / 2 ? whole.width / 2 : 1;
    DepthModel made = { 0 };
    GpResult result = capture_wall(device, source, &whole, &made.images[0], error);
    made.count += result == GP_OK;
    for (int cap = 0; result == GP_OK && cap < 2; cap++) {
        CaptureShot shot = cap_shot(&whole.cylinder, cap == 0, whole.cap);
        shot.behind = whole.behind;
        result = capture_planar(device, source, &shot, &made.images[1 + cap], error);
        made.count += result == GP_OK;
    }
    if (result == GP_OK)
        *model = made;
    else
        depth_model_free(&made);
    return result;
}
