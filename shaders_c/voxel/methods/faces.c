/* A voxel is inside where, along each axis, its centre lies between the nearest surface seen from
 * either face.
 * source Karabassi, Papaioannou and Theoharis, "A fast depth-buffer-based voxelization algorithm",
 *        Journal of Graphics Tools 4(4), 1999 */
#include "shaders_c/common/cover_shared.h"
#include "shaders_c/voxel/methods/faces.h"

cover_vertex_shader(voxel_faces_vs, FlatTextureSlab);

/* 1 where places along an axis, 0..1, are between two depths. */
GP_INLINE float4 between(float4 place, float4 near, float4 from_far)
{
    return sge(min(sub(place, near), sub(sub(sp4(bcast(1)), place), from_far)), 0);
}

/* Four voxels along z at a place: 1 where they are inside. */
GP_INLINE float4 four_inside(GpInvocation *gp, flt x, flt y, float4 z, float4 inside_z)
{
    const flt height[4] = { z.x, z.y, z.z, z.w };
    flt depth[4][4];
    for (int k = 0; k < 4; k++) {
        float2 yz = vec2(y, height[k]), zx = vec2(height[k], x);
        depth[0][k] = texld(0, yz).x;
        depth[1][k] = texld(1, yz).x;
        depth[2][k] = texld(2, zx).x;
        depth[3][k] = texld(3, zx).x;
    }
    float4 inside_x = between(sp4(x), vec4(depth[0][0], depth[0][1], depth[0][2], depth[0][3]),
                              vec4(depth[1][0], depth[1][1], depth[1][2], depth[1][3]));
    float4 inside_y = between(sp4(y), vec4(depth[2][0], depth[2][1], depth[2][2], depth[2][3]),
                              vec4(depth[3][0], depth[3][1], depth[3][2], depth[3][3]));
    return mul(mul(inside_x, inside_y), inside_z);
}

pixel_shader(voxel_faces_ps, FlatTextureSlab, CoverVarying)
{
    float4 near = sp4(texld(4, in->place).x), from_far = sp4(texld(5, in->place).x);
    flt byte[4];
    for (int i = 0; i < 4; i++) {
        byte[i] = bcast(0);
        for (int half = 0; half < 2; half++) {
            float4 step = vec4(0.5f, 1.5f, 2.5f, 3.5f);
            float4 z = mul(add(step, bcast(c->base) + (float)(8 * i + 4 * half)), 1.0f / c->size);
            float4 inside =
                four_inside(gp, in->place.x, in->place.y, z, between(z, near, from_far));
            byte[i] = byte[i] + dp4(inside, vec4(1, 2, 4, 8)) * (half ? 16.0f : 1.0f);
        }
    }
    return mul(vec4(byte[2], byte[1], byte[0], byte[3]), 1.0f / 255);
}

program(voxel_faces_program, voxel_faces_vs, voxel_faces_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_3_0, COVER_DECLARATIONS, .samplers = 0x3f)
