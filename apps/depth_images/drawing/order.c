#include "apps/depth_images/drawing/order.h"

#include <string.h>

/* Of what is at infinity the side of the picture that it is on. */
static double place_of(double over, double under, double first, double size, double pixels)
{
    if (under != 0)
        return (over / under - first) / size * pixels;
    return over > 0 ? (double)INFINITY : over < 0 ? -(double)INFINITY : 0;
}

WarpOrder warp_order(const DepthPlane *plane, const DepthPixels *pixels, const double eye[4])
{
    const double under = plane->is_parallel ? eye[3] : eye[2];
    return (WarpOrder){
        .epipole = { place_of(eye[0], under, plane->left, plane->width, pixels->width),
                     place_of(-eye[1], under, -(plane->bottom + plane->height), plane->height,
                              pixels->height) },
        .away = under < 0,
    };
}

/* Cells from first to last, either of which may be the greater. */
typedef struct Run {
    int64_t first, last;
    int step;
} Run;

/* The two runs of cells on both sides of the epipole, along an axis; that which has it is the
 * second.
 * returns in runs[]: none is one whose last is not reached from the first */
static void cut(const WarpOrder *order, const DepthLattice *lattice, int axis, Run runs[2])
{
    const int64_t cells = (int64_t)(axis ? lattice->height : lattice->width) - 1;
    const double at = (order->epipole[axis] - 0.5) / lattice->step;
    const int64_t split = at <= 0 ? 0 : at >= (double)cells ? cells : (int64_t)at;
    runs[0] = (Run){ 0, split - 1, 1 };
    runs[1] = (Run){ cells - 1, split, -1 };
    for (int i = 0; i < 2 && order->away; i++)
        runs[i] = (Run){ runs[i].last, runs[i].first, -runs[i].step };
}

static bool is_between(const DepthLattice *lattice, size_t vertex, const double range[2])
{
    const double depth = depth_flat(lattice->is_parallel, (double)lattice->flat[vertex]);
    return depth >= range[0] && depth <= range[1];
}

/* A cell's halves, of which that comes first that its order begins at. */
static void add_cell(const DepthLattice *lattice, uint32_t corner, bool right, bool down,
                     uint32_t *indices)
{
    const uint32_t a = corner, b = corner + 1, c = corner + lattice->width, d = c + 1;
    const uint32_t halves[4][6] = { { d, b, c, b, a, c },   /* to the left, upwards */
                                    { c, d, a, a, d, b },   /* to the right, upwards */
                                    { a, d, b, c, d, a },   /* to the left, downwards */
                                    { b, a, c, d, b, c } }; /* to the right, downwards */
    memcpy(indices, halves[2 * down + right], sizeof halves[0]);
}

uint32_t warp_order_cells(const WarpOrder *order, const DepthLattice *lattice,
                          const double range[2], uint32_t *indices)
{
    Run across[2], down[2];
    uint32_t count = 0;
    cut(order, lattice, 0, across);
    cut(order, lattice, 1, down);
    for (int i = 0; i < 4;
         i++) { /* the epipole's own row and column are at the end, or the beginning */
        const int sheet = order->away ? 3 - i : i;
        const Run *h = &across[sheet & 1], *v = &down[sheet >> 1];
        for (int64_t y = v->first; y * v->step <= v->last * v->step; y += v->step)
            for (int64_t x = h->first; x * h->step <= h->last * h->step; x += h->step) {
                const size_t at = (size_t)y * lattice->width + (size_t)x;
                if (!depth_lattice_is_whole(lattice, x, y) || !is_between(lattice, at, range) ||
                    !is_between(lattice, at + 1, range) ||
                    !is_between(lattice, at + lattice->width, range) ||
                    !is_between(lattice, at + lattice->width + 1, range))
                    continue;
                add_cell(lattice, (uint32_t)at, h->step > 0, v->step > 0, indices + count);
                count += 6;
            }
    }
    return count;
}
