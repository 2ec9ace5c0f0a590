/* What every program that lights a surface under a shadow map has in common: its vertices, the
 * place on the map, and the light that arrives. For shader files only.
 *
 * (ambient + diffuse S) texture + specular S, where S is the share of the light that arrives
 * (thesis, sections 4.2 and 4.3; Williams, "Casting curved shadows on curved surfaces", SIGGRAPH
 * 1978). */
#ifndef SHADERS_SHADOW_SHARED_H
#define SHADERS_SHADOW_SHARED_H

#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/shadow/shadow.h"

typedef struct Varying {
    SurfaceVarying surface;
    float4 place; /* in the map, projective */
} Varying;

typedef struct TexturedVarying {
    Varying lit;
    float2 uv;
} TexturedVarying;

GP_INLINE float3 towards_light(const ShadowUniforms *c, float3 world)
{
    return nrm(sub(u3(c->light), mul(world, bcast(c->light[3]))));
}

/* A surface that the light grazes is looked up further out along its normal, by so much that a
 * texel does not reach below it.
 * source Holbert, "Saying goodbye to shadow acne", GDC 2011: normal offset shadows */
GP_INLINE float4 find_place(const ShadowUniforms *c, float3 world, float3 normal)
{
    float4 place = m4x4(world, c->map);
    flt cosine = sat(dp3(normal, towards_light(c, world)));
    flt sine = sqrt_(bcast(1) - cosine * cosine);
    flt length = place.w * sine * (c->offset * c->texel);
    return add(place, m4x4(rgba(mul(normal, length), 0), c->map));
}

GP_INLINE void transform(const ShadowUniforms *c, float3 world, float3 normal, float4 *position,
                         Varying *out)
{
    *position = mesh_surface(c->mvp, world, normal, &out->surface);
    out->place = find_place(c, world, normal);
}

/* Positive where the surface, smooth as its normals say, is turned to the light. */
GP_INLINE flt smooth(__attribute__((unused)) GpInvocation *gp, const ShadowUniforms *c,
                     const Varying *in)
{
    return dp3(in->surface.normal, towards_light(c, in->surface.world));
}

/* The same for the triangle itself, whichever side is seen: the light is on the eye's side of its
 * plane. Where triangles are large beside the map's texels, this decides at the terminator, since a
 * triangle cannot shade itself. */
GP_INLINE flt flat(GpInvocation *gp, const ShadowUniforms *c, const Varying *in)
{
    float3 plane = crs(dsx(in->surface.world), dsy(in->surface.world));
    float3 to_eye = sub(u3(c->eye), in->surface.world);
    return dp3(plane, towards_light(c, in->surface.world)) * dp3(plane, to_eye);
}

/* --- ways to ask the map, in slot 1 ----------------------------------------------------------- */

/* From clip space, at the pixel. */
GP_INLINE float3 plain_place(const ShadowUniforms *c, float4 clip)
{
    flt x = clip.x / clip.w, y = clip.y / clip.w;
    return vec3(x * 0.5f + (0.5f + c->half_texel), y * -0.5f + (0.5f + c->half_texel),
                clip.z / clip.w - c->epsilon);
}

/* The map has one level, so that texldl reads what texld would. */
GP_INLINE flt stored_depth(GpInvocation *gp, flt u, flt v)
{
    return texldl(1, vec4(u, v, 0, 0)).x;
}

GP_INLINE flt plain_nearest(GpInvocation *gp, const ShadowUniforms *c, const Varying *in)
{
    float3 place = plain_place(c, in->place);
    return sge(stored_depth(gp, place.x, place.y), place.z);
}

GP_INLINE flt plain_bilinear(GpInvocation *gp, const ShadowUniforms *c, const Varying *in)
{
    float3 place = plain_place(c, in->place);
    flt size = bcast(c->map_size), step = rcp(size), depth = place.z;
    flt s = place.x * size - 0.5f, t = place.y * size - 0.5f;
    flt left = (floor_(s) + 0.5f) * step, top = (floor_(t) + 0.5f) * step;
    flt right = left + step, bottom = top + step;

    /* each by its name: a compiler chooses the order of what stands in one expression */
    flt upper_left = sge(stored_depth(gp, left, top), depth);
    flt upper_right = sge(stored_depth(gp, right, top), depth);
    flt lower_left = sge(stored_depth(gp, left, bottom), depth);
    flt lower_right = sge(stored_depth(gp, right, bottom), depth);
    flt upper = lrp(frc(s), upper_right, upper_left);
    flt lower = lrp(frc(s), lower_right, lower_left);
    return lrp(frc(t), lower, upper);
}

