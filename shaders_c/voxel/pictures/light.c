/* Light on the voxels that slices have found: by the faces of their cubes, or smooth, by normals
 * that are the slope of the volume's density, smoothed over six voxels along each axis.
 * source normals from the volume's gradient: Levoy, "Display of surfaces from volume data", IEEE
 *        CG&A 8(3), 1988; shading by Phong, "Illumination for computer generated pictures", 1975 */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/voxel/pictures/light.h"
#include "shaders_c/voxel/volume/flat_texture_shared.h"

typedef struct Varying {
    float3 origin, way; /* of the pixel's ray */
} Varying;

vertex_shader(voxel_light_vs, VoxelLightUniforms, PointVertex, Varying)
{
    float3 aside = add(mul(u3(c->right), in->position.x), mul(u3(c->up), in->position.y));
    *position = rgba(in->position, 1);
    out->origin = add(u3(c->eye), mul(aside, 1.0f - c->perspective));
    out->way = add(u3(c->at), mul(aside, c->perspective));
}

/* --- where the ray enters --------------------------------------------------------------------- */

typedef struct Hit {
    float3 place, face; /* face: its normal */
} Hit;

/* Share of the way to the near side of a voxel along one axis. */
GP_INLINE flt near_side(flt voxel, flt origin, flt way)
{
    flt side = sel(way < 0.0f, voxel + 1.0f, voxel);
    return sel(abs_(way) > 1e-12f, (side - origin) * rcp(way), bcast(-1e30f));
}

GP_INLINE Hit enter_voxel(const Varying *in, float3 voxel)
{
    flt x = near_side(voxel.x, in->origin.x, in->way.x);
    flt y = near_side(voxel.y, in->origin.y, in->way.y);
    flt z = near_side(voxel.z, in->origin.z, in->way.z);
    flt last = max(x, max(y, z));
    msk by_x = x == last, by_y = ~by_x & (y == last), by_z = ~by_x & ~by_y;
    Hit hit = { .face = vec3(sel(by_x, neg(sgn(in->way.x)), 0), sel(by_y, neg(sgn(in->way.y)), 0),
                             sel(by_z, neg(sgn(in->way.z)), 0)) };
    hit.place = add(in->origin, mul(in->way, last));
    hit.place = min(max(hit.place, voxel), add(voxel, 1.0f));
    return hit;
}

/* --- smooth normals --------------------------------------------------------------------------- */

/* Slopes are taken so many voxels before the surface: from there its steps look lower. */
#define BEFORE 1.0f

/* (1 - d^2 / 9)^2 of the six voxels in a row around a place, and its slopes as the place moves:
 * (slope, value, value) along x, (value, slope, value) along y. 0 outside the volume. */
typedef struct Weights {
    float3 x[VOXEL_RUN], y[VOXEL_RUN];
} Weights;

/* In: numbers of the first voxels; how far the place lies past the third ones' centres. */
GP_INLINE Weights weigh_six(const FlatTextureLayout *flat, float2 first, float2 past)
{
    const float last_from_centre = (flat->size - 1) * 0.5f;
    float2 from_centre = sub(first, last_from_centre);
    Weights weights;
    for (int k = 0; k < VOXEL_RUN; k++) {
        float2 distance = sub(sp2(bcast((float)(k - 2))), past);
        float2 rest = mad(mul(distance, -1.0f / 9), distance, 1.0f);
        float2 inside = sge(sp2(bcast(last_from_centre)), abs_(add(from_centre, (float)k)));
        float2 counted = mul(rest, inside);
        float2 value = mul(counted, rest), slope = mul(mul(counted, distance), 4.0f / 9);
        weights.x[k] = vec3(slope.x, value.x, value.x);
        weights.y[k] = vec3(value.y, slope.y, value.y);
    }
    return weights;
}

/* Six bits along z, from `first` on, lie in two neighbouring bytes, which two words may share. */
typedef struct RunPlace {
    float4 words;         /* texture coordinates of the first column's two words */
    float4 lower;         /* what the lower word's bytes count */
    flt upper;            /* what the upper word's first byte counts */
    float4 scale, centre; /* from bits to the table's coordinates */
} RunPlace;

/* What the bytes of a word count as parts of a run that begins in the channel-th: the first as it
 * is, the next 256 times. Bytes are read as b / 255. */
GP_INLINE float4 count_bytes(flt channel)
{
    float4 from_first = sub(vec4(2, 1, 0, 3), channel); /* red, green, blue, alpha */
    float4 other = abs_(from_first), not_next = abs_(sub(from_first, 1.0f));
    float4 zero = sp4(bcast(0));
    return mad(sge(zero, other), 255.0f, mul(sge(zero, not_next), 65280.0f));
}

