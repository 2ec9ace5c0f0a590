/* A ray through a volume, and what it meets: see raycast.h. For shader files only. */
#ifndef SHADERS_VOLUME_RAYCAST_SHARED_H
#define SHADERS_VOLUME_RAYCAST_SHARED_H

#include "shaders_c/volume/atlas_shared.h"
#include "shaders_c/volume/raycast.h"

/* --- steps ------------------------------------------------------------------------------------ */

typedef struct Ray {
    float3 start, step; /* samples; step k is about start + (k + 1/2) step */
    float3 per_step;    /* 1 / step */
    flt steps;          /* not whole */
    flt way;            /* place of its bricks */
} Ray;

GP_INLINE flt lesser3(float3 a)
{
    return min(a.x, min(a.y, a.z));
}

GP_INLINE flt greater3(float3 a)
{
    return max(a.x, max(a.y, a.z));
}

/* The part of a ray that lies in the volume; it ends at a share of its way. */
GP_INLINE Ray cut_ray(const RaycastUniforms *c, float3 start, float3 way, flt end)
{
    float3 per_way = vec3(rcp(way.x), rcp(way.y), rcp(way.z));
    float3 low = mul(neg(start), per_way);
    float3 high = mul(sub(u3(c->last), start), per_way);
    flt enters = max(greater3(min(low, high)), 0);
    flt leaves = min(lesser3(max(low, high)), min(end, 1.0f));
    float3 in_space = mul(way, u3(c->scale));
    flt steps = sqrt_(dp3(in_space, in_space)) * c->per_step;
    return (Ray){ .start = mad(way, enters, start),
                  .step = mul(way, rcp(steps)),
                  .per_step = mul(per_way, steps),
                  .steps = (leaves - enters) * steps,
                  .way = (sel(way.x < 0.0f, bcast(1), 0) + sel(way.y < 0.0f, bcast(2), 0) +
                          sel(way.z < 0.0f, bcast(4), 0)) *
                         c->way };
}

/* Before which step the ray leaves the cube of bricks about step k that are alike. */
GP_INLINE flt steps_until(GpInvocation *gp, const RaycastUniforms *c, const Ray *ray, flt k,
                          msk *empty)
{
    const float far = 127;
    float3 at = mad(ray->step, k + 0.5f, ray->start);
    float3 brick = floor_(mul(at, 1.0f / (float)VOLUME_BRICK));
    float4 place = volume_place(&c->bricks, brick.x, brick.y, brick.z);
    place.y = place.y + ray->way;
    flt run = texldl(1, place).x * 255.0f;
    flt side = sel(run > far, run - far, run);
    float3 wall =
        mul(add(brick, cmp(ray->per_step, sp3(side), sp3(1.0f - side))), (float)VOLUME_BRICK);
    *empty = run > far;
    return max(floor_(lesser3(mul(sub(wall, ray->start), ray->per_step)) + 0.5f), k + 1.0f);
}

/* --- what is met ------------------------------------------------------------------------------ */

/* How fast values rise, from a sample behind a place to one ahead along each axis in turn, inside
 * the volume. */
GP_INLINE float3 slope_at(GpInvocation *gp, const RaycastUniforms *c, float3 at)
{
    float3 axis = vec3(1, 0, 0), slope = sp3(bcast(0));
    flt turn = bcast(0);
    loop_while(3, turn < 3.0f)
    {
        float3 ahead = min(max(add(at, axis), 0), u3(c->last));
        float3 behind = min(max(sub(at, axis), 0), u3(c->last));
        flt rise = volume_value(gp, 0, &c->atlas, ahead) - volume_value(gp, 0, &c->atlas, behind);
        slope = mad(axis, rise, slope);
        axis = vec3(axis.z, axis.x, axis.y);
        turn = turn + 1.0f;
    }
    return vec3(slope.x / c->scale[0], slope.y / c->scale[1], slope.z / c->scale[2]);
}

/* Light of a place; where all is even, all of it. */
GP_INLINE flt light_at(GpInvocation *gp, const RaycastUniforms *c, float3 at)
{
    float3 slope = slope_at(gp, c, at);
    flt square = dp3(slope, slope);
    flt facing = abs_(dp3(slope, u3(c->light))) * rsq(max(square, 1e-12f));
    return mad(sel(square < 1e-12f, bcast(1), facing), bcast(c->diffuse), c->ambient);
}

/* Colour times alpha, and alpha, of a whole step. */
GP_INLINE float4 classified(GpInvocation *gp, const RaycastUniforms *c, const Ray *ray, flt middle,
                            bool lit)
{
    float3 at = mad(ray->step, middle, ray->start);
    flt value = volume_value(gp, 0, &c->atlas, at);
    float4 met = texldl(2, vec4(mad(value, c->table[0], c->table[1]), 0.5f, 0, 0));
    flt light = bcast(1);
    if (!lit)
        return met;
    loop_while(1, met.w > 0.0f)
    {
        light = light_at(gp, c, at);
    }
    return rgba(mul(xyz(met), light), met.w);
}

/* Where a lane has nothing left to add, and goes on only since others have, it adds nothing. */
GP_INLINE float4 walk(GpInvocation *gp, const RaycastUniforms *c, const Ray *ray, bool lit)
{
    const flt whole = floor_(ray->steps);
    float3 color = sp3(bcast(0));
    flt seen = bcast(1), k = bcast(0);

    loop_while(255, (msk)(k < whole) & (msk)(seen > c->least))
    {
        msk empty;
        flt until = min(steps_until(gp, c, ray, k, &empty), whole);
        k = sel(empty, until, k);
        loop_while(255, (msk)(k < until) & (msk)(seen > c->least))
        {
            float4 met = classified(gp, c, ray, k + 0.5f, lit);
            flt light = sel((msk)(k < whole) & (msk)(seen > c->least), seen, 0);
            color = mad(xyz(met), light, color);
            seen = seen - light * met.w;
            watch("step", k);
            watch("met", met);
            watch("light", light);
            watch("color", color);
            watch("seen", seen);
            k = k + 1.0f;
        }
    }
    loop_while(1, (msk)(ray->steps > 0.0f) & (msk)(seen > c->least))
    {
        flt rest = ray->steps - whole;
        float4 met = classified(gp, c, ray, whole + rest * 0.5f, lit);
        flt share = (1.0f - exp_(log_(1.0f - met.w) * rest)) / met.w;
        flt light = sel((msk)(ray->steps > 0.0f) & (msk)(seen > c->least) & (msk)(met.w > 0.0f),
                        seen * share, 0);
        color = mad(xyz(met), light, color);
        seen = seen - light * met.w;
        watch("step", whole);
        watch("met", met);
        watch("light", light);
        watch("color", color);
        watch("seen", seen);
    }
    return rgba(color, 1.0f - seen);
}

#endif
