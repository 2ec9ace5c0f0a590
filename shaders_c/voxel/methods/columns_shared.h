/* What a triangle knows of the columns that it crosses. For shader files only.
 *
 * A column is the square [x, x+1] x [y, y+1] over all z. What of z meets the triangle there is
 * bounded by its own ends, by its plane, and by the lines through its edges, as seen along y and
 * along x: intervals, whose common part is exact where the edges seen along z admit the column.
 * source Schwarz and Seidel, "Fast parallel surface and solid voxelization on GPUs", ACM TOG 29(6),
 *        2010, sections 3 and 4.1: their tests of a box, solved for z
 *
 * All of that is linear in x and y, and is found once a triangle. Every bound is then moved until
 * all three corners are within it: rounding may let a voxel in, but shuts none out. */
#ifndef SHADERS_VOXEL_METHODS_COLUMNS_SHARED_H
#define SHADERS_VOXEL_METHODS_COLUMNS_SHARED_H

#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/voxel/methods/columns.h"
#include "shaders_c/voxel/methods/motion_shared.h"
#include "shaders_c/voxel/volume/flat_texture_shared.h"

typedef struct Vertex {
    float3 a, b, c;
} Vertex;

typedef struct CornerVertex {
    Vertex triangle;
    flt corner; /* 0 to 3, of the rectangle round it */
} CornerVertex;

/* In voxels, x and y from the centre of the first column, z from the slab's floor. */
typedef struct Varying {
    float4 place; /* of the first column, in texels; and how many columns, x and y */
    float4 ends;  /* lowest and highest z; mirrors of the views along y and x, see View */
    /* z in the centre of the first column; rise a column in x and y; half its rise over a column,
     * with what rounding adds */
    float4 plane;
    float4 single; /* bounds of the views: along y, then along x */
    float4 pair_x, pair_y;
    float3 edge[3]; /* seen along z: positive, or 0, where the column lets the triangle in */
} Varying;

#define VOXEL_COLUMNS_VARYINGS                                                                     \
    {                                                                                              \
        { "place", 4, GP_FLAT }, { "ends", 4, GP_FLAT }, { "plane", 4, GP_FLAT },                  \
            { "single", 4, GP_FLAT }, { "pair_x", 4, GP_FLAT }, { "pair_y", 4, GP_FLAT },          \
            { "edge_ab", 3, GP_FLAT }, { "edge_bc", 3, GP_FLAT }, { "edge_ca", 3, GP_FLAT },       \
    }

#define STEEPEST 4194304.0f /* rise of one voxel's width: steeper counts as this */

GP_INLINE flt least(flt a, flt b, flt c)
{
    return min(min(a, b), c);
}

GP_INLINE flt most(flt a, flt b, flt c)
{
    return max(max(a, b), c);
}

/* -1 or 1. */
GP_INLINE flt side_of(flt a)
{
    return sel(a < 0.0f, bcast(-1), 1);
}

/* rise / run, but not steeper than STEEPEST, and 0 where both are 0. */
GP_INLINE flt slope_of(flt rise, flt run)
{
    return rise * rcp(side_of(run) * max(abs_(run), abs_(rise) * (1.0f / STEEPEST)));
}

/* --- views along y and x: bounds of z by edges ------------------------------------------------ */

/* An edge as z = at + slope * t, where t is x (or y); opposite: how much higher the third corner
 * is. above: the triangle is. */
typedef struct Edge {
    flt at, slope, opposite;
    flt above; /* -1 or 1 */
} Edge;

/* A view: one edge bounds z from one side and two from the other. Mirrored, so that the one is
 * always below: with z' = mirror * z, single <= z' <= both of pair; each is at + slope * t. */
typedef struct View {
    float2 single;
    float4 pair;
    flt mirror;
} View;

/* in   begin, end, third: corners of the triangle, (t, z) each; turn: positive where the triangle
 *      turns from t towards z */
