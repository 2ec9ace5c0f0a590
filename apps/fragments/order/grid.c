#include "apps/fragments/order/grid.h"

#include "apps/fragments/order/graph.h"
#include "apps/fragments/order/grid_levels.h"

#include <stdlib.h>
#include <string.h>

/* Of two pieces, whatever shares the screen with them. */
typedef enum Front { NEITHER, FIRST, SECOND, FIRST_IN_SECOND, SECOND_IN_FIRST } Front;

/* Nodes: the near side of piece p is 2 p, its far side 2 p + 1; then slabs. */
typedef struct Grid {
    const OrderMesh *mesh;
    const Partings *partings;
    double eye[3]; /* the eye; of parallel rays their direction */
    bool is_parallel;
    const Screen *screen;
    ScreenBox *boxes; /* of pieces */
    Pairs edges;
} Grid;

/* --- which is in front ------------------------------------------------------------------------ */

/* Whether the eye is on the lower side of a plane. */
static bool is_below(const Grid *grid, const double normal[3], double distance)
{
    const double at = vector_dot(normal, grid->eye);
    return grid->is_parallel ? at > 0 : at < distance;
}

/* By a border between two boxes; NEITHER: there is none. */
static Front front_by_boxes(const Grid *grid, uint32_t one, uint32_t other)
{
    const PieceSpan *a = &grid->mesh->spans[one], *b = &grid->mesh->spans[other];
    for (int k = 0; k < 3; k++) {
        const bool rises = a->high[k] <= b->low[k];
        if (!rises && !(b->high[k] <= a->low[k]))
            continue;
        const double border = rises ? (a->high[k] + b->low[k]) / 2 : (b->high[k] + a->low[k]) / 2;
        return is_below(grid, order_axes[k], border) == rises ? FIRST : SECOND;
    }
    return NEITHER;
}

static Front front_by_parting(const Grid *grid, const Parting *parting, uint32_t one)
{
    const bool is_low = parting->low == one;
    if (parting->kind == PARTING_NESTED)
        return is_low ? SECOND_IN_FIRST : FIRST_IN_SECOND;
    return is_below(grid, parting->plane, parting->plane[3]) == is_low ? FIRST : SECOND;
}

static Front front_of(const Grid *grid, uint32_t one, uint32_t other)
{
    const Front front = front_by_boxes(grid, one, other);
    const Parting *parting = front ? NULL : parting_of(grid->partings, one, other);
    return parting ? front_by_parting(grid, parting, one) : front;
}

/* --- what waits ------------------------------------------------------------------------------- */

static uint32_t slab_node(const Grid *grid, const Parting *parting)
{
    return 2 * grid->mesh->pieces->count + parting->slab;
}

static uint32_t other_of(const Parting *parting, uint32_t piece)
{
    return parting->low == piece ? parting->high : parting->low;
}

/* By how many the first of two pieces is rather in front: 1, 0 or -1. */
static int lead_of(const Grid *grid, uint32_t first, uint32_t second)
{
    const Front front = first == second ? NEITHER : front_of(grid, first, second);
    return (front == FIRST) - (front == SECOND);
}

/* Slabs of two pieces of which the first is in front: each stands with its own piece, unless its
 * other piece is beyond the other. */
static void wait_for_slabs(Grid *grid, uint32_t first, uint32_t second)
{
    const Partings *partings = grid->partings;
    const uint32_t *begin = partings->slab_first;
    for (uint32_t i = begin[second]; i < begin[second + 1]; i++) {
        const Parting *slab = &partings->list[partings->slabs[i]];
        const uint32_t other = other_of(slab, second);
        if (other == first || lead_of(grid, other, first) <= 0)
            pairs_add(&grid->edges, 2 * first + 1, slab_node(grid, slab));
    }
    for (uint32_t i = begin[first]; i < begin[first + 1]; i++) {
        const Parting *slab = &partings->list[partings->slabs[i]];
        const uint32_t other = other_of(slab, first);
        const int lead = lead_of(grid, other, second);
        if (other == second || lead >= 0)
            pairs_add(&grid->edges, slab_node(grid, slab), 2 * second);
        for (uint32_t k = begin[second]; k < begin[second + 1]; k++) {
            const Parting *next = &partings->list[partings->slabs[k]];
            const uint32_t beyond = other_of(next, second);
            const int sum = 1 + lead + lead_of(grid, first, beyond) + lead_of(grid, other, beyond);
            if (next != slab && sum > 0)
                pairs_add(&grid->edges, slab_node(grid, slab), slab_node(grid, next));
            else if (next != slab && sum < 0)
                pairs_add(&grid->edges, slab_node(grid, next), slab_node(grid, slab));
        }
    }
}

