/* Slices of volumes of bits: the first voxel on each ray, and voxels that let light through.
 *
 * DEVIATES: printed is one voxel for each pixel of a plane, so that seen askew parts of voxels lie
 * between the planes; here each plane answers for the slab behind it, and no part is lost.
 * source Dong, Chen, Bao, Zhang and Peng, Pacific Graphics 2004: rendering by slicing planes;
 *        the steps are those of Amanatides and Woo, "A fast voxel traversal algorithm for ray
 *        tracing", Eurographics 1987 */
#include "shaders_c/voxel/pictures/view.h"
#include "shaders_c/voxel/pictures/view_shared.h"

typedef struct Varying {
    SlabRay ray;
    float3 fading; /* log2 of the light that a way of one voxel leaves, for each kind */
} Varying;

vertex_shader(voxel_view_vs, VoxelViewUniforms, SlabVertex, Varying)
{
    *position = m4x4(in->position, c->slices.to_clip);
    out->ray = slab_ray(&c->slices, in);
    out->fading = vec3(log_(bcast(1 - c->colors[0][3])), log_(bcast(1 - c->colors[1][3])),
                       log_(bcast(1 - c->colors[2][3])));
}

/* --- the voxel that is met first -------------------------------------------------------------- */

GP_INLINE float4 first_voxel(GpInvocation *gp, const VoxelViewUniforms *c, const Varying *in,
                             bool two)
{
    Walk walk = walk_slab(&in->ray);
    float2 across = walk.voxel[0];
    flt found = bcast(0);
    msk near = is_near_voxels(gp, c, &in->ray);
    for (int i = STEPS; i-- > 0 && any(near);) {
        flt kind = kind_at(gp, c, walk.voxel[i], in->ray.layer, two);
        across = sel(kind > 0.0f, walk.voxel[i], across);
        found = sel(kind > 0.0f, kind, found);
    }
    discard(~near | (msk)(found == 0.0f));
    return rgba(voxel_at(&c->slices, across, in->ray.layer), found);
}

pixel_shader(voxel_first_ps, VoxelViewUniforms, Varying)
{
    return first_voxel(gp, c, in, false);
}

pixel_shader(voxel_first_two_ps, VoxelViewUniforms, Varying)
{
    return first_voxel(gp, c, in, true);
}

/* --- voxels that let light through ------------------------------------------------------------ */

pixel_shader(voxel_haze_ps, VoxelViewUniforms, Varying)
{
    flt way = way_in_first(gp, c, &in->ray), alpha = 1.0f - exp_(in->fading.x * way);
    return rgba(mul(u3(c->colors[0]), alpha), alpha);
}

pixel_shader(voxel_haze_two_ps, VoxelViewUniforms, Varying)
{
    Walk walk = walk_slab(&in->ray);
    flt length = way_through(&c->slices, &in->ray), seen = bcast(1); /* of what is behind */
    float3 color = sp3(bcast(0));
    msk near = is_near_voxels(gp, c, &in->ray);
    for (int i = 0; i < STEPS && any(near); i++) {
        flt kind = kind_at(gp, c, walk.voxel[i], in->ray.layer, true);
        msk second = kind == (float)VOXEL_KIND_SECOND, both = kind == (float)VOXEL_KIND_BOTH;
        float3 own = sel(second, u3(c->colors[1]), sel(both, u3(c->colors[2]), u3(c->colors[0])));
        flt fading = sel(second, in->fading.y, sel(both, in->fading.z, in->fading.x));
        flt way = sel(kind > 0.0f, walk.share[i] * length, 0);
        flt passed = exp_(fading * way);
        color = add(color, mul(own, seen * (1.0f - passed)));
        seen = seen * passed;
    }
    return sel(near, rgba(color, 1.0f - seen), 0.0f);
}

/* clang-format off */
#define SLICE_DECLARATIONS                                                                         \
    .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_3_0, .inputs = { SLAB_INPUTS },            \
    .varyings = { SLAB_VARYINGS, { "fading", 3, GP_FLAT } }

program(voxel_first_program, voxel_view_vs, voxel_first_ps, SLICE_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 3, .may_discard = true)
program(voxel_first_two_program, voxel_view_vs, voxel_first_two_ps, SLICE_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 1 | 1 << 3, .may_discard = true)
program(voxel_haze_program, voxel_view_vs, voxel_haze_ps, SLICE_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 3)
program(voxel_haze_two_program, voxel_view_vs, voxel_haze_two_ps, SLICE_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 1 | 1 << 3)
/* clang-format on */
