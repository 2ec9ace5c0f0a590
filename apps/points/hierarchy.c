#include "apps/points/hierarchy.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* --- walking ---------------------------------------------------------------------------------- */

typedef struct Walk {
    const Patches *patches;
    const PointView *view;
    double per_radius; /* depth at which a radius of 1 is as wide as the detail */
    HierarchyCut *cut;
} Walk;

/* Of a node's ball. */
static bool ball_is_seen(const PointView *view, const double place[3], double depth, double radius)
{
    if (depth + radius < view->near || depth - radius > view->far)
        return false;
    for (int i = 0; i < 4; i++)
        if (vector_dot(view->sides[i], place) - view->side_offset[i] > radius)
            return false;
    return true;
}

/* A level of a patch and a range of its nodes. */
static void walk_nodes(const Walk *walk, const Patch *patch, uint32_t level, uint32_t first,
                       uint32_t end)
{
    const PatchLevel *levels = patch_levels(walk->patches, patch);
    const bool is_leaf = level + 1 == patch->level_count;
    for (uint32_t i = first; i < end; i++) {
        const Surfel *node = &walk->patches->surfels[levels[level].first + i];
        const double radius = (double)node->radius;
        double place[3], from[3];
        for (int k = 0; k < 3; k++)
            place[k] = (double)node->position[k];
        vector_subtract(place, walk->view->eye, from);
        const double depth = vector_dot(walk->view->axes.forward, from);
        if (!ball_is_seen(walk->view, place, depth, radius))
            continue;
        if (is_leaf || depth >= radius * walk->per_radius)
            walk->cut->surfels[walk->cut->count++] = *node;
        else
            walk_nodes(walk, patch, level + 1, patch_child(walk->patches, patch, level, i),
                       patch_child(walk->patches, patch, level, i + 1));
    }
}

/* Depth at which a disc of radius 1 is `detail` pixels wide. */
static double depth_per_radius(const PointView *view, double detail)
{
    return 2 * view->pixels / detail;
}

GpResult hierarchy_walk(const Patches *patches, const PointView *view, double detail,
                        bool keeps_back, HierarchyCut *cut)
{
    /* a cut has no more nodes than leaves */
    cut->surfels = gp_alloc_unset(((size_t)patches->leaf_count + 1) * sizeof *cut->surfels);
    cut->count = 0;
    if (!cut->surfels)
        return GP_ERROR_MEMORY;
    const Walk walk = { patches, view, depth_per_radius(view, detail), cut };
    for (uint32_t p = 0; p < patches->patch_count; p++) {
        const Patch *patch = &patches->patches[p];
        const EyeWay way = eye_way(view, &patch->box, patch->cone.axis);
        if (keeps_back || way_facing(&way, patch->cone.cosine, patch->cone.sine).high > 0)
            walk_nodes(&walk, patch, 0, 0, patch_levels(patches, patch)[0].count);
    }
    return GP_OK;
}

/* --- sequences -------------------------------------------------------------------------------- */

/* Larger parents first; ties by place, so that the order is one. */
static int compare_nodes(const void *a, const void *b)
{
    const SequenceNode *one = a, *other = b;
    if (one->size[1] != other->size[1])
        return one->size[1] > other->size[1] ? -1 : 1;
    return memcmp(&one->surfel, &other->surfel, sizeof one->surfel);
}

static void put_patch(const Patches *patches, const Patch *patch, Sequence *sequence)
{
    const PatchLevel *levels = patch_levels(patches, patch);
    SequenceNode *nodes = sequence->nodes;
    for (uint32_t l = 0; l < patch->level_count; l++) {
        const bool is_leaf = l + 1 == patch->level_count;
        for (uint32_t i = 0; i < levels[l].count; i++) {
            SequenceNode *node = &nodes[levels[l].first + i];
            node->surfel = patches->surfels[levels[l].first + i];
            node->size[0] = is_leaf ? 0 : node->surfel.radius;
            if (l == 0)
                node->size[1] = FLT_MAX;
            const uint32_t end = is_leaf ? 0 : patch_child(patches, patch, l, i + 1);
            for (uint32_t c = is_leaf ? 0 : patch_child(patches, patch, l, i); c < end; c++)
                nodes[levels[l + 1].first + c].size[1] = node->surfel.radius;
        }
    }
}

GpResult sequence_build(const Patches *patches, Sequence *sequence)
{
    Sequence made = { gp_alloc_unset((size_t)patches->surfel_count * sizeof *made.nodes),
                      patches->surfel_count };
    if (!made.nodes)
        return GP_ERROR_MEMORY;
    for (uint32_t p = 0; p < patches->patch_count; p++)
        put_patch(patches, &patches->patches[p], &made);
    qsort(made.nodes, made.count, sizeof *made.nodes, compare_nodes);
    *sequence = made;
    return GP_OK;
}

void sequence_free(Sequence *sequence)
{
    gp_free(sequence->nodes);
    *sequence = (Sequence){ .nodes = NULL };
}

uint32_t sequence_prefix(const Sequence *sequence, double nearest, double per_radius)
{
    uint32_t low = 0, high = sequence->count;
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        if ((double)sequence->nodes[middle].size[1] * (per_radius + 1) > nearest)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}
