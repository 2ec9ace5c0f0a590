#include "apps/truth/voxel_probes.h"

#include "apps/truth/even_points.h"
#include "apps/truth/triangle.h"

enum {
    PROBES = 2000000,
    BLOCKS = 100, /* of them, which threads share out */
    CELLS = 512,  /* a side of the grid by which those above and below a triangle are found */
};

static const double wider = 1.125; /* than the model's box */

/* Probes by cells of x and y: those of cell i are from start[i] to start[i + 1] of `order`. */
typedef struct Grid {
    uint32_t *start, *order;
    int32_t *number; /* of each probe, in the probes' order */
} Grid;

static void place_of(const VoxelProbes *probes, uint32_t i, double point[3])
{
    truth_even_in_cube(i, point);
    for (int k = 0; k < 3; k++)
        point[k] = probes->low[k] + probes->side * point[k];
}

/* --- the grid --------------------------------------------------------------------------------- */

static uint32_t cell_of(uint32_t i)
{
    double place[3];
    truth_even_in_cube(i, place);
    return (uint32_t)(place[1] * CELLS) * CELLS + (uint32_t)(place[0] * CELLS);
}

/* Counts, sums, and fills from the back, so that each cell's start is reached at last. */
static void fill_grid(const Grid *grid)
{
    for (uint32_t i = 0; i < PROBES; i++)
        grid->start[cell_of(i)]++;
    for (uint32_t i = 1; i <= CELLS * CELLS; i++)
        grid->start[i] += grid->start[i - 1];
    for (uint32_t i = PROBES; i-- > 0;)
        grid->order[--grid->start[cell_of(i)]] = i;
}

/* Cells that lie between two places, in full or in part. */
static void cells_between(double low, double high, double origin, double side, uint32_t range[2])
{
    const double scale = CELLS / side, places[2] = { low, high };
    for (int i = 0; i < 2; i++)
        range[i] = (uint32_t)fmin(fmax((places[i] - origin) * scale, 0), CELLS - 1);
}

/* --- inside ----------------------------------------------------------------------------------- */

/* Counts in those of a row of cells that a triangle is above: 1, or -1 where it faces down. */
static void count_row(const VoxelProbes *probes, const Grid *grid, uint32_t first, uint32_t last,
                      const TruthTriangle *triangle, const TruthProjection *projection)
{
    double normal[3];
    truth_normal(triangle, normal);
    for (uint32_t k = grid->start[first]; k < grid->start[last + 1]; k++) {
        const uint32_t i = grid->order[k];
        double point[3];
        place_of(probes, i, point);
        if (truth_covers(projection, point[0], point[1]) &&
            point[2] < truth_depth(triangle, normal, projection, point[0], point[1]))
            grid->number[i] += normal[2] > 0 ? 1 : -1;
    }
}

static void count_below(const VoxelProbes *probes, const Grid *grid, const TruthTriangle *triangle)
{
    const TruthProjection projection = truth_project(triangle, 2);
    uint32_t range[2][2];
    if (projection.area == 0) /* seen from its edge */
        return;
    for (int k = 0; k < 2; k++) {
        double low, high;
        truth_bounds(triangle, k, &low, &high);
        cells_between(low, high, probes->low[k], probes->side, range[k]);
    }
    for (uint32_t y = range[1][0]; y <= range[1][1]; y++)
        count_row(probes, grid, y * CELLS + range[0][0], y * CELLS + range[0][1], triangle,
                  &projection);
}

/* A number is odd where that of the triangles is, whichever way they face. */
static void set_inside(const Grid *grid, VoxelInside inside, VoxelProbes *probes)
{
    for (uint32_t i = 0; i < PROBES; i++) {
        const bool in = inside == VOXEL_BY_PARITY ? grid->number[i] % 2 != 0 : grid->number[i] != 0;
        probes->inside[i / 8] = (uint8_t)(probes->inside[i / 8] | (unsigned)in << i % 8);
        probes->inside_count += in;
    }
}

static void set_cube(const TruthTriangle *triangles, uint32_t count, VoxelProbes *probes)
{
    Bounds box = bounds_of_nothing;
    for (size_t i = 0; i < 3 * (size_t)count; i++)
        bounds_add(&box, triangles[i / 3].corner[i % 3]);
    probes->side = bounds_longest(&box) * wider;
    for (int k = 0; k < 3; k++)
        probes->low[k] = 0.5 * (box.low[k] + box.high[k]) - 0.5 * probes->side;
}

GpResult voxel_probes_make(const TruthTriangle *triangles, uint32_t count, VoxelInside inside,
                           VoxelProbes *probes)
{
    VoxelProbes made = { .inside = gp_alloc((PROBES + 7) / 8, 1) };
    const Grid grid = { gp_alloc(CELLS * CELLS + 1, sizeof *grid.start),
                        gp_alloc(PROBES, sizeof *grid.order),
                        gp_alloc(PROBES, sizeof *grid.number) };
    bool good = made.inside && grid.start && grid.order && grid.number;
    if (good) {
        set_cube(triangles, count, &made);
        fill_grid(&grid);
        for (uint32_t i = 0; i < count; i++)
            count_below(&made, &grid, &triangles[i]);
        set_inside(&grid, inside, &made);
        *probes = made;
    } else {
        voxel_probes_free(&made);
    }
    gp_free(grid.start);
    gp_free(grid.order);
    gp_free(grid.number);
    return good ? GP_OK : GP_ERROR_MEMORY;
}

void voxel_probes_free(VoxelProbes *probes)
{
    gp_free(probes->inside);
    *probes = (VoxelProbes){ .inside = NULL };
}

/* --- wrong ------------------------------------------------------------------------------------ */

/* out  place: the bit of the voxel that a point lies in; false: in none */
static bool find_voxel(const VoxelBox *space, const double point[3], size_t *place)
{
    size_t at[3];
    for (int k = 0; k < 3; k++) {
        const double p = space->scale * point[k] + space->offset[k];
        if (!(p >= 0 && p < space->size))
            return false;
        at[k] = (size_t)p;
    }
    *place = at[0] + space->size * (at[1] + space->size * at[2]);
    return true;
}

/* Probes by blocks, which any thread counts. */
typedef struct Held {
    const VoxelProbes *probes;
    const VoxelBox *space;
    const uint8_t *bits;
    uint32_t wrong[BLOCKS];
} Held;

static void count_wrong(void *context, uint32_t block, int worker)
{
    Held *held = context;
    (void)worker;
    for (uint32_t i = block * (PROBES / BLOCKS); i < (block + 1) * (PROBES / BLOCKS); i++) {
        double point[3];
        size_t voxel;
        place_of(held->probes, i, point);
        if (find_voxel(held->space, point, &voxel))
            held->wrong[block] +=
                ((held->probes->inside[i / 8] >> i % 8) ^ (held->bits[voxel / 8] >> voxel % 8)) & 1;
    }
}

double voxel_probes_wrong(const VoxelProbes *probes, const VoxelBox *space, const uint8_t *bits,
                          GpPool *pool)
{
    Held held = { probes, space, bits, { 0 } };
    uint64_t wrong = 0;
    gp_pool_run(pool, BLOCKS, count_wrong, &held);
    for (int i = 0; i < BLOCKS; i++)
        wrong += held.wrong[i];
    return (double)wrong / fmax((double)probes->inside_count, 1);
}
