/* Numbers, quads and textures of the benchmark cases: no files, the same bits everywhere. */
#include "apps/bench/data.h"

#include <math.h>

#define PI 3.14159265358979323846

uint32_t bench_hash(uint32_t x)
{
    x = (x ^ x >> 16) * 0x7feb352du;
    x = (x ^ x >> 15) * 0x846ca68bu;
    return x ^ x >> 16;
}

double bench_sine(double radians)
{
    double sine, cosine;
    angle_sincos(radians * (180.0 / PI), &sine, &cosine);
    return sine;
}

const float bench_background[4] = { 0.10f, 0.12f, 0.15f, 0.0f };
const float bench_black[4] = { 0 };
const GpDepthState bench_depth_less = { .test = GP_LESS, .write = true };
const GpBlend bench_blend_add = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };

void bench_matrix(const Camera *camera, double world[4][4], float clip[4][4])
{
    double view[4][4], projection[4][4], to_eye[4][4], product[4][4];
    camera_view(camera, view);
    camera_projection(camera, 1.0, projection);
    matrix_multiply(view, world, to_eye);
    matrix_multiply(projection, to_eye, product);
    matrix_round(product, clip);
}

GpPass *bench_pass(Frame *frame, const char *name, GpFormat format)
{
    frame->color = frame_surface(frame, format, BENCH_SIZE, BENCH_SIZE, 1);
    frame->depth = frame_surface(frame, GP_D32F, BENCH_SIZE, BENCH_SIZE, 1);
    return frame_pass(frame, name, frame->color, frame->depth, bench_background);
}

/* --- quads ------------------------------------------------------------------------------------ */

void bench_corner_color(int quad, int corner, BenchCorner *out)
{
    for (int c = 0; c < 4; c++)
        out->value[c] = (float)(bench_hash((uint32_t)(quad * 16 + corner * 4 + c)) & 255) / 255.0f;
}

void bench_corner_plain(int quad, int corner, BenchCorner *out)
{
    (void)quad;
    (void)corner;
    for (int c = 0; c < 2; c++)
        out->value[c] = out->position[c] * 0.5f + 0.5f;
}

/* A whole number of texels of a texture of 1024. */
static float random_shift(int quad, int axis)
{
    return (float)(bench_hash((uint32_t)(quad * 2 + 1000 + axis)) & 1023) / 1024.0f;
}

void bench_corner_shifted(int quad, int corner, BenchCorner *out)
{
    bench_corner_plain(quad, corner, out);
    for (int c = 0; c < 2; c++)
        out->value[c] += random_shift(quad, c);
}

void bench_corner_rotated(int quad, int corner, BenchCorner *out)
{
    (void)corner;
    double sine, cosine;
    angle_sincos(30.0, &sine, &cosine);
    float s = (float)(1.7 * sine), c = (float)(1.7 * cosine);
    float x = out->position[0], y = out->position[1];
    out->value[0] = 0.5f * (c * x - s * y) + 0.5f + random_shift(quad, 0);
    out->value[1] = 0.5f * (s * x + c * y) + 0.5f + random_shift(quad, 1);
}

GpGeometry bench_quads(Frame *frame, int count, GpSemantic semantic, BenchCornerFn *fill)
{
    static const float places[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    static const uint32_t turns[6] = { 0, 1, 2, 0, 2, 3 };
    BenchCorner *corners = frame_alloc(frame, (size_t)count * 4, sizeof *corners);
    uint32_t *indices = frame_alloc(frame, (size_t)count * 6, sizeof *indices);
    if (!corners || !indices)
        return (GpGeometry){ .vertex_count = 0 };
    for (int i = 0; i < count * 4; i++) {
        const float *place = places[i % 4];
        corners[i] = (BenchCorner){ .position = { place[0], place[1], 0.5f } };
        fill(i / 4, i % 4, &corners[i]);
    }
    for (int i = 0; i < count * 6; i++)
        indices[i] = (uint32_t)(i / 6 * 4) + turns[i % 6];

    GpGeometry geometry = { .vertex_count = (uint32_t)count * 4,
                            .indices = indices,
                            .index_count = (uint32_t)count * 6 };
    geometry.streams[GP_POSITION] = (GpStream){ corners->position, sizeof *corners, 3, GP_FLOAT32 };
    geometry.streams[semantic] =
        (GpStream){ corners->value, sizeof *corners, semantic == GP_COLOR ? 4 : 2, GP_FLOAT32 };
    return geometry;
}

/* --- textures --------------------------------------------------------------------------------- */

static void set_texel(const GpSurface *surface, uint32_t x, uint32_t y, const uint32_t rgba[4])
{
    uint8_t *texel = gp_surface_texel(&surface->level[0], 4, x, y);
    texel[0] = (uint8_t)rgba[2];
    texel[1] = (uint8_t)rgba[1];
    texel[2] = (uint8_t)rgba[0];
    texel[3] = (uint8_t)rgba[3];
}

GpSurface *bench_noise(Frame *frame, bool mips)
{
    const uint32_t size = 1024;
    GpSurface *surface = frame_surface(frame, GP_A8R8G8B8, size, size, mips ? GP_MAX_LEVELS : 1);
    if (!surface->level[0].texels)
        return surface;
    for (uint32_t y = 0; y < size; y++) {
        for (uint32_t x = 0; x < size; x++) {
            uint32_t fine = bench_hash(y * size + x);
            uint32_t coarse = bench_hash(y / 16 * size + x / 16 + 77);
            uint32_t checker = (x / 32 ^ y / 32) & 1;
            uint32_t rgba[4] = { (coarse & 255) / 2 + (fine & 127),
                                 (coarse >> 8 & 255) / 2 + (fine >> 8 & 127), x * 255 / (size - 1),
                                 checker * 160 + (fine >> 16 & 95) };
            set_texel(surface, x, y, rgba);
        }
    }
    if (mips)
        gp_surface_build_mips(surface);
    return surface;
}

GpSurface *bench_waves(Frame *frame)
{
    const uint32_t size = 64;
    GpSurface *surface = frame_surface(frame, GP_A8R8G8B8, size, size, 1);
    for (uint32_t y = 0; surface->level[0].texels && y < size; y++) {
        for (uint32_t x = 0; x < size; x++) {
            uint32_t rgba[4] = { (uint32_t)(127.5 + 127.5 * bench_sine(x * 0.2)),
                                 (uint32_t)(127.5 + 127.5 * bench_sine(y * 0.3)), x * 4, y * 4 };
            set_texel(surface, x, y, rgba);
        }
    }
    return surface;
}
