#include "apps/points/cloud/neighbours.h"

#include "apps/points/cloud/median.h"
#include "apps/points/cloud/complete_tree.h"

#include <math.h>
#include <string.h>

enum { TASK_DEPTH = 8 };

typedef struct NeighbourNode {
    float low, high; /* along the axis: the last of the first half, the first of the second */
    uint8_t axis;
} NeighbourNode;

typedef struct Builder {
    NeighbourTree *tree;
    MedianItem *items;
    int depth; /* of the nodes that are parted now */
} Builder;

/* Nodes of a depth follow those above. */
static NeighbourNode *node_at(const NeighbourTree *tree, int depth, uint64_t node)
{
    return &tree->nodes[((uint64_t)1 << depth) - 1 + node];
}

static uint8_t longest_side(const MedianItem *items, uint32_t count)
{
    float low[3], high[3];
    memcpy(low, items->position, sizeof low);
    memcpy(high, items->position, sizeof high);
    for (uint32_t i = 1; i < count; i++) {
        for (int k = 0; k < 3; k++) {
            const float at = items[i].position[k];
            low[k] = at < low[k] ? at : low[k];
            high[k] = at > high[k] ? at : high[k];
        }
    }
    uint8_t axis = 0;
    for (uint8_t k = 1; k < 3; k++) {
        if ((double)high[k] - (double)low[k] > (double)high[axis] - (double)low[axis])
            axis = k;
    }
    return axis;
}

static void divide(const Builder *builder, int depth, uint64_t node)
{
    const uint32_t begin = tree_bound(builder->tree->count, depth, node);
    const uint32_t middle = tree_bound(builder->tree->count, depth + 1, 2 * node + 1) - begin;
    const uint32_t count = tree_bound(builder->tree->count, depth, node + 1) - begin;
    MedianItem *items = builder->items + begin;
    NeighbourNode *to = node_at(builder->tree, depth, node);
    const uint8_t axis = longest_side(items, count);
    for (uint32_t i = 0; i < count; i++)
        items[i].key = items[i].position[axis];
    median_part(items, count, middle);
    *to = (NeighbourNode){ .low = items[0].key, .high = items[middle].key, .axis = axis };
    for (uint32_t i = 1; i < middle; i++)
        to->low = items[i].key > to->low ? items[i].key : to->low;
    for (uint32_t i = middle + 1; i < count; i++)
        to->high = items[i].key < to->high ? items[i].key : to->high;
}

static void divide_all(const Builder *builder, int depth, uint64_t node)
{
    if (depth == builder->tree->depth)
        return;
    divide(builder, depth, node);
    divide_all(builder, depth + 1, 2 * node);
    divide_all(builder, depth + 1, 2 * node + 1);
}

static void divide_node(void *context, uint32_t item, int worker)
{
    const Builder *builder = context;
    (void)worker;
    divide(builder, builder->depth, item);
}

static void divide_below(void *context, uint32_t item, int worker)
{
    const Builder *builder = context;
    (void)worker;
    divide_all(builder, builder->depth, item);
}

GpResult neighbour_tree_build(const float *positions, uint32_t count, GpPool *pool,
                              NeighbourTree *tree)
{
    const int depth = tree_depth(count) - 1; /* 8 to 16 points in each */
    NeighbourTree made = { .positions = gp_alloc_unset(3 * (size_t)count * sizeof(float)),
                           .numbers = gp_alloc_unset(count * sizeof(uint32_t)),
                           .count = count,
                           .depth = depth > 0 ? depth : 0 };
    made.nodes = gp_alloc_unset(sizeof(NeighbourNode) << made.depth);
    MedianItem *items = gp_alloc_unset(count * sizeof *items);
    if (!made.positions || !made.numbers || !made.nodes || !items) {
        neighbour_tree_free(&made);
        gp_free(items);
        return GP_ERROR_MEMORY;
    }
    for (uint32_t i = 0; i < count; i++) {
        items[i].surfel = i;
        memcpy(items[i].position, positions + 3 * (size_t)i, sizeof items[i].position);
    }
    Builder builder = { .tree = &made, .items = items };
    for (; builder.depth < made.depth && builder.depth < TASK_DEPTH; builder.depth++)
        gp_pool_run(pool, 1u << builder.depth, divide_node, &builder);
    gp_pool_run(pool, 1u << builder.depth, divide_below, &builder);
    for (uint32_t i = 0; i < count; i++) {
        made.numbers[i] = items[i].surfel;
        memcpy(made.positions + 3 * (size_t)i, items[i].position, sizeof items[i].position);
    }
    gp_free(items);
    *tree = made;
    return GP_OK;
}

void neighbour_tree_free(NeighbourTree *tree)
{
    gp_free(tree->positions);
    gp_free(tree->numbers);
    gp_free(tree->nodes);
    *tree = (NeighbourTree){ .count = 0 };
}

