/* Per-pixel lighting under one shadow map. Filtering compares first and averages then: Reeves,
 * Salesin and Cook, "Rendering antialiased shadows with depth maps", SIGGRAPH 1987. */

/* Square roots, one after the other, and a power, once the maps are read. */
#define GP_SHADER_AT_ONCE 4
#include "shaders_c/shadow/shadow.h"
#include "shaders_c/shadow/shadow_shared.h"

vertex_shader(lit_vs, ShadowUniforms, MeshVertex, Varying)
{
    transform(c, in->position, in->normal, position, out);
}

vertex_shader(lit_textured_vs, ShadowUniforms, TexturedVertex, TexturedVarying)
{
    transform(c, in->position, in->normal, position, &out->lit);
    out->uv = in->texcoord;
}

/* --- the map ---------------------------------------------------------------------------------- */

/* A cube map, its faces side by side: +x +y +z from the left, below them -x -y -z. Each sees a
 * quarter turn; coordinates stay half a texel inside, since the neighbour on the map is none in the
 * world. */
GP_INLINE flt cube(GpInvocation *gp, const ShadowUniforms *c, const Varying *in)
{
    float3 way = sub(in->surface.world, u3(c->light)), far = abs_(way);
    msk is_x = (far.x >= far.y) & (far.x >= far.z), is_y = ~is_x & (far.y >= far.z);
    flt major = sel(is_x, way.x, sel(is_y, way.y, way.z)), distance = abs_(major);
    flt sign = sel(major < 0.0f, bcast(-1), bcast(1)), zero = bcast(0);

    flt right = sel(is_x, sign * way.z, sel(is_y, zero - way.x, zero - sign * way.x));
    flt up = sel(is_y, zero - sign * way.z, way.y);
    flt inside = bcast(1 - c->half_texel), least = bcast(c->half_texel);
    flt u = min(max(right / distance * 0.5f + 0.5f, least), inside);
    flt v = min(max(up / distance * -0.5f + 0.5f, least), inside);
    flt column = sel(is_x, zero, sel(is_y, bcast(1), bcast(2)));
    flt row = sel(major < 0.0f, bcast(1), zero);
    flt depth = bcast(c->face_depth[0]) - c->face_depth[1] / distance - c->epsilon;
    return texldl(1, vec4((u + column) * (1.0f / 3), (v + row) * 0.5f, depth, 0)).x;
}

/* Way from the light to a depth of the map. */
GP_INLINE flt distance_at(const ShadowUniforms *c, flt z)
{
    return (z * c->distance[1] + c->distance[0]) / (z * c->distance[3] + c->distance[2]);
}

enum { SEARCH_TAPS = 5, FILTER_TAPS = 7 }; /* a side */

/* Side, in the map, of the light as seen from a surface through a hole in what blocks. */
GP_INLINE flt light_through(const ShadowUniforms *c, flt surface, flt blocker)
{
    return (surface - blocker) * c->light_size / (surface * blocker * c->spread[1] + c->spread[0]);
}

/* Place of a tap of a square of taps around 0, where a side is 1. */
GP_INLINE float tap(int i, int taps)
{
    return (float)(2 * i + 1 - taps) / (float)(2 * taps);
}

/* How a flat surface's depth changes along u and v of the map: a tap beside the centre is compared
 * with the surface's depth there, or what is slanted would shade itself.
 * source Isidoro, "Shadow mapping: GPU-based tips and techniques", GDC 2006 */
GP_INLINE float2 depth_slope(GpInvocation *gp, float3 place)
{
    float3 right = dsx(place), down = dsy(place);
    flt area = right.x * down.y - down.x * right.y;
    flt scale = sel(abs_(area) > 0.0f, rcp(area), bcast(0));
    return vec2((right.z * down.y - down.z * right.y) * scale,
                (right.x * down.z - down.x * right.z) * scale);
}

/* Percentage-closer soft shadows (Fernando, SIGGRAPH 2005 sketches): the mean distance of what
 * blocks tells the penumbra's width; so wide an area is then compared. */
GP_INLINE flt soft(GpInvocation *gp, const ShadowUniforms *c, const Varying *in)
{
    float3 place = plain_place(c, in->place);
    float2 slope = depth_slope(gp, place);
    flt surface = distance_at(c, place.z);
    flt reach = max(light_through(c, surface, bcast(c->nearest)), 0);
    flt sum = bcast(0), count = bcast(0), seen = bcast(0);
    for (int i = 0; i < SEARCH_TAPS * SEARCH_TAPS; i++) {
        flt du = reach * tap(i % SEARCH_TAPS, SEARCH_TAPS);
        flt dv = reach * tap(i / SEARCH_TAPS, SEARCH_TAPS);
        flt stored = stored_depth(gp, place.x + du, place.y + dv);
        flt blocks = slt(stored, place.z + du * slope.x + dv * slope.y);
        sum = sum + blocks * distance_at(c, stored);
        count = count + blocks;
    }
    flt width = light_through(c, surface, sum / max(count, 1));
    width = sel(count > 0.0f, width, bcast(0));
    for (int i = 0; i < FILTER_TAPS * FILTER_TAPS; i++) {
        flt du = width * tap(i % FILTER_TAPS, FILTER_TAPS);
        flt dv = width * tap(i / FILTER_TAPS, FILTER_TAPS);
        seen = seen + sge(stored_depth(gp, place.x + du, place.y + dv),
                          place.z + du * slope.x + dv * slope.y);
    }
    return seen * (1.0f / (float)(FILTER_TAPS * FILTER_TAPS));
}

/* --- programs --------------------------------------------------------------------------------- */

#define PAIR(form, facing, model, derivatives)                                                     \
    SHADOW_PAIR(form, facing, ShadowUniforms, c, 1 << 1, model, derivatives)

/* clang-format off */
PAIR(hardware, smooth, 2_0, false)
PAIR(hardware, flat, 3_0, true)
PAIR(plain_nearest, smooth, 3_0, false)
PAIR(plain_nearest, flat, 3_0, true)
PAIR(plain_bilinear, smooth, 3_0, false)
PAIR(plain_bilinear, flat, 3_0, true)
PAIR(cube, smooth, 3_0, false)
PAIR(cube, flat, 3_0, true)
/* The taps of soft are unrolled here, to more slots than ps_3_0 has; hardware would loop. */
PAIR(soft, smooth, 3_SW, true)
PAIR(soft, flat, 3_SW, true)
/* clang-format on */
