/* Each point sets the voxel that it lies in. */
#include "shaders_c/voxel/inputs/points.h"
#include "shaders_c/voxel/inputs/points_shared.h"

typedef struct Vertex {
    float3 position;
} Vertex;

vertex_shader(voxel_points_vs, VoxelPointsUniforms, Vertex, PointVarying)
{
    *position = set_voxel(c, in->position, out, point_size);
}

pixel_shader(voxel_points_ps, VoxelPointsUniforms, PointVarying)
{
    return in->bit;
}

program(voxel_points_program, voxel_points_vs, voxel_points_ps, POINT_DECLARATIONS,
        .inputs = { { GP_POSITION, 3 } }, POINT_VARYINGS)
