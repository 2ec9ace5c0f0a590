/* What a list may take of the executor's memory, before it runs. */
#include "pipeline/fast/draws/sampler.h"
#include "pipeline/fast/executor.h"

/* Blocks of an arena double: together they are at most so many times what is taken of them. And
 * bins grow by half, from an array into another. */
enum { ARENA_FACTOR = 3, BINS_FACTOR = 4, BYTES_OF_PRIMITIVE = 32 };

/* Of a draw's vertices, and of indices where they are spelled out. */
static uint64_t draw_bytes(const GpDraw *draw)
{
    const GpGeometry *geometry = &draw->geometry;
    const GpVaryingModes modes = gp_varying_modes(draw->program);
    const int planes = __builtin_popcount(draw->state.raster.clip_planes);
    const uint64_t stride = ((uint64_t)modes.components + (uint64_t)planes + 3) & ~(uint64_t)3;
    const uint64_t vertices = (uint64_t)geometry->vertex_count + FAST_WIDEST;
    const uint64_t indices = (uint64_t)gp_geometry_primitives(geometry) *
                             gp_primitive_corners(geometry->primitive) * sizeof(uint32_t);
    const bool spelled_out = geometry->indices16 || geometry->primitive > GP_POINTS;
    return vertices * (sizeof(FastPosition) + stride * sizeof(float)) +
           (spelled_out ? indices : 0) + sizeof(FastDraw) +
           GP_MAX_SAMPLERS * sizeof(struct FastSampler);
}

/* What the passes of a list need at once, at the most. */
typedef struct Most {
    uint64_t vertices, bins; /* bytes: of a draw, or of all of a pass that sorts */
    uint64_t tiles;
    bool waits; /* fragments do */
} Most;

static void add_pass(const GpPass *pass, Most *most)
{
    const bool sorts = pass->order != GP_ORDER_SUBMITTED;
    uint32_t width, height;
    uint64_t vertices = 0, primitives = 0;
    gp_pass_size(pass, &width, &height);
    for (uint32_t d = 0; d < pass->draw_count; d++) {
        const uint64_t bytes = draw_bytes(&pass->draws[d]);
        vertices = sorts ? vertices + bytes : bytes > vertices ? bytes : vertices;
        primitives += gp_geometry_primitives(&pass->draws[d].geometry);
    }
    const uint64_t side = FAST_TILE;
    const uint64_t tiles = (width + side - 1) / side * ((height + side - 1) / side);
    const uint64_t bins = sorts ? primitives * BYTES_OF_PRIMITIVE : 0;
    most->vertices = vertices > most->vertices ? vertices : most->vertices;
    most->bins = bins > most->bins ? bins : most->bins;
    most->tiles = tiles > most->tiles ? tiles : most->tiles;
    most->waits |= sorts;
}

uint64_t gp_fast_bytes(const GpFast *fast, const GpList *list, size_t tile_bytes,
                       size_t fragment_bytes)
{
    const uint64_t threads = (uint64_t)gp_pool_threads(fast->pool);
    Most most = { .waits = list->pass_count > 1 }; /* passes may repeat earlier ones */
    for (uint32_t p = 0; p < list->pass_count; p++)
        add_pass(&list->passes[p], &most);
    const uint64_t workers = most.tiles < threads ? most.tiles : threads;
    return ARENA_FACTOR * (fast->limit + most.vertices) + BINS_FACTOR * (fast->limit + most.bins) +
           workers * (tile_bytes + (most.waits ? fragment_bytes : 0)) + (1 << 20);
}
