#include "apps/points/drawing/quads.h"

/* A corner of a quad. */
typedef struct QuadVertex {
    Surfel surfel;
    float corner[2];
} QuadVertex;

static void put_quad(const Surfel *surfel, uint32_t number, QuadVertex *vertices, uint32_t *indices)
{
    static const float corners[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    static const uint8_t order[6] = { 0, 1, 2, 0, 2, 3 };
    for (int i = 0; i < 4; i++)
        vertices[i] = (QuadVertex){ *surfel, { corners[i][0], corners[i][1] } };
    for (int i = 0; i < 6; i++)
        indices[i] = 4 * number + order[i];
}

GpGeometry splat_quads(const SplatSource *source, Frame *frame)
{
    uint32_t count = 0, done = 0;
    for (uint32_t i = 0; i < source->run_count; i++)
        count += source->runs[i].count;
    QuadVertex *vertices = frame_alloc(frame, 4 * (size_t)count + 1, sizeof *vertices);
    uint32_t *indices = frame_alloc(frame, 6 * (size_t)count + 1, sizeof *indices);
    if (!vertices || !indices)
        return (GpGeometry){ .vertex_count = 0 };
    for (uint32_t i = 0; i < source->run_count; i++)
        for (uint32_t k = 0; k < source->runs[i].count; k++, done++)
            put_quad(&source->surfels[source->runs[i].first + k], done, vertices + 4 * (size_t)done,
                     indices + 6 * (size_t)done);
    const uint32_t step = sizeof *vertices;
    return (GpGeometry){
        .primitive = GP_TRIANGLES,
        .vertex_count = 4 * count,
        .indices = indices,
        .index_count = 6 * count,
        .streams = {
            [GP_POSITION] = { vertices->surfel.position, step, 4, GP_FLOAT32 },
            [GP_NORMAL] = { vertices->surfel.normal, step, 3, GP_FLOAT32 },
            [GP_COLOR] = { vertices->surfel.color, step, 4, GP_UNORM8 },
            [GP_TEXCOORD0] = { vertices->corner, step, 2, GP_FLOAT32 },
        },
    };
}
