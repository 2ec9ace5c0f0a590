#include "apps/points/cloud/cells.h"

#include "apps/base/vector.h"

#include <float.h>
#include <string.h>

enum { SIDES = 8, MOST_CORNERS = SIDES + CELLS_NEIGHBOURS };

/* A convex polygon around (0, 0), counter-clockwise. */
typedef struct Corner {
    double x, y;
    bool is_limit; /* the side from it to the next is of the limit, not between neighbours */
} Corner;

typedef struct Cell {
    Corner corners[MOST_CORNERS];
    int count;
} Cell;

/* A neighbour in the tangent plane. */
typedef struct Beside {
    double x, y, distance2;
} Beside;

/* A regular octagon around a circle. */
static void set_limit(double radius, Cell *cell)
{
    static const double part = 0.41421356237309503; /* tan(22.5 degrees) */
    static const double places[SIDES][2] = { { 1, -part },  { 1, part },  { part, 1 },
                                             { -part, 1 },  { -1, part }, { -1, -part },
                                             { -part, -1 }, { part, -1 } };
    cell->count = SIDES;
    for (int i = 0; i < SIDES; i++)
        cell->corners[i] =
            (Corner){ .x = places[i][0] * radius, .y = places[i][1] * radius, .is_limit = true };
}

/* Takes off what is nearer to the neighbour; returns whether anything is. */
static bool cut(Cell *cell, const Beside *beside)
{
    double from[MOST_CORNERS]; /* above 0: nearer to the neighbour */
    bool is_cut = false;
    for (int i = 0; i < cell->count; i++) {
        const Corner *a = &cell->corners[i];
        from[i] = a->x * beside->x + a->y * beside->y - beside->distance2 / 2;
        is_cut |= !(from[i] <= 0);
    }
    if (!is_cut)
        return false;
    Corner whole[MOST_CORNERS];
    const int count = cell->count;
    memcpy(whole, cell->corners, (size_t)count * sizeof *whole);
    cell->count = 0;
    for (int i = 0; i < count; i++) {
        const int next = i + 1 < count ? i + 1 : 0;
        const Corner *a = &whole[i], *b = &whole[next];
        if (from[i] <= 0)
            cell->corners[cell->count++] = *a;
        if ((from[i] <= 0) == (from[next] <= 0) || cell->count == MOST_CORNERS)
            continue;
        const double share = from[i] / (from[i] - from[next]);
        /* Coming in: the new side ends and the old one goes on. Going out: the new one begins. */
        cell->corners[cell->count++] = (Corner){ .x = a->x + share * (b->x - a->x),
                                                 .y = a->y + share * (b->y - a->y),
                                                 .is_limit = from[i] > 0 && a->is_limit };
    }
    return true;
}

static double reach2_of(const Cell *cell)
{
    double reach2 = 0;
    for (int i = 0; i < cell->count; i++) {
        const Corner *c = &cell->corners[i];
        const double corner2 = c->x * c->x + c->y * c->y;
        reach2 = corner2 > reach2 ? corner2 : reach2;
    }
    return reach2;
}

/* Neighbours come nearest first: what is twice as far as the cell reaches, and all after it, cannot
 * cut it. */
static void find_cell(const Beside *beside, int count, double limit, Cell *cell)
{
    set_limit(limit, cell);
    double reach2 = reach2_of(cell);
    for (int i = 0; i < count && beside[i].distance2 < 4 * reach2; i++)
        if (cut(cell, &beside[i]))
            reach2 = reach2_of(cell);
}

static double area_of(const Cell *cell)
{
    double twice = 0;
    for (int i = 0; i < cell->count; i++) {
        const Corner *a = &cell->corners[i], *b = &cell->corners[(i + 1) % cell->count];
        twice += a->x * b->y - a->y * b->x;
    }
    return twice / 2;
}

/* The farthest corner between two neighbours; *is_open: there are others. */
static double reach_between(const Cell *cell, bool *is_open)
{
    double reach2 = 0;
    *is_open = false;
    for (int i = 0; i < cell->count; i++) {
        const Corner *c = &cell->corners[i];
        const bool is_limit =
            c->is_limit || cell->corners[(i + cell->count - 1) % cell->count].is_limit;
        *is_open |= is_limit;
        if (!is_limit)
            reach2 = fmax(reach2, c->x * c->x + c->y * c->y);
    }
    return sqrt(reach2);
}

/* Two axes of the plane. */
static void tangents(const double normal[3], double x[3], double y[3])
{
    int least = 0;
    for (int i = 1; i < 3; i++) {
        if (fabs(normal[i]) < fabs(normal[least]))
            least = i;
    }
    for (int i = 0; i < 3; i++)
        x[i] = (i == least) - normal[least] * normal[i];
    vector_normalize(x);
    vector_cross(normal, x, y);
}

typedef struct Measure {
    const NeighbourTree *tree;
    const float *normals;
    float *radii, *areas;
    float *caps;      /* by rank: what an open cell's disc is to reach at most; 0: it is not open */
    CellFacts *facts; /* of each piece */
} Measure;

static void load(const float *from, double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = (double)from[i];
}

