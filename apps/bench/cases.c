/* The table of benchmark cases, and their pictures. */
#include "apps/bench/cases.h"

#include <string.h>

/* clang-format off */
const BenchCase bench_cases[] = {
    /* name, builder, variant, screens, primitives, flop, picture, tell */
    { "clear", bench_build_fill, FILL_CLEAR, 1, 0, 0, NULL, NULL },
    { "fill", bench_build_fill, FILL_OPAQUE, FILL_QUADS, 2 * FILL_QUADS, 0, NULL, NULL },
    { "fill_nozs", bench_build_fill, FILL_NO_DEPTH, FILL_QUADS, 2 * FILL_QUADS, 0, NULL, NULL },
    { "fill_blend", bench_build_fill, FILL_BLEND, FILL_QUADS, 2 * FILL_QUADS, 0, NULL, NULL },
    { "fill_blend16f", bench_build_fill, FILL_ADD_16F, FILL_QUADS, 2 * FILL_QUADS, 0, NULL, NULL },
    { "fill_blend32f", bench_build_fill, FILL_ADD_32F, FILL_QUADS, 2 * FILL_QUADS, 0, NULL, NULL },
    { "fill_tex_bi", bench_build_texture, TEXTURE_BILINEAR, TEXTURE_QUADS, 2 * TEXTURE_QUADS, 0,
      NULL, NULL },
    { "fill_tex_tri", bench_build_texture, TEXTURE_TRILINEAR, TEXTURE_QUADS, 2 * TEXTURE_QUADS, 0,
      NULL, NULL },
    { "bunny_depth", bench_build_depth, MODEL_BUNNY, 0, BUNNY_TRIANGLES, 0, NULL, NULL },
    { "bunny_phong", bench_build_lit, MODEL_BUNNY, 0, BUNNY_TRIANGLES, 0, NULL, NULL },
    { "bunny_phong_cull", bench_build_lit, MODEL_BUNNY_CULLED, 0, BUNNY_TRIANGLES, 0, NULL, NULL },
    { "grid_big", bench_build_lit, MODEL_TORUS, 0, 1e6, 0, NULL, NULL },
    { "grid_depth", bench_build_depth, MODEL_TORUS, 0, 1e6, 0, NULL, NULL },
    { "mrt4", bench_build_maps, 0, 0, BUNNY_TRIANGLES, 0, NULL, NULL },
    { "shadow_hw", bench_build_shadow, MAP_COMPARE, 0, 2 * (BUNNY_TRIANGLES + 2), 0, NULL, NULL },
    { "shadow_near", bench_build_shadow, MAP_NEAREST, 0, 2 * (BUNNY_TRIANGLES + 2), 0, NULL, NULL },
    { "shadow_pcf4", bench_build_shadow, MAP_PCF, 0, 2 * (BUNNY_TRIANGLES + 2), 0, NULL, NULL },
    { "points", bench_build_points, 0, 0, POINT_COUNT, 0, NULL, NULL },
    { "peel", bench_build_peel, 0, 0, (double)PEEL_LAYERS * PEEL_MODELS * TEAPOT_TRIANGLES, 0,
      NULL, NULL },
    { "alu_mad", bench_build_arithmetic, ARITHMETIC_LOOP, 1, 2, 64 * 32, NULL, NULL },
    { "alu_flat", bench_build_arithmetic, ARITHMETIC_FLAT, 1, 2, 64 * 32, NULL, NULL },
    { "mandel", bench_build_arithmetic, ARITHMETIC_MANDELBROT, 1, 2, 0, NULL, NULL },
    { "dep_tex", bench_build_lookup, LOOKUP_DEPENDENT, LOOKUP_QUADS, 2 * LOOKUP_QUADS, 0, NULL, NULL },
    { "discard_tex", bench_build_lookup, LOOKUP_DISCARD, LOOKUP_QUADS, 2 * LOOKUP_QUADS, 0, NULL, NULL },
    { "sheets", bench_build_sheets, 0, 0, (double)SHEET_COUNT * SHEET_POINTS, 0, NULL, NULL },
    { "small_draws", bench_build_small, 0, 0, 50 * SMALL_DRAWS, 0, NULL, NULL },
    { "vox_add", bench_build_slabs, 0, 0, 2e6, 0, bench_show_slabs, NULL },
    { "voxel_conservative", bench_build_voxelize, VOXELIZE_CONSERVATIVE, 0, 73054, 0, NULL, NULL },
    { "voxel_thin", bench_build_voxelize, VOXELIZE_THIN, 0, 73008, 0, NULL, NULL },
    { "voxel_solid", bench_build_voxelize, VOXELIZE_SOLID, 0, 98100, 0, NULL, NULL },
    { "voxel_twisted", bench_build_voxelize, VOXELIZE_TWISTED, 0, 2 * BUNNY_TRIANGLES, 0, NULL, NULL },
    { "voxel_million", bench_build_voxelize, VOXELIZE_MILLION, 0, 1098119, 0, NULL, NULL },
    { "voxel_union", bench_build_combine, COMBINE_UNION, 1, 1, 0, NULL, NULL },
    { "voxel_collide", bench_build_combine, COMBINE_COLLISION, 1, 8, 0, NULL, NULL },
    { "points_ewa_35k", bench_build_splats, SPLATS_EWA_35K, 0, 0, 0, NULL, bench_tell_splats },
    { "points_ewa_139k", bench_build_splats, SPLATS_EWA_139K, 0, 0, 0, NULL, bench_tell_splats },
    { "points_ewa_556k", bench_build_splats, SPLATS_EWA_556K, 0, 0, 0, NULL, bench_tell_splats },
    { "points_minified", bench_build_splats, SPLATS_MINIFIED, 0, 0, 0, NULL, bench_tell_splats },
    { "points_adaptive_556k", bench_build_splats, SPLATS_ADAPTIVE, 0, 0, 0, NULL,
      bench_tell_splats },
    { "points_ternary_556k", bench_build_splats, SPLATS_TERNARY, 0, 0, 0, NULL,
      bench_tell_splats },
    { "points_sprites_556k", bench_build_splats, SPLATS_ROUND, 0, 0, 0, NULL,
      bench_tell_splats },
    { "points_qsplat_556k", bench_build_splats, SPLATS_QSPLAT, 0, 0, 0, NULL,
      bench_tell_splats },
    { "points_pixels_8m", bench_build_splats, SPLATS_PIXELS, 0, 0, 0, NULL,
      bench_tell_splats },
    { "points_lod_8m", bench_build_splats, SPLATS_LEVELS, 0, 0, 0, NULL, bench_tell_splats },
    { "points_lion", bench_build_splats, SPLATS_SCAN, 0, 0, 0, NULL, bench_tell_splats },
    { "volume_bonsai", bench_build_volume, VOLUME_BONSAI, 0, 0, 0, NULL, bench_tell_volume },
    { "volume_engine", bench_build_volume, VOLUME_ENGINE, 0, 0, 0, NULL, bench_tell_volume },
    { "volume_marschner_lobb", bench_build_volume, VOLUME_MARSCHNER_LOBB, 0, 0, 0, NULL,
      bench_tell_volume },
    { "splat_bonsai_vb", bench_build_volume, VOLUME_SPLAT_BONSAI_VB, 0, 0, 0, NULL,
      bench_tell_volume },
    { "splat_engine_vb", bench_build_volume, VOLUME_SPLAT_ENGINE_VB, 0, 0, 0, NULL,
      bench_tell_volume },
    { "splat_bonsai_vt", bench_build_volume, VOLUME_SPLAT_BONSAI_VT, 0, 0, 0, NULL,
      bench_tell_volume },
    { "splat_bonsai_pt", bench_build_volume, VOLUME_SPLAT_BONSAI_PT, 0, 0, 0, NULL,
      bench_tell_volume },
    { "splat_bonsai_im", bench_build_volume, VOLUME_SPLAT_BONSAI_IM, 0, 0, 0, NULL,
      bench_tell_volume },
    { "splat_bonsai_qd", bench_build_volume, VOLUME_SPLAT_BONSAI_QD, 0, 0, 0, NULL,
      bench_tell_volume },
    { "warp_planar", bench_build_warp, WARP_CASE_PLANAR, 0, 0, 0, NULL, bench_tell_warp },
    { "warp_layers", bench_build_warp, WARP_CASE_LAYERS, 0, 0, 0, NULL, bench_tell_warp },
    { "warp_printed", bench_build_warp, WARP_CASE_PRINTED, 0, 0, 0, NULL, bench_tell_warp },
    { "warp_dmesh", bench_build_warp, WARP_CASE_DMESH, 0, 0, 0, NULL, bench_tell_warp },
    { "warp_displacement", bench_build_warp, WARP_CASE_DISPLACEMENT, 0, 0, 0, NULL,
      bench_tell_warp },
    { "warp_relief", bench_build_warp, WARP_CASE_RELIEF, 0, 0, 0, NULL, bench_tell_warp },
    { "warp_relief_texture", bench_build_warp, WARP_CASE_RELIEF_TEXTURE, 0, 0, 0, NULL,
      bench_tell_warp },
    { "warp_polygons", bench_build_warp, WARP_CASE_POLYGONS, 0, 0, 0, NULL, bench_tell_warp },
    { "warp_cylinder", bench_build_warp, WARP_CASE_CYLINDER, 0, 0, 0, NULL, bench_tell_warp },
    { "warp_cylinder_printed", bench_build_warp, WARP_CASE_CYLINDER_PRINTED, 0, 0, 0, NULL,
      bench_tell_warp },
    { "warp_walk", bench_build_walk, 0, 0, 0, 0, NULL, bench_tell_walk },
    { "fragments_sorted_bunny", bench_build_fragments, FRAGMENTS_CASE_SORTED_BUNNY, 0, 0, 0, NULL,
      bench_tell_fragments },
    { "fragments_sorted_dragon", bench_build_fragments, FRAGMENTS_CASE_SORTED_DRAGON, 0, 0, 0, NULL,
      bench_tell_fragments },
    { "fragments_sorted_blade", bench_build_fragments, FRAGMENTS_CASE_SORTED_BLADE, 0, 0, 0, NULL,
      bench_tell_fragments },
    { "fragments_convex_bunny", bench_build_fragments, FRAGMENTS_CASE_CONVEX_BUNNY, 0, 0, 0, NULL,
      bench_tell_fragments },
    { "fragments_peel_bunny", bench_build_fragments, FRAGMENTS_CASE_PEEL_BUNNY, 0, 0, 0, NULL,
      bench_tell_fragments },
    { "fragments_dual_bunny", bench_build_fragments, FRAGMENTS_CASE_DUAL_BUNNY, 0, 0, 0, NULL,
      bench_tell_fragments },
    { "fragments_abuffer_bunny", bench_build_fragments, FRAGMENTS_CASE_ABUFFER_BUNNY, 0, 0, 0, NULL,
      bench_tell_fragments },
    { "fragments_spheres_96", bench_build_fragments, FRAGMENTS_CASE_SPHERES_96, 0, 0, 0, NULL,
      bench_tell_fragments },
};
/* clang-format on */
const size_t bench_case_count = GP_COUNT(bench_cases);

