/* Small copies of one mesh, both sides lit by Lambert's law. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/bench/placed.h"

vertex_shader(placed_vs, PlacedUniforms, MeshVertex, NormalVarying)
{
    float3 world = mad(in->position, bcast(c->place[3]), u3(c->place));
    *position = m4x4(world, c->mvp);
    out->normal = in->normal;
}

pixel_shader(placed_ps, PlacedUniforms, NormalVarying)
{
    flt cosine = abs_(dp3(nrm(in->normal), u3(c->light)));
    return rgba(mul(u3(c->albedo), cosine + c->ambient), 1);
}

program(placed_program, placed_vs, placed_ps, MODEL_2_0, .inputs = { MESH_INPUTS },
        .varyings = { { "normal", 3, GP_PERSPECTIVE } })
