/* Voxels slice by slice: all is done by the clip planes and the blend unit.
 * source Fang and Chen, "Hardware accelerated voxelization", Computers & Graphics 24(3), 2000 */
#include "pipeline/shader.h"
#include "shaders_c/voxel_slice.h"

typedef struct Vertex {
    float3 position;
} Vertex;

typedef struct Varying {
} Varying;

vertex_shader(voxel_slice_vs, VoxelSliceUniforms, Vertex, Varying)
{
    *position = m4x4(in->position, c->to_clip);
}

pixel_shader(voxel_slice_ps, VoxelSliceUniforms, Varying)
{
    return u4(c->bit);
}

program(voxel_slice_program, voxel_slice_vs, voxel_slice_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = { { GP_POSITION, 3 } })
