#include "apps/volumes/drawing/raycast.h"

#include "apps/base/reach.h"
#include "apps/base/stable_math.h"
#include "shaders_c/volume/through.h"

#include <math.h>
#include <string.h>

/* --- classification --------------------------------------------------------------------------- */

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

/* --- rays ------------------------------------------------------------------------------------- */

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

/* --- what is drawn ---------------------------------------------------------------------------- */

static const GpSampler points = { .address_u = GP_CLAMP, .address_v = GP_CLAMP };

/* What a picture shows of a volume. */
typedef struct Rays {
    double reach[2];
    GpRect rect; /* empty: nothing */
    RayCorner corners[3];
    RaycastUniforms uniforms;
} Rays;

static void set_textures(const RaycastVolume *volume, double step, GpTexture textures[3],
                         Frame *frame)
{
    static const GpSampler linear = {
        .min = GP_LINEAR, .mag = GP_LINEAR, .address_u = GP_CLAMP, .address_v = GP_CLAMP
    };
    textures[0] = (GpTexture){ volume->atlas.surface, linear };
    textures[1] = (GpTexture){ volume->runs, points };
    textures[2] = (GpTexture){ make_table(&volume->transfer, step, frame), points };
}

static double step_of(const RaycastSetting *setting)
{
    return setting->step > 0 ? setting->step : 1;
}

static GpResult find_rays(RaycastVolume *volume, const VolumeView *view,
                          const RaycastSetting *setting, Rays *rays, GpError *error)
{
    const CameraAxes axes = camera_axes(&view->camera, (double)view->width / view->height);
    double box[8][3];
    find_box(volume->field, box);
    *rays = (Rays){ .rect = reach_rect(box, &view->camera, &axes, view->width, view->height) };
    if (!volume->runs || !reach_find(box, &view->camera, &axes, rays->reach))
        rays->rect = (GpRect){ 0 };
    if (gp_rect_is_empty(rays->rect))
        return GP_OK;
    find_corners(volume->field, view, &axes, rays->reach, rays->corners);
    rays->uniforms = uniforms_of(volume, view, &axes, setting, step_of(setting), rays->reach);
    return raycast_find_runs(volume, ways_of(&view->camera, &axes), error);
}

GpResult raycast_add(RaycastVolume *volume, const VolumeView *view, const RaycastSetting *setting,
                     const VolumeTarget *target, Frame *frame, GpError *error)
{
    static const float none[4] = { 0 };
    Rays rays;
    const GpResult result = find_rays(volume, view, setting, &rays, error);

    frame_pass(frame, setting->name ? setting->name : "raycast", target->color, NULL, none)
        ->color[0]
        .clear = false;
    const RayCorner *corners = frame_copy(frame, rays.corners, sizeof rays.corners);
    if (result || !corners || gp_rect_is_empty(rays.rect))
        return result ? result : frame_result(frame, error);
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
                                     &rays.uniforms, &geometry);
    set_textures(volume, step_of(setting), draw->textures, frame);
    draw->textures[3] = (GpTexture){ depth, points };
    draw->state.raster = (GpRasterState){ .scissor = true,
                                          .scissor_x0 = rays.rect.x0,
                                          .scissor_y0 = rays.rect.y0,
                                          .scissor_x1 = rays.rect.x1,
                                          .scissor_y1 = rays.rect.y1 };
    draw->state.blend[0] = (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_INV_SRC_ALPHA };
    return frame_result(frame, error);
}

/* --- what is seen through it ------------------------------------------------------------------ */

bool raycast_is_before(const RaycastVolume *volume, const VolumeView *view, double body[8][3])
{
    const CameraAxes axes = camera_axes(&view->camera, (double)view->width / view->height);
    enum { FINE = 1 << 16 }; /* whatever the picture's size, the answer is one */
    double box[8][3], reach[2], of_body[2];
    find_box(volume->field, box);
    const GpRect common = gp_rect_common(reach_rect(box, &view->camera, &axes, FINE, FINE),
                                         reach_rect(body, &view->camera, &axes, FINE, FINE));
    return volume->runs && !gp_rect_is_empty(common) &&
           reach_find(box, &view->camera, &axes, reach) &&
           reach_find(body, &view->camera, &axes, of_body) && reach[0] < of_body[1];
}

/* Rays of corners (-1, -1), (-1, 3) and (3, -1) of clip space, as what pixels' centres add. */
static void find_pixels(const RayCorner corners[3], const VolumeView *view,
                        ThroughUniforms *uniforms)
{
    for (int i = 0; i < 3; i++)
        for (int way = 0; way < 2; way++) {
            float(*made)[3] = way ? uniforms->way : uniforms->start;
            double at[3];
            for (int k = 0; k < 3; k++)
                at[k] = (double)(way ? corners[k].way[i] : corners[k].start[i]);
            const double across = (at[2] - at[0]) / 2 / view->width;
            const double up = (at[1] - at[0]) / 2 / view->height;
            made[0][i] = (float)(at[0] + across / 2 + up * (view->height - 0.5));
            made[1][i] = (float)across;
            made[2][i] = (float)-up;
        }
}

GpResult raycast_see_through(RaycastVolume *volume, const VolumeView *view,
                             const RaycastSetting *setting, double to_field[3][4], GpDraw *draw,
                             Frame *frame, GpError *error)
{
    const CameraAxes axes = camera_axes(&view->camera, (double)view->width / view->height);
    ThroughUniforms made = { .phong = *(const PhongUniforms *)draw->uniforms };
    Rays rays;
    const GpResult result = find_rays(volume, view, setting, &rays, error);
    if (result || gp_rect_is_empty(rays.rect))
        return result;
    made.rays = rays.uniforms;
    find_pixels(rays.corners, view, &made);
    for (int k = 0; k < 4; k++) {
        double distance = k == 3 ? -vector_dot(view->camera.eye, axes.forward) - rays.reach[0] : 0;
        for (int i = 0; i < 3; i++)
            distance += axes.forward[i] * to_field[i][k];
        made.share[k] = (float)(distance / (rays.reach[1] - rays.reach[0]));
    }
    draw->program = view->lit ? &phong_through_lit_program : &phong_through_program;
    draw->uniforms = frame_copy(frame, &made, sizeof made);
    set_textures(volume, step_of(setting), draw->textures, frame);
    return frame_result(frame, error);
}
