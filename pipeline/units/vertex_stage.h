/* Vertex stage: runs the vertex shader over packets of vertices. */
#ifndef GP_VERTEX_STAGE_H
#define GP_VERTEX_STAGE_H

#include "pipeline/resources/packet.h"
#include "pipeline/shader/steps.h"

typedef struct GpVertexStage {
    const GpProgram *program;
    const GpProgramCode *code;
    const void *uniforms;
    const GpTexture *textures;
    GpTextureFn read_texture;
    void *executor; /* for read_texture */
} GpVertexStage;

/* Shades up to code->lanes vertices.
 * in   inputs: count x program->input_components floats, vertex after vertex
 * out  vertices[count]; point_size is 1 where the program writes none
 * note lanes beyond count repeat the last vertex, so they cannot raise surprises of their own */
void gp_shade_vertices(const GpVertexStage *stage, const float *inputs, int count,
                       GpVertex *vertices);

/* The same of up to four vertices step by step, for who listens (gp_program_steps).
 * returns false, and leaves the vertices alone, where the program has no counting build, or memory
 *      is short */
bool gp_step_vertices(const GpVertexStage *stage, const float *inputs, int count,
                      const GpStepListener *listener, GpVertex *vertices);

#endif
