#include "apps/techniques/warp/methods.h"

/* What a method draws. */
typedef enum Drawn { DRAWS_MESH, DRAWS_PLANES, DRAWS_CYLINDER } Drawn;

typedef struct MethodRow {
    Drawn drawn;
    size_t bytes; /* of what is kept of an image; 0: nothing is */
    GpResult (*open)(const DepthImage *image, void *made, GpError *error);
    void (*close)(void *made); /* of a zeroed one too */
    GpResult (*add)(const void *made, const WarpOptions *options, const WarpView *view,
                    const WarpTarget *target, Frame *frame, GpError *error);
    void (*warn)(const DepthImage *image, const WarpView *view, Text *warnings); /* NULL: never */
} MethodRow;

static const MethodRow rows[WARP_METHODS] = {
    [WARP_POLYGONS] = { .drawn = DRAWS_MESH },
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
    const WarpKind kind = row->drawn == DRAWS_CYLINDER ? WARP_CYLINDER : WARP_PLANAR;
    WarpImages *images;
    GpResult result = warp_model_images(model, options, kind, device, &images, error);
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
    if (rows[warp_method_of(model, options)].drawn != DRAWS_MESH)
        return add_images(model, options, view, target, device, frame, error);
    return model->mesh.triangle_count > 0
               ? polygons_add(&model->polygons, view, target, frame, error)
               : gp_fail(error, GP_ERROR_INVALID,
                         "--method polygons draws a mesh, and this is a depth image");
}

WarpMethod warp_method_of(const WarpModel *model, const WarpOptions *options)
{
    (void)model;
    return options->method != WARP_AUTO ? options->method : WARP_POLYGONS;
}

void warp_methods_warn(const WarpModel *model, const WarpOptions *options, const WarpView *view,
                       Text *warnings)
{
    const WarpMethod method = warp_method_of(model, options);
    for (const WarpImages *images = model->images; images && rows[method].warn;
         images = images->next)
        for (uint32_t i = 0; images->made[method] && i < images->model.count; i++)
            rows[method].warn(&images->model.images[i], view, warnings);
}
