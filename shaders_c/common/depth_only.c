/* Positions and nothing else. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/common/depth_only.h"

vertex_shader(depth_only_vs, DepthOnlyUniforms, PointVertex, NoVarying)
{
    *position = m4x4(in->position, c->mvp);
}

depth_program(depth_only_program, depth_only_vs, .vertex_profile = GP_VS_2_0,
              .inputs = { { GP_POSITION, 3 } })
