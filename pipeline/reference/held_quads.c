#include "pipeline/reference/held_quads.h"

#include "pipeline/base/grow.h"
#include "pipeline/list/pass_target.h"

#include <string.h>

GpResult gp_held_begin(GpHeldQuads *quads, const GpPass *pass, GpError *error)
{
    uint32_t width, height;
    gp_pass_size(pass, &width, &height);
    *quads =
        (GpHeldQuads){ .pass = pass, .quads_x = (width + 1) / 2, .bytes = 2 * sizeof(uint32_t) };
    quads->seen = gp_alloc((size_t)quads->quads_x * ((height + 1) / 2), 1);
    if (!quads->seen)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for the quads that are watched");
    for (int slot = 0; slot <= GP_MAX_TARGETS; slot++)
        if (gp_pass_target(pass, slot))
            quads->bytes += 4 * (size_t)gp_format_info(gp_pass_target(pass, slot)->format)->bytes;
    return GP_OK;
}

typedef void CopyFn(uint8_t *texel, uint8_t *held, size_t bytes);

static void take(uint8_t *texel, uint8_t *held, size_t bytes)
{
    memcpy(held, texel, bytes);
}

static void put(uint8_t *texel, uint8_t *held, size_t bytes)
{
    memcpy(texel, held, bytes);
}

/* Between the targets and what is held of a quad; what is outside of them is left out. */
static void copy_quad(const GpHeldQuads *quads, size_t number, CopyFn *copy)
{
    uint8_t *held = quads->held + number * quads->bytes;
    uint32_t place[2];
    memcpy(place, held, sizeof place);
    held += sizeof place;
    for (int slot = 0; slot <= GP_MAX_TARGETS; slot++) {
        const GpSurface *surface = gp_pass_target(quads->pass, slot);
        if (!surface)
            continue;
        const GpLevel *level = &surface->level[0];
        const size_t bytes = gp_format_info(surface->format)->bytes;
        for (uint32_t i = 0; i < 4; i++, held += bytes) {
            const uint32_t x = place[0] + i % 2, y = place[1] + i / 2;
            if (x < level->width && y < level->height)
                copy(level->texels + y * level->pitch + x * bytes, held, bytes);
        }
    }
}

void gp_held_add(GpHeldQuads *quads, int32_t x, int32_t y)
{
    const uint32_t place[2] = { (uint32_t)x, (uint32_t)y };
    uint8_t *seen = &quads->seen[(size_t)(place[1] / 2) * quads->quads_x + place[0] / 2];
    if (*seen)
        return;
    uint8_t *held = gp_grown(quads->held, quads->count, &quads->room, quads->bytes, &quads->failed);
    if (!held)
        return;
    *seen = 1;
    quads->held = held;
    memcpy(held + quads->count * quads->bytes, place, sizeof place);
    copy_quad(quads, quads->count++, take);
}

void gp_held_put(const GpHeldQuads *quads)
{
    for (size_t i = 0; i < quads->count; i++)
        copy_quad(quads, i, put);
}

void gp_held_free(GpHeldQuads *quads)
{
    gp_free(quads->seen);
    gp_free(quads->held);
    *quads = (GpHeldQuads){ .pass = NULL };
}
