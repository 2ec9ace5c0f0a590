#include "apps/techniques/warp/report.h"

#include "apps/techniques/warp/methods.h"

#include <string.h>

/* --- sizes ------------------------------------------------------------------------------------ */

/* Of passes that look at the model, which is all but those of a rectangle. */
static double count_triangles(const Frame *frame)
{
    double count = 0;
    for (uint32_t p = 0; p < frame->list.pass_count; p++)
        for (uint32_t d = 0; d < frame->list.passes[p].draw_count; d++) {
            const GpGeometry *geometry = &frame->list.passes[p].draws[d].geometry;
            count += (geometry->indices ? geometry->index_count : geometry->vertex_count) / 3;
        }
    return count;
}

/* Of the front layers of all images that were drawn, the last ones captured. */
static double count_pixels(const WarpModel *model)
{
    double count = 0;
    for (uint32_t i = 0; model->images && i < model->images->model.count; i++) {
        const DepthPixels *front = &model->images->model.images[i].front;
        for (size_t at = 0; at < (size_t)front->width * front->height; at++)
            count += isfinite(front->depth[at]);
    }
    return count;
}

void warp_tell_size(const WarpModel *model, const Frame *frame, json_t *members)
{
    json_object_set_new(members, "triangles", json_integer((json_int_t)count_triangles(frame)));
    json_object_set_new(members, "source_pixels", json_integer((json_int_t)count_pixels(model)));
}

/* --- errors ----------------------------------------------------------------------------------- */

void warp_tell_error(const WarpError *off, json_t *members)
{
    json_object_set_new(members, "interior_psnr",
                        off->both > 0 ? json_real(off->interior_psnr) : json_null());
    json_object_set_new(members, "missing", json_integer((json_int_t)off->missing));
    json_object_set_new(members, "extra", json_integer((json_int_t)off->extra));
    json_object_set_new(members, "depth_error", json_real(off->depth_error));
    json_object_set_new(members, "depth_mean", json_real(off->depth_mean));
}

static GpResult measure(WarpModel *model, const Frame *frame, int threads, TechniqueReport *report,
                        GpError *error)
{
    WarpError off;
    const GpResult result = warp_model_error(model, frame, threads, &off, error);
    if (result)
        return result;
    if (off.both > 0)
        text_add(&report->lines, "interior %.2f dB, ", off.interior_psnr);
    text_add(&report->lines,
             "%.0f missing and %.0f extra of %.0f pixels, depth off by %.3g "
             "(median; mean %.3g)\n",
             off.missing, off.extra, off.covered, off.depth_error, off.depth_mean);
    if (report->members)
        warp_tell_error(&off, report->members);
    return GP_OK;
}

/* --- views ------------------------------------------------------------------------------------ */

static json_t *json_of_vector(const double vector[3])
{
    return json_pack("[f, f, f]", vector[0], vector[1], vector[2]);
}

static json_t *json_of_camera(const Camera *camera)
{
    json_t *object = json_pack("{s:o, s:o, s:o}", "eye", json_of_vector(camera->eye), "at",
                               json_of_vector(camera->at), "up", json_of_vector(camera->up));
    if (camera->fovy > 0)
        json_object_set_new(object, "fovy", json_real(camera->fovy));
    else
        json_object_set_new(object, "height", json_real(camera->height));
    json_object_set_new(object, "near", json_real(camera->near));
    json_object_set_new(object, "far", json_real(camera->far));
    return object;
}

/* Warnings as an array, beside the lines that they are. */
static json_t *json_of_lines(const char *line)
{
    json_t *array = json_array();
    while (line && *line) {
        const size_t length = strcspn(line, "\n");
        json_array_append_new(array, json_stringn(line, length));
        line += length + (line[length] == '\n');
    }
    return array;
}

static void warn_if_empty(const GpSurface *color, Text *warnings)
{
    size_t texels = (size_t)color->width * color->height;
    while (texels > 0 && color->level[0].texels[4 * (texels - 1) + 3] == 0)
        texels--;
    if (texels == 0)
        text_add(warnings, "the picture is empty: of what was captured nothing that is in the view "
                           "turns to the eye\n");
}

GpResult warp_report(void *made, const void *setting, const Frame *frame, GpDevice *device,
                     TechniqueReport *report, GpError *error)
{
    WarpModel *model = made;
    const WarpOptions *options = setting;
    WarpLight light;
    const WarpView view = warp_model_view(model, options, &light);
    warp_methods_warn(model, options, &view, &report->warnings);
    warn_if_empty(frame->color, &report->warnings);
    if (!model->is_fixed)
        text_add(&report->lines, "seen %g degrees to the right of the source\n", options->turn);
    if (report->members) {
        warp_tell_size(model, frame, report->members);
        json_object_set_new(report->members, "view", json_of_camera(&view.camera));
        json_object_set_new(report->members, "warnings", json_of_lines(report->warnings.data));
    }
    return options->measures ? measure(model, frame, gp_device_threads(device), report, error)
                             : GP_OK;
}
