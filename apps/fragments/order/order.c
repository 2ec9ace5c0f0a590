#include "apps/fragments/order/order.h"

#include "apps/fragments/order/relations.h"

#include <string.h>

/* Nodes of the graph: the near side of piece p is 2 p, its far side 2 p + 1. Of sides that are
 * taken apart these are gates, before all of their faces; then come gates behind all of them, and
 * the faces. */
typedef struct Work {
    const Pieces *pieces;
    const Screen *screen;
    Relations relations;
    uint32_t *face_node; /* [faces] */
    bool *is_split;      /* [sides] */
    bool *has_gates;     /* [pieces]: whole pieces come before it, or after it */
    Graph graph;
    uint32_t *component; /* [nodes] */
    uint32_t components;
    uint32_t *size;  /* [components] faces and sides */
    uint32_t *start; /* [components] the earliest time: level * 2, one more for far */
    Order order;
} Work;

static uint32_t side_of(const Work *work, uint32_t face)
{
    return 2 * work->pieces->piece_of[face] + relations_is_far(work->pieces, work->screen, face);
}

static uint32_t sides(const Work *work)
{
    return 2 * work->pieces->count;
}

static bool is_drawn(const Work *work, uint32_t face)
{
    return work->screen->faces[face].count > 0;
}

/* --- the graph -------------------------------------------------------------------------------- */

static uint32_t gate_behind(const Work *work, uint32_t side)
{
    return work->is_split[side] ? sides(work) + side : side;
}

static void add_gates(const Work *work, Pairs *edges)
{
    for (uint32_t f = 0; f < work->pieces->face_count; f++) {
        const uint32_t side = side_of(work, f);
        if (is_drawn(work, f) && work->is_split[side] &&
            work->has_gates[work->pieces->piece_of[f]]) {
            pairs_add(edges, side, work->face_node[f]);
            pairs_add(edges, work->face_node[f], gate_behind(work, side));
        }
    }
}

/* Makes the graph of all nodes, and its components. */
static GpResult make_graph(Work *work)
{
    const Relations *relations = &work->relations;
    const uint32_t nodes = 2 * sides(work) + work->pieces->face_count;
    Pairs edges = { .pair = NULL };
    for (size_t i = 0; i < relations->faces.count; i++) {
        const uint32_t *pair = relations->faces.pair[i];
        const uint32_t before = work->face_node[pair[0]], after = work->face_node[pair[1]];
        if (before != after)
            pairs_add(&edges, before, after);
    }
    for (size_t i = 0; i < relations->pieces.count; i++)
        for (uint32_t k = 0; k < 4; k++)
            pairs_add(&edges, gate_behind(work, 2 * relations->pieces.pair[i][0] + k / 2),
                      2 * relations->pieces.pair[i][1] + k % 2);
    for (uint32_t p = 0; p < work->pieces->count; p++)
        if (order_is_large(work->pieces, p))
            pairs_add(&edges, gate_behind(work, 2 * p), 2 * p + 1);
    add_gates(work, &edges);
    graph_free(&work->graph);
    GpResult result = graph_make(nodes, &edges, &work->graph);
    pairs_free(&edges);
    return result ? result : graph_components(&work->graph, work->component, &work->components);
}

static void count_sizes(Work *work)
{
    memset(work->size, 0, work->graph.count * sizeof *work->size);
    for (uint32_t n = 0; n < work->graph.count; n++)
        work->size[work->component[n]]++;
}

/* Takes sides in circles apart; returns how many. */
static uint32_t split_circles(Work *work)
{
    uint32_t count = 0;
    count_sizes(work);
    for (uint32_t s = 0; s < sides(work); s++)
        if (work->size[work->component[s]] > 1) {
            work->is_split[s] = true;
            count++;
        }
    for (uint32_t f = 0; f < work->pieces->face_count && count > 0; f++)
        if (work->is_split[side_of(work, f)])
            work->face_node[f] = 2 * sides(work) + f;
    return count;
}

