/* Textures that decide: a dependent read, and alpha that discards. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/bench/lookup.h"

textured_quad_vertex_shader(lookup_vs, NoUniforms);

pixel_shader(lookup_ps, NoUniforms, UvVarying)
{
    float4 place = texld(0, in->uv);
    return texldl(1, vec4(place.x, place.y, 0, 0));
}

pixel_shader(cut_out_ps, NoUniforms, UvVarying)
{
    float4 color = texld(0, in->uv);
    discard(color.w < 0.5f);
    return color;
}

program(lookup_program, lookup_vs, lookup_ps, MODEL_3_0, TEXTURED_QUAD_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 1)

program(cut_out_program, lookup_vs, cut_out_ps, MODEL_2_0, TEXTURED_QUAD_DECLARATIONS,
        .samplers = 1 << 0, .may_discard = true)
