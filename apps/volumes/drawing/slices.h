/* Volumes as planes between their slices: passes of the programs shaders_c/volume/slices.h.
 *
 * Planes stand across the axis that is nearest to the view, and are put one under the other, front
 * to back,
 * in a picture of their own, which then lies over the target. Each is drawn where something can be
 * seen in the slab that it stands for; now and then pixels that let nothing through any more are
 * marked, and drawn no more. The whole is one group of passes.
 */
#ifndef APPS_VOLUMES_DRAWING_SLICES_H
#define APPS_VOLUMES_DRAWING_SLICES_H

#include "apps/volumes/bricks.h"
#include "apps/volumes/drawing/view.h"

/* All zero: as they are meant. */
typedef struct SlicesSetting {
    double spacing; /* of planes, in samples along their axis; 0: 1 */
    uint32_t cull;  /* planes after which opaque pixels are marked; 0: 16 */
} SlicesSetting;

/* A field, and a transfer function, as planes read them. A zeroed one is empty. Owned by whoever
 * made it, until slices_close; what frames refer to stays while they are run. */
typedef struct SlicesVolume {
    const Field *field; /* borrowed */
    Transfer transfer;
    Bricks bricks;
    uint8_t *shown;       /* of the bricks */
    GpSurface **slice[3]; /* across each axis; NULL: not asked for yet */
    uint8_t *turned;      /* samples by y, z, x: slices across x, whose rows must lie in memory */
} SlicesVolume;

/* errors GP_ERROR_MEMORY */
GpResult slices_open(const Field *field, SlicesVolume *volume, GpError *error);
void slices_close(SlicesVolume *volume);

/* Takes a transfer function, the first or another. Frames that were made before are to be made
 * anew. */
void slices_classify(SlicesVolume *volume, const Transfer *transfer);

/* Appends passes "slices", "opaque" and "slices-over" that draw the volume over what the target
 * holds.
 * in   volume: classified; slices across the axis of the view are added to it
 * errors GP_ERROR_MEMORY */
GpResult slices_add(SlicesVolume *volume, const VolumeView *view, const SlicesSetting *setting,
                    const VolumeTarget *target, Frame *frame, GpError *error);

#endif
