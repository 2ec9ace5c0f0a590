#include "apps/points/drawing/splats.h"

#include "apps/points/drawing/filtered.h"
#include "apps/points/drawing/opaque.h"

GpResult splats_build(const SplatSource *source, const SplatView *view, const SplatSetting *setting,
                      Frame *frame, GpError *error)
{
    if (view->camera.fovy <= 0)
        return gp_fail(error, GP_ERROR_INVALID,
                       "splats are seen by a perspective camera: expected a \"fovy\" above 0");
    const SplatEye eye = splat_eye(view);
    if (splat_is_opaque(setting->method))
        splat_build_opaque(source, &eye, view, setting, frame);
    else
        splat_build_filtered(source, &eye, view, setting, frame);
    return GP_OK;
}
