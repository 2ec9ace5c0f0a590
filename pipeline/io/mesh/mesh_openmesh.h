/* The border to OpenMesh: the one function that C++ implements (internal). */
#ifndef GP_IO_MESH_OPENMESH_H
#define GP_IO_MESH_OPENMESH_H

#include "pipeline/io/mesh/mesh_check.h"

/* Reads a checked file with OpenMesh.
 * in     source: after its check
 * out    mesh: as gp_mesh_read, but normals that the file lacks are (0, 0, 0); untouched on failure
 * errors GP_ERROR_FORMAT where OpenMesh refuses the file or delivers something else than the check
 *        promised; GP_ERROR_MEMORY
 * owns   the caller frees the mesh with gp_mesh_free */
GpResult gp_mesh_import(const GpMeshSource *source, GpMesh *mesh, GpError *error);

#endif
