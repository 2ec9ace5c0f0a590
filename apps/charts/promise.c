#include "apps/charts/promise.h"

#include <math.h>
#include <string.h>

typedef struct Search {
    const PromiseJob *job;
    Measured *measured;
    Candidates candidates;
    bool *was_tried; /* of each candidate */
    double *least;   /* error of each that was put off, above 0 */
    uint32_t done;   /* candidates, as progress is told */
    bool has_truth;
    Promise best;   /* so far; its error is infinite before any */
    GpError reason; /* why the last setting does not go that did not */
    GpResult result;
    GpError *error;
} Search;

/* --- one setting ------------------------------------------------------------------------------ */

/* The truth, as far as errors need it. */
static GpResult find_truth(Search *search)
{
    const PromiseJob *job = search->job;
    const Experiment *experiment = job->experiment;
    if (search->has_truth)
        return GP_OK;
    GpResult result =
        (experiment->find_truth_error ? experiment->find_truth_error : experiment->find_truth)(
            job->scene, gp_device_threads(job->device), search->error);
    search->has_truth = !result;
    return result;
}

/* Draws a setting and holds it against the truth.
 * out    goes: false: it does not go with the scene
 * errors GP_ERROR_INVALID: that, or the scene has no truth; or those of promise_choose */
static GpResult draw_and_measure(Search *search, const void *setting, TechniqueError *error,
                                 bool *goes)
{
    const PromiseJob *job = search->job;
    const Experiment *experiment = job->experiment;
    Frame frame = { .color = NULL };
    GpResult result =
        job->technique->build(job->scene, setting, job->device, &frame, search->error);
    *goes = result != GP_ERROR_INVALID;
    if (!result)
        result = gp_device_run(job->device, &frame.list, search->error);
    if (!result)
        result = find_truth(search);
    if (!result)
        result = (experiment->measure_error ? experiment->measure_error : experiment->measure)(
            job->scene, &frame, error, search->error);
    frame_free(&frame);
    return result;
}

static bool is_kept(const PromiseJob *job, const TechniqueError *error)
{
    return (job->per_cent ? chart_per_cent(error) : error->error) <= job->most;
}

/* Whether a setting is known to have more than was asked for. in/out least: then its least error */
static bool is_beyond(Search *search, const void *setting, double *least)
{
    const PromiseJob *job = search->job;
    TechniqueError error = { .error = 0 };
    if (!job->experiment->least_error)
        return false;
    search->result = find_truth(search);
    if (!search->result)
        job->experiment->least_error(job->scene, setting, &error);
    if (search->result || is_kept(job, &error))
        return false;
    *least = error.error;
    return true;
}

/* The error of a setting as it is remembered or measured; infinite where it does not go, or is put
 * off. in/out least: above 0 where it is put off, or was and is now wanted */
static GpResult find_error(Search *search, const void *setting, double *least,
                           TechniqueError *error)
{
    const PromiseJob *job = search->job;
    const Technique *technique = job->technique;
    const bool was_put_off = *least > 0;
    SettingText key;
    bool goes = true;
    setting_print(technique->settings, setting, technique->defaults, key, sizeof key);
    *error = (TechniqueError){ .error = HUGE_VAL };
    if (technique->check && technique->check(setting, job->given, job->extension, NULL))
        return GP_OK;
    search->best.tried += !was_put_off;
    if (measured_find(search->measured, key, error))
        return GP_OK;
    *error = (TechniqueError){ .error = HUGE_VAL };
    if (!was_put_off && is_beyond(search, setting, least))
        search->best.ruled_out++;
    if (search->result || (*least > 0 && !was_put_off))
        return search->result;
    search->best.ruled_out -= was_put_off;
    search->best.drawn++;
    GpResult result = draw_and_measure(search, setting, error, &goes);
    if (!goes && search->error)
        search->reason = *search->error;
    if (!goes)
        result = GP_OK;
    if (!result)
        measured_add(search->measured, key, error);
    return result;
}

static void tell_progress(const Search *search, uint32_t done, const char *text)
{
    const ChartListener *listener = &search->job->listener;
    if (listener->progress)
        listener->progress(listener->user, done, search->candidates.count, text);
}

/* Tries a candidate. returns whether it holds; false after a failure too, which search->result
 * is */
static bool holds(Search *search, uint32_t number)
{
    const PromiseJob *job = search->job;
    const Technique *technique = job->technique;
    const Candidate *candidate = &search->candidates.list[number];
    TechniqueError error = { .error = HUGE_VAL };
    if (search->result || search->was_tried[number])
        return false;
    search->was_tried[number] = true;
    tell_progress(search, search->done++, candidate->options);
    void *setting = gp_alloc(1, technique->setting_bytes);
    search->result = setting ? GP_OK : gp_fail(search->error, GP_ERROR_MEMORY, "out of memory");
    if (setting) {
        memcpy(setting, job->setting, technique->setting_bytes);
        search->result =
            setting_parse(technique->settings, setting, candidate->options, search->error);
    }
    if (!search->result)
        search->result = find_error(search, setting, &search->least[number], &error);
    gp_free(setting);
    const bool good = is_kept(job, &error);
    if (good || error.error < search->best.measured.error) {
        search->best.chosen = *candidate;
        search->best.measured = error;
        search->best.is_kept = good;
    }
    return good;
}

/* --- all of them ------------------------------------------------------------------------------ */

static void try_all(Search *search)
{
    const Candidates *all = &search->candidates;
    if (all->count > 0 && holds(search, all->first)) {
        for (uint32_t i = all->first; search->job->chart && i > 0 && holds(search, i - 1); i--)
            ;
        return;
    }
    for (uint32_t i = all->first; i < all->count; i++)
        if (holds(search, i))
            return;
    for (uint32_t i = all->first; i > 0; i--)
        if (holds(search, i - 1))
            return;
}

/* Where nothing holds: those put off, the least first, until none can be better than what is
 * found. */
static void try_put_off(Search *search)
{
    const uint32_t count = search->candidates.count;
    while (!search->result && !search->best.is_kept) {
        uint32_t next = count;
        for (uint32_t i = 0; i < count; i++)
            if (search->least[i] > 0 && (next == count || search->least[i] < search->least[next]))
                next = i;
        if (next == count || search->least[next] >= search->best.measured.error)
            return;
        search->was_tried[next] = false;
        search->done--;
        holds(search, next);
        search->least[next] = 0;
    }
}

GpResult promise_choose(const PromiseJob *job, Measured *measured, Promise *promise, GpError *error)
{
    Search search = {
        .job = job, .measured = measured, .best = { .measured.error = HUGE_VAL }, .error = error
    };
    GpResult result = candidates_list(job->experiment, job->chart, job->most, job->per_cent,
                                      &search.candidates, error);
    if (result)
        return result;
    search.was_tried = gp_alloc(search.candidates.count, sizeof *search.was_tried);
    search.least = gp_alloc(search.candidates.count, sizeof *search.least);
    if (!search.was_tried || !search.least)
        search.result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    try_all(&search);
    try_put_off(&search);
    tell_progress(&search, search.candidates.count, "");
    if (!search.result && !search.best.chosen.method[0])
        search.result = gp_fail(error, GP_ERROR_INVALID, "no setting goes with this scene: %s",
                                search.reason.text[0] ? search.reason.text : "they are refused");
    gp_free(search.was_tried);
    gp_free(search.least);
    gp_free(search.candidates.list);
    if (!search.result)
        *promise = search.best;
    return search.result;
}
