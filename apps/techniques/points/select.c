#include "apps/techniques/points/select.h"

#include "apps/points/filter.h"
#include "apps/points/level.h"

#include <math.h>

/* --- filters ---------------------------------------------------------------------------------- */

/* The setting and the view that filters are chosen for. */
typedef struct Chooser {
    const PointsModel *model;
    const SplatSetting *setting;
    PointView view;
    double h, tangent; /* square pixels; of half the angle of view */
} Chooser;

/* Radii of the standard deviations of what a range draws; a range may hold some of the next level. */
static void range_deviations(const Chooser *chooser, const PatchRange *range, double *least,
                             double *most)
{
    const Patches *patches = &chooser->model->patches;
    const Patch *patch = &patches->patches[range->patch];
    const PatchLevel *levels = patch_levels(patches, patch);
    uint32_t level = 0;
    while (range->first >= levels[level].first + levels[level].count)
        level++;
    *least = (double)levels[level].least_width;
    *most = (double)levels[level].most_width;
    if (range->first + range->count > levels[level].first + levels[level].count) {
        *least = fmin(*least, (double)levels[level + 1].least_width);
        *most = fmax(*most, (double)levels[level + 1].most_width);
    }
    *least *= chooser->setting->spread;
    *most *= chooser->setting->spread;
}

/* Ours: the filter that may be left out within the tolerance, whatever surfel of the patch. */
static SplatMethod bounded_filter(const Chooser *chooser, const PatchRange *range)
{
    double least, most;
    if (!(range->nearest > 0))
        return SPLAT_EWA;
    range_deviations(chooser, range, &least, &most);
    const SplatExtent extent =
        splat_extent(&chooser->view, range->nearest, range->farthest, least, most, &range->facing);
    const double tolerance = 2 * chooser->setting->tolerance; /* of L, of which half is an error */
    if (filter_bound_low_pass(extent.high, extent.high, chooser->h) <= tolerance)
        return SPLAT_LOW_PASS;
    if (filter_bound_reconstruction(extent.low, extent.low, chooser->h) <= tolerance)
        return SPLAT_RECONSTRUCTION;
    return SPLAT_EWA;
}

/* Of a mean surfel in the patch's middle: its area on the picture over the filter's, squares of
 * standard deviations both. */
static double area_ratio(const Chooser *chooser, const PatchRange *range)
{
    const double depth = (range->nearest + range->farthest) / 2;
    const double cosine = fmax((range->facing.low + range->facing.high) / 2, 0);
    const double radius = (double)range->mean_radius * chooser->setting->spread;
    const double pixels = radius * chooser->view.pixels / depth;
    return pixels * pixels * cosine / chooser->h;
}

/* source the thesis, section 3.3.2: S / Sh against c_max = 3, and widened towards the picture's corners
 *        against c_min = 0.3; patches at the silhouette keep both filters */
static SplatMethod area_filter(const Chooser *chooser, const PatchRange *range)
{
    const double ratio = area_ratio(chooser, range), tangent = chooser->tangent;
    if (range->is_silhouette || !(range->nearest > 0))
        return SPLAT_EWA;
    if (ratio > 3)
        return SPLAT_RECONSTRUCTION;
    return sqrt(2 * tangent * tangent + 1) * ratio < 0.3 ? SPLAT_LOW_PASS : SPLAT_EWA;
}

/* source paper 003, section 3: the distance against c r sqrt(cos theta) / rh with c_min = 0.3 and c_max =
 *        2 (1 + 2 tan(fov / 2))^2, so that the c are roots of ratios of areas, upside down */
static SplatMethod distance_filter(const Chooser *chooser, const PatchRange *range)
{
    const double root = sqrt(area_ratio(chooser, range)), tangent = chooser->tangent;
    const double wide = 1 + 2 * tangent;
    if (!(range->nearest > 0))
        return SPLAT_EWA;
    if (root * 0.3 > 1)
        return SPLAT_RECONSTRUCTION;
    return root * 2 * wide * wide < 1 ? SPLAT_LOW_PASS : SPLAT_EWA;
}

static SplatMethod choose_filter(const Chooser *chooser, const PatchRange *range)
{
    switch (chooser->setting->method) {
    case SPLAT_ADAPTIVE:
        return bounded_filter(chooser, range);
    case SPLAT_AREA:
        return area_filter(chooser, range);
    case SPLAT_DISTANCE:
        return distance_filter(chooser, range);
    default:
        return chooser->setting->method;
    }
}

/* --- runs ------------------------------------------------------------------------------------- */

bool points_needs_patches(const PointsOptions *options)
{
    const SplatMethod method = options->splats.method;
    return method == SPLAT_ADAPTIVE || method == SPLAT_AREA || method == SPLAT_DISTANCE ||
           options->detail > 0 || options->budget > 0 || options->cache;
}

static GpResult all_surfels(const PointsModel *model, SplatMethod method, Frame *frame,
                            SplatSource *source, GpError *error)
{
    const SplatRun all = { method, 0, model->surfels.count, model->mean_radius };
    *source = (SplatSource){ .surfels = model->surfels.surfels,
                             .runs = frame_copy(frame, &all, sizeof all),
                             .run_count = 1 };
    return source->runs ? GP_OK : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
}

static GpResult runs_of(const Chooser *chooser, const LevelSelection *selection, Frame *frame,
                        SplatSource *source, GpError *error)
{
    SplatRun *runs = frame_alloc(frame, selection->range_count + 1, sizeof *runs);
    if (!runs)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (uint32_t i = 0; i < selection->range_count; i++) {
        const PatchRange *range = &selection->ranges[i];
        runs[i] = (SplatRun){ choose_filter(chooser, range), range->first, range->count,
                              range->mean_radius };
    }
    *source = (SplatSource){ .surfels = chooser->model->patches.surfels,
                             .runs = runs,
                             .run_count = selection->range_count };
    return GP_OK;
}

GpResult points_select(const PointsModel *model, const PointsOptions *options, Frame *frame,
                       SplatSource *source, GpError *error)
{
    const SplatSetting *splats = &options->splats;
    const SplatView *view = &model->view;
    if (!points_needs_patches(options))
        return all_surfels(model, splats->method, frame, source, error);
    Chooser chooser = { .model = model,
                        .setting = splats,
                        .h = splats->low_pass * splats->low_pass };
    chooser.view =
        point_view(&view->camera, view->width, view->height, fmax(splats->spread * splats->cut, 1),
                   splats->low_pass * splats->cut);
    chooser.tangent = chooser.view.axes.half_height;
    const LevelChoice choice = { .pixels = options->detail / splats->spread,
                                 .budget = options->budget,
                                 .all_leaves = !(options->detail > 0) && !options->budget,
                                 .keeps_back = splats->two_sided };
    LevelSelection selection;
    if (level_selection_alloc(&model->patches, &selection))
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    GpResult result = level_select(&model->patches, &chooser.view, &choice, &selection, error);
    if (!result)
        result = runs_of(&chooser, &selection, frame, source, error);
    level_selection_free(&selection);
    return result;
}
