/* One call of a pixel shader: as many packets as a block has. */
#include "pipeline/fast/lanes/memory/tile.h"

#include "pipeline/fast/draws/sampler.h"

void fast_run_pixel_shader(Tile *tile, const FastDraw *d, const FastPacket *packets, int count)
{
    const GpProgram *program = d->draw->program;
    tile->shaded = packets;
    for (unsigned left = program->local_reads; left; left &= left - 1)
        fast_begin_fetch(tile, d->draw->textures, __builtin_ctz(left));
    GpShaderCall call = {
        .uniforms = d->draw->uniforms,
        .packets = count,
        .in = tile->in,
        .textures = d->draw->textures,
        .read_texture = fast_read_texture,
        .executor = d->samplers,
        .read_local = fast_fetch_framebuffer,
        .local = tile,
        .pixel = tile->pixel,
        .face = tile->face,
        .color = tile->color,
        .depth = program->writes_depth ? tile->shader_depth : NULL,
        .killed = program->may_discard ? tile->killed : NULL,
    };
    d->code->pixel(&call);
}
