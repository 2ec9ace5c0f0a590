#include "apps/fragments/order/relations.h"

#include "apps/fragments/order/front.h"

#include <stdlib.h>
#include <string.h>

/* Faces in the order of their pieces, BLOCK by BLOCK, are the leaves of a complete binary tree:
 * node n has the children 2n and 2n + 1, and the root is 1. */
enum { BLOCK = 4, MANY = UINT32_MAX };

typedef struct Node {
    ScreenBox box;
    uint32_t piece; /* that it is all of; MANY: of several */
} Node;

typedef struct Search {
    const OrderMesh *mesh;
    const Pieces *pieces;
    const Screen *screen;
    FrontView view;
    Node *nodes;
    uint32_t leaves; /* a power of two; leaf i is node leaves + i */
    Relations *relations;
} Search;

/* --- the tree --------------------------------------------------------------------------------- */

static void join_boxes(ScreenBox *box, const ScreenBox *other)
{
    box->x0 = other->x0 < box->x0 ? other->x0 : box->x0;
    box->y0 = other->y0 < box->y0 ? other->y0 : box->y0;
    box->x1 = other->x1 > box->x1 ? other->x1 : box->x1;
    box->y1 = other->y1 > box->y1 ? other->y1 : box->y1;
}

static Node empty_node(void)
{
    return (Node){ { INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN }, MANY };
}

static void fill_leaf(const Search *search, uint32_t leaf, Node *node)
{
    const Pieces *pieces = search->pieces;
    const uint32_t begin = leaf * BLOCK;
    *node = empty_node();
    for (uint32_t i = begin; i < begin + BLOCK && i < pieces->face_count; i++) {
        const uint32_t face = pieces->faces[i], piece = pieces->piece_of[face];
        join_boxes(&node->box, &search->screen->faces[face].box);
        node->piece = i == begin || node->piece == piece ? piece : MANY;
    }
}

static bool make_tree(Search *search)
{
    search->leaves = 1;
    while (search->leaves * BLOCK < search->pieces->face_count)
        search->leaves *= 2;
    search->nodes = gp_alloc_unset(2 * (size_t)search->leaves * sizeof *search->nodes);
    if (!search->nodes)
        return false;
    for (uint32_t i = 0; i < search->leaves; i++)
        fill_leaf(search, i, &search->nodes[search->leaves + i]);
    for (uint32_t n = search->leaves - 1; n > 0; n--) {
        const Node *left = &search->nodes[2 * n], *right = &search->nodes[2 * n + 1];
        search->nodes[n] = *left;
        join_boxes(&search->nodes[n].box, &right->box);
        if (left->piece != right->piece)
            search->nodes[n].piece = MANY;
    }
    return true;
}

/* --- pairs ------------------------------------------------------------------------------------ */

/* Which of two pieces can be in front of the other, by planes across the axes. */
static unsigned front_by_spans(const Search *search, uint32_t a, uint32_t b)
{
    const PieceSpan *one = &search->mesh->spans[a], *other = &search->mesh->spans[b];
    unsigned order = FRONT_FIRST | FRONT_SECOND;
    for (int k = 0; k < ORDER_AXES; k++) {
        const double eye = vector_dot(order_axes[k], search->view.eye);
        const bool rising = search->view.is_parallel && eye >= 0;
        const bool falling = search->view.is_parallel && eye <= 0;
        const bool perspective = !search->view.is_parallel;
        if (one->high[k] <= other->low[k]) {
            if (rising || (perspective && eye <= other->low[k]))
                order &= ~(unsigned)FRONT_SECOND;
            if (falling || (perspective && eye >= one->high[k]))
                order &= ~(unsigned)FRONT_FIRST;
        } else if (other->high[k] <= one->low[k]) {
            if (rising || (perspective && eye <= one->low[k]))
                order &= ~(unsigned)FRONT_FIRST;
            if (falling || (perspective && eye >= other->high[k]))
                order &= ~(unsigned)FRONT_SECOND;
        }
    }
    return order;
}

/* Whether two parts need not be looked at: of one large piece, or of two that are ordered as a
 * whole. */
