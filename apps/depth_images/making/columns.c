#include "apps/depth_images/making/columns.h"

#include "apps/base/stable_math.h"
#include "apps/base/vector.h"

/* A vertex as the axis sees it. */
typedef struct Around {
    double place[2]; /* across the axis: along zero, along axis x zero */
    double turn;     /* 0..1 */
} Around;

static Around around_of(const DepthCylinder *cylinder, const double aside[3],
                        const float position[3])
{
    double off[3];
    for (int k = 0; k < 3; k++)
        off[k] = (double)position[k] - cylinder->center[k];
    Around around = { { vector_dot(off, cylinder->zero), vector_dot(off, aside) }, 0 };
    const double turn = stable_atan2(around.place[1], around.place[0]) / 0x1.921fb54442d18p+2;
    around.turn = turn < 0 ? turn + 1 : turn;
    return around;
}

static double cross(const Around *a, const Around *b)
{
    return a->place[0] * b->place[1] - a->place[1] * b->place[0];
}

/* How near to the axis a triangle comes, seen along it: 0 where the axis goes through it, or where
 * its corners lie in one plane with the axis. */
static double distance_of(const Around *const corner[3])
{
    double nearest = HUGE_VAL;
    int left = 0, right = 0;
    for (int i = 0; i < 3; i++) {
        const Around *a = corner[i], *b = corner[(i + 1) % 3];
        const double area = cross(a, b);
        left += area >= 0;
        right += area <= 0;
        const double along[2] = { b->place[0] - a->place[0], b->place[1] - a->place[1] };
        const double length = along[0] * along[0] + along[1] * along[1];
        double t = length > 0 ? -(a->place[0] * along[0] + a->place[1] * along[1]) / length : 0;
        t = t < 0 ? 0 : t > 1 ? 1 : t;
        const double x = a->place[0] + t * along[0], y = a->place[1] + t * along[1];
        nearest = fmin(nearest, sqrt(x * x + y * y));
    }
    return left == 3 || right == 3 ? 0 : nearest;
}

/* The corners' turns without the largest gap between them, which is more than half a turn where the
 * axis is not in the triangle. */
static void arc_of(const Around *const corner[3], double *first, double *length)
{
    double gap = -1;
    for (int i = 0; i < 3; i++) {
        double next = 2; /* from this corner on to the next one, round the seam */
        for (int j = 0; j < 3; j++) {
            const double on = corner[j]->turn - corner[i]->turn;
            const double step = on < 0 || (on == 0 && j <= i) ? on + 1 : on;
            next = fmin(next, step);
        }
        if (next > gap) {
            gap = next;
            *first = corner[i]->turn + next;
        }
    }
    *length = fmax(0, 1 - gap);
}

static ColumnRange range_of(const Around *const corner[3], double radius, uint32_t columns)
{
    const ColumnRange all = { 0, columns };
    const double near = distance_of(corner);
    const double wall = 2 * 3.14159265358979323846 * radius / columns; /* width of a column there */
    if (!(near * 2 > wall / 256))
        return all;
    /* A corner moves by at most wall / 512 in a column's picture, which turns it by so many
     * columns. */
    const double room = 1 + radius / near / 128;
    double first = 0, length = 0;
    arc_of(corner, &first, &length);
    const double low = ceil(first * columns - 0.5 - room);
    const double high = floor((first + length) * columns - 0.5 + room);
    if (!(high - low + 1 < columns))
        return all;
    const double start = low - columns * floor(low / columns);
    return (ColumnRange){ (uint32_t)start % columns, (uint32_t)(high - low) + 1 };
}

GpResult columns_of(const DepthCylinder *cylinder, const GpMesh *mesh, uint32_t columns,
                    ColumnRange **ranges)
{
    double aside[3];
    vector_cross(cylinder->axis, cylinder->zero, aside);
    Around *around = gp_alloc(mesh->vertex_count, sizeof *around);
    ColumnRange *made = gp_alloc(mesh->triangle_count, sizeof *made);
    if (!around || !made) {
        gp_free(around);
        gp_free(made);
        return GP_ERROR_MEMORY;
    }
    for (size_t i = 0; i < mesh->vertex_count; i++)
        around[i] = around_of(cylinder, aside, mesh->positions + 3 * i);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *index = mesh->indices + 3 * i;
        const Around *const corner[3] = { &around[index[0]], &around[index[1]], &around[index[2]] };
        made[i] = range_of(corner, cylinder->radius, columns);
    }
    gp_free(around);
    *ranges = made;
    return GP_OK;
}
