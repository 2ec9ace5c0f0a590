/* Surface voxels by columns, exactly: no triangle is lost for being small or steep, and none is
 * drawn more than once, but where it reaches from slab to slab. */
#define GP_SHADER_AT_ONCE 4
#include "shaders_c/voxel/methods/columns_shared.h"

/* --- vertices --------------------------------------------------------------------------------- */

vertex_shader(voxel_touched_vs, VoxelColumnsUniforms, Vertex, Varying)
{
    Placed triangle = place_touched(c, in, VOXEL_MARGIN, out);
    describe_triangle(&triangle, VOXEL_TOUCHED_REACH, out);
    *position = square_centre(&c->flat, &triangle);
    *point_size = triangle.side;
}

vertex_shader(voxel_sampled_vs, VoxelColumnsUniforms, Vertex, Varying)
{
    Placed triangle = place_sampled(c, in, out);
    describe_triangle(&triangle, 0, out);
    *position = square_centre(&c->flat, &triangle);
    *point_size = triangle.side;
}

/* A corner of the rectangle along the triangle's longest edge, with room for the columns on its
 * rim.
 * DEVIATES: Hasselgren, Akenine-Moller and Ohlsson, "Conservative rasterization", GPU Gems 2, 2005,
 * ch. 42, move the triangle's own corners out, to infinity where it is a sliver. What a rectangle
 * has too much, the pixel shader cuts off, as theirs does outside the triangle's box. */
GP_INLINE float4 rectangle_corner(const FlatTextureLayout *flat, const Placed *triangle, flt number)
{
    float3 a = triangle->a, b = triangle->b, d = triangle->c;
    flt ab = square_length(a, b), bc = square_length(b, d), ca = square_length(d, a);
    msk is_ab = (msk)(ab >= bc) & (msk)(ab >= ca), is_bc = bc >= ca;
    float3 begin = sel(is_ab, a, sel(is_bc, b, d)), end = sel(is_ab, b, sel(is_bc, d, a));
    float3 third = sel(is_ab, d, sel(is_bc, a, b));
    float2 run = vec2(end.x - begin.x, end.y - begin.y);
    flt length = sqrt_(max(dp2(run, run), 1));
    float2 along = mul(run, rcp(length));
    flt height = along.x * (third.y - begin.y) - along.y * (third.x - begin.x);

    const float rim = 0.75f; /* more than half the diagonal of a column */
    msk far = (msk)(number == 1.0f) | (msk)(number == 2.0f), high = number > 1.5f;
    flt t = sel(far, length + rim, -rim);
    flt u = sel(high, max(height, 0) + rim, min(height, 0) - rim);
    float2 corner = vec2(begin.x + 0.5f + along.x * t - along.y * u,
                         begin.y + 0.5f + along.y * t + along.x * u);
    float4 placed = flat_position(flat, add(triangle->first, corner));
    return sel(triangle->side > 0.0f, placed, vec4(2, 2, 0, 1)); /* 2: outside */
}

vertex_shader(voxel_touched_rectangle_vs, VoxelColumnsUniforms, CornerVertex, Varying)
{
    Placed triangle = place_touched(c, &in->triangle, VOXEL_MARGIN, out);
    describe_triangle(&triangle, VOXEL_TOUCHED_REACH, out);
    *position = rectangle_corner(&c->flat, &triangle, in->corner);
}

vertex_shader(voxel_sampled_rectangle_vs, VoxelColumnsUniforms, CornerVertex, Varying)
{
    Placed triangle =
        place_touched(c, &in->triangle, VOXEL_MARGIN, out); /* slots: 512 are not enough for more */
    describe_triangle(&triangle, 0, out);
    *position = rectangle_corner(&c->flat, &triangle, in->corner);
}

/* clang-format off */
#define TRIANGLE_INPUTS { GP_TEXCOORD0, 3 }, { GP_TEXCOORD1, 3 }, { GP_TEXCOORD2, 3 }
#define SPRITE_DECLARATIONS                                                                        \
    MODEL_3_0, .inputs = { TRIANGLE_INPUTS }, .varyings = VOXEL_COLUMNS_VARYINGS,                  \
    .writes_point_size = true, .uses_pixel = true
#define RECTANGLE_DECLARATIONS                                                                     \
    MODEL_3_0, .inputs = { TRIANGLE_INPUTS, { GP_TEXCOORD3, 1 } },                                 \
    .varyings = VOXEL_COLUMNS_VARYINGS, .uses_pixel = true
/* clang-format on */

/* --- voxels that are touched ------------------------------------------------------------------ */

pixel_shader(voxel_touched_ps, VoxelColumnsUniforms, Varying)
{
    return touched_bits(in, vpos().x - in->place.x, vpos().y - in->place.y, VOXEL_MARGIN);
}