GP_INLINE flt hardware(GpInvocation *gp, const ShadowUniforms *c, const Varying *in)
{
    (void)c;
    return texldp(1, in->place).x;
}

/* --- light ------------------------------------------------------------------------------------ */

/* What the maps say of a surface. */
typedef struct Asked {
    flt seen, facing;
} Asked;

typedef struct AskedTextured {
    Asked lit;
    float3 texture;
} AskedTextured;

/* A surface that faces away is dark whatever it says, and so is all that is
 * beside the cone; behind the light the map says nothing. */
GP_INLINE float4 light_surface(const ShadowUniforms *c, const Varying *in, const Asked *asked,
                               float3 texture)
{
    float3 L = towards_light(c, in->surface.world);
    float3 N = nrm(in->surface.normal);
    float3 V = nrm(sub(u3(c->eye), in->surface.world));
    float3 H = nrm(add(V, L));

    flt S = sel(in->place.w > c->least_w, asked->seen, bcast(1));
    S = sel(asked->facing > 0.0f, S, bcast(0)) * sge(neg(dp3(L, u3(c->axis))), bcast(c->axis[3]));
    float3 arriving = mul(u3(c->color), S);

    flt highlight = pow_(max(dp3(N, H), 0), bcast(c->shininess)) * c->specular;
    float3 diffuse = mul(u3(c->diffuse), max(dp3(N, L), 0));
    float3 color = mul(mad(diffuse, arriving, u3(c->ambient)), texture);
    return rgba(mad(arriving, highlight, color), S);
}

/* clang-format off */
#define LIT_VARYINGS SURFACE_VARYINGS, { "place", 4, GP_PERSPECTIVE }

/* The pixel shaders and programs of a way to ask the map and one to face the light, without and
 * with a texture: form(gp, c, varying) is what the map says, facing(gp, shadow, varying) the other.
 * The file has the vertex shaders lit_vs and lit_textured_vs.
 * in   U: uniforms; shadow: what of them, c, is ShadowUniforms; maps: bits of samplers; model: of
 *      the profiles, 2_0, 3_0 or 3_SW */
#define SHADOW_PAIR(form, facing, U, shadow, maps, model, derivatives)                             \
    pixel_shader_begin(form##_##facing##_ps, U, Varying, Asked)                                    \
    {                                                                                              \
        flt seen = form(gp, c, in);                                                                \
        return (Asked){ seen, facing(gp, shadow, in) };                                            \
    }                                                                                              \
    pixel_shader_end(form##_##facing##_ps, U, Varying, Asked)                                      \
    {                                                                                              \
        return light_surface(shadow, in, begun, sp3(bcast(1)));                                    \
    }                                                                                              \
    pixel_shader_begin(form##_##facing##_textured_ps, U, TexturedVarying, AskedTextured)           \
    {                                                                                              \
        const Varying *lit = &in->lit;                                                             \
        float3 texture = xyz(texld(0, in->uv));                                                    \
        flt seen = form(gp, c, lit);                                                               \
        return (AskedTextured){ { seen, facing(gp, shadow, lit) }, texture };                      \
    }                                                                                              \
    pixel_shader_end(form##_##facing##_textured_ps, U, TexturedVarying, AskedTextured)             \
    {                                                                                              \
        return light_surface(shadow, &in->lit, &begun->lit, begun->texture);                       \
    }                                                                                              \
    program(shadow_##form##_##facing##_program, lit_vs, form##_##facing##_ps,                      \
            .vertex_profile = GP_VS_##model, .pixel_profile = GP_PS_##model,                       \
            .inputs = { MESH_INPUTS }, .varyings = { LIT_VARYINGS }, .samplers = maps,             \
            .uses_derivatives = derivatives)                                                       \
    program(shadow_##form##_##facing##_textured_program, lit_textured_vs,                          \
            form##_##facing##_textured_ps, .vertex_profile = GP_VS_##model,                        \
            .pixel_profile = GP_PS_##model, .inputs = { MESH_INPUTS, { GP_TEXCOORD0, 2 } },        \
            .varyings = { LIT_VARYINGS, { "uv", 2, GP_PERSPECTIVE } },                             \
            .samplers = 1 << 0 | maps, .uses_derivatives = derivatives)
/* clang-format on */

#endif
