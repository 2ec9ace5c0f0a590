#include "apps/techniques/voxel/sheets_time.h"

#include "apps/base/machine.h"
#include "apps/techniques/voxel/methods/sort.h"

#include <string.h>

/* --- steps ------------------------------------------------------------------------------------ */

enum { RASTER, TEXELIZE, SYNTHESIZE, STEPS };

static int step_of(const GpPass *pass)
{
    if (strncmp(pass->name, "along ", strlen("along ")) == 0)
        return RASTER;
    return strcmp(pass->name, "gather") == 0 ? TEXELIZE : SYNTHESIZE;
}

/* Milliseconds of the passes of one step. in some: room for all passes */
static GpResult time_step(const TechniqueClock *clock, const GpList *list, int step, GpPass *some,
                          double *ms, GpError *error)
{
    GpList chosen = { .passes = some };
    Timing timing = { .ms = 0 };
    for (uint32_t i = 0; i < list->pass_count; i++)
        if (step_of(&list->passes[i]) == step)
            some[chosen.pass_count++] = list->passes[i];
    GpResult result = technique_time_list(clock, &chosen, &timing, error);
    *ms = timing.ms;
    return result;
}

GpResult sheets_time_steps(const TechniqueClock *clock, const Frame *frame, SheetsTimes *steps,
                           GpError *error)
{
    double ms[STEPS];
    GpPass *some = gp_alloc(frame->list.pass_count, sizeof *some);
    GpResult result = some ? GP_OK : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (int step = 0; step < STEPS && !result; step++)
        result = time_step(clock, &frame->list, step, some, &ms[step], error);
    gp_free(some);
    if (!result)
        *steps = (SheetsTimes){ ms[RASTER], ms[TEXELIZE], ms[SYNTHESIZE] };
    return result;
}

/* --- sorting ---------------------------------------------------------------------------------- */

enum { SLAB = 32 }; /* voxels of one bit in a texel */

static double time_sorting(const TechniqueClock *clock, const VoxelModel *model, VoxelSort *sort)
{
    const double start = machine_clock_ms(CLOCK_MONOTONIC);
    double begin, end = start;
    uint32_t times = 0;
    do {
        begin = end;
        voxel_sort_count(model, sort);
        voxel_sort_fill(model, sort);
        end = machine_clock_ms(CLOCK_MONOTONIC);
        clock->each[times++] = end - begin;
    } while (!timing_is_over(&clock->plan, times, end - start));
    return timing_median(clock->each, times);
}

GpResult sheets_time_sort(const TechniqueClock *clock, const VoxelScene *scene, uint32_t size,
                          double *ms, GpError *error)
{
    const VoxelBox box = voxel_scene_box(scene, size);
    const VoxelModel model = voxel_scene_model(scene, &box);
    const uint32_t depth = GP_MAX_TARGETS * SLAB;
    VoxelSort sort = { .by = VOXEL_BY_NORMAL,
                       .groups = (size + depth - 1) / depth,
                       .group_depth = depth,
                       .spans = gp_alloc(model.triangle_count, sizeof *sort.spans) };
    if (sort.spans)
        sort.indices = gp_alloc(voxel_sort_count(&model, &sort), sizeof *sort.indices);
    GpResult result = GP_OK;
    if (sort.indices)
        *ms = time_sorting(clock, &model, &sort);
    else
        result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    gp_free(sort.spans);
    gp_free(sort.indices);
    return result;
}

/* --- memory ----------------------------------------------------------------------------------- */

static bool is_drawn_before(const GpList *list, uint32_t pass, const GpSurface *surface)
{
    for (uint32_t i = 0; i < pass; i++)
        for (int k = 0; k < GP_MAX_TARGETS; k++)
            if (list->passes[i].color[k].surface == surface)
                return true;
    return false;
}

size_t sheets_bytes(const GpList *list)
{
    size_t bytes = 0;
    for (uint32_t i = 0; i < list->pass_count; i++)
        for (int k = 0; k < GP_MAX_TARGETS; k++) {
            const GpSurface *surface = list->passes[i].color[k].surface;
            if (surface && !is_drawn_before(list, i, surface))
                bytes += (size_t)surface->width * surface->height *
                         gp_format_info(surface->format)->bytes;
        }
    return bytes;
}
