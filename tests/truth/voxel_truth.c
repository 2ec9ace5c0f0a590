#include "tests/truth/voxel_truth.h"

#include <string.h>

/* --- space ------------------------------------------------------------------------------------ */

VoxelSpace voxel_space(const float *positions, const uint32_t *indices, uint32_t count,
                       uint32_t size)
{
    double low[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL }, high[3], longest = 0;
    for (int k = 0; k < 3; k++)
        high[k] = -HUGE_VAL;
    for (size_t i = 0; i < 3 * (size_t)count; i++)
        for (int k = 0; k < 3; k++) {
            double p = (double)positions[3 * (size_t)indices[i] + (size_t)k];
            low[k] = fmin(low[k], p);
            high[k] = fmax(high[k], p);
        }
    for (int k = 0; k < 3; k++)
        longest = fmax(longest, high[k] - low[k]);
    VoxelSpace space = { size, longest > 0 ? (size - 2.5) / longest : 1, { 0 } };
    for (int k = 0; k < 3; k++)
        space.offset[k] = size / 2.0 - space.scale * (0.5 * (low[k] + high[k]));
    return space;
}

void voxel_triangles(const float *positions, const uint32_t *indices, uint32_t count,
                     const VoxelSpace *space, TruthTriangle *triangles)
{
    for (size_t i = 0; i < 3 * (size_t)count; i++)
        for (int k = 0; k < 3; k++) {
            double p = (double)positions[3 * (size_t)indices[i] + (size_t)k];
            triangles[i / 3].corner[i % 3][k] = space->scale * p + space->offset[k];
        }
}

size_t voxel_bytes(uint32_t size)
{
    return ((size_t)size * size * size + 7) / 8;
}

static void set_voxel(uint8_t *bits, uint32_t size, const int64_t at[3])
{
    for (int k = 0; k < 3; k++)
        if (at[k] < 0 || at[k] >= size)
            return;
    size_t i = (size_t)at[0] + size * ((size_t)at[1] + size * (size_t)at[2]);
    bits[i / 8] = (uint8_t)(bits[i / 8] | 1u << i % 8);
}

uint64_t voxel_count(const uint8_t *bits, uint32_t size)
{
    uint64_t count = 0;
    for (size_t i = 0; i < voxel_bytes(size); i++)
        count += (unsigned)__builtin_popcount(bits[i]);
    return count;
}

/* Voxels of the volume from the one that holds `low` to the one that holds `high`. */
static void range(double low, double high, uint32_t size, int64_t *first, int64_t *last)
{
    *first = (int64_t)fmax(floor(low), 0);
    *last = (int64_t)fmin(floor(high), (double)size - 1);
}

static void bounds(const TruthTriangle *t, int axis, double *low, double *high)
{
    *low = fmin(t->corner[0][axis], fmin(t->corner[1][axis], t->corner[2][axis]));
    *high = fmax(t->corner[0][axis], fmax(t->corner[1][axis], t->corner[2][axis]));
}

static void normal_of(const TruthTriangle *t, double normal[3])
{
    double edge[2][3];
    truth_subtract(t->corner[1], t->corner[0], edge[0]);
    truth_subtract(t->corner[2], t->corner[0], edge[1]);
    truth_cross(edge[0], edge[1], normal);
}

/* --- overlap ---------------------------------------------------------------------------------- */

/* Whether the images on an axis of a triangle around a box's middle and of the box are apart. */
static bool parts(const double axis[3], double corner[3][3], double half)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        double place = truth_dot(axis, corner[i]);
        low = fmin(low, place);
        high = fmax(high, place);
    }
    double reach = half * (fabs(axis[0]) + fabs(axis[1]) + fabs(axis[2]));
    return low > reach || high < -reach;
}

static bool touches(const TruthTriangle *t, const double middle[3], double half)
{
    double corner[3][3], normal[3];
    for (int i = 0; i < 3; i++)
        truth_subtract(t->corner[i], middle, corner[i]);
    normal_of(t, normal);
    if (parts(normal, corner, half))
        return false;
    for (int k = 0; k < 3; k++) {
        const double side[3] = { k == 0, k == 1, k == 2 };
        if (parts(side, corner, half))
            return false;
        for (int i = 0; i < 3; i++) {
            double edge[3], axis[3];
            truth_subtract(corner[(i + 1) % 3], corner[i], edge);
            truth_cross(side, edge, axis);
            if (parts(axis, corner, half))
                return false;
        }
    }
    return true;
}

