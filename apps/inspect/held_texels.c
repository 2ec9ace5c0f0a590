#include "apps/inspect/held_texels.h"

#include <string.h>

typedef void CopyFn(uint8_t *texel, uint8_t *held, size_t bytes);

static void take(uint8_t *texel, uint8_t *held, size_t bytes)
{
    memcpy(held, texel, bytes);
}

static void put(uint8_t *texel, uint8_t *held, size_t bytes)
{
    memcpy(texel, held, bytes);
}

/* returns the end of those of this surface */
static uint8_t *copy_texels(const GpSurface *surface, const Histories *histories, uint8_t *held,
                            CopyFn *copy)
{
    const GpLevel *level = &surface->level[0];
    const size_t bytes = gp_format_info(surface->format)->bytes;
    for (uint32_t i = 0; i < histories->count; i++)
        for (uint32_t corner = 0; corner < 4; corner++, held += bytes) {
            const uint32_t x = ((uint32_t)histories->pixel[i].x & ~1u) + corner % 2;
            const uint32_t y = ((uint32_t)histories->pixel[i].y & ~1u) + corner / 2;
            if (x < level->width && y < level->height)
                copy(level->texels + y * level->pitch + x * bytes, held, bytes);
        }
    return held;
}

static void copy_targets(const HeldTexels *held, const GpPass *pass, const Histories *histories,
                         CopyFn *copy)
{
    uint8_t *at = held->bytes;
    for (int t = 0; t < GP_MAX_TARGETS; t++)
        if (pass->color[t].surface)
            at = copy_texels(pass->color[t].surface, histories, at, copy);
    if (pass->depth.surface)
        copy_texels(pass->depth.surface, histories, at, copy);
}

GpResult held_texels_take(HeldTexels *held, const GpPass *pass, const Histories *histories,
                          GpError *error)
{
    enum { MOST_BYTES = 16 }; /* of a texel */
    const size_t room = (size_t)histories->count * 4 * (GP_MAX_TARGETS + 1) * MOST_BYTES;
    if (room > held->room) {
        held_texels_free(held);
        held->bytes = gp_alloc_unset(room);
        if (!held->bytes)
            return gp_fail(error, GP_ERROR_MEMORY, "no memory for the texels of chosen pixels");
        held->room = room;
    }
    copy_targets(held, pass, histories, take);
    return GP_OK;
}

void held_texels_put(const HeldTexels *held, const GpPass *pass, const Histories *histories)
{
    copy_targets(held, pass, histories, put);
}

void held_texels_free(HeldTexels *held)
{
    gp_free(held->bytes);
    *held = (HeldTexels){ .bytes = NULL };
}