static bool is_settled(Search *search, const Node *a, const Node *b)
{
    if (a->piece == MANY || b->piece == MANY || !order_is_large(search->pieces, a->piece))
        return false;
    if (a->piece == b->piece)
        return true;
    if (!order_is_large(search->pieces, b->piece))
        return false;
    const unsigned order = front_by_spans(search, a->piece, b->piece);
    if (order == (FRONT_FIRST | FRONT_SECOND))
        return false;
    if (order == FRONT_FIRST)
        pairs_add(&search->relations->pieces, a->piece, b->piece);
    else if (order == FRONT_SECOND)
        pairs_add(&search->relations->pieces, b->piece, a->piece);
    return true;
}

static void relate_faces(Search *search, uint32_t a, uint32_t b)
{
    const Pieces *pieces = search->pieces;
    const ScreenFace *one = &search->screen->faces[a], *other = &search->screen->faces[b];
    const bool together = pieces->piece_of[a] == pieces->piece_of[b];
    if (!screen_boxes_meet(&one->box, &other->box) ||
        (together && one->is_turned == other->is_turned) ||
        !screen_faces_meet(search->screen, one, other))
        return;
    unsigned order = 0;
    if (together)
        order = relations_is_far(pieces, search->screen, b) ? FRONT_FIRST : FRONT_SECOND;
    else
        order = front_of_two(&search->view, a, b);
    if (order & FRONT_FIRST)
        pairs_add(&search->relations->faces, a, b);
    if (order & FRONT_SECOND)
        pairs_add(&search->relations->faces, b, a);
}

static void relate_leaves(Search *search, uint32_t a, uint32_t b)
{
    const Pieces *pieces = search->pieces;
    const uint32_t first = a - search->leaves, second = b - search->leaves;
    for (uint32_t i = first * BLOCK; i < (first + 1) * BLOCK && i < pieces->face_count; i++)
        for (uint32_t k = a == b ? i + 1 : second * BLOCK;
             k < (second + 1) * BLOCK && k < pieces->face_count; k++)
            relate_faces(search, pieces->faces[i], pieces->faces[k]);
}

/* Two nodes of one height. */
static void relate(Search *search, uint32_t a, uint32_t b)
{
    const Node *one = &search->nodes[a], *other = &search->nodes[b];
    if (!screen_boxes_meet(&one->box, &other->box) || is_settled(search, one, other))
        return;
    if (a >= search->leaves) {
        relate_leaves(search, a, b);
        return;
    }
    relate(search, 2 * a, 2 * b);
    relate(search, 2 * a, 2 * b + 1);
    if (a != b)
        relate(search, 2 * a + 1, 2 * b);
    relate(search, 2 * a + 1, 2 * b + 1);
}

/* --- the whole -------------------------------------------------------------------------------- */

static int compare_pairs(const void *a, const void *b)
{
    return memcmp(a, b, 2 * sizeof(uint32_t));
}

/* Pieces are met part by part, and so often more than once. */
static void leave_out_repeated(Pairs *edges)
{
    size_t count = 0;
    if (edges->count > 0)
        qsort(edges->pair, edges->count, sizeof *edges->pair, compare_pairs);
    for (size_t i = 0; i < edges->count; i++)
        if (i == 0 || compare_pairs(edges->pair[i], edges->pair[i - 1]) != 0)
            memmove(edges->pair[count++], edges->pair[i], sizeof *edges->pair);
    edges->count = count;
}

GpResult relations_find(const OrderMesh *mesh, const Camera *camera, const Screen *screen,
                        Relations *relations, GpError *error)
{
    Relations found = { .faces = { NULL, 0, 0, false } };
    Search search = { .mesh = mesh,
                      .pieces = mesh->pieces,
                      .screen = screen,
                      .view = front_view(mesh->mesh, (const double(*)[4])mesh->planes, mesh->doubt,
                                         camera),
                      .relations = &found };
    const bool done = make_tree(&search);
    if (done)
        relate(&search, 1, 1);
    gp_free(search.nodes);
    leave_out_repeated(&found.pieces);
    if (!done || found.faces.failed || found.pieces.failed) {
        relations_free(&found);
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    }
    *relations = found;
    return GP_OK;
}

void relations_free(Relations *relations)
{
    pairs_free(&relations->faces);
    pairs_free(&relations->pieces);
}
