#include "apps/points/drawing/choose.h"

#include "apps/points/filter.h"
#include "apps/points/level.h"

#include <math.h>

/* --- filters ---------------------------------------------------------------------------------- */

/* The setting and the view that filters are chosen for. */
typedef struct Chooser {
    const Patches *patches;
    const SplatSetting *setting;
    PointView view;
    double h, tangent; /* square pixels; of half the angle of view */
} Chooser;

/* Whether a range holds more than leaves. */
static bool is_merged(const Patches *patches, const PatchRange *range)
{
    const Patch *patch = &patches->patches[range->patch];
    return range->first < patch_levels(patches, patch)[patch->level_count - 1].first;
}

/* Radii of the standard deviations of what a range draws; a range may hold some of the next
 * level. */
static void range_deviations(const Chooser *chooser, const PatchRange *range, double *least,
                             double *most)
{
    const Patches *patches = chooser->patches;
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
    const double spread =
        chooser->setting->spread * (is_merged(patches, range) ? SPLAT_MERGED_SPREAD : 1);
    *least *= spread;
    *most *= spread;
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

/* Ours: by how many pixels the standard deviation of splats may grow where surfels are merged. With
 * the pixel's filter alone its variance h becomes h + d^2, along both axes; 2 f(1 + x) <= x^2, so
 * that L is at most d^2 / h (apps/base/filter_bound.h). */
static double bounded_detail(const SplatSetting *setting)
{
    return setting->method == SPLAT_ADAPTIVE ? setting->low_pass * sqrt(2 * setting->tolerance) : 0;
}

/* From both sides a surfel shows as much that is turned away: the mean absolute value. */
static double mean_cosine(const Facing *facing, bool two_sided)
{
    const double low = facing->low, high = facing->high, mean = (low + high) / 2;
    if (!two_sided)
        return fmax(mean, 0);
    return low < 0 && high > 0 ? (low * low + high * high) / (2 * (high - low)) : fabs(mean);
}

/* Of a mean surfel in the patch's middle: its area on the picture over the filter's, squares of
 * standard deviations both. */
static double area_ratio(const Chooser *chooser, const PatchRange *range)
{
    const double depth = (range->nearest + range->farthest) / 2;
    const double cosine = mean_cosine(&range->facing, chooser->setting->two_sided);
    const double radius = (double)range->mean_radius * chooser->setting->spread;
    const double pixels = radius * chooser->view.pixels / depth;
    return pixels * pixels * cosine / chooser->h;
}

/* source the thesis, section 3.3.2: S / Sh against c_max = 3, and widened towards the picture's
 *        corners against c_min = 0.3; patches at the silhouette keep both filters */
static SplatMethod area_filter(const Chooser *chooser, const PatchRange *range)
{
    const double ratio = area_ratio(chooser, range), tangent = chooser->tangent;
    if (range->is_silhouette || !(range->nearest > 0))
        return SPLAT_EWA;
    if (ratio > 3)
        return SPLAT_RECONSTRUCTION;
    return sqrt(2 * tangent * tangent + 1) * ratio < 0.3 ? SPLAT_LOW_PASS : SPLAT_EWA;
}

/* source paper 003, section 3: the distance against c r sqrt(cos theta) / rh with c_min = 0.3 and
 *        c_max = 2 (1 + 2 tan(fov / 2))^2, so that the c are roots of ratios of areas, upside
 *        down */
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

/* Pixels by which the discs that hide may reach beyond those that are drawn: less where a patch may
 * hold an edge of the surface, behind which another begins. */
#define HIDERS_REACH      1
#define HIDERS_EDGE_REACH 0.5

/* What leaves the visibility of a range: the coarsest whole level above it whose discs are not much
 * wider. A parent's disc covers those of its children, but where these are far apart, so nothing
 * behind them shows; at the edges of the surface it hides a little more. */
static SplatRun hider_of(const Chooser *chooser, const PatchRange *range, SplatRun own)
{
    const Patches *patches = chooser->patches;
    const PatchLevel *levels = patch_levels(patches, &patches->patches[range->patch]);
    const double pixels = range->is_silhouette ? HIDERS_EDGE_REACH : HIDERS_REACH;
    const double reach = pixels * range->nearest / chooser->view.pixels;
    for (; levels->first + levels->count <= range->first; levels++)
        if ((double)levels->most_radius - (double)range->most_radius <= reach)
            return (SplatRun){ own.filter,          levels->first, levels->count,
                               levels->mean_radius, own.patch,     true };
    return own;
}

static GpResult runs_of(const Chooser *chooser, const LevelSelection *selection, Frame *frame,
                        SplatSource *source, GpError *error)
{
    const bool has_hiders = chooser->setting->method == SPLAT_ADAPTIVE;
    SplatRun *runs = frame_alloc(frame, selection->range_count + 1, sizeof *runs);
    SplatRun *hiders =
        has_hiders ? frame_alloc(frame, selection->range_count + 1, sizeof *hiders) : NULL;
    if (!runs || (has_hiders && !hiders))
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (uint32_t i = 0; i < selection->range_count; i++) {
        const PatchRange *range = &selection->ranges[i];
        runs[i] = (SplatRun){ choose_filter(chooser, range),
                              range->first,
                              range->count,
                              range->mean_radius,
                              range->patch,
                              is_merged(chooser->patches, range) };
        if (hiders)
            hiders[i] = hider_of(chooser, range, runs[i]);
    }
    *source = (SplatSource){ .surfels = chooser->patches->surfels,
                             .hiders = hiders,
                             .hider_count = hiders ? selection->range_count : 0,
                             .runs = runs,
                             .run_count = selection->range_count };
    return GP_OK;
}

PointView splat_point_view(const SplatView *view, const SplatSetting *setting)
{
    return point_view(&view->camera, view->width, view->height,
                      fmax(setting->spread * setting->cut, 1), setting->low_pass * setting->cut);
}

GpResult splat_choose(const Patches *patches, const SplatView *view, const SplatSetting *setting,
                      const SplatDetail *detail, Frame *frame, SplatSource *source, GpError *error)
{
    Chooser chooser = { .patches = patches,
                        .setting = setting,
                        .view = splat_point_view(view, setting),
                        .h = setting->low_pass * setting->low_pass };
    chooser.tangent = chooser.view.axes.half_height;
    const double pixels =
        detail->pixels > 0 || detail->budget > 0 ? detail->pixels : bounded_detail(setting);
    const LevelChoice choice = { .pixels = pixels / (setting->spread * SPLAT_MERGED_SPREAD),
                                 .budget = detail->budget,
                                 .all_leaves = !(pixels > 0) && !detail->budget,
                                 .keeps_back = setting->two_sided,
                                 .silhouette = -1,
                                 .curvature = -1 };
    LevelSelection selection;
    if (level_selection_alloc(patches, &selection))
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    GpResult result = level_select(patches, &chooser.view, &choice, &selection, error);
    if (!result)
        result = runs_of(&chooser, &selection, frame, source, error);
    level_selection_free(&selection);
    return result;
}
