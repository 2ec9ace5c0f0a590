#include "apps/scene/bounds.h"

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
