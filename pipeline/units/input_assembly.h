/* Input assembly: from streams and indices to vertex inputs and primitives. */
#ifndef GP_INPUT_ASSEMBLY_H
#define GP_INPUT_ASSEMBLY_H

#include "pipeline/resources/geometry.h"
#include "pipeline/shader/program.h"

/* Byte of a vertex at which a component begins. */
static inline size_t gp_stream_offset(const GpStream *stream, int component)
{
    static const uint8_t color[4] = { 2, 1, 0, 3 }; /* 0xAARRGGBB, the lowest byte first */
    return stream->type == GP_D3DCOLOR ? color[component]
                                       : (size_t)component * gp_component_bytes(stream->type);
}

/* Fetches one input of one vertex.
 * in   index < geometry->vertex_count
 * out  input: components that the stream lacks are (0, 0, 0, 1); any NaN becomes the canonical
 *      quiet one
 * source CONVENTIONS.md, "Geometry" */
void gp_fetch_input(const GpStream *stream, int components, uint32_t index, float *input);

/* All inputs of one vertex for a program.
 * out  inputs: program->input_components floats in the order of its declarations */
void gp_fetch_vertex(const GpGeometry *geometry, const GpProgram *program, uint32_t index,
                     float *inputs);

/* Vertex numbers of a primitive, three of a triangle or one of a point; corner 0 comes first.
 * in   primitive < gp_geometry_primitives(geometry)
 * source "Triangle Strips", "Triangle Fans" and "Flat Shading" of Direct3D 9; OpenGL ES 2 has the
 *      same triangles (2.8), and nothing flat */
void gp_assemble(const GpGeometry *geometry, uint32_t primitive, uint32_t vertices[3]);

#endif
