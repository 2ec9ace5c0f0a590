#include "apps/points/level.h"

/* Of a patch that may be seen. */
typedef struct LevelPlace {
    uint32_t patch;
    BoxPlace place;
    Facing facing;
    double unit; /* largest radius that takes one pixel */
} LevelPlace;

/* A level and how many of its nodes gave way to their children. */
typedef struct Cut {
    uint32_t level, done;
} Cut;

GpResult level_selection_alloc(const Patches *patches, LevelSelection *selection)
{
    *selection = (LevelSelection){
        .ranges = gp_alloc(patches->patch_count, sizeof *selection->ranges),
        .places = gp_alloc(patches->patch_count, sizeof *selection->places),
    };
    if (selection->ranges && selection->places)
        return GP_OK;
    level_selection_free(selection);
    return GP_ERROR_MEMORY;
}

void level_selection_free(LevelSelection *selection)
{
    gp_free(selection->ranges);
    gp_free(selection->places);
    *selection = (LevelSelection){ .ranges = NULL };
}

/* --- a patch in a view ------------------------------------------------------------------------ */

/* 1 where normals of the patch may be square to the view, falling to 0 where all cosines are 0.5. */
static double edge_of(const Facing *facing)
{
    const double from = facing->low > 0 ? facing->low : facing->high < 0 ? -facing->high : 0;
    return from < 0.5 ? 1 - 2 * from : 0;
}

static double share_of(double set, double standard)
{
    return set == 0 ? standard : set < 0 ? 0 : set;
}

/* False: nothing of it can be seen, at whichever level. */
static bool place_patch(const Patches *patches, const PointView *view, const LevelChoice *choice,
                        uint32_t number, LevelPlace *placed)
{
    const Patch *patch = &patches->patches[number];
    const PatchLevel *levels = patch_levels(patches, patch);
    *placed = (LevelPlace){ .patch = number, .place = box_place(view, &patch->box) };
    if (!box_is_seen(view, &placed->place, (double)levels[0].most_radius))
        return false;
    placed->facing = patch_facing(view, &patch->box, &patch->cone);
    if (placed->facing.high <= 0 && !choice->keeps_back)
        return false;
    const double nearest = placed->place.nearest;
    const double depth = view->is_parallel ? 1 : nearest > view->near ? nearest : view->near;
    const double finer = 1 + share_of(choice->silhouette, 1) * edge_of(&placed->facing) +
                         share_of(choice->curvature, 1) * 10 * (double)patch->curvature;
    placed->unit = depth / (view->pixels * finer);
    return true;
}

/* The coarsest level of at most that radius, and how far it is on the way to the next finer. */
static Cut cut_at(const Patch *patch, const PatchLevel *levels, double radius, bool switches)
{
    const uint32_t last = patch->level_count - 1;
    uint32_t level = 0;
    while (level < last && (double)levels[level].most_radius > radius)
        level++;
    if (level == last || switches)
        return (Cut){ level, 0 };
    const double own = (double)levels[level].most_radius;
    const double coarser = level > 0 ? (double)levels[level - 1].most_radius : 2 * own;
    const double way = coarser > own ? (coarser - radius) / (coarser - own) : 0;
    return (Cut){ level, way > 0 ? (uint32_t)(way * levels[level].count) : 0 };
}

static Cut choose(const Patches *patches, const LevelChoice *choice, const LevelPlace *placed,
                  double pixels)
{
    const Patch *patch = &patches->patches[placed->patch];
    if (choice->all_leaves)
        return (Cut){ patch->level_count - 1, 0 };
    return cut_at(patch, patch_levels(patches, patch), pixels * placed->unit, choice->switches);
}

/* Whether anything of the cut can be seen; its largest radius is the level's. */
static bool cut_is_seen(const Patches *patches, const PointView *view, const LevelPlace *placed,
                        Cut cut)
{
    const Patch *patch = &patches->patches[placed->patch];
    const PatchLevel *levels = patch_levels(patches, patch);
    double radius = (double)levels[cut.level].most_radius;
    if (cut.done > 0 && (double)levels[cut.level + 1].most_radius > radius)
        radius = (double)levels[cut.level + 1].most_radius;
    return box_is_seen(view, &placed->place, radius);
}

