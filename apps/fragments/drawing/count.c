#include "apps/fragments/drawing/count.h"

#include "apps/fragments/drawing/passes.h"

static FragmentCount sum_up(const GpSurface *counted)
{
    FragmentCount count = { .layers = 0 };
    for (uint32_t y = 0; y < counted->height; y++) {
        const float *row =
            (const float *)(const void *)gp_surface_texel(&counted->level[0], sizeof *row, 0, y);
        for (uint32_t x = 0; x < counted->width; x++) {
            const uint32_t here = (uint32_t)row[x];
            count.fragments += here;
            count.layers = here > count.layers ? here : count.layers;
        }
    }
    return count;
}

GpResult fragment_count(const FragmentMesh *mesh, const FragmentView *view, GpSurface *depth,
                        GpDevice *device, FragmentCount *count, GpError *error)
{
    Frame frame = { .color = NULL };
    const FragmentPasses passes = fragment_passes(mesh, view, NULL, depth, &frame);
    GpSurface *counted = fragment_surface(&passes, GP_R32F);
    fragment_pass(&passes, "count", counted, 0);
    fragment_draw(&passes, &fragment_count_program, &fragment_count_program)->state.blend[0] =
        (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };
    GpResult result = frame_result(&frame, error);
    if (!result)
        result = gp_device_run(device, &frame.list, error);
    if (!result)
        *count = sum_up(counted);
    frame_free(&frame);
    return result;
}
