/* Surfels from 8 bytes, for vertex shaders. For shader files only.
 *
 * Ours: one stream of four GP_UINT16, 64 bits:
 *
 *     word   bits 0 and up          bits above
 *     0      x, 11                  z / 32, 5
 *     1      y, 11                  z mod 32, 5
 *     2      u, 9                   share, 7
 *     3      v, 9                   radius, 7
 *
 * with x, y, z along the axes of the patch's own box, u, v on an octahedron (Meyer et al., "On
 * floating-point normal vectors", EGSR 2010; Cigolle et al., JCGT 2014), and the logarithm of the
 * radius between the least and the largest of the patch.
 *
 * Printed: two streams of four GP_UINT8 (Dong Zhao's thesis, table 3.1):
 *
 *     stream 0   cell x, cell y, cell z of 256 each along the world's axes; inside of the cell
 *                x of 8 (bits 0 to 2), y of 8 (3 to 5), z of 4 (6, 7)
 *     stream 1   theta of 256, phi of 256; form of the tangent (bits 0, 1), corner of a quad (2,
 *                3), share of 16 (4 to 7; these bits are free in print); number of the radius in a
 *                table
 */
#ifndef SHADERS_POINTS_COMPRESSED_SHARED_H
#define SHADERS_POINTS_COMPRESSED_SHARED_H

#include <glasspipe/shader.h>
#include "shaders_c/points/compressed.h"

typedef struct CompressedSurfel {
    float3 position, normal;
    flt radius, share;
} CompressedSurfel;

/* What stands from bit log2(scale) on; the rest stays in *low. */
GP_INLINE flt bits_above(flt word, float scale, flt *low)
{
    flt high = floor_(word * (1 / scale));
    *low = word - high * scale;
    return high;
}

GP_INLINE float3 compressed_place(const CompressedFrame *c, flt x, flt y, flt z)
{
    return mad(u3(c->steps[0]), x, mad(u3(c->steps[1]), y, mad(u3(c->steps[2]), z, u3(c->origin))));
}

GP_INLINE CompressedSurfel decompress(const CompressedFrame *c, float4 words)
{
    flt x, y, u, v;
    flt z = bits_above(words.x, 2048, &x) * 32 + bits_above(words.y, 2048, &y);
    flt share = bits_above(words.z, 512, &u), radius = bits_above(words.w, 512, &v);
    float2 place = mad(vec2(u, v), 2.0f / 511, -1);
    flt below = 1.0f - abs_(place.x) - abs_(place.y);
    flt fold = max(0.0f - below, 0);
    float3 normal = vec3(place.x - cmp(place.x, fold, 0.0f - fold),
                         place.y - cmp(place.y, fold, 0.0f - fold), below);
    return (CompressedSurfel){ .position = compressed_place(c, x, y, z),
                               .normal = nrm(normal),
                               .radius = exp_(radius * c->radius[1] + c->radius[0]),
                               .share = share * c->share[1] + c->share[0] };
}

/* --- the printed form ------------------------------------------------------------------------- */

typedef struct PrintedSurfel {
    CompressedSurfel surfel;
    float3 tangent; /* unit length, square to the normal */
    flt corner;     /* 0 to 3 */
} PrintedSurfel;

/* A direction square to the normal, by its form: (0, -nz, ny), (nz, 0, -nx) or (-ny, nx, 0). Each
 * has no length for one normal; the form of 0, 1 or 2 that leaves out the least component of the
 * normal always has one of 0.8 at least. */
GP_INLINE float3 tangent_of_form(float3 n, flt form)
{
    float3 first = vec3(0, 0.0f - n.z, n.y), second = vec3(n.z, 0, 0.0f - n.x);
    float3 third = vec3(0.0f - n.y, n.x, 0);
    return nrm(sel(form < 0.5f, first, sel(form < 1.5f, second, third)));
}

/* in   place, rest: the two streams; slot: of the vertex texture of radii */
GP_INLINE PrintedSurfel decompress_printed(GpInvocation *gp, const CompressedFrame *c, float4 place,
                                           float4 rest, int slot)
{
    const float pi = 3.14159265358979f;
    flt x, y, form, corner;
    flt z = bits_above(place.w, 64, &y);
    y = bits_above(y, 8, &x);
    flt share = bits_above(rest.z, 16, &corner);
    corner = bits_above(corner, 4, &form);
    float2 theta = sincos_((rest.x + 0.5f) * (pi / 256)),
           phi = sincos_((rest.y + 0.5f) * (pi / 128));
    float3 normal = vec3(theta.y * phi.x, theta.y * phi.y, theta.x);
    float4 radius = texldl(slot, vec4((rest.w + 0.5f) * (1.0f / 256), 0.5f, 0, 0));
    return (PrintedSurfel){ .surfel = { .position = compressed_place(
                                            c, place.x * 8 + x, place.y * 8 + y, place.z * 4 + z),
                                        .normal = normal,
                                        .radius = radius.x,
                                        .share = share * c->share[1] + c->share[0] },
                            .tangent = tangent_of_form(normal, form),
                            .corner = corner };
}

#endif
