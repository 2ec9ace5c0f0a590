#include "apps/points/cloud.h"

#include "apps/points/cloud/distinct.h"

#include <math.h>

#include <string.h>

/* What surfels are made of, by their numbers. */
typedef struct Cloud {
    uint32_t *numbers; /* of points */
    uint32_t count;
    float *positions, *normals, *radii, *areas;
    NeighbourTree tree;
} Cloud;

static void free_cloud(Cloud *cloud)
{
    gp_free(cloud->numbers);
    gp_free(cloud->positions);
    gp_free(cloud->normals);
    gp_free(cloud->radii);
    gp_free(cloud->areas);
    neighbour_tree_free(&cloud->tree);
}

static GpResult make_cloud(const GpPoints *points, Cloud *cloud)
{
    cloud->numbers = gp_alloc(points->count, sizeof *cloud->numbers);
    if (!cloud->numbers ||
        distinct_places(points->positions, points->count, cloud->numbers, &cloud->count) != GP_OK)
        return GP_ERROR_MEMORY;
    const size_t count = cloud->count;
    cloud->positions = gp_alloc(count, 3 * sizeof(float));
    cloud->normals = gp_alloc(count, 3 * sizeof(float));
    cloud->radii = gp_alloc(count, sizeof(float));
    cloud->areas = gp_alloc(count, sizeof(float));
    if (!cloud->positions || !cloud->normals || !cloud->radii || !cloud->areas)
        return GP_ERROR_MEMORY;
    for (size_t i = 0; i < count; i++) {
        const size_t from = 3 * (size_t)cloud->numbers[i];
        memcpy(cloud->positions + 3 * i, points->positions + from, 3 * sizeof(float));
        if (points->normals)
            memcpy(cloud->normals + 3 * i, points->normals + from, 3 * sizeof(float));
    }
    return GP_OK;
}

/* Normals so short that their squares vanish are none. */
static uint32_t count_zero_normals(Cloud *cloud)
{
    uint32_t zeros = 0;
    for (size_t i = 0; i < cloud->count; i++) {
        float *normal = cloud->normals + 3 * i;
        const double x = (double)normal[0], y = (double)normal[1], z = (double)normal[2];
        const double length = sqrt(x * x + y * y + z * z);
        zeros += !(length > 0);
        for (int k = 0; k < 3 && length > 0; k++)
            normal[k] = (float)((double)normal[k] / length);
    }
    return zeros;
}

static float given_radius(const GpPoints *points, const Cloud *cloud, size_t i)
{
    return points->radii ? points->radii[cloud->numbers[i]] : 0;
}

static GpResult estimate(const GpPoints *points, bool all, GpPool *pool, Cloud *cloud,
                         CloudFacts *facts)
{
    GpResult result = make_cloud(points, cloud);
    if (result != GP_OK)
        return result;
    if (cloud->count == 1 && !(given_radius(points, cloud, 0) > 0))
        return GP_ERROR_INVALID;
    facts->duplicates = points->count - cloud->count;
    const uint32_t zeros = count_zero_normals(cloud);
    facts->zero_normals = points->normals ? zeros : 0;
    result = neighbour_tree_build(cloud->positions, cloud->count, pool, &cloud->tree);
    if (result == GP_OK && (all || zeros > 0))
        result = planes_estimate(&cloud->tree, pool, cloud->normals, &facts->planes);
    if (result == GP_OK)
        result = cells_measure(&cloud->tree, cloud->normals, pool, cloud->radii, cloud->areas,
                               &facts->cells);
    return result;
}

static void fill(const GpPoints *points, const Cloud *cloud, Surfels *surfels, CloudFacts *facts)
{
    for (size_t i = 0; i < cloud->count; i++) {
        Surfel *surfel = &surfels->surfels[i];
        const float radius = given_radius(points, cloud, i);
        facts->zero_radii += points->radii && !(radius > 0);
        memcpy(surfel->position, cloud->positions + 3 * i, sizeof surfel->position);
        memcpy(surfel->normal, cloud->normals + 3 * i, sizeof surfel->normal);
        surfel->radius = radius > 0 ? radius : cloud->radii[i];
        const double disc = 3.141592653589793 * (double)surfel->radius * (double)surfel->radius;
        const double area = cloud->count > 1 ? (double)cloud->areas[i] : disc;
        surfel->share = surfel_share(area, (double)surfel->radius);
        const size_t color = 3 * (size_t)cloud->numbers[i];
        for (int k = 0; k < 3; k++)
            surfel->color[k] = points->colors ? points->colors[color + (size_t)k] : 255;
    }
    surfels->had_normals = points->normals != NULL;
    surfels->had_radii = points->radii != NULL;
    surfels->had_colors = points->colors != NULL;
}

GpResult surfels_of_points(const GpPoints *points, bool all, GpPool *pool, Surfels *surfels,
                           CloudFacts *facts)
{
    Cloud cloud = { .count = 0 };
    CloudFacts found = { .duplicates = 0 };
    Surfels made;
    GpResult result = estimate(points, all, pool, &cloud, &found);
    if (result == GP_OK)
        result = surfels_alloc(&made, cloud.count);
    if (result == GP_OK) {
        fill(points, &cloud, &made, &found);
        *surfels = made;
        *facts = found;
    }
    free_cloud(&cloud);
    return result;
}