GP_INLINE Edge see_edge(float2 begin, float2 end, float2 third, flt turn)
{
    flt run = end.x - begin.x, slope = slope_of(end.y - begin.y, run);
    flt at = begin.y - slope * begin.x;
    return (Edge){ at, slope, third.y - (at + slope * third.x), side_of(turn) * side_of(run) };
}

GP_INLINE Edge choose(msk which, Edge a, Edge b)
{
    return (Edge){ sel(which, a.at, b.at), sel(which, a.slope, b.slope),
                   sel(which, a.opposite, b.opposite), sel(which, a.above, b.above) };
}

/* The end of the column's width that lets more in decides. */
GP_INLINE float2 upper_bound(Edge edge, flt mirror, float reach)
{
    flt slope = mirror * edge.slope;
    return vec2(mirror * edge.at + abs_(slope) * reach + max(mirror * edge.opposite, 0), slope);
}

GP_INLINE float2 lower_bound(Edge edge, flt mirror, float reach)
{
    flt slope = mirror * edge.slope;
    return vec2(mirror * edge.at - abs_(slope) * reach + min(mirror * edge.opposite, 0), slope);
}

GP_INLINE View see_triangle(float2 a, float2 b, float2 c, flt turn, float reach)
{
    Edge ab = see_edge(a, b, c, turn), bc = see_edge(b, c, a, turn), ca = see_edge(c, a, b, turn);
    msk alike_ab_bc = ab.above == bc.above, alike_ab_ca = ab.above == ca.above;
    Edge single = choose(alike_ab_bc, ca, choose(alike_ab_ca, bc, ab));
    float2 first =
        upper_bound(choose((msk)alike_ab_bc | (msk)alike_ab_ca, ab, bc), single.above, reach);
    float2 second = upper_bound(choose(alike_ab_bc, bc, ca), single.above, reach);
    return (View){ lower_bound(single, single.above, reach),
                   vec4(first.x, first.y, second.x, second.y), single.above };
}

GP_INLINE flt square_length(float3 a, float3 b)
{
    flt x = b.x - a.x, y = b.y - a.y; /* seen along z */
    return x * x + y * y;
}

/* --- the plane, and edges seen along z -------------------------------------------------------- */

GP_INLINE float3 cross_edges(float3 a, float3 b, float3 c)
{
    return crs(sub(b, a), sub(c, b));
}

GP_INLINE float4 see_plane(float3 a, float3 b, float3 c, float3 normal, float reach)
{
    flt steep = max(abs_(normal.x), abs_(normal.y)) * (1.0f / STEEPEST);
    flt rcp_z = -side_of(normal.z) * rcp(max(abs_(normal.z), steep));
    flt rise_x = normal.x * rcp_z, rise_y = normal.y * rcp_z;
    flt at = a.z - rise_x * a.x - rise_y * a.y;
    flt off_b = b.z - (at + rise_x * b.x + rise_y * b.y);
    flt off_c = c.z - (at + rise_x * c.x + rise_y * c.y);
    return vec4(at, rise_x, rise_y,
                (abs_(rise_x) + abs_(rise_y)) * reach + max(abs_(off_b), abs_(off_c)));
}

/* (at, x, y): how far inside the edge a column's nearest corner is, times the edge's length. */
GP_INLINE float3 see_from_above(float3 begin, float3 end, float3 third, flt turn, float reach)
{
    flt x = turn * (begin.y - end.y), y = turn * (end.x - begin.x);
    flt at = -(x * begin.x + y * begin.y);
    flt opposite = at + x * third.x + y * third.y;
    return vec3(at + (abs_(x) + abs_(y)) * reach - min(opposite, 0), x, y);
}

/* --- vertices --------------------------------------------------------------------------------- */

/* Columns, or rows, of the volume: whole numbers. */
typedef struct Range {
    flt first, count; /* none: count is 0 or less */
} Range;

/* Those that an interval touches, where they are wider by a margin to each side. */
GP_INLINE Range range_touched(flt low, flt high, float last, float margin)
{
    flt first = max(floor_(low - margin), 0);
    return (Range){ first, min(floor_(high + margin), last) - first + 1.0f };
}

