#include "apps/techniques/points/report.h"

#include "apps/techniques/points/model.h"

static void tell_measure(const PointsError *measured, TechniqueReport *report)
{
    text_add(&report->lines, "interior %.2f dB, area %+.2f %%, %.0f holes in %.0f covered pixels\n",
             measured->interior_psnr, 100 * measured->area_error, measured->holes,
             measured->covered);
    if (!report->members)
        return;
    json_object_set_new(report->members, "interior_psnr", json_real(measured->interior_psnr));
    json_object_set_new(report->members, "area_error", json_real(measured->area_error));
    json_object_set_new(report->members, "holes", json_integer((json_int_t)measured->holes));
}

enum { STEPS = 16 }; /* in a radius: with fewer, places are off by more than 3 % of it */

/* Coordinates of surveys have an origin far away, and digits that floats do not hold. */
static void warn_of_rounding(const PointsModel *model, TechniqueReport *report)
{
    if (STEPS * model->step > (double)model->mean_radius)
        text_add(&report->warnings,
                 "%s: coordinates are rounded to steps of %g, so far from the origin they are, and "
                 "points have a radius of %g: subtract an offset from all points in the file\n",
                 model->path, model->step, (double)model->mean_radius);
}

GpResult points_report(void *made, const void *setting, const Frame *frame, GpDevice *device,
                       TechniqueReport *report, GpError *error)
{
    PointsModel *model = made;
    const PointsOptions *options = setting;
    const uint64_t splats = points_model_splats(frame);
    if (report->members) {
        json_object_set_new(report->members, "points", json_integer(model->point_count));
        json_object_set_new(report->members, "splats", json_integer((json_int_t)splats));
        json_object_set_new(report->members, "bytes_per_point",
                            json_real(points_model_bytes(model, options) / model->point_count));
    }
    warn_of_rounding(model, report);
    if (model->cache_fault.text[0])
        text_add(&report->warnings, "%s\n", model->cache_fault.text);
    if (options->reports)
        facts_report(&model->facts, &report->lines, report->members);
    if (!options->measures)
        return GP_OK;
    PointsError measured;
    GpResult result = points_model_truth(model, gp_device_threads(device), error);
    if (!result) {
        measured = points_error(&model->truth, frame->color);
        tell_measure(&measured, report);
    }
    return result;
}
