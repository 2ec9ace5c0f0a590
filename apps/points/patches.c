#include "apps/points/patches.h"

#include "apps/points/summary.h"

#include "apps/base/vector.h"

enum {
    TASKS_AT_ONCE = 256, /* between two words to the listener */
    MOST_PATCHES = 4096  /* that splitting makes by itself: each is looked at in every frame */
};

typedef struct Builder {
    const Surfels *surfels;
    PatchLimits limits;
    uint32_t *order;
    int depth;       /* of the tree */
    int first_depth; /* nodes of it are tried as patches first */
    uint32_t slots;  /* patches that such a node is cut into at most */
    Patch *found;    /* [2^first_depth][slots] */
    uint32_t *found_count;
    Patches *patches;
    uint32_t first; /* item of the run */
} Builder;

/* --- cutting ---------------------------------------------------------------------------------- */

static uint32_t leaves_of(const Builder *builder, int depth, uint64_t node)
{
    const uint32_t leaves = builder->surfels->count;
    return tree_bound(leaves, depth, node + 1) - tree_bound(leaves, depth, node);
}

/* Whether the children may be patches. */
static bool may_split(const Builder *builder, int depth)
{
    return depth < builder->depth &&
           (builder->surfels->count >> (depth + 1)) >= builder->limits.least_leaves;
}

/* Cuts a node into patches, in the order of their leaves; all but the levels and the box's size. */
static void cut(const Builder *builder, int depth, uint64_t node, Patch *found, uint32_t *count)
{
    const uint32_t begin = tree_bound(builder->surfels->count, depth, node);
    const uint32_t leaves = leaves_of(builder, depth, node);
    const uint32_t *order = builder->order + begin;
    const Surfel *surfels = builder->surfels->surfels;
    double origin[3];
    for (int i = 0; i < 3; i++)
        origin[i] = (double)surfels[order[0]].position[i];
    const SurfelSummary summary = surfels_summary(surfels, order, leaves, origin);
    Patch patch = { .depth = (uint32_t)depth, .node = (uint32_t)node };
    summary_axis(&summary, patch.cone.axis);
    summary_axes(&summary, patch.box.axes, &patch.curvature);
    const double alignment =
        sqrt(vector_dot(summary.normal_sum, summary.normal_sum)) / summary.area;
    const bool is_flat = alignment >= builder->limits.alignment &&
                         (double)patch.curvature <= builder->limits.curvature;
    if (is_flat || !may_split(builder, depth)) {
        found[(*count)++] = patch;
        return;
    }
    cut(builder, depth + 1, 2 * node, found, count);
    cut(builder, depth + 1, 2 * node + 1, found, count);
}

static void cut_item(void *context, uint32_t item, int worker)
{
    const Builder *builder = context;
    const uint32_t node = builder->first + item;
    (void)worker;
    cut(builder, builder->first_depth, node, builder->found + (size_t)node * builder->slots,
        &builder->found_count[node]);
}

/* --- levels ----------------------------------------------------------------------------------- */

/* How many inner levels a patch has: depths of the tree's parity from the patch's own on. */
static uint32_t inner_levels(const Builder *builder, const Patch *patch)
{
    return builder->depth < 0 ? 0 : (uint32_t)(builder->depth - (int)patch->depth) / 2 + 1;
}

/* Depth in the tree of an inner level. */
static int level_depth(const Builder *builder, const Patch *patch, uint32_t level)
{
    return builder->depth - 2 * (int)(inner_levels(builder, patch) - 1 - level);
}

