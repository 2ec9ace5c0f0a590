#include "apps/volumes/bricks.h"

#include <string.h>

enum { MOST_SAMPLES = 1024 }; /* of a field's side */

/* --- ranges ----------------------------------------------------------------------------------- */

/* Samples of a side that belong to a brick: [first, end). */
static uint32_t end_of(const Field *field, int axis, uint32_t brick)
{
    const uint32_t end = (brick + 1) * BRICK_SIDE + 1;
    return end < field->size[axis] ? end : field->size[axis];
}

/* The least and the most at each x of the rows of samples that are a row of bricks'. */
typedef struct Column {
    uint8_t least[MOST_SAMPLES], most[MOST_SAMPLES];
} Column;

static void widen_one(Column *column, uint32_t x, uint8_t value)
{
    column->least[x] = value < column->least[x] ? value : column->least[x];
    column->most[x] = value > column->most[x] ? value : column->most[x];
}

/* AT_ONCE is known to the compiler, which takes them in one vector. */
static void widen(Column *restrict column, const uint8_t *restrict row, uint32_t count)
{
    enum { AT_ONCE = 16 };
    uint32_t x = 0;
    for (; x + AT_ONCE <= count; x += AT_ONCE)
        for (uint32_t i = x; i < x + AT_ONCE; i++)
            widen_one(column, i, row[i]);
    for (; x < count; x++)
        widen_one(column, x, row[x]);
}

static void find_range(const Field *field, const Column *column, uint32_t brick, uint8_t range[2])
{
    const uint32_t first = brick * BRICK_SIDE, end = end_of(field, 0, brick);
    range[0] = FIELD_VALUES - 1;
    range[1] = 0;
    for (uint32_t x = first; x < end; x++) {
        range[0] = column->least[x] < range[0] ? column->least[x] : range[0];
        range[1] = column->most[x] > range[1] ? column->most[x] : range[1];
    }
}

GpResult bricks_make(const Field *field, Bricks *bricks, GpError *error)
{
    Bricks made = { { 0 }, NULL };
    for (int i = 0; i < 3; i++)
        made.count[i] = (field->size[i] - 1 + BRICK_SIDE - 1) / BRICK_SIDE;
    made.range = gp_alloc(bricks_total(&made) + 1, sizeof *made.range);
    if (!made.range)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    uint8_t(*row)[2] = made.range;
    for (uint32_t z = 0; z < made.count[2]; z++)
        for (uint32_t y = 0; y < made.count[1]; y++, row += made.count[0]) {
            Column column;
            memset(column.least, FIELD_VALUES - 1, sizeof column.least);
            memset(column.most, 0, sizeof column.most);
            for (uint32_t k = z * BRICK_SIDE; k < end_of(field, 2, z); k++)
                for (uint32_t j = y * BRICK_SIDE; j < end_of(field, 1, y); j++)
                    widen(&column, field->value + ((size_t)k * field->size[1] + j) * field->size[0],
                          field->size[0]);
            for (uint32_t x = 0; x < made.count[0]; x++)
                find_range(field, &column, x, row[x]);
        }
    *bricks = made;
    return GP_OK;
}

void bricks_free(Bricks *bricks)
{
    gp_free(bricks->range);
    *bricks = (Bricks){ { 0 }, NULL };
}

/* --- what they show --------------------------------------------------------------------------- */

/* Whether values from one whole number to the next have any opacity; out: how many before value i
 * do. */
static void count_shown(const Transfer *transfer, uint32_t before[FIELD_VALUES])
{
    bool shown[FIELD_VALUES] = { false };
    for (uint32_t i = 0; i + 1 < FIELD_VALUES; i++) {
        double low[4], high[4];
        transfer_at(transfer, i, low);
        transfer_at(transfer, i + 1, high);
        shown[i] = low[3] > 0 || high[3] > 0;
    }
    for (uint32_t i = 0; i < transfer->count; i++) {
        const TransferStop *stop = &transfer->stops[i];
        if (stop->rgba[3] > 0 && stop->value >= 0 && stop->value < FIELD_VALUES - 1)
            shown[(int)stop->value] = true;
    }
    before[0] = 0;
    for (uint32_t i = 0; i + 1 < FIELD_VALUES; i++)
        before[i + 1] = before[i] + shown[i];
}