/* --- all patches ------------------------------------------------------------------------------ */

static uint64_t count_at(const Patches *patches, const PointView *view, const LevelChoice *choice,
                         const LevelPlace *places, uint32_t count, double pixels)
{
    uint64_t surfels = 0;
    for (uint32_t i = 0; i < count; i++) {
        const Cut cut = choose(patches, choice, &places[i], pixels);
        if (cut_is_seen(patches, view, &places[i], cut))
            surfels +=
                patch_window(patches, &patches->patches[places[i].patch], cut.level, cut.done)
                    .count;
    }
    return surfels;
}

/* The least pixels, to 1 part in 1,000, at which the budget is kept; no less than asked for.
 * errors GP_ERROR_INVALID: none */
static GpResult keep_budget(const Patches *patches, const PointView *view,
                            const LevelChoice *choice, const LevelSelection *selection,
                            uint32_t count, double *pixels)
{
    const LevelPlace *places = selection->places;
    double low = choice->pixels > 0 ? choice->pixels : 0x1p-20, high = 0x1p40;
    if (count_at(patches, view, choice, places, count, low) <= choice->budget) {
        *pixels = low;
        return GP_OK;
    }
    if (count_at(patches, view, choice, places, count, high) > choice->budget)
        return GP_ERROR_INVALID;
    while (high > low * 1.001) {
        const double middle = sqrt(low) * sqrt(high);
        *(count_at(patches, view, choice, places, count, middle) > choice->budget ? &low : &high) =
            middle;
    }
    *pixels = high;
    return GP_OK;
}

static PatchRange range_of(const Patches *patches, const PointView *view, const LevelPlace *placed,
                           Cut cut)
{
    const Patch *patch = &patches->patches[placed->patch];
    const PatchLevel *level = patch_levels(patches, patch) + cut.level;
    const PatchWindow window = patch_window(patches, patch, cut.level, cut.done);
    const double near = view->near;
    PatchRange range = { .first = window.first,
                         .count = window.count,
                         .patch = placed->patch,
                         .facing = placed->facing,
                         .is_silhouette = placed->facing.low <= 0 && placed->facing.high >= 0,
                         .nearest = placed->place.nearest,
                         .farthest = placed->place.farthest,
                         .most_radius = level->most_radius,
                         .mean_radius = level->mean_radius };
    range.nearest = range.nearest < near ? near : range.nearest;
    range.farthest = range.farthest < near ? near : range.farthest;
    if (cut.done > 0) {
        const float coarse = (float)(level->count - cut.done) / (float)window.count;
        range.mean_radius = coarse * level[0].mean_radius + (1 - coarse) * level[1].mean_radius;
        if (level[1].most_radius > range.most_radius)
            range.most_radius = level[1].most_radius;
    }
    return range;
}

GpResult level_select(const Patches *patches, const PointView *view, const LevelChoice *choice,
                      LevelSelection *selection, GpError *error)
{
    static const LevelChoice defaults = { 0 };
    if (!choice)
        choice = &defaults;
    uint32_t count = 0;
    for (uint32_t i = 0; i < patches->patch_count; i++)
        count += place_patch(patches, view, choice, i, &selection->places[count]);
    double pixels = choice->pixels > 0 ? choice->pixels : 0.7;
    if (choice->budget > 0 && keep_budget(patches, view, choice, selection, count, &pixels))
        return gp_fail(
            error, GP_ERROR_INVALID, "a budget of %u splats: the coarsest levels in view have %llu",
            choice->budget,
            (unsigned long long)count_at(patches, view, choice, selection->places, count, 0x1p40));
    selection->range_count = 0;
    selection->surfel_count = 0;
    selection->pixels = pixels;
    for (uint32_t i = 0; i < count; i++) {
        const LevelPlace *placed = &selection->places[i];
        const Cut cut = choose(patches, choice, placed, pixels);
        if (!cut_is_seen(patches, view, placed, cut))
            continue;
        const PatchRange range = range_of(patches, view, placed, cut);
        selection->ranges[selection->range_count++] = range;
        selection->surfel_count += range.count;
    }
    return GP_OK;
}
