/* Benchmark cases of full-screen quads: fill rates, texture rates and arithmetic. */
#include "apps/bench/data.h"

#include "shaders_c/bench/arithmetic.h"
#include "shaders_c/common/blit.h"
#include "shaders_c/bench/lookup.h"
#include "shaders_c/bench/mandelbrot.h"
#include "shaders_c/bench/scaled_color.h"

/* --- fill ------------------------------------------------------------------------------------- */

static const GpBlend over = { .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA, .dst = GP_INV_SRC_ALPHA };

static const struct {
    GpFormat format;
    bool depth;
    float scale; /* of the quads' colours; 0: no quads */
    const GpBlend *blend;
} fills[] = {
    [FILL_CLEAR] = { GP_A8R8G8B8, true, 0, NULL },
    [FILL_OPAQUE] = { GP_A8R8G8B8, true, 1, NULL },
    [FILL_NO_DEPTH] = { GP_A8R8G8B8, false, 1, NULL },
    [FILL_BLEND] = { GP_A8R8G8B8, true, 1, &over },
    [FILL_ADD_16F] = { GP_A16B16G16R16F, true, 1.0f / 128, &bench_blend_add },
    [FILL_ADD_32F] = { GP_A32B32G32R32F, true, 1.0f / 128, &bench_blend_add },
};

GpResult bench_build_fill(const BenchCase *bench, Frame *frame, GpError *error)
{
    const int i = bench->variant;
    const ScaledColorUniforms uniforms = { .scale = fills[i].scale };
    frame->color = frame_surface(frame, fills[i].format, BENCH_SIZE, BENCH_SIZE, 1);
    frame->depth = fills[i].depth ? frame_surface(frame, GP_D32F, BENCH_SIZE, BENCH_SIZE, 1) : NULL;
    frame_pass(frame, "fill", frame->color, frame->depth,
               fills[i].format == GP_A8R8G8B8 ? bench_background : bench_black);
    if (uniforms.scale == 0)
        return frame_result(frame, error);

    GpGeometry quads = bench_quads(frame, FILL_QUADS, GP_COLOR, bench_corner_color);
    GpDraw *draw = frame_draw_copied(frame, &scaled_color_program, &uniforms, &quads);
    if (fills[i].blend)
        draw->state.blend[0] = *fills[i].blend;
    return frame_result(frame, error);
}

/* --- textures --------------------------------------------------------------------------------- */

GpResult bench_build_texture(const BenchCase *bench, Frame *frame, GpError *error)
{
    bool mips = bench->variant == TEXTURE_TRILINEAR;
    bench_pass(frame, "screen", GP_A8R8G8B8);
    GpGeometry quads = bench_quads(frame, TEXTURE_QUADS, GP_TEXCOORD0,
                                   mips ? bench_corner_rotated : bench_corner_shifted);
    GpDraw *draw = frame_draw(frame, &blit_program, NULL, &quads);
    draw->textures[0] = (GpTexture){
        .surface = bench_noise(frame, mips),
        .sampler = { .min = GP_LINEAR,
                     .mag = GP_LINEAR,
                     .mip = mips ? GP_MIP_LINEAR : GP_MIP_NONE },
    };
    return frame_result(frame, error);
}

/* From back to front, so that every quad is drawn where it is not cut out. */
static void corner_nearer(int quad, int corner, BenchCorner *out)
{
    bench_corner_shifted(quad, corner, out);
    float z = 0.9f - 1.8f * (float)quad / (LOOKUP_QUADS - 1); /* -1 to 1 */
    out->position[2] = (z + 1) * 0.5f;
}

GpResult bench_build_lookup(const BenchCase *bench, Frame *frame, GpError *error)
{
    bool dependent = bench->variant == LOOKUP_DEPENDENT;
    bench_pass(frame, "screen", GP_A8R8G8B8);
    GpGeometry quads = bench_quads(frame, LOOKUP_QUADS, GP_TEXCOORD0,
                                   dependent ? bench_corner_shifted : corner_nearer);
    GpDraw *draw = frame_draw(frame, dependent ? &lookup_program : &cut_out_program, NULL, &quads);
    draw->textures[0].surface = bench_noise(frame, false);
    if (dependent)
        draw->textures[1] = (GpTexture){ .surface = bench_waves(frame),
                                         .sampler = { .min = GP_LINEAR, .mag = GP_LINEAR } };
    else
        draw->state.depth = bench_depth_less;
    return frame_result(frame, error);
}

/* --- arithmetic ------------------------------------------------------------------------------- */

GpResult bench_build_arithmetic(const BenchCase *bench, Frame *frame, GpError *error)
{
    static const ArithmeticUniforms uniforms = {
        .factor = { 0.9990234375f, 0.998046875f, 0.99609375f, 0.9921875f },
        .addend = { 0.0009765625f, 0.0009765625f, 0.001953125f, 0.00390625f },
    };
    static const GpProgram *const programs[] = {
        [ARITHMETIC_LOOP] = &mad_loop_program,
        [ARITHMETIC_FLAT] = &mad_flat_program,
        [ARITHMETIC_MANDELBROT] = &mandelbrot_program,
    };
    bench_pass(frame, "screen", GP_A8R8G8B8);
    GpGeometry quad = bench_quads(frame, 1, GP_TEXCOORD0, bench_corner_plain);
    frame_draw(frame, programs[bench->variant], &uniforms, &quad);
    return frame_result(frame, error);
}
