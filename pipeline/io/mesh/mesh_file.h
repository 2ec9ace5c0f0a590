/* Triangle meshes from files: OFF, OBJ, PLY, STL and OM. Every face arrives, whether manifold or
 * not. */
#ifndef GP_IO_MESH_FILE_H
#define GP_IO_MESH_FILE_H

#include "pipeline/io/mesh/mesh.h"

typedef enum GpMeshFlags {
    GP_MESH_TRIANGLES = 0,        /* a file without any face is an error */
    GP_MESH_ALLOW_POINTS = 1 << 0 /* a file with vertices only is a point set */
} GpMeshFlags;

/* Reads a mesh. The format is that of the extension (any case), confirmed by what the file starts
 * with where its format has such a mark.
 * in     path: as for fopen; flags
 * out    mesh: untouched on failure. Normals are the file's, as stored; a vertex whose normal is
 *        absent or (0, 0, 0) gets that of gp_mesh_normals
 * errors GP_ERROR_IO (file access); GP_ERROR_FORMAT with "path: line 12: ..." or "path: byte 34:
 *        ..." (truncated, impossible counts, an index out of range, a number that is none or is
 *        not finite, no vertices, no faces); GP_ERROR_UNSUPPORTED (valid, but not read here: an
 *        unknown extension, four-dimensional OFF, binary OFF ...); GP_ERROR_MEMORY
 * owns   the caller frees the mesh with gp_mesh_free */
GpResult gp_mesh_read(const char *path, unsigned flags, GpMesh *mesh, GpError *error);

/* Whether gp_mesh_read knows the extension. */
bool gp_mesh_is_readable(const char *path);

#endif
