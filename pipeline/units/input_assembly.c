/* Input assembly: vertex numbers become primitives, streams become the inputs of vertices.
 * in: a geometry, and what the program wants; out: floats in the order of the vertex struct. Rules:
 * CONVENTIONS.md, "Geometry". */
#include "pipeline/units/input_assembly.h"

#include <string.h>

/* Streams promise no alignment. */
static uint16_t load16(const uint8_t *at)
{
    uint16_t word;
    memcpy(&word, at, sizeof word);
    return word;
}

static float load_float(const uint8_t *at)
{
    float value;
    memcpy(&value, at, sizeof value);
    return gp_canonical(value);
}

static float decode(GpComponentType type, const uint8_t *at)
{
    switch (type) {
    case GP_UNORM8:
    case GP_D3DCOLOR:
        return gp_float_from_unorm(*at, 8);
    case GP_UINT8:
        return *at;
    case GP_INT8:
        return (int8_t)*at;
    case GP_SNORM8:
        return gp_float_from_snorm((int8_t)*at, 8);
    case GP_UINT16:
        return load16(at);
    case GP_INT16:
        return (int16_t)load16(at);
    case GP_UNORM16:
        return gp_float_from_unorm(load16(at), 16);
    case GP_SNORM16:
        return gp_float_from_snorm((int16_t)load16(at), 16);
    case GP_FLOAT16:
        return gp_float_from_half(load16(at));
    default:
        return load_float(at);
    }
}

static float stream_component(const GpStream *stream, uint32_t vertex, int component)
{
    if (component >= stream->components)
        return component == 3 ? 1.0f : 0.0f;
    const uint8_t *record =
        (const uint8_t *)stream->data + (size_t)vertex * gp_stream_stride(stream);
    return decode(stream->type, record + gp_stream_offset(stream, component));
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
    const uint32_t odd = primitive & 1;
    uint32_t at[3] = { 3 * primitive, 3 * primitive + 1, 3 * primitive + 2 };
    if (geometry->primitive == GP_POINTS) {
        at[0] = primitive;
    } else if (geometry->primitive == GP_TRIANGLE_STRIP) {
        at[0] = primitive;
        at[1] = primitive + 1 + odd;
        at[2] = primitive + 2 - odd;
    } else if (geometry->primitive == GP_TRIANGLE_FAN) {
        at[0] = primitive + 1;
        at[1] = primitive + 2;
        at[2] = 0;
    }
    for (uint32_t i = 0; i < gp_primitive_corners(geometry->primitive); i++)
        vertices[i] = gp_geometry_vertex(geometry, at[i]);
}
