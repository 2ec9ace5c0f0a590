#include "apps/truth/voxel_distance.h"

#include "apps/truth/even_points.h"
#include "apps/truth/triangle.h"
#include "apps/truth/voxel_nearest.h"

enum { PLACES = 50000 }; /* points of the model; and voxels, at most */

/* --- the model -------------------------------------------------------------------------------- */

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
    for (uint32_t i = 0; i < PLACES; i++) {
        const double place = (i + 0.5) / PLACES * whole;
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
                           .points = gp_alloc(PLACES, sizeof *made.points) };
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

/* --- squares ---------------------------------------------------------------------------------- */

enum { BLOCK = 500 }; /* places that a thread takes at once */

static const double not_asked = -1;

/* Squares of distances, found by all threads. */
typedef struct Squares {
    const VoxelDistance *distance;
    const VoxelBox *space;
    const VoxelPyramid *pyramid;
    double (*find)(const struct Squares *squares, uint32_t place);
    uint32_t count;  /* of places: points, or voxels */
    size_t *voxels;  /* [PLACES] */
    double *squares; /* [count]; not_asked: none */
} Squares;

static void find_block(void *context, uint32_t block, int worker)
{
    const Squares *squares = context;
    const uint32_t first = block * BLOCK, left = squares->count - first;
    (void)worker;
    for (uint32_t i = first; i < first + (left < BLOCK ? left : BLOCK); i++)
        squares->squares[i] = squares->find(squares, i);
}

/* The root of their mean; 0 of none. */
static double find_root(Squares *squares, GpPool *pool)
{
    double sum = 0;
    uint32_t asked = 0;
    gp_pool_run(pool, (squares->count + BLOCK - 1) / BLOCK, find_block, squares);
    for (uint32_t i = 0; i < squares->count; i++) {
        if (squares->squares[i] == not_asked)
            continue;
        sum += squares->squares[i];
        asked++;
    }
    return asked ? sqrt(sum / asked) : 0;
}

/* --- from the model to voxels ----------------------------------------------------------------- */

/* A point in voxels. False: it is cut off by its placement, and not asked for */
static bool find_point(const Squares *squares, uint32_t number, double point[3])
{
    const VoxelBox *space = squares->space;
    for (int k = 0; k < 3; k++) {
        point[k] = space->scale * squares->distance->points[number][k] + space->offset[k];
        if (!(point[k] >= 0 && point[k] <= space->size))
            return false;
    }
    return true;
}

/* In voxels. */
static double square_to_voxel(const Squares *squares, uint32_t number)
{
    double point[3];
    if (!find_point(squares, number, point))
        return not_asked;
    const double apart = voxel_pyramid_nearest(squares->pyramid, point,
                                               squares->space->scale * squares->distance->longest);
    return apart * apart;
}

/* The same where all voxels are set. */
static double square_to_any_voxel(const Squares *squares, uint32_t number)
{
    const double most = squares->space->scale * squares->distance->longest;
    double point[3], square = 0;
    if (!find_point(squares, number, point))
        return not_asked;
    for (int k = 0; k < 3; k++) {
        const double off = point[k] - (fmin(floor(point[k]), squares->space->size - 1.0) + 0.5);
        square += off * off;
    }
    const double apart = sqrt(fmin(square, most * most));
    return apart * apart;
}

/* --- from voxels to the model ----------------------------------------------------------------- */

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

/* In the model's unit. */
static double square_to_model(const Squares *squares, uint32_t number)
{
    const VoxelBox *space = squares->space;
    uint32_t at[3];
    double centre[3], square = HUGE_VAL;
    voxel_place(squares->voxels[number], space->size, at);
    for (int k = 0; k < 3; k++)
        centre[k] = (at[k] + 0.5 - space->offset[k]) / space->scale;
    look_into(squares->distance, &squares->distance->nodes[0], centre, &square);
    return square;
}

/* Every voxel, or every second, third .. where there are too many. returns how many */
static uint32_t choose_voxels(const uint8_t *bits, uint32_t size, size_t *voxels)
{
    const size_t end = (size_t)size * size * size;
    const uint64_t step = voxel_count(bits, size) / PLACES + 1;
    uint64_t rank = 0;
    uint32_t count = 0;
    for (size_t i = 0; (i = voxel_next(bits, size, i)) < end; i++)
        if (rank++ % step == 0)
            voxels[count++] = i;
    return count;
}

GpResult voxel_distance_find(const VoxelDistance *distance, const VoxelBox *space,
                             const uint8_t *bits, GpPool *pool, VoxelApart *apart)
{
    VoxelPyramid pyramid = { .levels = 0 };
    Squares squares = { .distance = distance,
                        .space = space,
                        .pyramid = &pyramid,
                        .voxels = gp_alloc(PLACES, sizeof *squares.voxels),
                        .squares = gp_alloc(PLACES, sizeof *squares.squares) };
    GpResult result = squares.voxels && squares.squares
                          ? voxel_pyramid_make(bits, space->size, &pyramid)
                          : GP_ERROR_MEMORY;
    if (!result) {
        squares.find = square_to_voxel;
        squares.count = PLACES;
        apart->to_voxels = find_root(&squares, pool) / (space->scale * distance->longest);
        squares.find = square_to_model;
        squares.count = choose_voxels(bits, space->size, squares.voxels);
        apart->to_model = find_root(&squares, pool) / distance->longest;
    }
    voxel_pyramid_free(&pyramid);
    gp_free(squares.voxels);
    gp_free(squares.squares);
    return result;
}

GpResult voxel_distance_least(const VoxelDistance *distance, const VoxelBox *space, GpPool *pool,
                              double *least)
{
    Squares squares = { .distance = distance,
                        .space = space,
                        .find = square_to_any_voxel,
                        .count = PLACES,
                        .squares = gp_alloc(PLACES, sizeof *squares.squares) };
    if (!squares.squares)
        return GP_ERROR_MEMORY;
    *least = find_root(&squares, pool) / (space->scale * distance->longest);
    gp_free(squares.squares);
    return GP_OK;
}