void voxel_surface(const TruthTriangle *triangles, uint32_t count, uint32_t size, double margin,
                   uint8_t *bits)
{
    for (uint32_t i = 0; i < count; i++) {
        int64_t first[3], last[3], at[3];
        for (int k = 0; k < 3; k++) {
            double low, high;
            bounds(&triangles[i], k, &low, &high);
            /* a voxel's closed box holds its upper side too */
            range(low - margin - 1, high + margin + 1, size, &first[k], &last[k]);
        }
        for (at[2] = first[2]; at[2] <= last[2]; at[2]++)
            for (at[1] = first[1]; at[1] <= last[1]; at[1]++)
                for (at[0] = first[0]; at[0] <= last[0]; at[0]++) {
                    const double middle[3] = { (double)at[0] + 0.5, (double)at[1] + 0.5,
                                               (double)at[2] + 0.5 };
                    if (touches(&triangles[i], middle, 0.5 + margin))
                        set_voxel(bits, size, at);
                }
    }
}

/* --- samples ---------------------------------------------------------------------------------- */

/* A triangle along an axis: u and v are the next two. */
typedef struct Projection {
    int axis, u, v;
    double corner[3][2];
    double area; /* twice, with its sign */
} Projection;

static Projection project(const TruthTriangle *t, int axis)
{
    Projection p = { .axis = axis, .u = (axis + 1) % 3, .v = (axis + 2) % 3 };
    for (int i = 0; i < 3; i++) {
        p.corner[i][0] = t->corner[i][p.u];
        p.corner[i][1] = t->corner[i][p.v];
    }
    p.area = (p.corner[1][0] - p.corner[0][0]) * (p.corner[2][1] - p.corner[0][1]) -
             (p.corner[1][1] - p.corner[0][1]) * (p.corner[2][0] - p.corner[0][0]);
    return p;
}

/* Distance of a point from the nearest edge's line, positive inside. */
static double inside_by(const Projection *p, double u, double v)
{
    double least = HUGE_VAL, turn = p->area < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++) {
        const double *a = p->corner[i], *b = p->corner[(i + 1) % 3];
        double du = b[0] - a[0], dv = b[1] - a[1], length = sqrt(du * du + dv * dv);
        double side = turn * (du * (v - a[1]) - dv * (u - a[0]));
        least = fmin(least, length > 0 ? side / length : HUGE_VAL);
    }
    return least;
}

/* The triangle's plane over a point. */
static double depth_at(const TruthTriangle *t, const double normal[3], const Projection *p,
                       double u, double v)
{
    const double *c = t->corner[0];
    return c[p->axis] -
           (normal[p->u] * (u - c[p->u]) + normal[p->v] * (v - c[p->v])) / normal[p->axis];
}

static int nearest_axis(const double normal[3])
{
    int axis = 0;
    for (int k = 1; k < 3; k++)
        axis = fabs(normal[k]) > fabs(normal[axis]) ? k : axis;
    return axis;
}

static void sample(const TruthTriangle *t, const double normal[3], int axis, uint32_t size,
                   double margin, uint8_t *bits)
{
    Projection p = project(t, axis);
    int64_t first[2], last[2], at[3];
    if (p.area == 0)
        return;
    for (int k = 0; k < 2; k++) {
        double low, high;
        bounds(t, k ? p.v : p.u, &low, &high);
        range(low - 1, high + 1, size, &first[k], &last[k]);
    }
    for (at[p.v] = first[1]; at[p.v] <= last[1]; at[p.v]++)
        for (at[p.u] = first[0]; at[p.u] <= last[0]; at[p.u]++) {
            double u = (double)at[p.u] + 0.5, v = (double)at[p.v] + 0.5;
            if (inside_by(&p, u, v) < -margin)
                continue;
            double depth = depth_at(t, normal, &p, u, v);
            int64_t end = (int64_t)floor(depth + margin);
            for (at[axis] = (int64_t)floor(depth - margin); at[axis] <= end; at[axis]++)
                set_voxel(bits, size, at);
        }
}

void voxel_thin(const TruthTriangle *triangles, uint32_t count, uint32_t size, bool all_axes,
                double margin, uint8_t *bits)
{
    for (uint32_t i = 0; i < count; i++) {
        double normal[3];
        normal_of(&triangles[i], normal);
        int only = nearest_axis(normal);
        for (int axis = 0; axis < 3; axis++)
            if (all_axes || axis == only)
                sample(&triangles[i], normal, axis, size, margin, bits);
    }
}

