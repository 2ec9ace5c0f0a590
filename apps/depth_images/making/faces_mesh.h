/* What six faces of a box see of a mesh, as a mesh of their pixels. */
#ifndef APPS_DEPTH_IMAGES_MAKING_FACES_MESH_H
#define APPS_DEPTH_IMAGES_MAKING_FACES_MESH_H

#include "apps/depth_images/capture.h"

/* A vertex for each pixel that shows something, and triangles between neighbours that are one
 * surface: whose depths differ by less than twice their distance, since what is steeper faces
 * another side.
 * in     side: as capture_box has it
 * out    mesh: with normals and colours, indices at least one triangle's
 * errors those of capture_box; GP_ERROR_INVALID: nothing is seen; owns: the caller, until
 *        gp_mesh_free */
GpResult faces_mesh(GpDevice *device, const CaptureSource *source, uint32_t side, GpMesh *mesh,
                    GpError *error);

#endif