/* Those whose centres it holds. */
GP_INLINE Range range_sampled(flt low, flt high, float last)
{
    flt first = max(-floor_((0.5f + VOXEL_MARGIN) - low), 0);
    return (Range){ first, min(floor_(high + (VOXEL_MARGIN - 0.5f)), last) - first + 1.0f };
}

GP_INLINE Range sel_range(msk which, Range a, Range b)
{
    return (Range){ sel(which, a.first, b.first), sel(which, a.count, b.count) };
}

/* A triangle in the volume, in voxels. */
typedef struct Triangle {
    float3 a, b, c, low, high;
} Triangle;

GP_INLINE Triangle triangle_in_voxels(const VoxelColumnsUniforms *c, const Vertex *in)
{
    Triangle t = { .a = into_voxels(&c->motion, in->a),
                   .b = into_voxels(&c->motion, in->b),
                   .c = into_voxels(&c->motion, in->c) };
    t.low =
        vec3(least(t.a.x, t.b.x, t.c.x), least(t.a.y, t.b.y, t.c.y), least(t.a.z, t.b.z, t.c.z));
    t.high = vec3(most(t.a.x, t.b.x, t.c.x), most(t.a.y, t.b.y, t.c.y), most(t.a.z, t.b.z, t.c.z));
    return t;
}

/* The triangle in the slab that it is drawn into. */
typedef struct Placed {
    float3 a, b, c; /* corners, as in Varying */
    float2 first;   /* column, in texels of the flat texture */
    flt side;       /* columns, where a square is to hold them; 0: none in this slab */
} Placed;

GP_INLINE Placed place_triangle(const VoxelColumnsUniforms *c, const Triangle *t, Range columns,
                                Range rows, float margin, Varying *out)
{
    flt highest = min(t->high.z, c->flat.size - 0.5f);
    flt slab = floor_(max(t->low.z - margin, 0) * (1.0f / 32)) + c->step;
    flt floor = slab * 32.0f;

    float2 origin = patch_origin(&c->flat, slab);
    float2 first = vec2(origin.x + columns.first, origin.y + rows.first);
    float3 centre = vec3(columns.first + 0.5f, rows.first + 0.5f, floor);
    msk there =
        (msk)(floor <= highest + margin) & (msk)(columns.count > 0.0f) & (msk)(rows.count > 0.0f);
    out->place = vec4(first.x, first.y, columns.count, rows.count);
    out->ends = vec4(t->low.z - floor, highest - floor, 0, 0);
    return (Placed){ .a = sub(t->a, centre),
                     .b = sub(t->b, centre),
                     .c = sub(t->c, centre),
                     .first = first,
                     .side = sel(there, max(columns.count, rows.count), 0) };
}

/* Over all columns that the triangle's box touches. */
GP_INLINE Placed place_touched(const VoxelColumnsUniforms *c, const Vertex *in, float margin,
                               Varying *out)
{
    Triangle t = triangle_in_voxels(c, in);
    const float last = c->flat.size - 1;
    return place_triangle(c, &t, range_touched(t.low.x, t.high.x, last, margin),
                          range_touched(t.low.y, t.high.y, last, margin), margin, out);
}

/* Over those in which lines through centres may meet it: a line along x has its centres in y and z,
 * and so on. */
GP_INLINE Placed place_sampled(const VoxelColumnsUniforms *c, const Vertex *in, Varying *out)
{
    Triangle t = triangle_in_voxels(c, in);
    const float last = c->flat.size - 1;
    Range x = range_sampled(t.low.x, t.high.x, last), y = range_sampled(t.low.y, t.high.y, last);
    Range z = range_sampled(t.low.z, t.high.z, last);
    msk along_x = (msk)(y.count > 0.0f) & (msk)(z.count > 0.0f);
    msk along_y = (msk)(x.count > 0.0f) & (msk)(z.count > 0.0f);
    const float margin = VOXEL_MARGIN;
    return place_triangle(
        c, &t, sel_range(along_x, range_touched(t.low.x, t.high.x, last, margin), x),
        sel_range(along_y, range_touched(t.low.y, t.high.y, last, margin), y), margin, out);
}