/* Places for patches, levels and surfels. */
static GpResult lay_out(Builder *builder, uint32_t nodes)
{
    Patches *made = builder->patches;
    for (uint32_t i = 0; i < nodes; i++)
        for (uint32_t k = 0; k < builder->found_count[i]; k++) {
            made->patch_count++;
            made->level_count +=
                inner_levels(builder, &builder->found[(size_t)i * builder->slots + k]) + 1;
        }
    made->patches = gp_alloc(made->patch_count, sizeof *made->patches);
    made->levels = gp_alloc(made->level_count, sizeof *made->levels);
    if (!made->patches || !made->levels)
        return GP_ERROR_MEMORY;
    uint32_t patch = 0, level = 0;
    uint64_t surfel = 0;
    for (uint32_t i = 0; i < nodes; i++)
        for (uint32_t k = 0; k < builder->found_count[i]; k++) {
            Patch *placed = &made->patches[patch++];
            *placed = builder->found[(size_t)i * builder->slots + k];
            placed->first_level = level;
            placed->level_count = inner_levels(builder, placed) + 1;
            for (uint32_t l = 0; l < placed->level_count; l++) {
                const uint32_t count =
                    l + 1 == placed->level_count
                        ? leaves_of(builder, (int)placed->depth, placed->node)
                        : 1u << (level_depth(builder, placed, l) - (int)placed->depth);
                made->levels[level++] = (PatchLevel){ .first = (uint32_t)surfel, .count = count };
                surfel += count;
            }
        }
    if (surfel > UINT32_MAX)
        return GP_ERROR_MEMORY;
    made->surfel_count = (uint32_t)surfel;
    made->surfels = gp_alloc_unset(surfel * sizeof *made->surfels);
    return made->surfels ? GP_OK : GP_ERROR_MEMORY;
}

static void measure_level(const Patch *patch, const Surfel *surfels, PatchLevel *level)
{
    double sum = 0;
    level->least_radius = level->most_radius = surfels->radius;
    level->least_width = level->most_width = surfel_width(surfels);
    for (uint32_t i = 0; i < level->count; i++) {
        const float radius = surfels[i].radius;
        level->least_radius = radius < level->least_radius ? radius : level->least_radius;
        level->most_radius = radius > level->most_radius ? radius : level->most_radius;
        const float width = surfel_width(&surfels[i]);
        level->least_width = width < level->least_width ? width : level->least_width;
        level->most_width = width > level->most_width ? width : level->most_width;
        sum += (double)radius;
    }
    level->mean_radius = (float)(sum / level->count);
    surfels_cone(surfels, level->count, patch->cone.axis, &level->cone_cosine, &level->cone_sine);
}

/* What is known of the levels, and of the patch by them. */
static void measure_patch(const Surfel *surfels, Patch *patch, PatchLevel *levels)
{
    const PatchLevel *last = &levels[patch->level_count - 1];
    const double leaf_width = surfels_mean_width(surfels + last->first, last->count);
    patch->cone.cosine = 1;
    for (uint32_t l = 0; l < patch->level_count; l++) {
        const double width = surfels_mean_width(surfels + levels[l].first, levels[l].count);
        const double square = width * width - leaf_width * leaf_width;
        measure_level(patch, surfels + levels[l].first, &levels[l]);
        levels[l].blur = square > 0 ? (float)sqrt(square) : 0;
        if (levels[l].cone_cosine < patch->cone.cosine) {
            patch->cone.cosine = levels[l].cone_cosine;
            patch->cone.sine = levels[l].cone_sine;
        }
    }
    box_around(surfels + levels->first, last->first + last->count - levels->first, &patch->box);
}

static void fill_patch(void *context, uint32_t item, int worker)
{
    const Builder *builder = context;
    const uint32_t all = builder->surfels->count;
    Patches *made = builder->patches;
    Patch *patch = &made->patches[builder->first + item];
    PatchLevel *levels = &made->levels[patch->first_level];
    const uint32_t last = patch->level_count - 1;
    const uint32_t begin = tree_bound(all, (int)patch->depth, patch->node);
    Surfel *leaves = made->surfels + levels[last].first;
    (void)worker;
    for (uint32_t i = 0; i < levels[last].count; i++)
        leaves[i] = builder->surfels->surfels[builder->order[begin + i]];
    for (uint32_t l = 0; l < last; l++) {
        const int depth = level_depth(builder, patch, l);
        const uint64_t node = (uint64_t)patch->node << (depth - (int)patch->depth);
        for (uint32_t i = 0; i < levels[l].count; i++) {
            const uint32_t from = tree_bound(all, depth, node + i);
            const uint32_t to = tree_bound(all, depth, node + i + 1);
            made->surfels[levels[l].first + i] = surfel_parent(leaves + (from - begin), to - from);
        }
    }
    measure_patch(made->surfels, patch, levels);
}

/* --- all -------------------------------------------------------------------------------------- */

