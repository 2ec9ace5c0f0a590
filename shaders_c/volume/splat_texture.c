#include "shaders_c/volume/splat_texture.h"

#include "shaders_c/volume/splat_shared.h"

typedef struct SliceVertex {
    float4 place;
} SliceVertex;

GP_INLINE float3 slice_place(const VoxelTextureUniforms *c, float4 place)
{
    flt across = mad(place.z, 256, place.x), down = mad(place.w, 256, place.y);
    return mad(u3(c->across), across, mad(u3(c->down), down, u3(c->origin)));
}

/* Slices z stand in rows of `columns`. */
GP_INLINE float2 flat_place(const VoxelTextureUniforms *c, float3 place)
{
    flt row = floor_((place.z + 0.5f) * rcp(bcast(c->columns)));
    flt column = place.z - row * c->columns;
    return vec2((mad(column, c->size[0], place.x) + 0.5f) * c->texel[0],
                (mad(row, c->size[1], place.y) + 0.5f) * c->texel[1]);
}

/* What a voxel of 8 bytes has in its vertex. */
GP_INLINE float4 texture_attributes(GpInvocation *gp, float2 place)
{
    float4 texel = texldl(1, vec4(place.x, place.y, 0, 0));
    return floor_(mad(vec4(texel.w, texel.x, texel.y, texel.z), 255, 0.5f));
}

/* --- in the vertex shader --------------------------------------------------------------------- */

GP_INLINE void vt_point(GpInvocation *gp, const VoxelTextureUniforms *c, const SliceVertex *in,
                        VoxelFootprint which, float4 *position, VoxelVarying *out, flt *point_size)
{
    float3 place = slice_place(c, in->place);
    EyeVoxel eye = voxel_before_eye(&c->voxel, place);
    float4 color = voxel_color(gp, &c->voxel, texture_attributes(gp, flat_place(c, place)));
    *position = voxel_clip(&c->voxel, &eye, color.w);
    voxel_vertex(&c->voxel, &eye, color, which, out, point_size);
}

pixel_shader(vt_ps, VoxelTextureUniforms, VoxelVarying)
{
    return mul(in->color, voxel_weight(&c->voxel, in->conic, in->place, vpos()));
}

/* clang-format off */
#define VT_DECLARATIONS                                                                            \
    MODEL_3_0, .inputs = { { GP_TEXCOORD0, 4 } }, .varyings = { VOXEL_VARYINGS },                  \
    .vertex_samplers = 3, .uses_pixel = true, .writes_point_size = true
/* clang-format on */

vertex_shader(vt_ewa_vs, VoxelTextureUniforms, SliceVertex, VoxelVarying)
{
    vt_point(gp, c, in, FOOTPRINT_EWA, position, out, point_size);
}

program(voxel_vt_ewa_program, vt_ewa_vs, vt_ps, VT_DECLARATIONS)

vertex_shader(vt_reconstruction_vs, VoxelTextureUniforms, SliceVertex, VoxelVarying)
{
    vt_point(gp, c, in, FOOTPRINT_RECONSTRUCTION, position, out, point_size);
}

program(voxel_vt_reconstruction_program, vt_reconstruction_vs, vt_ps, VT_DECLARATIONS)

vertex_shader(vt_low_pass_vs, VoxelTextureUniforms, SliceVertex, VoxelVarying)
{
    vt_point(gp, c, in, FOOTPRINT_LOW_PASS, position, out, point_size);
}

program(voxel_vt_low_pass_program, vt_low_pass_vs, vt_ps, VT_DECLARATIONS)

/* --- in the pixel shader ---------------------------------------------------------------------- */

typedef struct PtVarying {
    float3 conic;
    float2 place;
    flt height;  /* of strength 1 */
    float2 flat; /* place in the texture */
} PtVarying;

GP_INLINE void pt_point(const VoxelTextureUniforms *c, const SliceVertex *in, VoxelFootprint which,
                        float4 *position, PtVarying *out, flt *point_size)
{
    float3 place = slice_place(c, in->place);
    EyeVoxel eye = voxel_before_eye(&c->voxel, place);
    VoxelSplat splat = voxel_splat(&c->voxel, &eye, which);
    *position = voxel_clip(&c->voxel, &eye, bcast(1));
    *point_size = splat.side + VOXEL_ROOM;
    out->conic = splat.conic;
    out->place = voxel_pixel(&c->voxel, &eye);
    out->height = splat.height;
    out->flat = flat_place(c, place);
}

/* Operations in the order of the vertex shader's, so that bits are the same. */
pixel_shader(pt_ps, VoxelTextureUniforms, PtVarying)
{
    float4 color = voxel_color(gp, &c->voxel, texture_attributes(gp, in->flat));
    flt height = color.w * in->height;
    return mul(rgba(mul(xyz(color), height), height),
               voxel_weight(&c->voxel, in->conic, in->place, vpos()));
}

/* clang-format off */
#define PT_DECLARATIONS                                                                            \
    MODEL_3_0, .inputs = { { GP_TEXCOORD0, 4 } },                                                  \
    .varyings = { { "conic", 3, GP_FLAT }, { "place", 2, GP_FLAT }, { "height", 1, GP_FLAT },      \
                  { "flat", 2, GP_FLAT } },                                                        \
    .samplers = 3, .uses_pixel = true, .writes_point_size = true
/* clang-format on */

vertex_shader(pt_ewa_vs, VoxelTextureUniforms, SliceVertex, PtVarying)
{
    pt_point(c, in, FOOTPRINT_EWA, position, out, point_size);
}

program(voxel_pt_ewa_program, pt_ewa_vs, pt_ps, PT_DECLARATIONS)

vertex_shader(pt_reconstruction_vs, VoxelTextureUniforms, SliceVertex, PtVarying)
{
    pt_point(c, in, FOOTPRINT_RECONSTRUCTION, position, out, point_size);
}

program(voxel_pt_reconstruction_program, pt_reconstruction_vs, pt_ps, PT_DECLARATIONS)

vertex_shader(pt_low_pass_vs, VoxelTextureUniforms, SliceVertex, PtVarying)
{
    pt_point(c, in, FOOTPRINT_LOW_PASS, position, out, point_size);
}

program(voxel_pt_low_pass_program, pt_low_pass_vs, pt_ps, PT_DECLARATIONS)
