#include "shaders_c/fragments/convex.h"

#include "shaders_c/fragments/fragment_shared.h"

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
