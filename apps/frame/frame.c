#include "apps/frame/frame.h"

#include "apps/commands/commands.h"
#include "apps/commands/options.h"

#include <stdlib.h>
#include <string.h>

/* --- memory and surfaces --------------------------------------------------------------------- */

void *frame_alloc(Frame *frame, size_t count, size_t size)
{
    GP_ASSERT(frame->block_count < FRAME_MAX_BLOCKS);
    void *block = gp_alloc(count, size);
    if (!block)
        exit(report(EXIT_INTERNAL, "out of memory"));
    frame->blocks[frame->block_count++] = block;
    return block;
}

const void *frame_copy(Frame *frame, const void *data, size_t size)
{
    return memcpy(frame_alloc(frame, 1, size), data, size);
}

GpSurface *frame_surface(Frame *frame, GpFormat format, uint32_t width, uint32_t height,
                         uint32_t levels)
{
    GP_ASSERT(frame->surface_count < FRAME_MAX_SURFACES);
    GpSurfaceDesc desc = { .format = format, .width = width, .height = height, .levels = levels };
    GpSurface *surface;
    GpError error = { "" };
    if (gp_surface_create(&desc, &surface, &error))
        exit(report(EXIT_INTERNAL, "%s", error.text));
    frame->surfaces[frame->surface_count++] = surface;
    return surface;
}

void frame_free(Frame *frame)
{
    for (int i = 0; i < frame->block_count; i++)
        gp_free(frame->blocks[i]);
    for (int i = 0; i < frame->surface_count; i++)
        gp_surface_destroy(&frame->surfaces[i]);
    *frame = (Frame){ .color = NULL };
}

/* --- passes ---------------------------------------------------------------------------------- */

void frame_reserve(Frame *frame, uint32_t passes, uint32_t draws)
{
    frame->passes = frame_alloc(frame, passes, sizeof *frame->passes);
    frame->draws = frame_alloc(frame, draws, sizeof *frame->draws);
    frame->pass_room = passes;
    frame->draw_room = draws;
    frame->list.passes = frame->passes;
}

GpPass *frame_pass(Frame *frame, const char *name, GpSurface *color, GpSurface *depth,
                   const float clear_color[4])
{
    GP_ASSERT(frame->list.pass_count < frame->pass_room);
    GpPass *pass = &frame->passes[frame->list.pass_count++];
    pass->name = name;
    pass->draws = frame->draws + frame->draw_count;
    if (color) {
        pass->color[0] = (GpColorTarget){ .surface = color, .clear = true };
        memcpy(pass->color[0].clear_color, clear_color, sizeof pass->color[0].clear_color);
    }
    if (depth)
        pass->depth = (GpDepthTarget){ .surface = depth, .clear_depth = true, .depth_value = 1.0f };
    return pass;
}

GpDraw *frame_draw(Frame *frame, const GpProgram *program, const void *uniforms,
                   const GpGeometry *geometry)
{
    GP_ASSERT(frame->list.pass_count > 0 && frame->draw_count < frame->draw_room);
    GpDraw *draw = &frame->draws[frame->draw_count++];
    frame->passes[frame->list.pass_count - 1].draw_count++;
    draw->program = program;
    draw->uniforms = uniforms;
    draw->geometry = *geometry;
    return draw;
}
