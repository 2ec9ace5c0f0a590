/* Samples of a scan as voxels, linear between them, and the pass that finds their slopes. */
#include "apps/techniques/voxel/pictures/scan.h"

#include "shaders_c/voxel/pictures/scan.h"

#include <math.h>

/* --- samples ---------------------------------------------------------------------------------- */

/* A volume of samples and where it lies among voxels. */
typedef struct Samples {
    const uint8_t *values;
    const uint32_t *dims;
    double spacing[3], first[3]; /* place of the first sample's centre */
} Samples;

/* Along one axis: the sample before a voxel's centre, and how far past it that is; false where the
 * voxel lies outside. */
static bool find_samples(const Samples *s, int axis, uint32_t voxel, uint32_t *before, double *past)
{
    const double at = (voxel + 0.5 - s->first[axis]) / s->spacing[axis];
    if (at < -0.5 || at > s->dims[axis] - 0.5)
        return false;
    const double last = s->dims[axis] - 1.0, inside = at < 0 ? 0 : at > last ? last : at;
    *before = (uint32_t)inside;
    *past = inside - *before;
    return true;
}

static uint32_t sample_linear(const Samples *s, const uint32_t before[3], const double past[3])
{
    double sum = 0;
    for (int corner = 0; corner < 8; corner++) {
        double weight = 1;
        size_t index = 0;
        for (int k = 2; k >= 0; k--) {
            const bool after = corner >> k & 1;
            weight *= after ? past[k] : 1 - past[k];
            index = index * s->dims[k] + before[k] + (after && before[k] + 1 < s->dims[k]);
        }
        sum += weight * s->values[index];
    }
    return (uint32_t)(sum + 0.5);
}

static void put_voxel(const FlatTexture *flat, const uint32_t at[3], uint32_t value)
{
    flat_texture_texel(flat, at[2] / flat->per_texel, at[0], at[1])[at[2] % flat->per_texel] =
        (uint8_t)value;
}

FlatTexture voxel_scan(Frame *frame, const uint8_t *samples, const uint32_t dims[3],
                       const double spacing[3], uint32_t size)
{
    const FlatTexture flat = flat_texture_make(frame, size, 8);
    Samples s = { .values = samples, .dims = dims };
    for (int k = 0; k < 3; k++) {
        s.spacing[k] = spacing ? spacing[k] : 1;
        s.first[k] = size / 2.0 - s.spacing[k] * (dims[k] - 1) / 2.0;
    }
    uint32_t at[3], before[3];
    double past[3];
    for (at[2] = 0; flat.texels->level[0].texels && at[2] < size; at[2]++)
        for (at[1] = 0; at[1] < size; at[1]++)
            for (at[0] = 0; at[0] < size; at[0]++) {
                bool inside = true;
                for (int k = 2; k >= 0 && inside; k--)
                    inside = find_samples(&s, k, at[k], &before[k], &past[k]);
                if (inside)
                    put_voxel(&flat, at, sample_linear(&s, before, past));
            }
    return flat;
}

/* --- slopes ----------------------------------------------------------------------------------- */

FlatTexture voxel_scan_slopes(Frame *frame, const FlatTexture *scan)
{
    const FlatTexture slopes = flat_texture_make(frame, scan->size, 32);
    const VoxelSlopesUniforms uniforms = { .scan = flat_texture_layout(scan),
                                           .slopes = flat_texture_layout(&slopes) };
    flat_texture_pass(frame, "slopes", &slopes);
    frame_draw_copied(frame, &voxel_slopes_program, &uniforms, &flat_texture_cover)
        ->textures[0]
        .surface = scan->texels;
    return slopes;
}
