#include "pipeline/fast/lanes/raster/even_tile.h"

#include "pipeline/fast/lanes/memory/slots.h"
#include "pipeline/fast/lanes/raster/fill.h"
#include "pipeline/fast/lanes/shade/packets.h"
#include "pipeline/fast/lanes/shade/records.h"
#include "pipeline/units/setup.h"

/* Number of the slot of a surface that has one colour in the tile; -1: none. */
static int even_slot(const Tile *tile, const GpSurface *surface)
{
    const int slot = fast_color_slot(tile->slots->surfaces, surface);
    return slot >= 0 && tile->slots->color[slot].cleared ? slot : -1;
}

static bool are_surfaces_even(const Tile *tile, const GpPass *pass, const GpDraw *draw)
{
    for (int t = 0; t < tile->targets; t++)
        if (even_slot(tile, pass->color[t].surface) < 0)
            return false;
    for (unsigned read = draw->program->local_reads; read; read &= read - 1)
        if (even_slot(tile, draw->textures[__builtin_ctz(read)].surface) < 0)
            return false;
    return true;
}

static bool set_up(const FastDraw *d, uint32_t primitive, const GpRect *rect, GpTriangle *triangle,
                   bool *is_cut)
{
    GpScreenVertex corner[3];
    for (uint32_t k = 0; k < 3; k++) {
        const uint32_t number = d->indices ? d->indices[3 * primitive + k] : 3 * primitive + k;
        const FastPosition *at = &d->positions[number - d->first_vertex];
        *is_cut = *is_cut || fast_outside(at);
        corner[k] = (GpScreenVertex){ .x = at->x, .y = at->y, .z = at->z, .rw = at->rw };
    }
    return !*is_cut &&
           gp_setup_triangle(corner, &d->draw->state.raster, rect, triangle) == GP_SETUP_DRAWN;
}

/* Whether one of a draw's triangles covers all of the tile, and no other any of it. */
static bool covers_once(const Tile *tile, const FastDraw *d)
{
    const GpRect rect = fast_tile_rect(tile, d);
    int wholes = 0;
    if (rect.x1 - rect.x0 != tile->width || rect.y1 - rect.y0 != tile->height)
        return false;
    for (uint32_t i = 0; i < d->primitive_count; i++) {
        GpTriangle triangle;
        bool is_cut = false;
        const FastCover cover = set_up(d, i, &rect, &triangle, &is_cut)
                                    ? fast_cover(tile, &triangle)
                                    : FAST_COVERS_NONE;
        if (is_cut || cover == FAST_COVERS_SOME)
            return false;
        wholes += cover == FAST_COVERS_ALL;
    }
    return wholes == 1;
}

/* What the first pixel of a target holds becomes what all hold. */
static void spread_first(Tile *tile, int target, int slot)
{
    const GpFormat format = tile->slots->surfaces->color[slot]->format;
    float *value = tile->slots->color[slot].value;
    if (fast_is_packed(format))
        gp_texel_load(format, tile->planes[target]->packed, value);
    for (int c = 0; !fast_is_packed(format) && c < gp_format_info(format)->channels; c++)
        value[c] = tile->planes[target]->channel[c][0];
    tile->slots->color[slot].written = true;
}

bool fast_draw_even(Tile *tile, const FastPass *pass)
{
    const FastDraw *d = &pass->draws[0];
    FastPacket packet;
    if (!are_surfaces_even(tile, pass->pass, d->draw) || !covers_once(tile, d))
        return false;
    set_packet(&packet, FAST_NO_RECORD, 0, 0, 1, GP_LANES);
    tile->draw = d;
    for (int t = 0; t < tile->targets; t++)
        fast_spell_out_first(tile, even_slot(tile, pass->pass->color[t].surface));
    fast_shade_inputs(tile, d, &(FastPacketBlock){ .packets = &packet, .count = 1 });
    for (int t = 0; t < tile->targets; t++)
        spread_first(tile, t, even_slot(tile, pass->pass->color[t].surface));
    tile->fragments_shaded += (uint64_t)(tile->width * tile->height - 1);
    return true;
}
