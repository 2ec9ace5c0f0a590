/* Input assembly: from streams and indices to vertex inputs and primitives. */
#ifndef GP_INPUT_ASSEMBLY_H
#define GP_INPUT_ASSEMBLY_H

#include "pipeline/resources/geometry.h"
#include "pipeline/shader/program.h"

/* Bytes from vertex to vertex. */
static inline size_t gp_stream_stride(const GpStream *stream)
{
    const size_t size = stream->type == GP_FLOAT32 ? sizeof(float) : 1;
    return stream->stride ? stream->stride : size * stream->components;
}

/* Fetches one input of one vertex.
 * in   index < geometry->vertex_count
 * out  input: components that the stream lacks are (0, 0, 0, 1); signalling NaNs become the
 *      canonical quiet one
 * source CONVENTIONS.md, "Geometry" */
void gp_fetch_input(const GpStream *stream, int components, uint32_t index, float *input);

/* All inputs of one vertex for a program.
 * out  inputs: program->input_components floats in the order of its declarations */
void gp_fetch_vertex(const GpGeometry *geometry, const GpProgram *program, uint32_t index,
                     float *inputs);

/* Vertex numbers of a primitive, three of a triangle or one of a point, in the order given.
 * in   primitive < gp_geometry_primitives(geometry) */
void gp_assemble(const GpGeometry *geometry, uint32_t primitive, uint32_t vertices[3]);

#endif
