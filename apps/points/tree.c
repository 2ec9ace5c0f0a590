#include "apps/points/tree.h"

#include "apps/base/symmetric.h"
#include "apps/base/vector.h"
#include "apps/points/cloud/median.h"

#include <stdlib.h>

enum {
    TASK_DEPTH = 8, /* nodes above are parted one depth at a time, below a thread does all of one */
    TASKS_AT_ONCE = 16 /* between two words to the listener */
};

typedef struct Builder {
    const Surfels *surfels;
    MedianItem *items;
    uint32_t *order;
    int depth;      /* of the whole tree */
    int task_depth; /* of the nodes that are parted now */
    uint32_t first_task;
} Builder;

/* --- nodes ------------------------------------------------------------------------------------ */

/* Parts a node's leaves into those of its children. */
static void divide(const Builder *builder, int depth, uint64_t node)
{
    const uint32_t leaves = builder->surfels->count;
    const uint32_t begin = tree_bound(leaves, depth, node);
    const uint32_t middle = tree_bound(leaves, depth + 1, 2 * node + 1);
    const uint32_t count = tree_bound(leaves, depth, node + 1) - begin;
    MedianItem *items = builder->items + begin;
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
    median_part(items, count, middle - begin);
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
            (MedianItem){ .position = { position[0], position[1], position[2] }, .surfel = i };
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