static void relate(Grid *grid, uint32_t one, uint32_t other)
{
    switch (front_of(grid, one, other)) {
    case FIRST:
        pairs_add(&grid->edges, 2 * one + 1, 2 * other);
        wait_for_slabs(grid, one, other);
        break;
    case SECOND:
        pairs_add(&grid->edges, 2 * other + 1, 2 * one);
        wait_for_slabs(grid, other, one);
        break;
    case FIRST_IN_SECOND:
        pairs_add(&grid->edges, 2 * other, 2 * one);
        pairs_add(&grid->edges, 2 * one + 1, 2 * other + 1);
        break;
    case SECOND_IN_FIRST:
        pairs_add(&grid->edges, 2 * one, 2 * other);
        pairs_add(&grid->edges, 2 * other + 1, 2 * one + 1);
        break;
    case NEITHER:
        break;
    }
}

static void find_boxes(Grid *grid)
{
    const Pieces *pieces = grid->mesh->pieces;
    for (uint32_t p = 0; p < pieces->count; p++) {
        ScreenBox *box = &grid->boxes[p];
        *box = (ScreenBox){ INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN };
        for (uint32_t i = pieces->first[p]; i < pieces->first[p + 1]; i++) {
            const ScreenBox *face = &grid->screen->faces[pieces->faces[i]].box;
            box->x0 = face->x0 < box->x0 ? face->x0 : box->x0;
            box->y0 = face->y0 < box->y0 ? face->y0 : box->y0;
            box->x1 = face->x1 > box->x1 ? face->x1 : box->x1;
            box->y1 = face->y1 > box->y1 ? face->y1 : box->y1;
        }
    }
}

/* Whether any face of one piece shares a pixel with one of another. */
static bool share_pixels(const Grid *grid, uint32_t one, uint32_t other)
{
    const Pieces *pieces = grid->mesh->pieces;
    for (uint32_t i = pieces->first[one]; i < pieces->first[one + 1]; i++) {
        const ScreenFace *a = &grid->screen->faces[pieces->faces[i]];
        if (!screen_boxes_meet(&a->box, &grid->boxes[other]))
            continue;
        for (uint32_t k = pieces->first[other]; k < pieces->first[other + 1]; k++) {
            const ScreenFace *b = &grid->screen->faces[pieces->faces[k]];
            if (screen_boxes_meet(&a->box, &b->box) && screen_faces_meet(grid->screen, a, b))
                return true;
        }
    }
    return false;
}

/* A piece and where it begins on the screen. */
typedef struct Begin {
    int32_t x;
    uint32_t piece;
} Begin;

static int compare_begins(const void *a, const void *b)
{
    const Begin *p = a, *q = b;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    return (p->piece > q->piece) - (p->piece < q->piece);
}

/* Goes over the screen from left to right, with all pieces that are there. */
static bool relate_all(Grid *grid)
{
    const uint32_t count = grid->mesh->pieces->count;
    Begin *begins = gp_alloc(count, sizeof *begins);
    uint32_t *active = gp_alloc(count, sizeof *active), active_count = 0, seen = 0;
    for (uint32_t p = 0; p < count && begins && active; p++) {
        pairs_add(&grid->edges, 2 * p, 2 * p + 1);
        if (grid->boxes[p].x0 < grid->boxes[p].x1)
            begins[seen++] = (Begin){ grid->boxes[p].x0, p };
    }
    if (seen > 0)
        qsort(begins, seen, sizeof *begins, compare_begins);
    for (uint32_t i = 0; i < seen; i++) {
        const ScreenBox *box = &grid->boxes[begins[i].piece];
        uint32_t left = 0;
        for (uint32_t k = 0; k < active_count; k++) {
            const ScreenBox *other = &grid->boxes[active[k]];
            if (other->x1 <= box->x0)
                continue;
            if (screen_boxes_meet(box, other) && share_pixels(grid, begins[i].piece, active[k]))
                relate(grid, begins[i].piece, active[k]);
            active[left++] = active[k];
        }
        active[left++] = begins[i].piece;
        active_count = left;
    }
    const bool done = begins && active;
    gp_free(begins);
    gp_free(active);
    return done;
}

