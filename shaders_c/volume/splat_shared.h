/* A voxel's footprint. For shader files only. */
#ifndef SHADERS_VOLUME_SPLAT_SHARED_H
#define SHADERS_VOLUME_SPLAT_SHARED_H

#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/volume/splat.h"

#define VOXEL_HALF_LOG2_E 0.72134752044448170368f

/* --- voxels in 8 bytes ------------------------------------------------------------------------ */

typedef struct VoxelVertex {
    float4 attributes; /* value; gradient x, y, z, each + 128 */
    float4 place;      /* x, y, z modulo 256; x / 256 * 32 + y / 256 * 4 + z / 256 */
} VoxelVertex;

#define VOXEL_INPUTS                                                                               \
    { GP_TEXCOORD0, 4 },                                                                           \
    {                                                                                              \
        GP_TEXCOORD1, 4                                                                            \
    }

GP_INLINE float3 voxel_place(float4 place)
{
    flt x = floor_(place.w * (1.0f / 32)), rest = place.w - x * 32;
    flt y = floor_(rest * 0.25f), z = rest - y * 4;
    return vec3(mad(x, 256, place.x), mad(y, 256, place.y), mad(z, 256, place.z));
}

/* --- before the eye --------------------------------------------------------------------------- */

typedef struct EyeVoxel {
    float3 position;
    float2 slope; /* x/z, y/z; 0 where rays are parallel */
    flt w, scale; /* pixels that a unit takes here */
} EyeVoxel;

GP_INLINE flt voxel_row(const float row[4], float3 v)
{
    return mad(v.x, row[0], mad(v.y, row[1], mad(v.z, row[2], row[3])));
}

GP_INLINE EyeVoxel voxel_before_eye(const VoxelUniforms *c, float3 place)
{
    EyeVoxel eye;
    eye.position =
        vec3(voxel_row(c->eye[0], place), voxel_row(c->eye[1], place), voxel_row(c->eye[2], place));
    eye.w = mad(max(eye.position.z, c->nearest), c->perspective[0], c->perspective[1]);
    flt per_w = rcp(eye.w);
    eye.scale = per_w * c->focal;
    eye.slope = mul(vec2(eye.position.x, eye.position.y), per_w * c->perspective[0]);
    return eye;
}

/* Outside where it is too near, or where nothing is to be seen of it. */
GP_INLINE float4 voxel_clip(const VoxelUniforms *c, const EyeVoxel *eye, flt strength)
{
    const float3 p = eye->position;
    float4 clip = vec4(p.x * (c->focal * c->ndc[0]), -p.y * (c->focal * c->ndc[1]),
                       mad(p.z, c->depth[0], c->depth[1]), eye->w);
    msk met = (msk)(abs_(p.x) <= mad(eye->w, c->side[0], c->reach[0])) &
              (msk)(abs_(p.y) <= mad(eye->w, c->side[1], c->reach[1]));
    msk drawn = met & (msk)(p.z >= c->nearest) & (msk)(strength > 0.0f);
    return sel(drawn, clip, vec4(0, 0, -1, 1)); /* before the near plane, however large it is */
}

/* Pixel whose centre is the voxel's, as vpos counts. */
GP_INLINE float2 voxel_pixel(const VoxelUniforms *c, const EyeVoxel *eye)
{
    return vec2(mad(eye->position.x, eye->scale, c->centre[0] - 0.5f),
                mad(eye->position.y, eye->scale, c->centre[1] - 0.5f));
}

/* --- footprints ------------------------------------------------------------------------------- */

/* What of V is left out. */
typedef enum VoxelFootprint {
    FOOTPRINT_EWA,
    FOOTPRINT_RECONSTRUCTION,
    FOOTPRINT_LOW_PASS
} VoxelFootprint;

typedef struct VoxelSplat {
    float3 conic; /* 2^-(x^2 conic.x + x y conic.y + y^2 conic.z) is the Gaussian */
    flt side;     /* of the square that holds it */
    flt height;   /* of strength 1 */
} VoxelSplat;

/* W S W^T of one voxel. */
typedef struct VoxelSpread {
    flt xx, xy, yy, xz, yz, zz;
} VoxelSpread;

GP_INLINE VoxelSpread voxel_spread(const VoxelUniforms *c)
{
    return (VoxelSpread){ bcast(c->spread[0]), bcast(c->spread[1]), bcast(c->spread[2]),
                          bcast(c->spread[3]), bcast(c->spread[4]), bcast(c->spread[5]) };
}