static bool shows(const uint32_t before[FIELD_VALUES], const uint8_t range[2])
{
    const int least = range[0] > 0 ? range[0] - 1 : 0;
    const int most = range[1] < FIELD_VALUES - 1 ? range[1] + 1 : FIELD_VALUES - 1;
    return before[most] > before[least];
}

void bricks_show(const Bricks *bricks, const Transfer *transfer, uint8_t *shown)
{
    uint32_t before[FIELD_VALUES];
    count_shown(transfer, before);
    for (size_t i = 0; i < bricks_total(bricks); i++)
        shown[i] = shows(before, bricks->range[i]);
}

/* --- runs ------------------------------------------------------------------------------------- */

/* Row (y, z) of an array of bricks; of what lies beyond it, all is far. */
static const uint8_t *row_at(const Bricks *bricks, const uint8_t *array, int64_t y, int64_t z,
                             const uint8_t *far)
{
    if (y < 0 || z < 0 || y >= bricks->count[1] || z >= bricks->count[2])
        return far;
    return array + ((size_t)z * bricks->count[1] + (size_t)y) * bricks->count[0];
}

static uint8_t lesser(uint8_t a, uint8_t b)
{
    return a < b ? a : b;
}

/* A row of cubes from the three rows ahead: one more than the least of the seven that begin at the
 * next bricks; 0 where the brick itself is not of the kind. The mathematics of the largest square
 * of an image in one scan, as everyone knows it, in three dimensions. */
static void grow_row(uint8_t *cube, const uint8_t *is, uint8_t kind, const uint8_t *const ahead[3],
                     uint32_t count, bool falls)
{
    uint8_t next = BRICKS_FAR, next_ahead = BRICKS_FAR; /* what the brick along the row has */
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t x = falls ? i : count - 1 - i;
        const uint8_t least = lesser(lesser(ahead[0][x], ahead[1][x]), ahead[2][x]);
        const uint8_t all = lesser(lesser(least, next_ahead), next);
        next = is[x] != kind ? 0 : all < BRICKS_FAR ? (uint8_t)(all + 1) : BRICKS_FAR;
        next_ahead = least;
        cube[x] = next;
    }
}

/* out  cubes: sides of the largest cubes of bricks of one kind */
static void grow_cubes(const Bricks *bricks, const uint8_t *is, uint8_t kind, unsigned way,
                       uint8_t *cubes)
{
    const uint32_t nx = bricks->count[0], ny = bricks->count[1], nz = bricks->count[2];
    const int64_t along_y = way & 2 ? -1 : 1, along_z = way & 4 ? -1 : 1;
    uint8_t far[MOST_SAMPLES / BRICK_SIDE];
    memset(far, BRICKS_FAR, sizeof far);
    GP_ASSERT(nx <= sizeof far);
    for (uint32_t k = 0; k < nz; k++)
        for (uint32_t j = 0; j < ny; j++) {
            const int64_t z = way & 4 ? k : nz - 1 - k, y = way & 2 ? j : ny - 1 - j;
            const uint8_t *ahead[3] = { row_at(bricks, cubes, y + along_y, z, far),
                                        row_at(bricks, cubes, y, z + along_z, far),
                                        row_at(bricks, cubes, y + along_y, z + along_z, far) };
            const size_t row = ((size_t)z * ny + (size_t)y) * nx;
            grow_row(cubes + row, is + row, kind, ahead, nx, way & 1);
        }
}

GpResult bricks_runs(const Bricks *bricks, const uint8_t *shown, unsigned way, uint8_t *runs,
                     GpError *error)
{
    const size_t total = bricks_total(bricks);
    uint8_t *empty = gp_alloc(total + 1, 1);
    if (!empty)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    grow_cubes(bricks, shown, 0, way, empty);
    grow_cubes(bricks, empty, 0, way, runs);
    for (size_t i = 0; i < total; i++)
        runs[i] = empty[i] ? (uint8_t)(BRICKS_FAR + empty[i]) : runs[i];
    gp_free(empty);
    return GP_OK;
}
