/* The printed scan: along a row of voxels the state turns from outside to inside, and back, at
 * every voxel that the surface crosses; those voxels themselves count as inside.
 * source Dong et al., Pacific Graphics 2004, solid voxelization: rows are scanned voxel by voxel.
 *        DEVIATES: eight at a read, by a table; and a first pass finds how each texel's part of a
 *        row ends, so that the second needs not wait from slab to slab. */
#include "shaders_c/common/cover_shared.h"
#include "shaders_c/voxel/methods/rows.h"
#include "shaders_c/voxel/volume/flat_texture_shared.h"

cover_vertex_shader(voxel_rows_vs, VoxelRowsUniforms);

/* What eight voxels fill, and the state after them. */
GP_INLINE float4 scan(GpInvocation *gp, flt byte, flt state)
{
    return texldl(1, vec4(byte * (255.0f / 256) + 0.5f / 256, state * 0.5f + 0.25f, 0, 0));
}

/* The lowest bits of a byte, as many as belong to the volume. */
GP_INLINE flt keep(flt byte, flt bits)
{
    flt power = exp_(min(max(bits, 0), 8));
    return frc(floor_(byte * 255.0f + 0.5f) / power) * power * (1.0f / 255);
}

/* How a texel's part of a row ends that begins outside: parity. */
pixel_shader(voxel_row_ends_ps, VoxelRowsUniforms, CoverVarying)
{
    float4 here = texldl(0, vec4(in->place.x, in->place.y, 0, 0));
    flt state = scan(gp, here.z, bcast(0)).y;
    state = scan(gp, here.y, state).y;
    state = scan(gp, here.x, state).y;
    return sp4(scan(gp, here.w, state).y);
}

program(voxel_row_ends_program, voxel_rows_vs, voxel_row_ends_ps, MODEL_3_0, COVER_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 1)

pixel_shader(voxel_rows_ps, VoxelRowsUniforms, CoverVarying)
{
    float3 at = texel_column(&c->flat, vpos());
    float2 place =
        vec2((at.x + 0.5f) * (1.0f / c->flat.width), (at.y + 0.5f) * (1.0f / c->flat.height));
    flt odd = bcast(0);
    for (int i = 0; i < VOXEL_ROWS_SLABS - 1 && any(at.z > (float)i); i++) {
        float2 below = add(place, u2(c->origin[i]));
        odd = odd + sel(at.z > (float)i, texldl(2, vec4(below.x, below.y, 0, 0)).x, 0);
    }
    flt state = frc(odd * 0.5f) * 2.0f;
    float4 here = texldl(0, vec4(in->place.x, in->place.y, 0, 0));
    float4 blue = scan(gp, here.z, state), green = scan(gp, here.y, blue.y);
    float4 red = scan(gp, here.x, green.y), alpha = scan(gp, here.w, red.y);
    flt left = c->flat.size - at.z * 32.0f;
    return vec4(keep(red.x, left - 16.0f), keep(green.x, left - 8.0f), keep(blue.x, left),
                keep(alpha.x, left - 24.0f));
}

program(voxel_rows_program, voxel_rows_vs, voxel_rows_ps, MODEL_3_0, COVER_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 1 | 1 << 2, .uses_pixel = true)
