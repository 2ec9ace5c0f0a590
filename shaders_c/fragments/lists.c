#include "shaders_c/fragments/lists.h"

#include "shaders_c/fragments/fragment_shared.h"

/* --- entries ---------------------------------------------------------------------------------- */

#define STEPS 4095.0f
#define SHIFT 4096.0f

GP_INLINE flt to_steps(flt value, float steps)
{
    return floor_(mad(sat(value), bcast(steps), bcast(0.5f)));
}

GP_INLINE float4 make_entry(flt depth, float4 source, float place)
{
    flt red = to_steps(source.x, STEPS), green = to_steps(source.y, STEPS);
    flt blue = to_steps(source.z, STEPS);
    return vec4(depth, mad(green, bcast(SHIFT), red), blue + place * SHIFT, source.w);
}

GP_INLINE float4 unpack_entry(float4 entry)
{
    flt green = floor_(entry.y * (1 / SHIFT)), place = floor_(entry.z * (1 / SHIFT));
    float3 steps = vec3(entry.y - green * SHIFT, green, entry.z - place * SHIFT);
    return rgba(mul(steps, 1 / STEPS), entry.w);
}

fragment_vertex_shader(list_vs);

pixel_shader(list_ps, FragmentUniforms, FragmentVarying)
{
    return make_entry(in->depth, fragment_source(c, in), c->place);
}

program(list_program, list_vs, list_ps, FRAGMENT_DECLARATIONS, MODEL_3_0)

/* --- in 32 bits ------------------------------------------------------------------------------- */

/* DEVIATES: fragments of one depth stay in the order of their drawing, where the least of two
 * numbers of 32 bits is also that of the smaller colour. */
pixel_shader(list_packed_ps, FragmentUniforms, FragmentVarying)
{
    float4 color = in->color;
    float3 packed = vec3(to_steps(color.x, 31) * (1 / 31.0f), to_steps(color.y, 63) * (1 / 63.0f),
                         to_steps(color.z, 31) * (1 / 31.0f));
    flt depth = to_steps(in->depth, 65535) * (1 / 65535.0f);
    return make_entry(depth, rgba(mul(packed, color.w), 1.0f - color.w), c->place);
}

program(list_packed_program, list_vs, list_packed_ps, FRAGMENT_DECLARATIONS, MODEL_3_0)

/* --- in windows ------------------------------------------------------------------------------- */

typedef struct WindowVertex {
    float3 position;
    float4 color;
    flt window;
} WindowVertex;

typedef struct WindowVarying {
    flt depth;
    float4 color;
    flt window;
} WindowVarying;

typedef struct WindowTargets {
    float4 entry, window, before;
} WindowTargets;

vertex_shader(list_window_vs, FragmentUniforms, WindowVertex, WindowVarying)
{
    *position = m4x4(in->position, c->mvp);
    out->depth = position->z * rcp(position->w);
    out->color = in->color;
    out->window = in->window;
}

pixel_shader_targets(list_window_ps, FragmentUniforms, WindowVarying, WindowTargets)
{
    float4 source = rgba(mul(xyz(in->color), in->color.w), 1.0f - in->color.w);
    msk is_lost = gp_load_local(0).x == in->window;
    out->entry = make_entry(in->depth, source, c->place);
    out->window = sp4(in->window);
    out->before = sp4(sel(is_lost, bcast(LIST_LOST), bcast(LIST_BEFORE)));
}

/* clang-format off */
program(list_window_program, list_window_vs, list_window_ps, MODEL_3_0, .local_reads = 1 << 0,
        .inputs = { { GP_POSITION, 3 }, { GP_COLOR, 4 }, { GP_TEXCOORD0, 1 } },
        .varyings = { { "depth", 1, GP_LINEAR_SCREEN }, { "color", 4, GP_FLAT },
                      { "window", 1, GP_FLAT } })
/* clang-format on */

/* --- in order --------------------------------------------------------------------------------- */

typedef struct NearestTargets {
    float4 entry[LIST_KEPT];
} NearestTargets;

clip_vertex_shader(list_nearest_vs, NoUniforms);

/* Whether one comes before another: by depth, and those of one depth by their places. */
GP_INLINE msk is_before(float4 one, float4 other)
{
    return (msk)(one.x < other.x) | ((msk)(one.x == other.x) & (msk)(one.z < other.z));
}

GP_INLINE void insert(float4 entry, NearestTargets *nearest)
{
    for (int i = 0; i < LIST_KEPT; i++) {
        msk is_nearer = is_before(entry, nearest->entry[i]);
        float4 farther = sel(is_nearer, nearest->entry[i], entry);
        nearest->entry[i] = sel(is_nearer, entry, nearest->entry[i]);
        entry = farther;
    }
}

pixel_shader_targets(list_nearest_ps, NoUniforms, NoVarying, NearestTargets)
{
    NearestTargets nearest;
    float4 last = gp_load_local(LIST_KEPT), entry = gp_load_local(LIST_KEPT + 1);
    for (int i = 0; i < LIST_KEPT; i++)
        nearest.entry[i] = gp_load_local(i);
    for (int i = 0; i < LIST_AT_ONCE && any(entry.x < LIST_NONE); i++) {
        entry.x = sel(is_before(last, entry), entry.x, bcast(LIST_NONE));
        insert(entry, &nearest);
        if (i + 1 < LIST_AT_ONCE)
            entry = gp_load_local(LIST_KEPT + 2 + i);
    }
    *out = nearest;
}

program(list_nearest_program, list_nearest_vs, list_nearest_ps, MODEL_3_0,
        .inputs = { { GP_POSITION, 3 } }, .local_reads = 0xffff)

clip_vertex_shader(list_layers_vs, ListLayersUniforms);

pixel_shader(list_layers_ps, ListLayersUniforms, NoVarying)
{
    float4 layers = vec4(0, 0, 0, 1);
    for (int i = 0; i < LIST_KEPT; i++) {
        float4 entry = gp_load_local(i);
        msk counts = (msk)(entry.x <= 1.0f) & (msk)(bcast((float)i) < c->count);
        float4 source = sel(counts, unpack_entry(entry), vec4(0, 0, 0, 1));
        layers = rgba(mad(xyz(source), layers.w, xyz(layers)), layers.w * source.w);
    }
    return layers;
}

program(list_layers_program, list_layers_vs, list_layers_ps, MODEL_3_0,
        .inputs = { { GP_POSITION, 3 } }, .local_reads = 15)