program(voxel_touched_program, voxel_touched_vs, voxel_touched_ps, SPRITE_DECLARATIONS)
program(voxel_touched_rectangle_program, voxel_touched_rectangle_vs, voxel_touched_ps,
        RECTANGLE_DECLARATIONS)

/* --- the same in one column ------------------------------------------------------------------- */

typedef struct RunVarying {
    float2 run; /* bits first <= k < end */
} RunVarying;

vertex_shader(voxel_column_vs, VoxelColumnsUniforms, Vertex, RunVarying)
{
    Varying triangle_out;
    Placed triangle = place_touched(c, in, VOXEL_MARGIN, &triangle_out);
    out->run = touched_run(triangle_out.ends.x, triangle_out.ends.y, VOXEL_MARGIN);
    *position = flat_position(&c->flat, add(triangle.first, 0.5f));
    *point_size = min(triangle.side, 1);
}

pixel_shader(voxel_column_ps, VoxelColumnsUniforms, RunVarying)
{
    return bits_between(in->run.x, in->run.y);
}

program(voxel_touched_column_program, voxel_column_vs, voxel_column_ps, MODEL_2_0,
        .inputs = { TRIANGLE_INPUTS }, .varyings = { { "run", 2, GP_FLAT } },
        .writes_point_size = true)

/* --- voxels that lines through centres meet --------------------------------------------------- */

/* Bits first <= k < end, whole numbers; none: NOWHERE and -NOWHERE. */
typedef struct Run {
    flt first, end;
} Run;

#define NOWHERE 64.0f

GP_INLINE Run run_where(msk found, flt first, flt end)
{
    return (Run){ sel(found, first, NOWHERE), sel(found, end, -NOWHERE) };
}

/* Voxels of the slab whose centres lie in an interval. */
GP_INLINE Run centres_inside(Interval z, msk asked)
{
    flt first = max(-floor_(0.5f - z.low), 0), end = min(floor_(z.high + 0.5f), 32);
    return run_where((msk)(first < end) & asked, first, end);
}

/* From the first bit of two runs to their last. */
GP_INLINE Run hull(Run a, Run b)
{
    return (Run){ min(a.first, b.first), max(a.end, b.end) };
}

/* Whether there are voxels between two runs. */
GP_INLINE msk apart(Run a, Run b)
{
    flt later = max(a.first, b.first), sooner = min(a.end, b.end);
    return (msk)(later > sooner) & (msk)(later < NOWHERE);
}

/* Takes the second run into the first, unless they are apart. */
GP_INLINE void unite(Run *a, Run *b)
{
    msk two = apart(*a, *b);
    Run both = hull(*a, *b);
    *a = (Run){ sel(two, a->first, both.first), sel(two, a->end, both.end) };
    *b = run_where(two, b->first, b->end);
}

/* Bits of any of three runs: made to share none, so that they can be added. */
GP_INLINE float4 bits_of_three(Run a, Run b, Run c)
{
    unite(&a, &b);
    unite(&a, &c);
    unite(&b, &c);
    return add(add(bits_between(a.first, a.end), bits_between(b.first, b.end)),
               bits_between(c.first, c.end));
}

pixel_shader(voxel_sampled_ps, VoxelColumnsUniforms, Varying)
{
    flt x = vpos().x - in->place.x, y = vpos().y - in->place.y;
    const Interval ends = { in->ends.x, in->ends.y };
    flt centre = in->plane.x + in->plane.y * x + in->plane.z * y;

    /* lines along x, and along y, are in the column where the plane is half a column's rise from
     * its centre */
    Interval lines_x = within(ends, centre, abs_(in->plane.y) * 0.5f);
    Interval lines_y = within(ends, centre, abs_(in->plane.z) * 0.5f);
    lines_x = within_view(lines_x, in->single.z, in->single.w, in->pair_y, in->ends.w, y);
    lines_y = within_view(lines_y, in->single.x, in->single.y, in->pair_x, in->ends.z, x);
    flt met = floor_(max(min(centre, ends.high), ends.low));

    msk boxed = in_box(in, x, y);
    Run along_x = centres_inside(lines_x, boxed), along_y = centres_inside(lines_y, boxed);
    Run along_z = run_where(boxed & in_edges(in, x, y) & (msk)(met >= 0.0f) & (msk)(met < 32.0f),
                            met, met + 1.0f);
    Run across = hull(along_x, along_y), all = hull(across, along_z);
    float4 bits = bits_between(all.first, all.end);

    /* hardly ever: the runs leave a gap */
    msk gap = apart(along_x, along_y) | apart(across, along_z);
    if (any(gap))
        bits = sel(gap, bits_of_three(along_x, along_y, along_z), bits);
    return bits;
}

program(voxel_sampled_program, voxel_sampled_vs, voxel_sampled_ps, SPRITE_DECLARATIONS)
program(voxel_sampled_rectangle_program, voxel_sampled_rectangle_vs, voxel_sampled_ps,
        RECTANGLE_DECLARATIONS)