GP_INLINE RunPlace place_run(const VoxelLightUniforms *c, float3 first, flt past)
{
    flt byte = floor_(first.z * (1.0f / 8)), slab = floor_(byte * 0.25f);
    flt channel = byte - 4.0f * slab;
    msk shared = channel == 3.0f;
    flt lowest = max(slab, 0), above = min(slab + 1.0f, c->slabs - 1.0f);
    flt exists = sge(slab, bcast(0)), next = sge(bcast(c->slabs - 1.5f), slab);
    flt scale = exp_(8.0f * byte - first.z) * (1.0f / (float)VOXEL_RUN_PATTERNS);
    float2 low = patch_origin(&c->flat, lowest);
    float2 high = patch_origin(&c->flat, sel(shared, above, lowest));
    float4 texels =
        add(vec4(low.x, low.y, high.x, high.y), vec4(first.x, first.y, first.x, first.y));
    return (RunPlace){ .words = mul(add(texels, 0.5f), add(u4(c->across), u4(c->down))),
                       .lower = mul(count_bytes(channel), exists),
                       .upper = sel(shared, next * 65280.0f, 0),
                       .scale = vec4(scale, 0, 0, 0),
                       .centre = vec4(scale * 0.5f, past + 0.5f / (float)VOXEL_RUN_ROWS, 0, 0) };
}

/* Density, density, and its slope along z, of the six voxels of a column. The table repeats, so
 * that bits above the six do not matter; those below stay within a column of it. */
GP_INLINE float3 read_run(GpInvocation *gp, const RunPlace *run, float4 words)
{
    float4 low = texld(1, vec2(words.x, words.y)), high = texld(1, vec2(words.z, words.w));
    flt bits = mad(high.z, run->upper, dp4(low, run->lower));
    return xyz(texld(2, xy(mad(sp4(bits), run->scale, run->centre))));
}

GP_INLINE float3 density_slope(GpInvocation *gp, const VoxelLightUniforms *c, float3 place)
{
    float3 centre = sub(place, 0.5f), third = floor_(centre), past = sub(centre, third);
    float3 first = sub(third, 2.0f);
    RunPlace run = place_run(c, first, past.z);
    Weights weights = weigh_six(&c->flat, vec2(first.x, first.y), vec2(past.x, past.y));
    float3 slope = sp3(bcast(0));
    for (int i = 0; i < VOXEL_RUN; i++) {
        float4 words = run.words;
        float3 row = sp3(bcast(0)); /* density; its slopes along y and z */
        for (int k = 0; k < VOXEL_RUN; k++) {
            row = mad(read_run(gp, &run, words), weights.y[k], row);
            words = add(words, u4(c->down));
        }
        run.words = add(run.words, u4(c->across));
        slope = mad(row, weights.x[i], slope);
    }
    return slope;
}

/* --- light ------------------------------------------------------------------------------------ */

#define AMBIENT   0.28f
#define DIFFUSE   0.72f
#define SPECULAR  0.22f
#define SHININESS 40

GP_INLINE float4 light_voxel(const VoxelLightUniforms *c, const Varying *in, float3 normal)
{
    float3 to_eye = neg(nrm(in->way)), light = u3(c->light);
    normal = mul(normal, sel(dp3(normal, to_eye) < 0.0f, bcast(-1), bcast(1)));
    flt highlight = pow_(max(dp3(normal, nrm(add(to_eye, light))), 0), bcast(SHININESS)) * SPECULAR;
    flt diffuse = max(dp3(normal, light), 0) * DIFFUSE + AMBIENT;
    return rgba(add(mul(u3(c->color), diffuse), highlight), 1);
}

pixel_shader(voxel_light_faces_ps, VoxelLightUniforms, Varying)
{
    float4 found = gp_load_local(0);
    discard(found.w != c->kind);
    return light_voxel(c, in, enter_voxel(in, xyz(found)).face);
}

/* Where nothing has a slope, the face's normal is left. */
pixel_shader(voxel_light_smooth_ps, VoxelLightUniforms, Varying)
{
    float4 found = gp_load_local(0);
    discard(found.w != c->kind);
    Hit hit = enter_voxel(in, xyz(found));
    float3 place = sub(hit.place, mul(nrm(in->way), BEFORE));
    float3 normal = sub(mul(hit.face, 1e-3f), density_slope(gp, c, place));
    return light_voxel(c, in, nrm(normal));
}

/* clang-format off */
#define LIGHT_DECLARATIONS                                                                         \
    .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_3_0, .inputs = { { GP_POSITION, 3 } },     \
    .varyings = { { "origin", 3, GP_PERSPECTIVE }, { "way", 3, GP_PERSPECTIVE } }

program(voxel_light_faces_program, voxel_light_vs, voxel_light_faces_ps, LIGHT_DECLARATIONS,
        .local_reads = 1 << 0, .may_discard = true)
program(voxel_light_smooth_program, voxel_light_vs, voxel_light_smooth_ps, LIGHT_DECLARATIONS,
        .samplers = 1 << 1 | 1 << 2, .local_reads = 1 << 0, .may_discard = true)
/* clang-format on */
