#include "shaders_c/points/compressed_splat.h"

#include "shaders_c/points/compressed_shared.h"
#include "shaders_c/points/splat_shared.h"

typedef struct WordsVertex {
    float4 words;
} WordsVertex;

typedef struct ColoredWordsVertex {
    float4 words;
    float3 color;
} ColoredWordsVertex;

typedef struct PrintedVertex {
    float4 place, rest;
} PrintedVertex;

typedef struct ColoredPrintedVertex {
    float4 place, rest;
    float3 color;
} ColoredPrintedVertex;

GP_INLINE SurfelVertex surfel_vertex(const CompressedSurfel *surfel, float3 color)
{
    return (SurfelVertex){ surfel->position, surfel->radius, surfel->normal,
                           rgba(color, surfel->share) };
}

GP_INLINE DiscVertex disc_vertex(const SurfelVertex *surfel)
{
    return (DiscVertex){ surfel->position, surfel->radius, surfel->normal };
}

GP_INLINE float3 own_color(const CompressedUniforms *c, float3 color)
{
    return mad(color, c->by_color, u3(c->color));
}

GP_INLINE SurfelVertex unpack(const CompressedUniforms *c, float4 words, float3 color)
{
    CompressedSurfel surfel = decompress(&c->frame, words);
    return surfel_vertex(&surfel, color);
}

GP_INLINE SurfelVertex unpack_printed(GpInvocation *gp, const CompressedUniforms *c, float4 place,
                                      float4 rest, float3 color)
{
    PrintedSurfel printed = decompress_printed(gp, &c->frame, place, rest, 0);
    return surfel_vertex(&printed.surfel, color);
}

/* --- pixels ----------------------------------------------------------------------------------- */

pixel_shader(compressed_visibility_ps, CompressedUniforms, DiscVarying)
{
    discard_outside_disc(in);
    return sp4(bcast(0));
}

pixel_shader(compressed_color_ps, CompressedUniforms, SplatColorVarying)
{
    return mul(in->color, splat_weight(&c->splat, in->conic, in->place));
}

pixel_shader_targets(compressed_surface_ps, CompressedUniforms, SplatSurfaceVarying, SplatTargets)
{
    flt weight = splat_weight(&c->splat, in->conic, in->place);
    out->color = mul(in->color, weight);
    out->surface = mul(in->surface, weight);
}

/* --- ours ------------------------------------------------------------------------------------- */

#define COLORED_WORDS_INPUTS .inputs = { { GP_TEXCOORD0, 4 }, { GP_COLOR, 3 } }

vertex_shader(compressed_visibility_vs, CompressedUniforms, WordsVertex, DiscVarying)
{
    SurfelVertex surfel = unpack(c, in->words, vec3(0, 0, 0));
    DiscVertex disc = disc_vertex(&surfel);
    splat_disc_vertex(&c->splat, &disc, position, out, point_size);
}

vertex_shader(compressed_color_vs, CompressedUniforms, ColoredWordsVertex, SplatColorVarying)
{
    SurfelVertex surfel = unpack(c, in->words, own_color(c, in->color));
    splat_color_point(&c->splat, &surfel, position, out, point_size);
}

vertex_shader(compressed_surface_vs, CompressedUniforms, ColoredWordsVertex, SplatSurfaceVarying)
{
    SurfelVertex surfel = unpack(c, in->words, own_color(c, in->color));
    splat_surface_point(&c->splat, &surfel, position, out, point_size);
}

program(compressed_visibility_program, compressed_visibility_vs, compressed_visibility_ps,
        SPLAT_VISIBILITY_DECLARATIONS, .inputs = { { GP_TEXCOORD0, 4 } })
program(compressed_color_program, compressed_color_vs, compressed_color_ps,
        SPLAT_COLOR_DECLARATIONS, COLORED_WORDS_INPUTS)
program(compressed_surface_program, compressed_surface_vs, compressed_surface_ps,
        SPLAT_SURFACE_DECLARATIONS, COLORED_WORDS_INPUTS)

/* --- printed ---------------------------------------------------------------------------------- */

/* clang-format off */
#define PRINTED_INPUTS .inputs = { { GP_TEXCOORD0, 4 }, { GP_TEXCOORD1, 4 } }
#define COLORED_PRINTED_INPUTS .inputs = { { GP_TEXCOORD0, 4 }, { GP_TEXCOORD1, 4 }, { GP_COLOR, 3 } }
/* clang-format on */

vertex_shader(printed_visibility_vs, CompressedUniforms, PrintedVertex, DiscVarying)
{
    SurfelVertex surfel = unpack_printed(gp, c, in->place, in->rest, vec3(0, 0, 0));
    DiscVertex disc = disc_vertex(&surfel);
    splat_disc_vertex(&c->splat, &disc, position, out, point_size);
}

vertex_shader(printed_color_vs, CompressedUniforms, ColoredPrintedVertex, SplatColorVarying)
{
    SurfelVertex surfel = unpack_printed(gp, c, in->place, in->rest, own_color(c, in->color));
    splat_color_point(&c->splat, &surfel, position, out, point_size);
}

vertex_shader(printed_surface_vs, CompressedUniforms, ColoredPrintedVertex, SplatSurfaceVarying)
{
    SurfelVertex surfel = unpack_printed(gp, c, in->place, in->rest, own_color(c, in->color));
    splat_surface_point(&c->splat, &surfel, position, out, point_size);
}

program(printed_visibility_program, printed_visibility_vs, compressed_visibility_ps,
        SPLAT_VISIBILITY_DECLARATIONS, PRINTED_INPUTS, .vertex_samplers = 1 << 0)
program(printed_color_program, printed_color_vs, compressed_color_ps, SPLAT_COLOR_DECLARATIONS,
        COLORED_PRINTED_INPUTS, .vertex_samplers = 1 << 0)
program(printed_surface_program, printed_surface_vs, compressed_surface_ps,
        SPLAT_SURFACE_DECLARATIONS, COLORED_PRINTED_INPUTS, .vertex_samplers = 1 << 0)
