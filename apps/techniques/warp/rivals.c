#include "apps/depth_images/drawing/direct.h"
#include "apps/depth_images/rivals/displacement.h"
#include "apps/depth_images/rivals/dmesh.h"
#include "apps/depth_images/rivals/parallax.h"
#include "apps/depth_images/rivals/relief.h"
#include "apps/depth_images/rivals/relief_texture.h"
#include "apps/techniques/warp/row.h"

WARP_ROW_KEEPS(relief);
WARP_ROW_KEEPS(dmesh);
WARP_ROW_KEEPS(relief_texture);
WARP_ROW_KEEPS(parallax);

/* --- meshes ----------------------------------------------------------------------------------- */

static GpResult open_simplified(const DepthImage *image, const WarpOptions *options, void *made,
                                GpError *error)
{
    const DmeshDetail detail = { .share = options->share > 0 ? options->share : 0.1 };
    return dmesh_open_detailed(image, &detail, made, error);
}

static GpResult add_dmesh(void *made, const WarpUse *use, const WarpView *view,
                          const WarpTarget *target, Frame *frame, GpError *error)
{
    (void)use;
    static const DmeshSetting setting = { .name = NULL };
    return dmesh_add(made, &setting, view, target, frame, error);
}

/* --- rays ------------------------------------------------------------------------------------- */

static GpResult add_relief(void *made, const WarpUse *use, const WarpView *view,
                           const WarpTarget *target, Frame *frame, GpError *error)
{
    const ReliefSetting setting = { .steps = use->options->search,
                                    .halvings = use->options->halvings };
    return relief_add(made, &setting, view, target, frame, error);
}

static GpResult open_displacement(const DepthImage *image, const WarpOptions *options, void *made,
                                  GpError *error)
{
    const DisplacementField field = { .size = options->field };
    return displacement_open_sized(image, &field, made, error);
}

static void close_displacement(void *made)
{
    displacement_close(made);
}

static GpResult add_displacement(void *made, const WarpUse *use, const WarpView *view,
                                 const WarpTarget *target, Frame *frame, GpError *error)
{
    const DisplacementSetting setting = { .steps = use->options->search };
    return displacement_add(made, &setting, view, target, frame, error);
}

/* --- pictures on rectangles ------------------------------------------------------------------- */

static GpResult add_relief_texture(void *made, const WarpUse *use, const WarpView *view,
                                   const WarpTarget *target, Frame *frame, GpError *error)
{
    const ReliefTextureSetting setting = { .cut = use->options->cut == WARP_CUT_NONE ? -1 : 0 };
    return relief_texture_add(made, &setting, view, target, frame, error);
}

static GpResult add_parallax(void *made, const WarpUse *use, const WarpView *view,
                             const WarpTarget *target, Frame *frame, GpError *error)
{
    const ParallaxSetting setting = { .kind = use->options->unlimited ? PARALLAX_OFFSET
                                                                      : PARALLAX_LIMITED };
    return parallax_add(made, &setting, view, target, frame, error);
}

static GpResult add_bump(void *made, const WarpUse *use, const WarpView *view,
                         const WarpTarget *target, Frame *frame, GpError *error)
{
    (void)use;
    static const ParallaxSetting setting = { .kind = PARALLAX_BUMP, .name = "bump" };
    return parallax_add(made, &setting, view, target, frame, error);
}

/* --- rows ------------------------------------------------------------------------------------- */

const WarpRow warp_relief = { sizeof(Relief), open_relief, close_relief, add_relief,
                              direct_warning };
const WarpRow warp_dmesh = { sizeof(Dmesh), open_dmesh, close_dmesh, add_dmesh, direct_warning };
const WarpRow warp_simplified = { sizeof(Dmesh), open_simplified, close_dmesh, add_dmesh,
                                  direct_warning };
const WarpRow warp_displacement = { sizeof(Displacement), open_displacement, close_displacement,
                                    add_displacement, direct_warning };
const WarpRow warp_relief_texture = { sizeof(ReliefTexture), open_relief_texture,
                                      close_relief_texture, add_relief_texture, direct_warning };
const WarpRow warp_parallax = { sizeof(Parallax), open_parallax, close_parallax, add_parallax,
                                direct_warning };
const WarpRow warp_bump = { sizeof(Parallax), open_parallax, close_parallax, add_bump,
                            direct_warning };
