/* Bucket peeling: fragments go into buckets by their depths, in one pass over the mesh or in two.
 * source Liu, Huang, Liu and Wu, "Efficient depth peeling via bucket sort", High Performance
 *      Graphics 2009
 *
 * A bucket is a channel of four A32B32G32R32F targets, which keeps the greatest of what is written
 * to it: a colour as a number, 8 bits each for red, green and blue, and one more. Cleared to 0.
 * (Hardware of 2009 had eight targets.) One alpha for all. */
#ifndef SHADERS_FRAGMENTS_BUCKETS_H
#define SHADERS_FRAGMENTS_BUCKETS_H

#include "pipeline/shader/program.h"

enum { BUCKETS = 16, BUCKET_BITS = 128 };

typedef struct BucketUniforms {
    float mvp[4][4];
    float depth[2]; /* to 0..1 of what the mesh has: depth[0] + depth[1] * depth */
} BucketUniforms;

/* Buckets of equal depth, one fragment each. */
extern const GpProgram bucket_single_program;

/* Half as many, in pairs: the first pass finds 2 - depth of the nearest and 1 + depth of the
 * farthest in each; the second, which has these in slots 0 to 3, writes their colours. */
extern const GpProgram bucket_range_program, bucket_pair_program;

/* The first pass: a bit in four A8R8G8B8 targets, by OR, for each of BUCKET_BITS parts of the depth
 * that has a fragment. Over all pixels: slots 0 to 3, these bits; targets 0 to 3, A16B16G16R16F:
 * how many of the bits before each byte are set. The second pass: slots 0 to 3 and 4 to 7 are both;
 * each part that has a fragment is a bucket, as far as there are any. */
extern const GpProgram bucket_bits_program, bucket_count_program, bucket_ranked_program;

/* Over all pixels: slots 0 to 3, buckets from front to back, put together. */
typedef struct BucketLayersUniforms {
    float alpha;
} BucketLayersUniforms;

extern const GpProgram bucket_layers_program;

#endif
