#include "apps/volumes/drawing/raycast.h"

#include "apps/base/reach.h"
#include "apps/base/stable_math.h"
#include "shaders_c/volume/raycast.h"

#include <math.h>
#include <string.h>

_Static_assert((int)VOLUME_BRICK == (int)BRICK_SIDE, "bricks are those of the shader");

/* --- flat textures ------------------------------------------------------------------------------ */

/* Patches of all ways, one way below the other. */
static GpResult make_runs(RaycastVolume *volume, GpError *error)
{
    const uint32_t *count = volume->bricks.count;
    volume->shown = gp_alloc(bricks_total(&volume->bricks) + 1, 1);
    if (!volume->shown)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    if (bricks_total(&volume->bricks) == 0)
        return GP_OK;
    const uint32_t columns = atlas_columns(count[0], count[1] * BRICK_WAYS, count[2]);
    GP_ASSERT(columns > 0);
    volume->columns = columns;
    return gp_surface_create(
        &(GpSurfaceDesc){ .format = GP_R8,
                          .width = columns * count[0],
                          .height = (count[2] + columns - 1) / columns * count[1] * BRICK_WAYS,
                          .name = "bricks" },
        &volume->runs, error);
}

/* What is not there yet of the ways that bits stand for. */
static GpResult find_runs(RaycastVolume *volume, unsigned ways, GpError *error)
{
    const Bricks *bricks = &volume->bricks;
    const uint32_t *count = bricks->count, rows = volume->runs->height / count[1] / BRICK_WAYS;
    uint8_t *runs = gp_alloc(bricks_total(bricks), 1);
    GpResult result = runs ? GP_OK : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (unsigned way = 0; way < BRICK_WAYS && !result; way++) {
        if (volume->known >> way & 1 || !(ways >> way & 1))
            continue;
        result = bricks_runs(bricks, volume->shown, way, runs, error);
        const uint8_t *from = runs;
        const uint32_t first = way * rows * volume->columns;
        for (uint32_t z = 0; z < count[2] && !result; z++)
            for (uint32_t y = 0; y < count[1]; y++, from += count[0])
                memcpy(atlas_texel(volume->runs, volume->columns, count, 0, y, first + z), from,
                       count[0]);
        volume->known |= result ? 0 : 1u << way;
    }
    gp_free(runs);
    return result;
}

GpResult raycast_open(const Field *field, RaycastVolume *volume, GpError *error)
{
    RaycastVolume made = { .field = field };
    GpResult result = volume_atlas_make(field->value, field->size, &made.atlas, error);
    if (!result)
        result = bricks_make(field, &made.bricks, error);
    if (!result)
        result = make_runs(&made, error);
    if (result) {
        raycast_close(&made);
        return result;
    }
    *volume = made;
    return GP_OK;
}

void raycast_close(RaycastVolume *volume)
{
    volume_atlas_free(&volume->atlas);
    gp_surface_destroy(&volume->runs);
    gp_free(volume->shown);
    bricks_free(&volume->bricks);
    *volume = (RaycastVolume){ .field = NULL };
}

void raycast_classify(RaycastVolume *volume, const Transfer *transfer)
{
    volume->transfer = *transfer;
    volume->known = 0;
    bricks_show(&volume->bricks, transfer, volume->shown);
}

/* --- classification ------------------------------------------------------------------------------ */

enum { PER_VALUE = 4, ENTRIES = (FIELD_VALUES - 1) * PER_VALUE + 1 };

/* Colour times alpha, and alpha, of a step: [value * PER_VALUE]. */
static GpSurface *make_table(const Transfer *transfer, double step, Frame *frame)
{
    GpSurface *table = frame_surface(frame, GP_A32B32G32R32F, ENTRIES, 1, 1);
    uint8_t *texel = table->level[0].texels;
    for (uint32_t i = 0; i < ENTRIES && texel; i++, texel += 16) {
        double rgba[4];
        transfer_at(transfer, (double)i / PER_VALUE, rgba);
        const double alpha = 1 - stable_pow(1 - rgba[3], step);
        const float stored[4] = { (float)(rgba[0] * alpha), (float)(rgba[1] * alpha),
                                  (float)(rgba[2] * alpha), (float)alpha };
        gp_texel_store(GP_A32B32G32R32F, texel, stored, 0);
    }
    return table;
}

