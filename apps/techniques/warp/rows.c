#include "apps/depth_images/drawing/cylinder.h"
#include "apps/depth_images/drawing/direct.h"
#include "apps/depth_images/drawing/planar.h"
#include "apps/techniques/warp/row.h"

WARP_ROW_KEEPS(direct);
WARP_ROW_KEEPS(planar);
WARP_ROW_KEEPS(cylinder);

/* --- this project's --------------------------------------------------------------------------- */

static DirectSetting direct_setting(const WarpUse *use)
{
    const WarpOptions *options = use->options;
    static const EdgeRule rules[] = { [WARP_CUT_AUTO] = EDGES_SLOPES,
                                      [WARP_CUT_SLOPES] = EDGES_SLOPES,
                                      [WARP_CUT_RELATIVE] = EDGES_RELATIVE,
                                      [WARP_CUT_NONE] = EDGES_NONE };
    return (DirectSetting){ .step = options->step,
                            .tolerance = options->tolerance,
                            .edges = { .rule = rules[options->cut] },
                            .detail = use->detail,
                            .one_sided = use->one_sided };
}

static GpResult add_direct(void *made, const WarpUse *use, const WarpView *view,
                           const WarpTarget *target, Frame *frame, GpError *error)
{
    const DirectSetting setting = direct_setting(use);
    return direct_add(made, &setting, view, target, frame, error);
}

static GpResult add_layers(void *made, const WarpUse *use, const WarpView *view,
                           const WarpTarget *target, Frame *frame, GpError *error)
{
    DirectSetting setting = direct_setting(use);
    setting.layers = true;
    return direct_add(made, &setting, view, target, frame, error);
}

static GpResult open_surface(const DepthImage *image, const WarpOptions *options, void *made,
                             GpError *error)
{
    (void)options;
    return surface_open(image, NULL, made, error);
}

static void close_surface(void *made)
{
    surface_close(made);
}

static GpResult add_surface(void *made, const WarpUse *use, const WarpView *view,
                            const WarpTarget *target, Frame *frame, GpError *error)
{
    const SurfaceSetting setting = { .step = use->options->step };
    return surface_add(made, &setting, view, target, frame, error);
}

/* --- as printed ------------------------------------------------------------------------------- */

static GpResult add_planar(void *made, const WarpUse *use, const WarpView *view,
                           const WarpTarget *target, Frame *frame, GpError *error)
{
    const PlanarSetting setting = { .step = use->options->step,
                                    .entries = use->options->entries,
                                    .is_cut = use->options->cut == WARP_CUT_SLOPES,
                                    .detail = use->detail };
    return planar_add(made, &setting, view, target, frame, error);
}

static GpResult add_cylinder(void *made, const WarpUse *use, const WarpView *view,
                             const WarpTarget *target, Frame *frame, GpError *error)
{
    const CylinderSetting setting = { .step = use->options->step, .detail = use->detail };
    return cylinder_add(made, &setting, view, target, frame, error);
}

/* --- rows ------------------------------------------------------------------------------------- */

const WarpRow warp_layers = { sizeof(Direct), open_direct, close_direct, add_layers,
                              direct_warning };
const WarpRow warp_direct = { sizeof(Direct), open_direct, close_direct, add_direct,
                              direct_warning };
const WarpRow warp_surface = { sizeof(DepthSurface), open_surface, close_surface, add_surface,
                               direct_warning };
const WarpRow warp_planar = { sizeof(Planar), open_planar, close_planar, add_planar,
                              planar_warning };
const WarpRow warp_cylinder = { sizeof(CylinderWarp), open_cylinder, close_cylinder, add_cylinder,
                                cylinder_warning };
