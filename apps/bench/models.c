/* Benchmark cases of triangle meshes. */
#include "apps/bench/data.h"

#include "shaders_c/common/depth_only.h"
#include "shaders_c/bench/placed.h"
#include "shaders_c/bench/slab_bits.h"
#include "shaders_c/bench/surface_maps.h"
#include "shaders_c/bench/two_sided.h"

#include <string.h>

static const Camera bunny_camera = {
    .eye = { 0.6, 0.5, 2.9 }, .up = { 0, 1, 0 }, .fovy = 44, .near = 0.5, .far = 10
};
static const Camera torus_camera = {
    .eye = { 0, 0, 3.6 }, .up = { 0, 1, 0 }, .fovy = 42, .near = 0.5, .far = 10
};

static GpResult load_bunny(Frame *frame, GpGeometry *geometry, GpError *error)
{
    return bench_model(frame, "meshes/bunny.ply", BUNNY_VERTICES, BUNNY_TRIANGLES, geometry, error);
}

/* A million triangles. */
static GpGeometry big_torus(Frame *frame)
{
    return bench_torus(frame, 1000, 500);
}

/* --- one mesh --------------------------------------------------------------------------------- */

static const Camera *camera_of(const BenchCase *bench)
{
    return bench->variant == MODEL_TORUS ? &torus_camera : &bunny_camera;
}

/* The mesh of a case and its place in the world. */
static GpResult choose_model(const BenchCase *bench, Frame *frame, GpGeometry *geometry,
                             double world[4][4], GpError *error)
{
    matrix_identity(world);
    if (bench->variant != MODEL_TORUS)
        return load_bunny(frame, geometry, error);
    *geometry = big_torus(frame);
    matrix_rotation((double[3]){ 1, 0, 0 }, 55, world); /* tilted for the camera */
    return GP_OK;
}

GpResult bench_build_depth(const BenchCase *bench, Frame *frame, GpError *error)
{
    GpGeometry geometry;
    DepthOnlyUniforms uniforms;
    double world[4][4];
    GpResult result = choose_model(bench, frame, &geometry, world, error);
    if (result)
        return result;
    bench_matrix(camera_of(bench), world, uniforms.mvp);
    frame->depth = frame_surface(frame, GP_D32F, BENCH_SIZE, BENCH_SIZE, 1);
    frame_pass(frame, "depth", NULL, frame->depth, NULL);
    frame_draw_copied(frame, &depth_only_program, &uniforms, &geometry)->state.depth =
        bench_depth_less;
    return frame_result(frame, error);
}

/* What all lit surfaces share. */
static TwoSidedUniforms lit_by(const Camera *camera, double world[4][4])
{
    TwoSidedUniforms uniforms = { .light = BENCH_LIGHT,
                                  .albedo = BENCH_ALBEDO,
                                  .ambient = BENCH_AMBIENT,
                                  .specular = 0.35f,
                                  .shininess = 40 };
    bench_matrix(camera, world, uniforms.mvp);
    matrix_round(world, uniforms.model);
    for (int i = 0; i < 3; i++)
        uniforms.eye[i] = (float)camera->eye[i];
    return uniforms;
}

GpResult bench_build_lit(const BenchCase *bench, Frame *frame, GpError *error)
{
    GpGeometry geometry;
    double world[4][4];
    GpResult result = choose_model(bench, frame, &geometry, world, error);
    if (result)
        return result;
    TwoSidedUniforms uniforms = lit_by(camera_of(bench), world);
    bench_pass(frame, "lit", GP_A8R8G8B8);
    GpDraw *draw = frame_draw_copied(frame, &two_sided_program, &uniforms, &geometry);
    draw->state.depth = bench_depth_less;
    if (bench->variant == MODEL_BUNNY_CULLED)
        draw->state.raster.cull = GP_CULL_CW; /* outsides turn counter-clockwise */
    return frame_result(frame, error);
}

GpResult bench_build_maps(const BenchCase *bench, Frame *frame, GpError *error)
{
    (void)bench;
    GpGeometry bunny;
    GpResult result = load_bunny(frame, &bunny, error);
    if (result)
        return result;
    SurfaceMapsUniforms uniforms = { .light = BENCH_LIGHT, .albedo = BENCH_ALBEDO };
    camera_matrix(&bunny_camera, 1, uniforms.mvp);

    GpPass *pass = bench_pass(frame, "maps", GP_A32B32G32R32F);
    for (int i = 1; i < GP_MAX_TARGETS; i++) {
        pass->color[i] = pass->color[0];
        pass->color[i].surface = frame_surface(frame, GP_A32B32G32R32F, BENCH_SIZE, BENCH_SIZE, 1);
    }
    frame_draw_copied(frame, &surface_maps_program, &uniforms, &bunny)->state.depth =
        bench_depth_less;
    return frame_result(frame, error);
}

/* --- shadows ---------------------------------------------------------------------------------- */

static const Camera shadow_camera = { .eye = { 1.2, 1.6, 4.2 },
                                      .at = { 0, -0.2, 0 },
                                      .up = { 0, 1, 0 },
                                      .fovy = 45,
                                      .near = 0.5,
                                      .far = 20 };
static const Camera light_camera = {
    .eye = { 3, 4, 2 }, .up = { 0, 1, 0 }, .height = 3.6, .near = 0.5, .far = 12
};

