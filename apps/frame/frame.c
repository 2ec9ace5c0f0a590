#include "apps/frame/frame.h"

#include "apps/commands/commands.h"
#include "apps/commands/options.h"

#include <stdlib.h>
#include <string.h>

/* --- memory and surfaces --------------------------------------------------------------------- */

void *work_alloc(Work *work, size_t count, size_t size)
{
    GP_ASSERT(work->block_count < WORK_MAX_BLOCKS);
    void *block = gp_alloc(count, size);
    if (!block)
        exit(report(EXIT_INTERNAL, "out of memory"));
    work->blocks[work->block_count++] = block;
    return block;
}

const void *work_copy(Work *work, const void *data, size_t size)
{
    return memcpy(work_alloc(work, 1, size), data, size);
}

GpSurface *work_surface(Work *work, GpFormat format, uint32_t width, uint32_t height,
                        uint32_t levels)
{
    GP_ASSERT(work->surface_count < WORK_MAX_SURFACES);
    GpSurfaceDesc desc = { .format = format, .width = width, .height = height, .levels = levels };
    GpSurface *surface;
    GpError error = { "" };
    if (gp_surface_create(&desc, &surface, &error))
        exit(report(EXIT_INTERNAL, "%s", error.text));
    work->surfaces[work->surface_count++] = surface;
    return surface;
}

void work_free(Work *work)
{
    for (int i = 0; i < work->block_count; i++)
        gp_free(work->blocks[i]);
    for (int i = 0; i < work->surface_count; i++)
        gp_surface_destroy(&work->surfaces[i]);
    *work = (Work){ .color = NULL };
}

/* --- passes ---------------------------------------------------------------------------------- */

void work_reserve(Work *work, uint32_t passes, uint32_t draws)
{
    work->passes = work_alloc(work, passes, sizeof *work->passes);
    work->draws = work_alloc(work, draws, sizeof *work->draws);
    work->pass_room = passes;
    work->draw_room = draws;
    work->list.passes = work->passes;
}

GpPass *work_pass(Work *work, const char *name, GpSurface *color, GpSurface *depth,
                  const float clear_color[4])
{
    GP_ASSERT(work->list.pass_count < work->pass_room);
    GpPass *pass = &work->passes[work->list.pass_count++];
    pass->name = name;
    pass->draws = work->draws + work->draw_count;
    if (color) {
        pass->color[0] = (GpColorTarget){ .surface = color, .clear = true };
        memcpy(pass->color[0].clear_color, clear_color, sizeof pass->color[0].clear_color);
    }
    if (depth)
        pass->depth = (GpDepthTarget){ .surface = depth, .clear_depth = true, .depth_value = 1.0f };
    return pass;
}

GpDraw *work_draw(Work *work, const GpProgram *program, const void *uniforms,
                  const GpGeometry *geometry)
{
    GP_ASSERT(work->list.pass_count > 0 && work->draw_count < work->draw_room);
    GpDraw *draw = &work->draws[work->draw_count++];
    work->passes[work->list.pass_count - 1].draw_count++;
    draw->program = program;
    draw->uniforms = uniforms;
    draw->geometry = *geometry;
    return draw;
}
