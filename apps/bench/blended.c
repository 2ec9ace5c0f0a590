/* Benchmark cases of what is blended: sprites, sheets of them, peeled layers. */
#include "apps/bench/data.h"

#include "shaders_c/bench/peeling.h"
#include "shaders_c/bench/soft_sprite.h"
#include "shaders_c/common/texel_copy.h"

#include <math.h>

/* Front to back: what is there hides what comes. Colours are multiplied by alpha. */
static const GpBlend under_blend = { .op = GP_BLEND_ADD, .src = GP_INV_DEST_ALPHA, .dst = GP_ONE };

/* --- points ----------------------------------------------------------------------------------- */

/* A spiral on the unit sphere, from top to bottom in equal steps, turning by the golden angle. */
static const float *sphere_positions(Frame *frame)
{
    const double golden = 180 * (3 - sqrt(5.0));
    float *positions = frame_alloc(frame, POINT_COUNT, 3 * sizeof *positions), *p = positions;
    for (int i = 0; positions && i < POINT_COUNT; i++, p += 3) {
        double y = 1 - 2 * (i + 0.5) / POINT_COUNT, radius = sqrt(1 - y * y), sine, cosine;
        angle_sincos(fmod(golden * i, 360), &sine, &cosine);
        p[0] = (float)(radius * cosine);
        p[1] = (float)y;
        p[2] = (float)(radius * sine);
    }
    return positions;
}

GpResult bench_build_points(const BenchCase *bench, Frame *frame, GpError *error)
{
    (void)bench;
    static const Camera camera = {
        .eye = { 0, 0, 3.1 }, .up = { 0, 1, 0 }, .fovy = 40, .near = 0.5, .far = 10
    };
    SoftSpriteUniforms uniforms = { .light = BENCH_LIGHT,
                                    .color = { 1, 0.8f, 0.6f },
                                    .ambient = 0.2f,
                                    .size = 6,
                                    .opacity = 1.0f / 16 };
    camera_matrix(&camera, 1, uniforms.mvp);
    GpGeometry points = bench_points(sphere_positions(frame), POINT_COUNT);

    frame->color = frame_surface(frame, GP_A32B32G32R32F, BENCH_SIZE, BENCH_SIZE, 1);
    frame_pass(frame, "points", frame->color, NULL, bench_black);
    GpDraw *draw = frame_draw_copied(frame, &soft_sprite_program, &uniforms, &points);
    draw->state.blend[0] = bench_blend_add;
    return frame_result(frame, error);
}

/* --- sheets ----------------------------------------------------------------------------------- */

/* The points of all sheets, front sheet first. A sheet is a shaken grid of 64 by 64, widest in the
 * centre; z is the value, waves that move from sheet to sheet. */
static const float *sheet_positions(Frame *frame)
{
    float *positions = frame_alloc(frame, SHEET_COUNT * SHEET_POINTS, 3 * sizeof *positions);
    const double pi = 3.14159265358979323846;
    for (int i = 0; positions && i < SHEET_COUNT * SHEET_POINTS; i++) {
        int sheet = i / SHEET_POINTS, cell = i % SHEET_POINTS;
        double half = 0.25 + 0.5 * bench_sine(pi * (sheet + 0.5) / SHEET_COUNT);
        uint32_t random = bench_hash((uint32_t)i);
        float *p = positions + 3 * (size_t)i;
        p[0] = (float)(half * ((cell % 64 + (random & 255) / 256.0) / 32 - 1));
        p[1] = (float)(half * ((cell / 64 + (random >> 8 & 255) / 256.0) / 32 - 1));
        double waves = bench_sine(5 * (double)p[0] + 0.05 * sheet) + bench_sine(7 * (double)p[1]);
        p[2] = (float)(0.5 + 0.25 * waves);
    }
    return positions;
}

/* Each sheet is drawn for itself and put under those before it. Pixels read the sheet at their own
 * place, so all passes are one group. */
