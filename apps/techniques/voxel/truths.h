/* What is true of a model: its exact voxels at a size, as bounds; its surface and its inside, at no
 * size. Found when a volume is first held against them, and kept. */
#ifndef APPS_TECHNIQUES_VOXEL_TRUTHS_H
#define APPS_TECHNIQUES_VOXEL_TRUTHS_H

#include "apps/techniques/voxel/inputs/scene.h"
#include "apps/truth/voxel_distance.h"
#include "apps/truth/voxel_probes.h"

/* Volumes of bits between two that are exact: what must be set, and what may be. In between lie the
 * voxels that rounding decides. */
typedef enum VoxelTruthKind {
    VOXEL_TRUTH_TOUCHED, /* by a triangle; undecided within 1/1000 voxel */
    VOXEL_TRUTH_SAMPLED, /* by lines through centres along three axes; within 1/1000 voxel */
    VOXEL_TRUTH_INSIDE,  /* an odd number of triangles above the centre; within 1/128 voxel */
    VOXEL_TRUTH_WOUND,   /* a winding number other than 0 there; the same */
} VoxelTruthKind;

enum { VOXEL_MAX_TRUTHS = 32 }; /* kept; the oldest goes */

typedef struct VoxelTruth {
    VoxelTruthKind kind;
    VoxelBox space;
    uint8_t *least, *most;
} VoxelTruth;

/* The error of a volume that was measured: settings that make the same volume share it. */
typedef struct VoxelFound {
    uint64_t hash; /* of its bits, and of what they were held against */
    double error;
} VoxelFound;

enum { VOXEL_MAX_FOUND = 64 };

/* Those of one scene. */
typedef struct VoxelTruths {
    VoxelTruth truths[VOXEL_MAX_TRUTHS];
    int count;    /* found so far: the last VOXEL_MAX_TRUTHS are there */
    GpPool *pool; /* that finds errors: voxel_truths_prepare */
    bool has_distance, has_probes[2];
    VoxelDistance distance;
    VoxelProbes probes[2]; /* by parity; by winding number */
    VoxelFound found[VOXEL_MAX_FOUND];
    int found_count;
} VoxelTruths;

/* A mesh's triangles in a volume. NULL without memory; the caller frees them. */
TruthTriangle *voxel_true_triangles(const VoxelScene *scene, const VoxelBox *space);

/* The truth of a kind in a volume that lies so: kept, or found now; NULL without memory. Good until
 * the next is found. */
const VoxelTruth *voxel_truths_find(VoxelTruths *truths, const VoxelScene *scene,
                                    VoxelTruthKind kind, const VoxelBox *space);

/* Before errors are asked for. in threads: 1..1024; errors do not depend on them
 * errors GP_ERROR_MEMORY */
GpResult voxel_truths_prepare(VoxelTruths *truths, int threads, GpError *error);

/* How far a volume that lies so is from the model's surface, and the surface from it: the larger of
 * both (voxel_distance.h); and how much of the model's inside it has wrong (voxel_probes.h). In
 * thousandths, of the model's longest side and of its enclosed volume. NaN without memory.
 * in   inside: VOXEL_BY_PARITY or VOXEL_BY_WINDING: which the model's inside is */
double voxel_truths_distance(VoxelTruths *truths, const VoxelScene *scene, const VoxelBox *space,
                             const uint8_t *bits);
double voxel_truths_wrong_volume(VoxelTruths *truths, const VoxelScene *scene, VoxelInside inside,
                                 const VoxelBox *space, const uint8_t *bits);

/* What voxel_truths_distance is at least, whatever a volume holds; 0 without memory. */
double voxel_truths_least_distance(VoxelTruths *truths, const VoxelScene *scene,
                                   const VoxelBox *space);

void voxel_truths_free(VoxelTruths *truths); /* zeroes it; a zeroed one is fine */

/* Voxels of a volume of bits that must be set and are not, and those that must not be and are. */
void voxel_truth_compare(const VoxelTruth *truth, const uint8_t *bits, uint64_t *missing,
                         uint64_t *extra);

#endif
