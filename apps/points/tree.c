#include "apps/points/tree.h"

#include "apps/base/symmetric.h"
#include "apps/base/vector.h"

#include <stdlib.h>

enum {
    TASK_DEPTH = 8, /* nodes above are parted one depth at a time, below a thread does all of one */
    TASKS_AT_ONCE = 16, /* between two words to the listener */
    MOST_SAMPLES = 31
};

typedef struct Item {
    float key; /* along the axis */
    float position[3];
    uint32_t surfel;
} Item;

typedef struct Builder {
    const Surfels *surfels;
    Item *items;
    uint32_t *order;
    int depth;      /* of the whole tree */
    int task_depth; /* of the nodes that are parted now */
    uint32_t first_task;
} Builder;

int tree_depth(uint32_t leaves)
{
    int depth = -1;
    while (leaves >= 4u << (depth + 1) && depth < 29)
        depth++;
    return depth;
}

/* --- the median ------------------------------------------------------------------------------- */

/* A total order: which half an item is in does not depend on how the median is found. */
static inline bool before(const Item *a, const Item *b)
{
    return a->key < b->key || (a->key == b->key && a->surfel < b->surfel);
}

/* An item of about that rank, from a sample. */
static Item item_near(const Item *items, uint32_t count, uint32_t rank)
{
    Item sample[MOST_SAMPLES];
    const uint32_t samples = count > 1024 ? MOST_SAMPLES : count > 64 ? 7 : 3;
    for (uint32_t i = 0; i < samples; i++) {
        const Item item = items[(uint64_t)count * (2 * i + 1) / (2 * samples)];
        uint32_t at = i;
        for (; at > 0 && before(&item, &sample[at - 1]); at--)
            sample[at] = sample[at - 1];
        sample[at] = item;
    }
    const uint32_t which = (uint32_t)((uint64_t)rank * samples / count);
    return sample[which < samples ? which : samples - 1];
}

/* Puts the `first` items that come first in front, 0 < first < count (Hoare's find). */
static void part(Item *items, uint32_t count, uint32_t first)
{
    uint32_t low = 0, high = count; /* before low and from high on all is in place */
    while (high - low > 1) {
        const Item pivot = item_near(items + low, high - low, first - low);
        uint32_t i = low,
                 end = high; /* [low, i) are not behind the pivot, [end, high) not before */
        while (i < end) {
            while (before(&items[i], &pivot))
                i++;
            while (before(&pivot, &items[end - 1]))
                end--;
            if (i >= end)
                break;
            const Item swap = items[i];
            items[i++] = items[--end];
            items[end] = swap;
        }
        if (first < end)
            high = end;
        else if (first > i)
            low = i;
        else
            return;
    }
}

/* --- nodes ------------------------------------------------------------------------------------ */

/* Parts a node's leaves into those of its children. */
static void divide(const Builder *builder, int depth, uint64_t node)
{
    const uint32_t leaves = builder->surfels->count;
    const uint32_t begin = tree_bound(leaves, depth, node);
    const uint32_t middle = tree_bound(leaves, depth + 1, 2 * node + 1);
    const uint32_t count = tree_bound(leaves, depth, node + 1) - begin;
    Item *items = builder->items + begin;
    Moments moments = { .origin = { (double)items->position[0], (double)items->position[1],
                                    (double)items->position[2] } };
    for (uint32_t i = 0; i < count; i++)
        moments_add(&moments, items[i].position);
    const Symmetric covariance = moments_covariance(&moments);
    double axis[3];
    symmetric_long_axis(&covariance, axis);
    for (uint32_t i = 0; i < count; i++) {
        const double from[3] = { (double)items[i].position[0] - moments.origin[0],
                                 (double)items[i].position[1] - moments.origin[1],
                                 (double)items[i].position[2] - moments.origin[2] };
        items[i].key = (float)vector_dot(axis, from);
    }
    part(items, count, middle - begin);
}

static void divide_all(const Builder *builder, int depth, uint64_t node)
{
    if (depth == builder->depth)
        return;
    divide(builder, depth, node);
    divide_all(builder, depth + 1, 2 * node);
    divide_all(builder, depth + 1, 2 * node + 1);
}

static void divide_node(void *context, uint32_t item, int worker)
{
    const Builder *builder = context;
    (void)worker;
    divide(builder, builder->task_depth, item);
}

static int compare_numbers(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

/* A node with all below it, whose leaves are then in their order. */
static void divide_task(void *context, uint32_t item, int worker)
{
    const Builder *builder = context;
    const uint32_t leaves = builder->surfels->count;
    const uint64_t task = builder->first_task + item;
    (void)worker;
    divide_all(builder, builder->task_depth, task);
    const int below = builder->depth - builder->task_depth;
    for (uint64_t node = task << below; node < (task + 1) << below; node++) {
        const uint32_t begin = tree_bound(leaves, builder->depth, node);
        const uint32_t end = tree_bound(leaves, builder->depth, node + 1);
        for (uint32_t i = begin; i < end; i++)
            builder->order[i] = builder->items[i].surfel;
        qsort(builder->order + begin, end - begin, sizeof *builder->order, compare_numbers);
    }
}

/* --- all -------------------------------------------------------------------------------------- */

GpResult tree_order(const Surfels *surfels, GpPool *pool, const PointsListener *listener,
                    uint32_t *order)
{
    Builder builder = { .surfels = surfels, .order = order, .depth = tree_depth(surfels->count) };
    for (uint32_t i = 0; i < surfels->count && builder.depth < 1; i++)
        order[i] = i;
    if (builder.depth < 1)
        return GP_OK;
    builder.items = gp_alloc_unset(surfels->count * sizeof *builder.items);
    if (!builder.items)
        return GP_ERROR_MEMORY;
    for (uint32_t i = 0; i < surfels->count; i++) {
        const float *position = surfels->surfels[i].position;
        builder.items[i] =
            (Item){ .position = { position[0], position[1], position[2] }, .surfel = i };
    }
    const int above = builder.depth < TASK_DEPTH ? builder.depth : TASK_DEPTH;
    const uint32_t tasks = 1u << above, total = (uint32_t)above + tasks;
    for (; builder.task_depth < above; builder.task_depth++) {
        points_tell(listener, (uint32_t)builder.task_depth, total, "tree");
        gp_pool_run(pool, 1u << builder.task_depth, divide_node, &builder);
    }
    for (; builder.first_task < tasks; builder.first_task += TASKS_AT_ONCE) {
        const uint32_t left = tasks - builder.first_task;
        points_tell(listener, (uint32_t)above + builder.first_task, total, "tree");
        gp_pool_run(pool, left < TASKS_AT_ONCE ? left : TASKS_AT_ONCE, divide_task, &builder);
    }
    points_tell(listener, total, total, "tree");
    gp_free(builder.items);
    return GP_OK;
}
