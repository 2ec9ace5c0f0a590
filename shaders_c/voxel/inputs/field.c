/* A sampled function's sign at 32 samples of a column. */
#include "shaders_c/voxel/inputs/implicit_shared.h"
#include "shaders_c/voxel/inputs/field.h"

cover_vertex_shader(voxel_field_vs, VoxelFieldUniforms);

GP_INLINE float4 bits_inside(GpInvocation *gp, const VoxelFieldUniforms *c, float2 place)
{
    float2 column = add(floor_(mul(place, c->size)), 0.5f);
    float4 sample[VOXEL_FIELD_PATCHES], value[FOURS];
    for (int i = 0; i < VOXEL_FIELD_PATCHES; i++)
        sample[i] = texld(0, mul(add(column, u2(c->origin[i])), u2(c->texel)));
    for (int i = 0; i < FOURS; i++) {
        float4 here = sample[i];
        value[i] = cmp(-bcast(c->next), here, vec4(here.y, here.z, here.w, sample[i + 1].x));
    }
    return signs_below(value, c->inside);
}

pixel_shader(voxel_field_ps, VoxelFieldUniforms, CoverVarying)
{
    return bits_inside(gp, c, in->place);
}

pixel_shader_targets(voxel_field_corner_ps, VoxelFieldUniforms, CoverVarying, TwoTargets)
{
    out->any = out->all = bits_inside(gp, c, in->place);
}

program(voxel_field_program, voxel_field_vs, voxel_field_ps, MODEL_2_0, COVER_DECLARATIONS,
        .samplers = 1 << 0)
program(voxel_field_corner_program, voxel_field_vs, voxel_field_corner_ps, MODEL_2_0,
        COVER_DECLARATIONS, .samplers = 1 << 0)
