#include "apps/truth/ray_tree.h"

enum {
    BINS = 16,
    /* Below this depth lists are halved, which takes 32 more levels at most. */
    CUT_DEPTH = TRUTH_TREE_DEPTH - 32
};

typedef struct Item {
    Bounds box;
    double centre[3];
    uint32_t triangle;
} Item;

typedef struct Builder {
    Item *items;
    TruthNode *nodes;
    uint32_t node_count;
} Builder;

/* Between bins `bin` - 1 and `bin`, of BINS from low to high. */
typedef struct Cut {
    int axis, bin;
    double low, high, cost;
} Cut;

/* Half the surface; of an empty box 0. */
static double box_area(const Bounds *box)
{
    double size[3];
    vector_subtract(box->high, box->low, size);
    return size[0] < 0 ? 0 : size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

static Item make_item(const TruthTriangle *triangle, uint32_t number)
{
    Item item = { .box = bounds_of_nothing, .triangle = number };
    for (int i = 0; i < 3; i++)
        bounds_add(&item.box, triangle->corner[i]);
    for (int i = 0; i < 3; i++)
        item.centre[i] = 0.5 * item.box.low[i] + 0.5 * item.box.high[i];
    return item;
}

static int bin_of(const Cut *cut, const Item *item)
{
    int bin = (int)((item->centre[cut->axis] - cut->low) / (cut->high - cut->low) * BINS);
    return bin < BINS ? bin : BINS - 1;
}

/* Takes the best bin on the cut's axis, if any is better than the best so far. */
static void try_axis(const Item *items, uint32_t count, Cut cut, Cut *best)
{
    Bounds box[BINS];
    uint32_t size[BINS] = { 0 };
    for (int i = 0; i < BINS; i++)
        box[i] = bounds_of_nothing;
    for (uint32_t i = 0; i < count; i++) {
        int bin = bin_of(&cut, &items[i]);
        bounds_join(&box[bin], &items[i].box);
        size[bin]++;
    }
    double high_cost[BINS];
    Bounds high = bounds_of_nothing, low = bounds_of_nothing;
    uint32_t high_size = 0, low_size = 0;
    for (int i = BINS - 1; i > 0; i--) {
        bounds_join(&high, &box[i]);
        high_size += size[i];
        high_cost[i] = box_area(&high) * high_size;
    }
    for (cut.bin = 1; cut.bin < BINS; cut.bin++) {
        bounds_join(&low, &box[cut.bin - 1]);
        low_size += size[cut.bin - 1];
        cut.cost = box_area(&low) * low_size + high_cost[cut.bin];
        if (low_size > 0 && low_size < count && cut.cost < best->cost)
            *best = cut;
    }
}

static uint32_t partition(Item *items, uint32_t count, const Cut *cut)
{
    uint32_t low = 0;
    for (uint32_t i = 0; i < count; i++)
        if (bin_of(cut, &items[i]) < cut->bin) {
            Item item = items[i];
            items[i] = items[low];
            items[low++] = item;
        }
    return low;
}

/* Puts the items of the low side first and returns their number, between 1 and count - 1. */
static uint32_t divide(Item *items, uint32_t count, int depth, uint32_t *axis)
{
    Bounds centres = bounds_of_nothing;
    for (uint32_t i = 0; i < count; i++)
        bounds_add(&centres, items[i].centre);
    Cut best = { .cost = HUGE_VAL };
    for (int i = 0; i < 3 && depth < CUT_DEPTH; i++)
        if (centres.high[i] > centres.low[i])
            try_axis(items, count,
                     (Cut){ .axis = i, .low = centres.low[i], .high = centres.high[i] }, &best);
    *axis = (uint32_t)best.axis;
    return best.cost < HUGE_VAL ? partition(items, count, &best) : count / 2;
}

static void build(Builder *builder, uint32_t node, uint32_t first, uint32_t count, int depth)
{
    TruthNode *made = &builder->nodes[node];
    Item *items = builder->items + first;
    *made = (TruthNode){ .box = bounds_of_nothing, .first = first, .count = count };
    for (uint32_t i = 0; i < count; i++)
        bounds_join(&made->box, &items[i].box);
    if (count <= TRUTH_LEAF_SIZE)
        return;
    uint32_t low = divide(items, count, depth, &made->axis);
    made->count = 0;
    made->first = builder->node_count;
    builder->node_count += 2;
    build(builder, made->first, first, low, depth + 1);
    build(builder, made->first + 1, first + low, count - low, depth + 1);
}

GpResult truth_tree_build(const TruthTriangle *triangles, uint32_t count, uint32_t *order,
                          TruthNode *nodes)
{
    Builder builder = { gp_alloc(count, sizeof *builder.items), nodes, 1 };
    if (!builder.items)
        return GP_ERROR_MEMORY;
    for (uint32_t i = 0; i < count; i++)
        builder.items[i] = make_item(&triangles[i], i);
    build(&builder, 0, 0, count, 0);
    for (uint32_t i = 0; i < count; i++)
        order[i] = builder.items[i].triangle;
    gp_free(builder.items);
    return GP_OK;
}
