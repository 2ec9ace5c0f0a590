/* How far each triangle reaches, and lists of those that a draw needs. */
#include "apps/techniques/voxel/methods/lists.h"

#include <math.h>
#include <string.h>

enum { X, Y, Z };

static const float rounding = 1.0f / 256;

static double distance(const double a[3], const double b[3])
{
    double x = a[X] - b[X], y = a[Y] - b[Y], z = a[Z] - b[Z];
    return sqrt(x * x + y * y + z * z);
}

/* However it turns, it is not longer than its longest edge. A twist moves what lies r from its axis
 * by r times the angle, and r is no more than the diagonal of the volume's centre: at most so much
 * longer does it make an edge. */
static VoxelExtent any_extent(const VoxelModel *model, double q[3][3])
{
    double longest = fmax(distance(q[0], q[1]), fmax(distance(q[1], q[2]), distance(q[2], q[0])));
    longest *= 1 + fabs((double)model->most_twist) * 1.5 * (double)model->motion.centre;
    return (VoxelExtent){ -rounding, (float)longest + rounding, (float)longest, false, true };
}

static double lesser(double a, double b)
{
    return a < b ? a : b;
}

static double greater(double a, double b)
{
    return a > b ? a : b;
}

/* Of numbers that a word holds. (By the libraries' own functions a million triangles took twice as
 * long.) */
static int32_t floor_of(double x)
{
    const int32_t whole = (int32_t)x;
    return whole - ((double)whole > x);
}

static bool in_one(double low, double high)
{
    return floor_of(low - (double)rounding) == floor_of(high + (double)rounding);
}

static bool holds_centre(double low, double high)
{
    return floor_of(high + (double)rounding - 0.5) >= -floor_of(-(low - (double)rounding - 0.5));
}

static VoxelExtent still_extent(double q[3][3])
{
    const double far = 1e9; /* what is beyond is in no volume, wherever it is */
    double low[3], high[3];
    int centres = 0;
    GP_UNROLL
    for (int k = 0; k < 3; k++) {
        low[k] = greater(-far, lesser(far, lesser(q[0][k], lesser(q[1][k], q[2][k]))));
        high[k] = greater(-far, lesser(far, greater(q[0][k], greater(q[1][k], q[2][k]))));
        centres += holds_centre(low[k], high[k]);
    }
    return (VoxelExtent){ (float)low[Z] - rounding, (float)high[Z] + rounding,
                          (float)greater(high[X] - low[X], high[Y] - low[Y]),
                          in_one(low[X], high[X]) && in_one(low[Y], high[Y]), centres >= 2 };
}

const VoxelExtent *voxel_extents(const VoxelModel *model, Frame *frame)
{
    VoxelExtent *extents = frame_alloc(frame, model->triangle_count, sizeof *extents);
    const VoxelModel m = *model; /* which no store can change */
    for (uint32_t i = 0; extents && i < m.triangle_count; i++) {
        double q[3][3];
        voxel_model_corners(&m, i, q);
        extents[i] = m.motions ? any_extent(&m, q) : still_extent(q);
    }
    return extents;
}

VoxelList voxel_choose(Frame *frame, const VoxelExtent *extents, VoxelList from,
                       VoxelChoice *choice, float about)
{
    uint32_t *chosen = frame_alloc(frame, (size_t)from.count + 1, sizeof *chosen), count = 0;
    if (!chosen || !extents)
        return (VoxelList){ NULL, 0 };
    for (uint32_t i = 0; i < from.count; i++) {
        const uint32_t triangle = from.triangles ? from.triangles[i] : i;
        chosen[count] = triangle;
        count += choice(&extents[triangle], about);
    }
    return (VoxelList){ chosen, count };
}

/* --- groups of slabs -------------------------------------------------------------------------- */

static bool rises_above(const VoxelExtent *extent, float floor)
{
    return extent->high >= floor;
}

static bool begins_below(const VoxelExtent *extent, float end)
{
    return extent->low <= end + 0.5f;
}

GpGeometry voxel_group_triangles(const VoxelModel *model, Frame *frame, const VoxelExtent *extents,
                                 float floor, float depth, bool top)
{
    GpGeometry geometry = voxel_model_geometry(model);
    if (model->motions)
        return geometry;
    VoxelList list = { NULL, model->triangle_count };
    list = voxel_choose(frame, extents, list, rises_above, floor);
    if (!top)
        list = voxel_choose(frame, extents, list, begins_below, floor + depth);
    uint32_t *indices = frame_alloc(frame, 3 * (size_t)list.count + 1, sizeof *indices);
    for (uint32_t i = 0; indices && i < list.count; i++)
        memcpy(indices + 3 * (size_t)i, model->indices + 3 * (size_t)list.triangles[i],
               3 * sizeof *indices);
    geometry.indices = indices;
    geometry.index_count = indices ? 3 * list.count : 0;
    return geometry;
}
