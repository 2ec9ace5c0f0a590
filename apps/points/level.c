#include "apps/points/level.h"

/* Of a patch that may be seen. */
typedef struct LevelPlace {
    uint32_t patch;
    BoxPlace place;
    EyeWay way;
    double unit; /* blur that takes one pixel */
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

/* Where a level begins to give way to the next finer, as a multiple of the blur at which that is
 * done: the wider, the slower the change, and the more surfels are finer than they need to be. */
#define BAND 1.5

/* 1 where the patch is seen from its edge, falling to 0 where it is turned by 30 degrees. By its
 * mean normal: where a model is rough, some normals of every patch are square to the view. */
static double edge_of(const EyeWay *way)
{
    const double cosine = fabs(way->cosine);
    return cosine < 0.5 ? 1 - 2 * cosine : 0;
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
    placed->way = eye_way(view, &patch->box, patch->cone.axis);
    const double nearest = placed->place.nearest;
    const double depth = view->is_parallel ? 1 : nearest > view->near ? nearest : view->near;
    const double finer = 1 + share_of(choice->silhouette, 1) * edge_of(&placed->way) +
                         share_of(choice->curvature, 1) * 10 * (double)patch->curvature;
    placed->unit = depth / (view->pixels * finer);
    return true;
}

/* The coarsest level of at most that blur, and how far it is on the way to the next finer. */
static Cut cut_at(const Patch *patch, const PatchLevel *levels, double blur, bool switches)
{
    const uint32_t last = patch->level_count - 1;
    uint32_t level = 0;
    while (level < last && (double)levels[level].blur > blur)
        level++;
    if (level == last || switches)
        return (Cut){ level, 0 };
    const double own = (double)levels[level].blur;
    double begin = BAND * own;
    if (level > 0 && (double)levels[level - 1].blur < begin)
        begin = (double)levels[level - 1].blur;
    const double way = begin > own ? (begin - blur) / (begin - own) : 0;
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

/* The normals of a cut: of its level, and of the next where some nodes gave way. */
static Facing cut_facing(const Patches *patches, const LevelPlace *placed, Cut cut)
{
    const PatchLevel *level = patch_levels(patches, &patches->patches[placed->patch]) + cut.level;
    if (cut.done > 0 && level[1].cone_cosine < level[0].cone_cosine)
        level++;
    return way_facing(&placed->way, level->cone_cosine, level->cone_sine);
}

static float cut_radius(const Patches *patches, const LevelPlace *placed, Cut cut)
{
    const PatchLevel *level = patch_levels(patches, &patches->patches[placed->patch]) + cut.level;
    return cut.done > 0 && level[1].most_radius > level[0].most_radius ? level[1].most_radius
                                                                       : level[0].most_radius;
}

static bool cut_is_seen(const Patches *patches, const PointView *view, const LevelChoice *choice,
                        const LevelPlace *placed, Cut cut)
{
    return box_is_seen(view, &placed->place, (double)cut_radius(patches, placed, cut)) &&
           (choice->keeps_back || cut_facing(patches, placed, cut).high > 0);
}

/* --- all patches ------------------------------------------------------------------------------ */

/* Surfels at so many pixels; counting ends above `most`. */
static uint64_t count_at(const Patches *patches, const PointView *view, const LevelChoice *choice,
                         const LevelPlace *places, uint32_t count, double pixels, uint64_t most)
{
    uint64_t surfels = 0;
    for (uint32_t i = 0; i < count && surfels <= most; i++) {
        const Cut cut = choose(patches, choice, &places[i], pixels);
        if (cut_is_seen(patches, view, choice, &places[i], cut))
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
    const uint64_t most = choice->budget;
    double low = choice->pixels > 0 ? choice->pixels : 0x1p-20;
    if (count_at(patches, view, choice, places, count, low, most) <= most) {
        *pixels = low;
        return GP_OK;
    }
    double high = low < 0.5 ? 0.5 : low;
    while (count_at(patches, view, choice, places, count, high, most) > most) {
        if (high > 0x1p40)
            return GP_ERROR_INVALID;
        low = high;
        high *= 2;
    }
    while (high > low * 1.001) {
        const double middle = sqrt(low) * sqrt(high);
        const uint64_t surfels = count_at(patches, view, choice, places, count, middle, most);
        *(surfels > most ? &low : &high) = middle;
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
                         .facing = cut_facing(patches, placed, cut),
                         .nearest = placed->place.nearest,
                         .farthest = placed->place.farthest,
                         .most_radius = cut_radius(patches, placed, cut),
                         .mean_radius = level->mean_radius };
    range.is_silhouette = range.facing.low <= 0 && range.facing.high >= 0;
    range.nearest = range.nearest < near ? near : range.nearest;
    range.farthest = range.farthest < near ? near : range.farthest;
    if (cut.done > 0) {
        const float coarse = (float)(level->count - cut.done) / (float)window.count;
        range.mean_radius = coarse * level[0].mean_radius + (1 - coarse) * level[1].mean_radius;
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
        return gp_fail(error, GP_ERROR_INVALID,
                       "a budget of %u splats: the coarsest levels in view have %llu",
                       choice->budget,
                       (unsigned long long)count_at(patches, view, choice, selection->places, count,
                                                    0x1p40, UINT64_MAX));
    selection->range_count = 0;
    selection->surfel_count = 0;
    selection->pixels = pixels;
    for (uint32_t i = 0; i < count; i++) {
        const LevelPlace *placed = &selection->places[i];
        const Cut cut = choose(patches, choice, placed, pixels);
        if (!cut_is_seen(patches, view, choice, placed, cut))
            continue;
        const PatchRange range = range_of(patches, view, placed, cut);
        selection->ranges[selection->range_count++] = range;
        selection->surfel_count += range.count;
    }
    return GP_OK;
}