/* --- rays ---------------------------------------------------------------------------------------- */

static void find_box(const Field *field, double corners[8][3])
{
    for (int corner = 0; corner < 8; corner++)
        for (int i = 0; i < 3; i++)
            corners[corner][i] = corner >> i & 1 ? (field->size[i] - 1) * field->scale[i] : 0;
}

typedef struct RayCorner {
    float corner[2], start[3], way[3];
} RayCorner;

/* One triangle over the whole picture: rays of its corners, in samples. */
static void find_corners(const Field *field, const VolumeView *view, const CameraAxes *axes,
                         const double reach[2], RayCorner corners[3])
{
    static const double places[3][2] = { { -1, -1 }, { -1, 3 }, { 3, -1 } };
    const Camera *camera = &view->camera;
    for (int k = 0; k < 3; k++) {
        const double x = places[k][0] * axes->half_width, y = places[k][1] * axes->half_height;
        for (int i = 0; i < 3; i++) {
            const double aside = axes->right[i] * x + axes->up[i] * y;
            double end[2];
            for (int e = 0; e < 2; e++)
                end[e] = (camera->eye[i] + axes->forward[i] * reach[e] +
                          aside * (camera->fovy > 0 ? reach[e] : 1)) /
                         field->scale[i];
            corners[k].start[i] = (float)end[0];
            corners[k].way[i] = (float)(end[1] - end[0]);
        }
        corners[k].corner[0] = (float)places[k][0];
        corners[k].corner[1] = (float)places[k][1];
    }
}

/* Ways of rays, as bits: directions are linear on the picture, so that its corners tell. */
static unsigned ways_of(const Camera *camera, const CameraAxes *axes)
{
    unsigned ways = 1;
    for (int i = 0; i < 3; i++) {
        const double aside = camera->fovy > 0 ? fabs(axes->right[i]) * axes->half_width +
                                                    fabs(axes->up[i]) * axes->half_height
                                              : 0;
        const double some = 1e-6; /* what the shader may round otherwise */
        const unsigned rising = axes->forward[i] + aside > -some ? ways : 0;
        const unsigned falling = axes->forward[i] - aside < some ? ways << (1 << i) : 0;
        ways = rising | falling;
    }
    return ways;
}

/* Of a depth z the distance is near far / (far - (far - near) z), or near + (far - near) z. */
static void find_depth(const Camera *camera, const double reach[2], float depth[4])
{
    const double near = camera->near, far = camera->far, way = reach[1] - reach[0];
    if (camera->fovy > 0) {
        depth[0] = (float)((near * far - reach[0] * far) / way);
        depth[1] = (float)(reach[0] * (far - near) / way);
        depth[2] = (float)far;
        depth[3] = (float)(near - far);
    } else {
        depth[0] = (float)((near - reach[0]) / way);
        depth[1] = (float)((far - near) / way);
        depth[2] = 1;
        depth[3] = 0;
    }
}

/* Beside the eye, as that of splats. */
static void find_light(const CameraAxes *axes, RaycastUniforms *uniforms)
{
    const double right = -0.3, up = 0.4, back = 1, length = sqrt(1.25);
    for (int i = 0; i < 3; i++)
        uniforms->light[i] =
            (float)((axes->right[i] * right + axes->up[i] * up - axes->forward[i] * back) / length);
    uniforms->ambient = 0.25f;
    uniforms->diffuse = 0.75f;
}

