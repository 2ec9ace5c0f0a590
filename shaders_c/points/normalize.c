#include "shaders_c/points/surface_shared.h"

GP_INLINE float4 over_background(const NormalizeUniforms *c, float3 color, flt alpha)
{
    flt behind = 1.0f - alpha;
    return rgba(mad(color, alpha, mul(u3(c->background), behind)),
                mad(behind, c->background[3], alpha));
}

clip_vertex_shader(normalize_vs, NormalizeUniforms);

pixel_shader(splat_normalize_ps, NormalizeUniforms, NoVarying)
{
    Sums sums = { gp_load_local(SUMS_HERE_SLOT), sp4(bcast(0)) };
    flt alpha = close_gaps(gp, c, 0, &sums);
    float3 color = mul(xyz(sums.color), rcp(max(sums.color.w, NOTHING)));
    return over_background(c, color, alpha);
}

program(splat_normalize_program, normalize_vs, splat_normalize_ps, MODEL_3_0,
        .inputs = { { GP_POSITION, 3 } }, .samplers = 1 << 0, .local_reads = READ_HERE,
        .uses_pixel = true)

pixel_shader(splat_shade_ps, NormalizeUniforms, NoVarying)
{
    SplattedSurface surface = surface_at(gp, c, 1);
    float3 L = u3(c->light), N = surface.normal, H = nrm(sub(L, nrm(surface.ray)));
    flt diffuse = max(dp3(N, L), 0) * (1.0f - c->ambient) + c->ambient;
    flt highlight = pow_(max(dp3(N, H), 0), bcast(c->shininess)) * c->specular;

    odepth(sel(surface.alpha >= 0.5f, surface_depth(c, surface.distance), 1));
    return over_background(c, add(mul(surface.color, diffuse), highlight), surface.alpha);
}

program(splat_shade_program, normalize_vs, splat_shade_ps, MODEL_3_0,
        .inputs = { { GP_POSITION, 3 } }, .samplers = 1 << 0 | 1 << 1,
        .local_reads = READ_HERE | 1 << SURFACE_HERE_SLOT, .writes_depth = true, .uses_pixel = true)
