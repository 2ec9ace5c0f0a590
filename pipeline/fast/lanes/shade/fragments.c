#include "pipeline/fast/lanes/shade/fragments.h"

#include "pipeline/fast/lanes/memory/convert.h"
#include "pipeline/fast/lanes/shade/blend_sorted.h"
#include "pipeline/fast/lanes/shade/records.h"
#include "pipeline/fast/lanes/shade/shader_block.h"
#include "pipeline/units/fragment_order.h"

#include <string.h>

/* --- memory ----------------------------------------------------------------------------------- */

/* A pixel's list takes a third of the memory at most, and ends where few scenes do. */
enum {
    LISTS = 3,
    LEAST_LAYERS = 4,
    MOST_LAYERS = 100,
    LAYER_BYTES = 2 * FAST_PIXELS * (int)sizeof(uint32_t),
};

size_t fast_least_fragment_bytes(void)
{
    return (size_t)LISTS * LEAST_LAYERS * LAYER_BYTES;
}

static void forget_all(FastFragments *f)
{
    f->shaded_count = f->deepest = 0;
    memset(f->waiting, 0, sizeof f->waiting);
}

void fast_begin_fragments(Tile *tile)
{
    FastFragments *f = tile->fragments;
    const size_t layers = f->bytes / LISTS / LAYER_BYTES;
    const size_t of_one = sizeof(float[4]) * (size_t)tile->targets + 2 * sizeof(uint32_t);
    f->layers = layers < MOST_LAYERS ? (uint32_t)layers : MOST_LAYERS;
    f->room = (uint32_t)((f->bytes - f->layers * (size_t)LAYER_BYTES) / of_one) & -64u;
    f->targets = (uint32_t)tile->targets;
    f->color = f->memory;
    f->key = (uint32_t *)f->memory + (size_t)f->room * 4 * f->targets;
    f->shaded = f->key + (size_t)f->layers * FAST_PIXELS;
    f->source = f->shaded + (size_t)f->layers * FAST_PIXELS;
    f->moved = f->source + f->room;
    f->first = 0;
    f->last = GP_ORDER_KEY_MOST;
    forget_all(f);
}

/* --- slices ----------------------------------------------------------------------------------- */

static uint32_t sum_of(itg a)
{
    uint32_t sum = 0;
    for (int lane = 0; lane < GP_LANES; lane++)
        sum += (uint32_t)a[lane];
    return sum;
}

/* How many that wait have a key up to this one: of all pixels, or of the one at a place. */
static uint32_t count_up_to(const FastFragments *f, const uint32_t *pixel, uint32_t key)
{
    itg count = itg_set(0);
    const uint32_t first = pixel ? *pixel : 0, end = pixel ? *pixel + 1 : FAST_PIXELS;
    for (uint32_t at = first; at < end; at += GP_LANES) {
        itg waiting = load_lanes(f->waiting + at, false);
        waiting &= (itg)(lane_numbers() < (int32_t)(end - at));
        for (int32_t layer = 0; msk_any((msk)(layer < waiting)); layer++) {
            const itg keys = load_lanes(f->key + (size_t)layer * FAST_PIXELS + at, false);
            count -= (itg)(layer < waiting) & (itg)(keys <= (int32_t)key);
        }
    }
    return sum_of(count);
}