static RaycastUniforms uniforms_of(const RaycastVolume *volume, const VolumeView *view,
                                   const CameraAxes *axes, const RaycastSetting *setting,
                                   double step, const double reach[2])
{
    const Field *field = volume->field;
    RaycastUniforms uniforms = {
        .atlas = volume_atlas_patches(&volume->atlas, field->size),
        .bricks = atlas_patches(volume->runs, volume->columns, volume->bricks.count[0],
                                volume->bricks.count[1]),
        .table = { (float)(ENTRIES - 1) / ENTRIES, 0.5f / ENTRIES },
        .per_step = (float)(1 / step),
        .least = (float)(setting->least > 0 ? setting->least : 1.0 / 256),
        .way = 1.0f / BRICK_WAYS,
        .texel = { 1 / (float)view->width, 1 / (float)view->height },
    };
    for (int i = 0; i < 3; i++) {
        uniforms.last[i] = (float)(field->size[i] - 1);
        uniforms.scale[i] = (float)field->scale[i];
    }
    find_depth(&view->camera, reach, uniforms.depth);
    find_light(axes, &uniforms);
    return uniforms;
}

GpResult raycast_add(RaycastVolume *volume, const VolumeView *view, const RaycastSetting *setting,
                     const VolumeTarget *target, Frame *frame, GpError *error)
{
    static const GpSampler linear = { .min = GP_LINEAR,
                                      .mag = GP_LINEAR,
                                      .address_u = GP_CLAMP,
                                      .address_v = GP_CLAMP },
                           points = { .address_u = GP_CLAMP, .address_v = GP_CLAMP };
    static const float none[4] = { 0 };
    const CameraAxes axes = camera_axes(&view->camera, (double)view->width / view->height);
    const double step = setting->step > 0 ? setting->step : 1;
    RayCorner *corners = frame_alloc(frame, 3, sizeof *corners);
    double box[8][3], reach[2];

    frame_pass(frame, setting->name ? setting->name : "raycast", target->color, NULL, none)
        ->color[0]
        .clear = false;
    find_box(volume->field, box);
    const GpRect rect = reach_rect(box, &view->camera, &axes, view->width, view->height);
    if (!corners || !volume->runs || gp_rect_is_empty(rect) ||
        !reach_find(box, &view->camera, &axes, reach))
        return frame_result(frame, error);
    find_corners(volume->field, view, &axes, reach, corners);
    const GpResult result = find_runs(volume, ways_of(&view->camera, &axes), error);
    if (result)
        return result;
    const RaycastUniforms uniforms = uniforms_of(volume, view, &axes, setting, step, reach);
    const uint32_t stride = sizeof *corners;
    const GpGeometry geometry = {
        .vertex_count = 3,
        .streams = { [GP_POSITION] = { corners->corner, stride, 2, GP_FLOAT32 },
                     [GP_TEXCOORD0] = { corners->start, stride, 3, GP_FLOAT32 },
                     [GP_TEXCOORD1] = { corners->way, stride, 3, GP_FLOAT32 } },
    };
    GpSurface *depth = target->depth;
    if (!depth) {
        depth = frame_surface(frame, GP_D32F, 1, 1, 1);
        if (depth->level[0].texels)
            gp_surface_clear_depth(depth, 1, 0, true, false);
    }
    GpDraw *draw = frame_draw_copied(frame, view->lit ? &raycast_lit_program : &raycast_program,
                                     &uniforms, &geometry);
    draw->textures[0] = (GpTexture){ volume->atlas.surface, linear };
    draw->textures[1] = (GpTexture){ volume->runs, points };
    draw->textures[2] = (GpTexture){ make_table(&volume->transfer, step, frame), points };
    draw->textures[3] = (GpTexture){ depth, points };
    draw->state.raster = (GpRasterState){ .scissor = true,
                                          .scissor_x0 = rect.x0,
                                          .scissor_y0 = rect.y0,
                                          .scissor_x1 = rect.x1,
                                          .scissor_y1 = rect.y1 };
    draw->state.blend[0] = (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_INV_SRC_ALPHA };
    return frame_result(frame, error);
}
