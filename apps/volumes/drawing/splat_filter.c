#include "apps/volumes/drawing/splat_filter.h"

#include "apps/base/filter_bound.h"

#include <math.h>

/* What is known of the voxels of a patch: distances along the view, and how much wider than a round
 * footprint perspective may make one, squared. */
typedef struct Extent {
    double nearest, farthest, stretch;
} Extent;

static void add_corner(const VoxelEye *eye, const double place[3], Extent *extent)
{
    double at[3];
    voxel_eye_place(eye, place, at);
    const double stretch =
        eye->parallel ? 1 : 1 + (at[0] * at[0] + at[1] * at[1]) / (at[2] * at[2]);
    extent->nearest = fmin(extent->nearest, at[2]);
    extent->farthest = fmax(extent->farthest, at[2]);
    extent->stretch = fmax(extent->stretch, stretch);
}

static Extent extent_of_patch(const VoxelEye *eye, const VoxelOrder *order, const Field *field,
                              uint32_t slice, uint32_t patch)
{
    const uint32_t at[2] = { patch % order->patches[0], patch / order->patches[0] };
    Extent extent = { HUGE_VAL, -HUGE_VAL, 1 };
    for (int corner = 0; corner < 4; corner++) {
        double place[3];
        place[order->axis[0]] = slice;
        for (int k = 0; k < 2; k++) {
            const uint32_t end = field->size[order->axis[1 + k]] - 1;
            const uint32_t sample = (at[k] + (corner >> k & 1)) * VOXEL_PATCH;
            place[order->axis[1 + k]] = sample < end ? sample : end;
        }
        add_corner(eye, place, &extent);
    }
    return extent;
}

/* rk / rh, and the thresholds that paper 003 multiplies it with. Along parallel rays a footprint is
 * everywhere as large as at distance 1, and nowhere wider. */
static double ratio_of_radii(const VoxelEye *eye)
{
    return eye->reach * eye->focal / fmax(eye->low_pass, 1e-6);
}

static double most_distance(const VoxelEye *eye)
{
    const double wide = eye->parallel ? 1 : 1 + 2 * eye->half_height;
    return ratio_of_radii(eye) * 2 * wide * wide;
}

static VoxelFilter filter_by_distance(const VoxelEye *eye, const Extent *extent)
{
    const double farthest = eye->parallel ? 1 : extent->farthest,
                 nearest = eye->parallel ? 1 : extent->nearest;
    if (farthest < ratio_of_radii(eye) * 0.3)
        return VOXEL_RECONSTRUCTION;
    return nearest > most_distance(eye) ? VOXEL_LOW_PASS : VOXEL_EWA;
}

static VoxelFilter filter_by_bound(const VoxelEye *eye, const VolumeSplatSetting *setting,
                                   const Extent *extent)
{
    const double h = setting->low_pass * setting->low_pass;
    const double far = eye->focal * eye->least / (eye->parallel ? 1 : extent->farthest),
                 near =
                     eye->focal * eye->reach / setting->cut / (eye->parallel ? 1 : extent->nearest);
    const double low = far * far, high = near * near * extent->stretch;
    if (filter_bound_low_pass(high, high, h) / 2 <= setting->tolerance)
        return VOXEL_LOW_PASS;
    if (filter_bound_reconstruction(low, low, h) / 2 <= setting->tolerance)
        return VOXEL_RECONSTRUCTION;
    return VOXEL_EWA;
}

static VoxelFilter filter_of_extent(const VoxelEye *eye, const VolumeSplatSetting *setting,
                                    const Extent *extent)
{
    if (!(extent->nearest >= eye->near) && !eye->parallel)
        return VOXEL_EWA;
    return setting->filter == VOXEL_ADAPTIVE ? filter_by_distance(eye, extent)
                                             : filter_by_bound(eye, setting, extent);
}

VoxelFilter splat_filter_of_depths(const VoxelEye *eye, const VolumeSplatSetting *setting,
                                   double nearest, double farthest)
{
    const double wide = eye->half_width * eye->half_width + eye->half_height * eye->half_height;
    const Extent extent = { nearest, farthest, eye->parallel ? 1 : 1 + wide };
    return setting->filter < VOXEL_ADAPTIVE ? setting->filter
                                            : filter_of_extent(eye, setting, &extent);
}

VoxelFilter splat_filter_of_patch(const VoxelEye *eye, const VoxelOrder *order, const Field *field,
                                  const VolumeSplatSetting *setting, uint32_t slice, uint32_t patch)
{
    if (setting->filter < VOXEL_ADAPTIVE)
        return setting->filter;
    const Extent extent = extent_of_patch(eye, order, field, slice, patch);
    return filter_of_extent(eye, setting, &extent);
}

VoxelSums splat_sums(const VoxelEye *eye, const Field *field, const VolumeSplatSetting *setting)
{
    if (setting->sums != VOXEL_BYTES_NEAR)
        return setting->sums;
    double square = 0;
    for (int k = 0; k < 3; k++) {
        const double end = (field->size[k] - 1) * field->scale[k];
        const double beside = fmax(fmax(-eye->position[k], eye->position[k] - end), 0);
        square += beside * beside;
    }
    return (eye->parallel ? 1 : sqrt(square)) > 0.3 * most_distance(eye) ? VOXEL_HALVES
                                                                         : VOXEL_BYTES;
}