/* --- inside ----------------------------------------------------------------------------------- */

/* Whether a point is left of the edge from a to b, the same from both sides but for the sign: the
 * ends are put in order first, and a point on the line is left of those that run one way. */
static bool is_left(const double a[2], const double b[2], double u, double v)
{
    bool turned = a[0] > b[0] || (a[0] == b[0] && a[1] > b[1]);
    const double *from = turned ? b : a, *to = turned ? a : b;
    double side = (to[0] - from[0]) * (v - from[1]) - (to[1] - from[1]) * (u - from[0]);
    return (side >= 0) != turned;
}

static bool covers(const Projection *p, double u, double v)
{
    int left = 0;
    for (int i = 0; i < 3; i++)
        left += is_left(p->corner[i], p->corner[(i + 1) % 3], u, v);
    return left == 0 || left == 3;
}

/* Inverts the voxels of a column whose middles lie below a depth. */
static void invert_below(uint8_t *bits, uint32_t size, int64_t x, int64_t y, double depth)
{
    for (int64_t z = 0; z < size && (double)z + 0.5 < depth; z++) {
        size_t i = (size_t)x + size * ((size_t)y + size * (size_t)z);
        bits[i / 8] = (uint8_t)(bits[i / 8] ^ 1u << i % 8);
    }
}

void voxel_solid(const TruthTriangle *triangles, uint32_t count, uint32_t size, uint8_t *bits)
{
    for (uint32_t i = 0; i < count; i++) {
        double normal[3], low[2], high[2];
        int64_t first[2], last[2];
        Projection p = project(&triangles[i], 2);
        normal_of(&triangles[i], normal);
        if (normal[2] == 0)
            continue;
        for (int k = 0; k < 2; k++) {
            bounds(&triangles[i], k, &low[k], &high[k]);
            range(low[k] - 1, high[k] + 1, size, &first[k], &last[k]);
        }
        for (int64_t y = first[1]; y <= last[1]; y++)
            for (int64_t x = first[0]; x <= last[0]; x++) {
                double u = (double)x + 0.5, v = (double)y + 0.5;
                if (covers(&p, u, v))
                    invert_below(bits, size, x, y, depth_at(&triangles[i], normal, &p, u, v));
            }
    }
}

/* --- distance --------------------------------------------------------------------------------- */

static double square_to_segment(const double p[3], const double a[3], const double b[3])
{
    double along[3], from[3], off[3];
    truth_subtract(b, a, along);
    truth_subtract(p, a, from);
    double length = truth_dot(along, along);
    double t = length > 0 ? fmin(fmax(truth_dot(from, along) / length, 0), 1) : 0;
    for (int k = 0; k < 3; k++)
        off[k] = from[k] - t * along[k];
    return truth_dot(off, off);
}

/* To the plane where the foot is inside all edges, else to the nearest edge. */
static double square_to_triangle(const double p[3], const TruthTriangle *t)
{
    double normal[3], from[3], nearest = HUGE_VAL;
    bool inside = true;
    normal_of(t, normal);
    for (int i = 0; i < 3; i++) {
        const double *a = t->corner[i], *b = t->corner[(i + 1) % 3];
        double edge[3], out[3];
        truth_subtract(b, a, edge);
        truth_subtract(p, a, from);
        truth_cross(normal, edge, out);
        inside = inside && truth_dot(out, from) >= 0;
        nearest = fmin(nearest, square_to_segment(p, a, b));
    }
    double height = truth_dot(normal, from), square = truth_dot(normal, normal);
    return inside && square > 0 ? height * height / square : nearest;
}

void voxel_near(const TruthTriangle *triangles, uint32_t count, uint32_t size, double distance,
                uint8_t *bits)
{
    for (uint32_t i = 0; i < count; i++) {
        int64_t first[3], last[3], at[3];
        for (int k = 0; k < 3; k++) {
            double low, high;
            bounds(&triangles[i], k, &low, &high);
            range(low - distance - 1, high + distance + 1, size, &first[k], &last[k]);
        }
        for (at[2] = first[2]; at[2] <= last[2]; at[2]++)
            for (at[1] = first[1]; at[1] <= last[1]; at[1]++)
                for (at[0] = first[0]; at[0] <= last[0]; at[0]++) {
                    const double middle[3] = { (double)at[0] + 0.5, (double)at[1] + 0.5,
                                               (double)at[2] + 0.5 };
                    if (square_to_triangle(middle, &triangles[i]) <= distance * distance)
                        set_voxel(bits, size, at);
                }
    }
}
