/* Slices through a scanned volume, and through one in which voxels of a model lie.
 * source Dong, Chen, Bao, Zhang and Peng, Pacific Graphics 2004: a voxelized model inside a scanned
 *        volume; samples, normals and transfer: Levoy, "Display of surfaces from volume data", IEEE
 *        CG&A 8(3), 1988 */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/voxel/pictures/scan.h"
#include "shaders_c/voxel/pictures/view_shared.h"

/* --- slopes ----------------------------------------------------------------------------------- */

clip_vertex_shader(voxel_slopes_vs, VoxelSlopesUniforms);

/* The sample of a voxel, those at the volume's ends going on for ever. */
GP_INLINE flt sample_at(GpInvocation *gp, const FlatTextureLayout *scan, flt x, flt y, flt z)
{
    flt last = bcast(scan->size - 1);
    float3 voxel = vec3(min(max(x, 0), last), min(max(y, 0), last), min(max(z, 0), last));
    VoxelPlace place = place_of_voxel(scan, voxel);
    float4 bytes = texld(0, place.coord);
    return sel(place.bit < 2.0f, sel(place.bit < 1.0f, bytes.z, bytes.y),
               sel(place.bit < 3.0f, bytes.x, bytes.w));
}

pixel_shader(voxel_slopes_ps, VoxelSlopesUniforms, NoVarying)
{
    const FlatTextureLayout *scan = &c->scan;
    float3 at = texel_column(&c->slopes, vpos());
    float3 fall = vec3(
        sample_at(gp, scan, at.x - 1.0f, at.y, at.z) - sample_at(gp, scan, at.x + 1.0f, at.y, at.z),
        sample_at(gp, scan, at.x, at.y - 1.0f, at.z) - sample_at(gp, scan, at.x, at.y + 1.0f, at.z),
        sample_at(gp, scan, at.x, at.y, at.z - 1.0f) -
            sample_at(gp, scan, at.x, at.y, at.z + 1.0f));
    msk even = dp3(fall, fall) == 0.0f;
    float3 normal = sel(even, sp3(bcast(0)), nrm(fall));
    return rgba(mad(normal, 0.5f, 0.5f), sample_at(gp, scan, at.x, at.y, at.z));
}

program(voxel_slopes_program, voxel_slopes_vs, voxel_slopes_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_3_0, .inputs = { { GP_POSITION, 3 } }, .samplers = 1 << 0,
        .uses_pixel = true)

/* --- slices ----------------------------------------------------------------------------------- */

typedef struct Varying {
    SlabRay ray;
    flt centre; /* of the slab, by w */
    flt fading; /* log2 of the light that a way of one voxel of the model leaves */
} Varying;

vertex_shader(voxel_scan_vs, VoxelScanUniforms, SlabVertex, Varying)
{
    *position = m4x4(in->position, c->view.slices.to_clip);
    out->ray = slab_ray(&c->view.slices, in);
    out->centre = in->position.z + c->view.slices.thickness * 0.5f;
    out->fading = log_(bcast(1 - c->view.colors[0][3]));
}

/* A texel of one layer's patch, linear between four; at the patch's edge they stay inside it. */
GP_INLINE float4 layer_at(GpInvocation *gp, const FlatTextureLayout *flat, float3 place, flt layer)
{
    flt inside = bcast(flat->size - 0.5f);
    float2 origin = patch_origin(flat, min(max(layer, 0), flat->size - 1));
    flt x = min(max(place.x, 0.5f), inside), y = min(max(place.y, 0.5f), inside);
    return texld(
        1, vec2((origin.x + x) * (1.0f / flat->width), (origin.y + y) * (1.0f / flat->height)));
}

/* What a slab of the scan adds, one sample for all of it, linear between eight. */
GP_INLINE float4 scan_haze(GpInvocation *gp, const VoxelScanUniforms *c, const Varying *in)
{
    float2 centre = mul(add(in->ray.start, in->ray.end), 0.5f);
    float3 place = voxel_at(&c->view.slices, centre, in->centre);
    flt below = floor_(place.z - 0.5f);
    float4 sample = lrp(place.z - 0.5f - below, layer_at(gp, &c->slopes, place, below + 1.0f),
                        layer_at(gp, &c->slopes, place, below));
    float4 matter = texld(2, vec2(sample.w * (255.0f / 256) + 0.5f / 256, bcast(0.5f)));

    float3 past = abs_(sub(place, c->slopes.size * 0.5f));
    msk inside = max(past.x, max(past.y, past.z)) < c->slopes.size * 0.5f;
    flt lost = sel(inside, matter.w, 0);
    flt alpha = 1.0f - exp_(log_(1.0f - lost) * way_through(&c->view.slices, &in->ray));

    float3 slope = sub(xyz(sample), 0.5f), normal = mul(slope, rsq(dp3(slope, slope) + 1e-4f));
    flt facing = max(dp3(normal, u3(c->light)), 0);
    flt highlight = max(dp3(normal, nrm(add(u3(c->light), u3(c->to_eye)))), 0);
    highlight = highlight * highlight * highlight * highlight;
    highlight = highlight * highlight * highlight * highlight * 0.25f;
    float3 color = add(mul(xyz(matter), facing * 0.75f + 0.3f), highlight);
    return rgba(mul(color, alpha), alpha);
}

pixel_shader(voxel_scan_ps, VoxelScanUniforms, Varying)
{
    return scan_haze(gp, c, in);
}

/* In a slab voxels come first. */
pixel_shader(voxel_scan_mixed_ps, VoxelScanUniforms, Varying)
{
    flt way = way_in_first(gp, &c->view, &in->ray), seen = exp_(in->fading * way);
    float4 scan = mul(scan_haze(gp, c, in), seen);
    return add(scan, mul(rgba(u3(c->view.colors[0]), 1), 1.0f - seen));
}

/* clang-format off */
#define SCAN_DECLARATIONS                                                                          \
    .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_3_0, .inputs = { SLAB_INPUTS },            \
    .varyings = { SLAB_VARYINGS, { "centre", 1, GP_FLAT }, { "fading", 1, GP_FLAT } }

program(voxel_scan_program, voxel_scan_vs, voxel_scan_ps, SCAN_DECLARATIONS,
        .samplers = 1 << 1 | 1 << 2)
program(voxel_scan_mixed_program, voxel_scan_vs, voxel_scan_mixed_ps, SCAN_DECLARATIONS,
        .samplers = 1 << 0 | 1 << 1 | 1 << 2 | 1 << 3)
/* clang-format on */
