#include "apps/fragments/order/grid_levels.h"

#include "apps/fragments/order/relations.h"

enum { PIXELS = 8 /* of a part of the screen */, TURNS = 3 /* near, far, slab */ };

typedef struct Levels {
    const Pieces *pieces;
    const Partings *partings;
    const Screen *screen;
    uint32_t across, down;
    uint32_t *used;              /* [down][across] the times that are taken */
    uint32_t *time;              /* [nodes] level * TURNS + turn */
    uint32_t *first, *faces;     /* [nodes + 1] of each node in faces */
    uint32_t node_count, latest; /* latest: the last time, and 1 */
} Levels;

/* --- faces of nodes --------------------------------------------------------------------------- */

static uint32_t node_of(const Levels *levels, uint32_t face)
{
    const uint32_t slab = levels->partings->slab_of[face];
    return slab != NO_SLAB ? 2 * levels->pieces->count + slab
                           : 2 * levels->pieces->piece_of[face] +
                                 relations_is_far(levels->pieces, levels->screen, face);
}

static bool is_drawn(const Levels *levels, uint32_t face)
{
    return levels->screen->faces[face].count > 0;
}

static void list_nodes(Levels *levels)
{
    uint32_t *next = levels->first + 1; /* counts, then where one goes, then ends */
    for (int round = 0; round < 2; round++) {
        for (uint32_t i = 0; i < levels->pieces->face_count; i++) {
            const uint32_t face = levels->pieces->faces[i];
            if (!is_drawn(levels, face))
                continue;
            if (round == 0)
                next[node_of(levels, face) + 1]++;
            else
                levels->faces[next[node_of(levels, face)]++] = face;
        }
        for (uint32_t n = 0; n < levels->node_count && round == 0; n++)
            next[n + 1] += next[n];
    }
}

/* --- times ------------------------------------------------------------------------------------ */

static int32_t between(int32_t value, uint32_t count)
{
    return value < 0 ? 0 : value >= (int32_t)count ? (int32_t)count - 1 : value;
}

/* The most times that are taken under a face; where `end` is not 0, they become it. */
static uint32_t used_under(Levels *levels, uint32_t face, uint32_t end)
{
    const ScreenBox *box = &levels->screen->faces[face].box;
    const int32_t side = PIXELS * 256;
    uint32_t most = 0;
    for (int32_t y = between(box->y0 / side, levels->down);
         y <= between(box->y1 / side, levels->down); y++)
        for (int32_t x = between(box->x0 / side, levels->across);
             x <= between(box->x1 / side, levels->across); x++) {
            uint32_t *used = &levels->used[(size_t)y * levels->across + (uint32_t)x];
            most = *used > most ? *used : most;
            *used = end ? end : *used;
        }
    return most;
}

static void find_time(Levels *levels, uint32_t node)
{
    const uint32_t sides = 2 * levels->pieces->count, turn = node < sides ? node % 2 : 2;
    uint32_t time = 0;
    for (uint32_t i = levels->first[node]; i < levels->first[node + 1]; i++) {
        const uint32_t most = used_under(levels, levels->faces[i], 0);
        time = most > time ? most : time;
    }
    time += (turn + TURNS - time % TURNS) % TURNS;
    for (uint32_t i = levels->first[node]; i < levels->first[node + 1]; i++)
        used_under(levels, levels->faces[i], time + 1);
    levels->time[node] = time;
    if (levels->first[node] < levels->first[node + 1] && time >= levels->latest)
        levels->latest = time + 1;
}

/* --- levels ----------------------------------------------------------------------------------- */

/* Faces by their levels, in the order of pieces: those of slabs, or of all others. */
static void list_faces(const Levels *levels, bool slabs, uint32_t level_count, uint32_t *first,
                       uint32_t *faces)
{
    uint32_t *next = first + 1;
    for (int round = 0; round < 2; round++) {
        for (uint32_t i = 0; i < levels->pieces->face_count; i++) {
            const uint32_t face = levels->pieces->faces[i];
            if (!is_drawn(levels, face) || (levels->partings->slab_of[face] != NO_SLAB) != slabs)
                continue;
            const uint32_t level = levels->time[node_of(levels, face)] / TURNS;
            if (round == 0)
                next[level + 1]++;
            else
                faces[next[level]++] = face;
        }
        for (uint32_t n = 0; n < level_count && round == 0; n++)
            next[n + 1] += next[n];
    }
}

static GpResult make_levels(const Levels *levels, Order *order)
{
    order->level_count = (levels->latest + TURNS - 1) / TURNS;
    if (order_make_room(order, levels->pieces->face_count))
        return GP_ERROR_MEMORY;
    list_faces(levels, false, order->level_count, order->first, order->faces);
    list_faces(levels, true, order->level_count, order->knot_first, order->knots);
    order->knot_count = levels->partings->slab_count;
    for (uint32_t n = 0; n < 2 * levels->pieces->count; n++)
        order->sides += levels->first[n] < levels->first[n + 1];
    return GP_OK;
}

GpResult grid_levels(const Pieces *pieces, const Partings *partings, const FragmentView *view,
                     const Screen *screen, const uint32_t *sequence, uint32_t node_count,
                     Order *order)
{
    Levels levels = { .pieces = pieces,
                      .partings = partings,
                      .screen = screen,
                      .across = (view->width + PIXELS - 1) / PIXELS,
                      .down = (view->height + PIXELS - 1) / PIXELS,
                      .node_count = node_count };
    levels.used = gp_alloc((size_t)levels.across * levels.down, sizeof *levels.used);
    levels.time = gp_alloc(node_count, sizeof *levels.time);
    levels.first = gp_alloc((size_t)node_count + 2, sizeof *levels.first);
    levels.faces = gp_alloc(pieces->face_count, sizeof *levels.faces);
    GpResult result =
        levels.used && levels.time && levels.first && levels.faces ? GP_OK : GP_ERROR_MEMORY;
    if (!result) {
        list_nodes(&levels);
        for (uint32_t i = 0; i < node_count; i++)
            find_time(&levels, sequence[i]);
        result = make_levels(&levels, order);
    }
    gp_free(levels.used);
    gp_free(levels.time);
    gp_free(levels.first);
    gp_free(levels.faces);
    return result;
}
