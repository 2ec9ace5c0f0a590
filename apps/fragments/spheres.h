/* A scene of known depth: a wall of spheres, one behind the other. */
#ifndef APPS_FRAGMENTS_SPHERES_H
#define APPS_FRAGMENTS_SPHERES_H

#include "apps/base/camera.h"
#include "pipeline/io/mesh/mesh.h"

enum { SPHERES_MOST = 96, SPHERE_COLUMNS = 200, SPHERE_TRIANGLES = 39600 };

/* Two by two columns of spheres of radius 0.48, a unit apart, that go away along -z: so many layers
 * deep, each sphere two of them. Triangles turn counter-clockwise seen from outside.
 * in     layers: even, 2 to SPHERES_MOST; columns: triangles round each sphere, even, 4 to
 *        SPHERE_COLUMNS, which makes SPHERE_TRIANGLES of it; half as many rows
 * errors GP_ERROR_MEMORY; owns: the caller, until gp_mesh_free
 * source paper 002, figure 6 */
GpResult spheres_make(uint32_t layers, uint32_t columns, GpMesh *mesh);

/* Looks along the columns, by parallel rays: each sphere hides the one behind it wholly. */
Camera spheres_camera(uint32_t layers);

#endif
