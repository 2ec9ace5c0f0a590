/* Checks of mesh files before OpenMesh reads them (internal).
 *
 * OpenMesh 9 trusts a file: it loops as often as the header says without looking for the end,
 * allocates by the header's counts, stores what it could not parse as zero, and takes any index.
 * A check walks over every byte that will be read, knows afterwards how many vertices and faces
 * must arrive, and refuses the rest with the place and the reason. Valid files that OpenMesh would
 * misread are brought into a form that it reads right: by blanking (OFF comments and face colours,
 * OBJ materials) or, every PLY file, by writing the same mesh again in the plainest form.
 */
#ifndef GP_IO_MESH_CHECK_H
#define GP_IO_MESH_CHECK_H

#include "pipeline/io/file.h"
#include "pipeline/io/mesh/mesh.h"

typedef enum GpMeshFormat {
    GP_MESH_OFF,
    GP_MESH_OBJ,
    GP_MESH_PLY,
    GP_MESH_STL,
    GP_MESH_OM,
} GpMeshFormat;

/* A mesh file in memory. */
typedef struct GpMeshSource {
    const char *path;    /* for messages */
    const char *reading; /* what OpenMesh calls the format: "off", "obj", "ply", "stl", "om" */
    GpMeshFormat format;
    GpFile file; /* checks may edit or replace the bytes */

    /* What the check found and the reader must deliver. */
    size_t vertex_count; /* STL: corners, so at most */
    size_t face_count;   /* polygons; STL, OBJ: at most (see GpMesh.skipped_count) */
    bool is_binary;      /* STL only */
    bool has_normals, has_colors, has_texcoords;
} GpMeshSource;

/* One per format.
 * in/out source: format, path and file are set; the facts are filled in
 * errors GP_ERROR_FORMAT, GP_ERROR_UNSUPPORTED, GP_ERROR_MEMORY with one line in *error */
GpResult gp_mesh_check_off(GpMeshSource *source, GpError *error);
GpResult gp_mesh_check_obj(GpMeshSource *source, GpError *error);
GpResult gp_mesh_check_ply(GpMeshSource *source, GpError *error);
GpResult gp_mesh_check_stl(GpMeshSource *source, GpError *error);
GpResult gp_mesh_check_om(GpMeshSource *source, GpError *error);

/* Largest count of vertices, faces or corners: OpenMesh numbers them with a positive int. */
#define GP_MESH_COUNT_MAX ((int64_t)0x7fffffff)

#endif
