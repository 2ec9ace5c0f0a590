/* Positions and nothing else. */
#include "pipeline/shader.h"
#include "shaders_c/common/depth_only.h"

typedef struct Vertex {
    float3 position;
} Vertex;

typedef struct Varying {
} Varying;

vertex_shader(depth_only_vs, DepthOnlyUniforms, Vertex, Varying)
{
    *position = m4x4(in->position, c->mvp);
}

depth_program(depth_only_program, depth_only_vs, .vertex_profile = GP_VS_2_0,
              .inputs = { { GP_POSITION, 3 } })
