#include "apps/frame/frame.h"

#include <string.h>

GpResult frame_result(const Frame *frame, GpError *error)
{
    return arena_result(&frame->arena, error);
}

void frame_free(Frame *frame)
{
    if (frame->release)
        frame->release(frame->held);
    arena_free(&frame->arena);
    *frame = (Frame){ .color = NULL };
}

/* --- memory and surfaces ---------------------------------------------------------------------- */

void *frame_alloc(Frame *frame, size_t count, size_t size)
{
    return arena_alloc(&frame->arena, count, size);
}

void frame_fail(Frame *frame)
{
    arena_fail(&frame->arena);
}

const void *frame_copy(Frame *frame, const void *data, size_t size)
{
    void *copy = frame_alloc(frame, 1, size);
    return copy && size > 0 ? memcpy(copy, data, size) : copy; /* of nothing data may be NULL */
}

void *frame_own(Frame *frame, void *memory)
{
    return arena_own(&frame->arena, memory);
}

static GpSurface *make_surface(Frame *frame, const GpSurfaceDesc *desc)
{
    GpSurface *surface = arena_surface(&frame->arena, desc);
    frame->no_surface =
        (GpSurface){ .format = desc->format, .width = desc->width, .height = desc->height };
    return surface ? surface : &frame->no_surface;
}

GpSurface *frame_surface(Frame *frame, GpFormat format, uint32_t width, uint32_t height,
                         uint32_t levels)
{
    const GpSurfaceDesc desc = {
        .format = format, .width = width, .height = height, .levels = levels
    };
    return make_surface(frame, &desc);
}

GpSurface *frame_target(Frame *frame, GpFormat format, uint32_t width, uint32_t height)
{
    GpSurfaceDesc desc = { .format = format, .width = width, .height = height };
    if (width == frame->window_of[0] && height == frame->window_of[1])
        desc.window = frame->window;
    return make_surface(frame, &desc);
}

/* --- passes ----------------------------------------------------------------------------------- */

/* An array with room for one more item, which moves to twice the room where it has none; NULL
 * without memory. */
static void *make_room(Frame *frame, void *items, uint32_t count, uint32_t *room, size_t size)
{
    if (count < *room)
        return items;
    const uint32_t twice = count ? 2 * count : 4;
    void *moved = frame_alloc(frame, twice, size);
    if (!moved)
        return NULL;
    if (count)
        memcpy(moved, items, count * size);
    *room = twice;
    return moved;
}

static GpPass *add_pass(Frame *frame)
{
    GpPass *passes = make_room(frame, frame->passes, frame->list.pass_count, &frame->pass_room,
                               sizeof *frame->passes);
    if (!passes)
        return memset(&frame->no_pass, 0, sizeof frame->no_pass);
    frame->list.passes = frame->passes = passes;
    return &passes[frame->list.pass_count++];
}

GpPass *frame_pass(Frame *frame, const char *name, GpSurface *color, GpSurface *depth,
                   const float clear_color[4])
{
    GpPass *pass = add_pass(frame);
    pass->name = name;
    if (color) {
        pass->color[0] = (GpColorTarget){ .surface = color, .clear = true };
        memcpy(pass->color[0].clear_color, clear_color, sizeof pass->color[0].clear_color);
    }
    if (depth)
        pass->depth = (GpDepthTarget){ .surface = depth, .clear_depth = true, .depth_value = 1.0f };
    return pass;
}

/* Draws of all passes lie one behind the other. */
static void move_draws(Frame *frame, GpDraw *draws)
{
    frame->draws = draws;
    for (uint32_t i = 0; i < frame->list.pass_count; i++) {
        frame->passes[i].draws = draws;
        draws += frame->passes[i].draw_count;
    }
}

void frame_reserve(Frame *frame, uint32_t draws)
{
    const uint32_t room = frame->draw_count + draws;
    if (room <= frame->draw_room)
        return;
    GpDraw *moved = frame_alloc(frame, room, sizeof *moved);
    if (!moved)
        return;
    if (frame->draw_count)
        memcpy(moved, frame->draws, frame->draw_count * sizeof *moved);
    frame->draw_room = room;
    move_draws(frame, moved);
}

static GpDraw *add_draw(Frame *frame)
{
    GpDraw *draws =
        make_room(frame, frame->draws, frame->draw_count, &frame->draw_room, sizeof *frame->draws);
    if (!draws || frame->arena.result)
        return memset(&frame->no_draw, 0, sizeof frame->no_draw);
    if (draws != frame->draws)
        move_draws(frame, draws);
    GP_ASSERT(frame->list.pass_count > 0);
    GpPass *pass = &frame->passes[frame->list.pass_count - 1];
    GpDraw *draw = &draws[frame->draw_count++];
    if (pass->draw_count++ == 0)
        pass->draws = draw;
    return draw;
}

GpDraw *frame_draw(Frame *frame, const GpProgram *program, const void *uniforms,
                   const GpGeometry *geometry)
{
    GpDraw *draw = add_draw(frame);
    draw->program = program;
    draw->uniforms = uniforms;
    draw->geometry = *geometry;
    return draw;
}

GpDraw *frame_draw_copied(Frame *frame, const GpProgram *program, const void *uniforms,
                          const GpGeometry *geometry)
{
    return frame_draw(frame, program, frame_copy(frame, uniforms, program->uniform_bytes),
                      geometry);
}

uint32_t frame_take(Frame *frame, bool (*which)(const GpDraw *draw), GpDraw *taken)
{
    if (frame->arena.result || frame->draw_count == 0)
        return 0;
    GP_ASSERT(frame->list.pass_count > 0);
    GpPass *pass = &frame->passes[frame->list.pass_count - 1];
    GpDraw *draws = frame->draws + frame->draw_count - pass->draw_count;
    uint32_t kept = 0, count = 0;
    for (uint32_t i = 0; i < pass->draw_count; i++)
        if (which(&draws[i]))
            taken[count++] = draws[i];
        else
            draws[kept++] = draws[i];
    for (uint32_t i = kept; i < pass->draw_count; i++)
        draws[i] = (GpDraw){ .program = NULL };
    pass->draw_count -= count;
    frame->draw_count -= count;
    return count;
}
