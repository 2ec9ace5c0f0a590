/* Splatting before classification: all densities that matter go into sheets. */
#ifndef APPS_VOLUMES_DRAWING_SPLAT_AFTER_H
#define APPS_VOLUMES_DRAWING_SPLAT_AFTER_H

#include "apps/volumes/drawing/splat_sheets.h"

/* Draws the volume slice by slice. Voxels near to which nothing can be seen are left out; of all
 * others the frame has copies.
 * errors GP_ERROR_MEMORY */
GpResult splat_after_add(Sheets *sheets, GpError *error);

#endif
