/* Pixel stage: packs a quad into lanes, runs the pixel shader, unpacks what it gave.
 * in: varyings, place and facing of a quad; out: colours, depth and kills. Helper pixels are shaded
 * too: derivatives need them. Code wider than a quad gets it repeated. */
#include "pipeline/units/pixel_stage.h"

enum { MAX_LANES = 16 };

typedef struct Packet {
    _Alignas(64) float in[GP_MAX_VARYINGS * MAX_LANES];
    _Alignas(64) float pixel[2 * MAX_LANES];
    _Alignas(64) float face[MAX_LANES];
    _Alignas(64) float color[GP_MAX_TARGETS * 4 * MAX_LANES];
    _Alignas(64) float depth[MAX_LANES];
    _Alignas(64) int32_t killed[MAX_LANES];
} Packet;

static void pack(const GpPixelStage *stage, int lanes, const GpQuad *quad, Packet *packet)
{
    for (int lane = 0; lane < lanes; lane++) {
        int pixel = lane % 4;
        for (int c = 0; c < stage->program->varying_components; c++)
            packet->in[c * lanes + lane] = quad->varying[c][pixel];
        packet->pixel[lane] = (float)(quad->x + pixel % 2);
        packet->pixel[lanes + lane] = (float)(quad->y + pixel / 2);
        packet->face[lane] = quad->front ? 1.0f : -1.0f;
    }
}

static void unpack(const GpPixelStage *stage, int lanes, const Packet *packet, GpQuad *quad)
{
    quad->killed = 0;
    for (int pixel = 0; pixel < 4; pixel++) {
        for (int t = 0; t < gp_program_targets(stage->program); t++)
            for (int c = 0; c < 4; c++)
                quad->color[t][c][pixel] = packet->color[(t * 4 + c) * lanes + pixel];
        if (stage->program->writes_depth)
            quad->depth[pixel] = packet->depth[pixel];
        if (stage->program->may_discard && packet->killed[pixel])
            quad->killed |= 1u << pixel;
    }
}

static GpShaderCall call_of(const GpPixelStage *stage, Packet *packet)
{
    return (GpShaderCall){
        .uniforms = stage->uniforms,
        .packets = 1,
        .in = packet->in,
        .textures = stage->textures,
        .read_texture = stage->read_texture,
        .read_local = stage->read_local,
        .executor = stage->executor,
        .pixel = packet->pixel,
        .face = packet->face,
        .color = packet->color,
        .depth = stage->program->writes_depth ? packet->depth : NULL,
        .killed = stage->program->may_discard ? packet->killed : NULL,
    };
}

void gp_shade_quad(const GpPixelStage *stage, GpQuad *quad)
{
    Packet packet;
    pack(stage, stage->code->lanes, quad, &packet);
    const GpShaderCall call = call_of(stage, &packet);
    stage->code->pixel(&call);
    unpack(stage, stage->code->lanes, &packet, quad);
}

bool gp_step_quad(const GpPixelStage *stage, const GpStepListener *listener, GpQuad *quad)
{
    Packet packet;
    pack(stage, 4, quad, &packet);
    const GpShaderCall call = call_of(stage, &packet);
    if (!gp_program_steps(stage->program, false, &call, listener))
        return false;
    unpack(stage, 4, &packet, quad);
    return true;
}
