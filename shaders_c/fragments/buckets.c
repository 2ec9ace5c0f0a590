#include "shaders_c/fragments/buckets.h"

#include "shaders_c/fragments/fragment_shared.h"

/* --- colours as numbers ----------------------------------------------------------------------- */

/* 1 to 2^24: 0 is no fragment. The greenest of two is the greater one, whichever is nearer. */
GP_INLINE flt to_number(float4 color)
{
    float3 codes = floor_(mad(sat(xyz(color)), 255, 0.5f));
    return min(mad(codes.y, bcast(65536), mad(codes.x, bcast(256), codes.z)) + 1.0f, 16777216);
}

GP_INLINE float3 to_color(flt number)
{
    flt code = number - 1.0f, green = floor_(code * (1 / 65536.0f));
    flt rest = code - green * 65536.0f, red = floor_(rest * (1 / 256.0f));
    return mul(vec3(red, green, rest - red * 256.0f), 1 / 255.0f);
}

/* Four channels, of which one gets a value, by numbers from `first` on. */
GP_INLINE float4 into_channel(flt channel, float first, flt value)
{
    flt none = bcast(0), at = channel - first;
    return vec4(sel(at == 0.0f, value, none), sel(at == 1.0f, value, none),
                sel(at == 2.0f, value, none), sel(at == 3.0f, value, none));
}

typedef struct BucketTargets {
    float4 target[4];
} BucketTargets;

GP_INLINE BucketTargets into_bucket(flt bucket, flt value)
{
    BucketTargets targets;
    for (int i = 0; i < 4; i++)
        targets.target[i] = into_channel(bucket, 4.0f * (float)i, value);
    return targets;
}

/* --- of equal depth --------------------------------------------------------------------------- */

vertex_shader(bucket_vs, BucketUniforms, FragmentVertex, FragmentVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->depth = position->z * rcp(position->w);
    out->color = in->color;
}

/* Of so many parts of the mesh's depth the one that has a depth. */
GP_INLINE flt find_part(const BucketUniforms *c, flt depth, float parts)
{
    flt along = mad(depth, bcast(c->depth[1]), bcast(c->depth[0]));
    return max(min(floor_(along * parts), parts - 1.0f), 0);
}

pixel_shader_targets(bucket_single_ps, BucketUniforms, FragmentVarying, BucketTargets)
{
    *out = into_bucket(find_part(c, in->depth, BUCKETS), to_number(in->color));
}

program(bucket_single_program, bucket_vs, bucket_single_ps, FRAGMENT_DECLARATIONS, MODEL_3_0)

/* --- pairs ------------------------------------------------------------------------------------ */

pixel_shader_targets(bucket_range_ps, BucketUniforms, FragmentVarying, BucketTargets)
{
    flt bucket = find_part(c, in->depth, BUCKETS / 2) * 2.0f;
    for (int i = 0; i < 4; i++)
        out->target[i] = add(into_channel(bucket, 4.0f * (float)i, 2.0f - in->depth),
                             into_channel(bucket + 1.0f, 4.0f * (float)i, in->depth + 1.0f));
}

program(bucket_range_program, bucket_vs, bucket_range_ps, FRAGMENT_DECLARATIONS, MODEL_3_0)

/* A bucket's only fragment is its nearest and its farthest: it counts as the nearest. */
GP_INLINE void into_pair(float2 range, flt depth, float2 *pair)
{
    msk is_nearest = range.x == 2.0f - depth, is_farthest = range.y == depth + 1.0f;
    pair->x = sel(is_nearest, pair->x, bcast(0));
    pair->y = sel((msk)is_farthest & ~(msk)is_nearest, pair->y, bcast(0));
}

pixel_shader_targets(bucket_pair_ps, BucketUniforms, FragmentVarying, BucketTargets)
{
    flt number = to_number(in->color);
    flt bucket = find_part(c, in->depth, BUCKETS / 2) * 2.0f;
    for (int i = 0; i < 4; i++) {
        float4 range = gp_load_local(i);
        float4 nearest = into_channel(bucket, 4.0f * (float)i, number);
        float4 farthest = into_channel(bucket + 1.0f, 4.0f * (float)i, number);
        float2 pair[2] = { vec2(nearest.x, farthest.y), vec2(nearest.z, farthest.w) };
        into_pair(vec2(range.x, range.y), in->depth, &pair[0]);
        into_pair(vec2(range.z, range.w), in->depth, &pair[1]);
        out->target[i] = vec4(pair[0].x, pair[0].y, pair[1].x, pair[1].y);
    }
}

