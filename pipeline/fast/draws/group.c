#include "pipeline/fast/draws/group.h"

static int find(GpSurface *const *slots, int count, const GpSurface *surface)
{
    for (int i = 0; i < count; i++)
        if (slots[i] == surface)
            return i;
    return -1;
}

/* Finds the surface's slot, or gives it a free one. */
static bool take(GpSurface **slots, int count, GpSurface *surface)
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

int fast_color_slot(const FastSlots *slots, const GpSurface *surface)
{
    return find(slots->color, FAST_COLOR_SLOTS, surface);
}

int fast_depth_slot(const FastSlots *slots, const GpSurface *surface)
{
    return find(slots->depth, FAST_DEPTH_SLOTS, surface);
}
