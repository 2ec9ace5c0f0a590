/* Voxels by adding: each fragment adds the power of two of its voxel to one channel of one of four
 * eight-bit targets, as Dong, Chen, Bao, Zhang and Peng do in "Real-time voxelization for complex
 * polygonal models", Pacific Graphics 2004. Depth 0..1 is 256 voxels in 8 slabs of 32: bit 8 c + k
 * of a slab is bit k of channel c, red first. Fragments that share a voxel carry into the next. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/bench/slab_bits.h"

vertex_shader(slab_bits_vs, SlabBitsUniforms, PointVertex, DepthVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->depth = position->z;
}

pixel_shader_targets(slab_bits_ps, SlabBitsUniforms, DepthVarying, SlabTargets)
{
    flt voxel = floor_(in->depth * 256.0f);
    flt slab = floor_(voxel * (1.0f / 32)), target = slab - c->first_slab;
    discard((target < 0.0f) | (target > 3.0f));

    flt bit = voxel - 32.0f * slab, channel = floor_(bit * (1.0f / 8));
    flt code = exp_(bit - 8.0f * channel) / 255.0f;
    float4 bits = vec4(sel(channel == 0.0f, code, 0), sel(channel == 1.0f, code, 0),
                       sel(channel == 2.0f, code, 0), sel(channel == 3.0f, code, 0));
    for (int i = 0; i < 4; i++)
        out->slab[i] = sel(target == (float)i, bits, 0);
}

program(slab_bits_program, slab_bits_vs, slab_bits_ps, MODEL_2_0, .inputs = { { GP_POSITION, 3 } },
        .varyings = { { "depth", 1, GP_PERSPECTIVE } }, .may_discard = true)
