/* Voxels of one bit: the power of two that belongs to a voxel is looked up and added. And those of
 * more bits that say no more than that something is there, or how often.
 * source Dong, Chen, Bao, Zhang and Peng, "Real-time voxelization for complex polygonal models",
 *        Pacific Graphics 2004: texelization, its table of 8 x 1, and four targets at once */
#include "pipeline/shader.h"
#include "shaders_c/voxel/methods/sheets_shared.h"

typedef struct Vertex {
    float3 position;
} Vertex;

typedef struct Varying {
    flt depth;
} Varying;

vertex_shader(voxel_place_vs, VoxelSheetsUniforms, Vertex, Varying)
{
    *position = place_on_patch(c, in->position, &out->depth);
}

pixel_shader_targets(voxel_bits_ps, VoxelSheetsUniforms, Varying, Targets)
{
    Place place = find_place(c, in->depth, 32);
    flt byte = floor_((place.voxel + 0.5f) * (1.0f / 8)), bit = place.voxel - 8.0f * byte;
    flt power = texld(0, vec2((bit + 0.5f) * (1.0f / 8), 0.5f)).x;
    put_texel(out, place.target,
              vec4(sel(byte == 2.0f, power, 0), sel(byte == 1.0f, power, 0),
                   sel(byte == 0.0f, power, 0), sel(byte == 3.0f, power, 0)));
}

program(voxel_bits_program, voxel_place_vs, voxel_bits_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = { { GP_POSITION, 3 } },
        .varyings = { { "depth", 1, GP_PERSPECTIVE } }, .samplers = 1 << 0)

pixel_shader_targets(voxel_density_ps, VoxelSheetsUniforms, Varying, Targets)
{
    put_value(c, in->depth, bcast(c->offset), out);
}

program(voxel_density_program, voxel_place_vs, voxel_density_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = { { GP_POSITION, 3 } },
        .varyings = { { "depth", 1, GP_PERSPECTIVE } })
