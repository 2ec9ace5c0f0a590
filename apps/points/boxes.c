#include "apps/points/boxes.h"

#include "apps/base/symmetric.h"

#include <float.h>
#include <string.h>

static void widen(const float from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = (double)from[i];
}

/* --- building --------------------------------------------------------------------------------- */

static void corner_of(const PatchBox *box, int number, float corner[3])
{
    double at[3], axis[3];
    widen(box->centre, at);
    for (int i = 0; i < 3; i++) {
        widen(box->axes[i], axis);
        vector_add_scaled(at, (number >> i & 1 ? 1 : -1) * (double)box->half[i], axis, at);
    }
    for (int i = 0; i < 3; i++)
        corner[i] = (float)at[i];
}

/* The box along the axes of the corners' spread that holds the boxes of patches. */
static PatchBox box_of(const Patch *patches, uint32_t count)
{
    Moments moments = { .count = 0 };
    double values[3], axes[3][3], low[3], high[3], size = 0;
    PatchBox box;
    widen(patches->box.centre, moments.origin);
    for (uint32_t i = 0; i < 8 * count; i++) {
        float corner[3];
        corner_of(&patches[i / 8].box, (int)(i % 8), corner);
        moments_add(&moments, corner);
    }
    const Symmetric covariance = moments_covariance(&moments);
    symmetric_eigen(&covariance, values, axes);
    for (int k = 0; k < 3; k++) {
        low[k] = DBL_MAX;
        high[k] = -DBL_MAX;
    }
    for (uint32_t i = 0; i < 8 * count; i++) {
        float corner[3];
        double from[3];
        corner_of(&patches[i / 8].box, (int)(i % 8), corner);
        widen(corner, from);
        vector_subtract(from, moments.origin, from);
        for (int k = 0; k < 3; k++) {
            const double along = vector_dot(axes[k], from);
            low[k] = along < low[k] ? along : low[k];
            high[k] = along > high[k] ? along : high[k];
        }
    }
    double centre[3] = { moments.origin[0], moments.origin[1], moments.origin[2] };
    for (int k = 0; k < 3; k++) {
        vector_add_scaled(centre, 0.5 * (low[k] + high[k]), axes[k], centre);
        size += high[k] - low[k];
    }
    for (int k = 0; k < 3; k++) {
        /* Roundings of corners, centre and axes: a few parts in ten million of size and place. */
        const double slack = 1e-6 * size + 4e-7 * vector_extent(centre);
        box.centre[k] = (float)centre[k];
        box.half[k] = (float)(0.5 * (high[k] - low[k]) + slack);
        for (int i = 0; i < 3; i++)
            box.axes[k][i] = (float)axes[k][i];
    }
    return box;
}

static void add_node(const Patches *patches, uint32_t first, uint32_t count, BoxTree *tree)
{
    const uint32_t at = tree->node_count++;
    BoxNode *node = &tree->nodes[at];
    *node = (BoxNode){ .first = first, .count = count, .least_radius = FLT_MAX };
    node->box = count == 1 ? patches->patches[first].box : box_of(patches->patches + first, count);
    for (uint32_t i = first; i < first + count; i++) {
        const Patch *patch = &patches->patches[i];
        const PatchLevel *leaves = patch_levels(patches, patch) + patch->level_count - 1;
        if (leaves->least_radius < node->least_radius)
            node->least_radius = leaves->least_radius;
        if (leaves->most_radius > node->most_radius)
            node->most_radius = leaves->most_radius;
    }
    if (count > 1) {
        add_node(patches, first, count / 2, tree);
        add_node(patches, first + count / 2, count - count / 2, tree);
    }
    node->next = tree->node_count;
}

GpResult box_tree_build(const Patches *patches, BoxTree *tree)
{
    BoxTree made = { .nodes = gp_alloc(2 * (size_t)patches->patch_count, sizeof *made.nodes) };
    if (!made.nodes)
        return GP_ERROR_MEMORY;
    add_node(patches, 0, patches->patch_count, &made);
    *tree = made;
    return GP_OK;
}

void box_tree_free(BoxTree *tree)
{
    gp_free(tree->nodes);
    *tree = (BoxTree){ .nodes = NULL };
}

/* --- classes ---------------------------------------------------------------------------------- */

int box_class_by_distance(const void *user, const PointView *view, const BoxNode *node,
                          const BoxPlace *place)
{
    const DistanceRule *rule = user;
    const double per_pixel = view->pixels / rule->low_pass;
    const double nearest = place->nearest > view->near ? place->nearest : view->near;
    if (view->is_parallel)
        return 2;
    if (place->farthest < rule->near * per_pixel * (double)node->least_radius)
        return 0;
    if (nearest > rule->far * per_pixel * (double)node->most_radius)
        return 1;
    /* Both filters for all, or only for some: then halves are asked. */
    const bool is_both = nearest >= rule->near * per_pixel * (double)node->most_radius &&
                         place->farthest <= rule->far * per_pixel * (double)node->least_radius;
    return is_both ? 2 : -1;
}

uint32_t box_tree_classify(const BoxTree *tree, const Patches *patches, const PointView *view,
                           BoxClassFn classify, const void *user, int undecided, int8_t *class_of)
{
    uint32_t looked_at = 0;
    memset(class_of, -1, patches->patch_count * sizeof *class_of);
    for (uint32_t at = 0; at < tree->node_count;) {
        const BoxNode *node = &tree->nodes[at];
        const BoxPlace place = box_place(view, &node->box);
        looked_at++;
        if (!box_is_seen(view, &place, (double)node->most_radius)) {
            at = node->next;
            continue;
        }
        int found = classify(user, view, node, &place);
        if (found < 0 && node->count == 1)
            found = undecided;
        if (found >= 0)
            for (uint32_t i = node->first; i < node->first + node->count; i++)
                class_of[i] = (int8_t)found;
        at = found >= 0 ? node->next : at + 1;
    }
    return looked_at;
}
