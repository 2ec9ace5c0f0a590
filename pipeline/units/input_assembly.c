/* Input assembly: vertex numbers become primitives, streams become the inputs of vertices.
 * in: a geometry, and what the program wants; out: floats in the order of the vertex struct. Rules:
 * CONVENTIONS.md, "Geometry". */
#include "pipeline/units/input_assembly.h"

#include <string.h>

static float stream_component(const GpStream *stream, uint32_t vertex, int component)
{
    if (component >= stream->components)
        return component == 3 ? 1.0f : 0.0f;
    size_t size = stream->type == GP_FLOAT32 ? sizeof(float) : 1;
    const uint8_t *at = (const uint8_t *)stream->data + (size_t)vertex * gp_stream_stride(stream) +
                        (size_t)component * size;
    if (stream->type == GP_UNORM8)
        return gp_float_from_unorm(*at, 8);
    float value;
    memcpy(&value, at, sizeof value); /* streams promise no alignment */
    return gp_canonical(value);
}

void gp_fetch_input(const GpStream *stream, int components, uint32_t index, float *input)
{
    for (int c = 0; c < components; c++)
        input[c] = stream_component(stream, index, c);
}

void gp_fetch_vertex(const GpGeometry *geometry, const GpProgram *program, uint32_t index,
                     float *inputs)
{
    for (size_t i = 0; i < GP_COUNT(program->inputs) && program->inputs[i].components; i++) {
        const GpInputDecl *input = &program->inputs[i];
        gp_fetch_input(&geometry->streams[input->semantic], input->components, index, inputs);
        inputs += input->components;
    }
}

void gp_assemble(const GpGeometry *geometry, uint32_t primitive, uint32_t vertices[3])
{
    uint32_t corners = geometry->primitive == GP_TRIANGLES ? 3 : 1;
    for (uint32_t i = 0; i < corners; i++) {
        uint32_t at = primitive * corners + i;
        vertices[i] = geometry->indices ? geometry->indices[at] : at;
    }
}
