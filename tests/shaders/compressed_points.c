/* Compressed surfels, taken apart in the vertex shader and written out. */
#include "shaders_c/points/compressed_shared.h"
#include "tests/shaders/compressed_points.h"

typedef struct Vertex {
    float2 pixel;
    float4 words;
} Vertex;

typedef struct PrintedVertex {
    float2 pixel;
    float4 place, rest;
} PrintedVertex;

typedef struct Targets {
    float4 place, normal;
} Targets;

typedef struct PrintedTargets {
    float4 place, normal, tangent;
} PrintedTargets;

vertex_shader(compressed_points_vs, CompressedPointsUniforms, Vertex, Targets)
{
    CompressedSurfel surfel = decompress(&c->frame, in->words);
    *position = vec4(in->pixel.x, in->pixel.y, 0.5f, 1);
    out->place = rgba(surfel.position, surfel.radius);
    out->normal = rgba(surfel.normal, surfel.share);
}

pixel_shader_targets(compressed_points_ps, CompressedPointsUniforms, Targets, Targets)
{
    out->place = in->place;
    out->normal = in->normal;
}

program(compressed_points, compressed_points_vs, compressed_points_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = { { GP_POSITION, 2 }, { GP_TEXCOORD0, 4 } },
        .varyings = { { "place", 4, GP_FLAT }, { "normal", 4, GP_FLAT } })

vertex_shader(compressed_points_printed_vs, CompressedPointsUniforms, PrintedVertex, PrintedTargets)
{
    PrintedSurfel printed = decompress_printed(gp, &c->frame, in->place, in->rest, 0);
    *position = vec4(in->pixel.x, in->pixel.y, 0.5f, 1);
    out->place = rgba(printed.surfel.position, printed.surfel.radius);
    out->normal = rgba(printed.surfel.normal, printed.surfel.share);
    out->tangent = rgba(printed.tangent, printed.corner);
}

pixel_shader_targets(compressed_points_printed_ps, CompressedPointsUniforms, PrintedTargets,
                     PrintedTargets)
{
    out->place = in->place;
    out->normal = in->normal;
    out->tangent = in->tangent;
}

program(compressed_points_printed, compressed_points_printed_vs, compressed_points_printed_ps,
        .vertex_profile = GP_VS_3_0, .pixel_profile = GP_PS_3_0,
        .inputs = { { GP_POSITION, 2 }, { GP_TEXCOORD0, 4 }, { GP_TEXCOORD1, 4 } },
        .varyings = { { "place", 4, GP_FLAT },
                      { "normal", 4, GP_FLAT },
                      { "tangent", 4, GP_FLAT } },
        .vertex_samplers = 1 << 0)
