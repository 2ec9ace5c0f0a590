/* The exact voxels of a mesh, in double: which a triangle touches, which lie inside.
 *
 * A volume of N a side has its voxel (x, y, z) at [x, x+1] x [y, y+1] x [z, z+1], and its bit at
 * i = x + N (y + N z): byte i/8, bit i%8 from the low end. All triangles here are in voxel space.
 */
#ifndef APPS_TRUTH_VOXEL_TRUTH_H
#define APPS_TRUTH_VOXEL_TRUTH_H

#include "apps/base/voxel_box.h"
#include "apps/truth/ray_triangle.h"
#include "pipeline/base/base.h"

/* Triangles of a mesh in voxel space. */
void voxel_triangles(const float *positions, const uint32_t *indices, uint32_t count,
                     const VoxelBox *space, TruthTriangle *triangles);

/* Sets every voxel whose closed box, grown by `margin` to each side (shrunk where it is negative),
 * a triangle touches.
 * in/out bits: [voxel_bytes(size)]
 * source Akenine-Moller, "Fast 3D triangle-box overlap testing", JGT 6(1), 2001: thirteen axes */
void voxel_surface(const TruthTriangle *triangles, uint32_t count, uint32_t size, double margin,
                   uint8_t *bits);

/* Sets the voxels that sampling finds: a triangle is looked at along axes, in lines through the
 * centres of voxels; where it is met within `margin` of a line (beyond its edges too), and within
 * `margin` of a voxel, that is set. With a negative margin those that are met for certain.
 * in     axes: bit k: along axis k; 0: along the one that the triangle's normal is nearest to (the
 *        first of equals)
 * in/out bits: [voxel_bytes(size)] */
void voxel_thin(const TruthTriangle *triangles, uint32_t count, uint32_t size, unsigned axes,
                double margin, uint8_t *bits);

/* Sets the voxels whose centre has an odd number of triangles above it, along z.
 * in/out bits: [voxel_bytes(size)], which are inverted: begin with zeros
 * note   A centre that lies exactly below an edge is below one of the two triangles: edges are told
 *        by one rule from both sides. */
void voxel_solid(const TruthTriangle *triangles, uint32_t count, uint32_t size, uint8_t *bits);

/* Sets the voxels whose centre lies within `distance` of a triangle: those of which inside and
 * outside are a matter of rounding.
 * in/out bits: [voxel_bytes(size)] */
void voxel_near(const TruthTriangle *triangles, uint32_t count, uint32_t size, double distance,
                uint8_t *bits);

enum { VOXEL_ALL_AXES = 7 };

/* Number of bits that are set. */
uint64_t voxel_count(const uint8_t *bits, uint32_t size);

#endif
