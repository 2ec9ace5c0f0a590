#include "apps/techniques/warp/methods.h"

#include "apps/techniques/warp/row.h"

/* NULL: it is not images that are drawn */
static const WarpRow *const rows[WARP_METHODS] = {
    [WARP_LAYERS] = &warp_layers,
    [WARP_DIRECT] = &warp_direct,
    [WARP_SURFACE] = &warp_surface,
    [WARP_PLANAR_PRINTED] = &warp_planar,
    [WARP_CYLINDER_PRINTED] = &warp_cylinder,
    [WARP_RELIEF] = &warp_relief,
    [WARP_DMESH] = &warp_dmesh,
    [WARP_SIMPLIFIED] = &warp_simplified,
    [WARP_DISPLACEMENT] = &warp_displacement,
    [WARP_RELIEF_TEXTURE] = &warp_relief_texture,
    [WARP_PARALLAX] = &warp_parallax,
    [WARP_BUMP] = &warp_bump,
};

/* --- what is kept ----------------------------------------------------------------------------- */

/* Of settings that differ in nothing else it is made once. */
struct WarpMade {
    WarpMade *next;
    WarpMethod method;
    double share;
    uint32_t field;
    char *images; /* the row's bytes for each */
};

static void close_made(WarpImages *images, WarpMade *made)
{
    const WarpRow *row = rows[made->method];
    for (uint32_t i = 0; made->images && i < images->model.count; i++)
        row->close(made->images + i * row->bytes);
    gp_free(made->images);
    gp_free(made);
}

static GpResult make(WarpMethod method, const WarpOptions *options, WarpImages *images,
                     const WarpMade **found, GpError *error)
{
    const WarpRow *row = rows[method];
    for (*found = images->made; *found; *found = (*found)->next)
        if ((*found)->method == method && (*found)->share == options->share &&
            (*found)->field == options->field)
            return GP_OK;
    WarpMade *made = gp_alloc(1, sizeof *made);
    if (!made)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    *made = (WarpMade){ .method = method, .share = options->share, .field = options->field };
    made->images = gp_alloc(images->model.count, row->bytes);
    GpResult result = made->images ? GP_OK : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (uint32_t i = 0; i < images->model.count && !result; i++)
        result = row->open(&images->model.images[i], options, made->images + i * row->bytes, error);
    if (result) {
        close_made(images, made);
        return result;
    }
    made->next = images->made;
    *found = images->made = made;
    return GP_OK;
}

void warp_methods_close(WarpModel *model)
{
    for (WarpImages *images = model->images; images; images = images->next)
        while (images->made) {
            WarpMade *made = images->made;
            images->made = made->next;
            close_made(images, made);
        }
}

/* --- drawing ---------------------------------------------------------------------------------- */

static GpResult add_images(WarpModel *model, const WarpOptions *options, const WarpView *view,
                           const WarpTarget *target, GpDevice *device, Frame *frame, GpError *error)
{
    const WarpMethod method = warp_method_of(model, options);
    const WarpRow *row = rows[method];
    const WarpMade *made = NULL;
    WarpImages *images;
    GpResult result = warp_model_images(model, options, device, &images, error);
    if (!result && !warp_method_draws(method, images->kind))
        result = gp_fail(error, GP_ERROR_INVALID, "--method %s does not draw %s",
                         warp_method_name(method),
                         images->kind == WARP_PLANAR     ? "planar images"
                         : images->kind == WARP_CYLINDER ? "cylinders"
                                                         : "boxes");
    if (!result)
        result = make(method, options, images, &made, error);
    for (uint32_t i = 0; !result && i < images->model.count; i++) {
        const WarpUse use = { options, warp_heights_on(&model->heights, &images->model, i),
                              images->kind == WARP_BOX };
        result = row->add(made->images + i * row->bytes, &use, view, target, frame, error);
    }
    return result;
}

GpResult warp_methods_add(WarpModel *model, const WarpOptions *options, const WarpView *view,
                          const WarpTarget *target, GpDevice *device, Frame *frame, GpError *error)
{
    if (warp_method_of(model, options) != WARP_POLYGONS)
        return add_images(model, options, view, target, device, frame, error);
    return model->mesh.triangle_count > 0
               ? polygons_add(&model->polygons, view, target, frame, error)
               : gp_fail(error, GP_ERROR_INVALID,
                         "--method polygons draws a mesh, and this is a depth image");
}

WarpMethod warp_method_of(const WarpModel *model, const WarpOptions *options)
{
    const WarpKind kind = model->is_image ? model->images->kind : options->kind;
    return options->method == WARP_AUTO ? warp_auto_method(kind, options->detail) : options->method;
}

static bool has_made(const WarpImages *images, WarpMethod method)
{
    const WarpMade *made = images->made;
    while (made && made->method != method)
        made = made->next;
    return made;
}

void warp_methods_warn(const WarpModel *model, const WarpOptions *options, const WarpView *view,
                       Text *warnings)
{
    const WarpMethod method = warp_method_of(model, options);
    const WarpRow *row = rows[method];
    if (!row || !row->warning)
        return;
    for (const WarpImages *images = model->images; images; images = images->next)
        for (uint32_t i = 0; has_made(images, method) && i < images->model.count; i++) {
            const DepthImage *image = &images->model.images[i];
            const bool is_part = images->model.count > 1 && !image->is_cylinder;
            const char *warning = is_part ? NULL : row->warning(image, view);
            if (warning) /* of parts others show what one cannot */
                text_add(warnings, "%s\n", warning);
        }
}
