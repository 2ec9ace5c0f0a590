/* Points whose values are the same all over them, and whose fragments combine bits with what was there:
 * those on one pixel may share a packet, since words are merged one by one. The values of GP_LANES points
 * are laid side by side, so that an input of a packet of their fragments is one shuffle. */
#include "pipeline/fast/lanes/patch.h"
#include "pipeline/fast/lanes/sprite.h"

enum {
    PACKETS = 8, /* of one call of the shader: their inputs stay in the first cache */
    ROOM = 16 * GP_LANES,
    Y_SHIFT = 8,
    POINT_SHIFT = 16,
    BYTE = 255,
};

/* Fragments of a batch of points: where they are in the tile, and their point's lane. The first
 * follow those that the last packet of the queue has already. */
typedef struct Fragments {
    uint32_t taken, count;
    uint32_t word[ROOM + GP_LANES]; /* x | y << Y_SHIFT | lane << POINT_SHIFT */
} Fragments;

/* --- packets ------------------------------------------------------------------------------------- */

static void begin_fragments(const Tile *tile, Fragments *f)
{
    const uint32_t last = tile->patch_count ? tile->patches[tile->patch_count - 1].live : 0;
    f->taken = f->count = (uint32_t)__builtin_popcount(last) % GP_LANES;
    store_lanes(f->word, false, itg_set(0));
}

/* A new packet at the end of the queue. One record serves a block of them: it only tells that points
 * face the eye. */
static void begin_packet(Tile *tile)
{
    if (tile->patch_count == PACKETS)
        FAST(flush_patches)(tile);
    uint32_t number = tile->patches[0].record;
    if (tile->patch_count == 0) {
        FAST(reserve_records)(tile, 1);
        number = tile->record_count++;
        tile->records[number] = (FastRecord){ .face = 1.0f, .kind = FAST_SPRITE };
    }
    FastPatch *patch = &tile->patches[tile->patch_count++];
    set_patch(patch, number, 0, FAST_TILE, 0, GP_LANES);
    patch->mixed = true;
}

/* Puts fragments into the lanes of the queue's last packet that `fresh` tells. */
GP_INLINE void fill_packet(Tile *tile, const itg *varying, itg word, msk fresh, bool whole)
{
    const uint32_t at = tile->patch_count - 1;
    const int components = tile->draw->modes.components;
    FastMix *mix = &tile->mixes[at];
    const itg x = word & BYTE, y = word >> Y_SHIFT & BYTE, point = word >> POINT_SHIFT;
    mix->x = whole ? x : itg_select(fresh, x, mix->x);
    mix->y = whole ? y : itg_select(fresh, y, mix->y);
    mix->at = mix->y * FAST_PITCH + mix->x;
    flt *in = (flt *)(void *)tile->in + at * (uint32_t)components;
    for (int c = 0; c < components; c++) {
        const flt value = (flt)itg_pick(varying[c], point);
        in[c] = whole ? value : flt_select(fresh, value, in[c]);
    }
}

/* Moves the fragments into the queue. Lanes that are left over repeat the last of them. */
static void queue_fragments(Tile *tile, const itg *varying, Fragments *f)
{
    if (f->count == f->taken)
        return;
    store_lanes(f->word + f->count, false, itg_set((int32_t)f->word[f->count - 1]));
    for (uint32_t first = 0; first < f->count; first += GP_LANES) {
        const itg word = load_lanes(f->word + first, false);
        if (first || !f->taken) {
            begin_packet(tile);
            fill_packet(tile, varying, word, word, true);
        } else
            fill_packet(tile, varying, word, (msk)(lane_numbers() >= (int32_t)f->taken), false);
        const uint32_t left = f->count - first;
        tile->patches[tile->patch_count - 1].live = left < GP_LANES ? (1u << left) - 1 : ALL_LANES;
    }
    begin_fragments(tile, f);
}

/* --- points -------------------------------------------------------------------------------------- */

/* The pixels of a box, by rows: as many at once as lanes have room for. */
GP_INLINE void add_box(Tile *tile, const itg *varying, Fragments *f, const FastBox *box,
                       int32_t point)
{
    const int32_t wide = box->x1 - box->x0 + 1, across = wide < GP_LANES ? wide : GP_LANES;
    const int32_t rows = GP_LANES / across;
    const itg place = lane_numbers() + lane_row(across) * ((1 << Y_SHIFT) - across);
    for (int32_t y = box->y0; y <= box->y1; y += rows)
        for (int32_t x = box->x0; x <= box->x1; x += across) {
            const int32_t right = box->x1 - x + 1, down = box->y1 - y + 1;
            if (f->count > ROOM - GP_LANES)
                queue_fragments(tile, varying, f);
            store_lanes(f->word + f->count, false,
                        place + (x | y << Y_SHIFT | point << POINT_SHIFT));
            f->count += (uint32_t)((right < across ? right : across) * (down < rows ? down : rows));
        }
}

/* Component after component of all points, side by side. */
static void load_varyings(const FastDraw *d, const uint32_t vertex[GP_LANES], itg *varying)
{
    for (int c = 0; c < d->modes.components; c += 4) {
        const void *record[GP_LANES];
        GP_UNROLL
        for (int lane = 0; lane < GP_LANES; lane++)
            record[lane] = d->varyings + (size_t)vertex[lane] * d->stride + c;
        lanes_load4(record, varying + c);
    }
}

void FAST(pack_points)(Tile *tile, const Sprites *sprites, const uint32_t vertex[GP_LANES])
{
    if (!sprites->drawn)
        return;
    itg varying[GP_MAX_VARYINGS];
    load_varyings(tile->draw, vertex, varying);
    Fragments fragments;
    begin_fragments(tile, &fragments);
    for (unsigned left = sprites->drawn; left; left &= left - 1) {
        const int32_t lane = __builtin_ctz(left);
        const FastBox box = { sprites->x0[lane], sprites->y0[lane], sprites->x1[lane],
                              sprites->y1[lane] };
        add_box(tile, varying, &fragments, &box, lane);
    }
    queue_fragments(tile, varying, &fragments);
}
