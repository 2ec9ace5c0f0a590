#include "apps/effect/effect.h"

#include "apps/base/bounds.h"
#include "apps/scene/model.h"
#include "apps/scene/objects.h"
#include "apps/scene/textures.h"
#include "pipeline/shader/effect_uniforms.h"

#include <string.h>

/* Of the near plane, beside a model two long. */
#define NEAREST 0.01

/* --- what the program wants ------------------------------------------------------------------- */

static GpResult check_program(const GpProgram *program, const GpGeometry *geometry, GpError *error)
{
    if (program->uniform_bytes != sizeof(EffectUniforms))
        return gp_fail(error, GP_ERROR_INVALID,
                       "program %s: its uniforms have %zu bytes; expected EffectUniforms of "
                       "<glasspipe/effect.h>, %zu bytes",
                       program->name, program->uniform_bytes, sizeof(EffectUniforms));
    for (size_t i = 0; i < GP_COUNT(program->inputs) && program->inputs[i].components; i++) {
        const GpSemantic semantic = program->inputs[i].semantic;
        if ((unsigned)semantic < GP_SEMANTICS && !geometry->streams[semantic].data)
            return gp_fail(error, GP_ERROR_INVALID,
                           "program %s: inputs[%zu] is %s; a model has position, normal, texcoord0 "
                           "and color",
                           program->name, i, gp_semantic_names[semantic]);
    }
    return GP_OK;
}

/* --- what it gets ----------------------------------------------------------------------------- */

static Bounds shape_bounds(const Shape *shape)
{
    return bounds_of(shape->positions, 3 * sizeof(float), NULL, shape->vertex_count);
}

/* The centre of the box to the origin, its longest side from -1 to 1. */
static void centre_shape(Shape *shape)
{
    const Bounds box = shape_bounds(shape);
    const double longest = bounds_longest(&box), scale = longest > 0 ? 2 / longest : 1;
    for (uint32_t i = 0; i < shape->vertex_count; i++)
        for (uint32_t k = 0; k < 3; k++) {
            float *at = &shape->positions[3 * i + k];
            *at = (float)(((double)*at - 0.5 * (box.low[k] + box.high[k])) * scale);
        }
}

static EffectUniforms find_uniforms(const EffectInput *input, const Shape *shape)
{
    EffectUniforms uniforms = { .time = (float)input->time,
                                .resolution = { (float)input->width, (float)input->height } };
    const double aspect = (double)input->width / input->height;
    const Bounds seen = shape_bounds(shape);
    const Camera camera = orbit_camera(&input->orbit, &seen, aspect, NEAREST);
    const CameraAxes axes = camera_axes(&camera, aspect);
    double light[3];
    camera_matrix(&camera, aspect, uniforms.view_projection);
    for (int k = 0; k < 3; k++)
        light[k] = 0.5 * axes.right[k] + 0.7 * axes.up[k] - axes.forward[k];
    vector_normalize(light);
    for (int k = 0; k < 3; k++) {
        uniforms.eye[k] = (float)camera.eye[k];
        uniforms.light[k] = (float)light[k];
    }
    memcpy(uniforms.values, input->values, sizeof uniforms.values);
    return uniforms;
}

static GpResult bind_textures(const EffectInput *input, Frame *frame, GpDraw *draw, GpError *error)
{
    const unsigned slots = input->program->samplers | input->program->vertex_samplers;
    GpSurface *picture = NULL;
    if (!slots)
        return GP_OK;
    GpResult result = scene_open_picture(NULL, input->texture, false, true, &picture, error);
    if (result)
        return result;
    const GpTexture texture = { .surface = arena_own_surface(&frame->arena, picture),
                                .sampler = {
                                    .min = GP_LINEAR, .mag = GP_LINEAR, .mip = GP_MIP_LINEAR } };
    for (int i = 0; i < GP_MAX_SAMPLERS; i++)
        if (slots >> i & 1)
            draw->textures[i] = texture;
    return GP_OK;
}

static GpResult build_draw(const EffectInput *input, Shape *shape, Frame *frame, GpError *error)
{
    const float background[4] = { 0.1f, 0.1f, 0.12f, 1 };
    GpGeometry geometry = { .vertex_count = 0 };
    centre_shape(shape);
    const EffectUniforms uniforms = find_uniforms(input, shape);
    scene_keep_shape(frame, shape, &geometry);
    scene_complete_streams(frame, input->program, &geometry);
    GpResult result = frame_result(frame, error);
    if (!result)
        result = check_program(input->program, &geometry, error);
    if (result)
        return result;
    frame->color = frame_surface(frame, GP_A8R8G8B8, input->width, input->height, 1);
    frame->depth = frame_surface(frame, GP_D24S8, input->width, input->height, 1);
    frame_pass(frame, "effect", frame->color, frame->depth, background);
    GpDraw *draw = frame_draw_copied(frame, input->program, &uniforms, &geometry);
    draw->name = "model";
    draw->state.depth = (GpDepthState){ .test = GP_LESS_EQUAL, .write = true };
    result = bind_textures(input, frame, draw, error);
    return result ? result : frame_result(frame, error);
}

GpResult effect_build(const EffectInput *input, Frame *frame, GpError *error)
{
    Shape shape = { .positions = NULL };
    GpResult result = model_shape(NULL, input->model, false, &shape, error);
    if (!result && !shape.vertex_count)
        result = gp_fail(error, GP_ERROR_FORMAT, "%s: no vertices", input->model);
    if (!result)
        result = build_draw(input, &shape, frame, error);
    shape_free(&shape);
    return result;
}
