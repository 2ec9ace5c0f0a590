/* Patches: subtrees that are nearly flat, each with its levels of detail in one array.
 *
 * The tree of tree.h is cut into patches: nodes small enough, and split further where the surface
 * bends. Of each patch every second depth is kept, from the depth whose nodes have 4 to 8 leaves
 * upwards, and the leaves; all of them are surfels, coarsest level first, so that a level is a
 * range:
 *
 *     surfels:  [ patch 0: level 0 | level 1 | ... | leaves ][ patch 1: ...
 *
 * Node i of an inner level has the children 4i to 4i + 3 in the next one, or the 4 to 8 leaves that
 * tree_bound says. Since children stand in their parents' order, not only a level shows the whole
 * patch once: so does any range that begins at a node and ends where its first child stands. Levels
 * pass over into each other node by node that way (patch_window), and such a range is one draw.
 * At most a third more surfels than leaves are kept.
 *
 * A parent's position, normal and colour are the means of its leaves', by their area; its radius is
 * that of a ball that holds the discs of all its leaves, so that its disc covers theirs, but where
 * they are so far apart that less of it would be theirs than a share can tell (summary.c); its
 * share makes its area that of its leaves together, as seen along its normal.
 *
 * source Dong Zhao's thesis, 3.2.2: "linear binary tree"; the ranges and the depths left out: ours
 */
#ifndef APPS_POINTS_PATCHES_H
#define APPS_POINTS_PATCHES_H

#include "apps/base/bounds.h"
#include "apps/points/tree.h"

/* A box along axes of its own; positions are in it, and discs of radius r not farther out than
 * r. */
typedef struct PatchBox {
    float centre[3], axes[3][3], half[3]; /* axes: orthonormal, the longest spread first */
} PatchBox;

/* All normals are within an angle of an axis. */
typedef struct PatchCone {
    float axis[3], cosine, sine; /* of that angle, below 90 degrees; -1, 0: every direction */
} PatchCone;

typedef struct PatchLevel {
    uint32_t first, count; /* of the surfels */
    float least_radius, most_radius, mean_radius;
    float least_width, most_width; /* surfel_width */
    /* How much wider its splats are than the leaves': the root of the difference of the squares of
     * the mean widths, by area. 0: the leaves, and levels that are as fine. */
    float blur;
    float cone_cosine, cone_sine; /* of its own cone, about the axis of the patch's */
} PatchLevel;

typedef struct Patch {
    PatchBox box;
    PatchCone cone;
    float curvature; /* of the leaves: least eigenvalue of the covariance over the sum, 0 to 1/3 */
    uint32_t depth, node;              /* in the tree */
    uint32_t first_level, level_count; /* coarsest first; the last are the leaves */
} Patch;

typedef struct Patches {
    Surfel *surfels; /* NULL where only a packed form is kept */
    Patch *patches;
    PatchLevel *levels;
    uint32_t surfel_count, patch_count, level_count, leaf_count;
    Bounds bounds; /* of the leaves' places */
    bool has_colors;
} Patches;

/* Where patches are cut; zero is a default. */
typedef struct PatchLimits {
    uint32_t most_leaves;  /* more are split; 4 times the least */
    uint32_t least_leaves; /* fewer are never made by splitting; 512, or 1/4096 of the leaves */
    /* length of the mean of the normals, by area: shorter is split; 0.95 (a cap of 26 degrees about
     * its middle). A few wrong normals do not count much here */
    double alignment;
    double curvature; /* more is split; 0.03 */
} PatchLimits;

/* Builds tree, patches and levels.
 * in     surfels: kept by the caller, not needed afterwards; limits, listener: NULL: defaults, none
 * out    patches; free with patches_free
 * order  the same bits for any number of threads
 * errors GP_ERROR_INVALID (no surfels), GP_ERROR_MEMORY */
GpResult patches_build(const Surfels *surfels, const PatchLimits *limits, GpPool *pool,
                       const PointsListener *listener, Patches *patches, GpError *error);

/* Frees and zeroes; a zeroed one is fine. */
void patches_free(Patches *patches);

static inline const PatchLevel *patch_levels(const Patches *patches, const Patch *patch)
{
    return &patches->levels[patch->first_level];
}

/* The first child of node `i` of a level that is not the last, counted in the next level; of the
 * count of nodes: the next level's count. */
uint32_t patch_child(const Patches *patches, const Patch *patch, uint32_t level, uint32_t i);

/* Surfels that show a patch once: a level whose first `done` nodes gave way to their children.
 * in     level; done: up to the level's count, 0 at the last level */
typedef struct PatchWindow {
    uint32_t first, count;
} PatchWindow;

PatchWindow patch_window(const Patches *patches, const Patch *patch, uint32_t level, uint32_t done);

/* Bytes of all but the surfels. */
size_t patches_bytes(const Patches *patches);

#endif