const BenchCase *bench_case_find(const char *name)
{
    for (size_t i = 0; i < bench_case_count; i++)
        if (strcmp(bench_cases[i].name, name) == 0)
            return &bench_cases[i];
    return NULL;
}

void bench_picture_size(const Frame *frame, uint32_t *width, uint32_t *height)
{
    const GpSurface *picture = frame_picture(frame);
    *width = picture->width;
    *height = picture->height;
}

static float depth_at(const GpSurface *depth, uint32_t x, uint32_t y)
{
    float texel[4];
    size_t bytes = gp_format_info(depth->format)->bytes;
    gp_texel_load(depth->format, gp_surface_texel(&depth->level[0], bytes, x, y), texel);
    return texel[0];
}

void bench_show(const Frame *frame, uint8_t *rgba)
{
    uint32_t width, height;
    bench_picture_size(frame, &width, &height);
    for (uint32_t i = 0; i < width * height; i++) {
        uint32_t x = i % width, y = i / width;
        float depth = frame->depth ? depth_at(frame->depth, x, y) : 0.0f;
        float grey = depth < 1.0f ? (1.0f - depth) * 6.0f : 0.0f;
        float color[4] = { grey, grey, grey, 1.0f };
        if (frame->color) {
            size_t bytes = gp_format_info(frame->color->format)->bytes;
            gp_texel_load(frame->color->format,
                          gp_surface_texel(&frame->color->level[0], bytes, x, y), color);
        }
        for (int c = 0; c < 3; c++)
            rgba[4 * (size_t)i + (size_t)c] = (uint8_t)gp_unorm_from_float(color[c], 8);
        rgba[4 * (size_t)i + 3] = depth < 1.0f ? 255 : 0;
    }
}

uint32_t bench_picture_hash(const uint8_t *rgba, uint32_t width, uint32_t height)
{
    uint32_t hash = 2166136261u;
    for (uint32_t y = height; y-- > 0;)
        for (uint32_t i = 0; i < width * 4; i++)
            hash = (hash ^ rgba[(size_t)y * width * 4 + i]) * 16777619u;
    return hash;
}
