/* Solid voxels in one pass over the geometry.
 * source Eisemann and Decoret, "Single-pass GPU solid voxelization for real-time applications",
 *        Graphics Interface 2008. DEVIATES: they turn over all slabs that a fragment lies above;
 *        here it turns over its own group of slabs only, and the others follow once for all
 *        fragments. */
#include "shaders_c/common/cover_shared.h"
#include "shaders_c/voxel/methods/parity.h"
#include "shaders_c/voxel/methods/motion_shared.h"
#include "shaders_c/voxel/volume/flat_texture_shared.h"

/* --- turning over what is below --------------------------------------------------------------- */

typedef struct Varying {
    flt height; /* z above the group's floor */
} Varying;

vertex_shader(voxel_parity_vs, VoxelParityUniforms, PointVertex, Varying)
{
    float3 q = into_voxels(&c->motion, in->position);
    float rows = c->size * c->patches;
    *position = vec4(q.x * (2.0f / c->size) - 1.0f,
                     1.0f - (q.y + c->patch * c->size) * (2.0f / rows), 0.5f, 1);
    out->height = q.z - c->floor;
}

pixel_shader_targets(voxel_parity_ps, VoxelParityUniforms, Varying, SlabTargets)
{
    flt below = -floor_(0.5f - in->height); /* centres below the surface */
    below = sel(below <= c->most, below, 0);
    below = min(min(below, c->size - c->floor), (float)VOXEL_PARITY_DEPTH);
    for (int i = 0; i < 4; i++)
        out->slab[i] = bits_below(below - 32.0f * (float)i);
}

program(voxel_parity_program, voxel_parity_vs, voxel_parity_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_A, .inputs = { { GP_POSITION, 3 } },
        .varyings = { { "height", 1, GP_LINEAR_SCREEN } })

/* --- all slabs -------------------------------------------------------------------------------- */

cover_vertex_shader(voxel_parity_resolve_vs, VoxelParityResolveUniforms);

pixel_shader(voxel_parity_resolve_ps, VoxelParityResolveUniforms, CoverVarying)
{
    const float scale = 1.0f / c->patches;
    float4 bits = texld(0, vec2(in->place.x, (in->place.y + c->patch) * scale));
    flt above = bcast(0);
    for (int i = 1; i < 8 && any(bcast(c->patch + (float)i) < c->patches); i++) {
        flt patch = bcast(c->patch + (float)i);
        float4 lowest = texld(1, vec2(in->place.x, (in->place.y + patch) * scale));
        flt half = lowest.z * 127.5f; /* blue's low bit is its fraction */
        above = above + sel(patch < c->patches, frc(half), 0);
    }
    return sel(frc(above) > 0.25f, sub(sp4(bcast(1)), bits), bits);
}

program(voxel_parity_resolve_program, voxel_parity_resolve_vs, voxel_parity_resolve_ps,
        .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_3_0, COVER_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 1)
