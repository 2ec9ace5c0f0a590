#include "apps/points/cloud/planes.h"

#include "apps/base/symmetric.h"
#include "apps/base/vector.h"
#include "apps/points/cloud/links.h"

#include <string.h>

typedef struct Planes {
    const NeighbourTree *tree;
    float *normals;      /* in and out, by number */
    Links links;         /* by rank */
    uint32_t *undefined; /* of each piece */
    uint32_t *estimated;
} Planes;

static const float *normal_of(const Planes *planes, uint32_t rank)
{
    return planes->normals + 3 * (size_t)planes->tree->numbers[rank];
}

/* Across a line, nearest to z or y. */
static void across(const double line[3], double normal[3])
{
    const int axis = fabs(line[2]) < 0.99 ? 2 : 1;
    for (int i = 0; i < 3; i++)
        normal[i] = (i == axis) - line[axis] * line[i];
    vector_normalize(normal);
}

/* The direction of least spread; false where it is not the only one. */
static bool fit_plane(const NeighbourTree *tree, uint32_t rank, const Neighbour *found,
                      uint32_t count, double normal[3])
{
    const float *place = tree->positions + 3 * (size_t)rank;
    Moments moments = { .origin = { (double)place[0], (double)place[1], (double)place[2] } };
    moments_add(&moments, place);
    for (uint32_t i = 0; i < count; i++)
        moments_add(&moments, tree->positions + 3 * (size_t)found[i].rank);
    const Symmetric covariance = moments_covariance(&moments);
    double values[3], vectors[3][3];
    symmetric_eigen(&covariance, values, vectors);
    /* Roundings of positions, 2^-24 of their size, are no spread. */
    const double rounding = vector_extent(moments.origin) * 0x1p-23;
    if (values[1] > 1e-10 * values[0] && values[1] > rounding * rounding) {
        memcpy(normal, vectors[2], 3 * sizeof *normal);
        return true;
    }
    across(vectors[0], normal);
    return false;
}

static void fit_piece(void *context, uint32_t piece, int worker)
{
    Planes *planes = context;
    const NeighbourTree *tree = planes->tree;
    uint32_t rank;
    const uint32_t end = neighbour_piece(tree->count, piece, &rank);
    (void)worker;
    Neighbour found[PLANES_NEIGHBOURS];
    for (uint32_t count = 0; rank < end; rank++) {
        count = neighbours_of(tree, rank, PLANES_NEIGHBOURS, count, found);
        LinkedPoint *point = &planes->links.points[rank];
        const float *given = normal_of(planes, rank);
        double normal[3] = { (double)given[0], (double)given[1], (double)given[2] };
        point->is_given = vector_dot(normal, normal) > 0;
        if (!point->is_given) {
            planes->estimated[piece]++;
            planes->undefined[piece] += !fit_plane(tree, rank, found, count, normal);
        }
        vector_normalize(normal);
        for (int i = 0; i < 3; i++)
            point->normal[i] = (float)normal[i];
        uint32_t *links = planes->links.links + PLANES_LINKS * (size_t)rank;
        const uint32_t linked = count < PLANES_LINKS ? count : PLANES_LINKS;
        for (uint32_t i = 0; i < PLANES_LINKS; i++)
            links[i] = i < linked ? found[i].rank : rank;
        point->area = linked ? (float)found[linked - 1].distance2 : 0;
    }
}

static void free_planes(Planes *planes)
{
    gp_free(planes->links.points);
    gp_free(planes->links.links);
    gp_free(planes->undefined);
    gp_free(planes->estimated);
}

GpResult planes_estimate(const NeighbourTree *tree, GpPool *pool, float *normals, PlaneFacts *facts)
{
    if (tree->count >= 1u << 29)
        return GP_ERROR_UNSUPPORTED;
    const uint32_t pieces = neighbour_pieces(tree->count);
    Planes planes = { .tree = tree,
                      .normals = normals,
                      .links = { .points = gp_alloc_unset(tree->count * sizeof(LinkedPoint)),
                                 .links = gp_alloc_unset(PLANES_LINKS * (size_t)tree->count *
                                                         sizeof(uint32_t)),
                                 .places = tree->positions,
                                 .count = tree->count,
                                 .each = PLANES_LINKS },
                      .undefined = gp_alloc(pieces, sizeof(uint32_t)),
                      .estimated = gp_alloc(pieces, sizeof(uint32_t)) };
    GpResult result = GP_ERROR_MEMORY;
    if (planes.links.points && planes.links.links && planes.undefined && planes.estimated) {
        gp_pool_run(pool, pieces, fit_piece, &planes);
        result = links_orient(&planes.links, &facts->components);
    }
    for (uint32_t rank = 0; result == GP_OK && rank < tree->count; rank++)
        memcpy(normals + 3 * (size_t)tree->numbers[rank], planes.links.points[rank].normal,
               3 * sizeof *normals);
    facts->estimated = facts->undefined = 0;
    for (uint32_t piece = 0; result == GP_OK && piece < pieces; piece++) {
        facts->estimated += planes.estimated[piece];
        facts->undefined += planes.undefined[piece];
    }
    free_planes(&planes);
    return result;
}