GpResult bench_build_sheets(const BenchCase *bench, Frame *frame, GpError *error)
{
    (void)bench;
    static const SheetSpriteUniforms sprite = { .size = 5, .opacity = 0.02f };
    const float *positions = sheet_positions(frame);
    GpGeometry quad = bench_quads(frame, 1, GP_TEXCOORD0, bench_corner_plain);
    GpSurface *sheet =
        frame_surface(frame, GP_A16B16G16R16F, BENCH_SMALL_SIZE, BENCH_SMALL_SIZE, 1);
    frame->color = frame_surface(frame, GP_A16B16G16R16F, BENCH_SMALL_SIZE, BENCH_SMALL_SIZE, 1);
    for (int i = 0; positions && i < SHEET_COUNT; i++) {
        GpGeometry points = bench_points(positions + (size_t)i * SHEET_POINTS * 3, SHEET_POINTS);
        frame_pass(frame, "sheet", sheet, NULL, bench_black);
        frame_draw(frame, &sheet_sprite_program, &sprite, &points)->state.blend[0] =
            bench_blend_add;

        GpPass *pass = frame_pass(frame, "under", frame->color, NULL, bench_black);
        pass->color[0].clear = i == 0;
        GpDraw *draw = frame_draw(frame, &texel_copy_program, NULL, &quad);
        draw->state.blend[0] = under_blend;
        draw->textures[0].surface = sheet;
    }
    return frame_result(frame, error);
}

/* --- depth peeling ---------------------------------------------------------------------------- */

/* Teapot i of 8, each within the one before it and turned against it. */
static PeelUniforms peel_model(int i)
{
    static const Camera camera = {
        .eye = { 0, 0.9, 2.9 }, .up = { 0, 1, 0 }, .fovy = 40, .near = 0.5, .far = 10
    };
    PeelUniforms uniforms = {
        .light = BENCH_LIGHT,
        .color = { i & 1 ? 0.9f : 0.3f, i & 2 ? 0.8f : 0.4f, i & 4 ? 0.9f : 0.2f, 0.35f },
    };
    double world[4][4], scale = 1 - 0.1 * i;
    matrix_rotation((double[3]){ 0, 1, 0 }, 20.0 * i, world);
    for (int k = 0; k < 9; k++)
        world[k / 3][k % 3] *= scale;
    bench_matrix(&camera, world, uniforms.mvp);
    matrix_round(world, uniforms.model);
    return uniforms;
}

/* Layers alternate between two pairs of surfaces, so that each can read the depths of the one
 * before; after each, it is put under the layers so far. */
GpResult bench_build_peel(const BenchCase *bench, Frame *frame, GpError *error)
{
    (void)bench;
    static const LayerUniforms background = { { 0.10f, 0.12f, 0.15f } };
    GpGeometry teapot;
    GpResult result =
        bench_model(frame, "meshes/teapot.ply", TEAPOT_VERTICES, TEAPOT_TRIANGLES, &teapot, error);
    if (result)
        return result;
    GpGeometry quad = bench_quads(frame, 1, GP_TEXCOORD0, bench_corner_plain);
    const void *models[PEEL_MODELS];
    for (int i = 0; i < PEEL_MODELS; i++) {
        const PeelUniforms model = peel_model(i);
        models[i] = frame_copy(frame, &model, sizeof model);
    }

    GpSurface *color[2], *depth[2];
    for (int i = 0; i < 2; i++) {
        color[i] = frame_surface(frame, GP_A8R8G8B8, BENCH_SIZE, BENCH_SIZE, 1);
        depth[i] = frame_surface(frame, GP_D32F, BENCH_SIZE, BENCH_SIZE, 1);
    }
    GpSurface *layers = frame_surface(frame, GP_A16B16G16R16F, BENCH_SIZE, BENCH_SIZE, 1);
    for (int layer = 0; layer < PEEL_LAYERS; layer++) {
        int now = layer % 2;
        frame_pass(frame, "peel", color[now], depth[now], bench_black);
        for (int i = 0; i < PEEL_MODELS; i++) {
            const GpProgram *program = layer ? &peel_next_program : &peel_first_program;
            GpDraw *draw = frame_draw(frame, program, models[i], &teapot);
            draw->state.depth = bench_depth_less;
            draw->textures[0].surface = layer ? depth[!now] : NULL;
        }
        GpPass *pass = frame_pass(frame, "under", layers, NULL, bench_black);
        pass->color[0].clear = layer == 0;
        GpDraw *draw = frame_draw(frame, &layer_premultiply_program, &background, &quad);
        draw->state.blend[0] = under_blend;
        draw->textures[0].surface = color[now];
    }
    frame->color = frame_surface(frame, GP_A8R8G8B8, BENCH_SIZE, BENCH_SIZE, 1);
    frame_pass(frame, "over background", frame->color, NULL, bench_background);
    frame_draw(frame, &layer_background_program, &background, &quad)->textures[0].surface = layers;
    return frame_result(frame, error);
}
