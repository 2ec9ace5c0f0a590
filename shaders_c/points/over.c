#include "shaders_c/points/over.h"

#include "shaders_c/points/surface_shared.h"

clip_vertex_shader(behind_vs, BehindUniforms);

pixel_shader(splat_behind_ps, BehindUniforms, NoVarying)
{
    flt depth = gp_load_local(0).x;
    flt distance = rcp(depth - c->depth[0]) * c->depth[1];
    flt behind = distance + mad(distance, c->behind[1], c->behind[0]);
    odepth(sat(c->depth[0] + c->depth[1] * rcp(behind)));
    return sp4(bcast(1));
}

program(splat_behind_program, behind_vs, splat_behind_ps, MODEL_3_0,
        .inputs = { { GP_POSITION, 3 } }, .local_reads = 1 << 0, .writes_depth = true)

clip_vertex_shader(over_vs, OverUniforms);

pixel_shader(splat_over_ps, OverUniforms, NoVarying)
{
    const NormalizeUniforms *n = &c->normalize;
    SplattedSurface surface = surface_at(gp, n, 1);
    float3 L = u3(n->light), N = surface.normal, H = nrm(sub(L, nrm(surface.ray)));
    float3 light = add(u3(c->ambient), max(dp3(N, L), 0));
    flt highlight = pow_(max(dp3(N, H), 0), bcast(n->shininess)) * n->specular;

    discard(surface.alpha <= 0.0f);
    odepth(surface_depth(n, surface.distance));
    return rgba(mul(add(mul(surface.color, light), highlight), surface.alpha), surface.alpha);
}

program(splat_over_program, over_vs, splat_over_ps, MODEL_3_0, .inputs = { { GP_POSITION, 3 } },
        .samplers = 1 << 0 | 1 << 1, .local_reads = READ_HERE | 1 << SURFACE_HERE_SLOT,
        .may_discard = true, .writes_depth = true, .uses_pixel = true)
