#include "apps/bench_work.h"

#include "apps/commands.h"
#include "apps/options.h"

#include <stdlib.h>
#include <string.h>

const float bench_background[4] = BENCH_BACKGROUND;
const float bench_black[4] = { 0 };
const GpDepthState bench_depth_less = { .test = GP_LESS, .write = true };

/* --- memory -------------------------------------------------------------------------------------- */

void *bench_alloc(BenchWork *work, size_t count, size_t size)
{
    GP_ASSERT(work->block_count < BENCH_MAX_BLOCKS);
    void *block = gp_alloc(count, size);
    if (!block)
        exit(report(EXIT_INTERNAL, "out of memory"));
    work->blocks[work->block_count++] = block;
    return block;
}

const void *bench_copy(BenchWork *work, const void *data, size_t size)
{
    return memcpy(bench_alloc(work, 1, size), data, size);
}

GpSurface *bench_surface(BenchWork *work, GpFormat format, uint32_t size, uint32_t levels)
{
    GP_ASSERT(work->surface_count < BENCH_MAX_SURFACES);
    GpSurfaceDesc desc = { .format = format, .width = size, .height = size, .levels = levels };
    GpSurface *surface;
    GpError error = { "" };
    if (gp_surface_create(&desc, &surface, &error))
        exit(report(EXIT_INTERNAL, "%s", error.text));
    work->surfaces[work->surface_count++] = surface;
    return surface;
}

void bench_free(BenchWork *work)
{
    for (int i = 0; i < work->block_count; i++)
        gp_free(work->blocks[i]);
    for (int i = 0; i < work->surface_count; i++)
        gp_surface_destroy(&work->surfaces[i]);
    *work = (BenchWork){ .color = NULL };
}

/* --- passes -------------------------------------------------------------------------------------- */

void bench_reserve(BenchWork *work, uint32_t passes, uint32_t draws)
{
    work->passes = bench_alloc(work, passes, sizeof *work->passes);
    work->draws = bench_alloc(work, draws, sizeof *work->draws);
    work->pass_room = passes;
    work->draw_room = draws;
    work->list.passes = work->passes;
}

GpPass *bench_pass(BenchWork *work, const char *name, GpSurface *color, GpSurface *depth,
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

GpDraw *bench_draw(BenchWork *work, const GpProgram *program, const void *uniforms,
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

void bench_matrix(const Camera *camera, double world[4][4], float clip[4][4])
{
    double identity[4][4], view[4][4], projection[4][4], to_eye[4][4], product[4][4];
    matrix_identity(identity);
    camera_view(camera, view);
    camera_projection(camera, 1.0, projection);
    matrix_multiply(view, world ? world : identity, to_eye);
    matrix_multiply(projection, to_eye, product);
    for (int i = 0; i < 16; i++)
        clip[i / 4][i % 4] = (float)product[i / 4][i % 4];
}
