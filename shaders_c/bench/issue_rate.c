/* Independent multiplications and additions, without end. */
#define GP_SHADER_SW /* longer than hardware's profiles allow */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/bench/issue_rate.h"

textured_quad_vertex_shader(issue_rate_vs, IssueRateUniforms);

/* With the factor and the addend they fit into sixteen registers. */
pixel_shader(issue_rate_ps, IssueRateUniforms, UvVarying)
{
    flt a = bcast(c->factor), b = bcast(c->addend);
    float4 v0 = vec4(in->uv.x, in->uv.y, in->uv.x + 1.0f, in->uv.y + 1.0f);
    float4 v1 = add(v0, 2.0f), v2 = add(v0, 3.0f);
    for (int i = 0; i < 64; i++) {
        v0 = mad(v0, vec4(a, a, a, a), vec4(b, b, b, b));
        v1 = mad(v1, vec4(a, a, a, a), vec4(b, b, b, b));
        v2 = mad(v2, vec4(a, a, a, a), vec4(b, b, b, b));
    }
    return add(add(v0, v1), v2);
}

program(issue_rate_program, issue_rate_vs, issue_rate_ps, .vertex_profile = GP_VS_3_SW,
        .pixel_profile = GP_PS_3_SW, TEXTURED_QUAD_DECLARATIONS)
