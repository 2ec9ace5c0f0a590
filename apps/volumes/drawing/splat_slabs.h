/* Voxels by the slabs of depth that their kernels reach into. */
#ifndef APPS_VOLUMES_DRAWING_SPLAT_SLABS_H
#define APPS_VOLUMES_DRAWING_SPLAT_SLABS_H

#include "apps/volumes/drawing/splat_sheets.h"

/* Draws all that is shown as sheets of equal depth, `thickness` each. Voxels are sorted into them
 * here, for this view: one comes into each that its kernel reaches.
 * errors GP_ERROR_MEMORY */
GpResult splat_slabs_add(Sheets *sheets, GpError *error);

#endif
