#include "shaders_c/volume/slices.h"

#include "shaders_c/common/vertices_shared.h"

typedef struct SliceVertex {
    float2 place;
} SliceVertex;

typedef struct SliceVarying {
    float2 uv;
    float3 way; /* from the eye, in space */
} SliceVarying;

vertex_shader(volume_slice_vs, VolumeSliceUniforms, SliceVertex, SliceVarying)
{
    float3 place = vec3(in->place.x, in->place.y, bcast(c->w));
    *position = m4x4(place, c->to_clip);
    out->uv = mul(add(in->place, 0.5f), u2(c->texel));
    out->way = sub(mul(place, u3(c->scale)), u3(c->eye));
}

/* A value beside a pixel's, by samples. */
GP_INLINE flt value_at(GpInvocation *gp, const VolumeSliceUniforms *c, float2 uv, float u, float v)
{
    float2 at = vec2(uv.x + u * c->texel[0], uv.y + v * c->texel[1]);
    return lrp(bcast(c->share), texld(1, at).x, texld(0, at).x);
}

/* What the slab leaves of light, and what a unit of space looks like in it. */
GP_INLINE float4 met_in_slab(GpInvocation *gp, const VolumeSliceUniforms *c, const SliceVarying *in,
                             flt value)
{
    float4 met = texld(2, vec2(mad(value, bcast(c->table[0]), c->table[1]), 0.5f));
    flt square = dp3(in->way, in->way);
    flt length = square * rsq(square) * rcp(max(abs_(in->way.z), 1e-6f)) * c->thickness;
    watch("value", value);
    watch("length", length);
    return rgba(xyz(met), 1.0f - exp_(met.w * length));
}

pixel_shader(volume_slice_ps, VolumeSliceUniforms, SliceVarying)
{
    flt value = lrp(bcast(c->share), texld(1, in->uv).x, texld(0, in->uv).x);
    float4 slab = met_in_slab(gp, c, in, value);
    return rgba(mul(xyz(slab), slab.w), slab.w);
}

pixel_shader(volume_slice_lit_ps, VolumeSliceUniforms, SliceVarying)
{
    flt before = texld(0, in->uv).x, behind = texld(1, in->uv).x;
    float4 slab = met_in_slab(gp, c, in, lrp(bcast(c->share), behind, before));
    flt along_u = value_at(gp, c, in->uv, 1, 0) - value_at(gp, c, in->uv, -1, 0);
    flt along_v = value_at(gp, c, in->uv, 0, 1) - value_at(gp, c, in->uv, 0, -1);
    float3 slope = mul(vec3(along_u, along_v, (behind - before) * 2.0f), u3(c->per_scale));
    flt square = dp3(slope, slope);
    flt facing = abs_(dp3(slope, u3(c->light))) * rsq(max(square, 1e-12f));
    flt light = mad(sel(square < 1e-12f, bcast(1), facing), bcast(c->diffuse), c->ambient);
    return rgba(mul(xyz(slab), slab.w * light), slab.w);
}

/* clang-format off */
#define SLICE_DECLARATIONS                                                                         \
    MODEL_2_0, .inputs = { { GP_POSITION, 2 } },                                                   \
    .varyings = { { "uv", 2, GP_PERSPECTIVE }, { "way", 3, GP_PERSPECTIVE } },                     \
    .samplers = 1 << 0 | 1 << 1 | 1 << 2

program(volume_slice_program, volume_slice_vs, volume_slice_ps, SLICE_DECLARATIONS)
program(volume_slice_lit_program, volume_slice_vs, volume_slice_lit_ps, SLICE_DECLARATIONS)
/* clang-format on */