static const struct {
    const GpProgram *program;
    GpSampler sampler;
} shadows[] = {
    [MAP_COMPARE] = { &two_sided_compare_program,
                      { .min = GP_LINEAR,
                        .mag = GP_LINEAR,
                        .address_u = GP_CLAMP,
                        .address_v = GP_CLAMP,
                        .compare = true } },
    [MAP_NEAREST] = { &two_sided_nearest_program,
                      { .address_u = GP_CLAMP, .address_v = GP_CLAMP } },
    [MAP_PCF] = { &two_sided_pcf_program, { .address_u = GP_CLAMP, .address_v = GP_CLAMP } },
};

GpResult bench_build_shadow(const BenchCase *bench, Frame *frame, GpError *error)
{
    GpGeometry geometry[2];
    GpResult result = load_bunny(frame, &geometry[0], error);
    if (result)
        return result;
    geometry[1] = bench_plane();
    double identity[4][4];
    matrix_identity(identity);
    DepthOnlyUniforms from_light;
    camera_matrix(&light_camera, 1, from_light.mvp);
    TwoSidedUniforms lit = lit_by(&shadow_camera, identity);
    memcpy(lit.light_clip, from_light.mvp, sizeof lit.light_clip);
    lit.bias = 0.002f;
    lit.map_size = BENCH_SIZE;

    GpSurface *map = frame_surface(frame, GP_D32F, BENCH_SIZE, BENCH_SIZE, 1);
    frame_pass(frame, "map", NULL, map, NULL);
    const void *uniforms = frame_copy(frame, &from_light, sizeof from_light);
    for (int i = 0; i < 2; i++)
        frame_draw(frame, &depth_only_program, uniforms, &geometry[i])->state.depth =
            bench_depth_less;
    bench_pass(frame, "lit", GP_A8R8G8B8);
    uniforms = frame_copy(frame, &lit, sizeof lit);
    for (int i = 0; i < 2; i++) {
        GpDraw *draw = frame_draw(frame, shadows[bench->variant].program, uniforms, &geometry[i]);
        draw->state.depth = bench_depth_less;
        draw->textures[0] = (GpTexture){ map, shadows[bench->variant].sampler };
    }
    return frame_result(frame, error);
}

/* --- many small draws ------------------------------------------------------------------------- */

static const Camera small_camera = {
    .eye = { 0, 0, 3.6 }, .up = { 0, 1, 0 }, .height = 2, .near = 0.5, .far = 10
};

/* A grid of 50 by 40 at random depths. */
static void place_small(uint32_t i, float place[4])
{
    place[0] = ((float)(i % 50) + 0.5f) / 25 - 1;
    place[1] = ((float)(i / 50) + 0.5f) / 20 - 1;
    place[2] = (float)(bench_hash(i + 5000) & 255) / 255.0f - 0.5f;
    place[3] = 0.02f;
}

GpResult bench_build_small(const BenchCase *bench, Frame *frame, GpError *error)
{
    (void)bench;
    GpGeometry torus = bench_torus(frame, 5, 5);
    bench_pass(frame, "small", GP_A8R8G8B8);
    for (uint32_t i = 0; i < SMALL_DRAWS; i++) {
        PlacedUniforms uniforms = { .light = BENCH_LIGHT,
                                    .albedo = BENCH_ALBEDO,
                                    .ambient = BENCH_AMBIENT };
        camera_matrix(&small_camera, 1, uniforms.mvp);
        place_small(i, uniforms.place);
        frame_draw_copied(frame, &placed_program, &uniforms, &torus)->state.depth =
            bench_depth_less;
    }
    return frame_result(frame, error);
}

/* --- slabs of voxels -------------------------------------------------------------------------- */

static const Camera voxel_camera = {
    .eye = { 0, 0, 1.15 }, .up = { 0, 1, 0 }, .height = 2.6, .near = 0.5, .far = 1.8
};

GpResult bench_build_slabs(const BenchCase *bench, Frame *frame, GpError *error)
{
    (void)bench;
    GpGeometry torus = big_torus(frame);
    for (int half = 0; half < 2; half++) {
        SlabBitsUniforms uniforms = { .first_slab = (float)(4 * half) };
        camera_matrix(&voxel_camera, 1, uniforms.mvp);
        GpPass *pass = frame_pass(frame, half ? "slabs 4 to 7" : "slabs 0 to 3", NULL, NULL, NULL);
        GpDraw *draw = frame_draw_copied(frame, &slab_bits_program, &uniforms, &torus);
        for (int i = 0; i < GP_MAX_TARGETS; i++) {
            GpSurface *slab =
                frame_surface(frame, GP_A8R8G8B8, BENCH_SMALL_SIZE, BENCH_SMALL_SIZE, 1);
            pass->color[i] = (GpColorTarget){ .surface = slab, .clear = true };
            draw->state.blend[i] = bench_blend_add;
        }
    }
    frame->color = frame->arena.result ? NULL : frame->list.passes[0].color[0].surface;
    return frame_result(frame, error);
}

/* Red and green: bits set in the column's nearer and farther half; blue: the sum of its bytes. */
void bench_show_slabs(const Frame *frame, uint8_t *rgba)
{
    for (uint32_t i = 0; i < BENCH_SMALL_SIZE * BENCH_SMALL_SIZE; i++) {
        uint8_t *pixel = rgba + 4 * (size_t)i, code[4];
        memset(pixel, 0, 3);
        pixel[3] = 255;
        for (int slab = 0; slab < 8; slab++) {
            const GpSurface *target = frame->list.passes[slab / 4].color[slab % 4].surface;
            gp_texel_codes(target->format, target->level[0].texels + 4 * (size_t)i, code);
            for (int c = 0; c < 4; c++) {
                pixel[slab / 4] = (uint8_t)(pixel[slab / 4] + __builtin_popcount(code[c]));
                pixel[2] = (uint8_t)(pixel[2] + code[c]);
            }
        }
    }
}
