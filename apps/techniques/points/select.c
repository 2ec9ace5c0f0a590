#include "apps/techniques/points/select.h"

#include "apps/points/drawing/choose.h"
#include "apps/points/drawing/compressed.h"

#include <math.h>

/* The last surfels, which have clips; NULL without memory. */
static const SplatSource *clipped_surfels(const PointsModel *model, SplatMethod method,
                                          Frame *frame)
{
    const Surfels *surfels = &model->surfels;
    const SplatRun run = { method, 0, surfels->clip_count, model->mean_radius, 0, false };
    const SplatSource source = { .surfels = surfels->surfels + surfels->count - surfels->clip_count,
                                 .clips = surfels->clips,
                                 .runs = frame_copy(frame, &run, sizeof run),
                                 .run_count = 1 };
    return source.runs ? frame_copy(frame, &source, sizeof source) : NULL;
}

static GpResult all_surfels(const PointsModel *model, SplatMethod method, Frame *frame,
                            SplatSource *source, GpError *error)
{
    const bool clips = splat_has_clips(method) && model->surfels.clip_count > 0;
    const SplatRun all = { method,
                           0,
                           model->surfels.count - (clips ? model->surfels.clip_count : 0),
                           model->mean_radius,
                           0,
                           false };
    *source = (SplatSource){ .surfels = model->surfels.surfels,
                             .runs = frame_copy(frame, &all, sizeof all),
                             .run_count = 1 };
    if (clips)
        source->clipped = clipped_surfels(model, method, frame);
    return source->runs && (!clips || source->clipped)
               ? GP_OK
               : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
}

/* Of the rivals that go down to nodes of some pixels. */
static double node_detail(const PointsOptions *options)
{
    return options->detail > 0 ? options->detail : 1;
}

static GpResult walked_nodes(const PointsModel *model, const PointView *view,
                             const PointsOptions *options, Frame *frame, SplatSource *source,
                             GpError *error)
{
    HierarchyCut cut;
    SplatRun run = { .filter = SPLAT_QSPLAT };
    if (hierarchy_walk(&model->patches, view, node_detail(options), options->splats.two_sided,
                       &cut))
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    run.count = cut.count;
    *source = (SplatSource){ .surfels = frame_copy(frame, cut.surfels,
                                                   ((size_t)cut.count + 1) * sizeof *cut.surfels),
                             .runs = frame_copy(frame, &run, sizeof run),
                             .run_count = 1 };
    gp_free(cut.surfels);
    return source->surfels && source->runs ? GP_OK
                                           : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
}

/* A prefix of the sequence, by the nearest corner of the patches' boxes. */
static void wanted_nodes(const PointsModel *model, const PointView *view,
                         const PointsOptions *options, SplatSource *source)
{
    const Patches *patches = &model->patches;
    double nearest = HUGE_VAL;
    for (uint32_t i = 0; i < patches->patch_count; i++)
        nearest = fmin(nearest, box_place(view, &patches->patches[i].box).nearest);
    const double per_radius = 2 * view->pixels / node_detail(options);
    *source = (SplatSource){
        .nodes = model->sequence.nodes,
        .node_count = sequence_prefix(&model->sequence, fmax(nearest, view->near), per_radius),
        .per_radius = per_radius,
    };
}

GpResult points_select(const PointsModel *model, const PointsOptions *options, Frame *frame,
                       SplatSource *source, GpError *error)
{
    const SplatSetting *splats = &options->splats;
    if (!points_needs_patches(options))
        return all_surfels(model, points_method(options), frame, source, error);
    const PointView view = splat_point_view(&model->view, splats);
    if (splats->method == SPLAT_QSPLAT)
        return walked_nodes(model, &view, options, frame, source, error);
    if (splats->method == SPLAT_SEQUENCE) {
        wanted_nodes(model, &view, options, source);
        return GP_OK;
    }
    const SplatDetail detail = { options->detail, options->budget };
    const GpResult result =
        splat_choose(&model->patches, &model->view, splats, &detail, frame, source, error);
    if (!result && options->compress) {
        source->compressed = &model->compressed[options->compress - 1];
        source->radii = compressed_radii(source->compressed, frame);
        source->color = model->color;
    }
    return result;
}