/* The least key of the slice up to which at least half of them goes. */
static uint32_t middle_key(const FastFragments *f, const uint32_t *pixel, uint32_t waiting)
{
    uint32_t low = f->first, high = f->last;
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        if (2 * count_up_to(f, pixel, middle) >= waiting)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/* Takes what lies beyond the slice from the lists, and notes what is left of what was shaded. */
static void shorten_lists(FastFragments *f)
{
    for (uint32_t at = 0; at < FAST_PIXELS; at++) {
        size_t to = at;
        uint32_t kept = 0;
        for (size_t layer = 0, from = at; layer < f->waiting[at]; layer++, from += FAST_PIXELS) {
            if (f->key[from] > f->last)
                continue;
            f->key[to] = f->key[from];
            f->shaded[to] = f->shaded[from];
            f->moved[f->shaded[to]] = 1;
            to += FAST_PIXELS;
            kept++;
        }
        f->waiting[at] = kept;
    }
}

/* Closes the ranks of what was shaded; its numbers still rise as it came. */
static void close_ranks(FastFragments *f)
{
    const size_t words = 4 * (size_t)f->targets;
    uint32_t count = 0;
    for (uint32_t number = 0; number < f->shaded_count; number++) {
        if (!f->moved[number])
            continue;
        memmove(f->color + count * words, f->color + number * words, words * sizeof(float));
        f->source[count] = f->source[number];
        f->moved[number] = count++;
    }
    f->shaded_count = count;
    for (uint32_t at = 0; at < FAST_PIXELS; at++)
        for (size_t layer = 0, of = at; layer < f->waiting[at]; layer++, of += FAST_PIXELS)
            f->shaded[of] = f->moved[f->shaded[of]];
}

/* Ends the slice earlier, so that some of what waits is left to later ones: half of what is at a
 * pixel whose list is full, or half of all. */
static void end_earlier(Tile *tile, const uint32_t *pixel)
{
    FastFragments *f = tile->fragments;
    const uint32_t waiting = count_up_to(f, pixel, GP_ORDER_KEY_MOST);
    const uint32_t middle = middle_key(f, pixel, waiting);
    const bool has_more = count_up_to(f, pixel, middle) < waiting;
    const bool has_one_key = !has_more && middle == f->first;
    f->last = has_more || has_one_key ? middle : middle - 1;
    memset(f->moved, 0, f->shaded_count * sizeof *f->moved);
    shorten_lists(f);
    if (has_one_key) { /* all that is left; and what comes of it comes later */
        fast_blend_sorted(tile);
        forget_all(f);
    } else
        close_ranks(f);
}

/* The length of the longest list, and where one such is. */
static uint32_t find_deepest(const FastFragments *f, uint32_t *pixel)
{
    itg most = itg_set(0);
    uint32_t deepest = 0;
    for (uint32_t at = 0; at < FAST_PIXELS; at += GP_LANES)
        most = itg_greater(most, load_lanes(f->waiting + at, false));
    for (int lane = 0; lane < GP_LANES; lane++)
        deepest = (uint32_t)most[lane] > deepest ? (uint32_t)most[lane] : deepest;
    for (*pixel = 0; deepest == f->layers && f->waiting[*pixel] < deepest;)
        ++*pixel;
    return deepest;
}

void fast_make_layer(Tile *tile)
{
    FastFragments *f = tile->fragments;
    uint32_t pixel;
    for (;;) {
        f->deepest = find_deepest(f, &pixel);
        if (fast_has_layer(f))
            return;
        end_earlier(tile, f->deepest == f->layers ? &pixel : NULL);
    }
}

bool fast_end_slice(Tile *tile)
{
    FastFragments *f = tile->fragments;
    fast_blend_sorted(tile);
    forget_all(f);
    if (f->last == GP_ORDER_KEY_MOST)
        return false;
    f->first = f->last + 1;
    f->last = GP_ORDER_KEY_MOST;
    f->slices++;
    return true;
}

/* --- what comes ------------------------------------------------------------------------------- */

static itg keys_of(const FastDraw *d, flt z)
{
    const flt low = flt_set(d->viewport.min_depth), high = flt_set(d->viewport.max_depth);
    z = flt_select((msk)(z < low), low, z);
    z = flt_select((msk)(z > high), high, z);
    return fast_order_keys(d, depth_codes(GP_D32F, z));
}

/* Fragments of one packet, lane by lane. */
typedef struct Arrivals {
    uint32_t key[GP_LANES], at[GP_LANES];
    _Alignas(64) float color[GP_LANES][GP_MAX_TARGETS * 4];
} Arrivals;

static void add_arrivals(FastFragments *f, const Arrivals *arrivals, unsigned live, uint32_t source)
{
    for (; live; live &= live - 1) {
        const int lane = __builtin_ctz(live);
        const uint32_t number = f->shaded_count++;
        f->source[number] = source;
        memcpy(f->color + (size_t)number * 4 * f->targets, arrivals->color[lane],
               f->targets * sizeof(float[4]));
        fast_add_fragment(f, arrivals->at[lane], arrivals->key[lane], number);
    }
}

void fast_keep_packets(Tile *tile, const FastDraw *d, const FastShaded *shaded)
{
    FastFragments *f = tile->fragments;
    const FastPacketBlock *block = &shaded->block;
    const bool by_shader = d->draw->program->writes_depth;
    const float *depths = by_shader ? tile->block->shader_depth : block->depths;
    const int written = gp_program_targets(d->draw->program);
    Arrivals arrivals;
    for (int p = 0; p < block->count; p++) {
        if (!shaded->live[p])
            continue;
        if (!fast_has_layer(f))
            fast_make_layer(tile);
        const itg keys = keys_of(d, flt_load(depths + p * GP_LANES));
        const unsigned live = shaded->live[p] & msk_bits(fast_of_slice(f, keys));
        store_lanes(arrivals.key, false, keys);
        store_lanes(arrivals.at, false, block_y(block, p) * FAST_PITCH + block_x(block, p));
        for (int t = 0; d->needs.pixel_shader && t < written && t < tile->targets; t++)
            lanes_store4(&arrivals.color[0][4 * t], sizeof arrivals.color[0],
                         (const itg *)(shaded->color + p * shaded->stride + 4 * t));
        const bool front = tile->records->record[block->packets[p].record].face > 0;
        add_arrivals(f, &arrivals, live, fast_source(tile, d, front));
        f->deepest++;
    }
}