GP_INLINE VoxelSplat voxel_splat_spread(const VoxelUniforms *c, const EyeVoxel *eye,
                                        VoxelSpread spread, VoxelFootprint which)
{
    VoxelSplat splat;
    flt square = eye->scale * eye->scale;
    float2 s = eye->slope;
    flt height = square * sqrt_(mad(s.x, s.x, mad(s.y, s.y, 1))) * c->strength;
    if (which == FOOTPRINT_LOW_PASS) {
        flt per_h = rcp(bcast(c->low_pass));
        splat.conic = vec3(per_h * VOXEL_HALF_LOG2_E, 0, per_h * VOXEL_HALF_LOG2_E);
        splat.side = sqrt_(bcast(c->low_pass)) * (2 * c->cut);
        splat.height = height * per_h;
        return splat;
    }
    const float h = which == FOOTPRINT_EWA ? c->low_pass : 0;
    flt xx = mad(s.x, mad(s.x, spread.zz, spread.xz * -2), spread.xx);
    flt yy = mad(s.y, mad(s.y, spread.zz, spread.yz * -2), spread.yy);
    flt xy = mad(s.x, mad(s.y, spread.zz, -spread.yz), mad(s.y, -spread.xz, spread.xy));
    xx = mad(xx, square, h);
    yy = mad(yy, square, h);
    xy = xy * square;
    flt det = max(mad(xx, yy, -(xy * xy)), 1e-12f);
    flt per_det = rcp(det) * VOXEL_HALF_LOG2_E;
    splat.conic = vec3(yy * per_det, xy * per_det * -2, xx * per_det);
    splat.side = sqrt_(max(xx, yy)) * (2 * c->cut);
    splat.height = height * rsq(det);
    return splat;
}

GP_INLINE VoxelSplat voxel_splat(const VoxelUniforms *c, const EyeVoxel *eye, VoxelFootprint which)
{
    return voxel_splat_spread(c, eye, voxel_spread(c), which);
}

/* Rounding of places on the screen, to 1/256 of a pixel, hides no pixel of a footprint: sprites and
 * quads have the same ones. */
#define VOXEL_ROOM 0.03125f

/* The weight of a footprint at a pixel, as a share of its height. */
GP_INLINE flt voxel_weight(const VoxelUniforms *c, float3 conic, float2 place, float2 pixel)
{
    flt x = pixel.x - place.x, y = pixel.y - place.y;
    flt exponent = mad(x, mad(conic.x, x, conic.y * y), conic.z * (y * y));
    flt weight = sel(exponent > c->farthest, bcast(0), exp_(-exponent));
    watch("exponent", exponent);
    watch("weight", weight);
    return weight;
}

/* --- light ------------------------------------------------------------------------------------ */

/* In eye space, of length 1, or 0 where there is no gradient. in gradient: 127 times a direction */
GP_INLINE float3 voxel_normal(const VoxelUniforms *c, float3 gradient)
{
    float3 n = vec3(dp3(gradient, u3(c->normal[0])), dp3(gradient, u3(c->normal[1])),
                    dp3(gradient, u3(c->normal[2])));
    flt square = dp3(n, n);
    return mul(n, sel(square < 0.5f, bcast(0), rsq(max(square, 0.5f))));
}

/* A light beside the eye, from both sides: gradients of densities have no outside. Without a
 * gradient all is lit. */
GP_INLINE flt voxel_light(const VoxelUniforms *c, float3 gradient)
{
    if (c->diffuse <= 0)
        return bcast(c->ambient);
    float3 n = voxel_normal(c, gradient);
    flt facing = sel(dp3(n, n) < 0.5f, bcast(1), abs_(dp3(n, u3(c->light))));
    return mad(facing, c->diffuse, c->ambient);
}

GP_INLINE float4 voxel_color(GpInvocation *gp, const VoxelUniforms *c, float4 attributes)
{
    float4 look = texldl(0, vec4((attributes.x + 0.5f) * (1.0f / 256), 0.5f, 0, 0));
    flt light = voxel_light(c, sub(vec3(attributes.y, attributes.z, attributes.w), 128));
    return rgba(mul(xyz(look), light), look.w);
}

typedef struct VoxelVarying {
    float3 conic;
    float2 place;
    float4 color; /* times height, and height */
} VoxelVarying;

/* clang-format off */
#define VOXEL_VARYINGS                                                                             \
    { "conic", 3, GP_FLAT }, { "place", 2, GP_FLAT }, { "color", 4, GP_FLAT }
/* clang-format on */

GP_INLINE void voxel_put(const VoxelUniforms *c, const EyeVoxel *eye, float4 color,
                         const VoxelSplat *splat, VoxelVarying *out, flt *side)
{
    flt height = color.w * splat->height;
    *side = splat->side + VOXEL_ROOM;
    out->conic = splat->conic;
    out->place = voxel_pixel(c, eye);
    out->color = rgba(mul(xyz(color), height), height);
}

GP_INLINE void voxel_vertex(const VoxelUniforms *c, const EyeVoxel *eye, float4 color,
                            VoxelFootprint which, VoxelVarying *out, flt *side)
{
    VoxelSplat splat = voxel_splat(c, eye, which);
    voxel_put(c, eye, color, &splat, out, side);
}

#endif
