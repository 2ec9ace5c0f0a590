/* How far a volume's surface is from a model's: one number for volumes of all sizes, so that they
 * can be compared.
 *
 * There and back: from points spread evenly over the model to the nearest centre of a set voxel,
 * and from the centres of set voxels to the nearest point of the model. The error is the larger of
 * both, so that what is lost is not made good by what is left being near. Each is the root of the
 * mean square: the mean alone hardly tells a volume with holes from a coarser one without, for most
 * points are beside no hole.
 *
 * A voxel counts by its centre, not its cube: a cube holds the surface that touches it at distance
 * 0, however large it is. So where all touched voxels are set, points are as far from them as those
 * of a cube from its centre: half a voxel.
 *
 * source Cignoni, Rocchini and Scopigno, "Metro: measuring error on simplified surfaces", Computer
 *        Graphics Forum 17(2), 1998: distances from samples to the nearest point, both ways
 */
#ifndef APPS_TRUTH_VOXEL_DISTANCE_H
#define APPS_TRUTH_VOXEL_DISTANCE_H

#include "apps/truth/ray_tree.h"
#include "apps/truth/voxel_truth.h"
#include "pipeline/base/pool.h"

/* A model to be measured against, in its own space. */
typedef struct VoxelDistance {
    TruthTriangle *triangles; /* in the order of the tree's leaves */
    TruthNode *nodes;
    double (*points)[3];
    double longest; /* side of its box */
} VoxelDistance;

/* in     count: at least 1
 * errors GP_ERROR_MEMORY; owns: the caller, until voxel_distance_free */
GpResult voxel_distance_make(const TruthTriangle *triangles, uint32_t count,
                             VoxelDistance *distance);
void voxel_distance_free(VoxelDistance *distance); /* zeroes it; a zeroed one is fine */

/* Roots of mean squares, in parts of the model's longest side. */
typedef struct VoxelApart {
    double to_voxels; /* of points inside the volume; at most 1, which it is of no voxels */
    double to_model;  /* of set voxels; 0 where there are none */
} VoxelApart;

/* in     space: from the model's space to that of the volume
 * order  squares are added up point after point, voxel after voxel: bits do not depend on the
 *        threads
 * errors GP_ERROR_MEMORY */
GpResult voxel_distance_find(const VoxelDistance *distance, const VoxelBox *space,
                             const uint8_t *bits, GpPool *pool, VoxelApart *apart);

/* What to_voxels is at least, whatever is set: each point is in a voxel, and no centre is nearer to
 * it than that one's. Each step rounds as in voxel_distance_find and keeps what is not more not
 * more, so that no error that is found lies below.
 * out    least: as VoxelApart's to_voxels
 * errors GP_ERROR_MEMORY */
GpResult voxel_distance_least(const VoxelDistance *distance, const VoxelBox *space, GpPool *pool,
                              double *least);

#endif
