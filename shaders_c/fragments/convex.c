#include "shaders_c/fragments/convex.h"

#include "shaders_c/fragments/fragment_shared.h"

fragment_vertex_shader(fragment_vs);
glass_vertex_shader(glass_vs);

typedef struct ConvexTargets {
    float4 near, far;
} ConvexTargets;

/* clang-format off */
fragment_programs(convex, ConvexTargets, MODEL_3_0, .uses_face = true)
/* clang-format on */
{
    float4 kept = rgba(xyz(source), source.w + 1.0f), none = sp4(bcast(0));
    msk is_near = vface() < 0.0f;
    return (ConvexTargets){ sel(is_near, kept, none), sel(is_near, none, kept) };
}

clip_vertex_shader(convex_join_vs, NoUniforms);

/* Light, and what is let through. */
GP_INLINE float4 side_or_nothing(float4 side)
{
    return rgba(xyz(side), sel(side.w > 0.0f, side.w - 1.0f, bcast(1)));
}

pixel_shader(convex_join_ps, NoUniforms, NoVarying)
{
    float4 near = side_or_nothing(gp_load_local(0)), far = side_or_nothing(gp_load_local(1));
    return rgba(mad(xyz(far), near.w, xyz(near)), near.w * far.w);
}

program(convex_join_program, convex_join_vs, convex_join_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 } }, .local_reads = 3)

fragment_programs(convex_knot, float4, MODEL_2_0)
{
    return source;
}

/* --- slabs ------------------------------------------------------------------------------------ */

typedef struct SlabLayer {
    float4 source, depth;
} SlabLayer;

fragment_programs(convex_slab, SlabLayer, MODEL_3_0)
{
    return (SlabLayer){ source, sp4(depth) };
}

clip_vertex_shader(convex_slab_join_vs, NoUniforms);

/* Neighbours change places; those of one depth stay in the order of their drawing. */
pixel_shader(convex_slab_join_ps, NoUniforms, NoVarying)
{
    float4 source[SLAB_LAYERS], layers = vec4(0, 0, 0, 1);
    flt depth[SLAB_LAYERS];
    for (int i = 0; i < SLAB_LAYERS; i++) {
        source[i] = gp_load_local(i);
        depth[i] = gp_load_local(SLAB_LAYERS + i).x;
    }
    for (int end = SLAB_LAYERS - 1; end > 0; end--)
        for (int i = 0; i < end; i++) {
            msk turned = depth[i] > depth[i + 1];
            float4 nearer = sel(turned, source[i + 1], source[i]);
            flt least = sel(turned, depth[i + 1], depth[i]);
            source[i + 1] = sel(turned, source[i], source[i + 1]);
            depth[i + 1] = sel(turned, depth[i], depth[i + 1]);
            source[i] = nearer;
            depth[i] = least;
        }
    for (int i = 0; i < SLAB_LAYERS; i++) {
        float4 layer = sel(depth[i] <= 1.0f, source[i], vec4(0, 0, 0, 1));
        layers = rgba(mad(xyz(layer), layers.w, xyz(layers)), layers.w * layer.w);
    }
    return layers;
}

program(convex_slab_join_program, convex_slab_join_vs, convex_slab_join_ps, MODEL_3_0,
        .inputs = { { GP_POSITION, 3 } }, .local_reads = 0xff)
