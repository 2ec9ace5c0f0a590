/* Voxels in 8 bytes, in the orders in which slices are drawn, and by their values in each.
 *
 * An order goes along one axis: slice after slice, of a slice patch after patch, of a patch value
 * after value, and of one value row after row. So the voxels that a transfer function shows are a
 * few runs of each patch, which are found without looking at any voxel: another transfer function
 * gathers other runs.
 * source paper 003, 4.1.2 (the 8 bytes), 4.1.1 (patches), 4.1.3 (lists of iso-values)
 */
#ifndef APPS_VOLUMES_VOXELS_H
#define APPS_VOLUMES_VOXELS_H

#include "apps/volumes/transfer.h"

enum {
    VOXEL_PATCH = 128, /* samples along the side of a patch */
    VOXEL_CELL = 16,   /* and of a cell, of which it is known what values lie in it */
};

/* x = place[0] + 256 (place[3] / 32), y = place[1] + 256 (place[3] / 4 mod 8),
 * z = place[2] + 256 (place[3] mod 4) */
typedef struct Voxel {
    uint8_t value;
    /* direction of the rising value in space, 128 + 127 of a unit vector; 128 all three: there is
     * none */
    uint8_t gradient[3];
    uint8_t place[4];
} Voxel;

typedef struct VoxelRange {
    uint8_t low, high; /* low > high: no voxel */
} VoxelRange;

/* One axis: its slices, and the other two axes in them. */
typedef struct VoxelOrder {
    uint32_t axis[3];    /* along, across, down */
    uint32_t slices;     /* samples along */
    uint32_t patches[2]; /* of a slice */
    uint32_t cells[2];
    Voxel *voxels;
    uint32_t *first; /* of each slice, patch and value, and behind the last: FIELD_VALUES a patch */
    VoxelRange *range; /* of each slice and cell */
} VoxelOrder;

/* A zeroed one is empty. */
typedef struct Voxels {
    /* a value that most samples have, and none of the voxels; -1: none is left out */
    int background;
    VoxelOrder along[3];
} Voxels;

/* Packs a field's samples in all three orders.
 * in   shown: values that must be there whether most samples have them or not
 * errors GP_ERROR_MEMORY
 * owns the caller, until voxels_free */
GpResult voxels_make(const Field *field, const bool shown[FIELD_VALUES], Voxels *voxels,
                     GpError *error);

void voxels_free(Voxels *voxels);

/* A sample as a voxel. */
Voxel voxel_of(const Field *field, const uint32_t place[3]);

/* Value and gradient of all samples, as in a Voxel, [z][y][x][4].
 * out  attributes: 4 bytes a sample of the field */
void voxels_attributes(const Field *field, uint8_t *attributes);

/* The values that have strength in a transfer function. returns how many */
uint32_t voxels_shown(const Transfer *transfer, bool shown[FIELD_VALUES]);

/* Voxels that follow each other in an order. */
typedef struct VoxelRun {
    uint32_t first, count;
    uint32_t patch; /* of the slice */
} VoxelRun;

/* The runs that a transfer function shows: run_of[slice] is the first of a slice, run_of[slices]
 * behind the last.
 * out  runs, run_of: of the caller, with gp_free
 * errors GP_ERROR_MEMORY */
GpResult voxels_gather(const VoxelOrder *order, const bool shown[FIELD_VALUES], VoxelRun **runs,
                       uint32_t **run_of, GpError *error);

#endif
