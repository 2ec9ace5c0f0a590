/* Which surfels of a model to draw: for each patch that may be seen, one range.
 *
 * A patch is drawn at the coarsest level that adds at most `pixels` to the standard deviation of
 * its splats where the patch is nearest; less where the surface bends or is seen from its edge.
 * Before it has to give way to the next finer level, its nodes do so one after the other
 * (patch_window): a move of the camera changes few surfels at a time, and no change of a level is
 * seen.
 *
 * Box and cone are those of what would be drawn: a few wrong normals among leaves keep their patch
 * from being culled only where it is drawn by its leaves.
 *
 * DEVIATES: the thesis takes the largest radius of a patch. One long triangle among thousands would
 * keep all of them fine; and what matters of a level is how much wider it is than the leaves.
 *
 * source Dong Zhao's thesis, 3.3.1: box, cone, nearest corner, radius, curvature, silhouette;
 *        levels that pass over into each other, and the budget: ours
 */
#ifndef APPS_POINTS_LEVEL_H
#define APPS_POINTS_LEVEL_H

#include "apps/points/cull.h"

/* Zero is a default. */
typedef struct LevelChoice {
    double pixels; /* largest standard deviation of a splat on the picture; 0.7 */
    /* surfels at most, coarser than `pixels` says where needed; 0: any number. With pixels = 0 as
     * fine as the budget allows */
    uint32_t budget;
    bool all_leaves;   /* no level of detail: the leaves of what may be seen */
    bool keeps_back;   /* patches that face away are drawn too */
    bool switches;     /* whole levels only, as in the thesis: changes are seen */
    double silhouette; /* at the silhouette splats are 1 + this times smaller; 1; < 0: not */
    double curvature;  /* for a curvature of 0.1 splats are 1 + this times smaller; 1; < 0: not */
} LevelChoice;

typedef struct PatchRange {
    uint32_t first, count; /* of the surfels */
    uint32_t patch;
    bool is_silhouette; /* some of its surfels may be seen from their edge */
    Facing facing;
    double nearest, farthest;       /* depth, at least the view's near */
    float most_radius, mean_radius; /* the model's unit */
} PatchRange;

/* What to draw; patches in their order. */
typedef struct LevelSelection {
    PatchRange *ranges; /* [range_count], room for all patches */
    uint32_t range_count;
    uint64_t surfel_count;     /* of all ranges */
    double pixels;             /* as used: more than asked for where the budget wants it */
    struct LevelPlace *places; /* what is known of each patch in a frame */
} LevelSelection;

/* Room for the selections of one model, frame after frame. errors GP_ERROR_MEMORY */
GpResult level_selection_alloc(const Patches *patches, LevelSelection *selection);

void level_selection_free(LevelSelection *selection); /* zeroes; a zeroed one is fine */

/* Chooses.
 * in     patches: their surfels are not looked at; choice: NULL: defaults
 * out    selection
 * errors GP_ERROR_INVALID: the budget is below what the coarsest levels in view have */
GpResult level_select(const Patches *patches, const PointView *view, const LevelChoice *choice,
                      LevelSelection *selection, GpError *error);

#endif
