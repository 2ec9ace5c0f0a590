#include "apps/truth/voxel_distance.h"

#include "apps/truth/even_points.h"
#include "apps/truth/triangle.h"
#include "apps/truth/voxel_nearest.h"

enum { POINTS = 50000, MOST_VOXELS = 50000 };

/* --- the model --------------------------------------------------------------------------------- */

static double area_of(const TruthTriangle *triangle)
{
    double normal[3];
    truth_normal(triangle, normal);
    return 0.5 * sqrt(vector_dot(normal, normal));
}

/* Uniform in a triangle where `place` is in the square.
 * source Turk, "Generating random points in triangles", Graphics Gems, 1990 */
static void point_of(const TruthTriangle *t, const double place[2], double point[3])
{
    const double root = sqrt(place[0]);
    const double share[3] = { 1 - root, root * (1 - place[1]), root * place[1] };
    for (int k = 0; k < 3; k++)
        point[k] =
            share[0] * t->corner[0][k] + share[1] * t->corner[1][k] + share[2] * t->corner[2][k];
}

/* One point for each of equal parts of the surface, taken in the triangles' order. */
static void spread(const TruthTriangle *triangles, uint32_t count, double (*points)[3])
{
    double whole = 0, before = 0; /* area of the triangles before `at` */
    uint32_t at = 0;
    for (uint32_t i = 0; i < count; i++)
        whole += area_of(&triangles[i]);
    for (uint32_t i = 0; i < POINTS; i++) {
        const double place = (i + 0.5) / POINTS * whole;
        double area, in_square[2];
        while ((area = area_of(&triangles[at])) + before <= place && at + 1 < count) {
            before += area;
            at++;
        }
        truth_even_in_square(i, in_square);
        point_of(&triangles[at], in_square, points[i]);
    }
}

GpResult voxel_distance_make(const TruthTriangle *triangles, uint32_t count,
                             VoxelDistance *distance)
{
    uint32_t *order = gp_alloc(count, sizeof *order);
    VoxelDistance made = { .triangles = gp_alloc(count, sizeof *made.triangles),
                           .nodes = gp_alloc(2 * (size_t)count - 1, sizeof *made.nodes),
                           .points = gp_alloc(POINTS, sizeof *made.points) };
    GpResult result = order && made.triangles && made.nodes && made.points
                          ? truth_tree_build(triangles, count, order, made.nodes)
                          : GP_ERROR_MEMORY;
    if (result) {
        voxel_distance_free(&made);
    } else {
        for (uint32_t i = 0; i < count; i++)
            made.triangles[i] = triangles[order[i]];
        spread(made.triangles, count, made.points);
        made.longest = bounds_longest(&made.nodes[0].box);
        *distance = made;
    }
    gp_free(order);
    return result;
}

void voxel_distance_free(VoxelDistance *distance)
{
    gp_free(distance->triangles);
    gp_free(distance->nodes);
    gp_free(distance->points);
    *distance = (VoxelDistance){ .nodes = NULL };
}

/* --- from the model to voxels ------------------------------------------------------------------ */

static double to_voxels(const VoxelDistance *distance, const VoxelBox *space,
                        const VoxelPyramid *pyramid)
{
    const double most = space->scale * distance->longest;
    double sum = 0;
    uint32_t count = 0;
    for (uint32_t i = 0; i < POINTS; i++) {
        double point[3];
        bool inside = true;
        for (int k = 0; k < 3; k++) {
            point[k] = space->scale * distance->points[i][k] + space->offset[k];
            inside = inside && point[k] >= 0 && point[k] <= space->size;
        }
        if (!inside) /* cut off by its placement, and not asked for */
            continue;
        const double apart = voxel_pyramid_nearest(pyramid, point, most);
        sum += apart * apart;
        count++;
    }
    return count ? sqrt(sum / count) / most : 0;
}

/* --- from voxels to the model ------------------------------------------------------------------ */

static double square_to_box(const Bounds *box, const double point[3])
{
    double square = 0;
    for (int k = 0; k < 3; k++) {
        double off = fmax(fmax(box->low[k] - point[k], point[k] - box->high[k]), 0);
        square += off * off;
    }
    return square;
}

/* Lowers the square of the distance to the nearest triangle so far; the nearer child first. */
static void look_into(const VoxelDistance *distance, const TruthNode *node, const double point[3],
                      double *square)
{
    if (node->count > 0) {
        for (uint32_t i = 0; i < node->count; i++)
            *square = fmin(*square,
                           truth_square_to_triangle(point, &distance->triangles[node->first + i]));
        return;
    }
    const TruthNode *child = &distance->nodes[node->first];
    const double apart[2] = { square_to_box(&child[0].box, point),
                              square_to_box(&child[1].box, point) };
    const int near = apart[1] < apart[0];
    if (apart[near] < *square)
        look_into(distance, &child[near], point, square);
    if (apart[1 - near] < *square)
        look_into(distance, &child[1 - near], point, square);
}

/* Of every voxel, or of every second, third .. where there are too many. */
static double to_model(const VoxelDistance *distance, const VoxelBox *space, const uint8_t *bits)
{
    const size_t end = (size_t)space->size * space->size * space->size;
    const uint64_t step = voxel_count(bits, space->size) / MOST_VOXELS + 1;
    uint64_t rank = 0, count = 0;
    double sum = 0;
    for (size_t i = 0; (i = voxel_next(bits, space->size, i)) < end; i++) {
        if (rank++ % step)
            continue;
        uint32_t at[3];
        double centre[3], square = HUGE_VAL;
        voxel_place(i, space->size, at);
        for (int k = 0; k < 3; k++)
            centre[k] = (at[k] + 0.5 - space->offset[k]) / space->scale;
        look_into(distance, &distance->nodes[0], centre, &square);
        sum += square;
        count++;
    }
    return count ? sqrt(sum / (double)count) / distance->longest : 0;
}

GpResult voxel_distance_find(const VoxelDistance *distance, const VoxelBox *space,
                             const uint8_t *bits, VoxelApart *apart)
{
    VoxelPyramid pyramid;
    GpResult result = voxel_pyramid_make(bits, space->size, &pyramid);
    if (result)
        return result;
    apart->to_voxels = to_voxels(distance, space, &pyramid);
    apart->to_model = to_model(distance, space, bits);
    voxel_pyramid_free(&pyramid);
    return GP_OK;
}
