/* Vertex stage: packs vertices into lanes, runs the vertex shader, unpacks positions and varyings.
 * in: input floats, vertex after vertex; out: vertices in clip space. */
#include "pipeline/units/vertex_stage.h"

enum { MAX_LANES = 16 };

typedef struct Packet {
    _Alignas(64) float in[GP_MAX_INPUTS * MAX_LANES];
    _Alignas(64) float position[4 * MAX_LANES];
    _Alignas(64) float varying[GP_MAX_VARYINGS * MAX_LANES];
    _Alignas(64) float point_size[MAX_LANES];
} Packet;

static void pack(const GpProgram *program, int lanes, const float *inputs, int count,
                 Packet *packet)
{
    for (int c = 0; c < program->input_components; c++)
        for (int lane = 0; lane < lanes; lane++) {
            int vertex = lane < count ? lane : count - 1;
            packet->in[c * lanes + lane] = inputs[vertex * program->input_components + c];
        }
}

static void unpack(const GpProgram *program, int lanes, const Packet *packet, int count,
                   GpVertex *vertices)
{
    for (int lane = 0; lane < count; lane++) {
        GpVertex *vertex = &vertices[lane];
        for (int c = 0; c < 4; c++)
            vertex->clip[c] = packet->position[c * lanes + lane];
        for (int c = 0; c < program->varying_components; c++)
            vertex->varying[c] = packet->varying[c * lanes + lane];
        vertex->point_size = program->writes_point_size ? packet->point_size[lane] : 1.0f;
    }
}

static GpShaderCall call_of(const GpVertexStage *stage, Packet *packet)
{
    return (GpShaderCall){
        .uniforms = stage->uniforms,
        .packets = 1,
        .in = packet->in,
        .textures = stage->textures,
        .read_texture = stage->read_texture,
        .executor = stage->executor,
        .position = packet->position,
        .varying = packet->varying,
        .point_size = stage->program->writes_point_size ? packet->point_size : NULL,
    };
}

void gp_shade_vertices(const GpVertexStage *stage, const float *inputs, int count,
                       GpVertex *vertices)
{
    const int lanes = stage->code->lanes;
    GP_ASSERT(count > 0 && count <= lanes && lanes <= MAX_LANES);
    Packet packet;
    pack(stage->program, lanes, inputs, count, &packet);
    const GpShaderCall call = call_of(stage, &packet);
    stage->code->vertex(&call);
    unpack(stage->program, lanes, &packet, count, vertices);
}

bool gp_step_vertices(const GpVertexStage *stage, const float *inputs, int count,
                      const GpStepListener *listener, GpVertex *vertices)
{
    GP_ASSERT(count > 0 && count <= 4);
    Packet packet;
    pack(stage->program, 4, inputs, count, &packet);
    const GpShaderCall call = call_of(stage, &packet);
    if (!gp_program_steps(stage->program, true, &call, listener))
        return false;
    unpack(stage->program, 4, &packet, count, vertices);
    return true;
}
