#include "pipeline/fast/draws/group.h"

static int find(const GpSurface *const *slots, int count, const GpSurface *surface)
{
    for (int i = 0; i < count; i++)
        if (slots[i] == surface)
            return i;
    return -1;
}

/* Finds the surface's slot, or gives it a free one. */
static bool take(const GpSurface **slots, int count, const GpSurface *surface)
{
    if (!surface || find(slots, count, surface) >= 0)
        return true;
    int free_slot = find(slots, count, NULL);
    if (free_slot >= 0)
        slots[free_slot] = surface;
    return free_slot >= 0;
}

bool fast_slots_add(FastSlots *slots, const GpPass *pass)
{
    FastSlots more = *slots;
    bool room = take(more.depth, FAST_DEPTH_SLOTS, pass->depth.surface);
    for (int t = 0; t < GP_MAX_TARGETS; t++)
        room = room && take(more.color, FAST_COLOR_SLOTS, pass->color[t].surface);
    if (room)
        *slots = more;
    return room;
}

/* Whether texels of a surface have a slot by another surface. */
static bool has_other_name(const FastSlots *slots, const GpSurface *surface)
{
    for (int i = 0; i < FAST_COLOR_SLOTS + FAST_DEPTH_SLOTS; i++) {
        const GpSurface *other =
            i < FAST_COLOR_SLOTS ? slots->color[i] : slots->depth[i - FAST_COLOR_SLOTS];
        if (other && other != surface && gp_surfaces_share(other, surface))
            return true;
    }
    return false;
}

static void add_read(FastSlots *slots, const GpSurface *surface)
{
    const GpFormatInfo *format = gp_format_info(surface->format);
    if (has_other_name(slots, surface))
        return;
    if (format->is_target)
        take(slots->color, FAST_COLOR_SLOTS, surface);
    else if (format->is_depth)
        take(slots->depth, FAST_DEPTH_SLOTS, surface);
}

void fast_slots_add_reads(FastSlots *slots, const GpPass *pass)
{
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        const GpDraw *draw = &pass->draws[i];
        for (unsigned read = draw->program->local_reads; read; read &= read - 1)
            add_read(slots, draw->textures[__builtin_ctz(read)].surface);
    }
}

int fast_color_slot(const FastSlots *slots, const GpSurface *surface)
{
    return find(slots->color, FAST_COLOR_SLOTS, surface);
}

int fast_depth_slot(const FastSlots *slots, const GpSurface *surface)
{
    return find(slots->depth, FAST_DEPTH_SLOTS, surface);
}
