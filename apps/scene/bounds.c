#include "apps/scene/bounds.h"

#include <string.h>

void draw_position(const GpDraw *draw, uint32_t vertex, double position[3])
{
    const GpStream *stream = &draw->geometry.streams[GP_POSITION];
    float p[3];
    memcpy(p, (const char *)stream->data + vertex * gp_stream_stride(stream), sizeof p);
    for (int k = 0; k < 3; k++)
        position[k] = (double)p[k];
}

Bounds draw_bounds(const GpDraw *draw)
{
    const GpStream *stream = &draw->geometry.streams[GP_POSITION];
    return bounds_of(stream->data, gp_stream_stride(stream), NULL, draw->geometry.vertex_count);
}

Bounds scene_bounds(const Scene *scene)
{
    const GpPass *pass = &scene->list.passes[0];
    Bounds all = bounds_of_nothing;
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        const Bounds one = draw_bounds(&pass->draws[i]);
        bounds_join(&all, &one);
    }
    return all;
}