/* The neighbours of the same sheet; returns their count. */
static int neighbours_beside(const Measure *measure, uint32_t rank, const Neighbour *found,
                             uint32_t count, Beside *beside)
{
    const NeighbourTree *tree = measure->tree;
    double normal[3], place[3], x[3], y[3];
    int kept = 0;
    load(measure->normals + 3 * (size_t)tree->numbers[rank], normal);
    load(tree->positions + 3 * (size_t)rank, place);
    tangents(normal, x, y);
    for (uint32_t i = 0; i < count; i++) {
        double to[3], other[3];
        load(tree->positions + 3 * (size_t)found[i].rank, to);
        load(measure->normals + 3 * (size_t)tree->numbers[found[i].rank], other);
        vector_subtract(to, place, to);
        const double along_x = vector_dot(to, x), along_y = vector_dot(to, y);
        const double across2 = along_x * along_x + along_y * along_y;
        if (!(vector_dot(normal, other) > 0) || !(2 * across2 > found[i].distance2))
            continue;
        const double stretch = sqrt(found[i].distance2 / across2);
        beside[kept++] = (Beside){ .x = along_x * stretch,
                                   .y = along_y * stretch,
                                   .distance2 = found[i].distance2 };
    }
    return kept;
}

/* The distance to the kept neighbour of that number, or to the last. */
static double distance_to(const Beside *beside, int count, int which)
{
    return sqrt(beside[which < count ? which : count - 1].distance2);
}

/* returns whether the cell is open */
static bool measure_cell(const Beside *beside, int count, double *radius, double *area)
{
    bool is_open;
    Cell cell;
    find_cell(beside, count, distance_to(beside, count, count - 1), &cell);
    *radius = reach_between(&cell, &is_open);
    *area = area_of(&cell);
    if (!is_open)
        return false;
    const double limit = distance_to(beside, count, 2) / 2;
    find_cell(beside, count, limit, &cell);
    *radius = fmax(fmin(*radius, distance_to(beside, count, 3)), limit);
    *area = area_of(&cell);
    return true;
}

static void measure_piece(void *context, uint32_t piece, int worker)
{
    const Measure *measure = context;
    const NeighbourTree *tree = measure->tree;
    uint32_t rank;
    const uint32_t end = neighbour_piece(tree->count, piece, &rank);
    CellFacts facts = { .nearest_least = (double)INFINITY };
    (void)worker;
    Neighbour found[CELLS_NEIGHBOURS];
    for (uint32_t count = 0; rank < end; rank++) {
        Beside beside[CELLS_NEIGHBOURS];
        count = neighbours_of(tree, rank, CELLS_NEIGHBOURS, count, found);
        const double nearest = count > 0 ? sqrt(found[0].distance2) : 0;
        double radius = nearest / 2, area = 3.141592653589793 * radius * radius;
        const int kept = neighbours_beside(measure, rank, found, count, beside);
        const bool is_open = kept == 0 || measure_cell(beside, kept, &radius, &area);
        measure->caps[rank] = is_open ? INFINITY : 0;
        facts.boundary += is_open;
        facts.nearest_sum += nearest;
        facts.nearest_least = fmin(facts.nearest_least, nearest);
        facts.nearest_most = fmax(facts.nearest_most, nearest);
        measure->radii[tree->numbers[rank]] = (float)fmax(radius, (double)FLT_MIN);
        measure->areas[tree->numbers[rank]] = (float)fmax(area, (double)FLT_MIN);
    }
    measure->facts[piece] = facts;
}

/* Once all radii are known. */
static void cap_piece(void *context, uint32_t piece, int worker)
{
    const Measure *measure = context;
    const NeighbourTree *tree = measure->tree;
    uint32_t rank;
    const uint32_t end = neighbour_piece(tree->count, piece, &rank);
    (void)worker;
    for (; rank < end; rank++) {
        Neighbour found[4];
        if (measure->caps[rank] == 0)
            continue;
        const uint32_t count = neighbours_of(tree, rank, 4, 0, found);
        for (uint32_t i = 0; i < count; i++) {
            const float cap = 2 * measure->radii[tree->numbers[found[i].rank]];
            if (cap < measure->caps[rank])
                measure->caps[rank] = cap;
        }
    }
}

static void apply_caps(const Measure *measure)
{
    for (uint32_t rank = 0; rank < measure->tree->count; rank++) {
        const float cap = measure->caps[rank];
        float *radius = &measure->radii[measure->tree->numbers[rank]];
        float *area = &measure->areas[measure->tree->numbers[rank]];
        if (!(cap > 0 && cap < *radius))
            continue;
        *radius = cap;
        *area = fminf(*area, 3.1415927F * cap * cap);
    }
}

GpResult cells_measure(const NeighbourTree *tree, const float *normals, GpPool *pool, float *radii,
                       float *areas, CellFacts *facts)
{
    const uint32_t pieces = neighbour_pieces(tree->count);
    Measure measure = { .tree = tree,
                        .normals = normals,
                        .radii = radii,
                        .areas = areas,
                        .caps = gp_alloc_unset(tree->count * sizeof(float)),
                        .facts = gp_alloc(pieces, sizeof(CellFacts)) };
    if (!measure.facts || !measure.caps) {
        gp_free(measure.facts);
        gp_free(measure.caps);
        return GP_ERROR_MEMORY;
    }
    gp_pool_run(pool, pieces, measure_piece, &measure);
    gp_pool_run(pool, pieces, cap_piece, &measure);
    apply_caps(&measure);
    *facts = measure.facts[0];
    for (uint32_t i = 1; i < pieces; i++) {
        const CellFacts *piece = &measure.facts[i];
        facts->nearest_sum += piece->nearest_sum;
        facts->nearest_least = fmin(facts->nearest_least, piece->nearest_least);
        facts->nearest_most = fmax(facts->nearest_most, piece->nearest_most);
        facts->boundary += piece->boundary;
    }
    gp_free(measure.facts);
    gp_free(measure.caps);
    return GP_OK;
}