/* --- the sequence ----------------------------------------------------------------------------- */

static double distance_of(const Grid *grid, uint32_t piece)
{
    const PieceSpan *span = &grid->mesh->spans[piece];
    double middle[3], from[3];
    for (int k = 0; k < 3; k++)
        middle[k] = (span->low[k] + span->high[k]) / 2;
    if (grid->is_parallel)
        return vector_dot(middle, grid->eye);
    vector_subtract(middle, grid->eye, from);
    return sqrt(vector_dot(from, from));
}

/* A node and how far it is. */
typedef struct Near {
    double distance;
    uint32_t node;
} Near;

static int compare_near(const void *a, const void *b)
{
    const Near *p = a, *q = b;
    if (p->distance != q->distance)
        return p->distance < q->distance ? -1 : 1;
    return (p->node > q->node) - (p->node < q->node);
}

/* All nodes, the nearest first. */
static bool list_nodes(const Grid *grid, uint32_t count, uint32_t *nodes)
{
    const Partings *partings = grid->partings;
    const uint32_t sides = 2 * grid->mesh->pieces->count;
    Near *near = gp_alloc(count, sizeof *near);
    for (uint32_t n = 0; n < count && near; n++)
        near[n] = (Near){ n < sides ? distance_of(grid, n / 2) : 0, n };
    for (uint32_t i = 0; i < partings->count && near; i++) {
        const Parting *slab = &partings->list[i];
        if (slab->slab != NO_SLAB)
            near[sides + slab->slab].distance =
                (near[2 * slab->low].distance + near[2 * slab->high].distance) / 2;
    }
    if (count > 0 && near)
        qsort(near, count, sizeof *near, compare_near);
    for (uint32_t n = 0; n < count && near; n++)
        nodes[n] = near[n].node;
    gp_free(near);
    return near;
}

static GpResult find_order(Grid *grid, const FragmentView *view, Order *order)
{
    const uint32_t pieces = grid->mesh->pieces->count;
    const uint32_t count = 2 * pieces + grid->partings->slab_count;
    Graph graph = { .count = 0 };
    uint32_t *nodes = gp_alloc(count, sizeof *nodes), *sequence = gp_alloc(count, sizeof *sequence);
    grid->boxes = gp_alloc(pieces, sizeof *grid->boxes);
    GpResult result = GP_ERROR_MEMORY;
    if (nodes && sequence && grid->boxes && list_nodes(grid, count, nodes)) {
        find_boxes(grid);
        result = relate_all(grid) ? graph_make(count, &grid->edges, &graph) : GP_ERROR_MEMORY;
    }
    if (!result)
        result = graph_sequence(&graph, nodes, sequence, &order->split_sides);
    if (!result)
        result = grid_levels(grid->mesh->pieces, grid->partings, view, grid->screen, sequence,
                             count, order);
    gp_free(nodes);
    gp_free(sequence);
    gp_free(grid->boxes);
    graph_free(&graph);
    return result;
}

GpResult order_by_grid(const OrderMesh *mesh, const Partings *partings, const FragmentView *view,
                       const Screen *screen, Order *order, GpError *error)
{
    Grid grid = {
        .mesh = mesh, .partings = partings, .screen = screen, .is_parallel = view->camera.fovy <= 0
    };
    Order made = { .level_count = 0 };
    if (grid.is_parallel) {
        const CameraAxes axes = camera_axes(&view->camera, 1);
        memcpy(grid.eye, axes.forward, sizeof grid.eye);
    } else {
        memcpy(grid.eye, view->camera.eye, sizeof grid.eye);
    }
    const GpResult result = find_order(&grid, view, &made);
    pairs_free(&grid.edges);
    if (result) {
        order_free(&made);
        return gp_fail(error, result, "out of memory");
    }
    *order = made;
    return GP_OK;
}
