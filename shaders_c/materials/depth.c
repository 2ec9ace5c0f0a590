/* The distance along the view as a grey. In perspective that is w of clip space, which, unlike the
 * depth buffer's z, grows evenly. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/depth.h"

typedef struct Varying {
    flt grey;
} Varying;

vertex_shader(depth_vs, DepthUniforms, PointVertex, Varying)
{
    float4 clip = m4x4(in->position, c->mvp);
    *position = clip;
    out->grey = (clip.w - c->near) / (bcast(c->far) - c->near);
}

pixel_shader(depth_ps, DepthUniforms, Varying)
{
    return rgba(sp3(sat(in->grey)), 1);
}

program(depth_program, depth_vs, depth_ps, MODEL_2_0, .inputs = { { GP_POSITION, 3 } },
        .varyings = { { "grey", 1, GP_PERSPECTIVE } })