/* --- times ------------------------------------------------------------------------------------ */

/* What draws of a component: nothing (gates), one side (of a piece, or a face of it), or a knot. */
typedef struct Kind {
    uint32_t faces;
    bool is_far;
} Kind;

/* Counts faces of knots one by one, and all of a side as one. */
static Kind *find_kinds(const Work *work)
{
    Kind *kinds = gp_alloc(work->components, sizeof *kinds);
    for (uint32_t f = 0; f < work->pieces->face_count && kinds; f++) {
        const uint32_t side = side_of(work, f);
        Kind *kind = &kinds[work->component[work->face_node[f]]];
        if (!is_drawn(work, f))
            continue;
        kind->faces = work->is_split[side] ? kind->faces + 1 : 1;
        kind->is_far = side % 2;
    }
    return kinds;
}

/* The earliest time of each component, after the last of those before it. Components are numbered
 * from the last. */
static GpResult find_times(Work *work, Kind *kinds)
{
    uint32_t *members = gp_alloc((size_t)work->graph.count + 1, sizeof *members);
    uint32_t *first = gp_alloc((size_t)work->components + 2, sizeof *first);
    if (!members || !first) {
        gp_free(members);
        gp_free(first);
        return GP_ERROR_MEMORY;
    }
    for (uint32_t n = 0; n < work->graph.count; n++)
        first[work->component[n] + 2]++;
    for (uint32_t c = 0; c < work->components; c++)
        first[c + 1] += first[c];
    for (uint32_t n = 0; n < work->graph.count; n++)
        members[first[work->component[n] + 1]++] = n;
    memset(work->start, 0, work->components * sizeof *work->start);
    for (uint32_t c = work->components; c-- > 0;) {
        uint32_t end = work->start[c];
        if (kinds[c].faces > 1)
            end = (work->start[c] = (end + 1) & ~1u) + 2;
        else if (kinds[c].faces == 1)
            end = (work->start[c] += (end & 1) != kinds[c].is_far) + 1;
        for (uint32_t i = first[c]; i < first[c + 1]; i++)
            for (size_t k = work->graph.first[members[i]]; k < work->graph.first[members[i] + 1];
                 k++) {
                uint32_t *start = &work->start[work->component[work->graph.after[k]]];
                if (start != &work->start[c] && *start < end)
                    *start = end;
            }
    }
    gp_free(members);
    gp_free(first);
    return GP_OK;
}

/* --- levels ----------------------------------------------------------------------------------- */

static uint32_t level_of(const Work *work, uint32_t face)
{
    return work->start[work->component[work->face_node[face]]] / 2;
}

/* Faces by their levels, in the order of pieces; of knots, or of all others. */
static void list_levels(const Work *work, const Kind *kinds, bool knots, uint32_t *first,
                        uint32_t *faces)
{
    const Pieces *pieces = work->pieces;
    uint32_t *next = first + 1;
    for (int round = 0; round < 2; round++) {
        for (uint32_t i = 0; i < pieces->face_count; i++) {
            const uint32_t face = pieces->faces[i];
            if (!is_drawn(work, face) ||
                (kinds[work->component[work->face_node[face]]].faces > 1) != knots)
                continue;
            if (round == 0)
                next[level_of(work, face) + 1]++;
            else
                faces[next[level_of(work, face)]++] = face;
        }
        for (uint32_t level = 0; level < work->order.level_count && round == 0; level++)
            next[level + 1] += next[level];
    }
}

GpResult order_make_room(Order *order, size_t faces)
{
    order->first = gp_alloc((size_t)order->level_count + 2, sizeof *order->first);
    order->knot_first = gp_alloc((size_t)order->level_count + 2, sizeof *order->knot_first);
    order->faces = gp_alloc(faces, sizeof *order->faces);
    order->knots = gp_alloc(faces, sizeof *order->knots);
    const bool has_room = order->first && order->knot_first && order->faces && order->knots;
    return has_room ? GP_OK : GP_ERROR_MEMORY;
}

