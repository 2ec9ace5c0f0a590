/* The readers of the mesh formats (internal), each in the file of its name.
 *
 * A reader walks over the bytes of a file once and trusts nothing: counts are held against the size
 * before memory is taken, every number must be one and finite, every index in range. What is wrong
 * is refused with the place and the reason.
 */
#ifndef GP_IO_MESH_FORMATS_H
#define GP_IO_MESH_FORMATS_H

#include "pipeline/io/mesh/mesh_builder.h"
#include "pipeline/io/input.h"

/* One per format.
 * in     input: at the start of a file that is not empty; what means nothing may be blanked in it
 * out    mesh: empty before, then what the file holds, also where it has no vertices or faces
 * errors GP_ERROR_FORMAT, GP_ERROR_UNSUPPORTED, GP_ERROR_MEMORY in input->result; memory that is
 *        short for the mesh itself is told by gp_mesh_builder_finish */
void gp_mesh_read_off(GpInput *input, GpMeshBuilder *mesh);
void gp_mesh_read_obj(GpInput *input, GpMeshBuilder *mesh);
void gp_mesh_read_ply(GpInput *input, GpMeshBuilder *mesh);
void gp_mesh_read_stl(GpInput *input, GpMeshBuilder *mesh);
void gp_mesh_read_om(GpInput *input, GpMeshBuilder *mesh);

#endif
