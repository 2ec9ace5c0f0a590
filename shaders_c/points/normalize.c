#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/points/normalize.h"

/* Less weight than this is none: sums of no splat. */
#define NOTHING 1e-6f

GP_INLINE flt coverage_of(const NormalizeUniforms *c, flt weight)
{
    flt alpha = sat(mad(weight, c->coverage[0], c->coverage[1]));
    return sel(weight > NOTHING, alpha, 0);
}

/* The sums of a pixel so many to the right and down. */
GP_INLINE float4 sums_at(GpInvocation *gp, const NormalizeUniforms *c, float right, float down)
{
    float2 place = vpos();
    return texldl(0, vec4((place.x + (right + 0.5f)) * c->texel[0],
                          (place.y + (down + 0.5f)) * c->texel[1], 0, 0));
}

/* Whether the surface is on both sides of the pixel: how much of the lesser. */
GP_INLINE flt between(GpInvocation *gp, const NormalizeUniforms *c, float right, float down)
{
    flt one = sums_at(gp, c, right, down).w, other = sums_at(gp, c, -right, -down).w;
    return min(coverage_of(c, one), coverage_of(c, other));
}

/* Where a surface ends before another one, its own weight fades out, and what is behind it has been
 * hidden: sums of one surface alone, though two cover the pixel. Such pixels have covered ones on both
 * sides, within two pixels, and those where the whole model ends have not. */
GP_INLINE flt coverage(GpInvocation *gp, const NormalizeUniforms *c, flt weight)
{
    flt alpha = coverage_of(c, weight);
    if (any((msk)(alpha < 1.0f) & (msk)(weight > NOTHING))) {
        flt closed = between(gp, c, 1, 0);
        closed = max(closed, between(gp, c, 0, 1));
        closed = max(closed, between(gp, c, 1, 1));
        closed = max(closed, between(gp, c, 1, -1));
        closed = max(closed, between(gp, c, 2, 0));
        closed = max(closed, between(gp, c, 0, 2));
        closed = max(closed, between(gp, c, 2, 2));
        closed = max(closed, between(gp, c, 2, -2));
        alpha = sel(weight > NOTHING, max(alpha, closed), alpha);
    }
    return alpha;
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
    float4 sum = sums_at(gp, c, 0, 0);
    float3 color = mul(xyz(sum), rcp(max(sum.w, NOTHING)));
    return over_background(c, color, coverage(gp, c, sum.w));
}

program(splat_normalize_program, normalize_vs, splat_normalize_ps, MODEL_3_0,
        .inputs = { { GP_POSITION, 3 } }, .samplers = 1 << 0, .uses_pixel = true)

pixel_shader(splat_shade_ps, NormalizeUniforms, NoVarying)
{
    float4 sum = sums_at(gp, c, 0, 0), surface = gp_load_local(1);
    flt per_weight = rcp(max(sum.w, NOTHING)), alpha = coverage(gp, c, sum.w);
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
        .inputs = { { GP_POSITION, 3 } }, .samplers = 1 << 0, .local_reads = 1 << 1,
        .writes_depth = true, .uses_pixel = true)
