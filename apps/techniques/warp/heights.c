#include "apps/techniques/warp/heights.h"

#include "apps/frame/picture.h"

static const double usual_share = 0.02; /* of the longest side */
enum { USUAL_REPEAT = 4 };

static GpResult make_surface(const Picture *picture, GpSurface **surface, GpError *error)
{
    const GpSurfaceDesc desc = { .format = GP_R32F,
                                 .width = picture->width,
                                 .height = picture->height,
                                 .levels = GP_MAX_LEVELS,
                                 .name = "heights" };
    const GpResult result = gp_surface_create(&desc, surface, error);
    if (result)
        return result;
    const size_t channel = picture->channels == 4 ? 3 : 0;
    float *texels = (float *)(void *)(*surface)->level[0].texels;
    for (size_t i = 0; i < (size_t)picture->width * picture->height; i++) {
        const float height = picture->values[i * (size_t)picture->channels + channel];
        texels[i] = height > 0 ? height < 1 ? height : 1 : 0; /* NaN: 0 */
    }
    gp_surface_build_mips(*surface);
    return GP_OK;
}

GpResult warp_heights_open(const WarpOptions *options, const Bounds *bounds, WarpHeights *heights,
                           GpError *error)
{
    WarpHeights made = { .repeat = options->detail_repeat ? options->detail_repeat : USUAL_REPEAT };
    char path[4096];
    Picture picture = { .values = NULL };
    if (!options->detail)
        return GP_OK;
    made.amplitude =
        options->detail_depth != 0 ? options->detail_depth : usual_share * bounds_longest(bounds);
    GpResult result = gp_data_find(options->detail, path, sizeof path, error);
    if (!result)
        result = picture_read(path, &picture, error);
    if (!result)
        result = make_surface(&picture, &made.surface, error);
    picture_free(&picture);
    if (!result)
        *heights = made;
    return result;
}

void warp_heights_close(WarpHeights *heights)
{
    gp_surface_destroy(&heights->surface);
}

/* How far an image reaches across and down. */
static void extent_of(const DepthImage *image, double extent[2])
{
    static const double two_pi = 0x1.921fb54442d18p+2;
    extent[0] = image->is_cylinder ? two_pi * image->cylinder.radius : image->plane.width;
    extent[1] = image->is_cylinder ? image->cylinder.height : image->plane.height;
}

WarpDetail warp_heights_on(const WarpHeights *heights, const DepthModel *model, uint32_t image)
{
    const bool is_cap = model->images[0].is_cylinder && image > 0;
    double extent[2], widest = 0;
    if (!heights->surface || is_cap)
        return (WarpDetail){ .heights = NULL };
    for (uint32_t i = 0; i < (model->images[0].is_cylinder ? 1 : model->count); i++) {
        extent_of(&model->images[i], extent);
        widest = fmax(widest, extent[0]);
    }
    extent_of(&model->images[image], extent);
    const double square = (double)heights->surface->height / heights->surface->width;
    return (WarpDetail){ .heights = heights->surface,
                         .amplitude = heights->amplitude,
                         .repeats = { heights->repeat * extent[0] / widest,
                                      heights->repeat * extent[1] / widest / square },
                         .is_smooth = true };
}

GpResult warp_heights_lean(const WarpHeights *heights, DepthModel *model, GpError *error)
{
    GpResult result = GP_OK;
    for (uint32_t i = 0; i < model->count && !result; i++) {
        DepthImage *image = &model->images[i];
        const WarpDetail detail = warp_heights_on(heights, model, i);
        if (detail.heights && image->front.normal)
            result = warp_detail_lean(image, &image->front, &detail, error);
        if (!result && detail.heights && image->behind.normal)
            result = warp_detail_lean(image, &image->behind, &detail, error);
    }
    return result;
}
