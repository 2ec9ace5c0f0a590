#include "apps/techniques/fragments/experiments.h"

#include "apps/techniques/fragments/report.h"
#include "apps/techniques/fragments/words.h"

/* The processor's own lists are not here: they are made before the frame, which the clock does not
 * see. */
static const TechniqueSweep sweep[] = {
    { "sorted by the machine", "--method sorted" },
    { "convex pieces", "--method convex" },
    { "convex pieces, as printed",
      "--method convex --pieces outward --order grid --tolerance 0|0.001|0.005|0.02" },
    { "peeling", "--method dp" },
    { "dual peeling", "--method ddp" },
    { "k-buffer", "--method kbuffer --kept 2|4|8|16" },
    { "k-buffer, 16 in flight", "--method kbuffer --kept 16 --hazard 16" },
    { "k-buffer, 256 in flight", "--method kbuffer --kept 16 --hazard 256" },
    { "stencil routing", "--method stencil --kept 4|8" },
    { "buckets", "--method bucket1" },
    { "buckets, two passes", "--method bucket2" },
    { "adaptive buckets", "--method adaptive" },
    { "multi-depth test", "--method mdt" },
    { "A-buffer", "--method abuffer" },
    { "weighted", "--method weighted" },
    { .method = NULL },
};

static const char *const usual[] = { "sorted by the machine", "peeling", "dual peeling", "weighted",
                                     NULL };
static const char *const metrics[] = { "beyond edges", "passes", "bytes", NULL };

static GpResult find_truth(void *model, int threads, GpError *error)
{
    return fragment_model_truth(model, threads, error);
}

static GpResult measure(void *made, const Frame *frame, TechniqueError *measured, GpError *error)
{
    const FragmentModel *model = made;
    (void)error;
    const FragmentError off = fragment_error(model, frame->color);
    const FragmentWork work = fragment_work(model, frame);
    *measured = (TechniqueError){ .error = (double)off.wrong,
                                  .metrics = { (double)off.wrong_beyond_edges, work.passes,
                                               (double)work.bytes },
                                  .whole = (double)model->view.width * model->view.height };
    return GP_OK;
}

static GpResult find_difference(void *made, const void *setting, GpDevice *device, Frame *frame,
                                float *off, GpError *error)
{
    (void)setting, (void)device, (void)error;
    fragment_difference(made, frame->color, off);
    return GP_OK;
}

const Experiment fragment_experiments[] = {
    { .name = "fragments",
      .title = "Fragments in order: time against wrong pixels",
      .scene = "builtin:teapot",
      .sweep = sweep,
      .usual = usual,
      .error_name = "wrong pixels",
      .part_of = "all pixels",
      .metrics = metrics,
      .words = fragment_words,
      .truth = fragment_truth_words,
      .difference = find_difference,
      .over = "brighter than in truth where it is most off, full from a tenth of white on",
      .under = "darker",
      .shows_failures = true,
      .find_truth = find_truth,
      .measure = measure },
    { .name = NULL },
};
