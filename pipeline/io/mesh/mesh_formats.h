/* The readers of the mesh formats (internal), each in the file of its name.
 *
 * A reader walks over the bytes of a file once and trusts nothing: counts are held against the size
 * before memory is taken, every number must be one and finite, every index in range. What is wrong
 * is refused with the place and the reason.
 */
#ifndef GP_IO_MESH_FORMATS_H
#define GP_IO_MESH_FORMATS_H

#include "pipeline/io/file.h"
#include "pipeline/io/mesh/mesh_builder.h"

/* One per format.
 * in     path: for messages; file: its bytes, of which a reader may blank what means nothing
 * out    mesh: empty before, then what the file holds, also where it has no vertices or faces;
 *        after an error whatever was read until then
 * errors GP_ERROR_FORMAT, GP_ERROR_UNSUPPORTED, GP_ERROR_MEMORY with one line in *error; memory that
 *        is short for the mesh itself is told by gp_mesh_builder_finish */
GpResult gp_mesh_read_off(const char *path, GpFile *file, GpMeshBuilder *mesh, GpError *error);
GpResult gp_mesh_read_obj(const char *path, GpFile *file, GpMeshBuilder *mesh, GpError *error);
GpResult gp_mesh_read_ply(const char *path, GpFile *file, GpMeshBuilder *mesh, GpError *error);
GpResult gp_mesh_read_stl(const char *path, GpFile *file, GpMeshBuilder *mesh, GpError *error);
GpResult gp_mesh_read_om(const char *path, GpFile *file, GpMeshBuilder *mesh, GpError *error);

/* Largest count of vertices, faces or corners that a file may promise. */
#define GP_MESH_COUNT_MAX ((int64_t)0x7fffffff)

#endif
