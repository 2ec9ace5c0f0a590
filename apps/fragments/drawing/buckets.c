#include "apps/fragments/drawing/buckets.h"

#include "apps/base/bounds.h"
#include "apps/fragments/drawing/passes.h"
#include "shaders_c/fragments/buckets.h"

#include <math.h>

/* The depths of the mesh's box, as far as it is in the view. */
static void find_depths(const FragmentPasses *passes, double depth[2])
{
    const FragmentMesh *mesh = passes->mesh;
    const float(*mvp)[4] = passes->uniforms.mvp;
    depth[0] = 1;
    depth[1] = 0;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const float *at = mesh->positions[i];
        double clip[2];
        for (int row = 2; row < 4; row++)
            clip[row - 2] = (double)mvp[row][0] * (double)at[0] +
                            (double)mvp[row][1] * (double)at[1] +
                            (double)mvp[row][2] * (double)at[2] + (double)mvp[row][3];
        const double here = clip[1] > 0 ? fmin(fmax(clip[0] / clip[1], 0), 1) : 0;
        depth[0] = fmin(depth[0], here);
        depth[1] = fmax(depth[1], here);
    }
}

static BucketUniforms uniforms_of(const FragmentPasses *passes)
{
    BucketUniforms uniforms;
    double depth[2];
    find_depths(passes, depth);
    const double range = fmax(depth[1] - depth[0], 1e-6);
    for (int i = 0; i < 16; i++)
        uniforms.mvp[i / 4][i % 4] = passes->uniforms.mvp[i / 4][i % 4];
    uniforms.depth[0] = (float)(-depth[0] / range);
    uniforms.depth[1] = (float)(1 / range);
    return uniforms;
}

/* The mesh into four targets. in read, slots: surfaces that it reads, `reads` of them */
static void add_pass(const FragmentPasses *passes, const BucketUniforms *uniforms, const char *name,
                     const GpProgram *program, GpSurface *const target[4], GpBlendOp blend,
                     GpSurface *const *read, int reads)
{
    GpPass *pass = fragment_pass(passes, name, target[0], 0);
    for (int i = 1; i < 4; i++)
        pass->color[i] = (GpColorTarget){ .surface = target[i], .clear = true };
    GpDraw *draw = frame_draw_copied(passes->frame, program, uniforms, passes->mesh->drawn);
    draw->state.depth.test = passes->depth ? GP_LESS : GP_ALWAYS;
    for (int i = 0; i < 4; i++)
        draw->state.blend[i].op = blend;
    for (int i = 0; i < reads; i++)
        draw->textures[i].surface = read[i];
}

static void make_targets(const FragmentPasses *passes, GpFormat format, GpSurface *target[4])
{
    for (int i = 0; i < 4; i++)
        target[i] = fragment_surface(passes, format);
}

static void add_pairs(const FragmentPasses *passes, const BucketUniforms *uniforms,
                      GpSurface *const bucket[4])
{
    GpSurface *range[4];
    make_targets(passes, GP_A32B32G32R32F, range);
    add_pass(passes, uniforms, "depths", &bucket_range_program, range, GP_BLEND_MAX, NULL, 0);
    add_pass(passes, uniforms, "buckets", &bucket_pair_program, bucket, GP_BLEND_MAX, range, 4);
}

static void add_adaptive(const FragmentPasses *passes, const BucketUniforms *uniforms,
                         GpSurface *const bucket[4])
{
    GpSurface *read[8], **bits = read, **counts = read + 4;
    make_targets(passes, GP_A8R8G8B8, bits);
    make_targets(passes, GP_A16B16G16R16F, counts);
    add_pass(passes, uniforms, "parts", &bucket_bits_program, bits, GP_BLEND_LOGIC_OR, NULL, 0);
    fragment_whole(passes, "count", &bucket_count_program, NULL,
                   (FragmentSlots){ bits, 4, counts, 4 });
    add_pass(passes, uniforms, "buckets", &bucket_ranked_program, bucket, GP_BLEND_MAX, read, 8);
}

GpResult buckets_add(const FragmentMesh *mesh, const BucketSetting *setting,
                     const FragmentView *view, GpSurface *color, GpSurface *depth, Frame *frame,
                     GpError *error)
{
    const FragmentPasses passes = fragment_passes(mesh, view, color, depth, frame);
    const BucketUniforms uniforms = uniforms_of(&passes);
    BucketLayersUniforms layers;
    GpSurface *bucket[4];
    const GpResult result = fragment_same_alpha(mesh, &layers.alpha, error);
    if (result)
        return result;
    make_targets(&passes, GP_A32B32G32R32F, bucket);
    if (setting->kind == BUCKETS_TWO_PASSES)
        add_pairs(&passes, &uniforms, bucket);
    else if (setting->kind == BUCKETS_ADAPTIVE)
        add_adaptive(&passes, &uniforms, bucket);
    else
        add_pass(&passes, &uniforms, "buckets", &bucket_single_program, bucket, GP_BLEND_MAX, NULL,
                 0);
    fragment_whole(&passes, "over", &bucket_layers_program, &layers,
                   (FragmentSlots){ bucket, 4, &color, 1 })
        ->state.blend[0] = fragment_over;
    return frame_result(frame, error);
}
