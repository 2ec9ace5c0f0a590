#include "apps/techniques/warp/methods.h"

#include "apps/depth_images/drawing/cylinder.h"

typedef struct MethodRow {
    size_t bytes; /* of what is kept of an image; 0: it is not images that are drawn */
    GpResult (*open)(const DepthImage *image, void *made, GpError *error);
    void (*close)(void *made); /* of a zeroed one too */
    GpResult (*add)(const void *made, const WarpOptions *options, const WarpView *view,
                    const WarpTarget *target, Frame *frame, GpError *error);
    /* What of a view the method cannot do, a sentence; NULL: nothing. NULL: never */
    const char *(*warning)(const DepthImage *image, const WarpView *view);
} MethodRow;

/* --- surfaces ----------------------------------------------------------------------------------- */

static GpResult open_surface(const DepthImage *image, void *made, GpError *error)
{
    return surface_open(image, NULL, made, error);
}

static void close_surface(void *made)
{
    surface_close(made);
}

static GpResult add_surface(const void *made, const WarpOptions *options, const WarpView *view,
                            const WarpTarget *target, Frame *frame, GpError *error)
{
    const SurfaceSetting setting = { .step = options->step };
    return surface_add(made, &setting, view, target, frame, error);
}

/* --- cylinders ---------------------------------------------------------------------------------- */

static GpResult open_cylinder(const DepthImage *image, void *made, GpError *error)
{
    return cylinder_open(image, made, error);
}

static void close_cylinder(void *made)
{
    cylinder_close(made);
}

static GpResult add_cylinder(const void *made, const WarpOptions *options, const WarpView *view,
                             const WarpTarget *target, Frame *frame, GpError *error)
{
    const CylinderSetting setting = { .step = options->step };
    return cylinder_add(made, &setting, view, target, frame, error);
}

/* --- rays --------------------------------------------------------------------------------------- */

static GpResult open_relief(const DepthImage *image, void *made, GpError *error)
{
    return relief_open(image, made, error);
}

static void close_relief(void *made)
{
    relief_close(made);
}

static GpResult add_relief(const void *made, const WarpOptions *options, const WarpView *view,
                           const WarpTarget *target, Frame *frame, GpError *error)
{
    return relief_add(made, &options->relief, view, target, frame, error);
}

/* --- all ---------------------------------------------------------------------------------------- */

static const MethodRow rows[WARP_METHODS] = {
    [WARP_SURFACE] = { sizeof(DepthSurface), open_surface, close_surface, add_surface, NULL },
    [WARP_CYLINDER_PRINTED] = { sizeof(CylinderWarp), open_cylinder, close_cylinder, add_cylinder,
                                cylinder_warning },
    [WARP_RELIEF] = { sizeof(Relief), open_relief, close_relief, add_relief, NULL },
    [WARP_POLYGONS] = { .bytes = 0 },
};

/* --- what is kept ------------------------------------------------------------------------------- */

static void close_made(const MethodRow *row, WarpImages *images, void **made)
{
    for (uint32_t i = 0; *made && i < images->model.count; i++)
        row->close((char *)*made + i * row->bytes);
    gp_free(*made);
    *made = NULL;
}

static GpResult make(const MethodRow *row, WarpImages *images, void **made, GpError *error)
{
    GpResult result = GP_OK;
    if (*made || row->bytes == 0)
        return GP_OK;
    *made = gp_alloc(images->model.count, row->bytes);
    if (!*made)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (uint32_t i = 0; i < images->model.count && !result; i++)
        result = row->open(&images->model.images[i], (char *)*made + i * row->bytes, error);
    if (result)
        close_made(row, images, made);
    return result;
}

void warp_methods_close(WarpModel *model)
{
    for (WarpImages *images = model->images; images; images = images->next)
        for (int i = 0; i < WARP_METHODS; i++)
            close_made(&rows[i], images, &images->made[i]);
}

/* --- drawing ------------------------------------------------------------------------------------ */

static GpResult add_images(WarpModel *model, const WarpOptions *options, const WarpView *view,
                           const WarpTarget *target, GpDevice *device, Frame *frame, GpError *error)
{
    const WarpMethod method = warp_method_of(model, options);
    const MethodRow *row = &rows[method];
    WarpImages *images;
    GpResult result = warp_model_images(model, options, device, &images, error);
    if (!result && !warp_method_draws(method, images->kind))
        result = gp_fail(error, GP_ERROR_INVALID, "--method %s does not draw %s",
                         warp_method_name(method),
                         images->kind == WARP_PLANAR     ? "planar images"
                         : images->kind == WARP_CYLINDER ? "cylinders"
                                                         : "boxes");
    if (!result)
        result = make(row, images, &images->made[method], error);
    for (uint32_t i = 0; !result && i < images->model.count; i++)
        result = row->add((char *)images->made[method] + i * row->bytes, options, view, target,
                          frame, error);
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
    (void)model;
    return options->method != WARP_AUTO ? options->method : WARP_SURFACE;
}

void warp_methods_warn(const WarpModel *model, const WarpOptions *options, const WarpView *view,
                       Text *warnings)
{
    const WarpMethod method = warp_method_of(model, options);
    const MethodRow *row = &rows[method];
    const char *last = NULL;
    for (const WarpImages *images = model->images; images; images = images->next)
        for (uint32_t i = 0; row->warning && images->made[method] && i < images->model.count; i++) {
            const char *warning = row->warning(&images->model.images[i], view);
            if (warning && warning != last) /* of the images of one model mostly the same */
                text_add(warnings, "%s\n", warning);
            last = warning ? warning : last;
        }
}
