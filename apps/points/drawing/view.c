#include "apps/points/drawing/view.h"

#include <math.h>

/* --- the camera ------------------------------------------------------------------------------- */

SplatEye splat_eye(const SplatView *view)
{
    const Camera *camera = &view->camera;
    const CameraAxes axes = camera_axes(camera, (double)view->width / view->height);
    const double range = camera->far - camera->near;
    SplatEye eye = { .focal = view->height / (2 * axes.half_height),
                     .depth = { camera->far / range, -camera->far * camera->near / range } };
    for (int k = 0; k < 3; k++) {
        eye.axis[0][k] = axes.right[k];
        eye.axis[1][k] = -axes.up[k];
        eye.axis[2][k] = axes.forward[k];
    }
    return eye;
}

SplatUniforms splat_uniforms(const SplatEye *eye, const SplatView *view,
                             const SplatSetting *setting, SplatMethod filter)
{
    const double low_pass = filter == SPLAT_RECONSTRUCTION ? 0 : setting->low_pass;
    SplatUniforms uniforms = {
        .focal = (float)eye->focal,
        .centre = { (float)view->width / 2, (float)view->height / 2 },
        .ndc = { 2 / (float)view->width, 2 / (float)view->height },
        .depth = { (float)eye->depth[0], (float)eye->depth[1] },
        .nearest = (float)view->camera.near,
        .facing = setting->two_sided ? -INFINITY : 0,
        .low_pass = (float)(low_pass * low_pass),
        .spread = filter == SPLAT_LOW_PASS ? 0 : (float)setting->spread,
        .cut = (float)setting->cut,
        .epsilon = (float)setting->epsilon,
        .waves = (float)view->waves,
    };
    for (int i = 0; i < 3; i++) {
        uniforms.eye[i][3] = (float)-vector_dot(eye->axis[i], view->camera.eye);
        for (int k = 0; k < 3; k++)
            uniforms.eye[i][k] = (float)eye->axis[i][k];
    }
    return uniforms;
}

SplatLight splat_light(const SplatView *view)
{
    const SplatEye eye = splat_eye(view);
    SplatLight light = { .ambient = 0.15, .specular = 0.25, .shininess = 32 };
    for (int k = 0; k < 3; k++)
        light.towards[k] = -0.4 * eye.axis[0][k] - 0.5 * eye.axis[1][k] - eye.axis[2][k];
    vector_normalize(light.towards);
    return light;
}

/* --- geometry --------------------------------------------------------------------------------- */

GpGeometry splat_run_geometry(const SplatSource *source, const SplatRun *run)
{
    const Surfel *first = source->surfels + run->first;
    GpGeometry geometry = {
        .primitive = GP_POINTS,
        .vertex_count = run->count,
        .streams = {
            [GP_POSITION] = { first->position, sizeof *first, 4, GP_FLOAT32 },
            [GP_NORMAL] = { first->normal, sizeof *first, 3, GP_FLOAT32 },
            [GP_COLOR] = { first->color, sizeof *first, 4, GP_UNORM8 },
        },
    };
    for (int i = 0; i < 2 && source->clips; i++)
        geometry.streams[GP_TEXCOORD0 + i] =
            (GpStream){ source->clips[run->first].inward[i], sizeof *source->clips, 4, GP_FLOAT32 };
    return geometry;
}

FilterUniforms splat_filter_uniforms(const SplatEye *eye, const SplatView *view,
                                     const SplatSetting *setting, Frame *frame)
{
    FilterUniforms uniforms;
    for (int i = 0; i < SPLAT_METHODS; i++) {
        SplatUniforms filtered = splat_uniforms(eye, view, setting, (SplatMethod)i);
        uniforms.of[false][i] = frame_copy(frame, &filtered, sizeof filtered);
        filtered.spread *= (float)SPLAT_MERGED_SPREAD;
        uniforms.of[true][i] = frame_copy(frame, &filtered, sizeof filtered);
    }
    return uniforms;
}

void splat_draw_runs(const SplatSource *source, const FilterUniforms *uniforms,
                     const GpProgram *program, const GpState *state, Frame *frame)
{
    for (uint32_t i = 0; i < source->run_count; i++) {
        const SplatRun *run = &source->runs[i];
        const GpGeometry geometry = splat_run_geometry(source, run);
        if (run->count > 0)
            frame_draw(frame, program, splat_run_uniforms(uniforms, run), &geometry)->state =
                *state;
    }
}
