#include "apps/truth/voxel_truth.h"

#include "apps/truth/triangle.h"

#include <string.h>

void voxel_triangles(const float *positions, const uint32_t *indices, uint32_t count,
                     const VoxelBox *space, TruthTriangle *triangles)
{
    for (size_t i = 0; i < 3 * (size_t)count; i++)
        for (int k = 0; k < 3; k++) {
            double p = (double)positions[3 * (size_t)indices[i] + (size_t)k];
            triangles[i / 3].corner[i % 3][k] = space->scale * p + space->offset[k];
        }
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
    const size_t bytes = voxel_bytes(size);
    uint64_t count = 0, word;
    size_t i = 0;
    for (; i + sizeof word <= bytes; i += sizeof word) {
        memcpy(&word, bits + i, sizeof word);
        count += (unsigned)__builtin_popcountll(word);
    }
    for (; i < bytes; i++)
        count += (unsigned)__builtin_popcount(bits[i]);
    return count;
}

/* Voxels of the volume from the one that holds `low` to the one that holds `high`. */
static void range(double low, double high, uint32_t size, int64_t *first, int64_t *last)
{
    *first = (int64_t)fmax(floor(low), 0);
    *last = (int64_t)fmin(floor(high), (double)size - 1);
}

/* --- overlap ---------------------------------------------------------------------------------- */

/* Whether the images on an axis of a triangle around a box's centre and of the box are apart. */
static bool parts(const double axis[3], double corner[3][3], double half)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        double place = vector_dot(axis, corner[i]);
        low = fmin(low, place);
        high = fmax(high, place);
    }
    double reach = half * (fabs(axis[0]) + fabs(axis[1]) + fabs(axis[2]));
    return low > reach || high < -reach;
}

static bool touches(const TruthTriangle *t, const double centre[3], double half)
{
    double corner[3][3], normal[3];
    for (int i = 0; i < 3; i++)
        vector_subtract(t->corner[i], centre, corner[i]);
    truth_normal(t, normal);
    if (parts(normal, corner, half))
        return false;
    for (int k = 0; k < 3; k++) {
        const double side[3] = { k == 0, k == 1, k == 2 };
        if (parts(side, corner, half))
            return false;
        for (int i = 0; i < 3; i++) {
            double edge[3], axis[3];
            vector_subtract(corner[(i + 1) % 3], corner[i], edge);
            vector_cross(side, edge, axis);
            if (parts(axis, corner, half))
                return false;
        }
    }
    return true;
}

/* Whether a triangle is as near to a voxel's centre as is asked. */
typedef bool Meets(const TruthTriangle *triangle, const double centre[3], double margin);

/* Asks every voxel near a triangle. */
static void set_where(Meets *meets, const TruthTriangle *triangles, uint32_t count, uint32_t size,
                      double margin, uint8_t *bits)
{
    for (uint32_t i = 0; i < count; i++) {
        int64_t first[3], last[3], at[3];
        for (int k = 0; k < 3; k++) {
            double low, high;
            truth_bounds(&triangles[i], k, &low, &high);
            /* a voxel's closed box holds its upper side too */
            range(low - margin - 1, high + margin + 1, size, &first[k], &last[k]);
        }
        for (at[2] = first[2]; at[2] <= last[2]; at[2]++)
            for (at[1] = first[1]; at[1] <= last[1]; at[1]++)
                for (at[0] = first[0]; at[0] <= last[0]; at[0]++) {
                    const double centre[3] = { (double)at[0] + 0.5, (double)at[1] + 0.5,
                                               (double)at[2] + 0.5 };
                    if (meets(&triangles[i], centre, margin))
                        set_voxel(bits, size, at);
                }
    }
}

static bool touches_box(const TruthTriangle *triangle, const double centre[3], double margin)
{
    return touches(triangle, centre, 0.5 + margin);
}

void voxel_surface(const TruthTriangle *triangles, uint32_t count, uint32_t size, double margin,
                   uint8_t *bits)
{
    set_where(touches_box, triangles, count, size, margin, bits);
}

/* --- samples ---------------------------------------------------------------------------------- */

/* Distance of a point from the nearest edge's line, positive inside. */
static double inside_by(const TruthProjection *p, double u, double v)
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
    TruthProjection p = truth_project(t, axis);
    int64_t first[2], last[2], at[3];
    if (p.area == 0)
        return;
    for (int k = 0; k < 2; k++) {
        double low, high;
        truth_bounds(t, k ? p.v : p.u, &low, &high);
        range(low - 1, high + 1, size, &first[k], &last[k]);
    }
    for (at[p.v] = first[1]; at[p.v] <= last[1]; at[p.v]++)
        for (at[p.u] = first[0]; at[p.u] <= last[0]; at[p.u]++) {
            double u = (double)at[p.u] + 0.5, v = (double)at[p.v] + 0.5;
            if (inside_by(&p, u, v) < -margin)
                continue;
            double depth = truth_depth(t, normal, &p, u, v);
            int64_t end = (int64_t)floor(depth + margin);
            for (at[axis] = (int64_t)floor(depth - margin); at[axis] <= end; at[axis]++)
                set_voxel(bits, size, at);
        }
}

void voxel_thin(const TruthTriangle *triangles, uint32_t count, uint32_t size, unsigned axes,
                double margin, uint8_t *bits)
{
    for (uint32_t i = 0; i < count; i++) {
        double normal[3];
        truth_normal(&triangles[i], normal);
        int only = nearest_axis(normal);
        for (int axis = 0; axis < 3; axis++)
            if (axes ? axes >> axis & 1 : axis == only)
                sample(&triangles[i], normal, axis, size, margin, bits);
    }
}

/* --- inside ----------------------------------------------------------------------------------- */

/* Inverts the voxels of a column whose centres lie below a depth. */
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
        TruthProjection p = truth_project(&triangles[i], 2);
        truth_normal(&triangles[i], normal);
        if (normal[2] == 0)
            continue;
        for (int k = 0; k < 2; k++) {
            truth_bounds(&triangles[i], k, &low[k], &high[k]);
            range(low[k] - 1, high[k] + 1, size, &first[k], &last[k]);
        }
        for (int64_t y = first[1]; y <= last[1]; y++)
            for (int64_t x = first[0]; x <= last[0]; x++) {
                double u = (double)x + 0.5, v = (double)y + 0.5;
                if (truth_covers(&p, u, v))
                    invert_below(bits, size, x, y, truth_depth(&triangles[i], normal, &p, u, v));
            }
    }
}

/* --- distance --------------------------------------------------------------------------------- */

static bool is_near(const TruthTriangle *triangle, const double centre[3], double distance)
{
    return truth_square_to_triangle(centre, triangle) <= distance * distance;
}

void voxel_near(const TruthTriangle *triangles, uint32_t count, uint32_t size, double distance,
                uint8_t *bits)
{
    set_where(is_near, triangles, count, size, distance, bits);
}
