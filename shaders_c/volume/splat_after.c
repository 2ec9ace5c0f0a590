#include "shaders_c/volume/splat_after.h"

#include "shaders_c/volume/splat_shared.h"
#include "shaders_c/volume/sheet_shared.h"

GP_INLINE void after_point(const VoxelUniforms *c, const VoxelVertex *in, VoxelFootprint which,
                           float4 *position, VoxelVarying *out, flt *point_size)
{
    EyeVoxel eye = voxel_before_eye(c, voxel_place(in->place));
    float3 normal =
        voxel_normal(c, sub(vec3(in->attributes.y, in->attributes.z, in->attributes.w), 128));
    float3 towards = mul(normal, sel(normal.z > 0.0f, bcast(-1), bcast(1)));
    float4 densities = vec4(in->attributes.x * (1.0f / 256), towards.x, towards.y, 1);
    *position = voxel_clip(c, &eye, bcast(1));
    VoxelSplat splat = voxel_splat(c, &eye, which);
    *point_size = splat.side + VOXEL_ROOM;
    out->conic = splat.conic;
    out->place = voxel_pixel(c, &eye);
    out->color = mul(densities, splat.height);
}

pixel_shader(after_ps, VoxelUniforms, VoxelVarying)
{
    return mul(in->color, voxel_weight(c, in->conic, in->place, vpos()));
}

/* clang-format off */
#define AFTER_DECLARATIONS                                                                         \
    MODEL_3_0, .inputs = { VOXEL_INPUTS }, .varyings = { VOXEL_VARYINGS }, .uses_pixel = true,     \
    .writes_point_size = true
/* clang-format on */

vertex_shader(after_ewa_vs, VoxelUniforms, VoxelVertex, VoxelVarying)
{
    after_point(c, in, FOOTPRINT_EWA, position, out, point_size);
}

program(voxel_after_ewa_program, after_ewa_vs, after_ps, AFTER_DECLARATIONS)

vertex_shader(after_reconstruction_vs, VoxelUniforms, VoxelVertex, VoxelVarying)
{
    after_point(c, in, FOOTPRINT_RECONSTRUCTION, position, out, point_size);
}

program(voxel_after_reconstruction_program, after_reconstruction_vs, after_ps, AFTER_DECLARATIONS)

vertex_shader(after_low_pass_vs, VoxelUniforms, VoxelVertex, VoxelVarying)
{
    after_point(c, in, FOOTPRINT_LOW_PASS, position, out, point_size);
}

program(voxel_after_low_pass_program, after_low_pass_vs, after_ps, AFTER_DECLARATIONS)

/* --- between two sheets ----------------------------------------------------------------------- */

clip_vertex_shader(sheets_after_vs, AfterUniforms);

/* Of both sheets together; its length is known. */
GP_INLINE flt after_light(const AfterUniforms *c, float4 both, flt per_weight)
{
    flt x = both.y * per_weight, y = both.z * per_weight;
    flt z = sqrt_(max(1.0f - (x * x + y * y), 0));
    flt facing = abs_(x * c->light[0] + y * c->light[1] - z * c->light[2]);
    return mad(facing, c->diffuse, c->ambient);
}

pixel_shader(sheets_after_ps, AfterUniforms, NoVarying)
{
    float4 front = gp_load_local(0), back = gp_load_local(1);
    float2 slope = mul(sub(vpos(), vec2(c->centre[0], c->centre[1])), c->per_focal);
    flt along = mad(slope.x, c->axis[0], mad(slope.y, c->axis[1], c->axis[2]));
    flt length = sqrt_(mad(slope.x, slope.x, mad(slope.y, slope.y, 1))) *
                 rcp(max(abs_(along), 0.05f)) * c->between;

    /* where a slice ends, or was left out, less than half of the weights are there: those of a
     * slice of ones are the way through it */
    flt least = min(front.w, back.w);
    float2 density = vec2(front.x * rcp(max(front.w, 1e-4f)), back.x * rcp(max(back.w, 1e-4f)));
    float4 seen = texldl(2, vec4(density.x + 0.5f / 256, density.y + 0.5f / 256, 0, 0));
    float4 both = add(front, back);
    flt light = after_light(c, both, rcp(max(both.w, 1e-4f)));
    float4 sheet = mul(rgba(mul(xyz(seen), light), seen.w), length);
    flt inside = sel(least >= length * 0.5f, bcast(1), bcast(0));
    return mul(sheet_of_light(sheet), inside);
}

program(sheets_after_program, sheets_after_vs, sheets_after_ps, MODEL_3_0,
        .inputs = { { GP_POSITION, 3 } }, .local_reads = 3, .samplers = 1 << 2, .uses_pixel = true)
