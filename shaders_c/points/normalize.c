#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/points/normalize.h"

/* Less weight than this is none: sums of no splat. */
#define NOTHING 1e-6f

GP_INLINE flt coverage(const NormalizeUniforms *c, flt weight)
{
    flt alpha = sat(mad(weight, c->coverage[0], c->coverage[1]));
    return sel(weight > NOTHING, alpha, 0);
}

GP_INLINE float4 over_background(const NormalizeUniforms *c, float3 color, flt alpha)
{
    flt behind = 1.0f - alpha;
    return rgba(mad(color, alpha, mul(u3(c->background), behind)),
                mad(behind, c->background[3], alpha));
}

clip_vertex_shader(normalize_vs, NormalizeUniforms);

pixel_shader(splat_normalize_ps, NormalizeUniforms, NoVarying)
{
    float4 sum = gp_load_local(0);
    float3 color = mul(xyz(sum), rcp(max(sum.w, NOTHING)));
    return over_background(c, color, coverage(c, sum.w));
}

program(splat_normalize_program, normalize_vs, splat_normalize_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 } }, .local_reads = 1 << 0)

pixel_shader(splat_shade_ps, NormalizeUniforms, NoVarying)
{
    float4 sum = gp_load_local(0), surface = gp_load_local(1);
    flt per_weight = rcp(max(sum.w, NOTHING)), alpha = coverage(c, sum.w);
    float3 color = mul(xyz(sum), per_weight);
    flt distance = surface.w * per_weight;

    flt x = (vpos().x + (0.5f - c->centre[0])) * c->per_focal;
    flt y = (vpos().y + (0.5f - c->centre[1])) * c->per_focal;
    float3 ray = mad(u3(c->axes[0]), x, mad(u3(c->axes[1]), y, u3(c->axes[2])));
    float3 L = u3(c->light), N = nrm(xyz(surface)), H = nrm(sub(L, nrm(ray)));
    flt diffuse = max(dp3(N, L), 0) * (1.0f - c->ambient) + c->ambient;
    flt highlight = pow_(max(dp3(N, H), 0), bcast(c->shininess)) * c->specular;

    odepth(sel(alpha >= 0.5f, c->depth[0] + c->depth[1] * rcp(max(distance, NOTHING)), 1));
    return over_background(c, add(mul(color, diffuse), highlight), alpha);
}

program(splat_shade_program, normalize_vs, splat_shade_ps, MODEL_3_0,
        .inputs = { { GP_POSITION, 3 } }, .local_reads = 1 << 0 | 1 << 1, .writes_depth = true,
        .uses_pixel = true)
