#include "apps/charts/chart_pictures.h"

#include "apps/charts/chart_difference.h"
#include "apps/frame/picture.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

void chart_difference_name(const char *picture, char *name, size_t size)
{
    char stem[128];
    text_stem(picture, stem, sizeof stem);
    snprintf(name, size, "%s_difference.png", stem);
}

/* --- one picture ------------------------------------------------------------------------------ */

/* Draws a setting's frame, and what shows it. in frame: zeroed; to be freed always */
static GpResult draw(const ChartPictures *job, const void *setting, Frame *frame, GpError *error)
{
    const Technique *technique = job->technique;
    GpResult result = technique->build(job->scene, setting, job->device, frame, error);
    if (!result && technique->show)
        result = technique->show(job->scene, setting, frame, error);
    return result ? result : gp_device_run(job->device, &frame->list, error);
}

static GpResult write_difference(const ChartPictures *job, const void *setting, Frame *frame,
                                 const char *path, GpError *error)
{
    const GpSurface *picture = frame->color;
    Picture made = { .values = NULL };
    float *off = gp_alloc((size_t)picture->width * picture->height, sizeof *off);
    if (!off)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    GpResult result =
        job->experiment->difference(job->scene, setting, job->device, frame, off, error);
    if (!result)
        result = chart_difference(picture, off, &made, error);
    if (!result)
        result = picture_write(path, &made, NULL, error);
    picture_free(&made);
    gp_free(off);
    return result;
}

static GpResult write_files(const ChartPictures *job, const void *setting, const char *path,
                            const char *difference, bool *goes, GpError *error)
{
    Frame frame = { .color = NULL };
    GpResult result = draw(job, setting, &frame, error);
    *goes = result != GP_ERROR_INVALID;
    if (!result)
        result = picture_write_surface(path, frame_picture(&frame), true, NULL, error);
    if (!result && job->experiment->difference)
        result = write_difference(job, setting, &frame, difference, error);
    frame_free(&frame);
    return result;
}

/* Volumes of several bits a voxel cannot be shown: such a point has no picture. */
static GpResult write_picture(const ChartPictures *job, ChartPoint *point, const char *name,
                              const char *const paths[2], GpError *error)
{
    void *setting;
    bool goes = true;
    GpResult result = technique_setting(job->technique, point->options, &setting, error);
    if (result)
        return result;
    result = write_files(job, setting, paths[0], paths[1], &goes, error);
    gp_free(setting);
    if (!result)
        text_copy(point->picture, sizeof point->picture, name);
    if (goes)
        return result;
    error->text[0] = '\0';
    return GP_OK;
}

/* --- all of them ------------------------------------------------------------------------------ */

/* Some of the front, its ends among them. */
static uint32_t list_front(Chart *chart, const ChartPoint **best, ChartPoint *shown[])
{
    const uint32_t count = chart_list_best(chart, best);
    const uint32_t wanted = count < CHART_MAX_PICTURES ? count : CHART_MAX_PICTURES;
    for (uint32_t i = 0; i < wanted; i++) {
        const uint32_t place = wanted > 1 ? i * (count - 1) / (wanted - 1) : 0;
        shown[i] = &chart->points[best[place] - chart->points];
    }
    return wanted;
}

static bool is_farther(const ChartPoint *point, const ChartPoint *other)
{
    return point->measured.error > other->measured.error;
}

/* Of each method the point farthest from the truth, unless it is on the front or, within a tenth,
 * as near as the nearest of all. */
static uint32_t list_failures(Chart *chart, ChartPoint *shown[])
{
    const ChartPoint *nearest = chart->points;
    uint32_t count = 0;
    for (uint32_t i = 1; i < chart->count; i++)
        nearest = is_farther(nearest, &chart->points[i]) ? &chart->points[i] : nearest;
    for (uint32_t i = 0; i < chart->count && count < CHART_MAX_FAILURES; i++) {
        ChartPoint *point = &chart->points[i];
        bool farthest = point->measured.error > 1.1 * nearest->measured.error && !point->best;
        for (uint32_t k = 0; k < chart->count && farthest; k++) {
            const ChartPoint *other = &chart->points[k];
            farthest = strcmp(other->method, point->method) != 0 || k == i ||
                       is_farther(point, other) || (k > i && !is_farther(other, point));
        }
        if (farthest)
            shown[count++] = point;
    }
    return count;
}

GpResult chart_write_pictures(const ChartPictures *job, Chart *chart, GpError *error)
{
    const ChartPoint **best = gp_alloc(chart->count, sizeof(const ChartPoint *));
    ChartPoint *shown[CHART_MAX_PICTURES + CHART_MAX_FAILURES];
    char name[96], beside[128], path[CHART_MAX_PATH], difference[CHART_MAX_PATH];
    const char *const paths[2] = { path, difference };
    if (!best)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    uint32_t wanted = list_front(chart, best, shown);
    if (job->experiment->shows_failures)
        wanted += list_failures(chart, shown + wanted);
    GpResult result = GP_OK;
    for (uint32_t i = 0; i < GP_COUNT(shown) && !result; i++) {
        snprintf(name, sizeof name, "%s_%u.png", job->stem, i + 1);
        chart_difference_name(name, beside, sizeof beside);
        snprintf(path, sizeof path, "%s/%s", job->folder, name);
        snprintf(difference, sizeof difference, "%s/%s", job->folder, beside);
        if (i < wanted)
            result = write_picture(job, shown[i], name, paths, error);
        const bool drawn = i < wanted && shown[i]->picture[0];
        if (!result && !drawn) /* what an earlier chart left */
            unlink(path);
        if (!result && !(drawn && job->experiment->difference))
            unlink(difference);
    }
    gp_free(best);
    return result;
}