program(bucket_pair_program, bucket_vs, bucket_pair_ps, FRAGMENT_DECLARATIONS, MODEL_3_0,
        .local_reads = 15)

/* --- where fragments are ---------------------------------------------------------------------- */

/* Bit n of a byte, as a unorm code. */
GP_INLINE flt to_bit(flt n)
{
    return exp_(n) * (1 / 255.0f);
}

GP_INLINE flt to_byte(flt unorm)
{
    return floor_(mad(unorm, bcast(255), bcast(0.5f)));
}

/* Bits that are set in a byte: what halving it again and again loses. */
GP_INLINE flt set_bits(flt byte)
{
    flt count = byte;
    for (int i = 1; i < 8; i++)
        count = count - floor_(byte * (1 / (float)(1 << i)));
    return count;
}

pixel_shader_targets(bucket_bits_ps, BucketUniforms, FragmentVarying, BucketTargets)
{
    flt part = find_part(c, in->depth, BUCKET_BITS), byte = floor_(part * (1 / 8.0f));
    *out = into_bucket(byte, to_bit(part - byte * 8.0f));
}

program(bucket_bits_program, bucket_vs, bucket_bits_ps, FRAGMENT_DECLARATIONS, MODEL_3_0)

clip_vertex_shader(bucket_count_vs, NoUniforms);

pixel_shader_targets(bucket_count_ps, NoUniforms, NoVarying, BucketTargets)
{
    flt before = bcast(0);
    for (int i = 0; i < 4; i++) {
        float4 bytes = gp_load_local(i);
        flt x = before, y = x + set_bits(to_byte(bytes.x)), z = y + set_bits(to_byte(bytes.y));
        flt w = z + set_bits(to_byte(bytes.z));
        out->target[i] = vec4(x, y, z, w);
        before = w + set_bits(to_byte(bytes.w));
    }
}

program(bucket_count_program, bucket_count_vs, bucket_count_ps, MODEL_3_0,
        .inputs = { { GP_POSITION, 3 } }, .local_reads = 15)

/* Channel number `channel` of those of slots from `slot` on. */
GP_INLINE flt channel_at(GpInvocation *gp, int slot, flt channel)
{
    flt value = bcast(0);
    for (int i = 0; i < 4; i++) {
        float4 read = gp_load_local(slot + i);
        flt at = channel - 4.0f * (float)i;
        value = sel(at == 0.0f, read.x, value);
        value = sel(at == 1.0f, read.y, value);
        value = sel(at == 2.0f, read.z, value);
        value = sel(at == 3.0f, read.w, value);
    }
    return value;
}

pixel_shader_targets(bucket_ranked_ps, BucketUniforms, FragmentVarying, BucketTargets)
{
    flt part = find_part(c, in->depth, BUCKET_BITS), byte = floor_(part * (1 / 8.0f));
    flt scale = exp_(byte * 8.0f - part), bits = to_byte(channel_at(gp, 0, byte)) * scale;
    flt lower = (bits - floor_(bits)) * exp_(part - byte * 8.0f);
    *out = into_bucket(channel_at(gp, 4, byte) + set_bits(lower), to_number(in->color));
}

program(bucket_ranked_program, bucket_vs, bucket_ranked_ps, FRAGMENT_DECLARATIONS, MODEL_3_0,
        .local_reads = 255)

/* --- put together ----------------------------------------------------------------------------- */

clip_vertex_shader(bucket_layers_vs, BucketLayersUniforms);

GP_INLINE float4 put_under(float4 layers, flt number, float alpha)
{
    float4 source = mul(rgba(to_color(number), 1), alpha);
    return mad(sel(number > 0.0f, source, sp4(bcast(0))), 1.0f - layers.w, layers);
}

pixel_shader(bucket_layers_ps, BucketLayersUniforms, NoVarying)
{
    float4 layers = sp4(bcast(0));
    for (int i = 0; i < 4; i++) {
        float4 four = gp_load_local(i);
        layers = put_under(layers, four.x, c->alpha);
        layers = put_under(layers, four.y, c->alpha);
        layers = put_under(layers, four.z, c->alpha);
        layers = put_under(layers, four.w, c->alpha);
    }
    return layers;
}

program(bucket_layers_program, bucket_layers_vs, bucket_layers_ps, MODEL_3_0,
        .inputs = { { GP_POSITION, 3 } }, .local_reads = 15)