/* reach: half a column's width, as far as triangles are seen from its centre; or 0 */
GP_INLINE void describe_triangle(const Placed *triangle, float reach, Varying *out)
{
    float3 a = triangle->a, b = triangle->b, c = triangle->c;
    float3 normal = cross_edges(a, b, c);
    View along_y = see_triangle(vec2(a.x, a.z), vec2(b.x, b.z), vec2(c.x, c.z), -normal.y, reach);
    View along_x = see_triangle(vec2(a.y, a.z), vec2(b.y, b.z), vec2(c.y, c.z), normal.x, reach);
    flt turn = side_of(normal.z);
    out->ends.z = along_y.mirror;
    out->ends.w = along_x.mirror;
    out->plane = see_plane(a, b, c, normal, reach);
    out->single = vec4(along_y.single.x, along_y.single.y, along_x.single.x, along_x.single.y);
    out->pair_x = along_y.pair;
    out->pair_y = along_x.pair;
    out->edge[0] = see_from_above(a, b, c, turn, reach);
    out->edge[1] = see_from_above(b, c, a, turn, reach);
    out->edge[2] = see_from_above(c, a, b, turn, reach);
}

/* A square over the columns. Where they are wider than high, or higher than wide, it is too large,
 * and finds nothing in its other pixels. */
GP_INLINE float4 square_centre(const FlatTextureLayout *flat, const Placed *triangle)
{
    return flat_position(flat, add(triangle->first, triangle->side * 0.5f));
}

/* --- pixels ----------------------------------------------------------------------------------- */

typedef struct Interval {
    flt low, high;
} Interval;

/* Keeps what a view admits at t. */
GP_INLINE Interval within_view(Interval z, flt at, flt slope, float4 pair, flt mirror, flt t)
{
    flt above = at + slope * t, below = min(pair.x + pair.y * t, pair.z + pair.w * t);
    msk upright = mirror > 0.0f;
    return (Interval){ max(z.low, sel(upright, above, -below)),
                       min(z.high, sel(upright, below, -above)) };
}

GP_INLINE Interval within(Interval z, flt centre, flt half)
{
    return (Interval){ max(z.low, centre - half), min(z.high, centre + half) };
}

GP_INLINE msk in_box(const Varying *in, flt x, flt y)
{
    return (msk)(x >= 0.0f) & (msk)(x < in->place.z) & (msk)(y >= 0.0f) & (msk)(y < in->place.w);
}

/* Whether the edges, seen along z, let the triangle into a column. */
GP_INLINE msk in_edges(const Varying *in, flt x, flt y)
{
    msk inside[3];
    for (int i = 0; i < 3; i++)
        inside[i] = in->edge[i].x + in->edge[i].y * x + in->edge[i].z * y >= 0.0f;
    return inside[0] & inside[1] & inside[2];
}

/* Bits first <= k < end of what is touched between two heights. */
GP_INLINE float2 touched_run(flt low, flt high, float margin)
{
    return vec2(-floor_((1 + margin) - low), floor_(high + (1 + margin)));
}

/* The voxels of a column that a triangle touches. in x, y: the column, from the first */
GP_INLINE float4 touched_bits(const Varying *in, flt x, flt y, float margin)
{
    Interval z = { in->ends.x, in->ends.y };
    z = within(z, in->plane.x + in->plane.y * x + in->plane.z * y, in->plane.w);
    z = within_view(z, in->single.x, in->single.y, in->pair_x, in->ends.z, x);
    z = within_view(z, in->single.z, in->single.w, in->pair_y, in->ends.w, y);

    float2 run = touched_run(z.low, z.high, margin);
    return bits_between(run.x, sel(in_box(in, x, y) & in_edges(in, x, y), run.y, run.x));
}

#endif