static GpResult make_levels(Work *work, const Kind *kinds)
{
    Order *order = &work->order;
    const size_t faces = work->pieces->face_count;
    for (uint32_t f = 0; f < faces; f++)
        if (is_drawn(work, f) && level_of(work, f) >= order->level_count)
            order->level_count = level_of(work, f) + 1;
    if (order_make_room(order, faces))
        return GP_ERROR_MEMORY;
    list_levels(work, kinds, false, order->first, order->faces);
    list_levels(work, kinds, true, order->knot_first, order->knots);
    for (uint32_t c = 0; c < work->components; c++)
        order->knot_count += kinds[c].faces > 1;
    return GP_OK;
}

/* --- the whole -------------------------------------------------------------------------------- */

static bool alloc_work(Work *work)
{
    const size_t faces = work->pieces->face_count, nodes = 2 * (size_t)sides(work) + faces + 1;
    work->face_node = gp_alloc(faces, sizeof *work->face_node);
    work->is_split = gp_alloc(sides(work), sizeof *work->is_split);
    work->has_gates = gp_alloc(work->pieces->count, sizeof *work->has_gates);
    work->component = gp_alloc(nodes, sizeof *work->component);
    work->size = gp_alloc(nodes, sizeof *work->size);
    work->start = gp_alloc(nodes, sizeof *work->start);
    return work->face_node && work->is_split && work->has_gates && work->component && work->size &&
           work->start;
}

static void free_work(Work *work)
{
    relations_free(&work->relations);
    gp_free(work->face_node);
    gp_free(work->is_split);
    gp_free(work->has_gates);
    graph_free(&work->graph);
    gp_free(work->component);
    gp_free(work->size);
    gp_free(work->start);
}

static void prepare(Work *work)
{
    const Relations *relations = &work->relations;
    bool *seen = work->is_split; /* for a moment */
    for (uint32_t f = 0; f < work->pieces->face_count; f++) {
        work->face_node[f] = side_of(work, f);
        work->order.sides += is_drawn(work, f) && !seen[side_of(work, f)];
        seen[side_of(work, f)] |= is_drawn(work, f);
    }
    memset(seen, 0, sides(work) * sizeof *seen);
    for (size_t i = 0; i < relations->pieces.count; i++)
        for (int k = 0; k < 2; k++)
            work->has_gates[relations->pieces.pair[i][k]] = true;
    for (uint32_t p = 0; p < work->pieces->count; p++)
        work->has_gates[p] |= order_is_large(work->pieces, p);
}

static GpResult sort_all(Work *work)
{
    if (!alloc_work(work))
        return GP_ERROR_MEMORY;
    prepare(work);
    GpResult result = make_graph(work);
    if (!result && (work->order.split_sides = split_circles(work)) > 0)
        result = make_graph(work);
    if (result)
        return result;
    Kind *kinds = find_kinds(work);
    result = kinds ? find_times(work, kinds) : GP_ERROR_MEMORY;
    if (!result)
        result = make_levels(work, kinds);
    gp_free(kinds);
    return result;
}

GpResult order_find(const OrderMesh *mesh, const FragmentView *view, const Screen *screen,
                    Order *order, GpError *error)
{
    Work work = { .pieces = mesh->pieces, .screen = screen };
    GpResult result = relations_find(mesh, &view->camera, screen, &work.relations, error);
    if (!result) {
        result = sort_all(&work);
        if (result)
            gp_fail(error, result, "out of memory");
    }
    free_work(&work);
    if (result)
        order_free(&work.order);
    else
        *order = work.order;
    return result;
}

void order_free(Order *order)
{
    gp_free(order->first);
    gp_free(order->faces);
    gp_free(order->knot_first);
    gp_free(order->knots);
    *order = (Order){ .level_count = 0 };
}
