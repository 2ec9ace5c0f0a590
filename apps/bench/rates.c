#include "apps/bench/rates.h"

#include "apps/base/machine.h"
#include "apps/bench/data.h"
#include "apps/bench/operations.h"
#include "apps/frame/timing.h"
#include "pipeline/base/pool.h"
#include "shaders_c/bench/issue_rate.h"
#include "shaders_c/common/depth_only.h"

#include <string.h>

/* --- drawing ---------------------------------------------------------------------------------- */

enum {
    SIDE = 512,
    TILE = 64,
    TILES_ACROSS = SIDE / TILE,
    TILES = TILES_ACROSS * TILES_ACROSS,
    TRIANGLES = TILES * 1024,
};

static const TimingPlan plan = { .seconds = 0.1, .least_frames = 20, .most_seconds = 1 };

/* The least time of a frame: what disturbs only adds to it. */
static GpResult least_ms(GpDevice *device, const Frame *frame, double *ms, GpError *error)
{
    RunStatistics statistics;
    Timing timing = { .ms = 0 };
    double *each = gp_alloc(TIMING_MAX_FRAMES, sizeof *each);
    if (!each)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    GpResult result = run_first(device, &frame->list, &statistics, error);
    if (!result)
        result = timing_run(device, &frame->list, &plan, each, &statistics, &timing, error);
    gp_free(each);
    *ms = timing.min_ms;
    return result;
}

/* Chains of multiplications and additions at every pixel. */
static GpResult measure_operations(GpDevice *device, double *rate, GpError *error)
{
    static const IssueRateUniforms uniforms = { 0.9990234375f, 0.0009765625f };
    Frame frame = { .color = NULL };
    double ms = 0;
    frame.color = frame_surface(&frame, GP_A8R8G8B8, SIDE, SIDE, 1);
    const GpPass *pass = frame_pass(&frame, "chains", frame.color, NULL, bench_black);
    const GpGeometry quad = bench_quads(&frame, 1, GP_TEXCOORD0, bench_corner_plain);
    const GpDraw *draw = frame_draw(&frame, &issue_rate_program, &uniforms, &quad);
    GpResult result = frame_result(&frame, error);
    if (!result)
        result = least_ms(device, &frame, &ms, error);
    if (!result)
        *rate = draw_operations(pass, draw).fragment * SIDE * SIDE / ms;
    frame_free(&frame);
    return result;
}

/* A triangle around the centre of pixel (32, 32) of each tile, in clip space. */
static void set_corners(float (*corner)[3])
{
    static const double reach[3][2] = { { -0.4, -0.4 }, { 0.9, -0.3 }, { -0.3, 0.9 } };
    for (int i = 0; i < 3 * TILES; i++) {
        const int tile = i / 3;
        const double x = tile % TILES_ACROSS * TILE + TILE / 2 + 0.5 + reach[i % 3][0];
        const double y = tile / TILES_ACROSS * TILE + TILE / 2 + 0.5 + reach[i % 3][1];
        corner[i][0] = (float)(2 * x / SIDE - 1);
        corner[i][1] = (float)(1 - 2 * y / SIDE);
        corner[i][2] = 0.5f;
    }
}

/* One small triangle a tile, again and again: of equal depth, so that none hides the next. */
static GpResult measure_triangles(GpDevice *device, double *rate, GpError *error)
{
    static const DepthOnlyUniforms uniforms = {
        { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, 0, 1 } }
    };
    Frame frame = { .color = NULL };
    double ms = 0;
    frame.depth = frame_surface(&frame, GP_D32F, SIDE, SIDE, 1);
    float(*corner)[3] = frame_alloc(&frame, 3 * TILES, sizeof *corner);
    uint32_t *indices = frame_alloc(&frame, 3 * TRIANGLES, sizeof *indices);
    frame_pass(&frame, "triangles", NULL, frame.depth, NULL);
    GpResult result = frame_result(&frame, error);
    if (!result) {
        set_corners(corner);
        for (uint32_t i = 0; i < 3 * TRIANGLES; i++)
            indices[i] = i % (3 * TILES);
        const GpGeometry geometry = { .vertex_count = 3 * TILES,
                                      .indices = indices,
                                      .index_count = 3 * TRIANGLES,
                                      .streams[GP_POSITION] = { corner, 0, 3, GP_FLOAT32 } };
        GpDraw *draw = frame_draw(&frame, &depth_only_program, &uniforms, &geometry);
        draw->state.depth = (GpDepthState){ .test = GP_LESS_EQUAL, .write = true };
        result = frame_result(&frame, error);
    }
    if (!result)
        result = least_ms(device, &frame, &ms, error);
    if (!result)
        *rate = TRIANGLES / ms;
    frame_free(&frame);
    return result;
}

GpResult bench_rates_measure(GpDevice *device, BenchRates *rates, GpError *error)
{
    GpResult result = measure_operations(device, &rates->operations, error);
    return result ? result : measure_triangles(device, &rates->triangles, error);
}

/* --- bytes ------------------------------------------------------------------------------------ */

enum { PIECE = 16 << 10, TRAFFIC_ROUNDS = 5 };

typedef struct Traffic {
    unsigned char *memory;
    size_t read, written; /* what is read comes first; whole pieces */
} Traffic;

/* Reads a piece into the nearest cache, or writes one out of it. */
static void move_piece(void *context, uint32_t item, int worker)
{
    unsigned char near[PIECE];
    const Traffic *traffic = context;
    unsigned char *piece = traffic->memory + (size_t)item * PIECE;
    (void)worker;
    if ((size_t)item * PIECE < traffic->read) {
        memcpy(near, piece, PIECE);
        __asm__ volatile("" : : "r"(near) : "memory"); /* as if someone looked at it */
    } else
        memset(piece, (int)item, PIECE);
}

static size_t whole_pieces(size_t bytes)
{
    return (bytes + PIECE - 1) / PIECE * PIECE;
}

GpResult bench_traffic_ms(int threads, size_t read, size_t written, double *ms, GpError *error)
{
    GpPool *pool = NULL;
    Traffic traffic = { .read = whole_pieces(read), .written = whole_pieces(written) };
    const size_t bytes = traffic.read + traffic.written;
    *ms = 0;
    if (!bytes)
        return GP_OK;
    traffic.memory = gp_alloc(bytes, 1);
    if (!traffic.memory)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    GpResult result = gp_pool_create(threads, &pool, error);
    for (int round = 0; !result && round <= TRAFFIC_ROUNDS; round++) {
        const double start = machine_clock_ms(CLOCK_MONOTONIC);
        gp_pool_run(pool, (uint32_t)(bytes / PIECE), move_piece, &traffic);
        const double took = machine_clock_ms(CLOCK_MONOTONIC) - start;
        if (round == 1 || (round > 1 && took < *ms)) /* the first touches the memory */
            *ms = took;
    }
    gp_pool_destroy(&pool);
    gp_free(traffic.memory);
    return result;
}
