/* Vertex stage: packs vertices into lanes, runs the vertex shader, unpacks positions and varyings.
 * in: input floats, vertex after vertex; out: vertices in clip space. */
#include "pipeline/units/vertex_stage.h"

enum { MAX_LANES = 16 };

void gp_shade_vertices(const GpVertexStage *stage, const float *inputs, int count,
                       GpVertex *vertices)
{
    const GpProgram *program = stage->program;
    int lanes = stage->code->lanes;
    GP_ASSERT(count > 0 && count <= lanes && lanes <= MAX_LANES);

    _Alignas(64) float in[GP_MAX_INPUTS * MAX_LANES];
    _Alignas(64) float position[4 * MAX_LANES];
    _Alignas(64) float varying[GP_MAX_VARYINGS * MAX_LANES];
    _Alignas(64) float point_size[MAX_LANES];

    for (int c = 0; c < program->input_components; c++)
        for (int lane = 0; lane < lanes; lane++) {
            int vertex = lane < count ? lane : count - 1;
            in[c * lanes + lane] = inputs[vertex * program->input_components + c];
        }

    GpShaderCall call = {
        .uniforms = stage->uniforms,
        .packets = 1,
        .in = in,
        .textures = stage->textures,
        .read_texture = stage->read_texture,
        .executor = stage->executor,
        .position = position,
        .varying = varying,
        .point_size = program->writes_point_size ? point_size : NULL,
    };
    stage->code->vertex(&call);

    for (int lane = 0; lane < count; lane++) {
        GpVertex *vertex = &vertices[lane];
        for (int c = 0; c < 4; c++)
            vertex->clip[c] = position[c * lanes + lane];
        for (int c = 0; c < program->varying_components; c++)
            vertex->varying[c] = varying[c * lanes + lane];
        vertex->point_size = program->writes_point_size ? point_size[lane] : 1.0f;
    }
}