static PatchLimits used_limits(const PatchLimits *limits, uint32_t leaves)
{
    PatchLimits used = limits ? *limits : (PatchLimits){ 0 };
    if (used.least_leaves == 0)
        used.least_leaves = leaves / MOST_PATCHES > 512 ? leaves / MOST_PATCHES : 512;
    if (used.most_leaves == 0)
        used.most_leaves = 4 * used.least_leaves;
    if (used.alignment == 0)
        used.alignment = 0.95;
    if (used.curvature == 0)
        used.curvature = 0.03;
    return used;
}

static void run_told(Builder *builder, GpPool *pool, const PointsListener *listener, uint32_t count,
                     GpPoolFn function, const char *text)
{
    for (builder->first = 0; builder->first < count; builder->first += TASKS_AT_ONCE) {
        const uint32_t left = count - builder->first;
        points_tell(listener, builder->first, count, text);
        gp_pool_run(pool, left < TASKS_AT_ONCE ? left : TASKS_AT_ONCE, function, builder);
    }
    points_tell(listener, count, count, text);
}

static GpResult build(Builder *builder, GpPool *pool, const PointsListener *listener)
{
    const uint32_t leaves = builder->surfels->count;
    if (tree_order(builder->surfels, pool, listener, builder->order))
        return GP_ERROR_MEMORY;
    builder->depth = tree_depth(leaves);
    while (builder->first_depth < builder->depth &&
           (leaves >> builder->first_depth) >= builder->limits.most_leaves)
        builder->first_depth++;
    builder->slots = 1;
    for (int depth = builder->first_depth; may_split(builder, depth); depth++)
        builder->slots *= 2;
    const uint32_t nodes = 1u << builder->first_depth;
    builder->found = gp_alloc_unset((size_t)nodes * builder->slots * sizeof *builder->found);
    builder->found_count = gp_alloc(nodes, sizeof *builder->found_count);
    if (!builder->found || !builder->found_count)
        return GP_ERROR_MEMORY;
    run_told(builder, pool, listener, nodes, cut_item, "patches");
    if (lay_out(builder, nodes))
        return GP_ERROR_MEMORY;
    run_told(builder, pool, listener, builder->patches->patch_count, fill_patch, "levels");
    return GP_OK;
}

GpResult patches_build(const Surfels *surfels, const PatchLimits *limits, GpPool *pool,
                       const PointsListener *listener, Patches *patches, GpError *error)
{
    if (surfels->count == 0)
        return gp_fail(error, GP_ERROR_INVALID, "no points");
    Patches made = { .leaf_count = surfels->count,
                     .has_colors = surfels->had_colors,
                     .bounds = surfels_bounds(surfels) };
    Builder builder = { .surfels = surfels,
                        .patches = &made,
                        .limits = used_limits(limits, surfels->count) };
    builder.order = gp_alloc_unset(surfels->count * sizeof *builder.order);
    GpResult result = builder.order ? build(&builder, pool, listener) : GP_ERROR_MEMORY;
    gp_free(builder.order);
    gp_free(builder.found);
    gp_free(builder.found_count);
    if (result) {
        patches_free(&made);
        return gp_fail(error, result, "no memory for the tree of %u points", surfels->count);
    }
    *patches = made;
    return GP_OK;
}

void patches_free(Patches *patches)
{
    gp_free(patches->surfels);
    gp_free(patches->patches);
    gp_free(patches->levels);
    *patches = (Patches){ .surfels = NULL };
}

/* --- reading ---------------------------------------------------------------------------------- */

uint32_t patch_child(const Patches *patches, const Patch *patch, uint32_t level, uint32_t i)
{
    if (level + 2 < patch->level_count)
        return 4 * i;
    const int depth = tree_depth(patches->leaf_count);
    const uint64_t node = (uint64_t)patch->node << (depth - (int)patch->depth);
    return tree_bound(patches->leaf_count, depth, node + i) -
           tree_bound(patches->leaf_count, depth, node);
}

PatchWindow patch_window(const Patches *patches, const Patch *patch, uint32_t level, uint32_t done)
{
    const PatchLevel *levels = patch_levels(patches, patch);
    PatchWindow window = { levels[level].first + done, levels[level].count - done };
    if (done > 0)
        window.count += patch_child(patches, patch, level, done);
    return window;
}

size_t patches_bytes(const Patches *patches)
{
    return sizeof *patches + patches->patch_count * sizeof *patches->patches +
           patches->level_count * sizeof *patches->levels;
}
