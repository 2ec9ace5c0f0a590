/* The workloads of `glasspipe bench`: named frames that any renderer can draw, made of generators
 * and constants only, so that figures of different renderers compare.
 *
 * A case is built once into a list and then run again and again; each run clears what it draws to.
 * Cases that the peer programs have too (tests/peer) draw what their namesakes there draw: the same
 * triangles to the same pixels with the same arithmetic, in this project's spaces (0 <= z <= w,
 * rows from the top). The others are this project's techniques.
 */
#ifndef APPS_BENCH_CASES_H
#define APPS_BENCH_CASES_H

#include "apps/base/camera.h"
#include "apps/frame/frame.h"

#include <jansson.h>

enum {
    BENCH_SIZE = 1024,      /* pixels a side */
    BENCH_SMALL_SIZE = 512, /* of sheets and vox_add */
};

typedef struct BenchCase BenchCase;
struct BenchCase {
    const char *name;
    /* Errors: GP_ERROR_IO and the like where the case needs a file that is not there. */
    GpResult (*build)(const BenchCase *bench, Frame *frame, GpError *error);
    int variant;       /* the builder's own */
    double screens;    /* full pictures drawn in a frame, for rates; 0: no fill rate */
    double primitives; /* triangles or points in a frame, all passes */
    double flop;       /* per pixel; 0: not a case of arithmetic */
    /* Writes the picture as RGBA8, rows from the top; NULL: bench_show. */
    void (*picture)(const Frame *frame, uint8_t *rgba);
    /* Adds what else there is to say of a frame that was drawn. NULL: nothing
     * in   ms: of a frame; measures: also how far it is off, which takes long */
    void (*tell)(const Frame *frame, double ms, int threads, bool measures, json_t *object);
};

extern const BenchCase bench_cases[];
extern const size_t bench_case_count;

/* The case of a name, or NULL. */
const BenchCase *bench_case_find(const char *name);

/* Size of the picture. */
void bench_picture_size(const Frame *frame, uint32_t *width, uint32_t *height);

/* The colour target clamped to eight bits; without one, (1 - depth) * 6 as grey where something was
 * drawn. Alpha is 255, or 0 where the depth buffer stayed clear. Rows from the top. */
void bench_show(const Frame *frame, uint8_t *rgba);

/* FNV-1a, 32 bits, of a picture with its rows taken from the bottom up, as the peers do. */
uint32_t bench_picture_hash(const uint8_t *rgba, uint32_t width, uint32_t height);

/* --- builders: each may serve several cases --------------------------------------------------- */

typedef GpResult BenchBuild(const BenchCase *bench, Frame *frame, GpError *error);

BenchBuild bench_build_fragments;
BenchBuild bench_build_fill, bench_build_texture, bench_build_arithmetic, bench_build_lookup;
BenchBuild bench_build_depth, bench_build_lit, bench_build_maps, bench_build_shadow;
BenchBuild bench_build_small, bench_build_slabs;
BenchBuild bench_build_points, bench_build_sheets, bench_build_peel;
BenchBuild bench_build_voxelize, bench_build_combine;
BenchBuild bench_build_splats, bench_build_volume, bench_build_warp, bench_build_walk;

void bench_tell_splats(const Frame *frame, double ms, int threads, bool measures, json_t *object);
void bench_tell_volume(const Frame *frame, double ms, int threads, bool measures, json_t *object);
void bench_tell_walk(const Frame *frame, double ms, int threads, bool measures, json_t *object);
void bench_tell_warp(const Frame *frame, double ms, int threads, bool measures, json_t *object);
void bench_tell_fragments(const Frame *frame, double ms, int threads, bool measures,
                          json_t *object);
void bench_show_slabs(const Frame *frame, uint8_t *rgba);

/* What variants mean. */
enum { FILL_CLEAR, FILL_OPAQUE, FILL_NO_DEPTH, FILL_BLEND, FILL_ADD_16F, FILL_ADD_32F };
enum { TEXTURE_BILINEAR, TEXTURE_TRILINEAR };
enum { ARITHMETIC_LOOP, ARITHMETIC_FLAT, ARITHMETIC_MANDELBROT };
enum { LOOKUP_DEPENDENT, LOOKUP_DISCARD };
enum { MODEL_BUNNY, MODEL_BUNNY_CULLED, MODEL_TORUS };
enum { MAP_COMPARE, MAP_NEAREST, MAP_PCF };
enum { VOXELIZE_CONSERVATIVE, VOXELIZE_THIN, VOXELIZE_SOLID, VOXELIZE_TWISTED, VOXELIZE_MILLION };
enum { COMBINE_UNION, COMBINE_COLLISION };
enum {
    SPLATS_EWA_35K,
    SPLATS_EWA_139K,
    SPLATS_EWA_556K,
    SPLATS_MINIFIED,
    SPLATS_ADAPTIVE,
    SPLATS_TERNARY,
    SPLATS_ROUND,
    SPLATS_QSPLAT,
    SPLATS_PIXELS,
    SPLATS_LEVELS,
    SPLATS_SCAN,
};
enum {
    VOLUME_BONSAI,
    VOLUME_ENGINE,
    VOLUME_MARSCHNER_LOBB,
    VOLUME_SPLAT_BONSAI_VB,
    VOLUME_SPLAT_ENGINE_VB,
    VOLUME_SPLAT_BONSAI_VT,
    VOLUME_SPLAT_BONSAI_PT,
    VOLUME_SPLAT_BONSAI_IM,
    VOLUME_SPLAT_BONSAI_QD,
};
enum {
    WARP_CASE_PLANAR,
    WARP_CASE_LAYERS,
    WARP_CASE_PRINTED,
    WARP_CASE_DMESH,
    WARP_CASE_DISPLACEMENT,
    WARP_CASE_RELIEF,
    WARP_CASE_RELIEF_TEXTURE,
    WARP_CASE_POLYGONS,
    WARP_CASE_CYLINDER,
    WARP_CASE_CYLINDER_PRINTED,
};
enum {
    FRAGMENTS_CASE_SORTED_BUNNY,
    FRAGMENTS_CASE_SORTED_DRAGON,
    FRAGMENTS_CASE_SORTED_BLADE,
    FRAGMENTS_CASE_CONVEX_BUNNY,
    FRAGMENTS_CASE_PEEL_BUNNY,
    FRAGMENTS_CASE_DUAL_BUNNY,
    FRAGMENTS_CASE_ABUFFER_BUNNY,
    FRAGMENTS_CASE_SPHERES_96,
};

/* Amounts that the table of cases and the builders share. */
enum {
    FILL_QUADS = 100,
    TEXTURE_QUADS = 50,
    LOOKUP_QUADS = 20,
    POINT_COUNT = 1000000,
    PEEL_LAYERS = 8,
    PEEL_MODELS = 8,
    SHEET_COUNT = 256,
    SHEET_POINTS = 4096,
    SMALL_DRAWS = 2000,
    BUNNY_VERTICES = 35947,
    BUNNY_TRIANGLES = 69451,
    TEAPOT_VERTICES = 3644,
    TEAPOT_TRIANGLES = 6320,
};

#endif
