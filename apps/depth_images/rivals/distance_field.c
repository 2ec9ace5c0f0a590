#include "apps/depth_images/rivals/distance_field.h"

#include <math.h>
#include <string.h>

/* What one row of samples needs. */
typedef struct Row {
    double *from, *to; /* [count] squares of distances */
    uint32_t *lowest;  /* [count]: parabolas of the lower envelope, by where they stand */
    double *begins;    /* [count]: where each of them begins to be it */
} Row;

/* Where two parabolas meet, in samples; per: square of a sample's length. */
static double meet(const Row *row, uint32_t left, uint32_t right, double per)
{
    const double a = left, b = right;
    return ((row->from[right] - row->from[left]) / per + (b - a) * (b + a)) / (2 * (b - a));
}

/* to[i] = min over j of from[j] + per (i - j)^2 */
static void transform(const Row *row, uint32_t count, double per)
{
    uint32_t parabolas = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (!isfinite(row->from[i]))
            continue;
        double begin = -HUGE_VAL;
        while (parabolas > 0) {
            begin = meet(row, row->lowest[parabolas - 1], i, per);
            if (begin > row->begins[parabolas - 1])
                break;
            parabolas--;
            begin = -HUGE_VAL;
        }
        row->lowest[parabolas] = i;
        row->begins[parabolas++] = begin;
    }
    for (uint32_t i = 0, at = 0; i < count; i++) {
        while (at + 1 < parabolas && row->begins[at + 1] <= i)
            at++;
        const double off = parabolas ? (double)i - row->lowest[at] : 0;
        row->to[i] = parabolas ? row->from[row->lowest[at]] + per * off * off : (double)INFINITY;
    }
}

static double square_of(double a)
{
    return a * a;
}

/* Squares of distances from a slice's samples to the columns: first up and down, then along x and
 * y.
 * in/out square: [size[1]][size[0]] */
static void find_slice(const DistanceColumns *columns, uint32_t slice, const Row *row,
                       double *square)
{
    const uint32_t nx = columns->size[0], ny = columns->size[1];
    const double z = (double)slice / (columns->size[2] - 1);
    const double per[2] = { square_of(columns->metric[0] / (nx - 1)),
                            square_of(columns->metric[1] / (ny - 1)) };
    for (uint32_t y = 0; y < ny; y++) {
        for (uint32_t x = 0; x < nx; x++) {
            const double top = (double)columns->z[(size_t)y * nx + x];
            const double off =
                fmax(fmax(top - z, z - top - columns->thickness), 0) * columns->metric[2];
            row->from[x] = top <= 1 ? off * off : (double)INFINITY;
        }
        transform(row, nx, per[0]);
        memcpy(square + (size_t)y * nx, row->to, nx * sizeof *square);
    }
    for (uint32_t x = 0; x < nx; x++) {
        for (uint32_t y = 0; y < ny; y++)
            row->from[y] = square[(size_t)y * nx + x];
        transform(row, ny, per[1]);
        for (uint32_t y = 0; y < ny; y++)
            square[(size_t)y * nx + x] = row->to[y];
    }
}

GpResult distance_field_make(const DistanceColumns *columns, double reach, uint8_t *codes)
{
    const uint32_t nx = columns->size[0], ny = columns->size[1];
    const size_t longest = nx > ny ? nx : ny, area = (size_t)nx * ny;
    Row row = { gp_alloc(longest, sizeof *row.from), gp_alloc(longest, sizeof *row.to),
                gp_alloc(longest, sizeof *row.lowest), gp_alloc(longest, sizeof *row.begins) };
    double *square = gp_alloc(area, sizeof *square);
    const bool has_memory = row.from && row.to && row.lowest && row.begins && square;
    for (uint32_t slice = 0; slice < columns->size[2] && has_memory; slice++) {
        find_slice(columns, slice, &row, square);
        for (size_t i = 0; i < area; i++)
            codes[slice * area + i] = (uint8_t)(fmin(sqrt(square[i]) / reach, 1) * 255);
    }
    gp_free(row.from);
    gp_free(row.to);
    gp_free(row.lowest);
    gp_free(row.begins);
    gp_free(square);
    return has_memory ? GP_OK : GP_ERROR_MEMORY;
}