/* --- search ----------------------------------------------------------------------------------- */

enum { MOST_IN_LEAF = 16 };

typedef struct Search {
    const NeighbourTree *tree;
    double place[3];
    uint32_t rank, most, count;
    double limit; /* nothing beyond is sought */
    Neighbour *found;
} Search;

static double distance2_to(const Search *search, uint32_t rank)
{
    const float *position = search->tree->positions + 3 * (size_t)rank;
    const double x = (double)position[0] - search->place[0];
    const double y = (double)position[1] - search->place[1];
    const double z = (double)position[2] - search->place[2];
    return x * x + y * y + z * z;
}

static bool comes_first(const NeighbourTree *tree, const Neighbour *a, const Neighbour *b)
{
    return a->distance2 < b->distance2 ||
           (a->distance2 == b->distance2 && tree->numbers[a->rank] < tree->numbers[b->rank]);
}

static void offer(Search *search, const Neighbour *offered)
{
    Neighbour *found = search->found;
    const bool is_full = search->count == search->most;
    if (is_full && !comes_first(search->tree, offered, &found[search->count - 1]))
        return;
    uint32_t at = is_full ? search->count - 1 : search->count++;
    for (; at > 0 && comes_first(search->tree, offered, &found[at - 1]); at--)
        found[at] = found[at - 1];
    found[at] = *offered;
    if (search->count == search->most)
        search->limit = found[search->most - 1].distance2;
}

/* Those within the limit first, without a branch: which they are is hard to foresee. */
static void search_leaf(Search *search, uint32_t rank, uint32_t end)
{
    Neighbour within[MOST_IN_LEAF];
    uint32_t count = 0;
    for (; rank < end; rank++) {
        within[count] = (Neighbour){ .distance2 = distance2_to(search, rank), .rank = rank };
        count += (within[count].distance2 <= search->limit) & (rank != search->rank);
    }
    for (uint32_t i = 0; i < count; i++)
        offer(search, &within[i]);
}

/* A node that may hold some. */
typedef struct Waiting {
    double away[3]; /* along each axis, how far the place is from the node's box */
    /* the sum of their squares, which rounding may have made a little too large */
    double distance2;
    uint32_t node;
    int depth;
} Waiting;

static bool is_beyond(const Search *search, double distance2)
{
    return distance2 * (1 - 1e-12) > search->limit;
}

/* Goes to the half that is nearer. other: becomes the other */
static void descend(const Search *search, Waiting *at, Waiting *other)
{
    const NeighbourNode *parted = node_at(search->tree, at->depth, at->node);
    const uint8_t axis = parted->axis;
    const double to_second = (double)parted->high - search->place[axis];
    const double to_first = search->place[axis] - (double)parted->low;
    const bool second_is_near = to_second < to_first;
    const double step = second_is_near ? to_first : to_second;
    *other = *at;
    other->away[axis] = step > at->away[axis] ? step : at->away[axis];
    other->distance2 = other->away[0] * other->away[0] + other->away[1] * other->away[1] +
                       other->away[2] * other->away[2];
    other->node = 2 * at->node + !second_is_near;
    other->depth = ++at->depth;
    at->node = 2 * at->node + second_is_near;
}

static void search_tree(Search *search)
{
    const NeighbourTree *tree = search->tree;
    Waiting stack[32];
    stack[0] = (Waiting){ .depth = 0 };
    for (int count = 1; count > 0;) {
        Waiting at = stack[--count];
        if (is_beyond(search, at.distance2))
            continue;
        while (at.depth < tree->depth) {
            descend(search, &at, &stack[count]);
            count += !is_beyond(search, stack[count].distance2);
        }
        search_leaf(search, tree_bound(tree->count, at.depth, at.node),
                    tree_bound(tree->count, at.depth, (uint64_t)at.node + 1));
    }
}

/* As many points as are sought are no farther: those of the rank before, but for that rank itself
 * in the place of this one. */
static double known_limit(const Search *search)
{
    double limit = 0;
    for (uint32_t i = 0; i < search->most; i++) {
        const uint32_t rank = search->found[i].rank;
        const double distance2 = distance2_to(search, rank == search->rank ? rank - 1 : rank);
        limit = distance2 > limit ? distance2 : limit;
    }
    return limit;
}

uint32_t neighbours_of(const NeighbourTree *tree, uint32_t rank, uint32_t most, uint32_t known,
                       Neighbour *found)
{
    const float *place = tree->positions + 3 * (size_t)rank;
    Search search = { .tree = tree,
                      .place = { (double)place[0], (double)place[1], (double)place[2] },
                      .rank = rank,
                      .most = most,
                      .limit = (double)INFINITY,
                      .found = found };
    if (most > 0 && known == most)
        search.limit = known_limit(&search);
    if (most > 0)
        search_tree(&search);
    return search.count;
}
