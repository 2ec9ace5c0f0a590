#include "apps/techniques/fragments/methods.h"

#include "apps/fragments/drawing/buckets.h"
#include "apps/fragments/drawing/cpu.h"
#include "apps/fragments/drawing/dual.h"
#include "apps/fragments/drawing/lists.h"
#include "apps/fragments/drawing/peel.h"
#include "apps/fragments/drawing/sorted.h"
#include "apps/fragments/drawing/weighted.h"

static GpResult add_sorted(const FragmentModel *model, const FragmentOptions *options, Frame *frame,
                           GpError *error)
{
    (void)options;
    return sorted_add(&model->mesh, &model->view, frame->color, NULL, frame, error);
}

static GpResult add_peeled(const FragmentModel *model, const FragmentOptions *options, Frame *frame,
                           GpError *error)
{
    const PeelSetting setting = { model->count.layers };
    (void)options;
    return peel_add(&model->mesh, &setting, &model->view, frame->color, NULL, frame, error);
}

static GpResult add_dual(const FragmentModel *model, const FragmentOptions *options, Frame *frame,
                         GpError *error)
{
    const DualSetting setting = { model->count.layers };
    (void)options;
    return dual_add(&model->mesh, &setting, &model->view, frame->color, NULL, frame, error);
}

/* Those of a kept number, and those that keep all. */
static GpResult add_lists(const FragmentModel *model, const FragmentOptions *options, Frame *frame,
                          GpError *error)
{
    const FragmentMethod method = options->method;
    const ListSetting setting = {
        .layers = model->count.layers,
        .first = method == FRAGMENTS_STENCIL ? options->kept : 0,
        .nearest = method == FRAGMENTS_KBUFFER ? options->kept : 0,
        .hazard = method == FRAGMENTS_KBUFFER ? options->hazard : 0,
        .is_packed = method == FRAGMENTS_MDT,
    };
    return lists_add(&model->mesh, &setting, &model->view, frame->color, NULL, frame, error);
}

static GpResult add_buckets(const FragmentModel *model, const FragmentOptions *options,
                            Frame *frame, GpError *error)
{
    const BucketSetting setting = { options->method == FRAGMENTS_BUCKET2    ? BUCKETS_TWO_PASSES
                                    : options->method == FRAGMENTS_ADAPTIVE ? BUCKETS_ADAPTIVE
                                                                            : BUCKETS_ONE_PASS };
    return buckets_add(&model->mesh, &setting, &model->view, frame->color, NULL, frame, error);
}

static GpResult add_cpu(const FragmentModel *model, const FragmentOptions *options, Frame *frame,
                        GpError *error)
{
    (void)options;
    return cpu_add(&model->mesh, &model->view, frame->color, NULL, frame, error);
}

static GpResult add_weighted(const FragmentModel *model, const FragmentOptions *options,
                             Frame *frame, GpError *error)
{
    (void)options;
    return weighted_add(&model->mesh, &model->view, frame->color, NULL, frame, error);
}

static GpResult add_convex(const FragmentModel *model, const FragmentOptions *options, Frame *frame,
                           GpError *error)
{
    return convex_add(&model->convex, options->order, &model->view, frame->color, NULL, frame,
                      model->facts, error);
}

const FragmentMethodRow fragment_methods[FRAGMENT_METHODS] = {
    [FRAGMENTS_CONVEX] = { add_convex, true },      [FRAGMENTS_SORTED] = { add_sorted, true },
    [FRAGMENTS_DP] = { add_peeled, true },          [FRAGMENTS_DDP] = { add_dual, true },
    [FRAGMENTS_KBUFFER] = { add_lists, false },     [FRAGMENTS_STENCIL] = { add_lists, false },
    [FRAGMENTS_BUCKET1] = { add_buckets, false },   [FRAGMENTS_BUCKET2] = { add_buckets, false },
    [FRAGMENTS_ADAPTIVE] = { add_buckets, false },  [FRAGMENTS_MDT] = { add_lists, false },
    [FRAGMENTS_ABUFFER] = { add_lists, false },     [FRAGMENTS_CPU] = { add_cpu, false },
    [FRAGMENTS_WEIGHTED] = { add_weighted, false },
};
